//! ASSEMBLE: instruction files to programs that the control's memory can hold.
//!
//! Files are put one after the other into a program while they fit; each further program repeats the start instructions, and
//! each is closed by the end instruction. A file too long for one program is divided (`divide`).
//!
//! For automatic machining the turret and the part handling are told what to do over the auxiliary channels. The published
//! package sends such signals in front of every tool change and of the end; the channels are ours: channel 1 to 8 stand for
//! the eight positions of the turret, channel 9 for the end of the program. Each signal switches its output on, waits for the
//! input of the same number (done), and switches the output off.

use super::divide::{Part, divide};
use super::files::InstructionFile;
use super::instruction::Instruction;
use crate::turning::OperationKind;

/// Channel that tells the part handling that the program ends.
const END_CHANNEL: i32 = 9;

/// One block of a program with the operation that it belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Block {
    pub(super) instruction: Instruction,
    pub(super) operation: Option<OperationKind>,
    pub(super) operation_index: Option<usize>,
}

impl Block {
    /// A block of a program's start or end.
    const fn frame(instruction: Instruction) -> Self {
        Self { instruction, operation: None, operation_index: None }
    }
}

/// The programs made of `files`, none longer than `limit` blocks.
pub(super) fn assemble(files: &[InstructionFile], limit: usize, automatic: bool) -> Vec<Vec<Block>> {
    let is_start = |i: &&Instruction| {
        use Instruction::{Abs, Inc, Inch, Mm, Pdat};
        matches!(i, Inc | Abs | Mm | Inch | Pdat { .. })
    };
    let Some(first) = files.first() else { return Vec::new() };
    let start: Vec<Instruction> = first.instructions.iter().take_while(is_start).copied().collect();
    let mut assembler = Assembler { start, limit, automatic, turret: None, current: Vec::new(), programs: Vec::new() };
    for (k, file) in files.iter().enumerate() {
        let skip = if k == 0 { assembler.start.len() } else { 0 };
        let body = file.instructions.iter().skip(skip).filter(|i| !matches!(i, Instruction::End));
        assembler.add(&body.copied().collect::<Vec<_>>(), file);
    }
    assembler.close();
    assembler.programs
}

struct Assembler {
    start: Vec<Instruction>,
    limit: usize,
    automatic: bool,
    /// Tool that the turret is known to hold.
    turret: Option<i32>,
    current: Vec<Block>,
    programs: Vec<Vec<Block>>,
}

impl Assembler {
    /// Adds the body of a file, divided if it is too long for a program of its own.
    fn add(&mut self, body: &[Instruction], file: &InstructionFile) {
        let room = self.room_for_a_file();
        let parts = if body.len() <= room { vec![Part::whole(body)] } else { divide(body, room) };
        for part in parts {
            self.add_part(&part.instructions, file);
        }
    }

    fn add_part(&mut self, body: &[Instruction], file: &InstructionFile) {
        let Some(tool) = body.iter().find_map(Instruction::tool) else { return };
        if self.current.len() + self.signals(tool).len() + body.len() + self.ending().len() > self.limit {
            self.close();
        }
        if self.current.is_empty() {
            self.current = self.start.iter().map(|&instruction| Block::frame(instruction)).collect();
        }
        let blocks = self.signals(tool).into_iter().chain(body.iter().copied());
        let (operation, operation_index) = (file.operation, file.operation_index);
        self.current.extend(blocks.map(|instruction| Block { instruction, operation, operation_index }));
        self.turret = Some(tool);
    }

    /// Ends the current program; the turret's position is not relied on by the next one.
    fn close(&mut self) {
        if self.current.is_empty() {
            return;
        }
        let ending = self.ending();
        self.current.extend(ending.into_iter().map(Block::frame));
        self.programs.push(std::mem::take(&mut self.current));
        self.turret = None;
    }

    /// Blocks that a program has for moves beside its start, one tool change and its end.
    fn room_for_a_file(&self) -> usize {
        let change = if self.automatic { signal(0).len() } else { 0 };
        self.limit.saturating_sub(self.start.len() + change + self.ending().len())
    }

    /// Signals in front of the moves of `tool`.
    fn signals(&self, tool: i32) -> Vec<Instruction> {
        if self.automatic && self.turret != Some(tool) { signal(tool).to_vec() } else { Vec::new() }
    }

    fn ending(&self) -> Vec<Instruction> {
        let signals = if self.automatic { signal(END_CHANNEL).to_vec() } else { Vec::new() };
        signals.into_iter().chain([Instruction::End]).collect()
    }
}

/// Ask over a channel, wait for the answer, and take the question back.
const fn signal(channel: i32) -> [Instruction; 3] {
    [Instruction::Oxua { channel, state: 1 }, Instruction::Ixua { channel }, Instruction::Oxua { channel, state: 0 }]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(number: usize, tool: i32, moves: usize) -> InstructionFile {
        let line = Instruction::Ptp { x: 0, z: 1, feed: 80, tool, rpm: 100 };
        let start = [Instruction::Inc, Instruction::Mm, Instruction::Pdat { x: 1, z: 1 }];
        let head = if number == 1 { &start[..] } else { &[] };
        let instructions = head.iter().copied().chain(std::iter::repeat_n(line, moves)).collect();
        InstructionFile { number, operation: None, operation_index: None, instructions }
    }

    fn lengths(programs: &[Vec<Block>]) -> Vec<usize> {
        programs.iter().map(Vec::len).collect()
    }

    #[test]
    fn files_share_a_program_while_they_fit() {
        let queen = [file(1, 1, 88), file(2, 1, 25), file(3, 1, 0), file(4, 2, 26), file(5, 2, 17)];
        assert_eq!(lengths(&assemble(&queen, 99, false)), [92, 72], "the published pages of the queen");
        let full = [file(1, 1, 50), file(2, 1, 45)];
        assert_eq!(lengths(&assemble(&full, 99, false)), [99]);
        assert_eq!(lengths(&assemble(&full, 98, false)), [54, 49]);
    }

    #[test]
    fn every_program_repeats_the_start_and_ends() {
        for program in assemble(&[file(1, 1, 90), file(2, 1, 40)], 99, false) {
            assert_eq!(program[0].instruction, Instruction::Inc);
            assert_eq!(program[program.len() - 1].instruction, Instruction::End);
        }
    }

    #[test]
    fn signals_stand_in_front_of_every_tool_change_and_of_the_end() {
        let programs = assemble(&[file(1, 1, 2), file(2, 1, 1), file(3, 2, 1)], 99, true);
        let summary: Vec<String> = programs[0].iter().skip(3).map(|b| b.instruction.summary()).collect();
        let change = |n: i32| [format!("OXUA {n} STATE 1"), format!("IXUA {n}"), format!("OXUA {n} STATE 0")];
        let cut = |t: i32| format!("PTP X 0.000 Z 0.001 F 80 T{t} S100");
        let mut expected = change(1).to_vec();
        expected.extend([cut(1), cut(1), cut(1)]);
        expected.extend(change(2));
        expected.push(cut(2));
        expected.extend(change(9));
        expected.push("END".into());
        assert_eq!(summary, expected);
    }
}
