//! Texts for a run that cannot start or continue.

use super::TimeLine;
use crate::{Basis, Status};
use engine::Subject;
use units::number;

/// Significant digits of the time at which a run ends.
const DIGITS: usize = 3;

/// A problem of the run, in the chosen language.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// Stable identifier.
    pub code: &'static str,
    /// Description, a sentence.
    pub message: String,
    /// Advice; may be empty.
    pub hint: String,
}

impl TimeLine {
    /// Reason why the run cannot continue; `None` unless the moment at which it stopped is shown.
    pub fn problem(&self, basis: &Basis) -> Option<Problem> {
        let error = self.course.error().filter(|_| !self.course.is_scrubbed())?;
        let message = error.message_in(basis.model(), |title| basis.text(title).to_owned());
        Some(Problem {
            code: error.code(),
            message: sentence(&message.text(basis.language()), error.code() == "not-finite"),
            hint: sentence(&error.hint().text(basis.language()), false),
        })
    }

    /// Text for a run that has reached the end set by the document or an event: the time and the event; `None` in any
    /// other status.
    pub fn ending(&self, basis: &Basis) -> Option<String> {
        if self.status() != Status::Ended {
            return None;
        }
        let independent = &basis.model().independent;
        let unit =
            basis.small_times(&self.course).map_or_else(|| independent.unit.clone(), |group| group.unit().clone());
        let time = number::plain(unit.from_si(self.course.time()), DIGITS, basis.style());
        let moment = format!("{} = {}", independent.name, number::with_unit(&time, &unit));
        let title = self.course.error().and_then(|error| match error.subject() {
            Some(Subject::Event(event)) => basis.model().events.get(event)?.title.as_deref(),
            _ => None,
        });
        let ends = basis.language().say("The run ends at");
        Some(match title {
            Some(title) => sentence(&format!("{ends} {moment}: {}", basis.text(title)), false),
            None => sentence(&format!("{ends} {moment}"), false),
        })
    }

    /// First warning of the run up to the front, if any; the run continues.
    pub fn notice(&self, basis: &Basis) -> Option<Problem> {
        let notice = self.course.notices().into_iter().find(|notice| notice.time <= self.course.front())?;
        Some(Problem {
            code: notice.code(),
            message: sentence(&notice.message(basis.model()).text(basis.language()), false),
            hint: sentence(&notice.hint().text(basis.language()), false),
        })
    }
}

/// Text as a sentence: with a full stop, and with a capital letter unless it begins with a name.
fn sentence(text: &str, named: bool) -> String {
    let mut characters = text.chars();
    match characters.next() {
        None => String::new(),
        Some(_) if named => format!("{text}."),
        Some(first) => format!("{}{}.", units::alphabet::capital(first), characters.as_str()),
    }
}
