//! The transfer's state machines under any bytes at any time, and the comparison of what came back.
#![no_main]

use libfuzzer_sys::fuzz_target;
use std::sync::LazyLock;
use std::time::Duration;
use turnwright::machine::{Catalog, FlowControl, SerialProfile};
use turnwright::transfer::compare::Blanks;
use turnwright::transfer::orac::{ReceiveStep, Receiver, SendStep, Sender};
use turnwright::transfer::{compare, pages};

static PROFILE: LazyLock<SerialProfile> =
    LazyLock::new(|| Catalog::shipped().machine("orac").expect("shipped").serial.clone());

const PATIENCE: Duration = Duration::from_secs(5);

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
    let text = receiver.into_text();
    let _ = pages::problems(&text, profile.page_start);
    let same = compare(&text, &text, profile.page_start, Blanks::Exact);
    assert!(same.is_empty(), "{same:?}");
    if done {
        send(profile, &text, bytes);
    }
}

fn send(profile: &SerialProfile, text: &str, answers: &[u8]) {
    let Ok(mut sender) = Sender::new(text, profile, true, PATIENCE) else { return };
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
    assert!(text.as_bytes().starts_with(out.strip_suffix(&[profile.end]).unwrap_or(&out)));
}

fuzz_target!(|bytes: &[u8]| {
    receive(&PROFILE, bytes);
    receive(&SerialProfile { flow: FlowControl::Software, ..PROFILE.clone() }, bytes);
    let text = String::from_utf8_lossy(bytes);
    let (a, b) = text.split_at(text.floor_char_boundary(text.len() / 2));
    let _ = (compare(a, b, 2, Blanks::Exact), compare(a, b, 2, Blanks::Ignored));
    send(&PROFILE, &text, bytes);
});
