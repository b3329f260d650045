//! Details: stretches of the outline at a larger scale, on sheets of their own.

use super::marks::Mark;
use super::row::{Place, Row};
use super::scale::{SCALES, Scale};
use super::subject::Subject;
use super::zones::Zone;
use crate::geometry::{Bounds, Point, Segment};
use crate::papers::page::{Align, Ink, Page, Pen};
use crate::papers::view::View;

/// Least distance of figures from the edge of the room, mm.
const MARGIN_MM: f64 = 4.0;
/// Height of the heading, mm.
const HEADING_MM: f64 = 10.0;
/// Material shown below the outline, mm on paper.
const BELOW_MM: f64 = 4.0;

/// One detail that fits its room.
pub(super) struct Detail {
    zone: Zone,
    view: View,
    above: Row,
    below: Row,
    scale: Scale,
    room: Bounds,
}

impl Detail {
    /// The detail at the largest scale that fits into `room`; `None` if there is none larger than `than`.
    pub(super) fn new(subject: &Subject<'_>, zone: Zone, room: Bounds, than: f64) -> Option<Self> {
        let larger = SCALES.into_iter().filter(|scale| scale.factor > than);
        larger.into_iter().find_map(|scale| Self::at_scale(subject, zone, room, scale))
    }

    fn at_scale(subject: &Subject<'_>, zone: Zone, room: Bounds, scale: Scale) -> Option<Self> {
        let factor = scale.factor;
        let low = subject.outside.smallest_radius(zone.from, zone.to);
        let high = subject.outside.largest_radius(zone.from, zone.to);
        let in_zone = |marks: &[Mark]| marks.iter().filter(|mark| zone.holds(mark)).cloned().collect();
        let middle = f64::midpoint(room.min.z, room.max.z);
        let mut view =
            View { origin: Point::new(middle - f64::midpoint(zone.from, zone.to) * factor, 0.0), scale: factor };
        let along = (room.min.z + MARGIN_MM, room.max.z - MARGIN_MM);
        let above = Row::new(in_zone(&subject.outside_leaders), &view, along)?;
        let below = Row::new(in_zone(&subject.outside_positions), &view, along)?;
        let height = above.height_mm() + (high - low) * factor + BELOW_MM + below.height_mm();
        let spare = room.max.r - room.min.r - HEADING_MM - 2.0 * MARGIN_MM - height;
        if spare < 0.0 || (zone.to - zone.from) * factor > along.1 - along.0 {
            return None;
        }
        view.origin.r = room.min.r + MARGIN_MM + spare / 2.0 + below.height_mm() + BELOW_MM - low * factor;
        Some(Self { zone, view, above, below, scale, room })
    }

    /// Its scale.
    pub(super) const fn scale(&self) -> Scale {
        self.scale
    }

    /// How the part lies on the sheet.
    pub(super) const fn view(&self) -> View {
        self.view
    }

    /// Draws the outline with its figures and a heading.
    pub(super) fn draw(&self, page: &mut Page, subject: &Subject<'_>, letter: &str) {
        let (view, zone) = (self.view, self.zone);
        let low = view.place(Point::new(0.0, subject.outside.smallest_radius(zone.from, zone.to))).r - BELOW_MM;
        let high = view.place(Point::new(0.0, subject.outside.largest_radius(zone.from, zone.to))).r;
        let outline = subject.outside.clipped(zone.from, zone.to);
        for end in outline.first().map(Segment::start).into_iter().chain(outline.last().map(Segment::end)) {
            let end = view.place(end);
            page.line(end, Point::new(end.z, low), Pen::THIN);
        }
        page.path(view.segments(&outline), Pen::EDGE);
        self.above.draw(page, &view, Place { side: 1.0, half: 1.0, edge_r: high });
        self.below.draw(page, &view, Place { side: -1.0, half: 1.0, edge_r: low });
        let at = Point::new(self.room.min.z + MARGIN_MM, self.room.max.r - MARGIN_MM - 3.5);
        page.heading(at, 3.5, format!("{letter}  ({})", self.scale.name()));
        let note = Point::new(at.z + 22.0, at.r);
        page.ink_text(note, 2.0, Align::Start, Ink::Grey, "Positions count from the clamped end of the part.");
    }
}
