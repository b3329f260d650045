//! The published program of a form-roll for the Fanuc 6T (Wong 1983, Fig. 8.31 a) as a path.

use super::scan;
use turnwright::geometry::Point;
use turnwright::turning::{Cut, CutMove, CutterPath, Feed, Operation, OperationKind, Speed};

/// The listing.
pub(crate) const LISTING: &str = include_str!("../../cases/1470b/NC1470b-2T.nc");

/// The path that the listing describes: X is a negative diameter, I the start's radius less the centre's.
pub(crate) fn path_of_listing() -> CutterPath {
    let mut path = CutterPath::default();
    let (mut at, mut motion, mut cut_feed, mut speed) = (Point::default(), 0, 0.1, 200.0);
    for line in LISTING.lines() {
        let words = scan(line);
        let value = |letter: char| words.iter().find(|w| w.letter == letter).map(|w| w.value);
        let has = |code: &str| words.iter().any(|w| w.text() == code);
        let to = Point::new(value('Z').unwrap_or(at.z), value('X').map_or(at.r, |x| -x / 2.0));
        if has("G50") {
            let tool = 0;
            let kind = OperationKind::RoughRight;
            path.operations.push(Operation {
                kind,
                name: String::new(),
                tool,
                change: Some(to),
                moves: Vec::new(),
                recipes: Vec::new(),
            });
            at = to;
            continue;
        }
        let Some(operation) = path.operations.last_mut() else { continue };
        if let Some(t) = value('T').filter(|_| operation.tool == 0) {
            operation.tool = (t / 100.0) as u32;
        }
        if has("G96") {
            speed = value('S').unwrap();
            continue;
        }
        for code in 0..4 {
            if has(&format!("G{code}")) {
                motion = code;
            }
        }
        if value('X').or(value('Z')).is_none() {
            continue;
        }
        cut_feed = value('F').unwrap_or(cut_feed);
        let cut =
            Cut { feed: Feed::PerRev(cut_feed), speed: Speed::Surface { m_per_min: speed, max_rpm: f64::INFINITY } };
        operation.moves.push(match motion {
            0 => CutMove::Rapid { to },
            1 => CutMove::Line { to, cut },
            _ => {
                let center = Point::new(at.z + value('K').unwrap(), at.r - value('I').unwrap());
                CutMove::Arc { to, center, ccw: motion == 2, cut }
            }
        });
        at = to;
    }
    path
}
