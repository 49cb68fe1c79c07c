//! Documents as theories of measured data.

mod errors;
mod exclude;
mod fitted;
mod fixed;
mod json;
mod lanes;
mod offsets;
mod ranking;
mod settings;
mod starts;
mod task;
mod text;
mod tied_parameters;
mod units;

pub use exclude::excluded_rows;
pub use fitted::{Fitted, Theory};
pub use json::{fit_as_json, record_as_json};
pub use lanes::lanes;
pub use ranking::{Contender, ranking_as_json, tied};
pub use settings::FitSettings;
pub use starts::Starts;
pub use task::{FitTask, task};
pub use text::{Columns, fit_as_text};
pub use units::settle_units;
