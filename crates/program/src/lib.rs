//! The compiled form of a document, without source text and source positions: what the engine runs and a page shows.
//!
//! [`Program`] holds the [`Model`] (equations as an expression [`Graph`]), the scene tree, plots, presets, questions, survey,
//! checks, method, and one [`Edition`] of finished prose for each language. [`functions`] has the functions of the language
//! and the rules for their dimensions. Evaluation, symbolic derivatives and [`Model::with_sensitivities`] are here too.
//! [`bundle`] writes a program as bytes and reads it.
//!
//! - **Invariant:** no source text, no spans, no parsers.
//! - **Invariant:** [`bundle::read`] checks every index, so that a damaged or hostile bundle cannot make the engine read
//!   outside its model.
//! - **Invariant:** `graph/evaluate.rs` alone defines the value of each operation.
//! - **Invariant:** a change that moves the bits of a result raises [`BITS`] and adds a line to `crates/probe/bits.txt`.
//!
//! ```
//! use program::{Graph, Node};
//!
//! let mut graph = Graph::default();
//! let (two, three, x) = (graph.constant(2.0), graph.constant(3.0), graph.insert(Node::State(0)));
//! let six = graph.multiply(two, three);
//! assert_eq!(graph.as_constant(six), Some(6.0));
//! // Equal expressions are one node.
//! assert_eq!(graph.add(x, six), graph.add(six, x));
//! ```

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
pub use questions::{
    ChoiceAnswer, NumberAnswer, OptionText, Question, QuestionKind, QuestionText, Tolerance, WrongValue,
};
pub use scene::{Attribute, Child, Drag, Dragged, Element, Piece, Scene, Template, Trail, write_attribute};
pub use speed::Speed;
pub use survey::{SurveyItem, SurveyKind, SurveyText};
pub use version::{BITS, VERSION, VERSION_AND_BITS};
