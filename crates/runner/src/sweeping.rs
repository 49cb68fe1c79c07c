//! Preparation of many runs: their plan, and what is kept of each.

use crate::plan::{Axis, Plan, PlanError, Points};
use crate::refusal::Refusal;
use document::Document;
use program::{Model, Outcomes};
use units::{Words, words};

/// The plan of these axes. `over`: the text of each axis, for messages.
///
/// # Errors
/// See [`PlanError`].
pub fn plan(model: &Model, axes: Vec<Axis>, points: Points, over: &[String]) -> Result<Plan, Refusal> {
    Plan::new(axes, points).map_err(|error| match error {
        PlanError::NoStep(axis) => {
            let over = over.get(axis).map_or("", String::as_str);
            Refusal::in_words(
                words!("--over {over}: it is not said how far apart the values are"),
                words("give a step, as in `b in 0..100 step 2`, or take samples with --random N or --halton N"),
            )
        }
        PlanError::TooMany => refusal(words!("these are more runs than {}, the most", Plan::MOST)),
        PlanError::TooManyAxes => {
            refusal(words!("--halton is for at most {} parameters; take --random for more", Plan::AXES))
        }
        PlanError::Twice(parameter) => {
            let name = model.parameters.get(parameter).map_or("", |parameter| &parameter.name);
            refusal(words!("--over names the parameter {name} twice"))
        }
    })
}

fn refusal(message: Words) -> Refusal {
    Refusal::Request { message, hint: None }
}

/// The numbers that are kept of each run, such as `y at end, maximum(y) from 2 [s] in [cm]`. Their nodes are added to the graph
/// of the model.
///
/// # Errors
/// Errors in the text.
pub fn kept(document: &mut Document, text: &str) -> Result<Outcomes, Refusal> {
    document::outcomes(document, text).map_err(|found| Refusal::Expression {
        setting: "--keep".to_owned(),
        text: text.to_owned(),
        found,
    })
}
