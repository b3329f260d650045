//! The headless commands and the transfer as a user meets them: files, ports, and what goes wrong on a line.

mod cli;
mod cli_transfer;
mod transfer_faults;
