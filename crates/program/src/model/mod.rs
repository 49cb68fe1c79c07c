//! The checked model: a system of first-order equations, with quantities, tables, events and buttons.

mod assigned;
mod compared;
mod continuity;
mod drawings;
mod drawn;
mod lookup;
mod motion;
mod sensitivity;
mod slopes;
mod switches;
mod whole;

pub use compared::Compared;
pub use drawn::Drawn;
pub use lookup::Dependence;
pub use slopes::{Slope, Slopes};
pub use switches::{Held, Switch, Timed};

use crate::{Assigned, Graph, NodeId};
use serde::{Deserialize, Serialize};
use units::{Dimension, Unit};

/// Maximum number of nodes of the graph with its derivatives. Documents come from strangers, and a short text can demand an
/// enormous computation; reasonable models stay far below.
const MOST_NODES: usize = 500_000;

/// A checked model, reduced to first order. Values are in SI units unless a [`Unit`] is given.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Model {
    /// The independent variable.
    pub independent: Independent,
    /// The parameters, in the order of the text.
    pub parameters: Vec<Parameter>,
    /// The sizes, in the order of the text.
    pub sizes: Vec<Size>,
    /// The states of each variable are adjacent, lowest order first: y, y', z, z'.
    pub states: Vec<State>,
    /// Named definitions, in the order of the text.
    pub quantities: Vec<Quantity>,
    /// The tables, in the order of the text.
    pub tables: Vec<Table>,
    /// The events, in the order of the text.
    pub events: Vec<Event>,
    /// The buttons, in the order of the text.
    pub buttons: Vec<Button>,
    /// All expressions of the model.
    pub graph: Graph,
    /// Texts to which values of kind [`Kind::Text`] refer by index.
    pub texts: Vec<String>,
    /// Data on sensitivities, in a model that has them among its states ([`Model::with_sensitivities`]).
    pub sensitive: Option<Sensitive>,
}

/// The independent variable; by default `t` in seconds.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Independent {
    /// Name, `t` by default.
    pub name: String,
    /// Display unit.
    pub unit: Unit,
    /// True if it counts 0, 1, 2 ... (discrete time): a run has one row per count.
    pub counts: bool,
}

/// A parameter: a value that the user can change.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Parameter {
    /// ASCII name.
    pub name: String,
    /// Label given by the author, if any.
    pub label: Option<String>,
    /// Heading of the group of its control, if any.
    pub group: Option<String>,
    /// Declared unit.
    pub unit: Unit,
    /// Default value, SI units.
    pub value: f64,
    /// Minimum and maximum value, SI units.
    pub range: Option<(f64, f64)>,
    /// Step of the slider, SI units.
    pub step: Option<f64>,
    /// True if an initial value depends on it: a change restarts the run.
    pub restarts: bool,
    /// Kind of values the user can choose.
    pub choices: Choices,
    /// True if readers do not see it; see [`Parameter::is_shown`].
    pub hidden: bool,
    /// Values for the seats of a class.
    pub assigned: Option<Assigned>,
}

/// Kind of values of a parameter.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Choices {
    /// Any finite number.
    Numbers,
    /// A switch: on (1) or off (0).
    Switch,
    /// Seed of all random draws, an integer from 0 to 2^53 - 1.
    Seed,
    /// One of these texts, the default first. The values are indices in [`Model::texts`].
    Texts(Vec<u32>),
}

impl Parameter {
    /// Kind of its value.
    pub fn kind(&self) -> Kind {
        match self.choices {
            Choices::Numbers | Choices::Seed => Kind::Number,
            Choices::Switch => Kind::Truth,
            Choices::Texts(_) => Kind::Text,
        }
    }

    /// True if its value is shown as a number, not as a word.
    pub fn is_number(&self) -> bool {
        matches!(self.choices, Choices::Numbers | Choices::Seed)
    }

    /// True if this value (SI units) is possible, regardless of the range.
    pub fn takes(&self, value: f64) -> bool {
        match &self.choices {
            Choices::Numbers => value.is_finite(),
            Choices::Seed => value.floor() == value && (0.0..9_007_199_254_740_992.0).contains(&value),
            Choices::Switch => value == 0.0 || value == 1.0,
            Choices::Texts(texts) => texts.iter().any(|&text| f64::from(text) == value),
        }
    }

    /// Value of a word: `on` or `off`, or one of the texts. `None` for numbers and other words.
    pub fn chosen(&self, word: &str, texts: &[String]) -> Option<f64> {
        match &self.choices {
            Choices::Numbers | Choices::Seed => None,
            Choices::Switch => match word {
                "on" | "true" => Some(1.0),
                "off" | "false" => Some(0.0),
                _ => None,
            },
            Choices::Texts(own) => {
                let is_meant = |text: &&u32| texts.get(**text as usize).is_some_and(|text| text == word);
                own.iter().find(is_meant).map(|&text| f64::from(text))
            }
        }
    }

    /// Words of all values: `on` and `off`, or the texts; empty for numbers.
    pub fn words<'a>(&self, texts: &'a [String]) -> Vec<&'a str> {
        match &self.choices {
            Choices::Numbers | Choices::Seed => Vec::new(),
            Choices::Switch => vec!["on", "off"],
            Choices::Texts(own) => {
                own.iter().filter_map(|&text| texts.get(text as usize)).map(String::as_str).collect()
            }
        }
    }

    /// Word of a value; `None` for numbers.
    pub fn word<'a>(&self, value: f64, texts: &'a [String]) -> Option<&'a str> {
        match &self.choices {
            Choices::Numbers | Choices::Seed => None,
            Choices::Switch => Some(if value == 0.0 { "off" } else { "on" }),
            Choices::Texts(_) => texts.get(value as usize).map(String::as_str),
        }
    }
}

/// An integer that determines the number of members of families. The model is built for this value; another value needs
/// another model.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Size {
    /// ASCII name.
    pub name: String,
    /// Label given by the author, if any.
    pub label: Option<String>,
    /// Current value.
    pub value: u32,
    /// Value stated in the document.
    pub stated: u32,
    /// Minimum and maximum value.
    pub range: Option<(u32, u32)>,
}

/// A state of the first-order system.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// Variable without primes, `y`.
    pub variable: String,
    /// Order of the derivative: 0 for y, 1 for y'.
    pub order: u32,
    /// Label given by the author to the initial value, if any.
    pub label: Option<String>,
    /// Display unit: as stated, or SI.
    pub unit: Unit,
    /// Initial value; depends on parameters only.
    pub initial: NodeId,
    /// Purpose of the state.
    pub role: Role,
    /// Rate of change: the next state, or the highest derivative.
    pub derivative: NodeId,
}

/// Purpose of a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Role {
    /// A variable of the author.
    Own,
    /// A variable that the author hides from the readouts.
    Hidden,
    /// Storage for values that the run remembers ([`Quantity::remembered`]).
    Remembered,
    /// Motion of a body with dry friction: 1 forwards, -1 backwards, 0 while it sticks.
    Friction,
}

impl State {
    /// Suffix of the names of states that store a running value: `maximum(x) so far` for `maximum(x)`.
    pub const SO_FAR: &str = " so far";

    /// Name of the variable, or of the author's expression whose running value it stores.
    pub fn kept_for(&self) -> &str {
        self.variable.strip_suffix(Self::SO_FAR).unwrap_or(&self.variable)
    }

    /// Name with primes, `y''`.
    pub fn name(&self) -> String {
        let mut name = self.variable.clone();
        name.extend(std::iter::repeat_n('\'', self.order as usize));
        name
    }
}

/// A named definition of the author, or a remembered value.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Quantity {
    /// ASCII name.
    pub name: String,
    /// Label given by the author, if any.
    pub label: Option<String>,
    /// Compiled value with its unit.
    pub value: Compiled,
    /// True if it depends on states or the independent variable; otherwise it is constant while parameters are.
    pub varies: bool,
    /// True if the author hides it from the readouts.
    pub hidden: bool,
    /// True if it is a value that the run remembers, such as `landing.x` or `maximum(y)`, not a definition of the author.
    pub remembered: bool,
}

/// A function given by a table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Table {
    /// ASCII name.
    pub name: String,
    /// Label given by the author, if any.
    pub label: Option<String>,
    /// Name of the argument.
    pub argument: String,
    /// Unit of the argument.
    pub argument_unit: Unit,
    /// Unit of the values.
    pub unit: Unit,
    /// Index in [`Graph::interpolations`].
    pub interpolation: u32,
    /// Range and default of the curve if the reader draws it.
    pub drawn: Option<Drawn>,
}

/// An expression compiled for a model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Compiled {
    /// Node in the graph of the model.
    pub node: NodeId,
    /// Kind of the value.
    pub kind: Kind,
    /// Display unit: as stated, or that of the name if the expression is a name, or SI. Dimensionless unless `kind` is a
    /// number.
    pub unit: Unit,
}

impl Compiled {
    /// Dimension of the unit.
    pub fn dimension(&self) -> Dimension {
        self.unit.dimension
    }
}

/// Kind of the value of an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Kind {
    /// A number with a dimension.
    Number,
    /// A truth value, 0 or 1.
    Truth,
    /// A text, as index in [`Model::texts`].
    Text,
}

/// A sudden change of the state.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Event {
    /// Condition; the event fires when it goes from 0 to 1.
    pub condition: NodeId,
    /// Actions: index of a state, and its new value.
    pub actions: Vec<(u32, NodeId)>,
    /// Label or name given by the author, if any.
    pub title: Option<String>,
    /// True if the title is a label, which can be translated, not a name.
    pub is_labelled: bool,
    /// True if the event ends the run.
    pub stops: bool,
    /// Jump of the sensitivities, in a model that has them ([`Model::with_sensitivities`]).
    pub jump: Option<Jump>,
}

impl Event {
    /// An event without title that does not end the run.
    pub fn new(condition: NodeId, actions: Vec<(u32, NodeId)>) -> Self {
        Self { condition, actions, title: None, is_labelled: false, stops: false, jump: None }
    }
}

/// A button for the reader; each press is an event.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Button {
    /// Text on the button.
    pub title: String,
    /// Name given by the author to the event, if any.
    pub name: Option<String>,
    /// Index in [`Model::events`] of its event, whose condition is never true.
    pub event: u32,
}

/// Structure of a model with sensitivities.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sensitive {
    /// Number of states without sensitivities; they come first.
    pub states: usize,
    /// Number of parameters with sensitivities.
    pub parameters: usize,
    /// Switches at which the equations jump, each with the derivatives of its moment with respect to each parameter, at the
    /// state before it.
    pub delays: Vec<(NodeId, Vec<NodeId>)>,
}

/// Jump of the sensitivities at an event. With S states of the model itself and P parameters, the model with sensitivities
/// has n = S (1 + P) states.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Jump {
    /// Derivatives of the moment of the event, one per parameter, at the state before all events of the moment.
    pub delays: Vec<NodeId>,
    /// Sensitivities after the event, states S to n. They read n + P states: the n states left by the previous events, then
    /// the P delays.
    pub sensitivities: Vec<NodeId>,
}
