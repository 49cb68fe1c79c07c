//! Figures: `"Phase portrait": y' against y`.

use crate::expressions::Expressions;
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
    let rest = rest.start + 1..rest.end;
    let Some(against) = find_word(source, rest.clone(), "against") else {
        expressions.diagnostics.push(malformed(
            words("the plot does not say what it is drawn against", "la gráfica no dice frente a qué se dibuja"),
            &statement,
        ));
        return None;
    };
    let x = curve(expressions, against.end..rest.end);
    let parts = split(source, rest.start..against.start, ',');
    if parts.len() > CURVES {
        expressions.error(
            "too-large",
            words!("a plot cannot have more than {CURVES} curves", "una gráfica no puede tener más de {CURVES} curvas"),
            span(&statement),
        );
        return None;
    }
    let curves: Vec<Curve> = parts.into_iter().filter_map(|part| curve(expressions, part)).collect();
    if curves.is_empty() {
        return None;
    }
    Some(Plot { title: title.to_owned(), x: x?, curves })
}

/// `y'` or `(h_l + h_r)/2 + y "Left level"`
fn curve(expressions: &mut Expressions, range: Range<usize>) -> Option<Curve> {
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
    let label = label.or_else(|| label_of_name(expressions.model(), source, range));
    Some(Curve { expression, label, value })
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
