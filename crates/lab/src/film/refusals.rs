//! Messages about failed actions.

use super::access::Trouble;
use crate::app::App;

/// Text of an error.
pub fn said(app: App, trouble: &Trouble) -> String {
    trouble.words().text(app.language.get_untracked()).into_owned()
}

/// Shows a refusal, if any.
pub fn refuse(app: App, refusal: Option<String>) {
    if let Some(why) = refusal {
        app.complain(why);
    }
}
