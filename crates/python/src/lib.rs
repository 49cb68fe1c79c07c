//! The Python package `meniscus`: documents, tables and fits as Python objects, on top of `runner`. The work is done without the
//! lock of the interpreter.

mod arguments;
mod arrow;
mod column;
mod diagnostic;
mod disk;
mod document;
mod errors;
mod fit;
mod fitting;
mod keywords;
mod page;
mod ranking;
mod settings;
mod sweeps;
mod table;

use pyo3::prelude::*;

/// Simulations of oscillations from text documents: runs, sweeps and fits with units.
#[pymodule]
mod meniscus {
    #[pymodule_export]
    use crate::diagnostic::Diagnostic;
    #[pymodule_export]
    use crate::document::{Document, check, open};
    #[pymodule_export]
    use crate::errors::{DocumentError, MeniscusError, RunError, SettingError};
    #[pymodule_export]
    use crate::fit::{Estimate, Fit};
    #[pymodule_export]
    use crate::ranking::rank;
    #[pymodule_export]
    use crate::table::Table;

    use super::*;

    #[pymodule_init]
    fn initialise(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
