//! The dialog of the dashboard: opening and closing it.

use crate::app::App;
use crate::panel;
use view::browser;
use web_sys::HtmlDialogElement;

/// Id of the dialog.
pub const ID: &str = "class";

/// Opens the dashboard.
pub fn open(app: App) {
    app.class.set_open(true);
    panel::turn_on(app, app.words().everything_for_class);
    if let Some(dialog) = browser::by_id::<HtmlDialogElement>(ID).filter(|dialog| !dialog.open()) {
        let _ = dialog.show_modal();
    }
}

/// Closes the dashboard.
pub fn close() {
    if let Some(dialog) = browser::by_id::<HtmlDialogElement>(ID) {
        dialog.close();
    }
}
