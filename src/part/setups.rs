//! The clampings of a part: what is machined in each, from what stock, and how it is held.

use super::bore::{self, bore};
use super::holding::held;
use super::outside::{faces, outside, walls};
use super::shape::{self, is_usable};
use super::split::split;
use super::stock;
use super::thread::{clipped, threads};
use super::{Curve, Piece, PieceRole, Profile, Section, Setup, ThreadSpec};
use crate::diagnostic::{Diagnostic, Place};
use crate::document::{Ends, Holding, TurnedPart};
use crate::geometry::Point;
use crate::machine::Machine;

/// Width that the published generator adds at the clamped end for parting off, mm: the width of its blade.
pub const PART_OFF_WIDTH_MM: f64 = 3.0;

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

/// A part with usable figures, in the space of one of its ends.
struct Blank {
    pieces: Vec<Piece>,
    /// Rows that stand for a face each.
    walls: Vec<Section>,
    threads: Vec<ThreadSpec>,
    bore: Vec<Piece>,
    bore_threads: Vec<ThreadSpec>,
    length: f64,
    bar_radius: f64,
    /// Radius of the hole in a tube, 0 for solid bar.
    hole_radius: f64,
    /// Material beyond the free end.
    facing: f64,
    holding: Holding,
}

impl Blank {
    fn of(part: &TurnedPart) -> Option<Self> {
        let positive = |value: f64| (is_usable(value) && value > shape::SAME_PLACE_MM).then_some(value);
        let last = part.sections.iter().filter_map(|s| positive(s.z2)).fold(0.0, f64::max);
        let length = positive(part.length).or(positive(last))?;
        let widest = part.sections.iter().filter_map(|s| positive(s.d1.max(s.d2))).fold(0.0, f64::max);
        let bar_radius = positive(part.bar_diameter).unwrap_or(widest) / 2.0;
        let hole = positive(part.stock_bore_diameter).map(|d| d / 2.0).filter(|r| *r < bar_radius);
        let hole_radius = hole.unwrap_or(0.0);
        Some(Self {
            pieces: outside(&part.sections, length, bar_radius),
            walls: walls(&part.sections),
            threads: threads(&part.sections, length),
            bore: bore(&part.bore, length, hole_radius),
            bore_threads: threads(&part.bore, length),
            length,
            bar_radius,
            hole_radius,
            facing: positive(part.facing_allowance).unwrap_or(0.0),
            holding: part.holding,
        })
    }

    /// A set-up that machines the outside from `machined_from_z` and the bore from `bored_from_z`, of `stock` from `from_z`.
    fn setup(&self, machine: &Machine, chuck_face_z: f64, [machined_from_z, bored_from_z, from_z]: [f64; 3]) -> Setup {
        let to_z = self.length + self.facing;
        let held = held(self.holding, machine, chuck_face_z, from_z, to_z);
        let bored_from_z = self.bored_from(bored_from_z);
        Setup {
            suffix: String::new(),
            profile: self.with_end_face(self.pieces.clone()),
            threads: clipped(&self.threads, machined_from_z, self.length),
            machined_from_z,
            bore: (!self.bore.is_empty()).then(|| Profile { pieces: self.bore.clone() }),
            bore_threads: clipped(&self.bore_threads, bored_from_z, self.length),
            bored_from_z,
            length: self.length,
            bar_radius: self.bar_radius,
            stock: stock::bar(from_z, to_z, self.bar_radius, self.hole_radius),
            holding: self.holding,
            directions: held.directions,
            chuck_face_z: held.chuck_face_z,
            mandrel: held.mandrel,
            tailstock: held.tailstock,
            part_off_width: None,
            turned_round: false,
        }
    }

    fn one_end(mut self, machine: &Machine, part_off: bool) -> Setup {
        let width = if part_off { PART_OFF_WIDTH_MM } else { 0.0 };
        if part_off {
            self.extend_into_cut(width);
        }
        let chuck_face_z = -machine.chuck.gap_mm - width;
        let from_z = match self.holding {
            Holding::Chuck => chuck_face_z - machine.chuck.depth_mm,
            Holding::BetweenCentres => -width,
        };
        let setup = self.setup(machine, chuck_face_z, [-width, f64::NEG_INFINITY, from_z]);
        Setup { part_off_width: part_off.then_some(width), ..setup }
    }

    /// Lets outside and bore run on through the cut that parts the piece off.
    fn extend_into_cut(&mut self, width: f64) {
        for pieces in [&mut self.pieces, &mut self.bore] {
            if let Some(first) = pieces.first().copied().filter(|first| first.start().z <= shape::SAME_PLACE_MM) {
                let curve = Curve::line(Point::new(-width, first.start().r), first.start());
                pieces.insert(0, Piece { curve, section: first.section, role: PieceRole::Surface });
            }
        }
    }

    fn first_end(&self, machine: &Machine, split: f64) -> Setup {
        let chuck_face_z = split - machine.chuck.gap_mm;
        let setup = self.setup(machine, chuck_face_z, [split, self.bored_first_from(), -self.facing]);
        Setup { suffix: "A".to_owned(), ..setup }
    }

    fn second_end(&self, machine: &Machine, split: f64) -> Setup {
        let turned = self.turned_round();
        let machined_from_z = self.length - split;
        let chuck_face_z = machined_from_z - machine.chuck.gap_mm;
        let bored_before = self.length - self.bored_from(self.bored_first_from());
        let bored_from_z = bore::narrowest(&self.bore).map_or(0.0, |(low, ..)| self.length - low);
        let to_z = self.length + self.facing;
        let outside = stock::half_finished(&turned.pieces, machined_from_z, 0.0, to_z, self.bar_radius);
        let inside = stock::half_finished(&turned.bore, bored_before, 0.0, to_z, self.hole_radius);
        Setup {
            suffix: "B".to_owned(),
            stock: stock::body(outside, inside),
            turned_round: true,
            ..turned.setup(machine, chuck_face_z, [machined_from_z, bored_from_z, 0.0])
        }
    }

    /// The same part in the space of its other end.
    fn turned_round(&self) -> Self {
        let pieces = |pieces: &[Piece]| pieces.iter().rev().map(|piece| piece.turned_round(self.length)).collect();
        let threads =
            |threads: &[ThreadSpec]| threads.iter().rev().map(|thread| thread.turned_round(self.length)).collect();
        Self {
            pieces: pieces(&self.pieces),
            threads: threads(&self.threads),
            walls: self.walls.iter().rev().map(|wall| turned_round(wall, self.length)).collect(),
            bore: pieces(&self.bore),
            bore_threads: threads(&self.bore_threads),
            ..*self
        }
    }

    /// Where the first of two clampings ends to bore: behind the narrowest place, or in front of a web.
    fn bored_first_from(&self) -> f64 {
        bore::narrowest(&self.bore).map_or(0.0, |(low, high, r)| if r > shape::SAME_PLACE_MM { low } else { high })
    }

    /// Where the bore of this set-up begins that reaches from `z` to the free end: `z`, but not before the bore itself, or
    /// the length of the part if the bore does not come out there.
    fn bored_from(&self, z: f64) -> f64 {
        let first = self.bore.first().map_or(self.length, |piece| piece.start().z);
        let last = self.bore.last().map(Piece::end);
        if bore::is_open_at(last, self.length) { z.max(first) } else { self.length }
    }

    /// The profile of pieces with a face at the free end, down to the bore or to the axis.
    fn with_end_face(&self, mut pieces: Vec<Piece>) -> Profile {
        if let Some(last) = pieces.last().copied() {
            let bore = self.bore.last().map(Piece::end).filter(|&end| bore::is_open_at(Some(end), self.length));
            let to_r = bore.map_or(0.0, |end| end.r.min(last.end().r));
            pieces.extend(faces(&self.walls, last.end(), to_r, last.section));
        }
        Profile { pieces }
    }
}

/// A face row in the space of the other end of a part of `length` mm.
fn turned_round(wall: &Section, length: f64) -> Section {
    Section { z1: length - wall.z2, d1: wall.d2, z2: length - wall.z1, d2: wall.d1, ..wall.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Contour;
    use crate::machine::Catalog;
    use crate::part::{SectionKind, contour, fixtures};

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
        assert_eq!((thread.z1, thread.z2, thread.crest_radius, thread.base_radius), (28.0, 40.0, 6.0, 5.0));
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

    /// A sleeve of 40 mm with a counterbore at either end of its 10 mm hole.
    fn sleeve() -> TurnedPart {
        let bore = vec![
            Section::line(2, 0.0, 16.0, 8.0, 16.0),
            Section::line(3, 8.0, 10.0, 30.0, 10.0),
            Section::line(4, 30.0, 20.0, 40.0, 20.0),
        ];
        TurnedPart { bore, ..fixtures::part(40.0, vec![Section::line(1, 0.0, 26.2, 40.0, 26.2)]) }
    }

    fn inside_of(stock: &Contour, z: f64) -> f64 {
        let points = stock.polyline(0.01);
        let pairs = points.iter().zip(points.iter().skip(1)).filter(|(a, b)| a.z < z && b.z > z);
        pairs.map(|(a, b)| a.r + (b.r - a.r) * (z - a.z) / (b.z - a.z)).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn a_bore_is_machined_from_both_ends_down_to_its_narrowest_place() {
        let (setups, _) = made(&two_ends(sleeve(), Some(20.0)));
        let [a, b] = setups.as_slice() else { panic!("two set-ups") };
        assert_eq!((a.bored_from_z, b.bored_from_z), (8.0, 32.0));
        assert_eq!(a.profile.pieces.last().unwrap().end(), Point::new(40.0, 10.0));
        assert_eq!(b.profile.pieces.last().unwrap().end(), Point::new(40.0, 8.0));
        assert_eq!(b.bore.as_ref().unwrap().pieces[0].start(), Point::new(0.0, 10.0));
        assert_eq!((inside_of(&a.stock, 20.0), inside_of(&b.stock, 5.0)), (0.0, 10.0));
        assert_eq!((inside_of(&b.stock, 20.0), inside_of(&b.stock, 36.0)), (5.0, 0.0));
    }

    #[test]
    fn a_blind_hole_is_machined_from_its_open_end_alone() {
        let mut part = sleeve();
        part.bore = vec![Section::line(2, 25.0, 10.0, 40.0, 10.0)];
        let (setups, _) = made(&two_ends(part.clone(), Some(20.0)));
        assert_eq!((setups[0].bored_from_z, setups[1].bored_from_z), (25.0, 40.0));
        part.bore = vec![Section::line(2, 0.0, 10.0, 15.0, 10.0)];
        let (setups, _) = made(&two_ends(part, Some(20.0)));
        assert_eq!((setups[0].bored_from_z, setups[1].bored_from_z), (40.0, 25.0));
        assert_eq!(inside_of(&setups[1].stock, 5.0), 0.0);
    }

    #[test]
    fn parting_off_lets_the_bore_run_through_the_cut() {
        let (setups, _) = made(&TurnedPart { part_off: true, ..sleeve() });
        assert_eq!(setups[0].bore.as_ref().unwrap().pieces[0].start(), Point::new(-3.0, 8.0));
        assert_eq!(setups[0].bored_from_z, -3.0);
    }

    #[test]
    fn threads_of_the_bore_are_apart_from_those_outside() {
        let mut part = sleeve();
        part.bore[2].kind = SectionKind::Thread { pitch: 1.5, starts: 2 };
        part.bore[2].d2 = 21.6;
        let setup = made(&part).0.remove(0);
        assert!(setup.threads.is_empty());
        let [thread] = setup.bore_threads.as_slice() else { panic!("one thread") };
        assert_eq!((thread.crest_radius, thread.base_radius, thread.lead()), (10.0, 10.8, 3.0));
    }

    #[test]
    fn a_tube_keeps_its_hole_and_its_material_for_facing() {
        let part = TurnedPart { bore: vec![], stock_bore_diameter: 12.0, facing_allowance: 1.5, ..sleeve() };
        let setup = made(&part).0.remove(0);
        let stock = setup.stock.bounds().unwrap();
        assert_eq!((stock.min.r, stock.max.z), (6.0, 41.5));
        assert_eq!(setup.bore.unwrap().radius_at(20.0), Some(6.0));
        let (setups, _) = made(&two_ends(part, Some(20.0)));
        let ends: Vec<_> = setups.iter().map(|s| s.stock.bounds().unwrap()).map(|b| (b.min.z, b.max.z)).collect();
        assert_eq!(ends, [(-1.5, 41.5), (0.0, 41.5)]);
    }

    #[test]
    fn between_centres_both_directions_may_be_cut_and_the_tailstock_stands_at_the_free_end() {
        let machine = Catalog::shipped().machine("mori-fanuc-6t").unwrap().clone();
        let part = TurnedPart { holding: Holding::BetweenCentres, facing_allowance: 2.0, bore: vec![], ..sleeve() };
        let setup = setups(&part, &machine).0.remove(0);
        assert!(setup.may_cut_both_ways());
        assert_eq!(setup.stock.bounds().unwrap().min.z, 0.0);
        assert_eq!(setup.tailstock.as_ref().unwrap().bounds().unwrap().min.z, 42.0);
        let mandrel = setup.mandrel.as_ref().unwrap().bounds().unwrap();
        assert_eq!((mandrel.max.z, mandrel.min.z), (0.0, setup.chuck_face_z));
        let chucked = setups(&TurnedPart { holding: Holding::Chuck, ..part }, &machine).0.remove(0);
        assert!(!chucked.may_cut_both_ways() && chucked.tailstock.is_none());
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
                3 => SectionKind::Thread { pitch: a, starts: chords },
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
                bore in proptest::collection::vec(row(), 0..6),
                split in proptest::option::of(figure()),
                two in any::<bool>(),
                part_off in any::<bool>(),
                between in any::<bool>(),
                stock_bore_diameter in prop_oneof![Just(0.0), figure()],
                facing_allowance in prop_oneof![Just(0.0), figure()],
            ) -> TurnedPart {
                let mut part = TurnedPart { facing_allowance, stock_bore_diameter, bore, ..fixtures::part(length, rows) };
                (1..).zip(part.sections.iter_mut().chain(&mut part.bore)).for_each(|(id, row)| row.id = id);
                let holding = if between { Holding::BetweenCentres } else { Holding::Chuck };
                TurnedPart { part_off, holding, ends: if two { Ends::Two { split } } else { Ends::One }, ..part }
            }
        }

        fn assert_sound(setup: &Setup) {
            assert_chain(&setup.profile, setup);
            if let Some(bore) = &setup.bore {
                assert_chain(bore, setup);
            }
            let stock = &setup.stock;
            assert_that(stock.largest_gap() <= 1e-9, "stock connected", setup);
            let (first, last) = (stock.segments.first(), stock.segments.last());
            let closed = first.zip(last).is_none_or(|(a, b)| a.start().distance(b.end()) <= 1e-9);
            assert_that(closed && stock.polyline(0.01).iter().all(|p| p.is_finite()), "stock closed, finite", setup);
        }

        fn assert_chain(profile: &Profile, setup: &Setup) {
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
                    let areas = crate::turning::unreachable(&setup, &TOOLS, &fixtures::orac());
                    assert!(areas.iter().flat_map(|area| &area.outline).all(|p| p.is_finite()));
                }
            }
        }
    }
}
