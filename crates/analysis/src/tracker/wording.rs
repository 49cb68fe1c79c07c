//! Texts of the remarks.

use super::coordinates::Placement;
use super::remark::Remark;
use units::number;
use units::{Language, say};

/// Upper bound of the listed names.
const SHOWN: usize = 6;

impl Remark {
    /// Remark as one or two sentences in English or Spanish.
    pub fn text(&self, language: Language) -> String {
        let round = |value: f64, digits: usize| number::plain(value, digits, language.style());
        match self {
            Self::OneOfSeveral(name) => say!(language, "the archive holds several projects of Tracker; the first with a marked mass was read: `{name}`"),
            Self::ConstantStep { milliseconds, film, packed } => {
                let step = round(*milliseconds, 8);
                let times = say!(language, "times are the frame number times a constant step of {step} ms, as the project states");
                let Some(film) = film else { return times };
                let place = match packed {
                    true => language.say(" in the archive"),
                    false => "",
                };
                times
                    + &say!(language, "; the film{place}, `{film}`, has a time for each frame, which is better: track it, in the tab Measure of the page or with `meniscus track`")
            }
            Self::ListedTimes { stretch } if *stretch == 1.0 => language.say("times are those that the project lists for the frames of its film").to_owned(),
            Self::ListedTimes { stretch } => {
                let factor = round(*stretch, 6);
                say!(language, "times are those that the project lists for the frames of its film, multiplied by {factor}, since it states \
                         another frame rate than the film has")
            }
            Self::FrameNumbers { film } => {
                let numbers = language.say("the project does not state how long a frame lasts, and no duration is assumed: the first column is the number of \
                     the frame, and not a time").to_owned();
                let remedy = match film {
                    Some(film) => say!(language, "; the film, `{film}`, has a time for each frame: track it, in the tab Measure of the page or with `meniscus track`"),
                    None => language.say("; set the frame rate in Tracker and save the project").to_owned(),
                };
                numbers + &remedy
            }
            Self::NoClipControl { listed: true } => language.say("the project has no clip control, which states the mean duration of a frame: the listed times were taken as they are").to_owned(),
            Self::NoClipControl { listed: false } => language.say("the project has no clip control, which states the duration of a frame: the one of its pictures was taken").to_owned(),
            Self::NoClip => language.say("the project has no video clip, which states the frames that it uses: all marked frames were read, and time zero is \
                 frame 0").to_owned(),
            Self::FilmTimes { milliseconds: None } => language.say("times are those of the frames of its film").to_owned(),
            Self::FilmTimes { milliseconds: Some(milliseconds) } => {
                let step = round(*milliseconds, 8);
                say!(language, "times are those of the frames of its film, and not the constant step of {step} ms of the project")
            }
            Self::Calibration { axes, changes, unit } => calibration(axes, *changes, unit.as_deref(), language),
            Self::AssumedMetres => language.say("the project states no unit of length: metres are assumed, as Tracker does").to_owned(),
            Self::Reference(mass) => say!(language, "Tracker shows positions relative to {mass}; those here are relative to the axes"),
            Self::Unconfirmed { mass, keys, marks } => say!(language, "{mass}: {keys} of {marks} positions are key frames, marked by hand or confirmed; the autotracker found the \
                     others, or they were interpolated (autofill)"),
            Self::OutsideClip(count) => say!(language, "positions outside the clip that the project selects were left out: {count}"),
            Self::LeftOut(kind, names) => {
                let (kind, names) = (kind.text(language), listed(names, language));
                say!(language, "{kind} were not read: {names}")
            }
            Self::Filters(names) => {
                let names = listed(names, language);
                say!(language, "the project filters its film ({names}); positions belong to the filtered pictures")
            }
        }
    }
}

fn calibration(axes: &Placement, changes: bool, unit: Option<&str>, language: Language) -> String {
    let round = |value: f64| number::plain(value, 5, language.style());
    let [along, down] = axes.scale.map(round);
    let origin = axes.origin.map(|value| number::fixed(value, 1, language.style())).join("; ");
    let angle = number::fixed(axes.angle, 2, language.style());
    let mut text = match (unit, along == down) {
        (None, _) => language.say("the project has no scale: positions are in pixels, y upwards").to_owned(),
        (Some(unit), true) => say!(language, "the scale of the project is {along} px/{unit}"),
        (Some(unit), false) => say!(
            language,
            "the scale of the project is {along} px/{unit} along the rows and {down} px/{unit} along the columns"
        ),
    };
    text.push_str(&say!(language, "; the origin is at the pixel ({origin}), the x axis at {angle}°"));
    if changes {
        text.push_str(
            language.say(" in the first frame; they change from frame to frame, which is taken into account"),
        );
    }
    if unit.is_some() {
        text.push_str(
            language.say("; the project states no error of the scale, and errors of lengths in fits do not include it"),
        );
    }
    text
}

/// First names of a list, and the number of the others.
pub(super) fn listed(names: &[String], language: Language) -> String {
    let shown = names.iter().take(SHOWN).cloned().collect::<Vec<_>>().join(", ");
    match names.len().saturating_sub(SHOWN) {
        0 => shown,
        more => say!(language, "{shown} and {more} more"),
    }
}
