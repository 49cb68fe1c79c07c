//! Figures: `"Phase portrait": y' against y`, `"Orbits": y_1 against x_1, y_2 against x_2, equal axes`.

use crate::expressions::{Expressions, dimension_error};
use crate::scan::{find_word, leading_text, split, statements};
use crate::source::trim;
use model::{Diagnostic, ExpressionKind, Span};
use program::Model;
use program::{Curve, Plot};
use std::ops::Range;
use units::{Words, words};

/// How many figures a document may have, and how many curves a figure.
const PLOTS: usize = 24;
const CURVES: usize = 12;

/// Reads the figures in `range`.
pub fn read(expressions: &mut Expressions, range: Range<usize>, plots: &mut Vec<Plot>) {
    for statement in statements(expressions.source, range) {
        if plots.len() == PLOTS {
            expressions.error(
                "too-large",
                words!(
                    "a document cannot have more than {PLOTS} plots",
                    "un documento no puede tener más de {PLOTS} gráficas"
                ),
                span(&statement),
            );
            return;
        }
        plots.extend(plot(expressions, statement));
    }
}

fn span(range: &Range<usize>) -> Span {
    Span::new(range.start, range.end)
}

fn plot(expressions: &mut Expressions, statement: Range<usize>) -> Option<Plot> {
    let source = expressions.source;
    let malformed = |message: Words, range: &Range<usize>| {
        Diagnostic::error("plot-syntax", message, span(range))
            .with_hint(words("a plot is `\"Title\": y, y' against t`", "una gráfica es `\"Título\": y, y' against t`"))
    };
    let title = leading_text(source, statement.clone());
    let Some((title, title_end)) = title.filter(|(title, _)| !title.trim().is_empty()) else {
        expressions.diagnostics.push(malformed(
            words(
                "a plot begins with its title in quotation marks",
                "una gráfica empieza con su título entre comillas",
            ),
            &statement,
        ));
        return None;
    };
    let rest = trim(source, title_end..statement.end);
    if !source[rest.clone()].starts_with(':') {
        expressions.diagnostics.push(malformed(
            words("a colon must follow the title", "tras el título deben ir dos puntos"),
            &(statement.start..title_end),
        ));
        return None;
    }
    let mut parts = split(source, rest.start + 1..rest.end, ',');
    let equal = parts.pop_if(|part| is_equal_axes(&source[part.clone()])).is_some();
    if parts.len() > CURVES {
        expressions.error(
            "too-large",
            words!("a plot cannot have more than {CURVES} curves", "una gráfica no puede tener más de {CURVES} curvas"),
            span(&statement),
        );
        return None;
    }
    let mut plot: Option<Plot> = None;
    // The curves of which it is not yet said what they are drawn against.
    let mut waiting = Vec::new();
    for part in parts {
        let against = find_word(source, part.clone(), "against");
        waiting.push(part.start..against.as_ref().map_or(part.end, |against| against.start));
        if let Some(against) = against {
            let x = curve(expressions, against.end..part.end).and_then(|x| changing(expressions, x));
            let curves: Vec<Curve> =
                waiting.drain(..).filter_map(|part| Some(curve(expressions, part)?.curve)).collect();
            add(expressions, &mut plot, title, curves, x?)?;
        }
    }
    if !waiting.is_empty() || plot.is_none() {
        expressions.diagnostics.push(malformed(
            words("the plot does not say what it is drawn against", "la gráfica no dice frente a qué se dibuja"),
            &statement,
        ));
        return None;
    }
    plot.filter(|plot| !plot.curves.is_empty()).map(|plot| Plot { equal, ..plot })
}

/// Whether a part after a comma asks for units of the same length on both axes.
fn is_equal_axes(part: &str) -> bool {
    part.split_whitespace().eq(["equal", "axes"])
}

/// A curve or an abscissa, and where it stands.
struct Read {
    curve: Curve,
    span: Span,
}

/// Adds curves against `x` to a plot. All abscissas have one dimension.
fn add(expressions: &mut Expressions, plot: &mut Option<Plot>, title: &str, curves: Vec<Curve>, x: Read) -> Option<()> {
    let Some(plot) = plot else {
        let (others, equal) = (Vec::new(), false);
        *plot = Some(Plot { title: title.to_owned(), x: x.curve, curves, others, equal });
        return Some(());
    };
    let (found, expected) = (x.curve.value.dimension(), plot.x.value.dimension());
    if found != expected {
        let message = words!(
            "`{}` cannot share the horizontal axis with `{}`",
            "`{}` no puede compartir el eje horizontal con `{}`",
            x.curve.expression,
            plot.x.expression
        );
        let mut diagnostic = dimension_error(message, (x.span, found), (x.span, expected));
        // Both labels would lie on one another.
        let expected = diagnostic.labels.pop().map(|label| label.text).unwrap_or_default();
        expressions.diagnostics.push(
            diagnostic
                .with_note(words!("the axis is {expected}", "el eje es {expected}", expected = expected))
                .with_hint(words("make it a plot of its own", "haz con ella otra gráfica")),
        );
        return None;
    }
    for curve in curves {
        if x.curve != plot.x {
            plot.others.push((plot.curves.len(), x.curve.clone()));
        }
        plot.curves.push(curve);
    }
    Some(())
}

/// An abscissa that changes during a run; against anything else a curve would be a point.
fn changing(expressions: &mut Expressions, x: Read) -> Option<Read> {
    let dependence = expressions.model().depends(x.curve.value.node);
    if dependence.varies() {
        return Some(x);
    }
    let name = &x.curve.expression;
    let diagnostic = Diagnostic::error(
        "constant-abscissa",
        words!(
            "`{name}` stays the same during a run, so nothing can be drawn against it",
            "`{name}` no cambia durante la simulación: no se puede dibujar nada frente a eso"
        ),
        x.span,
    );
    let time = &expressions.model().independent.name;
    expressions.diagnostics.push(diagnostic.with_hint(words!(
        "draw against `{time}` or against something that changes with it",
        "dibuja frente a `{time}` o frente a algo que cambie con ella"
    )));
    None
}

/// `y'` or `(h_l + h_r)/2 + y "Left level"`
fn curve(expressions: &mut Expressions, range: Range<usize>) -> Option<Read> {
    let source = expressions.source;
    let mut range = trim(source, range);
    let mut label = None;
    if let Some(opening) = source[range.clone()].strip_suffix('"').and_then(|text| text.rfind('"')) {
        let quote = range.start + opening;
        if quote > range.start {
            label = Some(source[quote + 1..range.end - 1].to_owned());
            range = trim(source, range.start..quote);
        }
    }
    let value = expressions.number(range.clone())?.value;
    let expression = source[range.clone()].split_whitespace().collect::<Vec<_>>().join(" ");
    let span = span(&range);
    let label = label.or_else(|| label_of_name(expressions.model(), source, range));
    Some(Read { curve: Curve { expression, label, value }, span })
}

/// The author's label of the name that fills `range`, if a name does.
fn label_of_name(model: &Model, source: &str, range: Range<usize>) -> Option<String> {
    let (expression, _, _) = model::parse_expression(source, range);
    let ExpressionKind::Name { name, order } = expression.kind else {
        return None;
    };
    let state = model.states.iter().find(|state| state.variable == name && state.order == order);
    if let Some(state) = state {
        return state.label.clone();
    }
    if order > 0 {
        return None;
    }
    let quantity = model.quantities.iter().find(|quantity| quantity.name == name).map(|quantity| &quantity.label);
    let parameter =
        || model.parameters.iter().find(|parameter| parameter.name == name).map(|parameter| &parameter.label);
    quantity.or_else(parameter)?.clone()
}
