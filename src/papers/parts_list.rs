//! The parts list of a set of form-rolls: every roll with blank, mass, time and cost.

use super::page::Page;
use super::setup_sheet::writer::{Cell, LINE_MM, Writer, cell, figure};
use crate::diagnostic::{Diagnostic, Place};
use crate::geometry::Contour;
use crate::machine::Material;
use crate::regen::{Derived, RollDerived};
use crate::rollform::Roll;
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// Chords of a roll's contour for its volume, mm.
const CHORD_MM: f64 = 0.01;

/// A roll in the parts list. Lengths in mm, masses in kg.
#[derive(Debug, Clone, PartialEq)]
pub struct RollLine {
    /// Its name: `1470b-2T`.
    pub name: String,
    /// Number of its station.
    pub station: usize,
    /// Top, bottom, left or right roll.
    pub kind: &'static str,
    /// Material.
    pub material: String,
    /// Diameter of the blank.
    pub blank_diameter_mm: f64,
    /// Width of the roll.
    pub width_mm: f64,
    /// Largest diameter.
    pub largest_diameter_mm: f64,
    /// Diameter of the bore.
    pub bore_mm: f64,
    /// Mass of the blank with its bore; absent without a density.
    pub blank_kg: Option<f64>,
    /// Mass of the finished roll.
    pub roll_kg: Option<f64>,
    /// Machining time, s; absent without a proof of the roll as it is designed.
    pub time_s: Option<f64>,
    /// Cost of the blank; absent without density or price.
    pub blank_cost: Option<f64>,
    /// Cost of machine and operator for the machining time; absent without rates or time.
    pub machining_cost: Option<f64>,
    /// Currency of the cost.
    pub currency: String,
    /// True if its programs passed their proofs.
    pub proved: bool,
}

impl RollLine {
    /// Cost of machining and, as far as it is known, of the blank; setting up is not in it.
    #[must_use]
    pub fn cost(&self) -> Option<f64> {
        Some(self.machining_cost? + self.blank_cost.unwrap_or(0.0))
    }
}

/// Prices: those of the set, else those of its machine and of the material of every roll.
struct Prices<'a> {
    per_hour: Option<f64>,
    /// What the set says, for rolls of its material.
    per_kg: Option<f64>,
    set_material: String,
    currency: String,
    /// Materials of rolls that are known, by their names as the rolls say them.
    materials: BTreeMap<&'a str, &'a Material>,
}

impl<'a> Prices<'a> {
    fn of(derived: &'a Derived) -> Self {
        let set = derived.document.content.roll_set();
        let own = set.map(|set| set.rates.clone()).unwrap_or_default();
        let machine = derived.machine.as_ref().and_then(|machine| machine.cost.clone());
        Self {
            per_hour: own.machine_per_hour.or(machine.as_ref().map(|cost| cost.machine_per_hour)),
            per_kg: own.price_per_kg,
            set_material: set.map(|set| set.material.clone()).unwrap_or_default(),
            currency: own.currency.or(machine.map(|cost| cost.currency)).unwrap_or_default(),
            materials: materials(derived),
        }
    }

    /// Price of a kilogram of a material.
    fn per_kg(&self, material: &str) -> Option<f64> {
        let of_set = self.per_kg.filter(|_| material.eq_ignore_ascii_case(&self.set_material));
        of_set.or_else(|| self.materials.get(material)?.price_per_kg)
    }

    fn kg_per_dm3(&self, material: &str) -> Option<f64> {
        self.materials.get(material)?.density_kg_per_dm3
    }
}

/// The materials of the rolls that were looked up when their programs were made.
fn materials(derived: &Derived) -> BTreeMap<&str, &Material> {
    let rolls = derived.rolls.iter().flat_map(|set| &set.rolls);
    let known = rolls.filter_map(|roll| {
        let name = roll.derived.document.content.turned_part()?.material.as_str();
        let material = roll.derived.material.as_ref()?;
        // Of an unknown name another material was taken, whose price and density say nothing.
        material.name.eq_ignore_ascii_case(name).then_some((name, material))
    });
    known.collect()
}

/// The rolls of a set, station by station; none of another document.
#[must_use]
pub fn roll_lines(derived: &Derived) -> Vec<RollLine> {
    let Some(set) = &derived.rolls else { return Vec::new() };
    let prices = Prices::of(derived);
    let stations = set.design.stations.iter();
    let rolls = stations.flat_map(|station| station.rolls.iter().map(move |roll| (station.number, roll)));
    rolls.map(|(number, roll)| line(number, roll, set.of_roll(roll.roll), &prices)).collect()
}

fn line(station: usize, roll: &Roll, made: Option<&RollDerived>, prices: &Prices<'_>) -> RollLine {
    let part = &roll.part;
    let made = made.filter(|made| made.current);
    let setups = made.map(|made| made.derived.setups.as_slice()).unwrap_or_default();
    let bounds = roll.contour().bounds();
    let density = prices.kg_per_dm3(&part.material);
    let mass = |volume_mm3: f64| density.map(|d| volume_mm3 * 1e-6 * d);
    let ring = |radius: f64| PI * (radius * radius - (part.stock_bore_diameter / 2.0).powi(2)) * part.length;
    let time_s = (!setups.is_empty()).then(|| setups.iter().map(|s| s.proof.times.total_s).sum::<f64>());
    let blank_kg = mass(ring(part.bar_diameter / 2.0));
    RollLine {
        name: roll.name.clone(),
        station,
        kind: roll.roll.kind.name(),
        material: part.material.clone(),
        blank_diameter_mm: part.bar_diameter,
        width_mm: part.length,
        largest_diameter_mm: bounds.map_or(0.0, |b| 2.0 * b.max.r),
        bore_mm: part.stock_bore_diameter,
        blank_kg,
        roll_kg: mass(volume_mm3(&roll.contour()) - ring(0.0).abs()),
        time_s,
        blank_cost: blank_kg.zip(prices.per_kg(&part.material)).map(|(kg, price)| kg * price),
        machining_cost: time_s.zip(prices.per_hour).map(|(s, per_hour)| s / 3600.0 * per_hour),
        currency: prices.currency.clone(),
        proved: made.is_some_and(RollDerived::is_proved),
    }
}

/// Volume that a contour from face to face sweeps around the axis, mm³: cones between its points.
fn volume_mm3(contour: &Contour) -> f64 {
    let points = contour.polyline(CHORD_MM);
    let pairs = points.iter().zip(points.iter().skip(1));
    let cones: f64 = pairs.map(|(a, b)| (a.r * a.r + a.r * b.r + b.r * b.r) / 3.0 * (b.z - a.z)).sum();
    PI * cones
}

/// The parts list as a table for a spreadsheet: comma-separated, full stop as the decimal mark, a first line of names.
#[must_use]
pub fn parts_list_csv(lines: &[RollLine]) -> String {
    let head = "roll,station,kind,material,blank diameter mm,width mm,largest diameter mm,bore mm,blank kg,roll kg,time min,\
                blank cost,machining cost,cost,currency,proved\n";
    let optional = |value: Option<f64>, decimals: usize| value.map_or_else(String::new, |v| format!("{v:.decimals$}"));
    let rows = lines.iter().map(|l| {
        format!(
            "{},{},{},{},{:.3},{:.3},{:.3},{:.3},{},{},{},{},{},{},{},{}\n",
            quoted(&l.name),
            l.station,
            l.kind,
            quoted(&l.material),
            l.blank_diameter_mm,
            l.width_mm,
            l.largest_diameter_mm,
            l.bore_mm,
            optional(l.blank_kg, 3),
            optional(l.roll_kg, 3),
            optional(l.time_s.map(|s| s / 60.0), 2),
            optional(l.blank_cost, 2),
            optional(l.machining_cost, 2),
            optional(l.cost(), 2),
            quoted(&l.currency),
            if l.proved { "yes" } else { "no" }
        )
    });
    head.to_owned() + &rows.collect::<String>()
}

/// A text as a cell: in quotation marks where it holds a comma, a mark or a line end.
fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}

/// Columns of the printed list: name, left border and width in mm.
const COLUMNS: [(&str, f64, f64); 10] = [
    ("roll", 20.0, 28.0),
    ("kind", 49.0, 18.0),
    ("material", 68.0, 19.0),
    ("blank ⌀", 88.0, 14.0),
    ("width", 103.0, 15.0),
    ("bore ⌀", 119.0, 12.0),
    ("kg", 132.0, 13.0),
    ("min", 146.0, 13.0),
    ("cost", 160.0, 14.0),
    ("state", 177.0, 16.0),
];

/// The pages of the parts list.
///
/// # Errors
/// A diagnostic if the document is no set of form-rolls with rolls.
pub fn parts_list(derived: &Derived) -> Result<Vec<Page>, Diagnostic> {
    let lines = roll_lines(derived);
    if lines.is_empty() {
        let message = "There are no rolls that a parts list could name.";
        let fault = Diagnostic::error("nothing-to-list", Place::Document, message);
        return Err(fault.with_hint("Open a set of form-rolls; see what is said about its stations."));
    }
    let mut writer = Writer::titled(format!("Parts list {}", derived.document.name));
    writer.heading(&format!("Form-rolls {}", derived.document.name), 5.0 * LINE_MM);
    let currency = lines.first().map(|l| l.currency.as_str()).filter(|c| !c.is_empty());
    if let Some(currency) = currency {
        writer.row(&[cell(COLUMNS[0].1, 150.0, format!("cost in {currency}, without setting up"))]);
    }
    writer.row(&COLUMNS.map(|(name, z, width)| Cell { ink: super::Ink::Grey, ..column(z, width, name) }));
    writer.rule();
    for line in &lines {
        writer.row(&cells(line));
    }
    writer.rule();
    writer.row(&totals(&lines));
    Ok(writer.done())
}

/// Texts stand left in the first three columns and the last one, figures right.
fn column<'a>(z: f64, width: f64, text: impl Into<std::borrow::Cow<'a, str>>) -> Cell<'a> {
    /// First border of a column of figures and of what follows them, mm.
    const FIGURES: (f64, f64) = (87.5, 176.5);
    if z > FIGURES.0 && z < FIGURES.1 { figure(z, width, text) } else { cell(z, width, text) }
}

fn cells(line: &RollLine) -> [Cell<'static>; 10] {
    let optional =
        |value: Option<f64>, decimals: usize| value.map_or_else(|| "–".to_owned(), |v| format!("{v:.decimals$}"));
    let texts = [
        line.name.clone(),
        line.kind.to_owned(),
        line.material.clone(),
        format!("{:.1}", line.blank_diameter_mm),
        format!("{:.3}", line.width_mm),
        format!("{:.1}", line.bore_mm),
        optional(line.roll_kg, 2),
        optional(line.time_s.map(|s| s / 60.0), 1),
        optional(line.cost(), 2),
        if line.proved { "proved" } else { "not proved" }.to_owned(),
    ];
    placed(texts)
}

fn totals(lines: &[RollLine]) -> [Cell<'static>; 10] {
    let proved = lines.iter().filter(|l| l.proved).count();
    let none = String::new;
    placed([
        format!("{} rolls", lines.len()),
        none(),
        none(),
        none(),
        none(),
        none(),
        total(lines.iter().map(|l| l.roll_kg), 1.0, 2),
        total(lines.iter().map(|l| l.time_s), 60.0, 1),
        total(lines.iter().map(RollLine::cost), 1.0, 2),
        format!("{proved} proved"),
    ])
}

/// A sum in units of `per`; a dash where nothing is known, a plus sign behind it where not all is.
fn total(values: impl Iterator<Item = Option<f64>>, per: f64, decimals: usize) -> String {
    let values: Vec<Option<f64>> = values.collect();
    let known: Vec<f64> = values.iter().copied().flatten().collect();
    if known.is_empty() {
        return "–".to_owned();
    }
    let more = if known.len() < values.len() { "+" } else { "" };
    format!("{:.decimals$}{more}", known.iter().sum::<f64>() / per)
}

fn placed(texts: [String; 10]) -> [Cell<'static>; 10] {
    let mut columns = COLUMNS.iter();
    texts.map(|text| {
        let (_, z, width) = columns.next().copied().unwrap_or_default();
        column(z, width, text)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Point;

    #[test]
    fn a_plain_roll_has_the_volume_of_its_cylinder() {
        let corners = [(0.0, 0.0), (0.0, 50.0), (20.0, 50.0), (20.0, 0.0)].map(|(z, r)| Point::new(z, r));
        let pairs = corners.iter().zip(corners.iter().skip(1));
        let contour = Contour::new(pairs.map(|(&a, &b)| crate::geometry::Segment::line(a, b)).collect());
        assert!((volume_mm3(&contour) - PI * 2500.0 * 20.0).abs() < 1e-6);
    }

    #[test]
    fn what_is_not_known_is_not_added_up() {
        assert_eq!(total([None, None].into_iter(), 1.0, 2), "–");
        assert_eq!(total([Some(60.0), Some(30.0)].into_iter(), 60.0, 1), "1.5");
        assert_eq!(total([Some(1.0), None].into_iter(), 1.0, 2), "1.00+");
    }

    #[test]
    fn cells_with_commas_are_quoted() {
        assert_eq!(quoted("a,b"), "\"a,b\"");
        assert_eq!(quoted("say \"x\""), "\"say \"\"x\"\"\"");
        assert_eq!(quoted("plain"), "plain");
    }
}
