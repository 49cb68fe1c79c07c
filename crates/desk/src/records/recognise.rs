//! Recognition of the quantity of the document that a data column measures.

use analysis::origin::Role;
use analysis::table::{Column, Table};
use document::Document;
use program::{Kind, Model};
use std::collections::BTreeSet;
use units::Unit;

/// Meaning of a column.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Meaning {
    /// Name of the quantity in the document; empty if the column is not used.
    pub quantity: String,
    /// Unit of the column's numbers.
    pub unit: Unit,
}

impl Meaning {
    /// Meaning of an unused column without a unit.
    pub fn nothing() -> Self {
        Self { quantity: String::new(), unit: Unit::dimensionless() }
    }
}

/// Quantities that can be measured, each with its unit: the independent variable, the subjects of the document and the
/// unknowns with their derivatives, and all other numeric quantities that vary.
pub(crate) fn measurable(document: &Document) -> Vec<(String, Unit)> {
    let model = &document.program.model;
    let mut found = vec![(model.independent.name.clone(), model.independent.unit.clone())];
    for subject in subjects(document) {
        for order in 0..=2 {
            let name = format!("{subject}{}", "'".repeat(order as usize));
            found.extend(model.lookup_shown(subject, order).map(|value| (name, value.unit)));
        }
    }
    for (index, state) in model.states.iter().enumerate() {
        found.push((state.name(), state.unit.clone()));
        // The highest derivative of a variable follows its last state.
        if model.states.get(index + 1).is_none_or(|next| next.order == 0) {
            let name = format!("{}'", state.name());
            found.extend(model.lookup_shown(&state.variable, state.order + 1).map(|value| (name, value.unit)));
        }
    }
    let varying = model.quantities.iter().filter(|quantity| quantity.varies && quantity.value.kind == Kind::Number);
    found.extend(varying.map(|quantity| (quantity.name.clone(), quantity.value.unit.clone())));
    let mut names = BTreeSet::new();
    found.retain(|(name, _)| names.insert(name.clone()));
    found
}

/// Subjects of the document: the quantities of its first plot against the independent variable, without derivatives.
fn subjects(document: &Document) -> Vec<&str> {
    let model = &document.program.model;
    let mut found: Vec<&str> = Vec::new();
    for curve in document
        .program
        .plots
        .iter()
        .find(|plot| plot.x.expression == model.independent.name)
        .iter()
        .flat_map(|plot| &plot.curves)
    {
        let stem = curve.expression.trim_end_matches('\'');
        if model.lookup_shown(stem, 0).is_some() && !found.contains(&stem) {
            found.push(stem);
        }
    }
    found
}

/// Compiled expression of a name such as `y'`; `None` if the model does not have it.
pub(crate) fn observed(model: &Model, name: &str) -> Option<program::Compiled> {
    let stem = name.trim_end_matches('\'');
    model.lookup_shown(stem, (name.len() - stem.len()) as u32)
}

/// Meaning of each column. `labels` gives a label in all languages of the document, in lower case.
pub(crate) fn recognise(table: &Table, document: &Document, labels: &dyn Fn(&str) -> Vec<String>) -> Vec<Meaning> {
    let model = &document.program.model;
    let known = measurable(document);
    let subjects = subjects(document);
    let mut taken: Vec<bool> = vec![false; known.len()];
    let nothing = |column: &Column| Meaning {
        quantity: String::new(),
        unit: column.unit.clone().unwrap_or_else(Unit::dimensionless),
    };
    let mut meanings: Vec<Meaning> = table.columns.iter().map(nothing).collect();
    // With several bodies, only the columns of the first one are used.
    let body = table.columns.iter().find_map(|column| column.body.as_ref());
    let of_body = |column: &Column| column.body.is_none() || column.body.as_ref() == body;
    // Positions in pixels match a length; the missing scale is reported later.
    let same =
        |own: &Unit, unit: &Unit| own.dimension == unit.dimension || own.dimension.lacks_scale_for(unit.dimension);
    let fits = |column: &Column, unit: &Unit| column.unit.as_ref().is_none_or(|own| same(own, unit));
    let errors: BTreeSet<usize> = (0..table.columns.len()).filter_map(|column| table.errors_of(column)).collect();
    // Order of attempts: exact name, name regardless of case or label, customary name, single letter, then unit or
    // position.
    let unknowns = 1 + known.iter().skip(1).take_while(|(name, _)| is_about(model, &subjects, name)).count();
    let unknowns = if model.states.is_empty() { known.len() } else { unknowns };
    for (names, how) in [by_exact_name, by_name, by_custom, by_letter, by_place].into_iter().enumerate() {
        for (index, column) in table.columns.iter().enumerate() {
            let independent = column.independent == index;
            // Columns of standard errors and row counters measure nothing.
            if errors.contains(&index) || column.origin.role == Role::Counter {
                continue;
            }
            // The clock of each body is used.
            if !(of_body(column) || independent)
                || meanings.get(index).is_none_or(|meaning| !meaning.quantity.is_empty())
            {
                continue;
            }
            let free = |place: &usize| (*place == 0) == independent && !taken.get(*place).copied().unwrap_or(true);
            // Customary names and positions match only subjects and unknowns of the document; other quantities need
            // their name.
            let within = if matches!(names, 0 | 1 | 3) { known.len() } else { unknowns };
            let candidates: Vec<usize> = (0..within)
                .filter(free)
                .filter(|&place| known.get(place).is_some_and(|(_, unit)| fits(column, unit)))
                // A column without a name can only be a subject of the document.
                .filter(|&place| {
                    let stem = known.get(place).map(|(name, _)| name.trim_end_matches('\''));
                    independent
                        || !column.name.is_empty()
                        || subjects.is_empty()
                        || stem.is_some_and(|stem| subjects.contains(&stem))
                })
                .collect();
            let spelled = spelling(&column.name);
            let found = if independent {
                candidates.first().copied()
            } else {
                let offered =
                    candidates.iter().filter_map(|&place| known.get(place).map(|(name, _)| (place, name.as_str())));
                how(&spelled, &offered.collect::<Vec<_>>(), column, &|name| {
                    label(model, name).map(labels).unwrap_or_default()
                })
            };
            if let Some((place, (name, unit))) = found.and_then(|place| Some((place, known.get(place)?)))
                && let (Some(meaning), Some(taken)) = (meanings.get_mut(index), taken.get_mut(place))
            {
                *meaning =
                    Meaning { quantity: name.clone(), unit: column.unit.clone().unwrap_or_else(|| unit.clone()) };
                // Each body has its own clock, so the independent variable can be assigned several times.
                *taken = !independent;
            }
        }
    }
    meanings
}

/// Match of the exact name: `T` is the quantity `T` even if the document also has a `t`.
fn by_exact_name(_: &str, names: &[(usize, &str)], column: &Column, _: &dyn Fn(&str) -> Vec<String>) -> Option<usize> {
    let name = squeezed(&column.name);
    names.iter().find(|(_, other)| squeezed(other) == name).map(|(place, _)| *place)
}

/// Match of the name or label regardless of case. A single letter is excluded here, because a capital usually is
/// another quantity.
fn by_name(spelled: &str, names: &[(usize, &str)], _: &Column, labels: &dyn Fn(&str) -> Vec<String>) -> Option<usize> {
    let letter = spelled.chars().count() == 1;
    let same = |name: &str| !letter && spelling(name) == spelled;
    let found = names.iter().find(|(_, name)| same(name) || labels(name).iter().any(|label| label == spelled));
    found.map(|(place, _)| *place)
}

fn by_letter(spelled: &str, names: &[(usize, &str)], _: &Column, _: &dyn Fn(&str) -> Vec<String>) -> Option<usize> {
    names.iter().find(|(_, name)| spelling(name) == spelled && !spelled.is_empty()).map(|(place, _)| *place)
}

/// True if a name is a subject of the document, an unknown of its model, or a derivative of one.
fn is_about(model: &Model, subjects: &[&str], name: &str) -> bool {
    let stem = name.trim_end_matches('\'');
    subjects.contains(&stem) || model.states.iter().any(|state| state.variable == stem)
}

/// Match of names of positions, velocities and accelerations that are customary in tracking programs and tables.
fn by_custom(spelled: &str, names: &[(usize, &str)], _: &Column, _: &dyn Fn(&str) -> Vec<String>) -> Option<usize> {
    let stem = spelled.trim_end_matches(|letter: char| letter.is_ascii_digit());
    let order = match stem {
        "x" | "y" | "z" | "r" | "s" | "h" | "position" | "posición" | "displacement" | "desplazamiento" | "theta"
        | "phi" | "angle" | "ángulo" => 0,
        "v" | "vx" | "vy" | "vz" | "vr" | "dy" | "dx" | "velocity" | "velocidad" | "speed" | "omega" => 1,
        "a" | "ax" | "ay" | "az" | "acceleration" | "aceleración" | "alpha" => 2,
        _ => return None,
    };
    let of_order = |name: &&(usize, &str)| {
        let primes = name.1.bytes().filter(|&byte| byte == b'\'').count();
        primes == order
    };
    names.iter().find(of_order).map(|(place, _)| *place)
}

/// Match by position or unit. A column without a name gets the next free quantity, one with a unit the first free
/// quantity of its dimension.
fn by_place(spelled: &str, names: &[(usize, &str)], column: &Column, _: &dyn Fn(&str) -> Vec<String>) -> Option<usize> {
    (spelled.is_empty() || column.unit.is_some()).then(|| names.first().map(|(place, _)| *place)).flatten()
}

/// Name in lower case and without typesetting: `v_{y}` becomes `vy`, `Y` becomes `y`.
fn spelling(name: &str) -> String {
    squeezed(name).to_lowercase()
}

/// Name without typesetting: `v_{y}` becomes `vy`.
fn squeezed(name: &str) -> String {
    name.chars().filter(|letter| !matches!(letter, '_' | '{' | '}' | ' ' | '$' | '\\')).collect()
}

/// Label of a state or quantity.
fn label<'a>(model: &'a Model, name: &str) -> Option<&'a str> {
    let of_state = model.states.iter().find(|state| state.name() == name).map(|state| &state.label);
    let label = of_state
        .or_else(|| model.quantities.iter().find(|quantity| quantity.name == name).map(|quantity| &quantity.label))?;
    label.as_deref()
}
