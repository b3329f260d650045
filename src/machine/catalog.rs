//! The shipped machines, tools and materials, and the user's own.

use super::check::Fault;
use super::file::{self, Item, Source};
use super::{Catalog, Machine, Material, Tool};
use crate::diagnostic::Diagnostic;
use crate::textfile::{self, file_place};
use crate::units::Unit;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Longest machine, tool or material file that is read, bytes.
pub(super) const MOST_BYTES: u64 = 1 << 20;

/// Sources of shipped files: names and texts.
macro_rules! shipped {
    ($($name:literal),+) => { &[$(Source { name: $name, text: include_str!(concat!("../../assets/", $name)) }),+] };
}

const MACHINES: &[Source<'static>] = shipped!(
    "machines/orac.toml",
    "machines/mori-fanuc-6t.toml",
    "machines/fanuc-0i.toml",
    "machines/linuxcnc.toml",
    "machines/swedish-1970s.toml"
);
const TOOLS: &[Source<'static>] = shipped!("tools/orac.toml", "tools/mori-fanuc-6t.toml", "tools/turning.toml");
const MATERIALS: &[Source<'static>] = shipped!("materials/oracap.toml", "materials/general.toml");

impl Catalog {
    /// What comes with the program. The files are part of it; a test proves that they are without fault.
    #[must_use]
    pub fn shipped() -> Self {
        Self::shipped_with_diagnostics().0
    }

    fn shipped_with_diagnostics() -> (Self, Vec<Diagnostic>) {
        let mut catalog = Self::default();
        let mut diagnostics = Vec::new();
        catalog.add(TOOLS, MATERIALS, MACHINES, &mut diagnostics);
        (catalog, diagnostics)
    }

    /// What comes with the program, and the `.toml` files in the folders `machines`, `tools` and `materials` of
    /// `user_dir`: their entries add to the shipped ones or replace those with the same id (materials: name and unit).
    ///
    /// Files are read in the order of their names. An entry with a mistake is left out (a file that is not TOML as a
    /// whole) and a diagnostic names file, line, value and limit; all other entries are there. A missing folder is no
    /// mistake.
    #[must_use]
    pub fn load(user_dir: Option<&Path>) -> (Self, Vec<Diagnostic>) {
        let (mut catalog, mut diagnostics) = Self::shipped_with_diagnostics();
        if let Some(dir) = user_dir {
            let [tools, materials, machines] =
                ["tools", "materials", "machines"].map(|folder| read_folder(&dir.join(folder), &mut diagnostics));
            catalog.add(&sources(&tools), &sources(&materials), &sources(&machines), &mut diagnostics);
        }
        (catalog, diagnostics)
    }

    /// The machine with this id.
    #[must_use]
    pub fn machine(&self, id: &str) -> Option<&Machine> {
        self.machines.iter().find(|m| m.id == id)
    }

    /// The tool with this id.
    #[must_use]
    pub fn tool(&self, id: &str) -> Option<&Tool> {
        self.tools.iter().find(|t| t.id == id)
    }

    /// The material of this name, without regard to case: the row in `unit`, or else the row in the other unit.
    #[must_use]
    pub fn material(&self, name: &str, unit: Unit) -> Option<&Material> {
        let mut rows = self.materials.iter().filter(|m| same_name(&m.name, name));
        rows.clone().find(|m| m.unit == unit).or_else(|| rows.next())
    }

    /// Adds what the files hold; tools first, because machines name them.
    fn add(
        &mut self,
        tools: &[Source<'_>],
        materials: &[Source<'_>],
        machines: &[Source<'_>],
        diagnostics: &mut Vec<Diagnostic>,
    ) {
        for &source in tools {
            let items = file::tools(source, diagnostics);
            place_all(source, &mut self.tools, items, diagnostics);
        }
        let mut likes = Vec::new();
        for &source in materials {
            let items = file::materials(source, diagnostics);
            likes.extend(items.iter().filter(|item| item.value.like.is_some()).map(|item| (source, item.clone())));
            place_all(source, &mut self.materials, items, diagnostics);
        }
        self.follow_likes(&likes, diagnostics);
        for &source in machines {
            let mut items = file::machines(source, diagnostics);
            items.retain(|item| self.knows_tools(source, item, diagnostics));
            place_all(source, &mut self.machines, items, diagnostics);
        }
    }

    /// Fills in what materials take from others. One that names a material which is not there has only what it gives itself.
    fn follow_likes(&mut self, likes: &[(Source<'_>, Item<Material>)], diagnostics: &mut Vec<Diagnostic>) {
        for (source, item) in likes {
            let name = item.value.like.as_deref().unwrap_or_default();
            let Some(other) = self.materials.iter().find(|m| same_name(&m.name, name) && m.like.is_none()).cloned()
            else {
                let message = format!("There is no material \"{name}\" with cutting data of its own to be like.");
                diagnostics.push(source.fault(item, &Fault { path: "like".to_owned(), message }));
                continue;
            };
            let key = item.value.key();
            if let Some(material) = self.materials.iter_mut().find(|m| m.key() == key) {
                material.fill_from(&other);
            }
        }
    }

    /// False, with a diagnostic for each, if the machine names tools that are not there.
    fn knows_tools(&self, source: Source<'_>, item: &Item<Machine>, diagnostics: &mut Vec<Diagnostic>) -> bool {
        let before = diagnostics.len();
        for (i, tool) in item.value.tools.iter().enumerate().filter(|(_, t)| self.tool(&t.tool).is_none()) {
            let known: Vec<&str> = self.tools.iter().map(|t| t.id.as_str()).collect();
            let message = format!("There is no tool \"{}\"; the tools are {}.", tool.tool, known.join(", "));
            diagnostics.push(source.fault(item, &Fault { path: format!("tools.{i}.tool"), message }));
        }
        diagnostics.len() == before
    }
}

fn same_name(a: &str, b: &str) -> bool {
    a.to_lowercase() == b.to_lowercase()
}

/// What tells entries of one table apart.
trait Entry {
    /// Field that a message about the key points to.
    const FIELD: &'static str;
    /// Equal keys mean the same entry.
    fn key(&self) -> String;
}

impl Entry for Machine {
    const FIELD: &'static str = "id";
    fn key(&self) -> String {
        self.id.clone()
    }
}

impl Entry for Tool {
    const FIELD: &'static str = "id";
    fn key(&self) -> String {
        self.id.clone()
    }
}

impl Entry for Material {
    const FIELD: &'static str = "name";
    fn key(&self) -> String {
        format!("{} in {}", self.name.to_lowercase(), self.unit.symbol())
    }
}

/// Puts the items of one file into `list`, each in place of the one with its key; two with one key in a file is a mistake.
fn place_all<T: Entry>(source: Source<'_>, list: &mut Vec<T>, items: Vec<Item<T>>, diagnostics: &mut Vec<Diagnostic>) {
    let mut seen = BTreeSet::new();
    for item in items {
        let key = item.value.key();
        if !seen.insert(key.clone()) {
            let message = format!("\"{key}\" is in the file twice; it must be there once. The first one counts.");
            diagnostics.push(source.fault(&item, &Fault { path: T::FIELD.to_owned(), message }));
            continue;
        }
        match list.iter_mut().find(|old| old.key() == key) {
            Some(old) => *old = item.value,
            None => list.push(item.value),
        }
    }
}

/// Names and texts of the `.toml` files of a folder, in the order of their names.
fn read_folder(folder: &Path, diagnostics: &mut Vec<Diagnostic>) -> Vec<(String, String)> {
    let mut paths: Vec<PathBuf> = match std::fs::read_dir(folder) {
        Ok(entries) => entries.filter_map(|e| Some(e.ok()?.path())).collect(),
        Err(e) if e.kind() == std::io::ErrorKind::NotFound => return Vec::new(),
        Err(e) => {
            let message = format!("The folder cannot be read: {e}.");
            diagnostics.push(Diagnostic::error("folder-unreadable", file_place(folder), message));
            return Vec::new();
        }
    };
    paths.retain(|path| path.extension().is_some_and(|e| e.eq_ignore_ascii_case("toml")));
    paths.sort();
    let mut files = Vec::new();
    for path in paths {
        match textfile::read(&path, MOST_BYTES) {
            Ok(text) => files.push((path.display().to_string(), text)),
            Err(diagnostic) => diagnostics.push(diagnostic),
        }
    }
    files
}

fn sources(files: &[(String, String)]) -> Vec<Source<'_>> {
    files.iter().map(|(name, text)| Source { name, text }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::Place;
    use crate::machine::{Delivery, Dialect, FlowControl, PageMarks, Parity, Protocol, SpeedRule};

    fn user_dir(files: &[(&str, &str)]) -> tempfile::TempDir {
        let dir = tempfile::tempdir().unwrap();
        for (name, text) in files {
            let path = dir.path().join(name);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, text).unwrap();
        }
        dir
    }

    fn load(files: &[(&str, &str)]) -> (Catalog, Vec<Diagnostic>) {
        Catalog::load(Some(user_dir(files).path()))
    }

    fn orac_with(from: &str, to: &str) -> String {
        assert!(MACHINES[0].text.contains(from), "{from}");
        MACHINES[0].text.replace(from, to)
    }

    #[test]
    fn shipped_files_are_without_fault() {
        let (catalog, diagnostics) = Catalog::shipped_with_diagnostics();
        assert_eq!(diagnostics, []);
        assert_eq!((catalog.machines.len(), catalog.tools.len(), catalog.materials.len()), (5, 38, 21));
        assert_eq!(Catalog::load(None), (catalog.clone(), Vec::new()));
        assert_eq!(load(&[]), (catalog, Vec::new()));
    }

    #[test]
    fn orac_has_the_published_figures() {
        let catalog = Catalog::shipped();
        let orac = catalog.machine("orac").unwrap();
        assert_eq!(orac.dialect, Dialect::Orac);
        assert_eq!((orac.limits.bar_diameter_mm, orac.limits.blocks_per_program), (40.0, 99));
        assert_eq!(orac.spindle.speed, SpeedRule::Radius { at_center_rpm: 2000.0, per_mm_radius_rpm: 60.0 });
        let Delivery::Line(serial) = &orac.serial else { panic!("no line") };
        assert_eq!((serial.baud, serial.data_bits, serial.parity, serial.stop_bits), (2400, 7, Parity::Odd, 1));
        assert_eq!(serial.flow, FlowControl::None);
        assert_eq!(serial.protocol, Protocol::OracPages(PageMarks { page_start: 2, end: 4 }));
    }

    #[test]
    fn materials_are_found_without_regard_to_case_and_by_unit_first() {
        let catalog = Catalog::shipped();
        assert_eq!(catalog.material("Aluminum", Unit::Mm).unwrap().orac.unwrap().feed_cut, 80.0);
        assert_eq!(catalog.material("aluminum", Unit::Inch).unwrap().orac.unwrap().feed_cut, 3.0);
        assert_eq!(catalog.material("steel", Unit::Inch).unwrap().unit, Unit::Mm);
        assert!(catalog.material("cheese", Unit::Mm).is_none());
    }

    #[test]
    fn a_user_file_adds_and_replaces() {
        let brass = "[[material]]\nname='BRASS'\n[material.orac]\nfeed_travel=1000\nfeed_cut=120\nfeed_part_off=8\n\
                     depth_rough=1\ndepth_finish=0.1\ndepth_thread=0.05\n";
        let steel = brass.replace("BRASS", "Steel");
        let small = orac_with("bar_diameter_mm = 40", "bar_diameter_mm = 20");
        let second = orac_with("id = \"orac\"", "id = \"second\"");
        let (catalog, diagnostics) = load(&[
            ("materials/a.toml", &format!("{brass}{steel}")),
            ("machines/a.toml", &small),
            ("machines/b.toml", &second),
            ("machines/notes.txt", "not read"),
        ]);
        assert_eq!(diagnostics, []);
        assert_eq!((catalog.machines.len(), catalog.materials.len()), (6, 22));
        assert_eq!(catalog.machine("orac").unwrap().limits.bar_diameter_mm, 20.0);
        assert_eq!(catalog.material("STEEL", Unit::Mm).unwrap().orac.unwrap().feed_cut, 120.0);
    }

    /// Loads one machine file with a mistake: exactly one diagnostic, at `line`, with every one of `words`.
    fn assert_one_mistake(text: &str, line_with: &str, words: &[&str]) {
        let (catalog, diagnostics) = load(&[("machines/bad.toml", text)]);
        let [diagnostic] = diagnostics.as_slice() else { panic!("{diagnostics:?}") };
        let line = 1 + text.lines().position(|l| l.contains(line_with)).unwrap();
        assert!(
            matches!(&diagnostic.at, Place::Line { line: l, file, .. } if *l == line && file.ends_with("bad.toml")),
            "{diagnostic}"
        );
        for word in words {
            assert!(diagnostic.message.contains(word), "{word}: {diagnostic}");
        }
        assert_eq!(catalog, Catalog::shipped());
    }

    #[test]
    fn mistakes_in_a_machine_file_have_line_value_and_limit() {
        let bad = |from: &str, to: &str, words: &[&str]| assert_one_mistake(&orac_with(from, to), to, words);
        bad("travel_x_mm = 95", "travel_x_mm = -95", &["-95 mm", "0.001 to 10000"]);
        bad("travel_x_mm = 95", "travel_x_mm = nan", &["NaN mm", "0.001 to 10000"]);
        bad("travel_x_mm = 95", "travel_x_mm = \"95\"", &["travel_x_mm = \"95\"", "f64"]);
        bad("baud = 2400", "baud = 7", &["7 bits/s", "50 to"]);
        bad("baud = 2400", "baud = -7", &["baud = -7"]);
        bad("parity = \"odd\"", "parity = \"mark\"", &["mark", "`odd`"]);
        bad("travel_x_mm = 95", "travel_q_mm = 95", &["travel_q_mm"]);
        bad("end = 0x04", "end = 0x02", &["2", "must differ"]);
        bad("tool = \"orac-left\"", "tool = \"none-such\"", &["none-such", "orac-right"]);
        bad("pitch_min_mm = 0.35", "pitch_min_mm = 4.35", &["4.35 mm", "3.5 mm"]);
        bad("feed_max_mm_per_min = 1200", "feed_max_mm_per_min = 1e999", &["1e999"]);
    }

    #[test]
    fn keys_that_a_protocol_lacks_or_does_not_know_are_named() {
        let fanuc = orac_with("protocol = \"orac-pages\"", "protocol = \"fanuc-reader-punch\"");
        assert_one_mistake(&fanuc, "[serial]", &["`end_of_block` is missing", "fanuc-reader-punch"]);
        let stray = orac_with("end = 0x04", "end = 0x04\nfolder = \"~/nc\"");
        assert_one_mistake(&stray, "[serial]", &["`folder` means nothing", "orac-pages"]);
    }

    /// The shipped machine file of this name with one change.
    fn machine_with(name: &str, from: &str, to: &str) -> String {
        let source = MACHINES.iter().find(|s| s.name.ends_with(name)).unwrap();
        assert!(source.text.contains(from), "{from}");
        source.text.replacen(from, to, 1)
    }

    #[test]
    fn mistakes_in_the_words_of_a_control_have_line_value_and_limit() {
        let bad = |name: &str, from: &str, to: &str, words: &[&str]| {
            assert_one_mistake(&machine_with(name, from, to), to.lines().next().unwrap(), words);
        };
        let swedish = "swedish-1970s.toml";
        bad(swedish, "x_sign = 1", "x_sign = 2", &["2", "1 or -1"]);
        bad(swedish, "decimals_mm = 3", "decimals_mm = 9", &["9 digits", "0 to 6"]);
        bad(swedish, "arc_center = \"absolute\"", "arc_center = \"polar\"", &["polar", "incremental"]);
        bad(swedish, "{ code = 2, rpm = 63 }", "{ code = 1, rpm = 63 }", &["S1", "twice"]);
        bad(swedish, "step = 1, digits = 3", "step = 0, digits = 3", &["at least 1"]);
        bad(swedish, "max_line_chars = 64", "max_line_chars = 6", &["6 characters", "40"]);
        bad(swedish, "F = { least = 4, most = 4 }", "F = { least = 5, most = 4 }", &["5 digits", "4"]);
        bad(swedish, "speed = { by = \"table\" }", "speed = { by = \"surface\" }", &["surface_speed"]);
        bad(swedish, "coolant_on = \"M08\"", "coolant_on = \"8\"", &["\"8\"", "M08"]);
        bad(swedish, "outline = [[-60, 0]", "outline = [[-60, 80]", &["mm²"]);
        let fanuc = "fanuc-0i.toml";
        bad(fanuc, "dialect = \"fanuc\"", "dialect = \"fancy\"", &["fancy", "linuxcnc"]);
        bad(
            fanuc,
            "decimal_point = \"always\"",
            "zeros = \"drop-leading\"\ndecimal_point = \"always\"",
            &["decimal point"],
        );
        bad(fanuc, "min_rpm = 35", "min_rpm = 35000", &["35000 rev/min", "4500"]);
        bad(fanuc, "rapid_x_mm_per_min = 24000", "rapid_x_mm_per_min = 0", &["0 mm/min"]);
        bad(fanuc, "efficiency = 0.85", "efficiency = 85", &["85", "0.1 to 1"]);
        let library = "mori-fanuc-6t.toml";
        bad(library, "change_z_mm = 320", "change_z_mm = 32000", &["32000 mm"]);
        bad(library, "code = \"M41\"", "code = \"low\"", &["low"]);
    }

    #[test]
    fn parts_of_a_control_that_its_dialect_lacks_or_needs_are_named() {
        let text = machine_with("fanuc-0i.toml", "[motion]", "[motion_]");
        assert!(!load(&[("machines/bad.toml", &text)]).1.is_empty());
        let slow = machine_with("fanuc-0i.toml", "turret_side", "rapid_feed_mm_per_min = 1000\nturret_side");
        assert_one_mistake(&slow, "rapid_feed_mm_per_min", &["has no"]);
        let none = orac_with("rapid_feed_mm_per_min = 1000", "");
        assert_one_mistake(&none, "dialect = ", &["rapid_feed_mm_per_min", "missing"]);
    }

    #[test]
    fn mistakes_in_tools_and_materials_are_named_with_their_line() {
        let tool = |body: &str| format!("[[tool]]\nid = 'a'\nname = 'a'\n{body}\n");
        let iso = |insert: &str, holder: &str| {
            tool(&format!("shape = {{ kind = 'iso', insert = '{insert}', holder = '{holder}' }}"))
        };
        let tools = [
            (iso("CNMG130408", "PCLNR2525M12"), 4, "size \"13\""),
            (iso("CNMG120408", "PDLNR2525M12"), 4, "holder takes the shape D"),
            (iso("CNMG120408", "PCLNR2525M16"), 4, "holder takes the size 16"),
            (tool("shape = { kind = 'button', diameter = 5 }"), 2, "holder is missing"),
            (tool("shape = { kind = 'button', diameter = 0 }\nshank = { width = 20, length = 99 }"), 4, "0 mm"),
            (tool("shape = { kind = 'drill', diameter = 20, point_angle = 118, length = 5 }"), 4, "point alone"),
            (
                tool(
                    "shape = { kind = 'drill', diameter = 20, point_angle = 118, length = 90 }\nshank = { width = 9, length = 9 }",
                ),
                5,
                "no `shank`",
            ),
            (
                tool(
                    "shape = { kind = 'outline', use = 'turning', orientation = 3, nose_radius = 9, corners = [[0,0],[5,0],[5,5]] }\nholder = [[0,0],[5,0],[5,5]]",
                ),
                4,
                "leave room",
            ),
            (tool("shape = { kind = 'spoon' }"), 4, "spoon"),
        ];
        let operation =
            "{ operation = 'rough', tool = 'carbide', speed_m_per_min = 0, feed_mm_per_rev = 1, depth_mm = 1 }";
        let materials = [
            ("[[material]]\nname = 'x'\nlike = 'cheese'\n".to_owned(), 3, "cheese"),
            ("[[material]]\nname = 'x'\n".to_owned(), 2, "no cutting data"),
            (format!("[[material]]\nname = 'x'\noperations = [{operation}]\n"), 3, "0 m/min"),
            ("[[material]]\nname = 'x'\nlike = 'C45'\nspecific_cutting_force_n_per_mm2 = 1\n".to_owned(), 4, "N/mm²"),
        ];
        let cases = tools.iter().map(|case| ("tools/bad.toml", case));
        for (file, (text, line, word)) in cases.chain(materials.iter().map(|case| ("materials/bad.toml", case))) {
            let (_, diagnostics) = load(&[(file, text)]);
            let [diagnostic] = diagnostics.as_slice() else { panic!("{text}: {diagnostics:?}") };
            assert!(matches!(&diagnostic.at, Place::Line { line: l, .. } if l == line), "{text}: {diagnostic}");
            assert!(diagnostic.message.contains(word), "{word}: {diagnostic}");
        }
    }

    #[test]
    fn the_published_library_stands_in_its_turret_as_published() {
        let catalog = Catalog::shipped();
        let machine = catalog.machine("mori-fanuc-6t").unwrap();
        let outlines = crate::machine::outlines(machine, &catalog);
        // Station: RAD, RZ, RX (outwards positive here), WID, ZREF, XREF (positive here).
        for (station, rad, rz, rx, wid, z, x) in [
            (1, 2.5, 0.0, 2.5, 0.0, 320.0, 455.0),
            (2, 0.8, 0.8, 0.8, 0.0, 320.0, 455.0),
            (3, 0.4, -0.4, 0.4, 0.0, 300.0, 300.0),
            (5, 0.0, 0.0, 0.0, 6.0, 320.0, 455.0),
            (6, 0.8, -0.8, 0.8, 0.0, 300.0, 300.0),
            (7, 0.8, 0.8, 0.8, 0.0, 320.0, 455.0),
            (8, 0.0, 0.0, 0.0, 4.1, 320.0, 455.0),
            (10, 0.8, -0.8, 0.8, 0.0, 300.0, 300.0),
            (11, 0.4, 0.4, 0.4, 0.0, 320.0, 455.0),
            (12, 0.8, 0.0, 0.8, 0.0, 320.0, 455.0),
        ] {
            let outline = &outlines[&station];
            assert_eq!((outline.nose_radius, outline.nose_center.z, outline.nose_center.r), (rad, rz, rx), "{station}");
            if wid > 0.0 {
                let bounds = outline.insert.bounds().unwrap();
                assert_eq!((bounds.min.z, bounds.max.z), (0.0, wid));
            }
            let change = machine.change_position(station).unwrap();
            assert_eq!((change.z_mm, change.diameter_mm), (z, x));
        }
        assert_eq!(outlines.len(), 10);
    }

    #[test]
    fn a_station_that_holds_two_tools_is_named() {
        let text = orac_with("station = 2", "station = 1 # again");
        assert_one_mistake(&text, "station = 1 # again", &["Station 1"]);
    }

    #[test]
    fn a_bad_tool_is_left_out_and_the_others_stay() {
        let text = TOOLS[0].text.replace("width = 3,", "width = -3,").replace("orac-", "my-");
        let (catalog, diagnostics) = load(&[("tools/my.toml", &text)]);
        assert!(diagnostics.iter().any(|d| d.message.contains("-3 mm")), "{diagnostics:?}");
        assert!(catalog.tool("my-part-off").is_none() && catalog.tool("my-left").is_some());
    }

    #[test]
    fn an_entry_that_is_there_twice_counts_once() {
        let text = format!("{}{}", MATERIALS[0].text, MATERIALS[0].text.replace("feed_cut = 80", "feed_cut = 81"));
        let (catalog, diagnostics) = load(&[("materials/twice.toml", &text)]);
        assert_eq!(diagnostics.len(), 7);
        assert_eq!(catalog, Catalog::shipped());
    }

    #[test]
    fn every_beginning_of_a_file_is_read_or_reported() {
        let shipped = Catalog::shipped();
        for source in MACHINES.iter().chain(TOOLS).chain(MATERIALS) {
            for (end, _) in source.text.char_indices().step_by(source.text.len() / 150) {
                let cut = Source { name: source.name, text: &source.text[..end] };
                let mut catalog = shipped.clone();
                let mut diagnostics = Vec::new();
                catalog.add(&[cut], &[cut], &[cut], &mut diagnostics);
                assert!(diagnostics.len() >= 2, "a file is of one kind at most: {diagnostics:?}");
            }
        }
    }

    #[test]
    fn a_folder_named_like_a_file_is_reported() {
        let dir = user_dir(&[("tools/folder.toml/x", "")]);
        let (_, diagnostics) = Catalog::load(Some(dir.path()));
        assert_eq!(diagnostics.len(), 1);
        assert_eq!(diagnostics[0].code, "not-a-file");
    }
}
