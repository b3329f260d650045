//! What can be chosen as a port, and opening it.

use super::link::Link;
use super::virtual_lathe::VirtualLathe;
use crate::machine::SerialProfile;

/// Name of the virtual lathe in the port list and on the command line.
pub const VIRTUAL: &str = "virtual";

/// One entry of the port list.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PortChoice {
    /// What is typed to choose it: [`VIRTUAL`], or a device path or name.
    pub name: String,
    /// What to show.
    pub label: String,
}

/// The ports of this computer, the virtual lathe first. Any other path may be typed as well.
#[must_use]
pub fn ports() -> Vec<PortChoice> {
    let lathe = PortChoice { name: VIRTUAL.to_owned(), label: "Virtual lathe (no cable needed)".to_owned() };
    #[cfg(feature = "serial")]
    let serial = super::serial::choices();
    #[cfg(not(feature = "serial"))]
    let serial = Vec::new();
    std::iter::once(lathe).chain(serial).collect()
}

/// Where a transfer goes.
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
    /// The port with this name; `lathe` stands behind the name [`VIRTUAL`].
    #[must_use]
    pub fn named(name: &str, lathe: &VirtualLathe) -> Self {
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

    #[test]
    fn the_virtual_lathe_is_always_in_the_list() {
        assert_eq!(ports().iter().filter(|choice| choice.name == VIRTUAL).count(), 1);
    }
}
