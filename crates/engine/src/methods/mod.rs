//! Integration methods, their linear algebra, and the stepper that moves from grid point to grid point.

pub(crate) mod adaptive;
pub(crate) mod banded;
pub(crate) mod cubic;
pub(crate) mod dormand_prince;
pub(crate) mod equations;
pub(crate) mod fixed;
pub(crate) mod jacobian;
pub(crate) mod last_step;
pub(crate) mod linear;
#[cfg(test)]
pub(crate) mod order_conditions;
pub(crate) mod rosenbrock;
pub(crate) mod sparse;
pub(crate) mod stability;
pub(crate) mod stepper;
pub mod tableau;
