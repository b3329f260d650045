//! Serial ports of this computer (feature `serial`).
//!
//! The driver's software flow control is never used: it swallows DC1 and DC3, which the protocol wants to see.
//! `flush` is never called: it waits without bound.

use super::link::{LARGEST_WRITE, Link};
use super::ports::{Opened, PortChoice};
use crate::machine::{self, SerialProfile};
use serialport::{ClearBuffer, DataBits, FlowControl, Parity, SerialPort, SerialPortType, StopBits};
use std::fmt::Debug;
use std::io::{self, ErrorKind};
use std::path::Path;
use std::time::Duration;

/// A serial port as a link.
#[derive(Debug)]
pub(super) struct SerialLink(Box<dyn SerialPort>);

impl SerialLink {
    pub(super) fn new(port: impl SerialPort + 'static) -> Self {
        Self(Box::new(port))
    }
}

/// Waiting without result is no failure of a link.
fn none_on_timeout(result: io::Result<usize>) -> io::Result<usize> {
    match result {
        Err(error) if matches!(error.kind(), ErrorKind::TimedOut | ErrorKind::WouldBlock | ErrorKind::Interrupted) => {
            Ok(0)
        }
        other => other,
    }
}

impl Link for SerialLink {
    fn write_some(&mut self, bytes: &[u8], timeout: Duration) -> io::Result<usize> {
        let chunk = bytes.get(..LARGEST_WRITE).unwrap_or(bytes);
        self.0.set_timeout(timeout)?;
        none_on_timeout(self.0.write(chunk))
    }

    fn read_some(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize> {
        self.0.set_timeout(timeout)?;
        match self.0.read(buffer) {
            // A port that is readable and yet has nothing was hung up.
            Ok(0) if !buffer.is_empty() => Err(ErrorKind::BrokenPipe.into()),
            result => none_on_timeout(result),
        }
    }

    fn queued(&mut self) -> io::Result<usize> {
        Ok(usize::try_from(self.0.bytes_to_write()?).unwrap_or(usize::MAX))
    }

    fn discard_queued(&mut self) {
        // A driver that cannot discard sends the few bytes it was given; nothing more can be done about it.
        let _ = self.0.clear(ClearBuffer::Output);
    }
}

/// The serial ports that the system lists.
pub(super) fn choices() -> Vec<PortChoice> {
    let listed = serialport::available_ports().unwrap_or_default();
    let choice = |port: serialport::SerialPortInfo| {
        let product = match port.port_type {
            SerialPortType::UsbPort(usb) => usb.product.map(|product| format!(" ({product})")),
            _ => None,
        };
        PortChoice { label: format!("{}{}", port.port_name, product.unwrap_or_default()), name: port.port_name }
    };
    listed.into_iter().map(choice).collect()
}

/// Opens a port with the profile's settings and reads them back.
pub(super) fn open(name: &str, profile: &SerialProfile) -> Result<Opened, String> {
    let wanted = Settings::of(profile);
    let port = serialport::new(name, wanted.baud)
        .data_bits(wanted.data_bits)
        .parity(wanted.parity)
        .stop_bits(wanted.stop_bits)
        .flow_control(wanted.flow)
        .open()
        .map_err(|error| cannot_open(name, &io::Error::from(error)))?;
    let remarks = wanted.not_taken(port.as_ref());
    Ok(Opened { link: Box::new(SerialLink(port)), remarks })
}

fn cannot_open(name: &str, error: &io::Error) -> String {
    const IN_USE: &str = "another program is using it; close that program";
    let why = match error.kind() {
        // The library reports a port that is in use as missing.
        ErrorKind::NotFound if Path::new(name).exists() => IN_USE,
        ErrorKind::NotFound => "there is no such port, or another program is using it; check the cable and the name",
        ErrorKind::PermissionDenied => "this user may not use it; on Linux join the group that owns it (often dialout)",
        ErrorKind::ResourceBusy | ErrorKind::WouldBlock => IN_USE,
        ErrorKind::InvalidInput => "it is no serial port, or it cannot be set to this speed",
        _ => "the system refused it; check that it is a serial port and that no other program uses it",
    };
    format!("Port {name} could not be opened: {why}.")
}

struct Settings {
    baud: u32,
    data_bits: DataBits,
    parity: Parity,
    stop_bits: StopBits,
    flow: FlowControl,
}

impl Settings {
    fn of(profile: &SerialProfile) -> Self {
        Self {
            baud: profile.baud,
            data_bits: if profile.data_bits == 7 { DataBits::Seven } else { DataBits::Eight },
            parity: match profile.parity {
                machine::Parity::None => Parity::None,
                machine::Parity::Odd => Parity::Odd,
                machine::Parity::Even => Parity::Even,
            },
            stop_bits: if profile.stop_bits == 2 { StopBits::Two } else { StopBits::One },
            flow: match profile.flow {
                machine::FlowControl::Hardware => FlowControl::Hardware,
                machine::FlowControl::None | machine::FlowControl::Software => FlowControl::None,
            },
        }
    }

    /// A sentence for every setting that reads back differently.
    fn not_taken(&self, port: &dyn SerialPort) -> Vec<String> {
        [
            differs("speed (baud)", &self.baud, port.baud_rate()),
            differs("number of data bits", &self.data_bits, port.data_bits()),
            differs("parity", &self.parity, port.parity()),
            differs("number of stop bits", &self.stop_bits, port.stop_bits()),
            differs("flow control", &self.flow, port.flow_control()),
        ]
        .into_iter()
        .flatten()
        .collect()
    }
}

fn differs<T: PartialEq + Debug>(what: &str, wanted: &T, taken: serialport::Result<T>) -> Option<String> {
    match taken {
        Ok(taken) if taken == *wanted => None,
        Ok(taken) => Some(format!("The port did not take the {what}: {wanted:?} was asked for, {taken:?} is set.")),
        Err(_) => Some(format!("The port does not tell its {what}; {wanted:?} was asked for.")),
    }
}
