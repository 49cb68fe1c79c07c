//! Simulation engine: register machine, integration methods, events, recorded history, and the checks of an author's
//! claims.

pub mod checks;
mod code;
mod compiled;
mod error;
mod events;
mod methods;
mod notice;
mod record;
mod run;
mod setup;
mod start;
mod wide;

pub use code::instruction::{Operation, Register};
pub use code::lines::Line;
pub use code::routine::Routine;
pub use compiled::lanes::{LanesLayout, LanesListing};
pub use compiled::layout::Layout;
pub use compiled::listing::{Formulas, Interpreted, Listing, Preparation, WindowListing};
pub use compiled::preparing::side_by_side;
pub use compiled::side_by_side::{LANES, SideBySide};
pub use compiled::window_layout::WindowLayout;
pub use compiled::{Compiled, Compiler};
pub use error::{Cause, RunError, Subject};
pub use events::interpolant::{CHECKS, sign_changes};
pub use events::press::Press;
pub use methods::adaptive::{StepControl, dormand_prince_growth, dormand_prince_shrinkage};
pub use methods::last_step::LastStep;
pub use methods::stepper::{Progress, ROUNDING, Reached, Stepper, rows_until};
pub use methods::tableau;
pub use notice::{Notice, NoticeKind};
pub use program::Method;
pub use record::folds::Folds;
pub use record::history::History;
pub use record::readings::Readings;
pub use record::{AfterJump, Record};
pub use record::{csv, table};
pub use run::{Advance, CAPACITY, Run};
pub use setup::Setup;
pub use wide::{Wide, dot, run_wide, subtract_multiple};
