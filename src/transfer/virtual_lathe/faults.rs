//! The fault switch: what goes wrong on purpose.

use std::str::FromStr;
use std::time::Duration;

/// What a byte suffers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ByteFaultKind {
    /// It is lost.
    Drop,
    /// Its lowest bit is flipped: `2` becomes `3`, the hardest change to notice.
    Change,
    /// It arrives twice.
    Duplicate,
    /// Its parity is wrong: it arrives as NUL, which is what a serial driver makes of it.
    Parity,
}

/// Which bytes suffer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum When {
    /// The byte at this place, counted from 1 since the connection was opened.
    At(usize),
    /// Every byte with this probability, 0 to 1; which ones follows from the seed.
    Chance(f64),
}

/// One fault of bytes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ByteFault {
    /// What happens.
    pub kind: ByteFaultKind,
    /// To which bytes.
    pub when: When,
}

/// All faults of a virtual lathe; by default none.
///
/// Read from words separated by commas, for example `drop@100,change@250,delay=50ms`:
///
/// | word | meaning |
/// |---|---|
/// | `drop@N`, `change@N`, `duplicate@N` | the Nth byte that reaches the lathe (from 1) is lost, has its lowest bit flipped, or arrives twice |
/// | `parity@N` | the Nth byte that reaches the lathe arrives with the wrong parity |
/// | `drop=P%`, `change=P%`, `duplicate=P%` | the same for every byte with a probability of P per cent |
/// | `answer-drop@N` and so on | the same for bytes that the lathe sends back |
/// | `seed=N` | which bytes a probability strikes; the same seed strikes the same bytes |
/// | `delay=T` | a pause after every 16 bytes either way; T as `50ms` or `2s` |
/// | `stall@N` | the lathe reads no more after N bytes |
/// | `unplug@N` | the connection is cut after N bytes |
/// | `reset@N` | the lathe is reset after N bytes: the program that is coming in is lost |
/// | `late-dc3@N` | a Fanuc sends DC3 N characters late; it has room for 16 |
/// | `silent` | the lathe takes programs and never sends anything |
/// | `truncate@N` | what the lathe sends back ends after N bytes |
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FaultSpec {
    /// Faults of bytes that reach the lathe.
    pub incoming: Vec<ByteFault>,
    /// Faults of bytes that the lathe sends back.
    pub answer: Vec<ByteFault>,
    /// Seed of the probabilities.
    pub seed: u64,
    /// Pause after every 16 bytes.
    pub delay: Option<Duration>,
    /// Reads no more after so many bytes.
    pub stall_after: Option<usize>,
    /// Cuts the connection after so many bytes.
    pub unplug_after: Option<usize>,
    /// Is reset after so many bytes.
    pub reset_after: Option<usize>,
    /// Sends DC3 so many characters late.
    pub late_dc3: Option<usize>,
    /// Never sends anything.
    pub silent: bool,
    /// Ends what it sends after so many bytes.
    pub truncate_after: Option<usize>,
}

/// A word of a fault specification that cannot be understood.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error(
    "The fault `{word}` is not understood: {why}. Possible are drop, change, duplicate and parity as drop@N or drop=P% \
     (for what the lathe sends back answer-drop and so on), seed=N, delay=T, stall@N, unplug@N, reset@N, late-dc3@N, \
     truncate@N and silent, separated by commas; N is a place in bytes from 1, P a probability in per cent from 0 to 100, T a time up to 60s such as 50ms or 2s."
)]
pub struct BadFault {
    /// The word.
    pub word: String,
    /// What is wrong with it.
    pub why: &'static str,
}

impl FromStr for FaultSpec {
    type Err = BadFault;

    fn from_str(text: &str) -> Result<Self, BadFault> {
        let mut spec = Self::default();
        for word in text.split(',').map(str::trim).filter(|word| !word.is_empty()) {
            spec.add(word).map_err(|why| BadFault { word: word.to_owned(), why })?;
        }
        Ok(spec)
    }
}

impl FaultSpec {
    fn add(&mut self, word: &str) -> Result<(), &'static str> {
        if word == "silent" {
            self.silent = true;
        } else if let Some((name, place)) = word.split_once('@') {
            self.add_at(name, place)?;
        } else if let Some((name, value)) = word.split_once('=') {
            self.add_value(name, value)?;
        } else {
            return Err("it has neither @ with a place nor = with a value");
        }
        Ok(())
    }

    fn add_at(&mut self, name: &str, place: &str) -> Result<(), &'static str> {
        let place = place.parse().ok().filter(|&place| place > 0).ok_or("its place is no whole number from 1")?;
        match name {
            "stall" => self.stall_after = Some(place),
            "unplug" => self.unplug_after = Some(place),
            "reset" => self.reset_after = Some(place),
            "late-dc3" => self.late_dc3 = Some(place),
            "truncate" => self.truncate_after = Some(place),
            _ => self.add_byte_fault(name, When::At(place))?,
        }
        Ok(())
    }

    fn add_value(&mut self, name: &str, value: &str) -> Result<(), &'static str> {
        match name {
            "seed" => self.seed = value.parse().map_err(|_| "its seed is no whole number from 0")?,
            "delay" => self.delay = Some(parse_time(value).ok_or("its time is not such as 50ms or 2s, up to 60s")?),
            _ => {
                let chance = parse_per_cent(value).ok_or("its probability is not between 0% and 100%")?;
                self.add_byte_fault(name, When::Chance(chance))?;
            }
        }
        Ok(())
    }

    fn add_byte_fault(&mut self, name: &str, when: When) -> Result<(), &'static str> {
        let (list, name) = match name.strip_prefix("answer-") {
            Some(rest) => (&mut self.answer, rest),
            None => (&mut self.incoming, name),
        };
        let kind = match name {
            "drop" => ByteFaultKind::Drop,
            "change" => ByteFaultKind::Change,
            "duplicate" => ByteFaultKind::Duplicate,
            "parity" => ByteFaultKind::Parity,
            _ => return Err("there is no fault of this name"),
        };
        list.push(ByteFault { kind, when });
        Ok(())
    }
}

fn parse_time(text: &str) -> Option<Duration> {
    /// Longer pauses look like a hang.
    const LONGEST: Duration = Duration::from_mins(1);
    let time = match text.strip_suffix("ms") {
        Some(number) => Duration::from_millis(number.parse().ok()?),
        None => Duration::from_secs(text.strip_suffix('s')?.parse().ok()?),
    };
    (time <= LONGEST).then_some(time)
}

fn parse_per_cent(text: &str) -> Option<f64> {
    let per_cent: f64 = text.strip_suffix('%')?.parse().ok()?;
    (0.0..=100.0).contains(&per_cent).then_some(per_cent / 100.0)
}

/// Applies byte faults to a stream of bytes.
pub(super) struct FaultLane {
    faults: Vec<ByteFault>,
    place: usize,
    random: u64,
}

impl FaultLane {
    pub(super) fn new(faults: &[ByteFault], seed: u64) -> Self {
        Self { faults: faults.to_vec(), place: 0, random: seed }
    }

    /// What becomes of the next byte, and how often it arrives.
    pub(super) fn pass(&mut self, mut byte: u8) -> (u8, usize) {
        self.place += 1;
        let mut copies = 1;
        for index in 0..self.faults.len() {
            let Some(fault) = self.faults.get(index).copied() else { break };
            let strikes = match fault.when {
                When::At(place) => place == self.place,
                When::Chance(chance) => self.random() < chance,
            };
            match fault.kind {
                _ if !strikes => {}
                ByteFaultKind::Drop => copies = 0,
                ByteFaultKind::Change => byte ^= 1,
                ByteFaultKind::Duplicate => copies *= 2,
                ByteFaultKind::Parity => byte = 0,
            }
        }
        (byte, copies)
    }

    /// The next number from 0 to 1 of the splitmix64 sequence.
    fn random(&mut self) -> f64 {
        self.random = self.random.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.random;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_what_is_documented() {
        let spec: FaultSpec = "drop@100, change@250,duplicate=0.5%,answer-drop@7,seed=3,unplug@500,silent,delay=50ms,\
                               truncate@9,stall@8,parity@4,reset@11,late-dc3@17"
            .parse()
            .unwrap();
        assert_eq!(spec.incoming.len(), 4);
        assert_eq!((spec.reset_after, spec.late_dc3), (Some(11), Some(17)));
        assert_eq!(spec.incoming[0], ByteFault { kind: ByteFaultKind::Drop, when: When::At(100) });
        assert_eq!(spec.incoming[2], ByteFault { kind: ByteFaultKind::Duplicate, when: When::Chance(0.005) });
        assert_eq!(spec.answer.len(), 1);
        assert_eq!((spec.seed, spec.silent, spec.unplug_after), (3, true, Some(500)));
        assert_eq!((spec.delay, spec.truncate_after), (Some(Duration::from_millis(50)), Some(9)));
        assert_eq!("".parse(), Ok(FaultSpec::default()));
    }

    #[test]
    fn bad_words_are_named_with_what_is_allowed() {
        for word in [
            "drop",
            "drop@0",
            "drop@x",
            "drop@-1",
            "explode@3",
            "drop=101%",
            "drop=NaN%",
            "drop=5",
            "delay=5",
            "delay=5h",
            "delay=61s",
            "seed=-1",
            "unplug=3",
            "silent@3",
            "answer-unplug@3",
        ] {
            let bad = format!("change@1,{word}").parse::<FaultSpec>().unwrap_err();
            assert!(bad.word == word && bad.to_string().contains("drop@N"), "{bad}");
        }
    }

    #[test]
    fn chances_follow_the_seed() {
        let struck = |seed| {
            let spec: FaultSpec = "drop=10%".parse().unwrap();
            let mut lane = FaultLane::new(&spec.incoming, seed);
            (0..1000).filter(|_| lane.pass(b'x').1 == 0).collect::<Vec<_>>()
        };
        assert_eq!(struck(1), struck(1));
        assert_ne!(struck(1), struck(2));
        assert!((50..200).contains(&struck(1).len()));
    }
}
