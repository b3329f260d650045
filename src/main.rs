//! The `turnwright` command: the window, or a headless command.

fn main() {}
