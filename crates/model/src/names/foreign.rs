//! Functions that only other tools have.

use super::scope::{Meaning, Scope};
use crate::{Expression, ExpressionKind, Name};
use program::functions::Function;
use units::{Words, words};

/// What derivatives are written with elsewhere.
const DERIVATIVES: [&str; 5] = ["der", "diff", "deriv", "derivative", "D"];

/// What only the model has, because a run remembers it.
const REMEMBERED: [&str; 4] = ["maximum", "minimum", "mean", "integral"];

/// What vectors are made with elsewhere.
const VECTORS: [&str; 7] = ["vector", "vec", "Vector", "vec2", "vec3", "Vec2", "Vec3"];

/// What to write instead of a function that does not exist.
pub(super) fn instead_of(scope: &Scope, function: &Name, arguments: &[Expression]) -> Option<Words> {
    let text = &function.text;
    if Function::named(text).is_some() {
        return None;
    }
    let name = match arguments {
        [Expression { kind: ExpressionKind::Name { name, order: 0 }, .. }, ..] => Some(name),
        _ => None,
    };
    if DERIVATIVES.contains(&text.as_str()) {
        let name = name.map_or("x", String::as_str);
        return Some(words!(
            "the derivative of `{name}` is written `{name}'`",
            "la derivada de `{name}` se escribe `{name}'`"
        ));
    }
    if VECTORS.contains(&text.as_str()) {
        return Some(words(
            "a vector is its components in parentheses: `(1, 0, 0)`",
            "un vector son sus componentes entre paréntesis: `(1, 0, 0)`",
        ));
    }
    if ["norm", "dot", "cross"].contains(&text.as_str()) {
        return Some(words!(
            "`{text}` is for vectors, and here is none: one is defined as in `r = (x, y)`",
            "`{text}` es para vectores, y aquí no hay ninguno: se definen así: `r = (x, y)`"
        ));
    }
    if REMEMBERED.contains(&text.as_str()) && arguments.len() == 1 {
        let name = name.map_or("x", String::as_str);
        return Some(words!(
            "a run remembers only what the model asks for: write `{name}_1 = {text}({name})` there",
            "una simulación solo recuerda lo que el modelo pide: escribe allí `{name}_1 = {text}({name})`"
        ));
    }
    let name = name.filter(|_| arguments.len() == 1)?;
    matches!(scope.meaning(name), Some(Meaning::Independent)).then(|| {
        words!(
            "write `{text}` alone: every quantity may depend on `{name}`",
            "escribe solo `{text}`: toda magnitud puede depender de `{name}`"
        )
    })
}
