//! Texts of this crate in every language. Texts of the document are translated by the document.

use crate::{Announcement, Basis, Grade, Refusal, TimeLine};
use engine::Method;
use units::{Language, say};

/// Name of a run with the document's own values.
pub fn defaults(language: Language) -> &'static str {
    language.say("initial settings")
}

/// Text of a truth value.
pub fn truth(language: Language, value: bool) -> &'static str {
    if value { language.say("yes") } else { language.say("no") }
}

/// Text in place of a grade if a question allows no further attempt.
pub fn no_attempts_left(language: Language) -> &'static str {
    language.say("No attempts are left.")
}

/// Label of the readout of a dry friction.
pub fn dry_friction(language: Language) -> &'static str {
    language.say("Dry friction")
}

/// State of a dry friction: sticking or slipping.
pub fn sticks(language: Language, sticks: bool) -> &'static str {
    if sticks { language.say("sticks") } else { language.say("slips") }
}

/// Name of an integration method.
pub fn method_name(language: Language, method: Method) -> &'static str {
    match method {
        Method::Euler => "Euler",
        Method::EulerRichardson => "Euler-Richardson",
        Method::VelocityVerlet => language.say("velocity Verlet"),
        Method::RungeKutta4 => language.say("Runge-Kutta, order 4"),
        Method::DormandPrince => language.say("Dormand-Prince 5(4), adaptive"),
        Method::Rosenbrock => language.say("Rosenbrock (RODAS), stiff"),
    }
}

/// Description of a plot.
pub fn against(language: Language, curves: &str, x: &str) -> String {
    say!(language, "{curves} against {x}.")
}

/// Label of the vertical axis of a histogram.
pub fn count(language: Language) -> &'static str {
    language.say("Count")
}

/// Description of a histogram.
pub fn counted(language: Language, values: &str, over_run: bool) -> String {
    match over_run {
        true => say!(language, "Histogram of {values} over the run."),
        false => say!(language, "Histogram of {values} at the moment shown."),
    }
}

/// Progress of the runs of a sweep plot.
pub fn runs_complete(language: Language, done: usize, all: usize) -> String {
    say!(language, "{done} of {all} runs")
}

/// Axis label of the deviation from a claim.
pub fn deviation(language: Language, relative: bool) -> &'static str {
    match relative {
        true => language.say("relative deviation"),
        false => language.say("deviation"),
    }
}

/// Name of the ghost run.
pub fn previous_run(language: Language) -> &'static str {
    language.say("previous run")
}

/// Name of a kept run in a list of other items.
pub fn kept_run(language: Language, name: &str) -> String {
    say!(language, "the kept run “{name}”")
}

/// Numbers of parameters and values in a fold, in words.
pub fn further(language: Language, parameters: usize, values: usize) -> String {
    match (parameters, values) {
        (0, values) => say!(language, "{values} values"),
        (parameters, 0) => say!(language, "{parameters} parameters"),
        (parameters, values) => say!(language, "{parameters} parameters, {values} values"),
    }
}

/// Name of the time on an axis.
pub fn time_axis(language: Language) -> &'static str {
    language.say("Time")
}

/// Name of the time of a run in a list of other items.
pub fn time(language: Language, time: &str) -> String {
    say!(language, "the time {time}")
}

/// Name of an answer in a list of other items.
pub fn answer(language: Language, typed: &str) -> String {
    say!(language, "the answer “{typed}”")
}

/// Placeholder for a value hidden by a question.
pub fn hidden(language: Language) -> &'static str {
    language.say("hidden")
}

/// Comment on the error stated with an answer. `within`: true if the true value lies within that error.
pub fn stated_error(language: Language, correct: bool, within: bool) -> &'static str {
    match (correct, within) {
        (true, true) => language.say("The true value lies within your error."),
        (true, false) => language.say("But the true value lies outside your error: it is too small."),
        (false, true) => language.say("Your error covers the true value, but the value itself is what counts."),
        (false, false) => language.say("The true value lies outside your error."),
    }
}

/// Text for a choice without a chosen option.
pub fn nothing_chosen(language: Language) -> &'static str {
    language.say("Choose an answer.")
}

/// Text of a grade.
pub fn grade(language: Language, grade: Grade) -> String {
    let text = match grade {
        Grade::Partly(percent) => return say!(language, "Partly right: {percent} % of the credit."),
        Grade::Correct => language.say("Correct."),
        Grade::Close => language.say("Close, but not close enough. Measure again."),
        Grade::WrongSign => language.say("The size is right; think about the sign."),
        Grade::WrongScale => language.say("The digits are right, but not the power of ten. Check the unit."),
        Grade::Wrong => language.say("Not yet."),
        Grade::Unreadable => language.say("This is not a number."),
        Grade::Unanswerable => language.say("With the present parameters this has no answer."),
    };
    text.to_owned()
}

/// Text of a refusal.
pub fn refusal_text(language: Language, refusal: &Refusal) -> String {
    match refusal {
        Refusal::NotRead(why) => why.words().text(language).into_owned(),
        Refusal::OtherFrequency { typed, meant, angular: true } => {
            say!(language, "{typed} is a frequency; the angular frequency is {meant}.")
        }
        Refusal::OtherFrequency { typed, meant, angular: false } => {
            say!(language, "{typed} is an angular frequency; the frequency is {meant}.")
        }
        Refusal::NameInAnswer { name } => {
            say!(language, "An answer consists of numbers and units; “{name}” is a quantity of the simulation.")
        }
        Refusal::TooSmall { name, least } => {
            say!(language, "{name}: at least {least}.")
        }
        Refusal::TooLarge { name, greatest } => {
            say!(language, "{name}: at most {greatest}.")
        }
        Refusal::NoValue { name } => {
            say!(language, "{name} would have no finite value.")
        }
        Refusal::NotPositive => language.say("It must be greater than zero.").to_owned(),
        Refusal::NotPaused => language.say("Pause first, then set the state.").to_owned(),
        Refusal::RunEnded => {
            language.say("The run has ended here. Go on, go back in time or back to the start.").to_owned()
        }
        Refusal::TooManyPresses { most } => {
            say!(language, "{most} presses in one run are the most. Go back to the start.")
        }
        Refusal::Method { method } => {
            let name = method_name(language, *method);
            say!(language, "{name} is for equations of second order only.")
        }
        Refusal::TooManyRuns { most } => say!(language, "{most} runs are kept already; remove one first."),
        Refusal::Unknown { name } => {
            say!(language, "There is no “{name}” here.")
        }
        Refusal::UnreadableState => {
            language.say("The link was not understood; the document opens as it is.").to_owned()
        }
        Refusal::DocumentTooLong => {
            language.say("The document in this link is too long. Ask for its file and open that.").to_owned()
        }
        Refusal::DocumentNeeded { name } => say!(
            language,
            "This link is about the document {name}, which is not in this page. Open that file, and you will see what the link shows."
        ),
        Refusal::NoSeat => {
            language.say("A seat is a whole number from 1, as your teacher has given it to you.").to_owned()
        }
        Refusal::PartlyRestored { left_out } => {
            let parts = left_out.join(", ");
            say!(language, "Parts of the link do not fit this document and were left out: {parts}.")
        }
    }
}

impl Announcement {
    /// Text in the chosen language.
    pub fn text(&self, basis: &Basis, line: &TimeLine) -> String {
        let language = basis.language();
        let time = |time: f64| basis.time_words(line.course(), time);
        match self {
            Announcement::Playing => language.say("Playing").to_owned(),
            Announcement::Paused(at) => {
                say!(language, "Paused at {}", time(*at))
            }
            Announcement::Ended(at) => say!(language, "The run ends at {}; press Play to continue", time(*at)),
            Announcement::Stepped(at) => say!(language, "Step, {}", time(*at)),
            Announcement::Scrubbed(at) => time(*at),
            Announcement::BackAtStart if line.course().begun().start.is_some() => {
                language.say("Back at the start that was set by hand").to_owned()
            }
            Announcement::BackAtStart => language.say("Back at the start").to_owned(),
            Announcement::Restarted(index) => {
                say!(language, "The run starts again: {} changed", basis.parameter_label(*index))
            }
            Announcement::ParameterSet(index, value) => {
                let value = basis.parameter_value_text(*index, *value);
                format!("{}: {value}", basis.parameter_label(*index))
            }
            Announcement::Drawn(index) => say!(language, "The run starts again: {} drawn", basis.drawing_label(*index)),
            Announcement::DrawingCleared(index) => {
                say!(language, "{}: as in the document", basis.drawing_label(*index))
            }
            Announcement::Pressed(button, at) => {
                let title = basis.model().buttons.get(*button).map_or("", |button| basis.text(&button.title));
                format!("{title}, {}", time(*at))
            }
            Announcement::DefaultsRestored => {
                language.say("Defaults restored: parameters and start are those of the document").to_owned()
            }
            Announcement::Preset(index) => {
                basis.program().presets.get(*index).map_or("", |preset| basis.text(&preset.name)).to_owned()
            }
            Announcement::StateSet(index, value) => {
                let unit = basis.model().states.get(*index).map(|state| &state.unit);
                let value = unit.map_or_else(String::new, |unit| basis.quantity_text(*value, unit));
                let label = basis.state_label(*index);
                say!(language, "{}; the run starts from there", format!("{label}: {value}"))
            }
            Announcement::StartSet { state, value, before } => {
                let changed = basis.parameters(line.course()).into_iter();
                let changed = changed.filter(|now| before.get(now.index).is_some_and(|before| now.value != *before));
                let changed: Vec<String> = changed.map(|now| format!("{}: {}", now.label, now.spoken)).collect();
                let unit = basis.model().states.get(*state).map(|state| &state.unit);
                let value = unit.map_or_else(String::new, |unit| basis.quantity_text(*value, unit));
                format!("{}: {value}; {}", basis.state_label(*state), changed.join(", "))
            }
            Announcement::Speed(speed) => say!(language, "Speed {}", line.speed_text(basis, *speed)),
            Announcement::Kept(name) => {
                say!(language, "Run kept: {}", name)
            }
            Announcement::Removed(name) => {
                say!(language, "Run removed: {}", name)
            }
            Announcement::Undone => language.say("Undone").to_owned(),
            Announcement::Full => language.say("Paused: the recording is full").to_owned(),
            Announcement::Failed => {
                let failure = || line.problem(basis).map(|problem| problem.message);
                line.ending(basis).or_else(failure).unwrap_or_default()
            }
            Announcement::Method(method) => say!(language, "Method: {}", method_name(basis.language(), *method)),
            Announcement::Step(step) => {
                say!(language, "Step: {}", basis.quantity_text(*step, &basis.model().independent.unit))
            }
            Announcement::QuestionSetup(_) => language.say("Parameters set for the question").to_owned(),
            Announcement::Resized(lost) => {
                let size = |size: crate::SizeView| format!("{}: {}", size.label, size.value);
                let sizes = basis.sizes().into_iter().map(size).collect::<Vec<_>>().join(", ");
                match lost.as_slice() {
                    [] => sizes,
                    lost => say!(language, "{sizes}; dropped, because it does not fit: {}", lost.join(", ")),
                }
            }
            Announcement::Replaced(lost) if lost.is_empty() => language.say("The changed document runs").to_owned(),
            Announcement::Replaced(lost) => {
                say!(language, "The changed document runs; dropped, because it does not fit: {}", lost.join(", "))
            }
            Announcement::Seated(Some(seat)) => say!(language, "Seat {}: your own values are set", seat.to_string()),
            Announcement::Seated(None) => language.say("No seat: the values of the document are set").to_owned(),
            Announcement::Restored => language.say("The saved state is back").to_owned(),
        }
    }
}
