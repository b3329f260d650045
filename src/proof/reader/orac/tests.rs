use super::*;

#[test]
fn both_layouts_give_the_same_blocks() {
    let pages = read(
        "\u{2}PAGE 01 INCREMENTAL-FORMAT.G91\r\n\u{2}PAGE 02 PROGRAM-DATUM\r\nX   15.100\r\nZ - 20.000\r\n\u{2}PAGE 03 CIRCULAR.G02\r\nz-1.000\r\nX1.000\r\nRADIUS 2\r\nFEEDRATE   80\r\nTOOL-NO 1\r\nSPINDLE-SPEED 1094\r\n\u{2}PAGE 04 END-PROGRAM..M02\r\n\u{4}",
    );
    let list = read("  1  INC\n  2  PDAT   15.100  -20.000\n  3  CIRC 1.000-1.000 2 cw 80 1 1094\n4 END");
    assert_eq!(pages.troubles, []);
    assert_eq!(list.troubles, []);
    let bare = |l: &Listing| l.blocks.iter().map(|b| (b.printed, b.op, b.words.clone())).collect::<Vec<_>>();
    assert_eq!(bare(&pages), bare(&list));
    assert_eq!((pages.layout, list.layout), (Layout::Pages, Layout::Instructions));
}

#[test]
fn pages_without_marks_and_with_lone_returns_are_read() {
    let lf = read("PAGE 1 DWELL.G04\nTIME 2.5\n\nPAGE 2 END-PROGRAM..M02");
    let cr = read("PAGE 1 DWELL.G04\rTIME 2.5\r\rPAGE 2 END-PROGRAM..M02");
    assert_eq!((lf.troubles.len(), &lf), (0, &cr));
    assert_eq!(lf.blocks[0].value(Word::Seconds), Some(2.5));
}

#[test]
fn every_instruction_is_read_from_both_layouts() {
    let list = "1 INC\n2 ABS\n3 MM\n4 IN\n5 PDAT 1 2\n6 PTP 1 2 3 4 5\n7 CIRC 1 2 3 CCW 4 5 6\n8 THRD -9 12 10 1.75 .04 3 400\n\
                9 DWEL 1\n10 IXUA 1\n11 OXUA 1 0\n12 CALL 1\n13 SUB 1\n14 ESUB\n15 DO 5\n16 EDO\n17 END";
    let pages = "PAGE 1 INCREMENTAL-FORMAT.G91\nPAGE 2 ABSOLUTE-FORMAT.G90\nPAGE 3 MM-UNITS\nPAGE 4 INCH-UNITS\nPAGE 5 PROGRAM-DATUM\nX 1\n\
        Z 2\nPAGE 6 POINT-TO-POINT.G00,G01\nX 1\nZ 2\nFEEDRATE 3\nTOOL-NO 4\nSPINDLE-SPEED 5\nPAGE 7 CIRCULAR.G03\nX 1\nZ 2\nRADIUS 3\n\
        FEEDRATE 4\nTOOL-NO 5\nSPINDLE-SPEED 6\nPAGE 8 THREADING.G33\nZ -9\nOUTSIDE-DIA 12\nBASE-DIA 10\nPITCH 1.75\nCUT-DEPTH .04\nTOOL-NO 3\n\
        SPINDLE-SPEED 400\nPAGE 9 DWELL.G04\nTIME 1\nPAGE 10 AUXILIARY-INPUT\nCHANNEL 1\nPAGE 11 AUXILIARY-OUTPUT\nCHANNEL 1\nSTATE 0\n\
        PAGE 12 CALL-SUBROUTINE\nNUMBER 1\nPAGE 13 SUBROUTINE-START\nNUMBER 1\nPAGE 14 END-SUBROUTINE\nPAGE 15 START-DO-LOOP\nCOUNT 5\n\
        PAGE 16 END-DO-LOOP\nPAGE 17 END-PROGRAM..M02";
    let (list, pages) = (read(list), read(pages));
    assert_eq!((list.troubles.len(), pages.troubles.len(), list.blocks.len()), (0, 0, 17));
    for (a, b) in list.blocks.iter().zip(&pages.blocks) {
        assert_eq!((a.op, &a.words), (b.op, &b.words));
    }
}

#[test]
fn whatever_cannot_be_read_is_named_and_the_rest_is_read() {
    let cases = [
        ("1 PTP 1 2 80 1 1O94", "1O94"),
        ("1 PTP 1 2 80 1.5 100", "whole"),
        ("1 PTP 1 2 80 1", "SPINDLE-SPEED"),
        ("1 PTP 1 2 80 1 100 7", "too many"),
        ("1 JMP 4", "JMP"),
        ("1 PTP 1e3 2 80 1 100", "1e3"),
        ("1 PTP NaN 2 80 1 100", "NaN"),
        ("1 PTP 9999999 2 80 1 100", "99999.999"),
        ("1 CIRC 1 2 3 XX 80 1 100", "CW"),
        ("PAGE 1 DWELL.G04\nTIME 1\nTIME 1", "twice"),
        ("PAGE 1 DWELL.G04\nTIME 1\nBANANA", "BANANA"),
        ("PAGE 1 DWELL.G04", "TIME"),
        ("PAGE DWELL.G04\nTIME 1", "no number"),
        ("hello\nPAGE 1 MM-UNITS", "before the first page"),
        ("PAGE 1 MN-UNITS", "MN-UNITS"),
    ];
    for (text, word) in cases {
        let listing = read(&format!("{text}\n{}", if text.contains("PAGE") { "PAGE 2 MM-UNITS" } else { "2 MM" }));
        assert_eq!(listing.troubles.len(), 1, "{text}: {:?}", listing.troubles);
        assert!(listing.troubles[0].message.contains(word), "{text}: {}", listing.troubles[0].message);
        assert_eq!(listing.blocks.last().and_then(|b| b.op), Some(Op::Millimetre), "{text}");
    }
}
