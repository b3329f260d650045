//! Judges what a move did to stock, part and jaws.

use super::cut::grid::{edges, from_grid};
use super::cut::{CONTACT_AREA_MM2, Contact, Cut, Cutting, Holding, Stock, StockHistory};
use super::findings::{Breach, Findings, Place};
use super::form::{Depth, Form};
use super::input::{ProofInput, Work};
use super::record::{Played, Record};
use super::report::{FindingKind, Leftover, Motion};
use super::{leftover, power};
use crate::geometry::Point;
use crate::machine::Machine;

/// A gouge up to this depth, mm, is not worth a word: chords and rounding explain it.
const NOTED_GOUGE_MM: f64 = 0.002;

/// The stock being cut and what must come out of it.
pub(super) struct Judge<'a> {
    work: &'a Work,
    machine: &'a Machine,
    cutting: Cutting<'a>,
    form: Form,
    deepest: f64,
    /// Deepest gouge within the tolerance in the present program.
    slight: Option<(Place, Depth)>,
}

impl<'a> Judge<'a> {
    /// The work before the first program; `None` without any.
    pub(super) fn new(input: &'a ProofInput) -> Option<Self> {
        let work = input.work.as_ref()?;
        let cutting = Cutting::new(work, &input.tools, &input.machine.chuck);
        Some(Self { work, machine: &input.machine, cutting, form: Form::new(work), deepest: 0.0, slight: None })
    }

    /// The stock as it is.
    fn stock(&self) -> &Stock {
        self.cutting.stock()
    }

    /// The stock after every move that has cut.
    pub(super) fn into_history(self) -> StockHistory {
        self.cutting.into_history()
    }

    /// Deepest gouge so far, mm.
    pub(super) fn deepest_gouge_mm(&self) -> f64 {
        self.deepest
    }

    /// Cuts along a move and judges it.
    pub(super) fn moved(&mut self, place: Place, played: &Played, record: &mut Record, findings: &mut Findings) {
        let cut = self.cutting.travel(&played.path, played.tool);
        let length = played.path.length();
        let chip =
            if length > 0.0 && played.rpm > 0.0 { cut.taken_mm2 / length * played.feed / played.rpm } else { 0.0 };
        if let Some(material) = &self.work.material {
            power::check(material, self.machine, played, chip, place, findings);
        }
        self.judge(place, &cut, played, chip, record, findings);
    }

    /// Cuts the grooves of a thread, whose passes take equal shares of them.
    pub(super) fn threaded(
        &mut self,
        place: Place,
        played: &Played,
        pitch: f64,
        passes: u32,
        record: &mut Record,
        findings: &mut Findings,
    ) {
        let (near, far) = (played.path.start(), played.path.end());
        let (cut, grooves) = self.cutting.thread(near, far, pitch, played.tool);
        let chip = cut.taken_mm2 / f64::from(grooves) / f64::from(passes);
        self.judge(place, &cut, played, chip, record, findings);
    }

    fn judge(
        &mut self,
        place: Place,
        cut: &Cut,
        played: &Played,
        chip: f64,
        record: &mut Record,
        findings: &mut Findings,
    ) {
        collisions(cut, place, findings);
        if cut.taken.is_empty() {
            return;
        }
        if must_not_cut(played)
            && let Some(contact) = cut.contact()
        {
            contact_findings(contact, played, place, findings);
        }
        self.gouge(cut, place, findings);
        if let Some(block) = record.block(place.block) {
            block.removed_mm2 += cut.taken_mm2;
            block.chip_mm2 = block.chip_mm2.max(chip);
        }
        record.stock_after = self.cutting.passes();
    }

    fn gouge(&mut self, cut: &Cut, place: Place, findings: &mut Findings) {
        let borders = cut.taken.iter().flat_map(|ring| edges(ring)).map(|(a, b)| (from_grid(a), from_grid(b)));
        let Some(depth) = self.form.deepest(borders) else { return };
        self.deepest = self.deepest.max(depth.mm);
        let limit = self.work.form_tolerance_mm;
        if depth.mm > limit {
            let message = format!(
                "The tool cuts {:.3} mm below the contour at {}; {limit:.3} mm is allowed.",
                depth.mm,
                self.shown(depth.at)
            );
            findings.add(place, Breach::error("gouge", FindingKind::Gouge, depth.mm, limit, message).at(depth.at));
        } else if depth.mm > NOTED_GOUGE_MM && self.slight.is_none_or(|(_, known)| depth.mm > known.mm) {
            self.slight = Some((place, depth));
        }
    }

    /// Position for people: z of the part as in the plots, z as the program counts it, and diameter.
    fn shown(&self, p: Point) -> String {
        let Point { z, r } = p;
        format!("z {z:.3} (program z {:.3}), ⌀ {:.3}", z - self.work.program_zero_z, 2.0 * r)
    }

    /// Notes the deepest of the slight gouges of a program that has ended.
    pub(super) fn end_program(&mut self, findings: &mut Findings) {
        let Some((place, depth)) = self.slight.take() else { return };
        let limit = self.work.form_tolerance_mm;
        let message = format!(
            "The deepest cut below the contour within the tolerance is {:.3} mm at {}; {limit:.3} mm is allowed.",
            depth.mm,
            self.shown(depth.at)
        );
        let breach = Breach::error("slight gouge", FindingKind::Gouge, depth.mm, limit, message).at(depth.at);
        findings.add(place, breach.into_info());
    }

    /// Measures what is left and warns of every section that is not finished.
    pub(super) fn leftover(&self, last: Place, findings: &mut Findings) -> Vec<Leftover> {
        let left = leftover::measure(self.work, self.stock());
        let limit = self.work.form_tolerance_mm;
        for l in left.iter().filter(|l| l.largest_mm > limit) {
            let message = format!(
                "{:.3} mm are left{} at {}, {:.3} mm in the mean; {limit:.3} mm is allowed.",
                l.largest_mm,
                self.work.target.names.get(&l.section).map(|name| format!(" on {name}")).unwrap_or_default(),
                self.shown(l.at),
                l.mean_mm
            );
            let breach = Breach::error("leftover", FindingKind::Leftover, l.largest_mm, limit, message);
            findings.add_each(last, breach.into_warning().at(l.at));
        }
        left
    }
}

fn collisions(cut: &Cut, place: Place, findings: &mut Findings) {
    let mut hit = |contact: Option<Contact>, rule, kind, what: &str| {
        let Some(Contact { area_mm2, at, .. }) = contact else { return };
        let message = format!("{what}: {area_mm2:.3} mm² overlap; {CONTACT_AREA_MM2} mm² is the limit.");
        findings.add(place, Breach::error(rule, kind, area_mm2, CONTACT_AREA_MM2, message).at(at));
    };
    hit(cut.flank, "flank", FindingKind::FlankCollision, "A side of the insert that cannot cut runs into the stock");
    hit(cut.holder, "holder", FindingKind::HolderCollision, "The tool holder runs into the stock");
    for &(holding, contact) in &cut.holding {
        let (rule, kind, what) = match holding {
            Holding::Chuck => ("chuck", FindingKind::ChuckCollision, "The tool runs into the chuck"),
            Holding::Mandrel => {
                ("mandrel", FindingKind::ChuckCollision, "The tool runs into the mandrel that drives the work")
            }
            Holding::Tailstock => ("tailstock", FindingKind::TailstockCollision, "The tool runs into the tailstock"),
        };
        hit(Some(contact), rule, kind, what);
    }
}

/// True if stock must not be touched: at the rapid feed, while the turret turns, or with the spindle at rest.
fn must_not_cut(played: &Played) -> bool {
    matches!(played.motion, Motion::Rapid | Motion::Pause) || played.rpm <= 0.0
}

fn contact_findings(contact: Contact, played: &Played, place: Place, findings: &mut Findings) {
    let Contact { area_mm2, thickness_mm, at } = contact;
    if matches!(played.motion, Motion::Rapid | Motion::Pause) {
        let how = if played.motion == Motion::Pause {
            "while the turret turns".to_owned()
        } else {
            format!("at the rapid feed of {:.0} mm/min", played.feed)
        };
        let message = format!(
            "The insert goes through {area_mm2:.3} mm² of stock, {thickness_mm:.3} mm thick, {how}; {CONTACT_AREA_MM2} mm² is the limit."
        );
        let breach = Breach::error("rapid", FindingKind::RapidContact, area_mm2, CONTACT_AREA_MM2, message).at(at);
        findings.add(place, breach);
    }
    if played.rpm <= 0.0 {
        let message = format!("The tool cuts {area_mm2:.3} mm² of stock with the spindle at rest (0 rev/min).");
        findings.add(place, Breach::error("at rest", FindingKind::OutsideLimits, played.rpm, 1.0, message).at(at));
    }
}
