use super::super::host::tests::{device, device_until, plan};
use super::super::{RemoteEnd, RemoteRun};
use super::*;
use crate::cancel::Cancel;
use crate::spinning::rig::Fault;
use crate::transfer::link::pipe;

/// Longer than any of these may take.
const HANG: Duration = Duration::from_secs(30);

/// A rig that has been greeted, and its run as it goes on.
struct Bench {
    line: RigLine,
    run: RemoteRun,
    seen: Vec<RigEvent>,
}

impl Bench {
    fn new(link: impl Link + 'static) -> Self {
        let line = RigLine::open(Port::Open(Box::new(link)), || ());
        Self { line, run: RemoteRun::new(plan()), seen: Vec::new() }
    }

    /// Takes events until one is `wanted`.
    fn until(&mut self, wanted: impl Fn(&RigEvent) -> bool) -> RigEvent {
        let until = Instant::now() + HANG;
        while Instant::now() < until {
            let events: Vec<RigEvent> = self.line.events().collect();
            for event in events {
                self.run.take(&event);
                self.seen.push(event.clone());
                if wanted(&event) {
                    return event;
                }
            }
            thread::sleep(Duration::from_millis(1));
        }
        panic!("nothing of the kind: {:?}", self.seen)
    }

    fn begin(&mut self) {
        self.until(|e| *e == RigEvent::AtDatum);
        self.line.run(plan());
    }

    fn end(&mut self) -> RemoteEnd {
        self.until(|e| matches!(e, RigEvent::Completed | RigEvent::Stopped { .. } | RigEvent::Lost(_)));
        self.run.end().unwrap().clone()
    }
}

fn follows(event: &RigEvent) -> bool {
    matches!(event, RigEvent::At(at) if at.state == 'F' && at.pulses > 100)
}

#[test]
fn a_run_over_the_line_is_followed_to_its_end_and_repeated() {
    let (link, _thread) = device(Vec::new(), 0.1, None);
    let mut bench = Bench::new(link);
    bench.begin();
    assert_eq!(bench.end(), RemoteEnd::Completed);
    let errors = bench.run.errors();
    assert!(bench.run.actual().len() > 10 && (errors.angle_deg - 30.0).abs() < 3.0, "{errors:?}");
    assert!(errors.largest_mm < 2.5, "{errors:?}");
    bench.run = RemoteRun::new(plan());
    bench.line.seek_datum();
    bench.begin();
    assert_eq!(bench.end(), RemoteEnd::Completed);
}

#[test]
fn emergency_stop_over_the_line_draws_back_and_switches_off() {
    // Before the roller moves, and in the middle of the contour.
    let moments: [fn(&RigEvent) -> bool; 2] = [|e| matches!(e, RigEvent::At(_)), follows];
    for moment in moments {
        let (link, thread) = device(Vec::new(), 0.05, None);
        let mut bench = Bench::new(link);
        bench.begin();
        bench.until(moment);
        bench.line.emergency_stop();
        let reason = "Emergency stop by the operator.".to_owned();
        assert_eq!(bench.end(), RemoteEnd::Stopped { reason, drawn_back: true });
        drop(bench);
        let mut device = thread.join().unwrap();
        assert!(!device.rig_mut().lathe_is_on() && !device.rig_mut().pump_is_on());
    }
}

#[test]
fn emergency_stop_reaches_a_rig_on_which_nothing_runs() {
    let (link, thread) = device(Vec::new(), 0.05, None);
    let mut bench = Bench::new(link);
    bench.until(|e| *e == RigEvent::AtDatum);
    // Pressed again and again.
    (0..50).for_each(|_| {
        bench.line.emergency_stop();
        thread::sleep(Duration::from_millis(1));
    });
    let reason = "Emergency stop by the operator.".to_owned();
    assert_eq!(bench.end(), RemoteEnd::Stopped { reason, drawn_back: true });
    // When the last one is through, it is set up again.
    thread::sleep(Duration::from_millis(200));
    let told: Vec<RigEvent> = bench.line.events().collect();
    assert!(told.iter().all(|e| matches!(e, RigEvent::Stopped { .. })), "{told:?}");
    bench.line.seek_datum();
    bench.until(|e| matches!(e, RigEvent::AtDatum | RigEvent::Stopped { .. } | RigEvent::Lost(_)));
    assert_eq!(bench.seen.last(), Some(&RigEvent::AtDatum));
    drop(bench);
    let mut device = thread.join().unwrap();
    assert!(!device.rig_mut().lathe_is_on());
}

#[test]
fn the_reason_of_a_stop_comes_with_value_and_limit() {
    // A roller that runs away is seen by its place or by its creeping, whichever comes first.
    let expected = [
        (Fault::StalledCarriage { after_pulses: 200 }, ["The encoder counted"; 2], true),
        (Fault::StuckValve { after_pulses: 200, open: true }, ["off its path away from", "with the valve shut"], true),
        (Fault::StuckValve { after_pulses: 200, open: false }, ["off its path towards the axis"; 2], false),
        (Fault::DriftingSupply { percent_per_min: 20.0 }, ["with the valve shut"; 2], true),
    ];
    for (fault, words, back) in expected {
        let (link, _thread) = device(vec![fault], 0.1, None);
        let mut bench = Bench::new(link);
        bench.begin();
        let RemoteEnd::Stopped { reason, drawn_back } = bench.end() else { panic!("{fault}: {:?}", bench.run.end()) };
        println!("{fault}: {reason}");
        assert!(words.iter().any(|w| reason.contains(w)) && reason.contains("2.50 mm"), "{fault}: {reason}");
        assert_eq!(drawn_back, back, "{fault}");
    }
}

#[test]
fn a_device_that_vanishes_in_a_run_is_told_and_stops_by_itself() {
    let unplugged = Cancel::default();
    let (link, thread) = device_until(Vec::new(), 0.05, None, unplugged.clone());
    let mut bench = Bench::new(link);
    bench.begin();
    bench.until(follows);
    unplugged.cancel();
    let RemoteEnd::Lost(reason) = bench.end() else { panic!("{:?}", bench.run.end()) };
    assert!(reason.contains("line to the rig is gone") && reason.contains("stops by itself"), "{reason}");
    // The device's side: its carriage stands and its roller is back, for it heard nothing more.
    let mut device = thread.join().unwrap();
    device.advance(60.0);
    assert!(!device.rig_mut().lathe_is_on() && !device.rig_mut().pump_is_on());
    assert!(device.rig_mut().roller_mm() < 5.0, "{}", device.rig_mut().roller_mm());
}

#[test]
fn silence_and_strangers_are_refused_in_bounded_time() {
    let (link, other) = pipe();
    let began = Instant::now();
    let mut bench = Bench::new(link);
    let RigEvent::Lost(reason) = bench.until(|e| matches!(e, RigEvent::Lost(_))) else { unreachable!("asked for") };
    assert!(reason.contains("no answer in 4 tries of 500 ms"), "{reason}");
    assert!(began.elapsed() < Duration::from_secs(10));
    drop(other);

    let (link, mut other) = pipe();
    let stranger = thread::spawn(move || {
        let mut buffer = [0; 64];
        while let Ok(count) = other.read_some(&mut buffer, Duration::from_millis(20)) {
            if count > 0 && other.write_some(b"H plotter 7*1B\n", Duration::from_millis(20)).is_err() {
                break;
            }
        }
    });
    let mut bench = Bench::new(link);
    let RigEvent::Lost(reason) = bench.until(|e| matches!(e, RigEvent::Lost(_))) else { unreachable!("asked for") };
    drop(bench);
    stranger.join().unwrap();
    assert!(reason.contains("plotter 7"), "{reason}");

    let missing = RigLine::open(Port::Serial("/dev/no-such-port".to_owned()), || ());
    let until = Instant::now() + HANG;
    let said = loop {
        if let Some(event) = missing.events().next() {
            break event;
        }
        assert!(Instant::now() < until);
        thread::sleep(Duration::from_millis(1));
    };
    assert!(matches!(&said, RigEvent::Lost(reason) if reason.contains("/dev/no-such-port")), "{said:?}");
}
