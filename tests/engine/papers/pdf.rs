//! PDF: objects by the cross-reference table, page sizes, lines in mm, texts through the fonts' own tables.

use super::{Page, drawing, drawn, sheet, texts};
use std::collections::BTreeMap;
use turnwright::geometry::Point;
use turnwright::papers::{Paper, pdf};

/// Single precision on the largest sheet.
const TOLERANCE_MM: f64 = 0.0005;
const POINTS_PER_MM: f64 = 72.0 / 25.4;

/// A file by its objects.
struct Reader<'a> {
    objects: BTreeMap<usize, &'a [u8]>,
}

fn find(bytes: &[u8], wanted: &[u8]) -> Option<usize> {
    bytes.windows(wanted.len()).position(|w| w == wanted)
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

impl<'a> Reader<'a> {
    /// Reads the table at the end and checks that every object is where it says.
    fn new(file: &'a [u8]) -> Self {
        assert!(file.starts_with(b"%PDF-1."));
        let tail = text(&file[file.len() - 64..]);
        let start: usize = tail.split("startxref").nth(1).unwrap().split_whitespace().next().unwrap().parse().unwrap();
        let table = text(&file[start..]);
        let mut lines = table.lines();
        assert_eq!(lines.next(), Some("xref"));
        let count: usize = lines.next().unwrap().split_whitespace().nth(1).unwrap().parse().unwrap();
        let mut objects = BTreeMap::new();
        for (number, line) in lines.take(count).enumerate().filter(|(_, line)| line.contains(" n")) {
            let offset: usize = line.split_whitespace().next().unwrap().parse().unwrap();
            let object = &file[offset..];
            assert!(object.starts_with(format!("{number} 0 obj").as_bytes()), "object {number}");
            objects.insert(number, &object[..find(object, b"endobj").unwrap()]);
        }
        Self { objects }
    }

    /// The object that `key` of `object` refers to.
    fn reference(object: &[u8], key: &str) -> usize {
        let object = text(object);
        let after = object.split(&format!("/{key} ")).nth(1).unwrap_or_else(|| panic!("{key} in {object}"));
        after.trim_start_matches('[').split_whitespace().next().unwrap().parse().unwrap()
    }

    /// The bytes of a stream, as many as its dictionary says.
    fn stream(&self, number: usize) -> &'a [u8] {
        let object = self.objects[&number];
        let from = find(object, b"stream").unwrap() + 7;
        let length = Self::reference(&object[..from], "Length");
        let bytes = &object[from..from + length];
        assert!(text(&object[from + length..]).trim_start().starts_with("endstream"));
        bytes
    }

    fn pages(&self) -> Vec<usize> {
        let is_page = |bytes: &[u8]| find(bytes, b"/Type /Page\n").is_some();
        self.objects.iter().filter(|(_, bytes)| is_page(bytes)).map(|(number, _)| *number).collect()
    }

    /// What every glyph number of a font of a page stands for.
    fn characters(&self, page: usize, font: &str) -> BTreeMap<u16, char> {
        let font = self.objects[&Self::reference(self.objects[&page], font)];
        let descendant = self.objects[&Self::reference(font, "DescendantFonts")];
        let descriptor = self.objects[&Self::reference(descendant, "FontDescriptor")];
        let outlines = self.stream(Self::reference(descriptor, "FontFile3"));
        assert_eq!(outlines[0], 1, "a font in the compact format is embedded");
        let map = text(self.stream(Self::reference(font, "ToUnicode")));
        let pairs = map.lines().filter(|line| line.starts_with('<') && line.matches('<').count() == 2);
        let hex = |part: &str| u16::from_str_radix(part.trim_matches(['<', '>', ' ']), 16).unwrap();
        let pairs = pairs.filter_map(|line| line.split_once(' ')).filter(|(glyph, _)| *glyph != "<0000>");
        pairs.map(|(glyph, c)| (hex(glyph), char::from_u32(u32::from(hex(c))).unwrap())).collect()
    }
}

/// The operators of a page with what stands before each.
fn operators(content: &[u8]) -> Vec<(String, Vec<Operand>)> {
    let (mut made, mut operands, mut at) = (Vec::new(), Vec::new(), 0);
    while let Some(&byte) = content.get(at) {
        match byte {
            b'(' => {
                let (string, after) = literal(content, at + 1);
                operands.push(Operand::String(string));
                at = after;
            }
            b'<' => {
                let end = at + find(&content[at..], b">").unwrap();
                let digits = text(&content[at + 1..end]);
                let bytes = (0..digits.len() / 2).map(|k| u8::from_str_radix(&digits[2 * k..2 * k + 2], 16).unwrap());
                operands.push(Operand::String(bytes.collect()));
                at = end + 1;
            }
            b' ' | b'\n' | b'[' | b']' => at += 1,
            _ => {
                let length = content[at..].iter().position(|b| b" \n[](<".contains(b)).unwrap_or(content.len() - at);
                let token = text(&content[at..at + length]);
                at += length;
                match token.parse() {
                    Ok(number) => operands.push(Operand::Number(number)),
                    Err(_) if token.starts_with('/') => operands.push(Operand::Name(token)),
                    Err(_) => made.push((token, std::mem::take(&mut operands))),
                }
            }
        }
    }
    made
}

#[derive(Debug, Clone, PartialEq)]
enum Operand {
    Number(f64),
    Name(String),
    String(Vec<u8>),
}

/// A string in parentheses, with its escapes.
fn literal(content: &[u8], mut at: usize) -> (Vec<u8>, usize) {
    let (mut string, mut depth) = (Vec::new(), 0);
    loop {
        match content[at] {
            b'\\' => {
                at += 1;
                if content[at].is_ascii_digit() {
                    string.push(u8::from_str_radix(&text(&content[at..at + 3]), 8).unwrap());
                    at += 3;
                    continue;
                }
                string.push(match content[at] {
                    b'n' => b'\n',
                    b'r' => b'\r',
                    b't' => b'\t',
                    b'b' => 8,
                    b'f' => 12,
                    other => other,
                });
            }
            b')' if depth == 0 => return (string, at + 1),
            other => {
                depth += i32::from(other == b'(') - i32::from(other == b')');
                string.push(other);
            }
        }
        at += 1;
    }
}

fn numbers(operands: &[Operand]) -> Vec<f64> {
    operands.iter().filter_map(|o| if let Operand::Number(n) = o { Some(*n) } else { None }).collect()
}

fn compare(pages: &[Page]) {
    let file = pdf(pages).unwrap();
    let reader = Reader::new(&file);
    let numbers_of_pages = reader.pages();
    assert_eq!(numbers_of_pages.len(), pages.len());
    for (number, page) in numbers_of_pages.into_iter().zip(pages) {
        let object = reader.objects[&number];
        let size = text(object).split("/MediaBox [").nth(1).unwrap().split(']').next().unwrap().to_owned();
        let size: Vec<f64> = size.split_whitespace().map(|n| n.parse().unwrap()).collect();
        let wanted = [0.0, 0.0, page.width_mm * POINTS_PER_MM, page.height_mm * POINTS_PER_MM];
        assert!(size.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 0.001), "{size:?} for {wanted:?}");
        let content = operators(reader.stream(Reader::reference(object, "Contents")));
        assert_eq!(content[0].0, "cm");
        assert!((numbers(&content[0].1)[0] - POINTS_PER_MM).abs() < 1e-5, "the page counts in mm");
        compare_lines(&content, page);
        compare_texts(&content, page, &[reader.characters(number, "F0"), reader.characters(number, "F1")]);
    }
}

/// Every line that is stroked begins, bends and ends where the page has it.
fn compare_lines(content: &[(String, Vec<Operand>)], page: &Page) {
    let mut lines: Vec<(Vec<Point>, usize)> = Vec::new();
    let (mut line, mut curves) = (Vec::new(), 0);
    for (operator, operands) in content {
        let numbers = numbers(operands);
        let point = || Point::new(numbers[numbers.len() - 2], numbers[numbers.len() - 1]);
        match operator.as_str() {
            "m" => (line, curves) = (vec![point()], 0),
            "l" => line.push(point()),
            "c" => {
                line.push(point());
                curves += 1;
            }
            "S" | "B*" => lines.push((std::mem::take(&mut line), curves)),
            _ => {}
        }
    }
    let wanted: Vec<_> = drawn(page).into_iter().filter(|(path, _)| !path.segments.is_empty()).collect();
    assert_eq!(lines.len(), wanted.len());
    for ((line, curves), (path, _)) in lines.iter().zip(wanted) {
        let arcs = path.segments.iter().filter(|s| s.radius().is_some()).count();
        assert!((*curves >= arcs) == (arcs > 0 || *curves == 0), "curves are arcs");
        let near = |p: Point| line.iter().map(|q| p.distance(*q)).fold(f64::INFINITY, f64::min);
        let ends = path.segments.iter().flat_map(|s| [s.start(), s.end()]);
        let worst = ends.map(near).fold(0.0, f64::max);
        assert!(worst < TOLERANCE_MM, "{worst} mm: {line:?} for {path:?}");
        // And no point of the file is off the page's line.
        let samples: Vec<Point> =
            path.segments.iter().flat_map(|s| (0..=64).map(|k| s.point_at(f64::from(k) / 64.0))).collect();
        for p in line.iter().skip(1).take(line.len().saturating_sub(2)) {
            let step = path.segments.iter().map(turnwright::geometry::Segment::length).fold(0.0, f64::max) / 64.0;
            assert!(samples.iter().any(|q| q.distance(*p) <= step + TOLERANCE_MM), "{p:?}");
        }
    }
}

/// Every text reads as on the page.
fn compare_texts(content: &[(String, Vec<Operand>)], page: &Page, fonts: &[BTreeMap<u16, char>; 2]) {
    let mut font = &fonts[0];
    let mut read = Vec::new();
    for (operator, operands) in content {
        match (operator.as_str(), operands.first()) {
            ("Tf", Some(Operand::Name(name))) => font = &fonts[usize::from(name == "/F1")],
            ("Tj", Some(Operand::String(codes))) => {
                let glyphs = codes.chunks_exact(2).map(|pair| u16::from_be_bytes([pair[0], pair[1]]));
                read.push(glyphs.map(|glyph| font[&glyph]).collect::<String>());
            }
            _ => {}
        }
    }
    let wanted: Vec<&str> = texts(page).into_iter().map(|t| t.0).collect();
    assert_eq!(read, wanted);
}

#[test]
fn drawings_come_back_from_pdf_on_every_paper() {
    compare(&drawing("QUEEN", None));
    compare(&drawing("1470b-2T", None));
    compare(&drawing("BEARING-HOUSING", None));
    for paper in Paper::ALL {
        compare(&drawing("MASTER", Some(paper)));
    }
}

#[test]
fn setup_sheets_come_back_from_pdf() {
    for name in ["1470b-2T", "SPIGOT", "BEARING-HOUSING"] {
        compare(&sheet(name));
    }
}
