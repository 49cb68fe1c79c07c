//! Comparison of the plots of two programs.

use crate::Play;
use program::{Curve, Plot};

/// True if two plots draw the same expressions in the same units. The meaning of their names may differ.
pub(super) fn same_curves(one: &Plot, other: &Plot) -> bool {
    let same =
        |(one, other): (&Curve, &Curve)| one.expression == other.expression && one.value.unit == other.value.unit;
    one.curves.len() == other.curves.len()
        && one.others.iter().map(|(place, _)| place).eq(other.others.iter().map(|(place, _)| place))
        && one.expressions().zip(other.expressions()).all(same)
}

impl Play {
    /// True if the columns of the plots are arranged as in the former program, so that its runs can be drawn.
    pub(super) fn has_curves_of(&self, before: &Play) -> bool {
        let (plots, former) = (&self.basis.program().plots, &before.basis.program().plots);
        plots.len() == former.len()
            && plots.iter().zip(former).all(|(one, other)| same_curves(one, other))
            && self.line.columns().is_arranged_like(before.line.columns())
    }

    /// True if the columns also compute the same values, for runs with the same states.
    pub(super) fn columns_are_those_of(&self, before: &Play) -> bool {
        let (graph, former) = (&self.model().graph, &before.model().graph);
        graph.same(self.line.columns().nodes(), former, before.line.columns().nodes(), Some)
    }
}
