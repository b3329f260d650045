//! What a person does in the window, and what becomes of document, files and picture; drawn without a GPU.

#![cfg(feature = "gui")]
#![allow(clippy::expect_used, clippy::panic, clippy::unwrap_used, reason = "a test fails by panicking")]

mod bore;
mod common;
mod desk;
mod files;
mod flower;
mod operations;
mod pictures;
mod plan;
mod roll_editor;
mod rolls;
mod rolls_dark;
mod rolls_first;
mod rolls_nonsense;
mod shell;
