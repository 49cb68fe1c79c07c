//! Hints about members of families that do not exist.

use super::scope::Scope;
use crate::families::family;
use units::{Words, words};

/// Hint for an unknown name that is a member of a family, or a family.
pub(super) fn hint(scope: &Scope, name: &str) -> Option<Words> {
    let members = |wanted: &str| {
        let mut members = scope.names().filter(|known| family(known) == Some(wanted));
        let first = members.next()?;
        Some((first.to_owned(), members.last().map(str::to_owned)))
    };
    let Some(family) = family(name) else {
        let (first, _) = members(name)?;
        return Some(words!(
            "`{name}` is a family: write one of its members, as `{first}`, or join them, as in `sum({name}[i] for i in 1..3)`"
        ));
    };
    if scope.meaning(family).is_some() {
        return Some(words!(
            "`{family}` is a single quantity and has no members; a unit after it is written `in [..]`"
        ));
    }
    Some(match members(family) {
        Some((first, Some(last))) => {
            words!("the members `{first}` to `{last}` are given; give this one, too: `{name} = ...`")
        }
        Some((only, None)) => words!("only the member `{only}` is given; give this one, too: `{name} = ...`"),
        None => words!("give its members: `{family}[i] = ... for i in 1..10`, or an equation for each"),
    })
}
