//! The compiled form of a document, without source text and source positions: equations as a graph, drawing, plots,
//! presets, questions, survey, checks and finished prose. The engine runs it; [`bundle`] writes and reads it.

mod assigned;
mod bandwidth;
pub mod bundle;
mod chance;
mod checks;
pub mod functions;
mod graph;
mod method;
mod model;
mod plots;
mod presets;
mod program;
mod prose;
mod questions;
mod scene;
mod seating;
mod speed;
mod survey;
mod version;

pub use assigned::{Assigned, Grid, GridFault, Seat};
pub use bandwidth::{band_width, banded_order, bandwidth, places};
pub use chance::binomial;
pub use checks::{Check, Claim, Moment, Relation, Sides, Test};
pub use graph::{
    Binary, Course, Entry, Graph, Interpolation, LinearSystem, Node, NodeId, OfDrawing, Unary, Variable, along,
    differentiate, differentiate_all,
};
pub use method::{Method, UnknownMethod};
pub use model::{
    Button, Choices, Compared, Compiled, Dependence, Drawn, Event, Held, Independent, Jump, Kind, Model, Parameter,
    Quantity, Role, Sensitive, Size, Slope, Slopes, State, Switch, Table, Timed,
};
pub use plots::{Aggregate, AggregateKind, Curve, Drawing, Every, Members, Outcomes, Plot, Profile, Sweep, Taken};
pub use presets::{Assignment, Preset};
pub use program::{Edition, Program};
pub use prose::{Block, Section};
pub use questions::{Question, QuestionText, Tolerance};
pub use scene::{Attribute, Child, Drag, Dragged, Element, Piece, Scene, Template, Trail, write_attribute};
pub use speed::Speed;
pub use survey::{SurveyItem, SurveyKind, SurveyText};
pub use version::{BITS, VERSION, VERSION_AND_BITS};
