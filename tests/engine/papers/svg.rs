//! SVG: every path and every text where the page has it.

use super::{Page, Segment, distance, drawing, sheet, texts};
use turnwright::geometry::Point;
use turnwright::papers::{Item, Paper, svg};

/// Largest difference of a place: the file has four decimals.
const TOLERANCE_MM: f64 = 0.0002;

/// The value of an attribute.
fn attribute<'a>(tag: &'a str, name: &str) -> &'a str {
    let start = tag.find(&format!(" {name}=\"")).unwrap_or_else(|| panic!("{name} in {tag}")) + name.len() + 3;
    tag[start..].split('"').next().unwrap()
}

/// The segments of path data with the commands M, L and A, turned over so that r grows upwards.
fn segments(data: &str, height: f64) -> Vec<Segment> {
    let mut at = Point::new(0.0, 0.0);
    let mut made = Vec::new();
    let kinds = data.chars().filter(char::is_ascii_alphabetic);
    for (text, kind) in data.split(|c: char| c.is_ascii_alphabetic()).skip(1).zip(kinds) {
        let numbers: Vec<f64> = text.split_whitespace().map(|n| n.parse().unwrap()).collect();
        let to = Point::new(numbers[numbers.len() - 2], height - numbers[numbers.len() - 1]);
        match kind {
            'M' => {}
            'L' => made.push(Segment::line(at, to)),
            'A' => {
                // The sweep flag counts with the page's own direction, downwards.
                made.push(arc(at, to, numbers[0], numbers[3] > 0.5, numbers[4] < 0.5));
            }
            other => panic!("command {other}"),
        }
        at = to;
    }
    made
}

/// The arc through two points of a radius, by the flags of the format.
fn arc(start: Point, end: Point, radius: f64, large: bool, ccw: bool) -> Segment {
    let chord = end - start;
    let half = chord.norm() / 2.0;
    let height = (radius * radius - half * half).max(0.0).sqrt();
    let left = nalgebra::Vector2::new(-chord.y, chord.x) / (2.0 * half);
    let middle = start + chord / 2.0;
    let center = if large == ccw { middle - left * height } else { middle + left * height };
    Segment::Arc { start, end, center, ccw }
}

fn compare(page: &Page) {
    let file = svg(page);
    let tags: Vec<&str> = file.split('<').filter(|tag| tag.starts_with("path")).collect();
    let root = file.split('<').find(|tag| tag.starts_with("svg")).unwrap();
    assert_eq!(attribute(root, "width"), format!("{}mm", page.width_mm));
    assert_eq!(attribute(root, "height"), format!("{}mm", page.height_mm));
    assert_eq!(attribute(root, "viewBox"), format!("0 0 {} {}", page.width_mm, page.height_mm));
    let paths = page.items.iter().filter_map(|i| if let Item::Path { path, .. } = i { Some(path) } else { None });
    let wanted: Vec<_> = paths.filter(|path| !path.segments.is_empty()).collect();
    assert_eq!(tags.len(), wanted.len());
    for (tag, path) in tags.iter().zip(wanted) {
        let read = segments(attribute(tag, "d"), page.height_mm);
        // Half circles and small radii make the centre of an arc inexact, its ends and its middle not.
        assert!(distance(&read, &path.segments) < TOLERANCE_MM * 5.0, "{tag}");
    }
    let written: Vec<&str> = file.split("<text").skip(1).collect();
    let wanted = texts(page);
    assert_eq!(written.len(), wanted.len());
    for (tag, (text, at)) in written.iter().zip(wanted) {
        let said = tag.split('>').nth(1).and_then(|t| t.split('<').next()).unwrap();
        assert_eq!(said.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&"), text);
        let place = |name: &str| attribute(tag, name).parse::<f64>().unwrap();
        assert!((place("x") - at.z).abs() < TOLERANCE_MM && (page.height_mm - place("y") - at.r).abs() < TOLERANCE_MM);
    }
}

#[test]
fn drawings_come_back_from_svg() {
    for (name, paper) in [("QUEEN", None), ("MASTER", Some(Paper::A2)), ("1470b-2T", None), ("BEARING-HOUSING", None)] {
        drawing(name, paper).iter().for_each(compare);
    }
}

#[test]
fn setup_sheets_come_back_from_svg() {
    sheet("1470b-2T").iter().for_each(compare);
}
