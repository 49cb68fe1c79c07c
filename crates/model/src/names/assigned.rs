//! Checks of the values that are assigned to the seats of a class.

use crate::{AssignedRange, Diagnostic, ParameterForm, ParameterStatement};
use program::{Grid, GridFault};
use units::words;

/// Reports a range of assigned values that cannot be used.
pub(super) fn check_assigned(parameter: &ParameterStatement, diagnostics: &mut Vec<Diagnostic>) {
    let Some(assigned) = &parameter.assigned else { return };
    if parameter.form != ParameterForm::Number {
        let wrong = words!(
            "`{0}` cannot have assigned values: only a parameter can",
            "`{0}` no puede tener valores asignados: solo un parámetro puede",
            parameter.name.text
        );
        diagnostics.push(Diagnostic::error("assigned-form", wrong, assigned.span));
        return;
    }
    diagnostics.extend(in_range(parameter, assigned));
    diagnostics.extend(grid(parameter, assigned));
}

/// Assigned values outside of the range of the parameter.
fn in_range(parameter: &ParameterStatement, assigned: &AssignedRange) -> Option<Diagnostic> {
    let range = parameter.range.as_ref()?;
    let own = &assigned.bounds;
    if own.low >= range.low && own.high <= range.high {
        return None;
    }
    let (name, low, high) = (&parameter.name.text, own.low, own.high);
    let wrong = words!(
        "the assigned values of `{name}`, {low}..{high}, lie outside its range",
        "los valores asignados de `{name}`, {low}..{high}, están fuera de su intervalo"
    );
    let diagnostic = Diagnostic::error("assigned-out-of-range", wrong, own.span);
    Some(
        diagnostic
            .with_label(
                range.span,
                words("the range, in the unit of the value", "el intervalo, en la unidad del valor"),
            )
            .with_hint(words("widen the range or assign other values", "amplía el intervalo o asigna otros valores")),
    )
}

/// Assigned values that are no grid.
fn grid(parameter: &ParameterStatement, assigned: &AssignedRange) -> Option<Diagnostic> {
    let (low, high, name) = (assigned.bounds.low, assigned.bounds.high, &parameter.name.text);
    let Some(step) = assigned.step else {
        let wrong =
            words!("the assigned values of `{name}` have no step", "los valores asignados de `{name}` no tienen paso");
        let hint = words!(
            "state their distance behind the range: assigned {low}..{high} step STEP",
            "indica su distancia detrás del intervalo: assigned {low}..{high} step PASO"
        );
        return Some(Diagnostic::error("assigned-step", wrong, assigned.span).with_hint(hint));
    };
    let fault = Grid::new(low, high, step).err()?;
    let (least, most) = (Grid::LEAST, Grid::MOST);
    let (wrong, hint) = match fault {
        GridFault::Empty => (
            words!(
                "`{name}` has no assigned values from {low} to {high} with the step {step}",
                "`{name}` no tiene valores asignados de {low} a {high} con el paso {step}"
            ),
            words(
                "write the smaller number first, and a step greater than 0",
                "escribe primero el número menor, y un paso mayor que 0",
            ),
        ),
        GridFault::Uneven => (
            words!(
                "from {low} to {high} there is no whole number of steps of {step}",
                "de {low} a {high} no hay un número entero de pasos de {step}"
            ),
            words(
                "choose a step that leads from the first value to the last one",
                "elige un paso que lleve del primer valor al último",
            ),
        ),
        GridFault::TooFew => (
            words!(
                "`{name}` has fewer than {least} assigned values",
                "`{name}` tiene menos de {least} valores asignados"
            ),
            words!(
                "each eighth of the range needs one: take a smaller step than {step}",
                "cada octavo del intervalo necesita uno: toma un paso menor que {step}"
            ),
        ),
        GridFault::TooMany => (
            words!("`{name}` has more than {most} assigned values", "`{name}` tiene más de {most} valores asignados"),
            words!("take a greater step than {step}", "toma un paso mayor que {step}"),
        ),
        GridFault::TooExact => (
            words!(
                "the assigned values of `{name}` have too many digits",
                "los valores asignados de `{name}` tienen demasiadas cifras"
            ),
            words(
                "write fewer digits, or take a unit in which the numbers are neither large nor small",
                "escribe menos cifras, o toma una unidad en la que los números no sean ni grandes ni pequeños",
            ),
        ),
    };
    Some(Diagnostic::error("assigned-values", wrong, assigned.span).with_hint(hint))
}
