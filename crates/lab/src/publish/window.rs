//! The dialog element.

use view::browser;
use web_sys::HtmlDialogElement;

/// Id of the dialog.
pub const ID: &str = "publish";

/// Opens the dialog.
pub fn open() {
    if let Some(dialog) = browser::by_id::<HtmlDialogElement>(ID) {
        let _ = dialog.show_modal();
    }
}
