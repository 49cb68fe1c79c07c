//! The invitation to drag something, which stands until something has been dragged once.

use crate::app::App;
use crate::browser;

/// Key of the storage.
const DRAGGED: &str = "dragged";

/// True until something has been dragged.
pub fn stands() -> bool {
    browser::remembered(DRAGGED).is_none()
}

/// Something has been dragged: the invitation goes for good.
pub fn accept(app: App) {
    if app.nodes(|nodes| std::mem::take(&mut nodes.invites)) == Some(true) {
        browser::remember(DRAGGED, "1");
    }
}
