//! Blocks of a document other than model and drawing: their syntax, and the parts of the program made from them.

mod amount;
pub(crate) mod asked;
pub(crate) mod assignment;
pub(crate) mod curves;
pub(crate) mod front_matter;
pub(crate) mod members;
pub(crate) mod named;
pub(crate) mod plots;
pub(crate) mod presets;
pub(crate) mod profiles;
pub(crate) mod questions;
pub(crate) mod settings;
pub(crate) mod survey;
pub(crate) mod sweeps;
pub(crate) mod tolerances;
