//! Advice for a name that is set but is no parameter: the parameter from which its value follows, or how to make one of its
//! start.

use model::{Diagnostic, Edit, Name, Places, Span};
use program::{Model, Node};
use units::words;

/// Most parameters named in one message.
const MOST: usize = 4;

/// Adds to `diagnostic` what can be set instead of `name`, a state or a quantity of the model.
pub fn advise(diagnostic: Diagnostic, source: &str, model: &Model, places: &Places, name: &Name) -> Diagnostic {
    let text = &name.text;
    let start = model.states.iter().position(|state| state.variable == *text && state.order == 0);
    if let Some(index) = start {
        return of_state(diagnostic, source, (model, places), name, index);
    }
    let Some(value) = model.lookup_shown(text, 0) else { return diagnostic };
    let dependence = model.depends(value.node);
    let of_start = dependence.states.iter().flat_map(|state| initial_parameters(model, *state as usize));
    let mut indices: Vec<u32> = dependence.parameters.iter().copied().chain(of_start).collect();
    indices.dedup();
    match names(model, &indices) {
        Some(names) => diagnostic.with_hint(words!("`{text}` is computed: set what it follows from, {names}")),
        None => diagnostic.with_hint(words!("only parameters can be set: declare it by `parameter {text} = ...`")),
    }
}

/// Advice for the start of a state.
fn of_state(
    diagnostic: Diagnostic,
    source: &str,
    (model, places): (&Model, &Places),
    name: &Name,
    index: usize,
) -> Diagnostic {
    let text = &name.text;
    let state = &model.states[index];
    if let Node::Parameter(parameter) = model.graph.node(state.initial)
        && let Some(parameter) = model.parameters.get(parameter as usize)
    {
        let own = &parameter.name;
        let hint = words!("`{text}` starts at the parameter `{own}`, which can be set");
        return diagnostic.with_hint(hint).with_fix(name.span, own.as_str());
    }
    if let Some(names) = names(model, &initial_parameters(model, index)) {
        return diagnostic.with_hint(words!("the start of `{text}` is computed: set what it follows from, {names}"));
    }
    let diagnostic = diagnostic.with_hint(words!("only parameters can be set: make one of `{text}(0)`"));
    let own = format!("{text}_0");
    let is_free = model.lookup(&own, 0).is_none();
    let place = places.states.get(index).copied().filter(|place| place.start < place.end && is_free);
    let Some((place, line)) = place.and_then(|place| Some((place, line_of(source, place, text)?))) else {
        return diagnostic;
    };
    let written = &source[place.range()];
    let unit = &state.unit.text;
    let value =
        if written.contains('[') || unit.is_empty() { written.to_owned() } else { format!("{written} [{unit}]") };
    diagnostic.with_fixes(vec![
        Edit { span: name.span, text: own.clone() },
        Edit { span: Span::new(line, line), text: format!("parameter {own} = {value}\n") },
        Edit { span: place, text: own },
    ])
}

/// First byte of the line of an initial value, if the line begins with it and the value is in this text.
fn line_of(source: &str, place: Span, name: &str) -> Option<usize> {
    let before = source.get(..place.start)?;
    let line = before.rfind('\n').map_or(0, |at| at + 1);
    let is_start = before[line..].trim_start().strip_prefix(name)?.starts_with("(0)");
    (is_start && source.get(place.range()).is_some()).then_some(line)
}

/// Parameters on which the start of a state depends.
fn initial_parameters(model: &Model, state: usize) -> Vec<u32> {
    model.states.get(state).map(|state| model.depends(state.initial).parameters).unwrap_or_default()
}

/// The names of parameters in backquotes; `None` without any.
fn names(model: &Model, indices: &[u32]) -> Option<String> {
    let shown = indices.iter().filter_map(|index| model.parameters.get(*index as usize)).take(MOST);
    let names: Vec<String> = shown.map(|parameter| format!("`{}`", parameter.name)).collect();
    (!names.is_empty()).then(|| names.join(", "))
}
