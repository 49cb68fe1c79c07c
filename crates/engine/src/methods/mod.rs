//! Integration methods, their linear algebra, and the stepper that moves from grid point to grid point.
//!
//! Linear systems, of coupled equations of motion and of the stiff method, are dense for small models and banded where each
//! equation has few neighbours (`Sparse`). Rows of the Dormand-Prince method come from its dense output. The stiff method
//! ends a step on every row, because its dense output loses order where a stiff part forces the solution. Unit tests check
//! coefficients by their order conditions.

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
