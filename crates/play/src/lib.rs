//! State and transitions of a simulation operated by a visitor. No DOM, no clock: the shell calls [`Play::tick`] with the
//! elapsed seconds and draws what the getters return.
//!
//! | folder | contents |
//! |---|---|
//! | `basis` | the program in the language of the visitor, parsing of typed values |
//! | `time` | the run, its time line and clock, kept runs |
//! | `plots` | figures of the run and of kept runs, points and plots added by other crates |
//! | `values` | readouts, values of the scene, table of rows |
//! | `controls` | views of parameters, presets, buttons and drawn curves; what a drag reaches |
//! | `questions` | answers and their grades |
//! | `survey` | answers to the survey, and the file with them |
//! | `claims` | claims of the author and their results |
//! | `play` | the wiring of these parts: operations of the visitor, links, replacing the program |
//! | `share` | documents of links, pages in other pages |
//!
//! An operation on a part returns [`Changes`]. [`Play`] folds them into its [`Revision`].
//!
//! A [`Refusal`] is returned for input that cannot be accepted; the state is then unchanged. Getters that return texts use
//! the chosen language. No method panics; an index that does not exist is ignored or refused.

mod announcement;
mod basis;
mod changes;
mod claims;
mod controls;
mod facts;
mod play;
mod plots;
mod questions;
mod refusal;
mod seat;
mod share;
mod survey;
mod time;
mod values;
pub mod words;

pub use engine;
pub use figure;
pub use program;
pub use units::{Language, name_of, number};

pub use announcement::{Announcement, Prominence};
pub use basis::Basis;
pub use basis::input::DIGITS;
pub use changes::{Changes, Revision};
pub use claims::{ClaimView, Claims, ClaimsView, Deviation, deviation, deviation_svg};
pub use controls::{
    ButtonView, ChoiceView, Controls, DrawingView, Grips, MethodView, ParameterGroup, ParameterView, PresetGroup,
    PresetView, SizeView, Slider,
};
pub use facts::{Fact, FactValue};
pub use play::share::Extent;
pub use play::{Passed, Play};
pub use plots::{AddedPlot, AddedSeries, Figures, Labels, LegendEntry, PlotId, PlotView, Plots, Points, points_colour};
pub use questions::{Answer, AnswerView, Answers, Attempt, Grade, Verdict};
pub use refusal::Refusal;
pub use seat::SeatView;
pub use share::{Embedding, LONGEST_PACKED, LONGEST_UNPACKED, Link, PagePart, Subject, packed_length};
pub use survey::{Survey, SurveyView};
pub use time::{
    Course, KeptValues, KeptView, LONGEST_GAP, MOST_KEPT, Problem, SPEEDS, Status, TimeLine, WORK_PER_TICK,
};
pub use values::{Follows, Index, Members, Outline, Readout, ReadoutKind, Shown, StateView, Values, symbol};
