//! Plot of the cycles: measured cycles with error bars, a constant where the linear theory predicts one, and the cycles
//! of the simulated run.

use crate::cycles::Cycles;
use crate::cycles::drawn::Points;
use crate::cycles::found::Found;
use crate::cycles::view::units_of;
use crate::records::recognise::observed;
use analysis::cycles::{Cycle, Quantity, cycles, mean, well_known};
use engine::Readings;
use figure::{Interval, Style};
use play::{AddedPlot, AddedSeries, Labels, Play, points_colour};
use units::alphabet::capitalised;
use units::{Language, say};

/// Number of rows of a run that are read to find its cycles. More are read if the run has many cycles.
const FEW_ROWS: usize = 2000;
/// Number of rows per period that are read.
const ROWS_PER_PERIOD: f64 = 32.0;

/// Index of the measured series in the plot.
const MEASURED: usize = 2;

impl Cycles {
    /// Computes the series of the plot from the cycles that were found.
    pub(crate) fn draw(&mut self, play: &mut Play) {
        let (quantity, against) = (self.view.quantity, self.view.against_amplitude);
        let found = self.found.as_ref().and_then(|found| found.cycles.as_ref().ok());
        let cycles = found.map_or(&[][..], |found| &found.cycles);
        let plot = &mut self.drawn;
        plot.measured = Points::of(cycles, quantity, against);
        plot.run = Points::of(&plot.of_run, quantity, against);
        let measured: Vec<_> = cycles.iter().map(|cycle| quantity.of(cycle)).collect();
        // The amplitude decreases in every damped theory, so its axis starts at 0 instead.
        let falls = quantity == Quantity::Amplitude;
        plot.limits = well_known(&measured).filter(|_| !falls).map(|(low, high)| {
            let room = 0.08 * (high - low);
            Interval::new(low - room, high + room)
        });
        let mean = mean(&measured).filter(|_| !falls);
        plot.constant = mean.map(|mean| vec![mean.value; measured.len()]).unwrap_or_default();
        // Forces a new search for the cycles of the run, within the times of this record.
        plot.seen = None;
        self.label(play);
    }

    /// Finds the cycles of the run once it is paused.
    pub(crate) fn follow(&mut self, play: &mut Play) {
        if self.found.as_ref().is_none_or(|found| found.cycles.is_err()) {
            return;
        }
        let now = (play.revision().parameters, play.course().rows() as u64);
        let plot = &mut self.drawn;
        if play.time_line().is_playing() {
            // Cycles of another run must not stay in the plot.
            if plot.seen.is_some_and(|seen| seen.0 != now.0 || now.1 < seen.1) {
                (plot.of_run, plot.run, plot.seen) = (Vec::new(), Points::default(), None);
                self.show_plot(play);
            }
            return;
        }
        if plot.seen == Some(now) {
            return;
        }
        let found = self.found.as_ref().and_then(|found| cycles_of_run(play, found)).unwrap_or_default();
        let plot = &mut self.drawn;
        plot.run = Points::of(&found, self.view.quantity, self.view.against_amplitude);
        (plot.of_run, plot.seen) = (found, Some(now));
        self.show_plot(play);
    }

    /// Sets the texts of the plot in the chosen language.
    pub(crate) fn label(&self, play: &mut Play) {
        let (quantity, against) = (self.view.quantity, self.view.against_amplitude);
        let units = self.found.as_ref().map(|found| units_of(play, found)).unwrap_or_default();
        let independent = play::symbol(&play.model().independent.name);
        let axis = |quantity: Quantity| {
            (quantity.symbol(play.basis().language()).to_owned(), quantity.unit(&units.0, &units.1))
        };
        let x = if against { axis(Quantity::Amplitude) } else { (independent, units.1.clone()) };
        let title =
            cycles_title(play.basis().language(), &capitalised(quantity.name(play.basis().language())), against);
        let description = format!("{title}. {}", cycles_description(play.basis().language()));
        let curves = cycles_legend(play.basis().language()).map(str::to_owned).to_vec();
        let labels = Labels { title, description, x, axes: vec![axis(quantity)], curves, ..Labels::default() };
        play.change_plots(|plots, _| plots.change_added(self.plot, |plot| plot.labels = labels));
        self.show_plot(play);
    }

    /// Passes the series to the plot.
    fn show_plot(&self, play: &mut Play) {
        let drawn = &self.drawn;
        let constant = AddedSeries {
            colour: 1,
            style: Style::Kept(0),
            in_legend: !drawn.constant.is_empty(),
            x: drawn.measured.x.clone(),
            y: drawn.constant.clone(),
            ..AddedSeries::default()
        };
        let run = AddedSeries {
            in_legend: !drawn.run.x.is_empty(),
            x: drawn.run.x.clone(),
            y: drawn.run.y.clone(),
            ..AddedSeries::default()
        };
        let measured = AddedSeries {
            colour: points_colour(0),
            style: Style::Points,
            in_legend: true,
            x: drawn.measured.x.clone(),
            y: drawn.measured.y.clone(),
            errors: drawn.measured.errors.clone(),
            ..AddedSeries::default()
        };
        // Axes of amplitudes start at 0.
        let nothing = Interval { low: 0.0, high: 0.0 };
        let (against, falls) = (self.view.against_amplitude, self.view.quantity == Quantity::Amplitude);
        let limits = drawn.limits;
        let offered = self.found.as_ref().is_some_and(|found| found.cycles.is_ok());
        let change = |plot: &mut AddedPlot| {
            *plot = AddedPlot {
                labels: std::mem::take(&mut plot.labels),
                series: vec![constant, run, measured],
                x_includes: against.then_some(nothing),
                y_includes: falls.then_some(nothing),
                y_limits: limits,
                marks_time: false,
                ordered: !against,
                offered,
                apart: true,
                cursor: MEASURED,
            };
        };
        play.change_plots(|plots, _| plots.change_added(self.plot, change));
    }
}

/// Cycles of the run within the times of the record, for the quantity that the column measures.
fn cycles_of_run(play: &Play, found: &Found) -> Option<Vec<Cycle>> {
    let model = play.model();
    let observed = observed(model, &found.name).filter(|_| !found.name.is_empty())?;
    let (history, time_unit) = (play.course().history()?, &model.independent.unit);
    let clock = |time: f64| time_unit.from_si(time + found.origin);
    let times = history.times().get(..play.course().rows())?;
    let first = times.partition_point(|time| clock(*time) < found.ends.0);
    let last = times.partition_point(|time| clock(*time) <= found.ends.1);
    let periods =
        (found.ends.1 - found.ends.0) * found.cycles.as_ref().ok()?.estimate.angular_frequency / core::f64::consts::TAU;
    let most = FEW_ROWS.max((ROWS_PER_PERIOD * periods) as usize);
    let mut readings = Readings::new(model, &[observed.node]);
    let rows = (first..last).step_by(last.saturating_sub(first).div_ceil(most).max(1));
    let (times, values): (Vec<f64>, Vec<f64>) = rows
        .map(|row| {
            let value = readings.at_row(history, row).first().copied().unwrap_or(f64::NAN);
            (clock(history.time(row)), found.unit.from_si(value))
        })
        .unzip();
    Some(cycles(&times, &values).ok()?.cycles)
}

fn cycles_title(language: Language, quantity: &str, against_amplitude: bool) -> String {
    match against_amplitude {
        true => say!(language, "{quantity} against amplitude"),
        false => say!(language, "{quantity} against time"),
    }
}

fn cycles_description(language: Language) -> &'static str {
    language.say("Each point is a turning point with the half-cycles around it; bars are one standard error.")
}

/// Legends of the constant, of the cycles of the run and of the measured cycles.
fn cycles_legend(language: Language) -> [&'static str; 3] {
    language.say_all(["if constant", "simulation", "measured"])
}
