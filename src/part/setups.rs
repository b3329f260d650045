//! The clampings of a part: what is machined in each, from what stock, and how it is held.

use super::outside::{faces, outside, walls};
use super::shape::{self, is_usable};
use super::split::split;
use super::{Curve, Piece, PieceRole, Profile, Section, SectionKind, Setup, ThreadSpec, contour};
use crate::diagnostic::{Diagnostic, Place};
use crate::document::{Ends, TurnedPart};
use crate::geometry::{Contour, Point, Segment};
use crate::machine::Machine;

/// Width that the published generator adds at the clamped end for parting off, mm: the width of its blade.
pub const PART_OFF_WIDTH_MM: f64 = 3.0;

/// How far the stock of a second clamping may lie from the parabolas that the first one left, mm.
const STOCK_TOLERANCE_MM: f64 = 1e-3;

/// The clampings of `part_mm`, in order of machining, and what is to be said about them.
///
/// Never fails: a bad row is left out or replaced by a straight line, which [`check()`](super::check()) reports. Only a
/// part without a length has no set-ups. Lengths in mm.
#[must_use]
pub fn setups(part_mm: &TurnedPart, machine: &Machine) -> (Vec<Setup>, Vec<Diagnostic>) {
    let Some(blank) = Blank::of(part_mm) else { return (Vec::new(), Vec::new()) };
    match part_mm.ends {
        Ends::One => (vec![blank.one_end(machine, part_mm.part_off)], Vec::new()),
        Ends::Two { .. } => {
            let (split, mut diagnostics) = split(part_mm, blank.length, machine);
            if part_mm.part_off {
                diagnostics.push(part_off_ignored());
            }
            (vec![blank.first_end(machine, split), blank.second_end(machine, split)], diagnostics)
        }
    }
}

fn part_off_ignored() -> Diagnostic {
    Diagnostic::warning(
        "part-off-two-ends",
        Place::Document,
        "A part machined at both ends is cut to its length before; it is not parted off.",
    )
    .with_hint("Machine one end only, or switch parting-off off.")
}

/// A part with usable figures, in document positions.
struct Blank {
    pieces: Vec<Piece>,
    /// Rows that stand for a face each.
    walls: Vec<Section>,
    threads: Vec<ThreadSpec>,
    length: f64,
    bar_radius: f64,
}

impl Blank {
    fn of(part: &TurnedPart) -> Option<Self> {
        let positive = |value: f64| (is_usable(value) && value > shape::SAME_PLACE_MM).then_some(value);
        let last = part.sections.iter().filter_map(|s| positive(s.z2)).fold(0.0, f64::max);
        let length = positive(part.length).or(positive(last))?;
        let widest = part.sections.iter().filter_map(|s| positive(s.d1.max(s.d2))).fold(0.0, f64::max);
        let bar_radius = positive(part.bar_diameter).unwrap_or(widest) / 2.0;
        let pieces = outside(&part.sections, length, bar_radius);
        Some(Self { pieces, walls: walls(&part.sections), threads: threads(part, length), length, bar_radius })
    }

    fn one_end(&self, machine: &Machine, part_off: bool) -> Setup {
        let width = if part_off { PART_OFF_WIDTH_MM } else { 0.0 };
        let mut pieces = self.pieces.clone();
        if let Some(first) = self.pieces.first().filter(|_| part_off) {
            let curve = Curve::line(Point::new(-width, first.start().r), first.start());
            pieces.insert(0, Piece { curve, section: first.section, role: PieceRole::Surface });
        }
        let chuck_face_z = -machine.chuck.gap_mm - width;
        Setup {
            suffix: String::new(),
            profile: self.with_end_face(pieces),
            threads: self.threads.clone(),
            machined_from_z: -width,
            length: self.length,
            bar_radius: self.bar_radius,
            stock: bar(chuck_face_z - machine.chuck.depth_mm, self.length, self.bar_radius),
            chuck_face_z,
            part_off_width: part_off.then_some(width),
            turned_round: false,
        }
    }

    fn first_end(&self, machine: &Machine, split: f64) -> Setup {
        Setup {
            suffix: "A".to_owned(),
            profile: self.with_end_face(self.pieces.clone()),
            threads: clipped(&self.threads, split, self.length),
            machined_from_z: split,
            length: self.length,
            bar_radius: self.bar_radius,
            stock: bar(0.0, self.length, self.bar_radius),
            chuck_face_z: split - machine.chuck.gap_mm,
            part_off_width: None,
            turned_round: false,
        }
    }

    fn second_end(&self, machine: &Machine, split: f64) -> Setup {
        let turned = Self {
            pieces: self.pieces.iter().rev().map(|piece| piece.turned_round(self.length)).collect(),
            threads: self.threads.iter().rev().map(|thread| thread.turned_round(self.length)).collect(),
            walls: self.walls.iter().rev().map(|wall| turned_round(wall, self.length)).collect(),
            ..*self
        };
        let machined_from_z = self.length - split;
        Setup {
            suffix: "B".to_owned(),
            threads: clipped(&turned.threads, machined_from_z, self.length),
            machined_from_z,
            stock: turned.half_finished(machined_from_z),
            profile: turned.with_end_face(turned.pieces.clone()),
            length: self.length,
            bar_radius: self.bar_radius,
            chuck_face_z: machined_from_z - machine.chuck.gap_mm,
            part_off_width: None,
            turned_round: true,
        }
    }

    /// The profile of pieces with a face down to the axis at the free end.
    fn with_end_face(&self, mut pieces: Vec<Piece>) -> Profile {
        if let Some(last) = pieces.last().copied() {
            pieces.extend(faces(&self.walls, last.end(), 0.0, last.section));
        }
        Profile { pieces }
    }

    /// Outline of the material with its finished outside up to `z` and the bar beyond.
    fn half_finished(&self, z: f64) -> Contour {
        let finished = self.pieces.iter().filter(|piece| piece.start().z < z).map(|piece| {
            let end_z = piece.end().z.min(z);
            if end_z < piece.end().z {
                Piece { curve: piece.curve.between(piece.start().z, end_z), ..*piece }
            } else {
                *piece
            }
        });
        let profile = Profile { pieces: finished.collect() };
        let mut outside = contour(&profile, STOCK_TOLERANCE_MM).contour.segments;
        let last = outside.last().map_or(Point::new(z, 0.0), Segment::end);
        let corner = Point::new(z, self.bar_radius);
        outside.push(Segment::line(last, corner));
        outside.push(Segment::line(corner, Point::new(self.length, self.bar_radius)));
        closed_on_axis(outside)
    }
}

/// A face row in the space of the other end of a part of `length` mm.
fn turned_round(wall: &Section, length: f64) -> Section {
    Section { z1: length - wall.z2, d1: wall.d2, z2: length - wall.z1, d2: wall.d1, ..wall.clone() }
}

/// The bar from `z1` to `z2`, counter-clockwise.
fn bar(z1: f64, z2: f64, radius: f64) -> Contour {
    closed_on_axis(vec![Segment::line(Point::new(z1, radius), Point::new(z2, radius))])
}

/// The outline of the body under `outside` (z growing), counter-clockwise, closed along the axis.
fn closed_on_axis(outside: Vec<Segment>) -> Contour {
    let on_axis = |p: Point| p.r <= shape::SAME_PLACE_MM;
    let body: Vec<Segment> = outside
        .into_iter()
        .skip_while(|s| on_axis(s.start()) && on_axis(s.end()))
        .filter(|s| s.start() != s.end())
        .collect();
    let (Some(first), Some(last)) = (body.first().map(Segment::start), body.last().map(Segment::end)) else {
        return Contour::default();
    };
    let corners = [first, Point::new(first.z, 0.0), Point::new(last.z, 0.0), last];
    let rest = corners.iter().zip(corners.iter().skip(1)).map(|(&a, &b)| Segment::line(a, b));
    let mut segments: Vec<Segment> = rest.filter(|s| s.start() != s.end()).collect();
    segments.extend(body.iter().rev().map(Segment::reversed));
    Contour::new(segments)
}

/// Threads of all usable thread rows, in order of position, within the part.
fn threads(part: &TurnedPart, length: f64) -> Vec<ThreadSpec> {
    let mut threads: Vec<ThreadSpec> = part
        .sections
        .iter()
        .filter_map(|section| match section.kind {
            SectionKind::Thread { pitch } if pitch > 0.0 && is_usable(pitch) && shape::curve(section).is_ok() => {
                Some(ThreadSpec {
                    section: section.id,
                    z1: section.z1,
                    z2: section.z2,
                    outside_radius: section.d1 / 2.0,
                    base_radius: section.d2 / 2.0,
                    pitch,
                })
            }
            _ => None,
        })
        .collect();
    threads.sort_by(|a, b| a.z1.total_cmp(&b.z1));
    clipped(&threads, 0.0, length)
}

/// What of the threads lies between `from` and `to`.
fn clipped(threads: &[ThreadSpec], from: f64, to: f64) -> Vec<ThreadSpec> {
    let inside = threads.iter().map(|t| ThreadSpec { z1: t.z1.max(from), z2: t.z2.min(to), ..*t });
    inside.filter(|t| t.z2 - t.z1 > shape::SAME_PLACE_MM).collect()
}

impl ThreadSpec {
    fn turned_round(&self, length: f64) -> Self {
        Self { z1: length - self.z2, z2: length - self.z1, ..*self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::fixtures;

    fn made(part: &TurnedPart) -> (Vec<Setup>, Vec<Diagnostic>) {
        setups(part, &fixtures::orac())
    }

    fn two_ends(part: TurnedPart, split: Option<f64>) -> TurnedPart {
        TurnedPart { ends: Ends::Two { split }, ..part }
    }

    fn codes(diagnostics: &[Diagnostic]) -> Vec<&str> {
        diagnostics.iter().map(|d| d.code.as_str()).collect()
    }

    #[test]
    fn queen_is_one_clamping_of_twelve_surfaces_and_four_faces() {
        let (setups, diagnostics) = made(&fixtures::queen());
        assert!(diagnostics.is_empty());
        let [setup] = setups.as_slice() else { panic!("one set-up") };
        assert_eq!((setup.chuck_face_z, setup.machined_from_z, setup.part_off_width), (-10.0, 0.0, None));
        let role = |role| setup.profile.pieces.iter().filter(|p| p.role == role).count();
        assert_eq!((role(PieceRole::Surface), role(PieceRole::Face), role(PieceRole::Filler)), (12, 4, 0));
        assert_eq!(setup.profile.radius_at(36.0), Some(8.75));
        let stock = setup.stock.bounds().unwrap();
        assert_eq!((stock.min, stock.max), (Point::new(-40.0, 0.0), Point::new(56.0, 13.1)));
    }

    #[test]
    fn master_gets_the_blade_width_and_its_thread() {
        let (setups, _) = made(&fixtures::master());
        let setup = &setups[0];
        assert_eq!((setup.machined_from_z, setup.chuck_face_z), (-3.0, -13.0));
        assert_eq!(setup.profile.pieces[0].start(), Point::new(-3.0, 12.5));
        assert_eq!(setup.profile.pieces.last().unwrap().end(), Point::new(40.0, 0.0));
        let [thread] = setup.threads.as_slice() else { panic!("one thread") };
        assert_eq!((thread.z1, thread.z2, thread.outside_radius, thread.base_radius), (28.0, 40.0, 6.0, 5.0));
    }

    #[test]
    fn queen_is_split_where_the_first_section_beyond_30_mm_begins() {
        let (setups, diagnostics) = made(&two_ends(fixtures::queen(), None));
        assert_eq!(codes(&diagnostics), ["split-short-grip"]);
        let [a, b] = setups.as_slice() else { panic!("two set-ups") };
        assert_eq!((a.suffix.as_str(), a.machined_from_z, a.chuck_face_z), ("A", 34.0, 24.0));
        assert_eq!((b.suffix.as_str(), b.machined_from_z, b.chuck_face_z), ("B", 22.0, 12.0));
        assert_eq!(b.profile.radius_at(20.0), Some(8.75));
        assert_eq!(b.profile.pieces.last().unwrap().end(), Point::new(56.0, 0.0));
        assert_eq!(b.profile.pieces[0].start(), Point::new(0.0, 0.5));
    }

    #[test]
    fn second_clamping_starts_from_what_the_first_one_left() {
        let (setups, _) = made(&two_ends(fixtures::queen(), Some(34.0)));
        let stock = &setups[1].stock;
        assert!(stock.largest_gap() < 1e-12);
        let (first, last) = (stock.segments.first().unwrap(), stock.segments.last().unwrap());
        assert!(first.start().distance(last.end()) < 1e-12);
        assert!(stock.distance_to(Point::new(40.0, 13.1)) < 1e-12);
        assert!(stock.distance_to(Point::new(20.0, 8.75)) < 1e-9);
        let around: f64 = stock.segments.iter().map(|s| s.start().z * s.end().r - s.end().z * s.start().r).sum();
        assert!(around > 0.0, "counter-clockwise");
    }

    #[test]
    fn split_diagnostics_give_value_and_limit() {
        let (setups, diagnostics) =
            made(&two_ends(fixtures::part(20.0, vec![Section::line(1, 0.0, 20.0, 20.0, 20.0)]), None));
        assert_eq!(setups[0].machined_from_z, 10.0);
        assert_eq!(codes(&diagnostics), ["split-not-found", "split-short-grip", "split-short-grip"]);
        assert!(diagnostics[0].message.contains("30.000 mm") && diagnostics[0].message.contains("10.000 mm"));
        let (_, diagnostics) = made(&two_ends(fixtures::queen(), Some(80.0)));
        assert!(codes(&diagnostics).contains(&"split-outside-part"));
    }

    #[test]
    fn a_thread_over_the_split_point_is_an_error() {
        let (setups, diagnostics) = made(&two_ends(fixtures::master(), Some(34.0)));
        assert!(codes(&diagnostics).contains(&"split-through-thread"));
        assert!(codes(&diagnostics).contains(&"part-off-two-ends"));
        assert_eq!((setups[0].threads[0].z1, setups[1].threads[0].z2), (34.0, 12.0));
    }

    #[test]
    fn a_part_without_length_has_no_setups() {
        assert!(made(&fixtures::part(f64::NAN, vec![])).0.is_empty());
    }

    mod random_tables {
        use super::*;
        use crate::machine::{Catalog, ToolOutline, outlines};
        use crate::units::Unit;
        use proptest::prelude::*;
        use std::collections::BTreeMap;
        use std::sync::LazyLock;

        static TOOLS: LazyLock<BTreeMap<u32, ToolOutline>> =
            LazyLock::new(|| outlines(&fixtures::orac(), &Catalog::shipped()));

        fn figure() -> impl Strategy<Value = f64> {
            prop_oneof![
                20 => (0..600_i32).prop_map(|v| f64::from(v) / 10.0),
                10 => 0.0..60.0_f64,
                1 => Just(f64::NAN),
                1 => Just(f64::INFINITY),
                1 => -5.0..0.0_f64,
                1 => Just(1e300),
            ]
        }

        fn kind() -> impl Strategy<Value = SectionKind> {
            (0..6_u8, figure(), figure(), 0..50_u32).prop_map(|(kind, a, b, chords)| match kind {
                0 => SectionKind::Line,
                1 => SectionKind::Concave { radius: a },
                2 => SectionKind::Convex { radius: a },
                3 => SectionKind::Thread { pitch: a },
                4 => SectionKind::ParabolaAlongZ { z3: a, d3: b, chords },
                _ => SectionKind::ParabolaAlongX { z3: a, d3: b, chords },
            })
        }

        prop_compose! {
            fn row()(z1 in figure(), step in figure(), d1 in figure(), d2 in figure(), kind in kind()) -> Section {
                Section { id: 0, z1, d1, z2: z1 + step, d2, kind }
            }
        }

        prop_compose! {
            fn any_part()(
                rows in proptest::collection::vec(row(), 0..12),
                length in figure(),
                split in proptest::option::of(figure()),
                two in any::<bool>(),
                part_off in any::<bool>(),
            ) -> TurnedPart {
                let mut part = fixtures::part(length, rows);
                (1..).zip(&mut part.sections).for_each(|(id, row)| row.id = id);
                TurnedPart { part_off, ends: if two { Ends::Two { split } } else { Ends::One }, ..part }
            }
        }

        fn assert_sound(setup: &Setup) {
            let profile = &setup.profile;
            for pair in profile.pieces.windows(2) {
                assert_that(pair[0].end().distance(pair[1].start()) <= 1e-9, "connected", setup);
            }
            let points = profile.polyline(0.01);
            assert_that(points.iter().all(|p| p.is_finite() && p.r > -1e-5), "finite and above the axis", setup);
            assert_that(points.windows(2).all(|w| w[1].z >= w[0].z - 1e-9), "z never decreases", setup);
            let contour = contour(profile, 0.01);
            assert_that(contour.contour.largest_gap() <= 1e-9, "contour connected", setup);
            let points = contour.contour.polyline(0.01);
            assert_that(points.iter().all(|p| p.is_finite()), "contour finite", setup);
            assert_that(setup.stock.polyline(0.01).iter().all(|p| p.is_finite()), "stock finite", setup);
        }

        fn assert_that(holds: bool, what: &str, setup: &Setup) {
            assert!(holds, "{what}: {:#?}", setup.profile);
        }

        proptest! {
            #![proptest_config(ProptestConfig::with_cases(200))]

            #[test]
            fn every_table_is_checked_and_gives_sound_profiles(part in any_part()) {
                for diagnostic in crate::part::check(&part, Unit::Inch, &fixtures::orac()) {
                    let unreadable = ["NaN", "inf"].iter().any(|word| diagnostic.message.contains(word));
                    assert!(!unreadable, "{}", diagnostic.message);
                }
                for setup in made(&part).0 {
                    assert_sound(&setup);
                    let areas = crate::part::unreachable(&setup, &TOOLS, &fixtures::orac());
                    assert!(areas.iter().flat_map(|area| &area.outline).all(|p| p.is_finite()));
                }
            }
        }
    }
}
