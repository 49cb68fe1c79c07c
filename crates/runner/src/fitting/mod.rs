//! Documents as theories of measured data.

mod fitted;
mod json;
mod lanes;
mod ranking;
mod settings;
mod task;
mod text;

pub use fitted::{Fitted, Theory};
pub use json::{fit_as_json, record_as_json};
pub use lanes::lanes;
pub use ranking::{Contender, ranking_as_json, tied};
pub use settings::FitSettings;
pub use task::task;
pub use text::{Columns, fit_as_text};
