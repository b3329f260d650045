//! The headless commands and the transfer as a user meets them: files, ports, and what goes wrong on a line.

#![allow(clippy::expect_used, clippy::panic, clippy::unwrap_used, reason = "a test fails by panicking")]
#![allow(clippy::print_stdout, reason = "tables of what was compared are for people to read")]

mod cli;
mod cli_shells;
mod cli_transfer;
mod transfer_faults;
