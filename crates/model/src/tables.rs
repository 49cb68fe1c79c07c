//! Functions that are given by a table: `table eta(T) in [mPa s] { 273 [K] 1.792  293 1.002 }`.

use crate::{Course, Diagnostic, Point, Span, StatedUnit, TableStatement, limits};
use program::Interpolation;
use std::cmp::Ordering;
use std::sync::Arc;
use units::{Dimension, words};

/// A table as expressions use it.
#[derive(Clone, Debug)]
pub(crate) struct TableFunction {
    /// What its argument is called.
    pub argument_name: String,
    /// The dimension of its argument.
    pub argument: Dimension,
    /// The dimension of its values.
    pub value: Dimension,
    pub interpolation: Arc<Interpolation>,
    /// Where the unit of its argument stands, or else its name.
    pub span: Span,
}

impl TableStatement {
    /// What expressions use; says what is wrong with the points.
    pub(crate) fn checked(&self, diagnostics: &mut Vec<Diagnostic>) -> Option<TableFunction> {
        let si = |unit: &Option<StatedUnit>, value| unit.as_ref().map_or(value, |stated| stated.unit.to_si(value));
        let point = |point: &Point| [si(&self.argument_unit, point.x), si(&self.unit, point.y)];
        let points: Vec<[f64; 2]> = self.points.iter().map(point).collect();
        let interpolation = match self.course {
            Course::Linear => Interpolation::linear(&points),
            Course::Smooth => Interpolation::smooth(&points),
            Course::Steps => Interpolation::steps(&points),
        };
        match interpolation {
            Some(interpolation) if points.len() > 1 => {
                let dimension =
                    |unit: &Option<StatedUnit>| unit.as_ref().map_or(Dimension::NONE, |unit| unit.unit.dimension);
                Some(TableFunction {
                    argument_name: self.argument.text.clone(),
                    argument: dimension(&self.argument_unit),
                    value: dimension(&self.unit),
                    interpolation: Arc::new(interpolation),
                    span: self.argument_unit.as_ref().map_or(self.name.span, |unit| unit.span),
                })
            }
            _ => {
                diagnostics.push(self.disorder());
                None
            }
        }
    }

    /// What is wrong with the points.
    fn disorder(&self) -> Diagnostic {
        let (name, argument) = (&self.name.text, &self.argument.text);
        if self.points.len() < 2 {
            let message =
                words!("the table `{name}` has fewer than two points", "la tabla `{name}` tiene menos de dos puntos");
            let hint = words!(
                "what is the same everywhere is a definition: `{name} = ...`",
                "lo que es igual en todas partes es una definición: `{name} = ...`"
            );
            return Diagnostic::error("table-points", message, self.name.span).with_hint(hint);
        }
        if let Some(pair) =
            self.points.windows(2).find(|pair| pair[0].x.partial_cmp(&pair[1].x) != Some(Ordering::Less))
        {
            let twice = pair[0].x == pair[1].x;
            let message = if twice {
                words!(
                    "two points of the table `{name}` have the same {argument}",
                    "dos puntos de la tabla `{name}` tienen el mismo {argument}"
                )
            } else {
                words!(
                    "in the table `{name}`, {argument} must increase from point to point",
                    "en la tabla `{name}`, {argument} debe crecer de un punto al siguiente"
                )
            };
            let hint = if twice {
                words(
                    "for a jump write `steps table`, or move one of the points a little",
                    "para un salto escribe `steps table`, o mueve un poco uno de los puntos",
                )
            } else {
                words("put the points into order", "pon los puntos en orden")
            };
            return Diagnostic::error("table-order", message, pair[1].span)
                .with_label(pair[0].span, words("the point before", "el punto anterior"))
                .with_hint(hint);
        }
        let message =
            words!("a number of the table `{name}` is too large", "un número de la tabla `{name}` es demasiado grande");
        Diagnostic::error("number-too-large", message, self.name.span)
    }
}

/// The error of a table with too many points.
pub(crate) fn too_many_points(span: Span) -> Diagnostic {
    let message =
        words!("a table has at most {} points", "una tabla tiene como máximo {} puntos", limits::TABLE_POINTS);
    Diagnostic::error("model-too-large", message, span)
}
