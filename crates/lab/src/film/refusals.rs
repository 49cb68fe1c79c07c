//! Why something was not done.

use super::access::Trouble;
use crate::app::App;

/// What went wrong, in words.
pub fn said(app: App, trouble: &Trouble) -> String {
    trouble.words().text(app.language.get_untracked()).to_owned()
}

/// Says why something was not done, if it was not.
pub fn refuse(app: App, refusal: Option<String>) {
    if let Some(why) = refusal {
        app.complain(why);
    }
}
