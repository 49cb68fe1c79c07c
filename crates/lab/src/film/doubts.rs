//! Frames that a person should look at.

use crate::app::App;
use view::views::*;

/// The button that goes to the next one.
pub fn button(app: App) -> View {
    let _ = app;
    View::new()
}

/// Goes to the next one.
pub fn next(_app: App) {}
