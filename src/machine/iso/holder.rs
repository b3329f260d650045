//! Holder codes: ISO 5608 for outside, ISO 6261 for boring bars, and the makers' common codes for threading holders.

use crate::machine::Hand;

/// A holder by its code. Lengths in mm, angles in degrees.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::machine) struct IsoHolder {
    /// Letter of the insert that it takes.
    pub(in crate::machine) insert_letter: char,
    /// Size code of the insert that it takes.
    pub(in crate::machine) insert_size: String,
    /// Angle between cutting edge and direction of feed; `None` where the insert points straight at the work.
    pub(in crate::machine) approach_deg: Option<f64>,
    /// Hand; `None` for a neutral one.
    pub(in crate::machine) hand: Option<Hand>,
    /// Shank or bar.
    pub(in crate::machine) seat: Seat,
}

/// What the insert sits on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::machine) enum Seat {
    /// A square or flat shank for outside work.
    Shank { width: f64, length: f64 },
    /// A round bar for bores.
    Bar { diameter: f64 },
}

/// Shank or bar length by its letter, mm (ISO 5608, ISO 6261).
const LENGTHS: [(char, f64); 20] = [
    ('A', 32.0),
    ('B', 40.0),
    ('C', 50.0),
    ('D', 60.0),
    ('E', 70.0),
    ('F', 80.0),
    ('G', 90.0),
    ('H', 100.0),
    ('J', 110.0),
    ('K', 125.0),
    ('L', 140.0),
    ('M', 150.0),
    ('N', 160.0),
    ('P', 170.0),
    ('Q', 180.0),
    ('R', 200.0),
    ('S', 250.0),
    ('T', 300.0),
    ('U', 350.0),
    ('V', 400.0),
];

/// Approach angle by the letter of the style, degrees (ISO 5608, table of styles).
const STYLES: [(char, f64); 17] = [
    ('A', 90.0),
    ('B', 75.0),
    ('C', 90.0),
    ('D', 45.0),
    ('E', 60.0),
    ('F', 90.0),
    ('G', 90.0),
    ('H', 107.5),
    ('J', 93.0),
    ('K', 75.0),
    ('L', 95.0),
    ('N', 63.0),
    ('R', 75.0),
    ('S', 45.0),
    ('U', 93.0),
    ('V', 72.5),
    ('Q', 107.5),
];

impl IsoHolder {
    /// Reads a code such as `PCLNR2525M12`, `S20S-SCLCR09`, `SER2525M16` or `SIR0016M16`.
    ///
    /// # Errors
    /// A sentence that names the character that is not understood and what would be.
    pub(in crate::machine) fn read(code: &str) -> Result<Self, String> {
        let compact: String = code.chars().filter(|c| !c.is_whitespace() && *c != '-').collect();
        if !compact.is_ascii() {
            return Err(format!("The code \"{code}\" has characters that no code has."));
        }
        let bar = compact.get(1..3).is_some_and(|digits| digits.bytes().all(|b| b.is_ascii_digit()));
        if bar {
            bored(&compact)
        } else if compact.starts_with("SE") || compact.starts_with("SI") {
            threading(&compact)
        } else {
            outside(&compact)
        }
    }
}

/// Clamping, insert, style, clearance, hand, height, width, length, insert size: `PCLNR2525M12`.
fn outside(code: &str) -> Result<IsoHolder, String> {
    let too_short = || format!("The code \"{code}\" is too short; one such as PCLNR2525M12 has 12 characters.");
    let (head, shank) = code.split_at_checked(5).ok_or_else(too_short)?;
    let width = number(shank.get(2..4).ok_or_else(too_short)?, "width of the shank")?;
    let length = length(shank.chars().nth(4).ok_or_else(too_short)?)?;
    let insert_size = shank.get(5..7).ok_or_else(too_short)?;
    headed(head, insert_size, Seat::Shank { width, length })
}

/// Bar, diameter, length, then clamping, insert, style, clearance, hand, insert size: `S20S-SCLCR09`.
fn bored(code: &str) -> Result<IsoHolder, String> {
    let too_short = || format!("The code \"{code}\" is too short; one such as S20S-SCLCR09 has 11 characters.");
    let diameter = number(code.get(1..3).ok_or_else(too_short)?, "diameter of the bar")?;
    length(code.chars().nth(3).ok_or_else(too_short)?)?;
    let head = code.get(4..9).ok_or_else(too_short)?;
    let insert_size = code.get(9..11).ok_or_else(too_short)?;
    headed(head, insert_size, Seat::Bar { diameter })
}

fn headed(head: &str, insert_size: &str, seat: Seat) -> Result<IsoHolder, String> {
    let letter = |i: usize| head.chars().nth(i).unwrap_or_default();
    if !"CMPSDX".contains(letter(0)) {
        return Err(format!("The clamping \"{}\" is not known; C, D, M, P, S and X are.", letter(0)));
    }
    let insert_letter = letter(1);
    let (style, hand) = (letter(2), hand(letter(4))?);
    let approach = STYLES.iter().find(|(l, _)| *l == style).map(|&(_, angle)| angle);
    let approach = approach.ok_or_else(|| {
        let known: Vec<String> = STYLES.iter().map(|(l, _)| l.to_string()).collect();
        format!("The style \"{style}\" is not known; the styles are {}.", known.join(", "))
    })?;
    let neutral = hand.is_none() || insert_letter == 'R';
    Ok(IsoHolder {
        insert_letter,
        insert_size: insert_size.to_owned(),
        approach_deg: (!neutral).then_some(approach),
        hand,
        seat,
    })
}

/// `SER2525M16` outside, `SIR0016M16` inside: side, hand, height and width (of a bar: 00 and diameter), length, insert size.
fn threading(code: &str) -> Result<IsoHolder, String> {
    let too_short = || format!("The code \"{code}\" is too short; one such as SER2525M16 has 10 characters.");
    let part = |range: std::ops::Range<usize>| code.get(range).ok_or_else(too_short);
    let inside = part(1..2)? == "I";
    let hand = hand(part(2..3)?.chars().next().unwrap_or_default())?;
    let width = number(part(5..7)?, "width of the shank")?;
    let length = length(part(7..8)?.chars().next().unwrap_or_default())?;
    Ok(IsoHolder {
        insert_letter: if inside { 'I' } else { 'E' },
        insert_size: part(8..10)?.to_owned(),
        approach_deg: None,
        hand,
        seat: if inside { Seat::Bar { diameter: width } } else { Seat::Shank { width, length } },
    })
}

fn hand(letter: char) -> Result<Option<Hand>, String> {
    match letter {
        'R' => Ok(Some(Hand::Right)),
        'L' => Ok(Some(Hand::Left)),
        'N' => Ok(None),
        other => Err(format!("The hand \"{other}\" is not known; R, L and N are.")),
    }
}

fn number(digits: &str, what: &str) -> Result<f64, String> {
    let value = digits.parse::<u8>().ok().filter(|v| (5..=80).contains(v));
    value.map(f64::from).ok_or_else(|| format!("The {what} is \"{digits}\"; it must be 05 to 80 mm."))
}

fn length(letter: char) -> Result<f64, String> {
    LENGTHS.iter().find(|(l, _)| *l == letter).map(|&(_, length)| length).ok_or_else(|| {
        let known: Vec<String> = LENGTHS.iter().map(|(l, _)| l.to_string()).collect();
        format!("The length \"{letter}\" is not known; the letters are {}.", known.join(", "))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_give_approach_hand_and_shank() {
        let read = |code| IsoHolder::read(code).unwrap();
        let pclnr = read("PCLNR2525M12");
        assert_eq!((pclnr.approach_deg, pclnr.hand), (Some(95.0), Some(Hand::Right)));
        assert_eq!(pclnr.seat, Seat::Shank { width: 25.0, length: 150.0 });
        assert_eq!((pclnr.insert_letter, pclnr.insert_size.as_str()), ('C', "12"));
        assert_eq!(read("PDJNL2020K11").approach_deg, Some(93.0));
        assert_eq!(read("PTGNR2020K16").approach_deg, Some(90.0));
        assert_eq!(read("SVVBN1616H11").approach_deg, None);
        assert_eq!(read("S20S-SCLCR09").seat, Seat::Bar { diameter: 20.0 });
        assert_eq!(read("SER2525M16").insert_letter, 'E');
        assert_eq!(read("SIR0016M16").seat, Seat::Bar { diameter: 16.0 });
    }

    #[test]
    fn a_wrong_code_is_named() {
        for (code, word) in [
            ("QCLNR2525M12", "clamping \"Q\""),
            ("PCXNR2525M12", "style \"X\""),
            ("PCLNX2525M12", "hand \"X\""),
            ("PCLNR25xxM12", "width"),
            ("PCLNR2525X12", "length \"X\""),
            ("PCLNR2525M", "too short"),
            ("S20S-SCLC", "too short"),
            ("SER25", "too short"),
            ("", "too short"),
        ] {
            let message = IsoHolder::read(code).unwrap_err();
            assert!(message.contains(word), "{code}: {message}");
        }
    }
}
