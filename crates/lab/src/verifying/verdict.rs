//! Result of the verification of a dropped hand-in.

use desk::saved::project::Project;
use std::rc::Rc;
use web_sys::File;

/// A hand-in and the result of its verification.
#[derive(Clone)]
pub struct Verified {
    /// Name of the file, and of the sender if there is one.
    pub name: String,
    /// True if every value follows from the data; `None` while it is being computed.
    pub holds: Option<bool>,
    /// Description in lines: a summary, then details.
    pub lines: Vec<String>,
    /// Document, records, films, fits and answers.
    pub work: Rc<Project>,
    /// The file, if it is a hand-in that the dashboard of a class takes.
    pub file: Option<File>,
}
