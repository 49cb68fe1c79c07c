//! Diagnostics for undeclared names, with the name that was probably meant.

use super::members;
use super::scope::{Meaning, PI, Scope};
use crate::notation::primed;
use crate::{Diagnostic, Edit, Span, limits};
use program::functions::Function;
use units::{Words, words};

/// An undeclared name.
#[derive(Debug)]
pub(super) struct Unknown<'a> {
    pub name: &'a str,
    /// Highest derivative order with which it occurs.
    pub order: u32,
    /// Its places, each with the text after the name: primes, `(0)`.
    pub places: Vec<(Span, String)>,
}

/// Maximum number of names in a hint.
const MOST_NAMES: usize = 12;

/// Maximum length in bytes of a name that is tried as a product.
const LONGEST_PRODUCT: usize = 16;

/// Diagnostic for an undeclared name. `in_model` is false where nothing can be declared.
pub(super) fn unknown_name(scope: &Scope, unknown: &Unknown, in_model: bool) -> Diagnostic {
    let Unknown { name, order, places } = unknown;
    let (name, order) = (*name, *order);
    let mut spans = places.iter().map(|(span, _)| *span);
    let first = spans.next().unwrap_or_default();
    let message = if order > 0 {
        words!("nothing determines `{}`: `{name}` is neither defined nor in an equation", primed(name, order))
    } else {
        words!("`{name}` is not known")
    };
    let mut diagnostic = Diagnostic::error("unknown-name", message, first);
    for place in spans.take(limits::PLACES) {
        diagnostic = diagnostic.with_label(place, words("and here"));
    }
    let is_function = || words!("`{name}` is a function: write `{name}(...)`");
    if scope.is_function(name) {
        return diagnostic.with_hint(is_function());
    }
    if let Some(hint) = members::hint(scope, name) {
        return diagnostic.with_hint(hint);
    }
    // The source text of members and components differs from these names, so it cannot be replaced.
    let meaning = |diagnostic: Diagnostic, new: &str| {
        if name.contains(['[', '.']) || new.contains(['[', '.']) {
            return diagnostic;
        }
        let edits = places.iter().map(|(span, ending)| Edit { span: *span, text: format!("{new}{ending}") });
        diagnostic.with_fixes(edits.collect())
    };
    if let Some(factors) = as_product(scope, name) {
        let hint = words!("for a product write `{factors}`");
        return meaning(diagnostic.with_hint(hint), &factors);
    }
    if let Some(hint) = as_differential(scope, name).filter(|_| order == 0) {
        return diagnostic.with_hint(hint);
    }
    if let Some(near) = scope.called(name).filter(|_| order == 0).or_else(|| scope.near(name)) {
        let hint = words!("did you mean `{near}`?");
        return meaning(diagnostic.with_hint(hint), near);
    }
    if Function::named(name).is_some() {
        return diagnostic.with_hint(is_function());
    }
    match name {
        _ if order > 0 => {
            let highest = primed(name, order.max(2));
            diagnostic
                .with_hint(words!("write an equation for it, such as `{highest} = ...`, or define `{name} = ...`"))
        }
        "t" => diagnostic.with_hint(words!("the independent variable is `{}`", scope.independent)),
        "verdadero" | "cierto" => diagnostic.meaning("true"),
        "falso" => diagnostic.meaning("false"),
        "encendido" => diagnostic.meaning("on"),
        "apagado" => diagnostic.meaning("off"),
        "on" | "off" | "true" | "false" => {
            diagnostic.with_hint(words("what is true or false stands alone: `if drag then ... else ...`, `not drag`"))
        }
        "e" => diagnostic.with_hint(words("for a power of 2.718... write `exp(x)`")),
        _ if in_model => {
            diagnostic.with_hint(words!("declare it: `parameter {name} = 1`, with its unit, or `{name} = ...`"))
        }
        _ => diagnostic.with_hint(known_names(scope)),
    }
}

/// Hint with the names of the model. Names with other characters are parts of families or vectors.
fn known_names(scope: &Scope) -> Words {
    let is_written = |name: &&str| *name != PI && name.chars().all(|c| c == '_' || c.is_alphanumeric());
    let names = scope.names().filter(is_written).map(|name| format!("`{name}`"));
    let names = names.take(MOST_NAMES).collect::<Vec<_>>().join(", ");
    words!("the model has the names {names}")
}

/// Hint for the parts of `dy/dt`.
fn as_differential(scope: &Scope, name: &str) -> Option<Words> {
    let variable = name.strip_prefix('d')?;
    match scope.meaning(variable)? {
        Meaning::Independent => Some(words("derivatives are written with primes: `y'`, `y''`")),
        Meaning::Variable(_) | Meaning::Definition(_) => {
            Some(words!("the derivative of `{variable}` is written `{variable}'`"))
        }
        Meaning::Parameter(_) | Meaning::Pi => None,
    }
}

/// `m*g` for `mg`, if both are names.
fn as_product(scope: &Scope, name: &str) -> Option<String> {
    if name.len() > LONGEST_PRODUCT {
        return None;
    }
    let is_name = |text: &str| scope.meaning(text).is_some();
    let cuts = || name.char_indices().map(|(index, _)| index).skip(1);
    let two = cuts().find(|&cut| is_name(&name[..cut]) && is_name(&name[cut..]));
    if let Some(cut) = two {
        return Some(format!("{}*{}", &name[..cut], &name[cut..]));
    }
    let three = cuts().find_map(|first| {
        let second =
            cuts().find(|&second| second > first && is_name(&name[first..second]) && is_name(&name[second..]))?;
        is_name(&name[..first]).then_some((first, second))
    });
    three.map(|(first, second)| format!("{}*{}*{}", &name[..first], &name[first..second], &name[second..]))
}
