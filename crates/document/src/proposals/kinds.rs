//! The list of all kinds of proposals.

use super::energy::Energy;
use super::proposal::Proposal;
use super::study::Study;
use super::{balance, decay, energy, period, rest, signs, start, sums};

/// A kind of proposals.
pub struct Kind {
    /// Name, the first word of the keys of its proposals.
    pub name: &'static str,
    /// Structure of the equations that it recognises.
    pub recognises: &'static str,
    /// Claims that it derives.
    pub(super) derive: fn(&mut Study, &[Energy]) -> Vec<Proposal>,
}

/// All kinds, the most telling first.
pub const KINDS: [Kind; 9] = [
    Kind {
        name: energy::KIND,
        recognises: "an energy of variables with a second derivative, which the forces keep without friction and drive",
        derive: energy::kept,
    },
    Kind {
        name: balance::KIND,
        recognises: "an energy, and integrals of power that account for its changes",
        derive: balance::accounted,
    },
    Kind {
        name: signs::FRICTION,
        recognises: "a term of an acceleration that changes its sign with the velocity",
        derive: signs::friction,
    },
    Kind {
        name: signs::WEIGHT,
        recognises: "a height, and a parameter labelled as gravitational acceleration",
        derive: signs::weight,
    },
    Kind {
        name: period::KIND,
        recognises: "a variable that swings about an equilibrium, and a labelled period, frequency or damping rate",
        derive: period::periods,
    },
    Kind {
        name: decay::KIND,
        recognises: "a variable that decays, and a labelled half-life or time constant",
        derive: decay::times,
    },
    Kind {
        name: rest::KIND,
        recognises: "an equilibrium of the equations, and a labelled position or value of equilibrium",
        derive: rest::equilibria_stay,
    },
    Kind { name: sums::KIND, recognises: "rates of change that cancel in a sum", derive: sums::kept },
    Kind {
        name: start::KIND,
        recognises: "a parameter labelled as the value of a variable at the start",
        derive: start::labelled,
    },
];
