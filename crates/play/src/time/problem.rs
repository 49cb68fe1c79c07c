//! Why a run cannot start or go on, in the chosen language.

use crate::Play;

/// Why the run cannot go on, in the chosen language.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// A stable name.
    pub code: &'static str,
    /// What is wrong, a sentence.
    pub message: String,
    /// What to do; may be empty.
    pub hint: String,
}

impl Play {
    /// Why the run cannot go on; only while the moment where it stopped is shown.
    pub fn problem(&self) -> Option<Problem> {
        let error = self.course.error().filter(|_| !self.course.is_scrubbed())?;
        let message = error.message_in(self.model(), |title| self.text(title).to_owned());
        Some(Problem {
            code: error.code(),
            message: sentence(message.text(self.language), error.code() == "not-finite"),
            hint: sentence(error.hint().text(self.language), false),
        })
    }
}

impl Play {
    /// What the run cannot promise up to the front, if there is anything; it goes on.
    pub fn notice(&self) -> Option<Problem> {
        let notice = self.course.notices().into_iter().find(|notice| notice.time <= self.course.front())?;
        Some(Problem {
            code: notice.code(),
            message: sentence(notice.message(self.model()).text(self.language), false),
            hint: sentence(notice.hint().text(self.language), false),
        })
    }
}

/// With a full stop, and with a capital letter unless it begins with a name.
fn sentence(text: &str, named: bool) -> String {
    let mut characters = text.chars();
    match characters.next() {
        None => String::new(),
        Some(_) if named => format!("{text}."),
        Some(first) => format!("{}{}.", first.to_uppercase(), characters.as_str()),
    }
}
