//! `assignment: tube-2026`: name on which the values of the seats of a class depend.
//!
//! Nothing else stands in for it. Title and file name change when a typo is corrected, and with them the values of all students
//! would.

use super::front_matter::FrontMatter;
use model::{Diagnostic, Places};
use program::Model;
use units::words;

/// Maximum length of a name, in characters.
const LONGEST: usize = 64;

/// The name, if it is a valid one. Reports another one, and a missing one where values are assigned.
pub fn read(matter: &FrontMatter, model: &Model, places: &Places, diagnostics: &mut Vec<Diagnostic>) -> Option<String> {
    if let Some(value) = matter.get("assignment") {
        let good = |c: char| c.is_ascii_alphanumeric() || "-_.".contains(c);
        if value.text.len() <= LONGEST && value.text.chars().all(good) {
            return Some(value.text.clone());
        }
        let wrong =
            words!("the name of an assignment has up to {LONGEST} letters without accents, digits, `-`, `_` and `.`");
        diagnostics.push(
            Diagnostic::error("assignment", wrong, value.span).with_hint(words("such as: assignment: tube-2026")),
        );
        return None;
    }
    let index = model.assigned_parameters().next()?;
    let wrong = words!("`{}` has assigned values, and the assignment has no name", model.parameters[index].name);
    let hint = words(
        "write a name into the front matter that stays as it is, such as `assignment: tube-2026`: the values depend on it",
    );
    let declared = places.parameters.get(index).copied().unwrap_or_default();
    diagnostics.push(Diagnostic::error("assignment", wrong, declared).with_hint(hint));
    None
}
