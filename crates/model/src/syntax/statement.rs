//! Statements.

use super::expression::{Expression, Over};
use super::name::{Name, Quoted, StatedUnit};
use crate::Span;
use program::Course;

/// One statement of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// What it states.
    pub kind: StatementKind,
    /// `hidden m = rho*L`: whether a definition is kept out of the readouts.
    pub hidden: bool,
    /// `for i in 1..N`: the indices for each of whose values it is stated; none of a statement that stands for itself.
    pub over: Vec<Over>,
    /// The quoted label that ends it, such as `"Damping"`.
    pub label: Option<Quoted>,
    /// Where it stands, without its comment.
    pub span: Span,
}

/// The kinds of statement.
#[derive(Clone, Debug, PartialEq)]
pub enum StatementKind {
    /// `parameter b = 50 [kg/s] in 0..20000 step 1`
    Parameter(ParameterStatement),
    /// `choice liquid "Liquid" { "Water": rho = 998.2 [kg/m^3] }`
    Choice(ChoiceStatement),
    /// `group "Circuit"`: the heading of the controls of the parameters after it, up to the next group.
    Group(Quoted),
    /// `size N = 20 in 2..200`
    Size(SizeStatement),
    /// `independent x in [m]`, `independent k by 1`
    Independent {
        /// The independent variable.
        name: Name,
        /// Its unit; dimensionless without one.
        unit: Option<StatedUnit>,
        /// `by 1`: it counts.
        counts: bool,
    },
    /// `m = rho*S*L in [kg]`
    Definition {
        /// What is defined.
        name: Name,
        /// Its value.
        value: Expression,
        /// The stated unit.
        unit: Option<StatedUnit>,
    },
    /// `y'(0) = v_0 in [cm/s]`
    InitialValue {
        /// The variable.
        name: Name,
        /// How many primes.
        order: u32,
        /// Its value at the start.
        value: Expression,
        /// The stated unit, which is also the display unit of the state.
        unit: Option<StatedUnit>,
    },
    /// `x[i](0) = A*sin(pi*i/(N + 1)) in [cm]`, `s[i] = s[i-1] + x[i]`, `discrete n[i] = 0`
    Members {
        /// What the members are.
        what: Members,
        /// Those that are meant: an [`ExpressionKind::Member`] without primes, unless it is an initial value.
        left: Expression,
        /// Their value.
        value: Expression,
        /// The stated unit.
        unit: Option<StatedUnit>,
    },
    /// `discrete n = 0 in [cm]`
    Discrete {
        /// What only events change.
        name: Name,
        /// Its value at the start.
        value: Expression,
        /// The stated unit, which is also the display unit.
        unit: Option<StatedUnit>,
        /// The equation that it stands for: its derivative, and 0.
        rate: Box<[Expression; 2]>,
    },
    /// `function Re(v, d) = rho*abs(v)*d/eta`
    Function(FunctionStatement),
    /// `table eta(T) in [mPa s] { 273 [K] 1.792  293 1.002 }`
    Table(TableStatement),
    /// `rho*S*L*y'' + b*y' + 2*rho*S*g*y = 0`. Two [`ExpressionKind::Error`] stand for a statement that could not be
    /// read at all, which may have been of any kind.
    Equation {
        /// The left side.
        left: Expression,
        /// The right side.
        right: Expression,
    },
    /// `when y < 0 [m] { y' = -e*y' }`
    Event {
        /// Fires when this becomes true.
        condition: Expression,
        /// What it changes, all from the values before the event.
        actions: Vec<Action>,
        /// Its name, names of its own, and whether it ends the run.
        extras: EventExtras,
    },
}

/// What an event may have besides its condition and actions.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EventExtras {
    /// `as landing`
    pub name: Option<Name>,
    /// `let u = e*y'`: names inside the event, for values before it. They have no primes.
    pub names: Vec<Action>,
    /// `every 0.1 [s] from 0 [s]` in the place of a condition: the interval, and when the first may be.
    pub every: Option<Box<(Expression, Option<Expression>)>>,
    /// `stop`: it ends the run.
    pub stop: Option<Span>,
    /// `next p = r*p*(1 - p)` in the place of a condition: it acts at each count.
    pub next: bool,
    /// `button "Kick"` in the place of a condition: it acts when the reader presses the button with this title.
    pub button: Option<Quoted>,
}

/// What the members of a family are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Members {
    /// Each is defined by an expression.
    Definitions,
    /// Each is an unknown, and this is its value at the start.
    InitialValues,
    /// Each is changed by events only, and this is its value at the start.
    Discrete,
}

/// `size N = 20 in 2..200`: a whole number that decides how many members families have.
#[derive(Clone, Debug, PartialEq)]
pub struct SizeStatement {
    /// The size.
    pub name: Name,
    /// Its value.
    pub value: u32,
    /// Where the value stands.
    pub value_span: Span,
    /// `in LOW..HIGH`
    pub range: Option<Bounds>,
}

/// The parts of a parameter statement. Numbers in `range` and `step` are bare, in the declared unit.
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterStatement {
    /// The parameter.
    pub name: Name,
    /// The default value in the declared unit, with its sign. NaN where it or its unit could not be read: a diagnostic
    /// has said so, and the parameter fits any dimension.
    pub value: f64,
    /// Where the value stands.
    pub value_span: Span,
    /// The declared unit; dimensionless without one.
    pub unit: Option<StatedUnit>,
    /// `in LOW..HIGH`
    pub range: Option<Bounds>,
    /// `step S`: the slider's, in the declared unit.
    pub step: Option<f64>,
    /// What it can be.
    pub form: ParameterForm,
}

/// What a parameter can be.
#[derive(Clone, Debug, PartialEq)]
pub enum ParameterForm {
    /// `parameter b = 50 [kg/s]`: a number.
    Number,
    /// `switch drag = on`: the value is 1 or 0.
    Switch,
    /// `random seed = 1`: a whole number that decides all random draws.
    Seed,
    /// `choice liquid { ... }`: one of these texts; the value is the number of the one.
    Choice(Vec<String>),
}

impl ParameterForm {
    /// What its value is.
    pub(crate) fn kind(&self) -> program::Kind {
        match self {
            Self::Number | Self::Seed => program::Kind::Number,
            Self::Switch => program::Kind::Truth,
            Self::Choice(_) => program::Kind::Text,
        }
    }
}

/// The parts of `choice liquid "Liquid" { "Water": rho = 998.2 [kg/m^3] }`.
#[derive(Clone, Debug, PartialEq)]
pub struct ChoiceStatement {
    /// What the reader chooses.
    pub name: Name,
    /// The label, which stands before the brace.
    pub label: Option<Quoted>,
    /// What there is to choose from.
    pub alternatives: Vec<Alternative>,
}

/// One of the alternatives of a choice.
#[derive(Clone, Debug, PartialEq)]
pub struct Alternative {
    /// What the reader sees.
    pub text: Quoted,
    /// What it defines.
    pub values: Vec<ChosenValue>,
}

/// `hidden rho = 998.2 [kg/m^3] "Density"`, as in an alternative.
#[derive(Clone, Debug, PartialEq)]
pub struct ChosenValue {
    /// What gets the value.
    pub name: Name,
    /// The value.
    pub value: Expression,
    /// The stated unit.
    pub unit: Option<StatedUnit>,
    /// What the reader sees; one alternative gives it for all.
    pub label: Option<Quoted>,
    /// Whether it is kept out of the readouts; one alternative says it for all.
    pub hidden: bool,
}

/// `b = 2*m*omega_0 in [kg/s]`, as in a preset.
#[derive(Clone, Debug, PartialEq)]
pub struct Assignment {
    /// What gets the value.
    pub name: Name,
    /// The value.
    pub value: Expression,
    /// The stated unit.
    pub unit: Option<StatedUnit>,
}

/// The parts of a function of the author's own.
#[derive(Clone, Debug, PartialEq)]
pub struct FunctionStatement {
    /// The function.
    pub name: Name,
    /// What its arguments are called in `body`.
    pub parameters: Vec<Name>,
    /// Its value.
    pub body: Expression,
    /// The stated unit of its value.
    pub unit: Option<StatedUnit>,
}

/// The parts of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct TableStatement {
    /// The function.
    pub name: Name,
    /// What its argument is called.
    pub argument: Name,
    /// How it goes from point to point.
    pub course: Course,
    /// The label, where it stands before the brace.
    pub label: Option<Quoted>,
    /// The unit of the argument, which stands behind the first number; dimensionless without one.
    pub argument_unit: Option<StatedUnit>,
    /// The unit of the values: stated, or else behind the first value.
    pub unit: Option<StatedUnit>,
    /// In the units of their columns.
    pub points: Vec<Point>,
    /// `drawn in -5..5 until 10 [s]`: what the reader may draw.
    pub drawn: Option<DrawnRange>,
}

/// What the reader may draw in the place of a table. The numbers are in the units of its columns.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnRange {
    /// The least and the greatest value.
    pub bounds: Bounds,
    /// The least argument.
    pub from: f64,
    /// The greatest argument.
    pub until: f64,
    /// Where the greatest argument stands.
    pub until_span: Span,
}

/// A point of a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// The argument.
    pub x: f64,
    /// The value.
    pub y: f64,
    /// Where both stand.
    pub span: Span,
}

/// `LOW..HIGH` and where.
#[derive(Clone, Debug, PartialEq)]
pub struct Bounds {
    /// The least value.
    pub low: f64,
    /// The greatest value.
    pub high: f64,
    /// Where it stands.
    pub span: Span,
}

/// `y' = -e*y'` inside an event.
#[derive(Clone, Debug, PartialEq)]
pub struct Action {
    /// The variable.
    pub name: Name,
    /// The indices of a member of a family; none of what stands for itself.
    pub indices: Vec<Expression>,
    /// Which component of a vector that is a member of a family, from 0; those of other vectors are part of the name.
    pub component: Option<usize>,
    /// How many primes.
    pub order: u32,
    /// Its value after the event.
    pub value: Expression,
    /// `for i in 1..N`: the indices for each of whose values it acts.
    pub over: Vec<Over>,
}

impl Statement {
    /// A statement without a label that stands for itself.
    pub(crate) fn of(kind: StatementKind, span: Span) -> Self {
        Self { kind, hidden: false, over: Vec::new(), label: None, span }
    }
}

impl Action {
    /// What happens to a quantity that is no member of a family.
    pub(crate) fn of(name: Name, order: u32, value: Expression) -> Self {
        Self { name, indices: Vec::new(), component: None, order, value, over: Vec::new() }
    }
}

impl StatementKind {
    /// A quantity that only events change, with the equation that it stands for.
    pub(crate) fn discrete(name: Name, value: Expression, unit: Option<StatedUnit>) -> Self {
        let rate = [Expression::derivative(&name.text, 1, name.span), Expression::number(0.0, name.span)];
        Self::Discrete { name, value, unit, rate: Box::new(rate) }
    }
}
