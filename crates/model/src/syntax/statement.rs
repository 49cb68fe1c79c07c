//! Statements.

use super::expression::{Expression, Over};
use super::name::{Name, Quoted, StatedUnit};
use crate::Span;
use program::Course;

/// One statement of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// Kind of statement.
    pub kind: StatementKind,
    /// `hidden m = rho*L`: true if the quantity is left out of the readouts.
    pub hidden: bool,
    /// `for i in 1..N`: indices for whose values the statement is repeated; empty for a single statement.
    pub over: Vec<Over>,
    /// Quoted label at its end, such as `"Damping"`.
    pub label: Option<Quoted>,
    /// Place in the source, without the comment.
    pub span: Span,
}

/// The kinds of statement.
#[derive(Clone, Debug, PartialEq)]
pub enum StatementKind {
    /// `parameter b = 50 [kg/s] in 0..20000 step 1`
    Parameter(ParameterStatement),
    /// `choice liquid "Liquid" { "Water": rho = 998.2 [kg/m^3] }`
    Choice(ChoiceStatement),
    /// `group "Circuit"`: heading of the controls of the parameters after it, up to the next group.
    Group(Quoted),
    /// `size N = 20 in 2..200`
    Size(SizeStatement),
    /// `independent x in [m]`, `independent k by 1`
    Independent {
        /// The independent variable.
        name: Name,
        /// Its unit; dimensionless without one.
        unit: Option<StatedUnit>,
        /// `by 1`: true for a discrete independent variable.
        counts: bool,
    },
    /// `m = rho*S*L in [kg]`
    Definition {
        /// Name of the quantity.
        name: Name,
        /// Its value.
        value: Expression,
        /// The stated unit.
        unit: Option<StatedUnit>,
    },
    /// `y'(0) = v_0 in [cm/s]`
    InitialValue {
        /// Name of the variable.
        name: Name,
        /// Derivative order: the number of primes.
        order: u32,
        /// Initial value.
        value: Expression,
        /// The stated unit, which is also the display unit of the state.
        unit: Option<StatedUnit>,
    },
    /// `x[i](0) = A*sin(pi*i/(N + 1)) in [cm]`, `s[i] = s[i-1] + x[i]`, `discrete n[i] = 0`
    Members {
        /// Kind of the members.
        what: Members,
        /// Left side: an [`crate::ExpressionKind::Member`], without primes except in an initial value.
        left: Expression,
        /// Value of each member.
        value: Expression,
        /// The stated unit.
        unit: Option<StatedUnit>,
    },
    /// `discrete n = 0 in [cm]`
    Discrete {
        /// Name of the quantity, which only events change.
        name: Name,
        /// Initial value.
        value: Expression,
        /// The stated unit, which is also the display unit.
        unit: Option<StatedUnit>,
        /// Equivalent equation: its derivative, and 0.
        rate: Box<[Expression; 2]>,
    },
    /// `function Re(v, d) = rho*abs(v)*d/eta`
    Function(FunctionStatement),
    /// `table eta(T) in [mPa s] { 273 [K] 1.792  293 1.002 }`
    Table(TableStatement),
    /// `rho*S*L*y'' + b*y' + 2*rho*S*g*y = 0`. Two [`crate::ExpressionKind::Error`] stand for an unreadable statement of
    /// any kind.
    Equation {
        /// The left side.
        left: Expression,
        /// The right side.
        right: Expression,
    },
    /// `when y < 0 [m] { y' = -e*y' }`
    Event {
        /// Condition; the event fires when it becomes true.
        condition: Expression,
        /// Assignments; all read the values before the event.
        actions: Vec<Action>,
        /// Name, local names and other optional parts.
        extras: EventExtras,
    },
}

/// Optional parts of an event.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EventExtras {
    /// `as landing`
    pub name: Option<Name>,
    /// `let u = e*y'`: local names for values before the event. They have no primes.
    pub names: Vec<Action>,
    /// `every 0.1 [s] from 0 [s]` instead of a condition: the interval, and the earliest time.
    pub every: Option<Box<(Expression, Option<Expression>)>>,
    /// `stop`: the event ends the run.
    pub stop: Option<Span>,
    /// `next p = r*p*(1 - p)` instead of a condition: true if the event fires at each count.
    pub next: bool,
    /// `button "Kick"` instead of a condition: title of the button that fires the event.
    pub button: Option<Quoted>,
}

/// Kind of the members of a family.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Members {
    /// Definitions: each member is given by an expression.
    Definitions,
    /// Unknowns; the value is the initial value.
    InitialValues,
    /// Discrete quantities, changed only by events; the value is the initial value.
    Discrete,
}

/// `size N = 20 in 2..200`: an integer that sets the number of members of families.
#[derive(Clone, Debug, PartialEq)]
pub struct SizeStatement {
    /// The size.
    pub name: Name,
    /// Its value.
    pub value: u32,
    /// Place of the value.
    pub value_span: Span,
    /// `in LOW..HIGH`
    pub range: Option<Bounds>,
}

/// Parts of a parameter statement. Numbers in `range` and `step` are in the declared unit.
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterStatement {
    /// The parameter.
    pub name: Name,
    /// Default value in the declared unit, with its sign. NaN if it or its unit could not be parsed: this was reported, and
    /// the parameter then fits every dimension.
    pub value: f64,
    /// Place of the value.
    pub value_span: Span,
    /// The declared unit; dimensionless without one.
    pub unit: Option<StatedUnit>,
    /// `in LOW..HIGH`
    pub range: Option<Bounds>,
    /// `step S`: step of the slider, in the declared unit.
    pub step: Option<f64>,
    /// Kind of values.
    pub form: ParameterForm,
    /// `assigned LOW..HIGH step S`: values for the seats of a class.
    pub assigned: Option<AssignedRange>,
}

impl ParameterStatement {
    /// Statement with only a name and a kind. The value is NaN and has the place of the name.
    pub(crate) fn bare(name: Name, form: ParameterForm) -> Self {
        let value_span = name.span;
        Self { name, value: f64::NAN, value_span, unit: None, range: None, step: None, form, assigned: None }
    }
}

/// `assigned LOW..HIGH step S`, in the unit of the parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct AssignedRange {
    /// Least and greatest value.
    pub bounds: Bounds,
    /// Distance of the values; `None` if it is missing, which is an error.
    pub step: Option<f64>,
    /// Place, from the word to the step.
    pub span: Span,
}

/// Kind of values of a parameter.
#[derive(Clone, Debug, PartialEq)]
pub enum ParameterForm {
    /// `parameter b = 50 [kg/s]`: a number.
    Number,
    /// `switch drag = on`: on or off; the value is 1 or 0.
    Switch,
    /// `random seed = 1`: the integer seed of all random draws.
    Seed,
    /// `choice liquid { ... }`: one of these texts; the value is the index of the text, from 0.
    Choice(Vec<String>),
}

impl ParameterForm {
    /// Kind of its value.
    pub(crate) fn kind(&self) -> program::Kind {
        match self {
            Self::Number | Self::Seed => program::Kind::Number,
            Self::Switch => program::Kind::Truth,
            Self::Choice(_) => program::Kind::Text,
        }
    }
}

/// Parts of `choice liquid "Liquid" { "Water": rho = 998.2 [kg/m^3] }`.
#[derive(Clone, Debug, PartialEq)]
pub struct ChoiceStatement {
    /// Name of the parameter.
    pub name: Name,
    /// Label, which stands before the brace.
    pub label: Option<Quoted>,
    /// Alternatives, in text order.
    pub alternatives: Vec<Alternative>,
}

/// One of the alternatives of a choice.
#[derive(Clone, Debug, PartialEq)]
pub struct Alternative {
    /// Text shown to the reader.
    pub text: Quoted,
    /// Quantities that it defines.
    pub values: Vec<ChosenValue>,
}

/// `hidden rho = 998.2 [kg/m^3] "Density"` in an alternative.
#[derive(Clone, Debug, PartialEq)]
pub struct ChosenValue {
    /// Name of the quantity.
    pub name: Name,
    /// The value.
    pub value: Expression,
    /// The stated unit.
    pub unit: Option<StatedUnit>,
    /// Label shown to the reader; one alternative gives it for all.
    pub label: Option<Quoted>,
    /// True if it is left out of the readouts; one alternative is enough for all.
    pub hidden: bool,
}

/// `b = 2*m*omega_0 in [kg/s]`, for example in a preset.
#[derive(Clone, Debug, PartialEq)]
pub struct Assignment {
    /// Name of the parameter.
    pub name: Name,
    /// The value.
    pub value: Expression,
    /// The stated unit.
    pub unit: Option<StatedUnit>,
}

/// Parts of a user-defined function.
#[derive(Clone, Debug, PartialEq)]
pub struct FunctionStatement {
    /// The function.
    pub name: Name,
    /// Names of its arguments in `body`.
    pub parameters: Vec<Name>,
    /// Its value.
    pub body: Expression,
    /// The stated unit of its value.
    pub unit: Option<StatedUnit>,
}

/// Parts of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct TableStatement {
    /// The function.
    pub name: Name,
    /// Name of the argument.
    pub argument: Name,
    /// Interpolation between the points.
    pub course: Course,
    /// Label, if it stands before the brace.
    pub label: Option<Quoted>,
    /// Unit of the argument, which stands after the first number; dimensionless without one.
    pub argument_unit: Option<StatedUnit>,
    /// Unit of the values: stated, or else after the first value.
    pub unit: Option<StatedUnit>,
    /// Points, in the units of their columns.
    pub points: Vec<Point>,
    /// `drawn in -5..5 until 10 [s]`: range of the curve that the reader may draw.
    pub drawn: Option<DrawnRange>,
}

/// Range of the curve that the reader may draw instead of a table. The numbers are in the units of the columns.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnRange {
    /// Least and greatest value, in the unit of the value column.
    pub bounds: Bounds,
    /// The least argument, in the unit of the argument column.
    pub from: f64,
    /// The greatest argument, in the unit of the argument column.
    pub until: f64,
    /// Place of the greatest argument.
    pub until_span: Span,
}

/// A point of a table. Both numbers are in the units of their columns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// The argument.
    pub x: f64,
    /// The value.
    pub y: f64,
    /// Place of both numbers.
    pub span: Span,
}

/// `LOW..HIGH` and its place. Both numbers are in the unit that the statement declares.
#[derive(Clone, Debug, PartialEq)]
pub struct Bounds {
    /// The least value.
    pub low: f64,
    /// The greatest value.
    pub high: f64,
    /// Place in the source.
    pub span: Span,
}

/// `y' = -e*y'` inside an event.
#[derive(Clone, Debug, PartialEq)]
pub struct Action {
    /// The variable.
    pub name: Name,
    /// Indices of a member of a family; empty for a single quantity.
    pub indices: Vec<Expression>,
    /// Component of a vector that is a member of a family, from 0. Components of other vectors are part of the name.
    pub component: Option<usize>,
    /// Derivative order: the number of primes.
    pub order: u32,
    /// Value after the event.
    pub value: Expression,
    /// `for i in 1..N`: indices for whose values the action is repeated.
    pub over: Vec<Over>,
}

impl Statement {
    /// A single statement without a label.
    pub(crate) fn of(kind: StatementKind, span: Span) -> Self {
        Self { kind, hidden: false, over: Vec::new(), label: None, span }
    }
}

impl Action {
    /// An action on a quantity that is not a member of a family.
    pub(crate) fn of(name: Name, order: u32, value: Expression) -> Self {
        Self { name, indices: Vec::new(), component: None, order, value, over: Vec::new() }
    }
}

impl StatementKind {
    /// A discrete quantity, with its equivalent equation.
    pub(crate) fn discrete(name: Name, value: Expression, unit: Option<StatedUnit>) -> Self {
        let rate = [Expression::derivative(&name.text, 1, name.span), Expression::number(0.0, name.span)];
        Self::Discrete { name, value, unit, rate: Box::new(rate) }
    }
}
