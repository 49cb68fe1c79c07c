//! Measured values beside the model: the columns in use as points over the curves.

use crate::measured::MeasuredData;
use crate::measured::data::{Measured, Residuals};
use crate::records::Records;
use crate::records::recognise::observed;
use crate::records::series::turn;
use crate::words;
use document::Document;
use engine::Readings;
use play::{Play, Points, points_colour, symbol};
use program::{Curve, Drawing};
use units::Language;

/// Maximum length of a record's name in a legend, in characters.
const LONGEST_NAME: usize = 24;

impl MeasuredData {
    /// Takes the columns in use of the records, and draws them. Needed when records or the meanings of their columns have
    /// changed.
    pub(crate) fn renew(&mut self, play: &mut Play, document: &Document, records: &Records) {
        let model = play.model();
        let independent = &model.independent;
        let autonomous = model.is_autonomous();
        let mut measured = Vec::new();
        for record in records.all().iter().filter(|record| record.is_shown()) {
            let origin = record.origin(independent, autonomous);
            for (index, used) in record.uses().iter().enumerate() {
                let name = &used.meaning.quantity;
                if name.is_empty() || *name == independent.name {
                    continue;
                }
                let Some(observed) = observed(model, name) else { continue };
                if observed.dimension() == used.meaning.unit.dimension
                    && let Some((mut times, mut values)) = record.series(index, independent)
                {
                    times.iter_mut().for_each(|time| *time -= origin);
                    turn(&mut values, &used.meaning.unit, &observed.unit);
                    values.iter_mut().for_each(|value| *value -= used.offset);
                    let pause = usual_pause(&times);
                    let errors = record.errors_beside(record.uses(), index, &independent.name);
                    let mut errors = errors.unwrap_or_default();
                    turn(&mut errors, &used.meaning.unit, &observed.unit);
                    let excluded = record.excluded();
                    let excluded = (!excluded.is_empty()).then(|| {
                        record.marks_as(record.uses(), index, &independent.name, excluded).unwrap_or_default()
                    });
                    let excluded = excluded.unwrap_or_default();
                    let (record, record_name, name) = (record.id(), record.name().to_owned(), name.clone());
                    measured.push(Measured {
                        record,
                        column: index,
                        record_name,
                        name,
                        observed,
                        times,
                        values,
                        errors,
                        excluded,
                        pause,
                    });
                }
            }
        }
        let language = play.basis().language();
        let drawn = document.program.plots.iter().map(|plot| points(model, plot, &measured, language));
        let drawn: Vec<_> = drawn.collect();
        self.residuals = measured
            .iter()
            .map(|measured| Residuals { readings: Readings::new(model, &[measured.observed.node]), passed: 0 })
            .collect();
        self.columns = measured;
        self.version += 1;
        for (plot, mut points) in drawn.into_iter().enumerate() {
            for (number, points) in points.iter_mut().enumerate() {
                points.version = self.version_of(number);
            }
            play.change_plots(|plots, _| plots.set_points(plot, points));
        }
        self.begin_outline(play, document);
        self.begin_residuals(play);
    }
}

/// Measured points of a plot.
fn points(model: &program::Model, plot: &program::Plot, measured: &[Measured], language: Language) -> Vec<Points> {
    let mut found = Vec::new();
    if plot.drawing != Drawing::Run {
        return found;
    }
    let of = |curve: &Curve, measured: &&Measured| {
        let (own, shown) = (&measured.observed, &curve.value);
        // `omega in [Hz]` draws the column of `omega`, too.
        let node = match own.unit.turning(&shown.unit) {
            1.0 => own.node,
            _ => model::turned(&mut model.graph.clone(), own.node, &own.unit, &shown.unit),
        };
        node == shown.node
    };
    // Curves of the same dimension share an axis and the unit of the first of them.
    let unit = |curve: &Curve| {
        let same = |other: &&Curve| other.value.dimension() == curve.value.dimension();
        plot.curves.iter().find(same).map_or_else(|| curve.value.unit.clone(), |first| first.value.unit.clone())
    };
    for (number, curve) in plot.curves.iter().enumerate() {
        let (unit, across) = (unit(curve), plot.x_of(number));
        let against_time = model.is_independent(across.value.node);
        for (place, column) in measured.iter().enumerate().filter(|(_, measured)| of(curve, measured)) {
            let (x_unit, y_unit) = (&plot.x.value.unit, &unit);
            let turning = column.observed.unit.turning(y_unit);
            let up = |value: &f64| y_unit.from_si(value * turning);
            let other = measured.iter().find(|other| other.record == column.record && of(across, other));
            if !against_time && other.is_none() {
                continue;
            }
            let across = |time: &f64| {
                let Some(other) = other.filter(|_| !against_time) else { return Some(x_unit.from_si(*time)) };
                let turned = other.observed.unit.turning(x_unit);
                let row = other.times.partition_point(|at| at < time);
                let same = other.times.get(row) == Some(time);
                Some(x_unit.from_si(*other.values.get(row).filter(|_| same)? * turned))
            };
            let label = format!("{} ({})", symbol(&curve.expression), shortened(&column.record_name));
            for unused in [false, true] {
                let colour = points_colour(place);
                let mut points = Points { curve: number, colour, column: place, unused, ..Points::default() };
                for (row, (time, value)) in column.times.iter().zip(&column.values).enumerate() {
                    let Some(x) = across(time).filter(|_| column.excludes(row) == unused) else { continue };
                    points.places.push(row);
                    points.x.push(x);
                    points.y.push(up(value));
                    if !column.errors.is_empty() {
                        points.errors.push(column.errors.get(row).map_or(f64::NAN, up));
                    }
                }
                if unused && points.x.is_empty() {
                    continue;
                }
                let named = |name: &str| if unused { words::left_out(language, name) } else { name.to_owned() };
                (points.source, points.label) = (named(&column.record_name), named(&label));
                found.push(points);
            }
        }
    }
    found
}

/// Name of a record, shortened for a legend.
pub(crate) fn shortened(name: &str) -> String {
    if name.chars().count() <= LONGEST_NAME {
        return name.to_owned();
    }
    let start: String = name.chars().take(LONGEST_NAME - 1).collect();
    format!("{}…", start.trim_end())
}

/// Longest interval between two times that is not a gap: three times the median interval. For long records the median
/// is taken of a sample.
fn usual_pause(times: &[f64]) -> f64 {
    const ENOUGH: usize = 10_000;
    let pairs = times.windows(2).step_by(1 + times.len() / ENOUGH);
    let pauses: Vec<f64> = pairs.map(|pair| pair[1] - pair[0]).filter(|pause| *pause > 0.0).collect();
    if pauses.is_empty() {
        return f64::INFINITY;
    }
    3.0 * units::order::median(pauses)
}
