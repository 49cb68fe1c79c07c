//! The checked model: a system of first-order equations and everything that can be shown of it.

mod compared;
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

use crate::{Graph, NodeId};
use serde::{Deserialize, Serialize};
use units::{Dimension, Unit};

/// Nodes of the expression graph with all its derivatives. Documents come from strangers, and a short text can ask for an
/// enormous computation; no honest model comes near this.
const MOST_NODES: usize = 500_000;

/// A checked model, lowered to first order. Values are SI unless a [`Unit`] is named.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Model {
    /// The independent variable.
    pub independent: Independent,
    /// In the order of the text.
    pub parameters: Vec<Parameter>,
    /// In the order of the text.
    pub sizes: Vec<Size>,
    /// Each variable's orders stand together, lowest first: y, y', z, z'.
    pub states: Vec<State>,
    /// Named definitions, in the order of the text.
    pub quantities: Vec<Quantity>,
    /// In the order of the text.
    pub tables: Vec<Table>,
    /// In the order of the text.
    pub events: Vec<Event>,
    /// In the order of the text.
    pub buttons: Vec<Button>,
    /// The expressions.
    pub graph: Graph,
    /// The texts that nodes of kind [`Kind::Text`] index.
    pub texts: Vec<String>,
    /// What is known of sensitivities, in a model that has them among its states ([`Model::with_sensitivities`]).
    pub sensitive: Option<Sensitive>,
}

/// The independent variable, `t` in seconds unless stated.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Independent {
    /// Its name.
    pub name: String,
    /// Its unit.
    pub unit: Unit,
    /// Whether it counts 0, 1, 2 ...: nothing flows, and a run has one row at each count.
    pub counts: bool,
}

/// A number the user can change.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Parameter {
    /// Its ASCII name.
    pub name: String,
    /// The author's label, if any.
    pub label: Option<String>,
    /// The heading under which its control stands, if any.
    pub group: Option<String>,
    /// The declared unit.
    pub unit: Unit,
    /// The default, SI.
    pub value: f64,
    /// Least and greatest value, SI.
    pub range: Option<(f64, f64)>,
    /// The slider's step, SI.
    pub step: Option<f64>,
    /// Whether an initial value depends on it: a change restarts the run.
    pub restarts: bool,
    /// What the user can choose.
    pub choices: Choices,
}

/// What values a parameter can have.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Choices {
    /// Numbers.
    Numbers,
    /// On (1) or off (0).
    Switch,
    /// A whole number that decides all random draws.
    Seed,
    /// One of these texts, the default first: indices into [`Model::texts`], which are also its values.
    Texts(Vec<u32>),
}

impl Parameter {
    /// What its value is.
    pub fn kind(&self) -> Kind {
        match self.choices {
            Choices::Numbers | Choices::Seed => Kind::Number,
            Choices::Switch => Kind::Truth,
            Choices::Texts(_) => Kind::Text,
        }
    }

    /// Whether its value is a number, and no word stands for it.
    pub fn is_number(&self) -> bool {
        matches!(self.choices, Choices::Numbers | Choices::Seed)
    }

    /// Whether it can have a value (SI), its range aside.
    pub fn takes(&self, value: f64) -> bool {
        match &self.choices {
            Choices::Numbers => value.is_finite(),
            Choices::Seed => value.floor() == value && (0.0..9_007_199_254_740_992.0).contains(&value),
            Choices::Switch => value == 0.0 || value == 1.0,
            Choices::Texts(texts) => texts.iter().any(|&text| f64::from(text) == value),
        }
    }

    /// The value that a word stands for: `on` or `off`, or one of the texts; `None` for numbers and other words.
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

    /// The words for all values, `on` and `off` or the texts; none for numbers.
    pub fn words<'a>(&self, texts: &'a [String]) -> Vec<&'a str> {
        match &self.choices {
            Choices::Numbers | Choices::Seed => Vec::new(),
            Choices::Switch => vec!["on", "off"],
            Choices::Texts(own) => {
                own.iter().filter_map(|&text| texts.get(text as usize)).map(String::as_str).collect()
            }
        }
    }

    /// The word for a value; `None` for a number.
    pub fn word<'a>(&self, value: f64, texts: &'a [String]) -> Option<&'a str> {
        match &self.choices {
            Choices::Numbers | Choices::Seed => None,
            Choices::Switch => Some(if value == 0.0 { "off" } else { "on" }),
            Choices::Texts(_) => texts.get(value as usize).map(String::as_str),
        }
    }
}

/// A whole number that decides how many members families have. It is part of what the model was built from: another value
/// needs another model.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Size {
    /// Its ASCII name.
    pub name: String,
    /// The author's label, if any.
    pub label: Option<String>,
    /// Its value.
    pub value: u32,
    /// The value that the document's text states.
    pub stated: u32,
    /// Least and greatest value.
    pub range: Option<(u32, u32)>,
}

/// One first-order state.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// The variable without primes, `y`.
    pub variable: String,
    /// How many primes: 0 for y, 1 for y'.
    pub order: u32,
    /// The author's label on its initial value, if any.
    pub label: Option<String>,
    /// The display unit: stated, or SI.
    pub unit: Unit,
    /// Its value at the start; depends on parameters only.
    pub initial: NodeId,
    /// What it is there for.
    pub role: Role,
    /// Its rate of change: the next state, or the solution of the equations for the highest derivative.
    pub derivative: NodeId,
}

/// What a state is there for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Role {
    /// It is one of the author's quantities.
    Own,
    /// It is one of them that the author keeps out of the readouts.
    Hidden,
    /// The run keeps in it what it remembers ([`Quantity::remembered`]).
    Remembered,
    /// It says how a body with dry friction moves: 1 forwards, -1 backwards, 0 while it sticks.
    Friction,
}

impl State {
    /// How the names of states end that a run keeps for a name of the author's: `maximum(x) so far` for `maximum(x)`.
    pub const SO_FAR: &str = " so far";

    /// Its variable, or the author's name for which a run keeps it.
    pub fn kept_for(&self) -> &str {
        self.variable.strip_suffix(Self::SO_FAR).unwrap_or(&self.variable)
    }

    /// `y''`
    pub fn name(&self) -> String {
        let mut name = self.variable.clone();
        name.extend(std::iter::repeat_n('\'', self.order as usize));
        name
    }
}

/// A named definition.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Quantity {
    /// Its ASCII name.
    pub name: String,
    /// The author's label, if any.
    pub label: Option<String>,
    /// Its value and unit.
    pub value: Compiled,
    /// Whether it depends on states or the independent variable; if not, it is constant while parameters are.
    pub varies: bool,
    /// Whether the author keeps it out of the readouts.
    pub hidden: bool,
    /// Whether it is what a run remembers, such as `landing.x` or `maximum(y)`, and none of the author's own.
    pub remembered: bool,
}

/// A function that is given by a table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Table {
    /// Its ASCII name.
    pub name: String,
    /// The author's label, if any.
    pub label: Option<String>,
    /// What its argument is called.
    pub argument: String,
    /// The unit of its argument.
    pub argument_unit: Unit,
    /// The unit of its values.
    pub unit: Unit,
    /// Its place in [`Graph::interpolations`].
    pub interpolation: u32,
    /// What the reader may draw, if the curve is the reader's.
    pub drawn: Option<Drawn>,
}

/// An expression compiled against a model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Compiled {
    /// Its node.
    pub node: NodeId,
    /// What it is.
    pub kind: Kind,
    /// The display unit: stated, or that of the name it consists of, or SI. Dimensionless unless `kind` is a number.
    pub unit: Unit,
}

impl Compiled {
    /// Its dimension.
    pub fn dimension(&self) -> Dimension {
        self.unit.dimension
    }
}

/// What an expression's value is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Kind {
    /// A number with a dimension.
    Number,
    /// 0 or 1.
    Truth,
    /// An index into [`Model::texts`].
    Text,
}

/// A sudden change of the state.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Event {
    /// Fires when this goes from 0 to 1.
    pub condition: NodeId,
    /// Which states change, and to what.
    pub actions: Vec<(u32, NodeId)>,
    /// The author's label or name for it, if any.
    pub title: Option<String>,
    /// Whether the title is a label, which can be translated, and no name.
    pub is_labelled: bool,
    /// Whether it ends the run.
    pub stops: bool,
    /// How sensitivities change, in a model that has them ([`Model::with_sensitivities`]).
    pub jump: Option<Jump>,
}

impl Event {
    /// One without a name that does not end the run.
    pub fn new(condition: NodeId, actions: Vec<(u32, NodeId)>) -> Self {
        Self { condition, actions, title: None, is_labelled: false, stops: false, jump: None }
    }
}

/// A button for the reader of the document: each press of it is an event.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Button {
    /// What stands on it.
    pub title: String,
    /// The author's name for its event, if any.
    pub name: Option<String>,
    /// Which of [`Model::events`]; its condition is never true.
    pub event: u32,
}

/// What a model with sensitivities knows of them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sensitive {
    /// How many of the states, the first, are the model's own.
    pub states: usize,
    /// By how many parameters there are sensitivities.
    pub parameters: usize,
    /// The switches of the equations at which these jump, each with the derivative of its moment by each parameter, at the
    /// state before.
    pub delays: Vec<(NodeId, Vec<NodeId>)>,
}

/// How the sensitivities of a model change at an event. With S states of the model itself and P parameters, the model with
/// sensitivities has n = S (1 + P) states.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Jump {
    /// The derivative of the event's moment by each parameter, at the state before all events of the moment.
    pub delays: Vec<NodeId>,
    /// The sensitivities after the event, states S to n. They read n + P states: the n that the events before this one have
    /// left, and the P delays.
    pub sensitivities: Vec<NodeId>,
}
