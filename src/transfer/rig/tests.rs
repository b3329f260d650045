use super::super::Device;
use super::*;
use crate::cancel::Cancel;
use crate::spinning::control::Watch;
use crate::spinning::published::{Arithmetic, ConeParameters, cone_points};
use crate::spinning::rig::{Fault, RigModel, SimulatedRig};
use crate::transfer::link::{PipeEnd, pipe};
use std::thread::JoinHandle;

/// A device on a thread; `pace` seconds of its time pass with whatever it hears, none while it hears nothing. With `damage` every so many bytes one is
/// changed on its way to the device.
pub(in super::super) fn device(faults: Vec<Fault>, pace: f64, damage: Option<usize>) -> (PipeEnd, JoinHandle<Device>) {
    device_until(faults, pace, damage, Cancel::default())
}

/// The same, until it is unplugged.
pub(in super::super) fn device_until(
    faults: Vec<Fault>,
    pace: f64,
    damage: Option<usize>,
    unplugged: Cancel,
) -> (PipeEnd, JoinHandle<Device>) {
    let (host, mut line) = pipe();
    let thread = std::thread::spawn(move || {
        let mut device = Device::new(SimulatedRig::new(RigModel::new(95.0, 1.27), faults));
        let mut buffer = [0; 64];
        let mut count = 0;
        while let (false, Ok(read)) = (unplugged.is_cancelled(), line.read_some(&mut buffer, Duration::from_millis(1)))
        {
            for byte in buffer.iter_mut().take(read) {
                count += 1;
                if damage.is_some_and(|every| count % every == 0) && *byte != b'\n' {
                    *byte ^= 4;
                }
            }
            let answer = device.take(&buffer[..read]);
            let mut rest = answer.as_slice();
            while let (false, Ok(taken)) = (rest.is_empty(), line.write_some(rest, Duration::from_millis(50))) {
                rest = &rest[taken..];
            }
            device.advance(if read > 0 { pace } else { 0.0 });
        }
        device
    });
    (host, thread)
}

pub(in super::super) fn plan() -> Plan {
    let cone = ConeParameters::new(40, 16, 30).unwrap();
    Plan::published(&cone_points(&cone, Arithmetic::Exact), cone.roller_position())
        .watched(Watch { limit_mm: 2.5, carriage_mm_per_s: RigModel::new(95.0, 1.27).carriage_mm_per_s() })
}

fn run_to_end(host: &mut Host<PipeEnd>) -> Vec<Position> {
    let mut seen = Vec::new();
    while !seen.last().is_some_and(Position::is_over) {
        seen.push(host.position().unwrap());
        assert!(seen.len() < 10_000, "{:?}", seen.last());
    }
    seen
}

#[test]
fn a_table_goes_down_and_positions_come_up() {
    let (line, thread) = device(Vec::new(), 0.25, None);
    let mut host = Host::connect(line).unwrap();
    host.load(&plan()).unwrap();
    host.go().unwrap();
    let seen = run_to_end(&mut host);
    assert_eq!(seen.last().unwrap().state, 'C');
    assert!(seen.iter().any(|p| p.state == 'F') && seen.windows(2).all(|w| w[0].ms <= w[1].ms));
    let last = plan().targets.last().copied().unwrap();
    assert!(seen.iter().map(|p| p.pulses).max().unwrap() >= last.pulses);
    drop(host);
    assert!(!thread.join().unwrap().rig_mut().lathe_is_on());
}

#[test]
fn damaged_lines_are_sent_again() {
    let (line, _thread) = device(Vec::new(), 0.25, Some(97));
    let mut host = Host::connect(line).unwrap();
    host.load(&plan()).unwrap();
    host.go().unwrap();
    assert_eq!(run_to_end(&mut host).last().unwrap().state, 'C');
}

#[test]
fn faults_and_emergency_stop_reach_the_host() {
    let (line, _thread) = device(vec![Fault::StalledCarriage { after_pulses: 200 }], 0.25, None);
    let mut host = Host::connect(line).unwrap();
    host.load(&plan()).unwrap();
    host.go().unwrap();
    assert_eq!(run_to_end(&mut host).last().unwrap().state, 'D');
    host.go().unwrap();
    host.emergency_stop().unwrap();
    assert_eq!(run_to_end(&mut host).last().unwrap().state, 'D');
}

#[test]
fn a_device_that_hears_nothing_stops_by_itself() {
    let mut device = Device::new(SimulatedRig::new(RigModel::new(95.0, 1.27), Vec::new()));
    let mut tell = |frame: Frame| String::from_utf8(device.take(frame.to_string().as_bytes())).unwrap();
    assert!(tell(Frame::of('G', &[])).starts_with("E table"));
    assert!(tell(Frame::of('S', &[0, 16, 5])).starts_with("E order"));
    assert!(tell(Frame::of('B', &[2, 602, 177, 73, 0, 0])).starts_with("K 2"));
    assert!(tell(Frame::of('S', &[0, 16, 5])).starts_with("K 0"));
    assert!(tell(Frame::of('S', &[0, 16, 5])).starts_with("K 0"), "told twice");
    assert!(tell(Frame::of('S', &[1, 16, 9])).starts_with("E range"), "does not rise");
    assert!(tell(Frame::of('S', &[2, 32, 9])).starts_with("E order"));
    assert!(tell(Frame::of('G', &[])).starts_with("E table"), "half a table");
    assert!(tell(Frame::of('S', &[1, 3200, 9])).starts_with("K 1"));
    assert!(tell(Frame::of('G', &[])).starts_with("K 2"));
    assert!(tell(Frame::of('B', &[2, 602, 177, 73, 0, 0])).starts_with("E order"), "running");
    device.advance(30.0);
    assert!(String::from_utf8(device.take(b"Q*51\n")).unwrap().contains(" D*"));
    assert!(!device.rig_mut().lathe_is_on() && !device.rig_mut().pump_is_on());
}

#[test]
fn a_line_without_a_rig_is_silent_or_strange() {
    let (line, other) = pipe();
    drop(other);
    assert!(matches!(Host::connect(line), Err(HostError::Line(_))));
}
