//! Plots: profile, cut, solid and thumbnails of a turned part, stations of a roll-forming line flat and in the round, former and roller of a shell.
//!
//! Plots take data in and give events out. They know neither the session nor the transfer and never edit a document.

mod canvas;
mod coordinates;
mod cut;
mod depth;
mod flower;
mod line_solid;
mod lines;
mod palette;
mod profile;
mod regions;
mod roll;
#[cfg(test)]
mod sample;
mod section;
mod shell;
mod solid;
mod station;
mod thumbnail;
mod time_bar;
mod tip;
mod tool_picture;

pub use canvas::CanvasView;
pub use coordinates::{Coordinates, fixed};
pub use cut::{CutEvent, CutScene, CutView, clock, cut_plot};
pub use flower::{FlowerEvent, FlowerPlotView, FlowerScene, flower_plot};
pub(crate) use line_solid::line_shortening;
pub use line_solid::{LineSolidView, LineSubject, line_solid};
pub use palette::{LeftoverClass, Palette};
pub use profile::{Dimension, End, NodeMove, Phase, ProfileEvent, ProfileScene, ProfileView, SectionEnd, profile_plot};
pub use roll::{RollPlotEvent, RollScene, roll_plot};
pub use section::{SectionEvent, SectionScene, section_plot};
pub use shell::{ShellEvent, ShellPlot, ShellScene, shell_plot};
pub use solid::{SolidScene, SolidView, solid_view};
pub use station::{StationEvent, StationScene, StationView, station_plot};
pub use thumbnail::{flower_thumbnail, thumbnail};
pub use time_bar::{TimeShare, time_bar};
pub use tool_picture::tool_picture;
