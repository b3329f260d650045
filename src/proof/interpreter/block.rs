//! Runs one block: its words in the order in which the controls obey them.

use super::codes::{G, meaning};
use super::state::Motion;
use super::{Next, Run};
use crate::cancel::Cancelled;
use crate::machine::{Dialect, ToolWord};
use crate::proof::findings::Breach;
use crate::proof::reader::words::{Number, WordBlock};
use crate::proof::report::FindingKind;
use crate::proof::step::Step;
use crate::units::{MM_PER_INCH, Unit};

/// The words of a block, each of which must be taken by something.
pub(super) struct Taken<'t> {
    block: &'t WordBlock,
    /// One bit a letter.
    taken: u32,
}

impl<'t> Taken<'t> {
    pub(super) fn of(block: &'t WordBlock) -> Self {
        Self { block, taken: 0 }
    }

    fn bit(letter: char) -> u32 {
        1 << (u32::from(letter).wrapping_sub(u32::from('A')) % 32)
    }

    /// The number behind a letter, which has then been taken.
    pub(super) fn take(&mut self, letter: char) -> Option<Number> {
        self.taken |= Self::bit(letter);
        self.block.number(letter)
    }

    /// True if the block has this letter.
    pub(super) fn has(&self, letter: char) -> bool {
        self.block.has(letter)
    }

    /// The numbers behind a letter.
    fn take_all(&mut self, letter: char) -> Vec<Number> {
        self.taken |= Self::bit(letter);
        self.block.all(letter).collect()
    }

    /// Letters that nothing has taken.
    fn left(&self) -> impl Iterator<Item = (char, Number)> + '_ {
        self.block.words.iter().filter(|w| self.taken & Self::bit(w.letter) == 0).map(|w| (w.letter, w.number))
    }

    /// True if it has words for the axes.
    pub(super) fn moves(&self) -> bool {
        ['X', 'Z', 'U', 'W'].into_iter().any(|letter| self.has(letter))
    }
}

/// Meanings of the M words of a block.
#[derive(Debug, Default)]
#[allow(clippy::struct_excessive_bools, reason = "each stands for an M word of its own")]
pub(super) struct Ms {
    /// The tool is changed.
    pub change: bool,
    stop_spindle: bool,
    end: bool,
    call: bool,
    back: bool,
}

impl Run<'_, '_> {
    /// Runs the block at `index` and says where the program goes on.
    pub(super) fn block(&mut self, index: usize) -> Result<Next, Cancelled> {
        let block = &self.tape.blocks[index];
        if block.flow.is_some() {
            return Ok(self.flow(index));
        }
        let mut words = Taken::of(block);
        let begun = self.begun;
        self.begun |= !block.is_empty();
        if words.take('O').is_some() && begun && !self.calls.is_entry(index) {
            return Ok(self.runs_into_next_program());
        }
        let codes = self.codes(&mut words);
        if codes.contains(&G::PathControl) {
            words.take('P');
            words.take('Q');
        }
        let ms = self.ms(&mut words);
        self.modal(&codes);
        self.numbers(&codes, &mut words);
        self.tool_words(&codes, &ms, &mut words);
        let next = self.act(&codes, &mut words)?;
        if ms.stop_spindle {
            self.state.turning = false;
        }
        let next = if ms.call || ms.back { self.call_or_return(index, ms.call, &mut words) } else { next };
        let left: Vec<String> = words.left().map(|(letter, n)| format!("{letter}{}", n.plain())).collect();
        if !left.is_empty() {
            self.unreadable(format!("{} has no meaning in this block.", left.join(" and ")));
        }
        if ms.end {
            self.end_compensation()?;
            return Ok(Next::End);
        }
        Ok(next.unwrap_or(Next::Block(index + 1)))
    }

    /// The meanings of the block's G words.
    fn codes(&mut self, words: &mut Taken<'_>) -> Vec<G> {
        let mut codes: Vec<G> = Vec::new();
        for number in words.take_all('G') {
            let tenths = number.plain() * 10.0;
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked to be whole and small")]
            let known = (tenths.fract() == 0.0 && (0.0..10_000.0).contains(&tenths))
                .then(|| meaning(tenths as u32, self.control.machine.dialect, self.control.words))
                .flatten();
            let Some(code) = known else {
                self.unreadable(format!("G{} is not known to the control or not computed here.", number.plain()));
                continue;
            };
            if let Some(other) = codes.iter().find(|c| c.group() == code.group() && c.group() > 0 && **c != code) {
                let message =
                    format!("G{} and another G word of its group exclude each other ({other:?}).", number.plain());
                self.unreadable(message);
            }
            codes.push(code);
        }
        codes
    }

    /// Takes the M words; those that switch something on do so before the block moves.
    fn ms(&mut self, words: &mut Taken<'_>) -> Ms {
        let mut ms = Ms::default();
        let linuxcnc = self.control.machine.dialect == Dialect::Linuxcnc;
        for number in words.take_all('M') {
            let Some(m) = number.whole() else {
                self.unreadable(format!("M{} is not a whole number.", number.plain()));
                continue;
            };
            match m {
                0 | 1 | 7 | 8 | 9 => {}
                2 | 30 => ms.end = true,
                3 | 4 => self.spindle_on(m),
                5 => ms.stop_spindle = true,
                6 if self.control.words.tool_word == ToolWord::Change => ms.change = true,
                98 if !linuxcnc => ms.call = true,
                99 if !linuxcnc => ms.back = true,
                // Overrides on and off.
                48 | 49 if linuxcnc => {}
                // Chuck, tailstock, turret direction, thread run-out and parts catcher, as published for the 6T.
                10..=13 | 17..=24 | 73 | 74 if !linuxcnc => {}
                _ if self.select_range(m) => {}
                // Gears of a machine whose file names none.
                40..=44 if self.control.machine.spindle.ranges.is_empty() && !linuxcnc => {}
                _ => self.unreadable(format!("M{m} is not known to the control.")),
            }
        }
        ms
    }

    fn spindle_on(&mut self, m: u32) {
        self.state.turning = true;
        let reverse = &self.control.words.codes.spindle_reverse;
        if reverse.trim_start_matches('M').parse() == Ok(m) {
            let forward = &self.control.words.codes.spindle_on;
            let message = format!(
                "M{m} turns the spindle the wrong way round for the tools of this turret; {forward} is its word."
            );
            let breach = Breach::error("reverse", FindingKind::OutsideLimits, f64::from(m), 0.0, message);
            self.find(breach.into_warning());
        }
    }

    fn select_range(&mut self, m: u32) -> bool {
        let code = |text: &str| text.trim_start_matches('M').parse() == Ok(m);
        let found = self.control.machine.spindle.ranges.iter().position(|range| code(&range.code));
        if found.is_some() {
            self.state.range = found;
        }
        found.is_some()
    }

    fn modal(&mut self, codes: &[G]) {
        for code in codes {
            match *code {
                G::Motion(motion) => self.state.motion = motion,
                G::Unit(unit) => self.state.unit = Some(unit),
                G::Absolute(absolute) => self.state.absolute = absolute,
                G::Diameter(diameter) => {
                    self.state.diameter = diameter;
                    self.state.diameter_said = true;
                }
                G::ArcCenter(center) => self.state.arc_center = center,
                G::PerRev(per_rev) => {
                    if self.state.per_rev != per_rev {
                        self.state.feed = None;
                    }
                    self.state.per_rev = per_rev;
                }
                G::Surface(surface) => {
                    // A speed of the other kind does not go on; a control keeps turning as fast as it does.
                    if self.state.surface != surface {
                        self.state.speed = None;
                    }
                    self.state.surface = surface;
                }
                _ => {}
            }
        }
    }

    /// F, S and D.
    fn numbers(&mut self, codes: &[G], words: &mut Taken<'_>) {
        let threads = codes.contains(&G::ThreadCycle)
            || matches!(self.state.motion, Motion::Thread | Motion::ThreadCycle)
                && !codes.iter().any(|c| c.group() == 11);
        if !threads && let Some(feed) = words.take('F') {
            self.state.feed = Some(self.feed(feed));
        }
        if codes.contains(&G::Surface(true))
            && self.control.machine.dialect == Dialect::Linuxcnc
            && let Some(limit) = words.take('D')
        {
            self.state.clamp = Some(limit.plain());
        }
        let Some(s) = words.take('S') else { return };
        if codes.contains(&G::Preset) && self.control.machine.dialect != Dialect::Linuxcnc {
            self.state.clamp = Some(s.plain());
            return;
        }
        self.state.speed = Some(self.speed(s));
    }

    /// Feed in mm.
    fn feed(&mut self, number: Number) -> f64 {
        let words = self.control.words;
        let decimals = if self.state.per_rev { words.feed_per_rev_decimals } else { words.feed_per_min_decimals };
        let value = if self.control.machine.dialect == Dialect::Linuxcnc {
            number.plain()
        } else {
            number.in_increments(decimals, words)
        };
        value * self.state.mm_per_unit()
    }

    /// Cutting speed in m/min, or rev/min.
    fn speed(&mut self, number: Number) -> f64 {
        if self.state.surface {
            // In inch mode the cutting speed is in feet per minute.
            let feet = 12.0 * MM_PER_INCH / 1000.0;
            return number.plain() * if self.state.unit == Some(Unit::Inch) { feet } else { 1.0 };
        }
        let table = &self.control.words.speed_codes;
        if table.is_empty() {
            return number.plain();
        }
        let step = number.whole().and_then(|code| table.iter().find(|s| s.code == code));
        if let Some(step) = step {
            return step.rpm;
        }
        let codes = table.iter().map(|s| s.code.to_string()).collect::<Vec<_>>().join(", ");
        self.unreadable(format!("S{} is no step of the spindle; its steps are {codes}.", number.plain()));
        0.0
    }

    /// What the block does once its modal words are in force.
    fn act(&mut self, codes: &[G], words: &mut Taken<'_>) -> Result<Option<Next>, Cancelled> {
        if let Some(G::Compensate(side)) = codes.iter().find(|c| matches!(c, G::Compensate(_))) {
            self.compensate(*side)?;
        }
        if let Some(G::CompensateBy(side)) = codes.iter().find(|c| matches!(c, G::CompensateBy(_))) {
            self.compensate_by(*side, words)?;
        }
        let machine_coordinates = codes.contains(&G::MachineCoordinates);
        let once = codes.iter().find(|c| c.group() == 11);
        match once {
            Some(G::Dwell) => self.dwell(words)?,
            Some(G::Preset) => self.preset(words)?,
            Some(G::PresetOff) => self.preset_off()?,
            Some(G::Home) => self.home(words)?,
            Some(G::Finish) => self.finish_cycle(words)?,
            Some(G::Rough { facing }) => return self.rough_cycle(*facing, words),
            Some(G::Pattern) => return self.pattern_cycle(words),
            Some(G::Peck { groove }) => self.peck_cycle(*groove, words)?,
            Some(G::ThreadCycle) => self.thread_cycle(words)?,
            _ if machine_coordinates => self.machine_coordinates(words)?,
            _ => self.motion(codes, words)?,
        }
        Ok(None)
    }

    fn dwell(&mut self, words: &mut Taken<'_>) -> Result<(), Cancelled> {
        let linuxcnc = self.control.machine.dialect == Dialect::Linuxcnc;
        let seconds = if linuxcnc {
            words.take('P').map(|p| p.plain())
        } else {
            // X and U in seconds, P in milliseconds.
            let x = words.take('X').or(words.take('U')).map(|x| x.in_increments(3, self.control.words));
            x.or(words.take('P').map(|p| p.plain() / 1000.0))
        };
        match seconds {
            Some(seconds) if seconds >= 0.0 => self.step(Step::Pause(seconds)),
            Some(seconds) => {
                self.control_error("dwell", seconds, 0.0, format!("A dwell of {seconds} s is less than no time."));
                Ok(())
            }
            None => {
                self.control_error("dwell", 0.0, 0.0, "The dwell has no time.".to_owned());
                Ok(())
            }
        }
    }
}
