//! Settings of a fit: participating records, varied numbers, numbers shared between records, and the fitted time
//! window.

use crate::fits::{FitData, Fits, ShownFits};
use crate::records::record::Record;
use crate::{Changes, Refusal, number, words};
use analysis::fit::{Loss, Target, Varied};
use play::Play;

/// A record in the list of records that can be fitted together.
#[derive(Clone, Debug, PartialEq)]
pub struct FitRecordView {
    /// Id of the record.
    pub id: u32,
    /// Name of the record.
    pub name: String,
    /// True if it is the chosen record, which always takes part.
    pub chosen: bool,
    /// True if it takes part in the fit.
    pub taking_part: bool,
}

/// A number that a fit can vary.
#[derive(Clone, Debug, PartialEq)]
pub struct ChoiceView {
    /// Index in the list, for [`Fits::vary`].
    pub index: usize,
    /// Name in the document; empty for the zeros of the clock and of the scale.
    pub name: String,
    /// Label shown to users.
    pub label: String,
    /// True if it is varied.
    pub varied: bool,
    /// True if all records share one value, false if each record has its own; `None` if there is no choice.
    pub same: Option<bool>,
    /// Unit of the values in `values`.
    pub unit: String,
    /// Value per record. Empty unless the number is fixed and differs between the records.
    pub values: Vec<KnownView>,
}

/// Value of a parameter in one record.
#[derive(Clone, Debug, PartialEq)]
pub struct KnownView {
    /// Id of the record.
    pub record: u32,
    /// Name of the record.
    pub name: String,
    /// Text of the field of the value. Shows the value of the slider if none was entered.
    pub text: String,
}

/// Keys of the two zeros in `Setup::same`. No parameter can have such a name.
const ZEROS: [&str; 2] = ["zero of the clock", "zero of the scale"];

impl Fits {
    /// Adds a record to the fit or removes it. The chosen record always takes part.
    pub fn include(&mut self, id: u32, takes_part: bool) -> Changes {
        let others = &mut self.setup.others;
        if takes_part {
            others.insert(id)
        } else {
            others.remove(&id)
        };
        Changes::FITS
    }

    /// Sets whether a fit varies a number. `choice` is an index of [`ShownFits::choices`].
    pub fn vary(&mut self, play: &Play, choice: usize, varied: bool) -> Changes {
        let Some(name) = choice_name(play, choice) else { return Changes::NONE };
        let parameters = play.model().parameters.len();
        let setup = &mut self.setup;
        match choice.checked_sub(parameters) {
            Some(zero) => setup.zeros.iter_mut().skip(zero).take(1).for_each(|place| *place = Some(varied)),
            None => setup.varied.iter_mut().skip(choice).take(1).for_each(|place| *place = varied),
        }
        // Varied and fixed numbers have different defaults of `same`.
        setup.same.remove(&name);
        Changes::FITS
    }

    /// Sets whether all records share one value of a number or each record has its own.
    pub fn set_same(&mut self, play: &Play, choice: usize, same: bool) -> Changes {
        let Some(name) = choice_name(play, choice) else { return Changes::NONE };
        self.setup.same.insert(name, same);
        Changes::FITS
    }

    /// Chooses the loss function by its index in [`ShownFits::losses`].
    pub fn set_loss(&mut self, place: usize) -> Changes {
        let Some(loss) = Loss::ALL.get(place) else { return Changes::NONE };
        self.setup.loss = *loss;
        Changes::FITS
    }

    /// Sets one end of the fitted time window from typed text: `end` is 0 for the start, 1 for the end. Empty text
    /// leaves the end open.
    ///
    /// # Errors
    /// The text is not a time.
    pub fn set_window(&mut self, play: &Play, end: usize, typed: &str) -> Result<Changes, Refusal> {
        let value = match typed.trim() {
            "" => None,
            typed => Some(play.basis().read_value(typed, &play.model().independent.unit)?),
        };
        if let Some(place) = self.setup.window.get_mut(end) {
            *place = value;
        }
        Ok(Changes::FITS)
    }

    /// Sets the fitted time window on the record clocks, SI; `None` is open.
    pub fn set_fitted_part(&mut self, part: [Option<f64>; 2]) -> Changes {
        let changes = Changes::FITS.only_if(self.setup.window != part);
        self.setup.window = part;
        changes
    }

    /// Sets the fitted time window to the range of the zoomed plot.
    pub fn take_part_in_plot(&mut self, data: FitData<'_>) -> Changes {
        let part = self.shown(data).part_in_plot();
        part.map_or(Changes::NONE, |part| self.set_fitted_part(part.map(Some)))
    }
}

impl ShownFits<'_> {
    /// Id of the chosen record; the latest one if none was chosen.
    pub fn chosen_record(self) -> Option<u32> {
        let exists = |id: &u32| self.records.get(*id).is_some();
        self.fits.setup.chosen.filter(exists).or_else(|| self.records.all().last().map(Record::id))
    }

    /// The records that can be fitted, oldest first.
    pub fn records(self) -> Vec<FitRecordView> {
        let chosen = self.chosen_record();
        let view = |record: &Record| FitRecordView {
            id: record.id(),
            name: record.name().to_owned(),
            chosen: Some(record.id()) == chosen,
            taking_part: Some(record.id()) == chosen || self.fits.setup.others.contains(&record.id()),
        };
        self.records.all().iter().map(view).collect()
    }

    /// Ids of the records that take part, oldest first.
    pub(crate) fn taking_part(self) -> Vec<u32> {
        self.records().into_iter().filter(|record| record.taking_part).map(|record| record.id).collect()
    }

    /// Numbers that a fit can vary: the numeric parameters, then the zero of the clock, then the zero of the scale.
    pub fn choices(self) -> Vec<ChoiceView> {
        let parameters = self.play.model().shown_parameters();
        let numbers = parameters.filter(|(_, parameter)| parameter.choices == program::Choices::Numbers);
        let parameters = numbers.map(|(index, parameter)| {
            let varied = self.fits.setup.varied.get(index).copied().unwrap_or(false);
            let same = self.is_several().then(|| self.fits.setup.is_same(&parameter.name, varied));
            ChoiceView {
                index,
                name: parameter.name.clone(),
                label: self.play.basis().parameter_label(index).to_owned(),
                varied,
                same,
                unit: number::unit_text(&parameter.unit.text),
                values: if same == Some(false) && !varied { self.known_views(index) } else { Vec::new() },
            }
        });
        let count = self.play.model().parameters.len();
        let varied_zeros = [self.varies_clock(), !self.own_offsets().is_empty()];
        let zeros = words::zeros(self.play.basis().language()).into_iter().zip(varied_zeros).enumerate();
        let zeros = zeros.map(|(place, (label, varied))| ChoiceView {
            index: count + place,
            name: String::new(),
            label: label.to_owned(),
            varied,
            same: (varied && self.is_several()).then(|| self.fits.setup.is_same(ZEROS[place], true)),
            unit: String::new(),
            values: Vec::new(),
        });
        parameters.chain(zeros).collect()
    }

    /// True if several records take part.
    fn is_several(self) -> bool {
        self.taking_part().len() > 1
    }

    /// Value of a parameter in each record that takes part.
    fn known_views(self, index: usize) -> Vec<KnownView> {
        let view = |record: &Record| KnownView {
            record: record.id(),
            name: record.name().to_owned(),
            text: self.records.known_text(self.open(), record.id(), index),
        };
        self.taking_part().into_iter().filter_map(|id| self.records.get(id)).map(view).collect()
    }

    /// The varied numbers of a fit of the open document.
    pub(crate) fn varied(self) -> Vec<Varied> {
        let setup = &self.fits.setup;
        let targets = setup.varied.iter().enumerate().filter(|(_, varied)| **varied);
        let mut targets: Vec<(Target, String)> = targets
            .map(|(index, _)| (Target::Parameter(index), choice_name(self.play, index).unwrap_or_default()))
            .collect();
        targets.extend(self.varies_clock().then(|| (Target::Origin, ZEROS[0].to_owned())));
        // An offset alone is no fit.
        let wanted = !targets.is_empty() || setup.zeros[1] == Some(true);
        let offsets = self.own_offsets().into_iter().filter(|_| wanted);
        targets.extend(offsets.map(|place| (Target::Offset(place), ZEROS[1].to_owned())));
        let shared = |name: &str| setup.is_same(name, true);
        // The search starts at the values of the sliders.
        let varied =
            |(target, name): (Target, String)| Varied { target, shared: shared(&name), ..Varied::parameter(0) };
        targets.into_iter().map(varied).collect()
    }

    /// The offset of the readings of the observation at this place as a varied number.
    pub(super) fn varied_offset(self, place: usize) -> Varied {
        let shared = self.fits.setup.is_same(ZEROS[1], true);
        Varied { target: Target::Offset(place), shared, ..Varied::parameter(0) }
    }

    /// Names of the loss functions, and the index of the chosen one.
    pub fn losses(self) -> (Vec<&'static str>, usize) {
        let names = Loss::ALL.iter().map(|loss| loss.name(self.play.basis().language())).collect();
        (names, Loss::ALL.iter().position(|loss| *loss == self.fits.setup.loss).unwrap_or_default())
    }

    /// Texts of the fields for the start and the end of the fitted time window; empty if open.
    pub fn window(self) -> [String; 2] {
        let unit = &self.play.model().independent.unit;
        let shown = |end: f64| number::plain(unit.from_si(end), 6, self.play.basis().style());
        self.fits.setup.window.map(|end| end.map_or_else(String::new, shown))
    }

    /// Start and end of the fitted time window on the record clocks, SI; `None` is open.
    pub fn fitted_part(self) -> [Option<f64>; 2] {
        self.fits.setup.window
    }

    /// True if a plot is zoomed to a time range that can become the fitted window.
    pub fn has_part_in_plot(self) -> bool {
        self.part_in_plot().is_some()
    }

    /// Time range of the zoomed plot on the clocks of the records that take part, SI. `None` if no plot is zoomed, or if the
    /// model begins at different readings of these clocks, so that no common range corresponds to the plot.
    fn part_in_plot(self) -> Option<[f64; 2]> {
        let part = self.play.plots().zoomed_part()?;
        let model = self.play.model();
        let taking_part: Vec<u32> =
            self.records().iter().filter(|choice| choice.taking_part).map(|choice| choice.id).collect();
        let mut origins = (self.records.all().iter())
            .filter(|record| taking_part.contains(&record.id()))
            .map(|record| record.origin(&model.independent, model.is_autonomous()));
        let origin = origins.next()?;
        let unit = &model.independent.unit;
        origins.all(|other| other == origin).then(|| [part.low, part.high].map(|end| unit.to_si(end) + origin))
    }
}

/// Name of a parameter, or key of a zero, by its index in [`ShownFits::choices`].
fn choice_name(play: &Play, choice: usize) -> Option<String> {
    let parameters = &play.model().parameters;
    match choice.checked_sub(parameters.len()) {
        Some(zero) => ZEROS.get(zero).map(|name| (*name).to_owned()),
        None => parameters.get(choice).filter(|own| own.is_shown()).map(|parameter| parameter.name.clone()),
    }
}
