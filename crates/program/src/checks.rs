//! Checks: claims of an author about runs of the document.

use crate::{Assignment, Compiled, NodeId, Tolerance};
use serde::{Deserialize, Serialize};

/// Claims about one run, which has the values of the document with some parameters set.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Check {
    /// Parameters set for the run, one after the other.
    pub setup: Vec<Assignment>,
    /// The claims, in the order of the text.
    pub claims: Vec<Claim>,
}

/// A claim: `"Energy is kept": E within 1e-6 of E(0) always`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Claim {
    /// Name of the claim, to be translated with [`crate::Program::text`].
    pub name: String,
    /// Source text without the name.
    pub written: String,
    /// The claimed statement.
    pub test: Test,
    /// Moment or moments of the claim.
    pub moment: Moment,
}

/// The statement of a claim.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Test {
    /// A number equals another one within a tolerance.
    Near {
        /// The claimed number.
        value: Compiled,
        /// Expected value.
        expected: Compiled,
        /// Allowed difference. A relative tolerance is a fraction of the expected number; for a claim about the whole run,
        /// a fraction of the greatest magnitude of the expected number during it.
        tolerance: Tolerance,
    },
    /// A condition is true.
    Holds {
        /// The condition.
        condition: NodeId,
        /// The two sides, if the condition is one comparison of two numbers.
        compared: Option<Sides>,
    },
    /// Halving the step changes a number by less than this. With an adaptive method, a tenth of the tolerance replaces half
    /// the step.
    HalvedStep {
        /// The number that must not change.
        value: Compiled,
        /// Upper bound of the change; a relative one refers to the value with the finer step, as in [`Test::Near`].
        tolerance: Tolerance,
    },
}

/// A comparison of two numbers of the same dimension.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sides {
    /// The left side.
    pub left: Compiled,
    /// The relation.
    pub relation: Relation,
    /// The right side.
    pub right: Compiled,
}

/// Relation between two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Relation {
    /// `<` or `<=`
    Below,
    /// `>` or `>=`
    Above,
    /// `==`
    Equal,
    /// `!=`
    Different,
}

/// Moment or moments of a claim.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Moment {
    /// Every row of the run, including those before and after events.
    Always,
    /// End of the run.
    End,
    /// At this value of the independent variable, an expression of parameters.
    At(Compiled),
}

impl Claim {
    /// All compiled values of the claim.
    pub fn values(&self) -> Vec<&Compiled> {
        let mut values = match &self.test {
            Test::Near { value, expected, .. } => vec![value, expected],
            Test::Holds { compared, .. } => {
                compared.iter().flat_map(|compared| [&compared.left, &compared.right]).collect()
            }
            Test::HalvedStep { value, .. } => vec![value],
        };
        if let Moment::At(time) = &self.moment {
            values.push(time);
        }
        values
    }

    /// The condition of [`Test::Holds`], otherwise `None`.
    pub fn condition(&self) -> Option<NodeId> {
        match &self.test {
            Test::Holds { condition, .. } => Some(*condition),
            _ => None,
        }
    }
}
