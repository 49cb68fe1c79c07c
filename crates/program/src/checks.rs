//! Checks: what the author of a document claims about its runs.

use crate::{Assignment, Compiled, NodeId, Tolerance};
use serde::{Deserialize, Serialize};

/// Claims about one run: that of the document's own values, with some parameters set.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Check {
    /// The parameters that are set for the run, one after the other.
    pub setup: Vec<Assignment>,
    /// In the order of the text.
    pub claims: Vec<Claim>,
}

/// A claim: `"Energy is kept": E within 1e-6 of E(0) always`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Claim {
    /// Its name, to be passed through [`crate::Program::text`].
    pub name: String,
    /// As written, without the name.
    pub written: String,
    /// What is claimed.
    pub test: Test,
    /// When it is claimed.
    pub moment: Moment,
}

/// What a claim says.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Test {
    /// A number is near another one.
    Near {
        /// The number.
        value: Compiled,
        /// What it should be.
        expected: Compiled,
        /// How far off it may be. A relative tolerance is a fraction of the expected number; of a claim for the whole run, a
        /// fraction of the greatest magnitude that the expected number has in it.
        tolerance: Tolerance,
    },
    /// A condition is true.
    Holds {
        /// The condition.
        condition: NodeId,
        /// What it compares, where it is one comparison of two numbers.
        compared: Option<Sides>,
    },
    /// Halving the step changes a number by less than this. With a method that chooses its own steps the tolerance becomes a
    /// tenth instead.
    HalvedStep {
        /// The number.
        value: Compiled,
        /// How much it may change, relative to what it is with the finer step as in [`Test::Near`].
        tolerance: Tolerance,
    },
}

/// A comparison of two numbers of one dimension.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sides {
    /// The left side.
    pub left: Compiled,
    /// How they are compared.
    pub relation: Relation,
    /// The right side.
    pub right: Compiled,
}

/// How two numbers are compared.
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

/// When a claim is made.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Moment {
    /// At every row of the run, those before and after events among them.
    Always,
    /// Where the run ends.
    End,
    /// At this value of the independent variable, in terms of parameters only.
    At(Compiled),
}

impl Claim {
    /// The values that it is computed from.
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

    /// Its condition, where it has one.
    pub fn condition(&self) -> Option<NodeId> {
        match &self.test {
            Test::Holds { condition, .. } => Some(*condition),
            _ => None,
        }
    }
}
