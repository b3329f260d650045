//! The lines of a roll profile, read and checked one by one.

use super::SAME_PLACE_MM;
use crate::diagnostic::{Diagnostic, has_errors};
use crate::geometry::Point;
use crate::textfile::line_place;

/// Numbers in a line.
pub(super) const COLUMNS: usize = 10;

/// Names of the columns, for messages.
const NAMES: [&str; COLUMNS] = [
    "element number",
    "type",
    "start z",
    "start radius",
    "end z",
    "end radius",
    "A or centre z",
    "B or centre radius",
    "C or arc radius",
    "sense",
];

/// Largest magnitude of a figure; no lathe is that long.
const MOST_MM: f64 = 100_000.0;

/// How far an end may lie from the arc's circle, mm: five units of the last figure.
const OFF_CIRCLE_MM: f64 = 0.005;

/// One element of a profile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Element {
    /// Its number.
    pub number: u32,
    /// Its line in the file.
    pub line: usize,
    /// Where it starts by its own figures.
    pub start: Point,
    /// Where it ends.
    pub end: Point,
    /// What it is.
    pub shape: Shape,
}

/// What an element is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Shape {
    /// A straight line.
    Line,
    /// An arc.
    Arc {
        /// Centre.
        center: Point,
        /// Radius, mm.
        radius: f64,
        /// Counter-clockwise, z to the right and the radius upwards.
        ccw: bool,
    },
}

/// The elements of a profile up to the line of zeros.
pub(super) fn read(file: &str, text: &str) -> Result<Vec<Element>, Vec<Diagnostic>> {
    let mut elements: Vec<Element> = Vec::new();
    let mut diagnostics = Vec::new();
    let mut ended = false;
    let lines = (1..).zip(text.lines()).filter(|(_, line)| !line.trim().is_empty());
    for (line, words) in lines {
        let reader = Line { file, line };
        if ended {
            let message = format!("The list has ended; `{}` behind it is not read.", shortened(words));
            diagnostics.push(Diagnostic::warning("roll-more-lines", line_place(file, line, None), message));
            break;
        }
        match reader.figures(words) {
            Ok(figures) if figures == [0.0; COLUMNS] => ended = true,
            Ok(figures) => match reader.element(&figures, elements.last()) {
                Ok(element) => elements.push(element),
                Err(diagnostic) => diagnostics.push(diagnostic),
            },
            Err(diagnostic) => diagnostics.push(diagnostic),
        }
    }
    if !ended {
        let message =
            format!("The file ends after {} elements without the line of zeros that ends the list.", elements.len());
        diagnostics.push(Diagnostic::error(
            "roll-truncated",
            line_place(file, text.lines().count().max(1), None),
            message,
        ));
    } else if elements.is_empty() {
        let message = "The list has 0 elements; a roll has at least 1.";
        diagnostics.push(Diagnostic::error("roll-empty", line_place(file, 1, None), message));
    }
    if has_errors(&diagnostics) { Err(diagnostics) } else { Ok(elements) }
}

fn shortened(words: &str) -> String {
    words.trim().chars().take(20).collect()
}

/// A line of the file.
#[derive(Clone, Copy)]
struct Line<'a> {
    file: &'a str,
    line: usize,
}

impl Line<'_> {
    fn refused(self, code: &str, message: impl Into<String>) -> Diagnostic {
        Diagnostic::error(code, line_place(self.file, self.line, None), message)
    }

    fn figures(self, text: &str) -> Result<[f64; COLUMNS], Diagnostic> {
        let words: Vec<&str> = text.split_whitespace().collect();
        if words.len() != COLUMNS {
            let message = format!("The line has {} numbers; an element has {COLUMNS}.", words.len());
            return Err(self.refused("roll-columns", message));
        }
        let mut figures = [0.0; COLUMNS];
        for ((figure, word), (column, name)) in figures.iter_mut().zip(&words).zip((1..).zip(NAMES)) {
            let value = word.parse().ok().filter(|v: &f64| v.is_finite() && v.abs() <= MOST_MM);
            *figure = value.ok_or_else(|| {
                let limit = format!("it must be a number of at most {MOST_MM}");
                self.refused("roll-number", format!("Number {column} ({name}) is `{}`; {limit}.", shortened(word)))
            })?;
        }
        Ok(figures)
    }

    fn element(self, figures: &[f64; COLUMNS], before: Option<&Element>) -> Result<Element, Diagnostic> {
        let &[number, kind, z1, r1, z2, r2, a, b, c, sense] = figures;
        let expected = before.map_or(1, |b| b.number.saturating_add(1));
        if number != f64::from(expected) {
            let message = format!("The element's number is {number}; {expected} comes next.");
            return Err(self.refused("roll-order", message));
        }
        let (start, end) = (Point::new(z1, r1), Point::new(z2, r2));
        if r1.min(r2) < 0.0 {
            return Err(
                self.refused("roll-radius", format!("The radius is {} mm; it must be 0 mm or more.", r1.min(r2)))
            );
        }
        let gap = before.map_or(0.0, |b| b.end.distance(start));
        if gap > SAME_PLACE_MM {
            let message = format!(
                "The element starts {gap:.4} mm from the end of element {}; at most {SAME_PLACE_MM} mm are rounding.",
                expected - 1
            );
            return Err(self.refused("roll-gap", message));
        }
        let shape = match (kind, sense) {
            (1.0, 0.0) => Shape::Line,
            (2.0, 1.0 | -1.0) => self.arc(start, end, Point::new(a, b), c, sense > 0.0)?,
            _ => {
                let message =
                    format!("Type and sense are {kind} and {sense}; a line is 1 and 0, an arc is 2 and 1 or -1.");
                return Err(self.refused("roll-type", message));
            }
        };
        Ok(Element { number: expected, line: self.line, start, end, shape })
    }

    fn arc(self, start: Point, end: Point, center: Point, radius: f64, ccw: bool) -> Result<Shape, Diagnostic> {
        for (name, end) in [("start", start), ("end", end)] {
            let off = end.distance(center) - radius;
            if off.abs() > OFF_CIRCLE_MM {
                let message = format!(
                    "The arc's {name} lies {off:.4} mm off its circle of radius {radius} mm; at most {OFF_CIRCLE_MM} mm are \
                     rounding."
                );
                return Err(self.refused("roll-arc", message));
            }
        }
        // Travelling along the chord, the centre of a counter-clockwise arc of up to half a turn is on the left.
        let left = (end - start).perp(&(center - start)) > 0.0;
        if left != ccw || radius <= 0.0 {
            let message = format!("With its sense the arc of radius {radius} mm would turn by more than half a turn.");
            return Err(self.refused("roll-arc", message));
        }
        Ok(Shape::Arc { center, radius, ccw })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const END: &str = "0 0 0 0 0 0 0 0 0 0\n";
    const FIRST: &str = "1 1 0 0 0 50 1 0 0 0\n";

    fn code(text: &str) -> (String, usize) {
        let found = read("E", text).unwrap_err().remove(0);
        let crate::diagnostic::Place::Line { line, .. } = found.at else { panic!("a line") };
        (found.code, line)
    }

    #[test]
    fn every_line_that_cannot_be_used_is_named() {
        let with = |second: &str| code(&format!("{FIRST}{second}\n{END}"));
        let line2 = |code: &str| (code.to_owned(), 2);
        assert_eq!(with("2 1 0 50 10 50 0 1 -50"), line2("roll-columns"));
        assert_eq!(with("2 1 0 50 ten 50 0 1 -50 0"), line2("roll-number"));
        assert_eq!(with("2 1 0 50 1e9 50 0 1 -50 0"), line2("roll-number"));
        assert_eq!(with("3 1 0 50 10 50 0 1 -50 0"), line2("roll-order"));
        assert_eq!(with("2 1 0 50 10 -50 0 1 -50 0"), line2("roll-radius"));
        assert_eq!(with("2 1 0 50.1 10 50 0 1 -50 0"), line2("roll-gap"));
        assert_eq!(with("2 3 0 50 10 50 0 1 -50 0"), line2("roll-type"));
        assert_eq!(with("2 2 0 50 2 52 2 50 2.1 -1"), line2("roll-arc"));
        assert_eq!(with("2 2 0 50 2 52 2 50 2 1"), line2("roll-arc"));
        assert!(read("E", &format!("{FIRST}2 2 0 50 2 52 2 50 2 -1\n{END}")).is_ok());
    }

    #[test]
    fn all_bad_lines_are_reported_together() {
        let text = format!("{FIRST}2 1 0 50 x 50 0 1 -50 0\n2 1 0 50 y 50 0 1 -50 0\n{END}");
        assert_eq!(read("E", &text).unwrap_err().len(), 2);
    }

    #[test]
    fn the_list_needs_its_end_and_an_element() {
        assert_eq!(code(FIRST).0, "roll-truncated");
        assert_eq!(code("").0, "roll-truncated");
        assert_eq!(code(END).0, "roll-empty");
        assert!(read("E", &format!("{FIRST}{END}more")).is_ok());
    }
}
