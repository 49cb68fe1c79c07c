//! What a visitor does with a simulation, as plain state and transitions. No DOM, no clock: the shell calls [`Play::tick`]
//! with the seconds that have passed and draws what the getters return.
//!
//! | folder | what it holds |
//! |---|---|
//! | `time` | the run, its time line and clock |
//! | `controls` | parameters, presets, buttons, states, dragging, method and step, and how typed values are read |
//! | `plots` | figures of the run, of kept runs, of points and plots that others add |
//! | `values` | readouts, the scene's values, the table of rows |
//! | `questions` | answers and what they are worth |
//! | `checks.rs` | claims of the author, and whether they hold |
//! | `replacement` | another program in the place of the present one |
//! | `share` | the state as a link |
//!
//! A [`Refusal`] is the answer to input that cannot be taken; nothing has changed then. Getters that return texts use
//! the chosen language. No method panics; an index that does not exist is ignored or refused.

mod announcement;
mod checks;
mod controls;
mod deviation;
mod name;
mod play;
mod plots;
mod questions;
mod refusal;
mod removed;
mod replacement;
mod share;
mod time;
mod undo;
mod values;
pub mod words;

pub use engine;
pub use figure;
pub use program;
pub use units::{Language, number};

pub use announcement::{Announcement, Prominence};
pub use checks::{ClaimView, ClaimsView};
pub use controls::{
    ButtonView, ChoiceView, DIGITS, DrawingView, MethodView, ParameterGroup, ParameterView, PresetGroup, PresetView,
    SizeView, Slider, StateView,
};
pub use deviation::Deviation;
pub use name::name_of;
pub use play::{Play, Revision};
pub use plots::{
    AddedPlot, AddedSeries, KeptView, Labels, LegendEntry, MOST_KEPT, PlotId, PlotView, Points, points_colour,
};
pub use questions::{Answer, AnswerView, Grade, Verdict};
pub use refusal::Refusal;
pub use share::{Embedding, LONGEST_PACKED, LONGEST_UNPACKED, Link, PagePart, Subject, packed_length};
pub use time::{Course, LONGEST_GAP, Problem, SPEEDS, Status, WORK_PER_TICK};
pub use values::{Follows, Index, Members, Outline, Readout, ReadoutKind, symbol};
