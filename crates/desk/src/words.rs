//! Texts about measuring and fitting in every language.

use crate::fits::NothingFound;
use crate::{Announcement, Refusal};
use analysis::fit::FitError;
use play::Play;
use units::{Language, say};

/// Title and description of the plot of the residuals.
pub(crate) fn residuals(language: Language) -> [&'static str; 2] {
    language.say_all(["Residuals", "measured minus computed, against time."])
}

/// Labels of the zeros of the clock and of the scale.
pub(crate) fn zeros(language: Language) -> [&'static str; 2] {
    language.say_all(["Time offset", "Offset of the readings"])
}

/// Instructions to repeat a fit made on the page. `several`: true for several records.
pub(crate) fn how_to_repeat(language: Language, several: bool) -> &'static str {
    if several {
        return language.say(
            "Made in the laboratory's page: open the document, drop the records, tick those to be fitted together, press Fit.",
        );
    }
    language.say("Made in the laboratory's page: open the document, drop the record, press Fit.")
}

/// Question for the unit of a column that theories declare in different units.
pub(crate) fn unit_asked(language: Language, record: &str, column: &str, units: &str) -> String {
    say!(
        language,
        "{record} states no unit of column {column}, and it can be {units}. Residuals in different units cannot be ranked: enter the \
             unit in the table of the record, then rank again."
    )
}

/// Name of measured values that are left out of fits, in legends and read-outs.
pub(crate) fn left_out(language: Language, points: &str) -> String {
    say!(language, "{points}, left out")
}

pub(crate) fn record(language: Language) -> &'static str {
    language.say("record")
}

/// Text for a search that did not converge.
pub(crate) fn not_converged(language: Language) -> &'static str {
    language.say("The fit did not converge.")
}

/// Text for a fitted curve that is not finite.
pub(crate) fn not_finite(language: Language) -> &'static str {
    language.say("The fitted curve is not finite.")
}

/// Text for estimates at a bound of their range.
pub(crate) fn stopped(language: Language, names: &str) -> String {
    say!(language, "The search has stopped at an end of the range: {names}.")
}

/// Text for a curve that does not follow the data.
pub(crate) fn missed(language: Language) -> &'static str {
    language.say("The model does not describe these data.")
}

/// Text for a fit that is dominated by outliers.
pub(crate) fn misled(language: Language) -> &'static str {
    language.say("Outliers dominate the fit.")
}

/// Text for a fitted curve that oscillates faster than the samples can show (aliasing).
pub(crate) fn undersampled(language: Language) -> &'static str {
    language.say("The curve oscillates faster than the samples can show.")
}

/// Text for standard errors that were ignored because some are missing. The last argument is the number of missing ones
/// and of all rows.
pub(crate) fn missing_errors(language: Language, record: &str, name: &str, (missing, rows): (usize, usize)) -> String {
    say!(
        language,
        "{record}: {missing} of {rows} values of {name} have no standard error beside them, so the fit weighs all values equally. \
             Complete their column or remove these rows."
    )
}

/// True value of a virtual measurement, and the deviation of the estimate in standard errors.
pub(crate) fn truth_is(language: Language, truth: &str, off: Option<&str>) -> String {
    let off = off.map(|off| say!(language, "; deviation {off} σ"));
    let off = off.unwrap_or_default();
    say!(language, "true value: {truth}{off}")
}

pub(crate) fn run(language: Language) -> &'static str {
    language.say("run")
}

/// Reason why a fit cannot be made.
pub(crate) fn fit_error(language: Language, error: &FitError) -> String {
    let text = match error {
        FitError::NothingVaried => language.say("Tick what is to be varied."),
        FitError::NothingObserved => {
            language.say("No column is ticked for the fit, or none of its values lies between the two times.")
        }
        FitError::TooFew { values, varied } => {
            return say!(language, "{values} values cannot determine {varied} numbers.");
        }
        FitError::TooLarge => language.say("There are too many values or too many varied numbers."),
        // No fit of the page ties parameters.
        FitError::VariedTwice(_) | FitError::BadBounds(_) | FitError::TiedInCircle(_) | FitError::BadTie(_) => {
            language.say("The ranges leave no room.")
        }
        FitError::BadStart(_) | FitError::BadValue(_) => {
            language.say("The value of a parameter is not a finite number.")
        }
        FitError::BadScaleError(_) => language.say("The standard error of the film's scale is not greater than 0."),
        FitError::BadErrors { count, .. } => {
            return say!(language, "{count} values have a standard error that is missing or not greater than 0.");
        }
        FitError::RecordEmpty(_) => language.say("None of its values lies between the two times."),
        FitError::Model(message) => return message.text(language).into_owned(),
    };
    text.to_owned()
}

impl Refusal {
    /// Text in the chosen language.
    pub fn text(&self, play: &Play) -> String {
        let language = play.basis().language();
        match self {
            Self::Play(refusal) => play.basis().refusal_text(refusal),
            Self::TooManyRecords { most } => say!(language, "{most} records are open already; remove one first."),
            Self::RecordTooLong { most } => say!(language, "The page reads records of up to {most} MiB; the program reads longer ones."),
            Self::UnreadableRecord { name, why, .. } => {
                say!(language, "{name} could not be read. {why}")
            }
            Self::NoSuchPolynomial => language
                .say(
                    "There is no such polynomial: the window is an odd number of rows up to ROWS, the degree is from 2 to 7 and below it.",
                )
                .replace("ROWS", &analysis::smoothing::WIDEST.to_string()),
            Self::NoDerivative => language
                .say(
                    "No row has the neighbours that a derivative needs. Times must ascend; uneven ones can be smoothed by polynomials.",
                )
                .to_owned(),
            Self::Fit { why } | Self::Film { why } => why.clone(),
            Self::Size { why } => units::sentence(why),
        }
    }
}

impl Announcement {
    /// Text in the chosen language.
    pub fn text(&self, play: &Play) -> String {
        let language = play.basis().language();
        match self {
            Self::Play(announcement) => announcement.text(play.basis(), play.time_line()),
            Self::RecordAdded(name) => say!(language, "Record read: {}", name),
            Self::DerivativesMade(name) => {
                say!(language, "Velocity and acceleration made: {}", name)
            }
            Self::FilmTracked(lost) if lost.is_empty() => language.say("The film has been tracked").to_owned(),
            Self::FilmTracked(lost) => lost.clone(),
            Self::RecordCancelled(name) => say!(language, "Not read: {}", name),
            Self::RecordRemoved(name) => say!(language, "Record removed: {}", name),
            Self::FitRemoved(theory) => say!(language, "Fit removed: {}", theory),
            Self::FitFinished(None) => language.say("The fit is finished").to_owned(),
            Self::FitFinished(Some(doubt)) => say!(language, "The fit is finished, and the parameters keep their values. {} Press Show in the results to see the curve.", doubt),
            Self::TheoriesLeftOut(which) => say!(language, "Not fitted: {}", which),
            Self::FitFailed(NothingFound::NoCurve) => language.say("The model has no finite curve at any start: nothing was found").to_owned(),
            Self::FitFailed(NothingFound::TooManySteps) => language.say("Wherever it was tried, the model needs too many steps for this record: nothing was found. Fit a shorter part, or \
                 narrow the ranges of the parameters").to_owned(),
            Self::FitCancelled => language.say("Fit cancelled").to_owned(),
            Self::RowLeftOut { record, row, counts: false } => {
                say!(language, "{record}: row {row} is left out of fits")
            }
            Self::RowLeftOut { record, row, counts: true } => say!(language, "{record}: row {row} counts again"),
            Self::FitApplied(record) if record.is_empty() => {
                language.say("The parameters have the fitted values").to_owned()
            }
            Self::FitApplied(record) => say!(language, "The parameters have the fitted values of {}", record),
        }
    }
}
