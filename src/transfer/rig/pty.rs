//! The simulated device on a pseudo-terminal, for other programs.

use super::device::Device;
use crate::cancel::Cancel;
use crate::transfer::link::Link;
use crate::transfer::serial::SerialLink;
use serialport::{SerialPort, TTYPort};
use std::time::{Duration, Instant};

/// Longest wait of one read or write.
const TURN: Duration = Duration::from_millis(5);

/// Serves until cancelled; the rig's time passes `pace` times as fast as the clock. `ready` is told the port to use.
///
/// # Errors
/// A sentence, if the system gives no pseudo-terminal.
pub fn run_on_pty(device: Device, pace: f64, ready: impl FnOnce(String), cancel: &Cancel) -> Result<(), String> {
    // The slave stays open here, so that a program that closes the port does not hang the device up.
    let (master, slave) = TTYPort::pair().map_err(|_| "The system gives no pseudo-terminal.".to_owned())?;
    ready(slave.name().ok_or("The system does not name the pseudo-terminal.")?);
    serve(&mut SerialLink::new(master), device.at_pace(pace), pace, cancel);
    drop(slave);
    Ok(())
}

fn serve(link: &mut dyn Link, mut device: Device, pace: f64, cancel: &Cancel) {
    let mut buffer = [0; 64];
    let mut answer: Vec<u8> = Vec::new();
    let mut last = Instant::now();
    while !cancel.is_cancelled() {
        let Ok(count) = link.read_some(&mut buffer, TURN) else { break };
        let now = Instant::now();
        device.advance(pace * (now - last).as_secs_f64());
        last = now;
        answer.extend(device.take(buffer.get(..count).unwrap_or_default()));
        if !answer.is_empty() {
            let Ok(taken) = link.write_some(&answer, TURN) else { break };
            answer.drain(..taken.min(answer.len()));
        }
    }
}
