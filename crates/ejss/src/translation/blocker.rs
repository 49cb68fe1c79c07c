//! Reasons why a simulation is listed and not translated.

use super::names::original;
use crate::place::Reason;
use crate::report::shown;
use units::{Words, words};

/// Reason why a model is not translated.
#[derive(Clone, Debug)]
pub(crate) enum Blocker {
    /// No active page of equations.
    NoEquations,
    /// Several active pages of equations.
    SeveralEquations(usize),
    /// A page of evolution code.
    EvolutionCode(String),
    /// A state that is an array.
    ArrayState(String),
    /// A state that no table declares.
    UnknownState(String),
    /// Delays or discontinuities.
    Extras,
    /// More rates, events or variables than are translated.
    TooLarge,
    /// The step is no constant number.
    Step(String),
    /// The time does not begin at 0.
    StartOfTime(String),
    /// Code that moves states, time or step in a way that cannot be translated.
    Code(Reason),
    /// A quantity that the states need cannot be translated.
    Needed(String, Reason),
    /// The checker does not accept the translation.
    Checker(String),
}

impl Blocker {
    /// The reason as part of a sentence.
    pub fn words(&self) -> Words {
        match self {
            Self::NoEquations => words!("it has no page of differential equations"),
            Self::SeveralEquations(count) => words!("it has {count} pages of differential equations"),
            Self::EvolutionCode(page) => {
                let page = shown(page);
                words!("code runs after each step (page \"{page}\" of the evolution)")
            }
            Self::ArrayState(name) => {
                let name = shown(name.split('[').next().unwrap_or_default());
                words!("the state {name} is an array")
            }
            Self::UnknownState(name) => {
                let name = shown(name);
                words!("the state {name} is in no table of variables")
            }
            Self::Extras => words!("its equations have delays or discontinuities"),
            Self::TooLarge => words!("it has more than 100 rates or events, or more than 1000 variables"),
            Self::Step(step) => {
                let step = shown(step);
                words!("the step {step} is no constant number")
            }
            Self::StartOfTime(value) => {
                let value = shown(value);
                words!("the time begins at {value}")
            }
            Self::Code(reason) => reason.words(),
            Self::Needed(name, reason) => {
                let (name, reason) = (shown(original(name)), reason.words());
                words!("{name} cannot be translated, and the motion needs it: {reason}")
            }
            Self::Checker(message) => {
                let message = shown(message);
                words!("the checker does not accept the translation: {message}")
            }
        }
    }
}
