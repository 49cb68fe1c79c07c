//! Figures: the document's plots with the present and kept runs, and content added by other crates.

mod added;
mod drawn;
mod histogram;
mod labelling;
mod labels;
mod members;
mod plot;
mod reading;
mod section;
mod series;
mod sweep;
pub(crate) mod traces;
mod viewing;

pub use added::{AddedPlot, AddedSeries, Points, points_colour};
pub use labels::Labels;
pub use plot::{PlotId, PlotView};
pub use series::LegendEntry;

use crate::{Basis, Changes, OpenRun, TimeLine, WORK_PER_TICK};
use figure::{Direction, Figure, Interval, Point, Readout, Settings, Style, View};
use histogram::Histogram;
use members::Snapshot;
use program::{Drawing, Plot, Program};
use section::{Moments, Section};
use std::cell::OnceCell;
use sweep::Swept;
pub use sweep::{SweepComputation, SweepNews, SweepWork, SweepWorkers, TakenRun};
use traces::Columns;

/// Number of document plots shown initially: the scene needs the room, and the others are one click away.
const AT_FIRST: usize = 1;

/// The plots: those of the document in the order of the text, then added ones.
#[derive(Debug, Default)]
pub struct Plots {
    states: Vec<PlotState>,
    /// Time (SI) up to which records are drawn, without the runs; `None` for whole records with the runs.
    records_until: Option<f64>,
}

/// The plots as they are shown: with the run, in the chosen language.
#[derive(Clone, Debug)]
pub struct Figures<'a> {
    basis: &'a Basis,
    line: &'a TimeLine,
    plots: &'a Plots,
    /// Names of the kept runs that are drawn, once a plot needs them.
    runs: OnceCell<Vec<String>>,
}

impl Plots {
    /// Plots of the document.
    pub(crate) fn new(program: &Program, columns: &Columns) -> Self {
        Self { states: PlotState::of_document(program, columns), records_until: None }
    }

    /// The plots as they are shown.
    pub(crate) fn seen<'a>(&'a self, OpenRun { basis, line }: OpenRun<'a>) -> Figures<'a> {
        Figures { basis, line, plots: self, runs: OnceCell::new() }
    }

    /// Must be called when the model has changed.
    pub(crate) fn model_changed(&mut self, program: &Program, columns: &Columns) {
        for (own, new) in self.states.iter_mut().zip(PlotState::of_document(program, columns)) {
            own.content = new.content;
        }
    }

    /// Updates the contents to the front of the run, whose columns must be up to date.
    pub(crate) fn follow(&mut self, line: &mut TimeLine) {
        for (index, plot) in self.states.iter_mut().enumerate() {
            match &mut plot.content {
                Content::Run => {}
                Content::Section(section) => section.follow(line.course_between_rows()),
                Content::Swept(swept) => swept.follow(line.course()),
                Content::Profile(profile, _) => profile.follow(line.course()),
                Content::Histogram(histogram) => {
                    let plot = line.columns().plot(index);
                    let column = plot.map_or(&[][..], |plot| line.traces().column(plot.x));
                    histogram.follow(line.course(), column);
                }
            }
        }
    }

    /// Discards the rows processed, because another run replaces the present one.
    pub(crate) fn forget_rows(&mut self) {
        self.states.iter_mut().for_each(PlotState::forget_rows);
    }

    /// Continues the runs of sweep plots that are shown, limited to [`WORK_PER_TICK`] per call. Returns true if work
    /// remains.
    pub fn work(&mut self, run: OpenRun<'_>) -> (bool, Changes) {
        let mut left = WORK_PER_TICK;
        let mut worked = false;
        for swept in self.shown_sweeps() {
            swept.follow(run.course());
            let before = swept.progress();
            swept.proceed(run.line.motion(run.basis), &mut left);
            worked |= swept.progress() != before;
        }
        (self.shown_sweeps().any(|swept| swept.is_unfinished()), Changes::FRAME.only_if(worked))
    }

    /// As [`Plots::work`], but workers compute what the first call after a change leaves. The picture is the same to the bit.
    /// Returns true if work remains here; when workers have news, it must be called again.
    pub fn work_beside(&mut self, run: OpenRun<'_>, workers: &mut dyn SweepWorkers) -> (bool, Changes) {
        for plot in self.states.iter_mut().filter(|plot| !plot.shown) {
            plot.swept_mut().into_iter().for_each(Swept::take_back);
        }
        let mut sweeps: Vec<&mut Swept> = self.shown_sweeps().collect();
        sweeps.iter_mut().for_each(|swept| swept.follow(run.course()));
        let in_progress =
            |sweeps: &[&mut Swept]| sweeps.iter().flat_map(|swept| swept.in_progress()).collect::<Vec<_>>();
        let before: Vec<_> = sweeps.iter().map(|swept| swept.progress()).collect();
        workers.keep(&in_progress(&sweeps));
        for (number, news) in workers.news() {
            sweeps.iter_mut().for_each(|swept| swept.take_news(number, &news));
        }
        let mut busy = in_progress(&sweeps).len();
        let mut left = WORK_PER_TICK;
        let mut remains = false;
        for swept in sweeps.iter_mut().filter(|swept| swept.is_unfinished()) {
            let count = if swept.is_new() { 0 } else { workers.count() };
            if count == 0 {
                swept.take_back();
                swept.proceed(run.line.motion(run.basis), &mut left);
                remains |= swept.is_unfinished();
            } else {
                busy += swept.hand_out(run.basis.model(), workers, [count.saturating_sub(busy), count]);
            }
        }
        let worked = sweeps.iter().map(|swept| swept.progress()).ne(before);
        (remains, Changes::FRAME.only_if(worked))
    }

    /// Curves over parameters that are shown.
    fn shown_sweeps(&mut self) -> impl Iterator<Item = &mut Swept> {
        self.states.iter_mut().filter(|plot| plot.shown).filter_map(PlotState::swept_mut)
    }

    /// Shows or hides a plot.
    pub fn show(&mut self, PlotId(index): PlotId, shown: bool) -> Changes {
        let plot = self.states.get_mut(index);
        Changes::PLOTS.only_if(plot.map(|plot| plot.shown = shown).is_some())
    }

    /// Shows the first plots without zoom, as at first.
    pub(crate) fn reset_all(&mut self) -> Changes {
        for (index, plot) in self.states.iter_mut().enumerate() {
            (plot.shown, plot.view) = (index < AT_FIRST, View::default());
        }
        Changes::PLOTS
    }

    /// Shows all plots of the document except those with these indices; `None` if one does not exist.
    pub(crate) fn show_except(&mut self, hidden: impl Iterator<Item = Option<usize>>) -> Option<Changes> {
        self.states.iter_mut().for_each(|plot| plot.shown = plot.added.is_none());
        for index in hidden {
            self.states.get_mut(index?)?.shown = false;
        }
        Some(Changes::PLOTS)
    }

    /// Indices of the hidden plots of the document; `None` if they are those hidden at first.
    pub(crate) fn hidden(&self, of_document: usize) -> Option<Vec<usize>> {
        let hidden = self.states.iter().take(of_document).enumerate().filter(|(_, plot)| !plot.shown);
        let hidden: Vec<usize> = hidden.map(|(index, _)| index).collect();
        (!hidden.iter().copied().eq(AT_FIRST..of_document)).then_some(hidden)
    }

    /// Indices and views of the zoomed plots.
    pub(crate) fn zoomed(&self) -> impl Iterator<Item = (usize, &View)> {
        self.states.iter().map(|plot| &plot.view).enumerate().filter(|(_, view)| !view.is_automatic())
    }

    /// Zooms a plot to a view; `None` if it has other axes.
    pub(crate) fn set_view(&mut self, index: usize, view: View) -> Option<Changes> {
        let plot = self.states.get_mut(index)?;
        let fits = view.y.is_empty() || view.y.len() == plot.labels.axes.len();
        fits.then(|| {
            plot.view = view;
            Changes::PLOTS
        })
    }

    /// Adds an empty plot after the others. It is hidden until it is asked for, unless it is the only one.
    pub fn add(&mut self) -> (PlotId, Changes) {
        self.states.push(PlotState { shown: self.states.is_empty(), ..PlotState::added() });
        (PlotId(self.states.len() - 1), Changes::PLOTS)
    }

    /// Changes an added plot. If it gets another title, the zoom is reset because it referred to other content. Does
    /// nothing if the plot is not an added one.
    pub fn change_added(&mut self, id: PlotId, change: impl FnOnce(&mut AddedPlot)) -> Changes {
        let Some(state) = self.states.get_mut(id.0) else { return Changes::NONE };
        let Some(added) = &mut state.added else { return Changes::NONE };
        change(added);
        if added.labels.title != state.labels.title {
            state.view = View::default();
            state.labels.title.clone_from(&added.labels.title);
        }
        Changes::PLOTS
    }

    /// Replaces the points over the curves of a plot of the document.
    pub fn set_points(&mut self, plot: usize, points: Vec<Points>) -> Changes {
        let Some(state) = self.states.get_mut(plot) else { return Changes::NONE };
        let ends = |points: &Points| {
            // Error bars are drawn whole.
            let errors = points.errors.iter().map(|error| if error.is_finite() { *error } else { 0.0 });
            let errors = errors.chain(std::iter::repeat(0.0));
            let bars = points.y.iter().zip(errors).flat_map(|(y, error)| [y - error, y + error]);
            [Interval::around(points.x.iter().copied()), Interval::around(bars)]
        };
        state.measured = points.iter().map(ends).collect();
        state.points = points;
        Changes::PLOTS
    }

    /// Draws records alone, in plots over time up to this time (SI), and marks their last points as the present moment. `None`
    /// draws whole records with the runs.
    pub fn draw_records_until(&mut self, time: Option<f64>) -> Changes {
        Changes::PLOTS.only_if(std::mem::replace(&mut self.records_until, time) != time)
    }

    /// Updates the texts of all plots to the chosen language.
    pub(crate) fn label(&mut self, basis: &Basis, columns: &Columns) -> Changes {
        for (index, state) in self.states.iter_mut().enumerate() {
            if let Some(labels) = basis.labels_of(columns, index) {
                state.labels = labels;
            }
        }
        Changes::PLOTS
    }

    /// Lays out a plot for the time shown, reusing the buffers of its figure. `None` if there is no such plot.
    pub(crate) fn layout(&mut self, run: OpenRun<'_>, PlotId(index): PlotId, settings: &Settings) -> Option<&Figure> {
        let mut figure = std::mem::take(&mut self.states.get_mut(index)?.figure);
        if let Some(mut plot) = self.seen(run).figure_of(index) {
            // The page shows title and legend above the figure.
            plot.title = "";
            plot.series.iter_mut().for_each(|series| series.label = "");
            figure::layout_into(&mut figure, &plot, settings);
        }
        let state = self.states.get_mut(index)?;
        state.figure = figure;
        Some(&state.figure)
    }

    /// Read-out at a pixel of the last layout: values of the present and kept runs and the nearest measured points.
    /// Moves the keyboard cursor there.
    pub fn hover(&mut self, run: OpenRun<'_>, id: PlotId, at: Point) -> (Option<Readout>, Changes) {
        let (row, readout) = self.seen(run).hover(id, at).unwrap_or_default();
        if let (Some(row), Some(state)) = (row, self.states.get_mut(id.0)) {
            state.cursor = Some(row);
        }
        (readout, Changes::NONE)
    }

    /// Measured point nearest to a pixel of the last layout: number of its column among all that are drawn, and index among
    /// the values of the column. `None` if no point is near.
    pub fn measured_point(&mut self, run: OpenRun<'_>, id: PlotId, at: Point) -> (Option<(usize, usize)>, Changes) {
        (self.seen(run).measured_point(id, at), Changes::NONE)
    }

    /// Moves the keyboard cursor by `rows` rows along the run, initially from the present row, and returns the read-out
    /// there.
    pub fn move_cursor(&mut self, run: OpenRun<'_>, id: PlotId, rows: isize) -> (Option<Readout>, Changes) {
        let (row, readout) = self.seen(run).beside_cursor(id, rows).unzip();
        if let (Some(row), Some(state)) = (row, self.states.get_mut(id.0)) {
            state.cursor = Some(row);
        }
        (readout.flatten(), Changes::NONE)
    }

    /// Zooms by `factor` (2 shows half as much) about a pixel, or about the centre if `at` is `None`.
    pub fn zoom(&mut self, id: PlotId, at: Option<Point>, factor: f64, direction: Direction) -> Changes {
        if !(factor.is_finite() && factor > 0.0) {
            return Changes::NONE;
        }
        self.change_view(id, |figure| match at {
            Some(at) => figure.zoom(at, factor, direction),
            None => figure.zoom_centre(factor, direction),
        })
    }

    /// Zooms to the rectangle between two pixels.
    pub fn zoom_to(&mut self, id: PlotId, one: Point, other: Point) -> Changes {
        self.change_view(id, |figure| figure.zoom_to(one, other))
    }

    /// Pans by a number of pixels.
    pub fn pan(&mut self, id: PlotId, right: f64, down: f64) -> Changes {
        self.change_view(id, |figure| figure.pan(right, down))
    }

    /// Resets the zoom: shows all data.
    pub fn reset(&mut self, id: PlotId) -> Changes {
        self.change_view(id, |_| View::default())
    }

    fn change_view(&mut self, PlotId(index): PlotId, change: impl FnOnce(&Figure) -> View) -> Changes {
        let plot = self.states.get_mut(index);
        Changes::PLOTS.only_if(plot.map(|plot| plot.view = change(&plot.figure)).is_some())
    }

    /// Takes over visibility and zoom of the plots of another program, the points over their curves, and added plots.
    /// `same_curves` and `same_axes` compare a plot here (first index) with a former one.
    pub(crate) fn adopt(
        &mut self,
        (own, former): (&Program, &Program),
        mut before: Self,
        same_curves: impl Fn(&Plot, &Plot) -> bool,
        same_axes: impl Fn(usize, usize) -> bool,
    ) {
        let documents = former.plots.len().min(before.states.len());
        let added = before.states.split_off(documents);
        let mut states: Vec<Option<PlotState>> = before.states.into_iter().map(Some).collect();
        for (index, (state, plot)) in self.states.iter_mut().zip(&own.plots).enumerate() {
            // Plots with equal titles are matched in their order.
            let titles = former.plots.iter().zip(&mut states).enumerate();
            let mut same_title = titles.filter(|(_, (other, state))| other.title == plot.title && state.is_some());
            let Some((place, (other, old))) = same_title.next() else { continue };
            let Some(old) = old.take() else { continue };
            if same_curves(plot, other) {
                // Computed content belongs to the program.
                let content = std::mem::take(&mut state.content);
                *state = PlotState { content, ..old };
            } else {
                state.shown = old.shown;
                if plot.x.value.unit == other.x.value.unit && same_axes(index, place) {
                    state.view = old.view;
                }
            }
        }
        self.states.extend(added);
    }
}

/// Settings of a plot, and the data kept from frame to frame.
#[derive(Debug)]
struct PlotState {
    shown: bool,
    view: View,
    figure: Figure,
    /// Row at which the keyboard cursor reads.
    cursor: Option<usize>,
    labels: Labels,
    /// Measured points over the curves.
    points: Vec<Points>,
    /// Horizontal and vertical range of each of them.
    measured: Vec<[Option<Interval>; 2]>,
    /// Content of a plot that does not come from the document.
    added: Option<AddedPlot>,
    /// Computed content.
    content: Content,
}

/// Computed content of a plot of the document.
#[derive(Debug, Default)]
enum Content {
    /// Lines along the run: only the columns shared by all plots.
    #[default]
    Run,
    /// Isolated points of the run.
    Section(Section),
    /// Lines over the values of a parameter.
    Swept(Box<Swept>),
    /// Lines or points over family members at the moment shown.
    Profile(Snapshot, Style),
    /// Bars.
    Histogram(Histogram),
}

impl Default for PlotState {
    fn default() -> Self {
        Self {
            shown: true,
            view: View::default(),
            figure: Figure::default(),
            cursor: None,
            labels: Labels::default(),
            points: Vec::new(),
            measured: Vec::new(),
            added: None,
            content: Content::Run,
        }
    }
}

impl PlotState {
    /// States of the document's plots.
    fn of_document(program: &Program, columns: &Columns) -> Vec<Self> {
        let state = |(index, plot): (usize, &Plot)| {
            let model = &program.model;
            let content = columns.plot(index).map(|columns| match &plot.drawing {
                Drawing::Run => Content::Run,
                Drawing::Every(every) => {
                    Content::Section(Section::new(model, plot, Moments::Every(every.clone()), columns))
                }
                Drawing::At(count) => Content::Section(Section::new(model, plot, Moments::Firings(*count), columns)),
                Drawing::Sweep(sweep) => Content::Swept(Box::new(Swept::new(model, plot, sweep, columns.units()))),
                Drawing::Profile(profile) => {
                    let style = if profile.points { Style::Dots } else { Style::Line };
                    Content::Profile(Snapshot::of_curves(model, plot, &profile.members, columns), style)
                }
                Drawing::Histogram(members) => Content::Histogram(Histogram::new(model, plot, members)),
            });
            Self { content: content.unwrap_or_default(), shown: index < AT_FIRST, ..Self::default() }
        };
        program.plots.iter().enumerate().map(state).collect()
    }

    /// Discards the rows processed, because another run replaces the present one.
    fn forget_rows(&mut self) {
        match &mut self.content {
            Content::Section(section) => section.truncate(0),
            Content::Profile(profile, _) => profile.forget(),
            Content::Histogram(histogram) => histogram.forget(),
            Content::Run | Content::Swept(_) => {}
        }
    }

    /// Curves over a parameter, if the plot has them.
    fn swept(&self) -> Option<&Swept> {
        match &self.content {
            Content::Swept(swept) => Some(swept),
            _ => None,
        }
    }

    /// Mutable access to the curves over a parameter, if the plot has them.
    fn swept_mut(&mut self) -> Option<&mut Swept> {
        match &mut self.content {
            Content::Swept(swept) => Some(swept),
            _ => None,
        }
    }

    /// An empty plot that does not come from the document.
    fn added() -> Self {
        Self { added: Some(AddedPlot::default()), ..Self::default() }
    }
}
