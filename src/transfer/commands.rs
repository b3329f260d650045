//! `send`, `receive` and `lathe` for the command line. Nothing is printed here: events go to the caller.

use super::job::{Event, Job, Outcome, Request, Task, Timing};
use super::ports::Target;
use super::virtual_lathe::VirtualLathe;
pub use super::virtual_lathe::{PtyOptions, run_on_pty as lathe};
use crate::cancel::Cancel;
use crate::machine::Delivery;

/// The line that a command uses.
#[derive(Debug, Clone, Copy)]
pub struct Line<'a> {
    /// Port as given: `virtual`, or a device path or name; for a control with a folder, that folder.
    pub port: &'a str,
    /// How programs reach the control.
    pub delivery: &'a Delivery,
    /// Do not keep to the speed of the line.
    pub unpaced: bool,
    /// How long to wait for what.
    pub timing: Timing,
}

/// Sends the program `text`; with `verify`, waits until the control sends them back and compares.
pub fn send(
    name: &str,
    text: &str,
    verify: bool,
    line: Line<'_>,
    on_event: &mut dyn FnMut(&Event),
    cancel: &Cancel,
) -> Outcome {
    run(Task::Send { name: name.to_owned(), text: text.to_owned(), verify }, line, on_event, cancel)
}

/// Receives a program. A virtual control is asked to send (a lone DC1); at any other the operator starts the transfer.
pub fn receive(line: Line<'_>, on_event: &mut dyn FnMut(&Event), cancel: &Cancel) -> Outcome {
    run(Task::Receive, line, on_event, cancel)
}

fn run(task: Task, line: Line<'_>, on_event: &mut dyn FnMut(&Event), cancel: &Cancel) -> Outcome {
    let target = Target::named(line.port, line.delivery, &VirtualLathe::default());
    let mut request = Request::new(task, target);
    request.unpaced = line.unpaced;
    request.timing = line.timing;
    Job::start(request, cancel, || ()).run_to_end(on_event)
}
