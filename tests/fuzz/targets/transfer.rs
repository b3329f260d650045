//! The transfer's state machines under any bytes at any time, and the comparison of what came back.
#![no_main]

use libfuzzer_sys::fuzz_target;
use std::sync::LazyLock;
use std::time::Duration;
use turnwright::machine::{Catalog, Delivery, EndOfBlock, FlowControl, Protocol, ReaderPunch, SerialProfile};
use turnwright::transfer::compare::Blanks;
use turnwright::transfer::protocol::{compare, outgoing, problems, text_of};
use turnwright::transfer::receiver::{ReceiveStep, Receiver};
use turnwright::transfer::sender::{Patience, SendStep, Sender};

static ORAC: LazyLock<SerialProfile> = LazyLock::new(|| {
    let orac = Catalog::shipped().machine("orac").expect("shipped").serial.clone();
    let Delivery::Line(profile) = orac else { panic!("no line") };
    profile
});

const PATIENCE: Duration = Duration::from_secs(5);

/// A Fanuc whose habits follow from a byte.
fn fanuc(habits: u8) -> SerialProfile {
    let end_of_block = if habits & 1 == 0 { EndOfBlock::Lf } else { EndOfBlock::LfCrCr };
    let habits = ReaderPunch { end_of_block, tv_check: habits & 2 != 0, confirms_end: habits & 4 != 0 };
    SerialProfile { flow: FlowControl::Software, protocol: Protocol::FanucReaderPunch(habits), ..ORAC.clone() }
}

/// The first byte of a chunk says how long it came after the one before.
fn chunks(bytes: &[u8]) -> impl Iterator<Item = (Duration, &[u8])> {
    bytes.chunks(16).map(|chunk| (Duration::from_millis(u64::from(chunk[0]) * 25), &chunk[1..]))
}

fn receive(profile: &SerialProfile, bytes: &[u8]) {
    let (mut receiver, mut now) = (Receiver::new(profile, PATIENCE, PATIENCE), Duration::ZERO);
    receiver.poll(now);
    for (pause, chunk) in chunks(bytes) {
        now += pause;
        receiver.received(chunk, now);
        if receiver.poll(now) != ReceiveStep::Wait {
            break;
        }
    }
    assert_ne!(receiver.poll(now + PATIENCE), ReceiveStep::Wait, "waits for ever");
    let done = receiver.poll(now) == ReceiveStep::Done;
    let received = receiver.into_received();
    let text = text_of(received.clone(), profile.protocol);
    if problems(&received, profile.protocol).is_empty() {
        let same = compare(&text, &received, profile.protocol, Blanks::Exact);
        assert!(same.is_empty(), "{same:?}");
    }
    if done {
        send(profile, &text, bytes);
    }
}

fn send(profile: &SerialProfile, text: &str, answers: &[u8]) {
    let patience = Patience { start: PATIENCE, stuck: PATIENCE };
    let Ok(mut sender) = Sender::new(text, profile, true, patience) else { return };
    let whole = outgoing(text, profile.protocol).expect("the sender took it").bytes;
    let (mut now, mut out) = (Duration::ZERO, Vec::new());
    for (pause, chunk) in chunks(answers) {
        now += pause;
        sender.received(chunk, now);
        let taken = match sender.poll(now) {
            SendStep::Write(bytes) => {
                let taken = bytes.len().min(1 + chunk.len());
                out.extend_from_slice(&bytes[..taken]);
                taken
            }
            SendStep::Wait(_) => continue,
            SendStep::Done | SendStep::Failed(_) => break,
        };
        sender.written(taken, now);
    }
    assert!(whole.starts_with(&out));
}

fuzz_target!(|bytes: &[u8]| {
    let habits = bytes.first().copied().unwrap_or_default();
    let software = SerialProfile { flow: FlowControl::Software, ..ORAC.clone() };
    for profile in [ORAC.clone(), software, fanuc(habits)] {
        receive(&profile, bytes);
        let text = String::from_utf8_lossy(bytes);
        let (a, b) = text.split_at(text.floor_char_boundary(text.len() / 2));
        for blanks in [Blanks::Exact, Blanks::Ignored] {
            let _ = compare(a, b, profile.protocol, blanks);
        }
        send(&profile, &text, bytes);
    }
});
