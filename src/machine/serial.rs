//! How programs reach a control: over a serial line, or into a folder.

use serde::{Deserialize, Serialize};
use std::ops::RangeInclusive;
use std::path::Path;

/// Speeds of a serial line, bits per second.
pub const BAUD: RangeInclusive<u32> = 50..=4_000_000;

/// DC1 (XON): "start" or "go on".
pub const DC1: u8 = 0x11;
/// DC2: a reader/punch control begins to punch.
pub const DC2: u8 = 0x12;
/// DC3 (XOFF): "wait".
pub const DC3: u8 = 0x13;
/// DC4: a reader/punch control has ended its punch.
pub const DC4: u8 = 0x14;

/// The way of a program to its control: the table `[serial]` of a machine file.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "Keys", into = "Keys")]
pub enum Delivery {
    /// Over a serial line.
    Line(SerialProfile),
    /// As a file into a folder that the control reads (protocol `folder`).
    Folder(FolderProfile),
}

/// Settings of a serial line and what is spoken over it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SerialProfile {
    /// Speed, bits per second.
    pub baud: u32,
    /// Data bits, 7 or 8.
    pub data_bits: u8,
    /// Parity bit.
    pub parity: Parity,
    /// Stop bits, 1 or 2.
    pub stop_bits: u8,
    /// Flow control.
    pub flow: FlowControl,
    /// Protocol.
    pub protocol: Protocol,
}

/// What is spoken over a serial line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Protocol {
    /// Pages of the Denford ORAC (`orac-pages`).
    OracPages(PageMarks),
    /// Reader/punch interface of Fanuc controls (`fanuc-reader-punch`).
    FanucReaderPunch(ReaderPunch),
}

/// Marks of a page protocol.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PageMarks {
    /// Character that begins a page, as a number.
    pub page_start: u8,
    /// Character that ends the transfer, as a number.
    pub end: u8,
}

/// Habits of a reader/punch control.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ReaderPunch {
    /// Characters that end a block.
    pub end_of_block: EndOfBlock,
    /// Every block has an even number of characters, its line feed included; a blank before the line feed makes it so.
    pub tv_check: bool,
    /// The control sends DC3 when it has read the closing `%`; without it a send fails.
    pub confirms_end: bool,
}

/// Characters that end a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum EndOfBlock {
    /// A line feed.
    Lf,
    /// A line feed and two carriage returns.
    LfCrCr,
}

impl EndOfBlock {
    /// The characters.
    #[must_use]
    pub const fn text(self) -> &'static str {
        match self {
            Self::Lf => "\n",
            Self::LfCrCr => "\n\r\r",
        }
    }
}

/// A folder from which a control takes its programs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FolderProfile {
    /// The folder: an absolute path, or one that begins with `~/` for the user's home.
    pub folder: String,
    /// What the names of the files end with, without the dot.
    pub extension: String,
}

/// Parity of a serial line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Parity {
    /// No parity bit.
    None,
    /// Odd number of ones.
    Odd,
    /// Even number of ones.
    Even,
}

/// Flow control of a serial line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum FlowControl {
    /// None: the receiver must keep up.
    None,
    /// DC1/DC3 characters.
    Software,
    /// RTS/CTS lines.
    Hardware,
}

/// A value that cannot be right: its key, and a sentence with the value and what is allowed.
pub type WrongKey = (&'static str, String);

impl Delivery {
    /// Everything that cannot be right.
    #[must_use]
    pub fn faults(&self) -> Vec<WrongKey> {
        match self {
            Self::Line(profile) => profile.faults(),
            Self::Folder(profile) => profile.faults(),
        }
    }
}

impl SerialProfile {
    /// Everything that cannot be right.
    #[must_use]
    pub fn faults(&self) -> Vec<WrongKey> {
        let mut faults = Vec::new();
        let Self { baud, data_bits, stop_bits, .. } = self;
        if !BAUD.contains(baud) {
            let (low, high) = (BAUD.start(), BAUD.end());
            faults.push(("baud", format!("The speed is {baud} bits/s; it must be {low} to {high} bits/s.")));
        }
        if !(7..=8).contains(data_bits) {
            faults.push(("data_bits", format!("There are {data_bits} data bits; there must be 7 or 8.")));
        }
        if !(1..=2).contains(stop_bits) {
            faults.push(("stop_bits", format!("There are {stop_bits} stop bits; there must be 1 or 2.")));
        }
        match self.protocol {
            Protocol::OracPages(marks) => faults.extend(marks.faults()),
            Protocol::FanucReaderPunch(_) if self.flow == FlowControl::None => {
                let message = "The value is \"none\"; a reader/punch control starts and stops the sender with DC1 and \
                               DC3, so it must be \"software\", or \"hardware\" if the RTS/CTS lines are wired as well.";
                faults.push(("flow", message.to_owned()));
            }
            Protocol::FanucReaderPunch(_) => {}
        }
        faults
    }

    /// True if the control stops the sender with DC3 and lets it go on with DC1.
    #[must_use]
    pub fn heeds_dc3(&self) -> bool {
        self.flow == FlowControl::Software || matches!(self.protocol, Protocol::FanucReaderPunch(_))
    }
}

impl PageMarks {
    fn faults(self) -> Vec<WrongKey> {
        let mut faults = Vec::new();
        for (key, mark) in [("page_start", self.page_start), ("end", self.end)] {
            let taken = [0, b'\t', b'\n', b'\r', DC1, DC3].contains(&mark);
            if taken || mark >= b' ' {
                let message = format!(
                    "The value is character {mark}; it must be a control character from 1 to 31 other than tab (9), line \
                     feed (10), carriage return (13), DC1 (17) and DC3 (19)."
                );
                faults.push((key, message));
            }
        }
        if self.page_start == self.end {
            faults.push(("end", format!("The value is {}, the same as page_start; they must differ.", self.end)));
        }
        faults
    }
}

impl FolderProfile {
    /// Everything that cannot be right.
    #[must_use]
    pub fn faults(&self) -> Vec<WrongKey> {
        let Self { folder, extension } = self;
        let mut faults = Vec::new();
        if !(folder.starts_with("~/") || Path::new(folder).is_absolute()) {
            let message = format!("The folder is \"{folder}\"; it must be an absolute path or begin with \"~/\".");
            faults.push(("folder", message));
        }
        if !(1..=16).contains(&extension.len()) || !extension.chars().all(|c| c.is_ascii_alphanumeric()) {
            let message =
                format!("The value is \"{extension}\"; it must be 1 to 16 letters or digits, without the dot.");
            faults.push(("extension", message));
        }
        faults
    }
}

/// Names of the protocols in a machine file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Name {
    OracPages,
    FanucReaderPunch,
    Folder,
}

impl Name {
    const fn text(self) -> &'static str {
        match self {
            Self::OracPages => "orac-pages",
            Self::FanucReaderPunch => "fanuc-reader-punch",
            Self::Folder => "folder",
        }
    }
}

/// The table `[serial]` as it is written: each protocol has keys of its own.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Keys {
    protocol: Option<Name>,
    #[serde(skip_serializing_if = "Option::is_none")]
    baud: Option<u32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    data_bits: Option<u8>,
    #[serde(skip_serializing_if = "Option::is_none")]
    parity: Option<Parity>,
    #[serde(skip_serializing_if = "Option::is_none")]
    stop_bits: Option<u8>,
    #[serde(skip_serializing_if = "Option::is_none")]
    flow: Option<FlowControl>,
    #[serde(skip_serializing_if = "Option::is_none")]
    page_start: Option<u8>,
    #[serde(skip_serializing_if = "Option::is_none")]
    end: Option<u8>,
    #[serde(skip_serializing_if = "Option::is_none")]
    end_of_block: Option<EndOfBlock>,
    #[serde(skip_serializing_if = "Option::is_none")]
    tv_check: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    confirms_end: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    folder: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    extension: Option<String>,
}

impl TryFrom<Keys> for Delivery {
    type Error = String;

    fn try_from(mut keys: Keys) -> Result<Self, String> {
        const NAMES: &str = "\"orac-pages\", \"fanuc-reader-punch\" or \"folder\"";
        let name = keys.protocol.ok_or_else(|| format!("the key `protocol` is missing; it is {NAMES}"))?;
        let missing = |key: &str| format!("the key `{key}` is missing; the protocol \"{}\" needs it", name.text());
        let delivery = match name {
            Name::OracPages => {
                let page_start = keys.page_start.take().ok_or_else(|| missing("page_start"))?;
                let end = keys.end.take().ok_or_else(|| missing("end"))?;
                Self::Line(keys.line(Protocol::OracPages(PageMarks { page_start, end }), missing)?)
            }
            Name::FanucReaderPunch => {
                let habits = ReaderPunch {
                    end_of_block: keys.end_of_block.take().ok_or_else(|| missing("end_of_block"))?,
                    tv_check: keys.tv_check.take().ok_or_else(|| missing("tv_check"))?,
                    confirms_end: keys.confirms_end.take().ok_or_else(|| missing("confirms_end"))?,
                };
                Self::Line(keys.line(Protocol::FanucReaderPunch(habits), missing)?)
            }
            Name::Folder => Self::Folder(FolderProfile {
                folder: keys.folder.take().ok_or_else(|| missing("folder"))?,
                extension: keys.extension.take().ok_or_else(|| missing("extension"))?,
            }),
        };
        match keys.left_over() {
            Some(key) => Err(format!("the key `{key}` means nothing to the protocol \"{}\"; remove it", name.text())),
            None => Ok(delivery),
        }
    }
}

impl Keys {
    /// Takes the keys of the line.
    fn line(&mut self, protocol: Protocol, missing: impl Fn(&str) -> String) -> Result<SerialProfile, String> {
        Ok(SerialProfile {
            baud: self.baud.take().ok_or_else(|| missing("baud"))?,
            data_bits: self.data_bits.take().ok_or_else(|| missing("data_bits"))?,
            parity: self.parity.take().ok_or_else(|| missing("parity"))?,
            stop_bits: self.stop_bits.take().ok_or_else(|| missing("stop_bits"))?,
            flow: self.flow.take().ok_or_else(|| missing("flow"))?,
            protocol,
        })
    }

    /// A key that no protocol has taken.
    fn left_over(&self) -> Option<&'static str> {
        let keys = [
            ("baud", self.baud.is_some()),
            ("data_bits", self.data_bits.is_some()),
            ("parity", self.parity.is_some()),
            ("stop_bits", self.stop_bits.is_some()),
            ("flow", self.flow.is_some()),
            ("page_start", self.page_start.is_some()),
            ("end", self.end.is_some()),
            ("end_of_block", self.end_of_block.is_some()),
            ("tv_check", self.tv_check.is_some()),
            ("confirms_end", self.confirms_end.is_some()),
            ("folder", self.folder.is_some()),
            ("extension", self.extension.is_some()),
        ];
        keys.into_iter().find(|(_, is_there)| *is_there).map(|(key, _)| key)
    }
}

impl From<Delivery> for Keys {
    fn from(delivery: Delivery) -> Self {
        let profile = match delivery {
            Delivery::Line(profile) => profile,
            Delivery::Folder(FolderProfile { folder, extension }) => {
                return Self {
                    protocol: Some(Name::Folder),
                    folder: Some(folder),
                    extension: Some(extension),
                    ..Self::default()
                };
            }
        };
        let line = Self {
            baud: Some(profile.baud),
            data_bits: Some(profile.data_bits),
            parity: Some(profile.parity),
            stop_bits: Some(profile.stop_bits),
            flow: Some(profile.flow),
            ..Self::default()
        };
        match profile.protocol {
            Protocol::OracPages(PageMarks { page_start, end }) => {
                Self { protocol: Some(Name::OracPages), page_start: Some(page_start), end: Some(end), ..line }
            }
            Protocol::FanucReaderPunch(ReaderPunch { end_of_block, tv_check, confirms_end }) => Self {
                protocol: Some(Name::FanucReaderPunch),
                end_of_block: Some(end_of_block),
                tv_check: Some(tv_check),
                confirms_end: Some(confirms_end),
                ..line
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FANUC: &str = "protocol = \"fanuc-reader-punch\"\nbaud = 4800\ndata_bits = 7\nparity = \"even\"\nstop_bits = 2\n\
                         flow = \"software\"\nend_of_block = \"lf-cr-cr\"\ntv_check = false\nconfirms_end = true\n";
    const FOLDER: &str = "protocol = \"folder\"\nfolder = \"~/linuxcnc/nc_files\"\nextension = \"ngc\"\n";

    fn read(text: &str) -> Result<Delivery, String> {
        toml::from_str(text).map_err(|e| e.to_string())
    }

    #[test]
    fn each_protocol_is_read_and_written_with_its_own_keys() {
        for text in [FANUC, FOLDER] {
            let delivery = read(text).unwrap();
            assert_eq!(delivery.faults(), []);
            assert_eq!(toml::to_string(&delivery).unwrap(), text);
        }
        let Ok(Delivery::Line(fanuc)) = read(FANUC) else { panic!("no line") };
        assert!(fanuc.heeds_dc3());
    }

    #[test]
    fn keys_that_are_missing_or_mean_nothing_are_named() {
        for (text, words) in [
            (FANUC.replace("tv_check = false\n", ""), "`tv_check` is missing"),
            (FANUC.replace("baud = 4800\n", ""), "`baud` is missing; the protocol \"fanuc-reader-punch\""),
            (format!("{FANUC}page_start = 2\n"), "`page_start` means nothing"),
            (format!("{FOLDER}baud = 4800\n"), "`baud` means nothing to the protocol \"folder\""),
            (FOLDER.replace("folder\"\nf", "carrier-pigeon\"\nf"), "carrier-pigeon"),
            (FOLDER.replace("protocol = \"folder\"\n", ""), "`protocol` is missing"),
            (format!("{FOLDER}port = 1\n"), "unknown field `port`"),
        ] {
            let error = read(&text).unwrap_err();
            assert!(error.contains(words), "{words}: {error}");
        }
    }

    #[test]
    fn values_out_of_range_are_named_with_their_key() {
        for (from, to, key, words) in [
            ("4800", "7", "baud", "7 bits/s"),
            ("data_bits = 7", "data_bits = 9", "data_bits", "9 data bits"),
            ("stop_bits = 2", "stop_bits = 0", "stop_bits", "0 stop bits"),
            ("\"software\"", "\"none\"", "flow", "DC1 and DC3"),
        ] {
            let faults = read(&FANUC.replace(from, to)).unwrap().faults();
            assert!(faults.len() == 1 && faults[0].0 == key && faults[0].1.contains(words), "{faults:?}");
        }
        for (from, to, key) in [("~/linuxcnc", "linuxcnc", "folder"), ("\"ngc\"", "\".ngc\"", "extension")] {
            let faults = read(&FOLDER.replace(from, to)).unwrap().faults();
            assert!(faults.len() == 1 && faults[0].0 == key, "{faults:?}");
        }
        for (page_start, end, words) in
            [(2, 65, "character 65"), (DC1, 4, "character 17"), (4, 4, "the same as page_start")]
        {
            let faults = PageMarks { page_start, end }.faults();
            assert!(faults.len() == 1 && faults[0].1.contains(words), "{faults:?}");
        }
    }
}
