//! The plot of the cycles: measured ones with error bars, a constant where the linear theory has one, and the cycles of
//! the run beside them.

use crate::cycles::{Found, capital};
use crate::plot::{Labels, MEASURED, PlotState};
use crate::recognise::observed;
use crate::{Session, number};
use analysis::cycles::{Cycle, Quantity, cycles, mean, well_known};
use engine::Readings;
use figure::{Axis, Interval, Plot, Readout, Series, Style, View};
use units::Language;

/// So many rows of a run are enough for its cycles, unless it has many of these.
const FEW_ROWS: usize = 2000;
/// So many rows a period are enough.
const ROWS_PER_PERIOD: f64 = 32.0;

/// Which of the plot's series is the measured one.
pub(crate) const CYCLES_MEASURED: usize = 2;

/// What is drawn of the cycles, in the units of the axes.
#[derive(Debug, Default)]
pub(crate) struct CyclePlot {
    measured: Points,
    /// The mean of all, where the linear theory has the same for all.
    constant: Vec<f64>,
    run: Points,
    limits: Option<Interval>,
    /// The cycles of the run that is recorded, and which run that is.
    of_run: Vec<Cycle>,
    seen: Option<(u64, u64)>,
}

#[derive(Debug, Default)]
struct Points {
    x: Vec<f64>,
    y: Vec<f64>,
    errors: Vec<f64>,
}

impl Points {
    fn of(cycles: &[Cycle], quantity: Quantity, against_amplitude: bool) -> Self {
        let across = |cycle: &Cycle| if against_amplitude { cycle.amplitude.value } else { cycle.time.value };
        let measured: Vec<_> = cycles.iter().map(|cycle| quantity.of(cycle)).collect();
        Self {
            x: cycles.iter().map(across).collect(),
            y: measured.iter().map(|one| one.value).collect(),
            errors: measured.iter().map(|one| one.error).collect(),
        }
    }
}

impl Session {
    /// Which of [`Session::plots`] is that of the cycles.
    pub fn cycle_plot(&self) -> usize {
        self.document.program.plots.len() + 1
    }

    /// Takes what is to be drawn from what was found.
    pub(crate) fn draw_cycles(&mut self) {
        let (quantity, against) = (self.cycle_view.quantity, self.cycle_view.against_amplitude);
        let found = self.cycle_view.found.as_ref().and_then(|found| found.cycles.as_ref());
        let cycles = found.map_or(&[][..], |found| &found.cycles);
        let plot = &mut self.cycle_plot;
        plot.measured = Points::of(cycles, quantity, against);
        plot.run = Points::of(&plot.of_run, quantity, against);
        let measured: Vec<_> = cycles.iter().map(|cycle| quantity.of(cycle)).collect();
        // An amplitude falls in every theory with damping; it is shown down to nothing.
        let falls = quantity == Quantity::Amplitude;
        plot.limits = well_known(&measured).filter(|_| !falls).map(|(low, high)| {
            let room = 0.08 * (high - low);
            Interval::new(low - room, high + room)
        });
        let mean = mean(&measured).filter(|_| !falls);
        plot.constant = mean.map(|mean| vec![mean.value; measured.len()]).unwrap_or_default();
        // Another run is looked for, within the times of this record.
        plot.seen = None;
        self.label_cycles();
        self.revision.plots += 1;
    }

    /// Finds the cycles of the run, once it stands still.
    pub(crate) fn follow_cycles(&mut self) {
        if self.cycle_view.found.as_ref().is_none_or(|found| found.cycles.is_none()) {
            return;
        }
        let now = (self.revision.parameters, self.course.rows() as u64);
        let plot = &mut self.cycle_plot;
        if self.playing {
            // A line of another run would be a lie.
            if plot.seen.is_some_and(|seen| seen.0 != now.0 || now.1 < seen.1) {
                (plot.of_run, plot.run, plot.seen) = (Vec::new(), Points::default(), None);
            }
            return;
        }
        if plot.seen == Some(now) {
            return;
        }
        let found = self.cycle_view.found.as_ref().and_then(|found| self.cycles_of_run(found)).unwrap_or_default();
        let plot = &mut self.cycle_plot;
        plot.run = Points::of(&found, self.cycle_view.quantity, self.cycle_view.against_amplitude);
        (plot.of_run, plot.seen) = (found, Some(now));
    }

    /// The cycles of the run in the times of the record, of what the column measures.
    fn cycles_of_run(&self, found: &Found) -> Option<Vec<Cycle>> {
        let model = self.model();
        let observed = observed(model, &found.name).filter(|_| !found.name.is_empty())?;
        let (history, time_unit) = (self.course.history()?, &model.independent.unit);
        let clock = |time: f64| time_unit.from_si(time + found.origin);
        let times = history.times().get(..self.course.rows())?;
        let first = times.partition_point(|time| clock(*time) < found.ends.0);
        let last = times.partition_point(|time| clock(*time) <= found.ends.1);
        let periods =
            (found.ends.1 - found.ends.0) * found.cycles.as_ref()?.estimate.angular_frequency / core::f64::consts::TAU;
        let most = FEW_ROWS.max((ROWS_PER_PERIOD * periods) as usize);
        let mut readings = Readings::new(model, &[observed.node]);
        let rows = (first..last).step_by(last.saturating_sub(first).div_ceil(most).max(1));
        let (times, values): (Vec<f64>, Vec<f64>) = rows
            .map(|row| {
                let value = readings.at_row(history, row).first().copied().unwrap_or(f64::NAN);
                (clock(history.time(row)), found.unit.from_si(value))
            })
            .unzip();
        Some(cycles(&times, &values)?.cycles)
    }

    /// Writes the texts of the plot in the session's language.
    pub(crate) fn label_cycles(&mut self) {
        let (quantity, against) = (self.cycle_view.quantity, self.cycle_view.against_amplitude);
        let units = self.cycle_view.found.as_ref().map(|found| self.cycle_units(found)).unwrap_or_default();
        let independent = crate::symbol(&self.model().independent.name);
        let axis = |quantity: Quantity| (quantity.symbol(self.language).to_owned(), quantity.unit(&units.0, &units.1));
        let x = if against { axis(Quantity::Amplitude) } else { (independent, units.1.clone()) };
        let title = cycles_title(self.language, &capital(quantity.name(self.language)), against);
        let description = format!("{title}. {}", cycles_description(self.language));
        let curves = cycles_legend(self.language).map(str::to_owned).to_vec();
        let index = self.cycle_plot();
        if let Some(state) = self.plots.get_mut(index) {
            // What was zoomed was another quantity.
            if state.labels.title != title {
                state.view = View::default();
            }
            state.labels = Labels { title, description, x, axes: vec![axis(quantity)], curves };
        }
    }

    /// What is drawn.
    pub(crate) fn cycle_figure<'a>(&'a self, state: &'a PlotState) -> Option<Plot<'a>> {
        let plot = &self.cycle_plot;
        let labels = &state.labels;
        let [constant, run, measured] = labels.curves.as_slice() else { return None };
        let drawn = |label: &'a str, shown: bool| if shown { label } else { "" };
        let series = vec![
            Series {
                label: drawn(constant, !plot.constant.is_empty()),
                colour: 1,
                style: Style::Kept(0),
                x: &plot.measured.x,
                y: &plot.constant,
                ..Series::default()
            },
            Series { label: drawn(run, !plot.run.x.is_empty()), x: &plot.run.x, y: &plot.run.y, ..Series::default() },
            Series {
                label: measured,
                colour: MEASURED,
                style: Style::Points,
                x: &plot.measured.x,
                y: &plot.measured.y,
                spread: &plot.measured.errors,
                ..Series::default()
            },
        ];
        let limits = plot.limits.filter(|_| state.view.y.is_empty());
        let view = View { x: state.view.x, y: limits.map_or_else(|| state.view.y.clone(), |limits| vec![limits]) };
        // Sizes begin at nothing.
        let nothing = Interval { low: 0.0, high: 0.0 };
        let (against, falls) = (self.cycle_view.against_amplitude, self.cycle_view.quantity == Quantity::Amplitude);
        Some(Plot {
            title: &labels.title,
            description: &labels.description,
            x: Axis { label: &labels.x.0, unit: &labels.x.1, include: against.then_some(nothing) },
            y: labels
                .axes
                .iter()
                .map(|(label, unit)| Axis { label, unit, include: falls.then_some(nothing) })
                .collect(),
            series,
            marker: None,
            view,
            ordered: !against,
            equal: false,
        })
    }

    /// A read-out of the plot, the measured values with their errors.
    pub(crate) fn with_errors(&self, mut readout: Readout) -> Readout {
        let errors = &self.cycle_plot.measured.errors;
        let labels = self.plots.get(self.cycle_plot()).map(|state| &state.labels);
        let (name, unit) = labels.and_then(|labels| labels.axes.first().cloned()).unwrap_or_default();
        for sample in &mut readout.samples {
            let error = errors.get(sample.row).copied().filter(|_| sample.series == CYCLES_MEASURED);
            let Some(error) = error else { continue };
            let value = number::with_error(sample.y, Some(error), self.style);
            sample.text = format!("{name} = {}", number::error_with_unit(&value, &unit));
        }
        readout
    }
}

fn cycles_title(language: Language, quantity: &str, against_amplitude: bool) -> String {
    match against_amplitude {
        true => language.pick(format!("{quantity} against amplitude"), format!("{quantity} frente a la amplitud")),
        false => language.pick(format!("{quantity} against time"), format!("{quantity} frente al tiempo")),
    }
}

fn cycles_description(language: Language) -> &'static str {
    language.pick(
        "Each point is a turning point with the half-cycles around it; bars are one standard error.",
        "Cada punto es un punto de retorno con los semiciclos a su alrededor; las barras son un error estándar.",
    )
}

/// The names of the constant, of the run's cycles, of the measured ones.
fn cycles_legend(language: Language) -> [&'static str; 3] {
    language.pick(["if constant", "simulation", "measured"], ["si es constante", "simulación", "medido"])
}
