//! HP-GL: a plotter that reads the file moves its pen along the lines of the page.

use super::{Page, Segment, distance, drawing, drawn, sheet, texts};
use turnwright::geometry::Point;
use turnwright::papers::hpgl;

/// A plotter unit is 0.025 mm; a place is off by half of it in both directions, the middle of an arc a little more.
const TOLERANCE_MM: f64 = 0.03;

/// Two units: start, centre and end of an arc are rounded each.
const SETTLE_MM: f64 = 0.05;

/// What a plotter did.
#[derive(Default)]
struct Plotted {
    /// Lines from one pen down to the next pen up.
    lines: Vec<Vec<Segment>>,
    labels: Vec<String>,
}

fn point(text: &str) -> Point {
    let numbers: Vec<f64> = text.split(',').map(|n| n.parse().unwrap()).collect();
    Point::new(numbers[0] / 40.0, numbers[1] / 40.0)
}

/// Follows the commands as a plotter does.
fn plot(file: &str) -> Plotted {
    let mut plotted = Plotted::default();
    let (mut at, mut line, mut down) = (Point::new(0.0, 0.0), Vec::new(), false);
    let mut rest = file;
    while let Some(kind) = rest.get(..2) {
        if kind == "LB" {
            let (label, after) = rest[2..].split_once('\u{3}').expect("a label ends");
            plotted.labels.push(label.to_owned());
            rest = after.trim_start_matches(['\n', ';']);
            continue;
        }
        let (command, after) = rest.split_once(';').expect("a command ends");
        rest = after.trim_start_matches('\n');
        let parameters = &command[2..];
        match kind {
            "PU" => {
                if !line.is_empty() {
                    plotted.lines.push(std::mem::take(&mut line));
                }
                down = false;
                if !parameters.is_empty() {
                    at = point(parameters);
                }
            }
            "PD" => down = true,
            "PA" => {
                let to = point(parameters);
                assert!(down, "a line is drawn with the pen down");
                // Behind an arc the pen only settles on the nearest unit.
                let settles = matches!(line.last(), Some(Segment::Arc { .. })) && at.distance(to) < SETTLE_MM;
                if !settles {
                    line.push(Segment::line(at, to));
                }
                at = to;
            }
            "AA" => {
                let numbers: Vec<f64> = parameters.split(',').map(|n| n.parse().unwrap()).collect();
                let center = Point::new(numbers[0] / 40.0, numbers[1] / 40.0);
                let (sin, cos) = numbers[2].to_radians().sin_cos();
                let arm = at - center;
                let end = center + nalgebra::Vector2::new(cos * arm.x - sin * arm.y, sin * arm.x + cos * arm.y);
                line.push(Segment::Arc { start: at, end, center, ccw: numbers[2] > 0.0 });
                at = end;
            }
            "IN" | "SP" | "LT" | "DI" | "SI" => {}
            other => panic!("command {other}"),
        }
    }
    plotted
}

fn compare(page: &Page) {
    let plotted = plot(&hpgl(page));
    let wanted: Vec<_> = drawn(page).into_iter().filter(|(path, _)| !path.segments.is_empty()).collect();
    assert_eq!(plotted.lines.len(), wanted.len());
    for (line, (path, _)) in plotted.lines.iter().zip(wanted) {
        let apart = distance(line, &path.segments);
        assert!(apart < TOLERANCE_MM, "{apart} mm: {line:?} for {path:?}");
    }
    let texts = texts(page);
    assert_eq!(plotted.labels.len(), texts.len());
    for (label, (text, _)) in plotted.labels.iter().zip(texts) {
        let signs = [("Ø", "D"), ("×", "x"), ("°", " deg"), ("±", "+-"), ("²", "2"), ("⌀", "D"), ("…", "...")];
        let wanted = signs.into_iter().fold(text.to_owned(), |text, (sign, plain)| text.replace(sign, plain));
        assert_eq!(*label, wanted);
    }
}

#[test]
fn drawings_come_back_from_hpgl() {
    for name in ["QUEEN", "MASTER", "1470b-2T", "BEARING-HOUSING"] {
        drawing(name, None).iter().for_each(compare);
    }
}

#[test]
fn setup_sheets_come_back_from_hpgl() {
    sheet("QUEEN").iter().for_each(compare);
}
