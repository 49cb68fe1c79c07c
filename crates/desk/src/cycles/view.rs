//! View of the cycles of an oscillation: choice of the column, table, and conclusions in sentences. No theory is
//! needed. Cycles are computed only while the view is open.

use crate::cycles::found::Found;
use crate::cycles::{Cycles, ShownCycles};
use crate::records::Records;
use crate::records::record::Record;
use crate::{Changes, Export, ExportKind, number};
use analysis::cycles::{self, Measured, Quantity, Writing};
use play::{Play, PlotId};
use units::Language;
use units::alphabet::capitalised;
use units::number::Layout;

/// Significant digits of a value without an error.
const DIGITS: usize = 4;

/// A column in which cycles can be searched.
#[derive(Clone, Debug, PartialEq)]
pub struct CycleColumn {
    /// Id of the record.
    pub record: u32,
    /// Index of the column in the record.
    pub column: usize,
    /// Name of the record and heading of the column.
    pub label: String,
    /// True if it is the chosen column.
    pub selected: bool,
}

/// The cycles of a column as shown on the page.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CyclesView {
    /// Headings of the table, with units.
    pub heads: Vec<String>,
    /// One row per turning point: its kind, then its values with their errors.
    pub rows: Vec<(&'static str, Vec<String>)>,
    /// Sentences about the quantities that change from cycle to cycle and those that do not.
    pub sentences: Vec<String>,
}

impl Cycles {
    /// Opens or closes the view of cycles.
    pub fn open(&mut self, open: bool) -> Changes {
        self.view.open = open;
        Changes::CYCLES
    }

    /// Chooses another column.
    pub fn choose(&mut self, record: u32, column: usize) -> Changes {
        self.view.chosen = Some((record, column));
        Changes::CYCLES
    }

    /// Plots another quantity of the cycles, against time or amplitude. The amplitude itself is always plotted against
    /// time.
    pub fn show(&mut self, quantity: usize, against_amplitude: bool) -> Changes {
        if let Some(quantity) = Quantity::ALL.get(quantity) {
            self.view.quantity = *quantity;
        }
        self.view.against_amplitude = against_amplitude && self.view.quantity != Quantity::Amplitude;
        Changes::CYCLE_PLOT
    }

    /// Takes the settings of the view from a desk with another document.
    pub(crate) fn adopt(&mut self, other: &mut Self) -> Changes {
        std::mem::swap(&mut self.view, &mut other.view);
        Changes::CYCLES
    }

    /// Sets the id of the plot of the cycles, which follows the plots of the document.
    pub(crate) fn move_plot(&mut self, plot: PlotId) {
        self.plot = plot;
    }

    /// Finds the cycles again. Needed when the records or the meanings of their columns have changed.
    pub(crate) fn find(&mut self, play: &Play, records: &Records) {
        self.found = None;
        if self.view.open {
            let known = |(id, column): &(u32, usize)| {
                records.get(*id).is_some_and(|record| oscillating_columns(play, record).contains(column))
            };
            self.view.chosen = self.view.chosen.filter(known).or_else(|| usual_column(play, records));
            let chosen = self.view.chosen.and_then(|(id, column)| Some((records.get(id)?, column)));
            self.found = chosen.and_then(|(record, column)| measure(play, record, column));
        }
    }
}

impl ShownCycles<'_> {
    /// The plot of the cycles.
    pub fn plot(self) -> PlotId {
        self.cycles.plot
    }

    /// True if the view of cycles is open.
    pub fn is_open(self) -> bool {
        self.cycles.view.open
    }

    /// The columns in which cycles can be searched.
    pub fn columns(self) -> Vec<CycleColumn> {
        let mut found = Vec::new();
        let views = self.records.shown(self.open).list();
        for (record, view) in self.records.all().iter().zip(views) {
            for column in oscillating_columns(self.open.play, record) {
                let Some(own) = view.columns.get(column) else { continue };
                let bare = own.head.split(" [").next().unwrap_or_default();
                let called = if own.quantity.is_empty() || own.quantity == bare {
                    own.head.clone()
                } else {
                    format!("{} ({})", play::symbol(&own.quantity), own.head)
                };
                found.push(CycleColumn {
                    record: record.id(),
                    column,
                    label: format!("{}: {called}", record.name()),
                    selected: self.cycles.view.chosen == Some((record.id(), column)),
                });
            }
        }
        found
    }

    /// Names of the quantities that can be plotted, in the order of the index that [`Cycles::show`] takes, and the
    /// index of the plotted one.
    pub fn quantities(self) -> (Vec<String>, usize) {
        let names = Quantity::ALL
            .iter()
            .map(|quantity| capitalised(quantity.name(self.open.play.basis().language())))
            .collect();
        (names, Quantity::ALL.iter().position(|quantity| *quantity == self.cycles.view.quantity).unwrap_or_default())
    }

    /// True if the abscissa of the plot is the amplitude, false if it is the time.
    pub fn is_against_amplitude(self) -> bool {
        self.cycles.view.against_amplitude
    }

    /// The cycles as shown, `None` while the view is closed. Contains a single sentence if no cycles were found.
    pub fn table(self) -> Option<CyclesView> {
        let found = self.cycles.found.as_ref()?;
        let cycles = match &found.cycles {
            Ok(cycles) => cycles,
            Err(reason) => {
                let fixed = |value: f64| number::fixed(value, 1, self.open.play.basis().style());
                let sentences = vec![reason.text(self.open.play.basis().language(), &fixed)];
                return Some(CyclesView { sentences, ..CyclesView::default() });
            }
        };
        let (own, time) = units_of(self.open.play, found);
        let head = |symbol: &str, unit: &str| match unit {
            "" => symbol.to_owned(),
            unit => format!("{symbol} [{unit}]"),
        };
        let mut heads = vec![head(&play::symbol(&self.open.play.model().independent.name), &time)];
        heads.extend(
            Quantity::ALL
                .map(|quantity| head(quantity.symbol(self.open.play.basis().language()), &quantity.unit(&own, &time))),
        );
        let text = |measured: Measured| {
            number::with_error(measured.value, Some(measured.error), self.open.play.basis().style())
        };
        let column = |of: &dyn Fn(&cycles::Cycle) -> Measured| {
            let measured: Vec<Measured> = cycles.cycles.iter().map(of).collect();
            let layout = Layout::of_errors(measured.iter().map(|one| (one.value, one.error)));
            let write = |one: Measured| match layout {
                Some(layout) => layout.with_error(one.value, one.error, self.open.play.basis().style()),
                None => text(one),
            };
            measured.into_iter().map(write).collect::<Vec<String>>()
        };
        let mut columns = vec![column(&|cycle| cycle.time)];
        columns.extend(Quantity::ALL.map(|quantity| column(&|cycle| quantity.of(cycle))));
        let row = |(place, cycle): (usize, &cycles::Cycle)| {
            let cells = columns.iter().filter_map(|column| column.get(place).cloned()).collect();
            (turning_point(self.open.play.basis().language(), cycle.maximum), cells)
        };
        let style = self.open.play.basis().style();
        let sentences = cycles.sentences(
            self.open.play.basis().language(),
            &Writing {
                measured: &|quantity, measured| number::error_with_unit(&text(measured), &quantity.unit(&own, &time)),
                value: &|value| number::error_with_unit(&number::plain(value, DIGITS, style), &own),
                time: &|value| format!("{} {time}", number::fixed(value, 2, style)),
                fixed: &|value, decimals| number::fixed(value, decimals, style),
            },
        );
        Some(CyclesView { heads, rows: cycles.cycles.iter().enumerate().map(row).collect(), sentences })
    }

    /// Exports the cycles of the chosen column.
    pub fn export(self, kind: ExportKind) -> Option<Export> {
        let found = self.cycles.found.as_ref()?;
        let record = self.records.get(self.cycles.view.chosen?.0)?;
        let cycles = &found.cycles.as_ref().ok()?.cycles;
        let table = cycles::columns(cycles, &found.unit.text, &self.open.play.model().independent.unit.text);
        let heads: Vec<&str> = table.iter().map(|(head, _)| head.as_str()).collect();
        let columns: Vec<&[f64]> = table.iter().map(|(_, column)| column.as_slice()).collect();
        let bytes = match kind {
            ExportKind::Workbook => {
                let sheet = analysis::spreadsheet::Sheet::of_columns(
                    cycles_word(self.open.play.basis().language()),
                    &heads,
                    &columns,
                );
                analysis::spreadsheet::Workbook { sheets: vec![sheet] }.xlsx()
            }
            _ => {
                analysis::csv::write(&heads, &columns, crate::fits::reporting::dialect(self.open.play.basis().style()))
                    .into_bytes()
            }
        };
        Some(crate::fits::reporting::export(
            &format!(
                "{} {}",
                crate::fits::reporting::stem(record.name()),
                cycles_word(self.open.play.basis().language())
            ),
            kind,
            bytes,
        ))
    }
}

/// Indices of the observed columns of a record that do not hold the independent variable.
fn oscillating_columns(play: &Play, record: &Record) -> Vec<usize> {
    let independent = &play.model().independent.name;
    let is_time = |column: &usize| record.uses().get(*column).is_some_and(|used| used.meaning.quantity == *independent);
    record.table().observed_columns().filter(|column| !is_time(column)).collect()
}

/// Default column of the latest record: the fitted one, else the first measured one, else the first.
fn usual_column(play: &Play, records: &Records) -> Option<(u32, usize)> {
    let record = records.all().last()?;
    let columns = oscillating_columns(play, record);
    let fitted = |column: &&usize| record.uses().get(**column).is_some_and(|used| used.fitted);
    let measured = |column: &&usize| record.computed_from(**column).is_none();
    let column = columns.iter().find(fitted).or_else(|| columns.iter().find(measured)).or_else(|| columns.first())?;
    Some((record.id(), *column))
}

fn measure(play: &Play, record: &Record, column: usize) -> Option<Found> {
    let independent = &play.model().independent;
    let used = record.uses().get(column)?;
    let (mut times, mut values) = record.series(column, independent)?;
    times.iter_mut().for_each(|time| *time = independent.unit.from_si(*time));
    values.iter_mut().for_each(|value| *value = used.meaning.unit.from_si(*value));
    Some(Found {
        ends: (*times.first()?, *times.last()?),
        cycles: cycles::cycles(&times, &values),
        unit: used.meaning.unit.clone(),
        name: used.meaning.quantity.clone(),
        origin: record.origin(independent, play.model().is_autonomous()),
    })
}

/// Units of values and times as shown to users.
pub(super) fn units_of(play: &Play, found: &Found) -> (String, String) {
    (number::unit_text(&found.unit.text), number::unit_text(&play.model().independent.unit.text))
}

/// The word for cycles, also used in file names.
fn cycles_word(language: Language) -> &'static str {
    language.say("cycles")
}

fn turning_point(language: Language, maximum: bool) -> &'static str {
    match maximum {
        true => language.say("maximum"),
        false => language.say("minimum"),
    }
}
