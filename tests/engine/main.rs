//! Everything without window and port: importers, planner, posts, proof, form-rolls, shells and papers, held against published
//! data, against readers of their own and against LinuxCNC's interpreter.
//!
//! One program for all, since each test program carries the whole library. `cargo test --test engine planner::` runs one file's.

#![allow(clippy::expect_used, clippy::panic, clippy::unwrap_used, reason = "a test fails by panicking")]
#![allow(clippy::print_stdout, reason = "tables of what was compared are for people to read")]
#![allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "small whole numbers of the tests")]

mod bad_input;
mod bad_roll_sets;
mod bad_shells;
mod changed_bytes;
mod cut_by;
mod facing;
mod fanuc_listing;
mod linuxcnc_judge;
mod mutants;
mod orac_listing;
mod papers;
mod pecking;
mod plan_edits;
mod planned_against_published;
mod planner;
mod planner_sets;
mod planner_stages;
mod published_flow_turning;
mod published_generator;
mod regen;
mod rolfom_listing;
mod roll_set_import;
mod roll_sets;
mod shells;
mod support;
mod word_post;
mod words_scan;
