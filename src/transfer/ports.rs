//! What can be chosen as the target of a transfer, and opening it.

use super::link::Link;
use super::virtual_lathe::VirtualLathe;
use crate::machine::{Delivery, FolderProfile, Protocol, SerialProfile};

/// Name of the virtual lathe in the port list and on the command line.
pub const VIRTUAL: &str = "virtual";

/// One entry of the port list.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PortChoice {
    /// What is typed to choose it: [`VIRTUAL`], a device path or name, or a folder.
    pub name: String,
    /// What to show.
    pub label: String,
}

/// Where programs of a control can go: the ports of this computer, the virtual control first, or the control's folder.
/// Any other path may be typed as well.
#[must_use]
pub fn ports(delivery: &Delivery) -> Vec<PortChoice> {
    let profile = match delivery {
        Delivery::Line(profile) => profile,
        Delivery::Folder(FolderProfile { folder, .. }) => {
            return vec![PortChoice { name: folder.clone(), label: format!("Folder {folder}") }];
        }
    };
    let label = match profile.protocol {
        Protocol::OracPages(_) => "Virtual lathe (no cable needed)",
        Protocol::FanucReaderPunch(_) => "Virtual Fanuc (no cable needed)",
    };
    let lathe = PortChoice { name: VIRTUAL.to_owned(), label: label.to_owned() };
    std::iter::once(lathe).chain(serial_ports()).collect()
}

/// The serial ports at which a rig may be; none in a Turnwright built without serial ports. A path may be typed as well.
#[must_use]
pub fn serial_ports() -> Vec<PortChoice> {
    #[cfg(feature = "serial")]
    let serial = super::serial::choices();
    #[cfg(not(feature = "serial"))]
    let serial = Vec::new();
    serial
}

/// Where a transfer goes.
#[derive(Debug)]
pub enum Target {
    /// Over a line.
    Line {
        /// Over which port.
        port: Port,
        /// Settings of the line.
        profile: SerialProfile,
    },
    /// Into a folder.
    Folder(FolderProfile),
}

impl Target {
    /// What `name` means for a control: a port, or the folder for its programs. `lathe` stands behind [`VIRTUAL`].
    #[must_use]
    pub fn named(name: &str, delivery: &Delivery, lathe: &VirtualLathe) -> Self {
        match delivery {
            Delivery::Line(profile) => Self::Line { port: Port::named(name, lathe), profile: profile.clone() },
            Delivery::Folder(profile) => Self::Folder(FolderProfile { folder: name.to_owned(), ..profile.clone() }),
        }
    }
}

/// A port of a line.
#[derive(Debug)]
pub enum Port {
    /// The virtual lathe in this process.
    Virtual(VirtualLathe),
    /// A serial port by device path or name.
    Serial(String),
    /// A link that is open already.
    Open(Box<dyn Link>),
}

impl Port {
    fn named(name: &str, lathe: &VirtualLathe) -> Self {
        if name == VIRTUAL { Self::Virtual(lathe.clone()) } else { Self::Serial(name.to_owned()) }
    }
}

/// An open link, and what is worth saying about it.
pub(super) struct Opened {
    pub(super) link: Box<dyn Link>,
    /// Settings that the driver did not take.
    pub(super) remarks: Vec<String>,
}

/// Opens a port. May block for as long as the driver likes.
pub(super) fn open(port: Port, profile: &SerialProfile, unpaced: bool) -> Result<Opened, String> {
    match port {
        Port::Virtual(lathe) => Ok(Opened { link: Box::new(lathe.connect(profile, unpaced)), remarks: Vec::new() }),
        Port::Open(link) => Ok(Opened { link, remarks: Vec::new() }),
        #[cfg(feature = "serial")]
        Port::Serial(name) => super::serial::open(&name, profile),
        #[cfg(not(feature = "serial"))]
        Port::Serial(name) => Err(format!(
            "Port {name} cannot be opened: this Turnwright was built without serial ports. Use the port `{VIRTUAL}`."
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::transfer::line::tests::{fanuc_profile, orac_profile};

    #[test]
    fn a_virtual_control_is_always_in_the_list() {
        for (profile, label) in [(orac_profile(), "Virtual lathe"), (fanuc_profile(), "Virtual Fanuc")] {
            let all = ports(&Delivery::Line(profile));
            assert!(all[0].name == VIRTUAL && all[0].label.starts_with(label), "{all:?}");
            assert_eq!(all.iter().filter(|choice| choice.name == VIRTUAL).count(), 1);
        }
    }

    #[test]
    fn a_folder_is_the_only_choice_of_a_control_that_reads_one() {
        let delivery = Delivery::Folder(FolderProfile { folder: "~/nc".to_owned(), extension: "ngc".to_owned() });
        assert_eq!(ports(&delivery), [PortChoice { name: "~/nc".to_owned(), label: "Folder ~/nc".to_owned() }]);
        let target = Target::named("/tmp/other", &delivery, &VirtualLathe::default());
        assert!(matches!(target, Target::Folder(profile) if profile.folder == "/tmp/other"));
    }
}
