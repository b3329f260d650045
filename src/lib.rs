//! Turnwright: from a dragged dimension of a turned part, a set of form-rolls or a flow-turned shell to a proved NC program on
//! the lathe.
//!
//! The way of an edit: `Document` → [`regen`] → `Derived` → window, files, NC text → [`proof`] → [`transfer`].
//!
//! Modules, from the top down; nothing points up:
//!
//! | module | duty |
//! |---|---|
//! | `app` | the window; the only place that knows egui (feature `gui`) |
//! | `cli` | the headless commands (in the binary) |
//! | [`session`], [`worker`] | document, undo history, newest `Derived`; the thread that makes it |
//! | [`storage`] | documents, recovery, imports, exports |
//! | [`transfer`] | links, protocols and the virtual lathe |
//! | [`output`] | the files that a build writes |
//! | [`papers`] | drawing and setup sheet as pages, PDF, SVG, DXF and HP-GL |
//! | [`regen`] | document to everything derived, in stages |
//! | [`proof`] | the second opinion: program readers, stock removal, findings, times |
//! | [`post`] | cutter location data to program text |
//! | [`turning`] | generators: set-up to cutter location data |
//! | [`spinning`] | flow-turning: former, wall, roller path, process rules, published controller, rigs, program and its proof |
//! | [`document`] | what is edited and saved |
//! | [`rollform`] | cross-section, flower and rolls of a forming line |
//! | [`part`] | section table to exact profile, checks |
//! | [`machine`] | machines, tools and materials as data |
//! | [`geometry`] | points, line and arc segments, contours |
//! | [`diagnostic`], [`units`], [`cancel`], [`textfile`], `replace` | messages, units, cancelling, reading text, replacing files |
//!
//! Spaces and units: mm and radians inside; degrees and the document's unit at the edges. Part space has `z` along the
//! spindle, growing away from the chuck, and `r` as a radius. The proof shares nothing with generators and posts but
//! geometry, machine data and the shape of the data.

#[cfg(feature = "gui")]
pub mod app;
pub mod cancel;
pub mod diagnostic;
pub mod document;
pub mod geometry;
pub mod machine;
pub mod output;
pub mod papers;
pub mod part;
pub mod post;
pub mod proof;
pub mod regen;
mod replace;
pub mod rollform;
pub mod session;
pub mod spinning;
pub mod storage;
pub mod textfile;
pub mod transfer;
pub mod turning;
pub mod units;
pub mod worker;
