//! Shells with something wrong: every figure set to what no figure can be, one after the other. It is said at its place with
//! value and limit, and nothing that is derived from it, drawn, sent or run breaks.

use std::sync::Arc;
use std::time::{Duration, Instant};
use turnwright::cancel::Cancel;
use turnwright::diagnostic::{Diagnostic, Place, Severity};
use turnwright::document::{Content, Document, FormerShape, Forming, Kind, Shell};
use turnwright::machine::Catalog;
use turnwright::output;
use turnwright::papers::{DrawingChoice, PaperKind};
use turnwright::part::{Section, SectionKind};
use turnwright::regen::{Cache, Derived, regenerate};
use turnwright::spinning::control::Phase;
use turnwright::spinning::operator::Job;
use turnwright::spinning::published::Arithmetic;
use turnwright::spinning::rig::{RigModel, SimulatedRig};
use turnwright::spinning::run::Run;
use turnwright::storage::{document_from_text, document_to_text, examples_of};

/// What is put into every figure.
const WRONG: [f64; 14] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    1e300,
    -1e300,
    1e-300,
    0.0,
    -0.0,
    -1.0,
    1e5,
    1e-9,
    89.999_999_999,
    90.0,
    11.0,
];

/// Longest time for one of them, in an unoptimised build on a busy machine.
const PATIENCE: Duration = Duration::from_secs(30);

/// A figure by the place that messages name, and how it is set.
type Figure = (&'static str, fn(&mut Shell, f64));

const FIGURES: [Figure; 17] = [
    ("former.base_length", |s, v| s.former.base_length = v),
    ("blank.thickness", |s, v| s.blank.thickness = v),
    ("blank.diameter", |s, v| s.blank.diameter = Some(v)),
    ("blank.follower_diameter", |s, v| s.blank.follower_diameter = v),
    ("blank.follower_length", |s, v| s.blank.follower_length = v),
    ("roller.nose_radius", |s, v| s.roller.nose_radius = v),
    ("roller.diameter", |s, v| s.roller.diameter = v),
    ("roller.width", |s, v| s.roller.width = v),
    ("roller.swivel_deg", |s, v| s.roller.swivel_deg = v),
    ("roller.flank_deg", |s, v| s.roller.flank_deg = v),
    ("speeds.surface_m_per_min", |s, v| s.speeds.surface_m_per_min = v),
    ("speeds.max_rpm", |s, v| s.speeds.max_rpm = v),
    ("speeds.feed_per_rev", |s, v| s.speeds.feed_per_rev = v),
    ("gap_tolerance", |s, v| s.gap_tolerance = v),
    ("rig.rpm", |s, v| s.rig.rpm = v),
    ("rig.feed_per_rev", |s, v| s.rig.feed_per_rev = v),
    ("rig.path_limit", |s, v| s.rig.path_limit = v),
];

fn example(name: &str) -> Document {
    let example = examples_of(Kind::Shell).find(|e| e.name == name).unwrap();
    document_from_text(name, example.text).unwrap()
}

fn changed(document: &Document, change: impl FnOnce(&mut Shell)) -> Document {
    let mut document = document.clone();
    let Content::Shell(shell) = &mut document.content else { unreachable!("a shell") };
    change(shell);
    document
}

/// A former of two rows with an arc and a parabola.
fn of_rows(document: &Document) -> Document {
    let row = |id, z1, d1, z2, d2, kind| Section { id, z1, d1, z2, d2, kind };
    let sections = vec![
        row(1, 0.0, 120.0, 20.0, 90.0, SectionKind::Convex { radius: 60.0 }),
        row(2, 20.0, 90.0, 40.0, 50.0, SectionKind::ParabolaAlongZ { z3: 20.0, d3: -90.0, chords: 10 }),
    ];
    changed(document, |shell| shell.former.shape = FormerShape::Sections { sections })
}

/// Makes everything that can be made of a document, and looks at what must hold of all of it.
struct Judge {
    catalog: Catalog,
    cache: Cache,
    longest: (Duration, String),
    count: u32,
    errors: u32,
}

impl Judge {
    fn new() -> Self {
        Self {
            catalog: Catalog::shipped(),
            cache: Cache::default(),
            longest: (Duration::ZERO, String::new()),
            count: 0,
            errors: 0,
        }
    }

    fn judge(&mut self, name: &str, document: Document) -> Derived {
        let begin = Instant::now();
        let made = regenerate(&Arc::new(document), &self.catalog, &mut self.cache, &Cancel::default()).unwrap();
        let wrong: Vec<&Diagnostic> = made.diagnostics.iter().filter(|d| d.severity == Severity::Error).collect();
        for said in &made.diagnostics {
            assert!(said.message.ends_with('.') && !said.message.contains("panic"), "{name}: {said:?}");
        }
        // Whatever is sent is proved, or it is said that it is not.
        if wrong.is_empty() {
            let shell = made.shell.as_ref().unwrap_or_else(|| panic!("{name}: nothing made and nothing said"));
            assert!(shell.proof.passed && !shell.programs.is_empty(), "{name}: {:?}", shell.proof.findings);
        }
        let files = output::files(&made);
        // The report quotes what is wrong.
        for file in files.iter().filter(|file| file.name != "report.json") {
            assert!(!file.text.contains("NaN") && !file.text.contains("inf,"), "{name}: {}", file.name);
        }
        for kind in [PaperKind::SetupSheet, PaperKind::Drawing(DrawingChoice::default())] {
            let _ = kind.pages(&made, &self.catalog);
        }
        Self::run(name, &made);
        self.count += 1;
        self.errors += u32::from(!wrong.is_empty());
        let took = begin.elapsed();
        if took > self.longest.0 {
            self.longest = (took, name.to_owned());
        }
        assert!(took < PATIENCE, "{name}: {took:?}");
        made
    }

    /// The rig, without regard to what was said: it ends, and never moves to where it cannot read.
    fn run(name: &str, made: &Derived) {
        let Some(shell) = made.shell.as_ref().filter(|s| !s.set_points.is_empty()) else { return };
        let model = RigModel::new(shell.shell.rig.rpm, shell.shell.rig.feed_per_rev);
        let plan = Job::Design.plan(&shell.set_points, Arithmetic::Exact, None);
        let mut run = Run::new(plan, SimulatedRig::new(model, Vec::new()));
        run.advance(5.0);
        run.emergency_stop();
        run.advance(30.0);
        let over = matches!(run.controller().phase(), Phase::Stopped { .. } | Phase::Completed);
        assert!(
            over && run.retreat_mm().is_finite() && !run.rig().lathe_is_on(),
            "{name}: {:?}",
            run.controller().phase()
        );
    }
}

fn is_at(said: &Diagnostic, path: &str) -> bool {
    matches!(&said.at, Place::Setting { path: at } if at == path || path.starts_with(&format!("{at}.")) || path.starts_with(&format!("{at}[")))
}

/// True if an error is told there, with a figure.
fn is_told(made: &Derived, path: &str) -> bool {
    let errors = made.diagnostics.iter().filter(|d| d.severity == Severity::Error);
    errors
        .filter(|d| is_at(d, path))
        .any(|d| d.message.contains(|c: char| c.is_ascii_digit()) || d.message.contains("NaN"))
}

#[test]
fn every_figure_set_to_what_none_can_be_is_told_at_its_place() {
    let mut judge = Judge::new();
    for name in ["CONE", "DISH", "PARABOLA"] {
        let document = example(name);
        for (path, set) in FIGURES {
            for value in WRONG {
                let made = judge.judge(&format!("{name} {path} = {value}"), changed(&document, |s| set(s, value)));
                if !(value.is_finite() && value.abs() <= 1e5) || value < 0.0 && path != "roller.swivel_deg" {
                    assert!(is_told(&made, path), "{name} {path} = {value}: {:?}", made.diagnostics);
                }
            }
        }
    }
    println!(
        "{} shells with a wrong figure, {} with an error told; the longest took {:?}: {}",
        judge.count, judge.errors, judge.longest.0, judge.longest.1
    );
}

#[test]
fn every_figure_of_a_contour_set_to_what_none_can_be_is_told_at_its_place() {
    let mut judge = Judge::new();
    let mut documents: Vec<Document> = ["CONE", "DISH", "PARABOLA"].map(example).into();
    documents.push(of_rows(&example("CONE")));
    let ellipse = FormerShape::Ellipse { semi_axis: 40.0, diameter: 120.0, tip_diameter: 50.0, length: 25.0 };
    documents.push(changed(&example("CONE"), |shell| shell.former.shape = ellipse));
    for document in documents {
        let Content::Shell(shell) = &document.content else { unreachable!("a shell") };
        for (index, (key, _)) in shell.former.shape.figures().into_iter().enumerate() {
            for value in WRONG {
                let set = |shell: &mut Shell| match &mut shell.former.shape {
                    FormerShape::Sections { sections } => *figure_of_row(sections, index) = value,
                    shape => shape.set(&key, value),
                };
                let name = format!("{} {key} = {value}", shell.former.shape.name());
                let made = judge.judge(&name, changed(&document, set));
                let path = format!("former.shape.{key}");
                if !(value.is_finite() && value.abs() <= 1e5) {
                    assert!(is_told(&made, &path), "{name}: {:?}", made.diagnostics);
                }
                let lengths = !matches!(shell.former.shape, FormerShape::Sections { .. });
                if lengths && value <= 0.0 {
                    assert!(is_told(&made, &path), "{name}: {:?}", made.diagnostics);
                }
            }
        }
    }
    println!(
        "{} contours, {} with an error told; the longest took {:?}: {}",
        judge.count, judge.errors, judge.longest.0, judge.longest.1
    );
}

/// The figure of the two rows of [`of_rows`] by its number.
fn figure_of_row(sections: &mut [Section], index: usize) -> &mut f64 {
    let [first, second] = sections else { panic!("two rows") };
    let (row, index) = if index < 5 { (first, index) } else { (second, index - 5) };
    match (index, &mut row.kind) {
        (0, _) => &mut row.z1,
        (1, _) => &mut row.d1,
        (2, _) => &mut row.z2,
        (3, _) => &mut row.d2,
        (_, SectionKind::Convex { radius }) => radius,
        (4, SectionKind::ParabolaAlongZ { z3, .. }) => z3,
        (_, SectionKind::ParabolaAlongZ { d3, .. }) => d3,
        other => panic!("{other:?}"),
    }
}

#[test]
fn counts_tables_and_names_that_are_none_are_told() {
    let mut judge = Judge::new();
    let cone = example("CONE");
    let mut told = |what: &str, code: &str, change: fn(&mut Shell)| {
        let made = judge.judge(what, changed(&cone, change));
        let found = made.diagnostics.iter().find(|d| d.code == code);
        assert!(found.is_some(), "{what}: no {code} in {:?}", made.diagnostics);
    };
    for set in [|s: &mut Shell| s.passes = 0, |s: &mut Shell| s.passes = u32::MAX] {
        told("passes", "passes", set);
    }
    for set in [|s: &mut Shell| s.rig.increment_pulses = 0, |s: &mut Shell| s.rig.increment_pulses = u32::MAX] {
        told("increment", "rig", set);
    }
    for set in [|s: &mut Shell| s.roller.station = 0, |s: &mut Shell| s.roller.station = u32::MAX] {
        told("station", "roller", set);
    }
    told("empty table", "former-impossible", |s| s.former.shape = FormerShape::Sections { sections: Vec::new() });
    told("thread", "former-impossible", |s| {
        let kind = SectionKind::Thread { pitch: 1.0, starts: 1 };
        let sections = vec![Section { kind, ..Section::line(1, 0.0, 90.0, 30.0, 60.0) }];
        s.former.shape = FormerShape::Sections { sections };
    });
    told("machine", "unknown-machine", |s| s.machine = "lathe of nobody".to_owned());
    told("material", "shell-material", |s| s.material = "\u{0}cheese\n%".to_owned());
    // A former as narrow as it can be said to be, and walls at and beyond both limits.
    for (angle, code) in [(11.9, "half-angle-small"), (7.9, "half-angle-small"), (80.1, "half-angle-large")] {
        for (passes, forming) in [(1, Forming::Shear), (2, Forming::Shear)] {
            let made = judge.judge(
                &format!("{angle}° in {passes}"),
                changed(&cone, |s| {
                    let shape = FormerShape::Cone { half_angle_deg: angle, tip_diameter: 40.0, length: 20.0 };
                    (s.former.shape, s.passes, s.forming) = (shape, passes, forming);
                }),
            );
            let is_told = made.diagnostics.iter().any(|d| d.code == code);
            // Two passes reach 8°; what stops a wall of 11.9° then is the material.
            assert_eq!(is_told, (angle, passes) != (11.9, 2), "{angle} {passes}: {:?}", made.diagnostics);
        }
    }
}

#[test]
fn a_table_as_long_as_a_document_may_have_is_formed_in_time_and_a_longer_one_refused() {
    let stairs = |rows: u32| {
        let row = |k: u32| {
            let at = |k: u32| (f64::from(k) * 40.0 / f64::from(rows), 140.0 - f64::from(k) * 80.0 / f64::from(rows));
            let ((z1, d1), (z2, d2)) = (at(k), at(k + 1));
            Section::line(k + 1, z1, d1, z2, d2)
        };
        FormerShape::Sections { sections: (0..rows).map(row).collect() }
    };
    let mut judge = Judge::new();
    judge.judge("1000 rows", changed(&example("CONE"), |s| s.former.shape = stairs(1000)));
    println!("1000 rows: {:?}", judge.longest.0);
    let long = changed(&example("CONE"), |s| s.former.shape = stairs(10_001));
    let refused = document_to_text(&long).map_err(|e| e.to_string());
    assert!(refused.as_ref().is_err_and(|e| e.contains("10001") && e.contains("10000")), "{refused:?}");
}
