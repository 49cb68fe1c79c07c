//! Comparison of the plots of two programs.

use program::{Curve, Plot, Program};

/// True if two plots draw the same expressions in the same units. The meaning of their names may differ.
pub(crate) fn same_curves(one: &Plot, other: &Plot) -> bool {
    let same =
        |(one, other): (&Curve, &Curve)| one.expression == other.expression && one.value.unit == other.value.unit;
    one.curves.len() == other.curves.len()
        && one.others.iter().map(|(place, _)| place).eq(other.others.iter().map(|(place, _)| place))
        && one.expressions().zip(other.expressions()).all(same)
}

/// True if the plots of two programs draw the same curves in the same order.
pub(crate) fn has_same_curves(program: &Program, former: &Program) -> bool {
    program.plots.len() == former.plots.len()
        && program.plots.iter().zip(&former.plots).all(|(one, other)| same_curves(one, other))
}
