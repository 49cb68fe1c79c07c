//! State and transitions of a simulation operated by a visitor. No DOM, no clock: the shell calls [`TimeLine::tick`]
//! with the elapsed seconds and draws what the getters return.
//!
//! | folder | contents |
//! |---|---|
//! | `basis` | the program in the language of the visitor, parsing of typed values |
//! | `time` | the run, its time line and clock, kept runs |
//! | `plots` | figures of the run and of kept runs, points and plots added by other crates |
//! | `values` | readouts, values of the scene, table of rows |
//! | `controls` | parameters, presets, states, method and step, buttons and drawn curves; dragging in the scene |
//! | `questions` | answers and their grades |
//! | `survey` | answers to the survey, and the file with them |
//! | `claims` | claims of the author and their results |
//! | `share` | links with the state and their documents, pages in other pages, passing a simulation on |
//! | `replacement` | what of a program is kept when another one replaces it |
//!
//! [`Play`] (`play.rs`) is the wiring of these parts. An operation on a part returns [`Changes`]; [`Play`] folds them into
//! its [`Revision`]: `play.change_run(|line, _| line.scrub(1.0))`.
//!
//! A [`Refusal`] is returned for input that cannot be accepted; the state is then unchanged. Getters that return texts use
//! the chosen language. No method panics; an index that does not exist is ignored or refused.
//!
//! - **Invariant:** no data, no fits, no parsers, no DOM. Time comes in as [`TimeLine::tick`]; getters return what is shown.
//! - **Invariant:** a refused input changes nothing and returns a [`Refusal`]. The one exception, a link that cannot be
//!   restored in full, has a variant of its own. Everything in a link has a limit, and all its runs share one budget of work.

mod announcement;
mod basis;
mod changes;
mod claims;
mod controls;
mod facts;
mod motion;
mod open_run;
mod picture;
mod play;
mod plots;
mod questions;
mod refusal;
mod removed;
mod replacement;
mod seat;
mod share;
mod survey;
mod time;
mod values;
pub mod words;

pub use engine;
pub use figure;
pub use handed;
pub use program;
pub use units::{Language, name_of, number};

pub use announcement::{Announcement, Prominence};
pub use basis::Basis;
pub use basis::input::DIGITS;
pub use changes::{Changes, Outcome, Revision};
pub use claims::{ClaimView, Claims, ClaimsView, Deviation, deviation, deviation_svg};
pub use controls::{
    ButtonView, ChoiceView, Controls, DrawingView, Grips, MethodView, ParameterGroup, ParameterView, PresetGroup,
    PresetView, SceneLevel, Settings, SizeView, Slider,
};
pub use facts::{UNKNOWN_GRADE, facts_of_answers, facts_of_run};
pub use open_run::OpenRun;
pub use picture::scene_svg;
pub use play::Play;
pub use plots::{AddedPlot, AddedSeries, Figures, Labels, LegendEntry, PlotId, PlotView, Plots, Points, points_colour};
pub use plots::{SweepComputation, SweepNews, SweepWork, SweepWorkers, TakenRun};
pub use questions::{Answer, AnswerView, Answers, Attempt, Conditions, Grade, GradedAttempt, Limit, Marker, Verdict};
pub use refusal::Refusal;
pub use removed::Removals;
pub use seat::SeatView;
pub use share::{
    Embedding, Extent, LONGEST_PACKED, LONGEST_UNPACKED, Link, PagePart, Passed, Subject, missing_in_link,
    packed_length,
};
pub use survey::{Survey, SurveyView};
pub use time::{
    Course, KeptValues, KeptView, LONGEST_GAP, MOST_KEPT, Problem, SPEEDS, Status, TimeLine, WORK_PER_TICK,
};
pub use values::{
    Follows, Index, Members, Outline, Readout, ReadoutKind, Shown, ShownScene, StateView, Values, symbol,
};
