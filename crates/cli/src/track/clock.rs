//! Recording times of the frames, and the selection of tracked frames.

use super::arguments::{Place, Track as Arguments};
use super::opened::{Opened, refused, refused_with};
use crate::failure::Failure;
use film::timing::{Finding, Intervals, RESOLUTION, TimeBase, displayed, slow_motion};
use runner::records::limits;
use std::ops::RangeInclusive;
use units::number::fixed;
use units::{Words, words};

/// Tolerance in s of a given time later than that of a frame: `ffmpeg` counts in microseconds.
const ROUNDED: f64 = 1e-6;

/// Times and selection of frames.
#[derive(Debug)]
pub struct Clock {
    /// Factor of slow motion: duration of playback relative to that of the recording.
    pub factor: f64,
    /// Recording time of each frame, s.
    pub times: Vec<f64>,
    /// Frames per second of playback.
    pub rate: Option<f64>,
    /// Numbers of the tracked frames, ascending.
    pub frames: Vec<usize>,
    /// Notes on the times for the user.
    pub notes: Vec<Words>,
}

impl Clock {
    /// Times of a film with the requested factor and part.
    ///
    /// # Errors
    ///
    /// An invalid factor, or a part without frames.
    pub fn of(film: &Opened, arguments: &Arguments) -> Result<Self, Failure> {
        let intervals = Intervals::of(&film.times);
        let findings = intervals.as_ref().map_or_else(Vec::new, |intervals| intervals.findings(film.stated_rate));
        let mut notes: Vec<Words> = findings.iter().map(said).collect();
        let stated =
            intervals.as_ref().zip(film.capture_rate).and_then(|(intervals, rate)| slow_motion(intervals, rate));
        let factor = match (arguments.rate, &stated) {
            (Some(factor), _) => factor,
            (None, Some(Finding::SlowMotion { factor, .. })) => *factor,
            (None, _) => 1.0,
        };
        let base = TimeBase::new(&film.times, factor).ok_or_else(|| {
            Failure::in_words(
                words!(
                    "--rate {factor} is not possible: the factor is greater than zero and finite"
                ),
                words(
                    "write how many times slower the film plays than things happened, such as 8 for 240 frames/s played at 30",
                ),
            )
        })?;
        match (arguments.rate, stated) {
            (Some(factor), _) => notes.push(words!("times are divided by {factor}, as --rate says")),
            (None, stated) => notes.extend(stated.map(|stated| stated.words())),
        }
        let part = part(arguments)?;
        let rate = intervals.as_ref().map(|intervals| intervals.rate);
        // Two frames with equal times cannot both be correct; the first is kept.
        let doubled = intervals.map_or_else(Vec::new, |intervals| intervals.doubled);
        let inside = |frame: &usize| film.times.get(*frame).is_some_and(|time| part.contains(time));
        let frames: Vec<usize> =
            (0..film.times.len()).filter(|frame| doubled.binary_search(frame).is_err()).filter(inside).collect();
        if frames.is_empty() {
            return Err(refused(
                &film.path,
                words("no frame lies between --from and --until; both are times of the film as a player shows them"),
            ));
        }
        Ok(Self { factor, times: base.times().to_vec(), rate, frames, notes })
    }

    /// Frame of a click: the first tracked one from the time of the click on, as for `--from` and for pictures made by
    /// `ffmpeg -ss`.
    ///
    /// # Errors
    ///
    /// A time outside the tracked part.
    pub fn frame_of(&self, film: &Opened, click: &Place) -> Result<usize, Failure> {
        let shown = |frame: &usize| film.times.get(*frame).copied().unwrap_or(f64::NAN);
        let ends = self.frames.first().zip(self.frames.last());
        let (first, last) = ends.map_or((0, 0), |(first, last)| (*first, *last));
        let Some(time) = click.time else { return Ok(first) };
        let next = self.frames.iter().find(|frame| shown(frame) >= time - ROUNDED).copied();
        if let Some(frame) = next.filter(|_| time >= shown(&first) - RESOLUTION) {
            return Ok(frame);
        }
        let [x, y] = click.position;
        let why = words!("{x},{y}@{time}: no frame that is tracked has this time");
        let hint = words!(
            "the frames that are tracked are from {first} s to {last} s of the film, as a player shows it",
            first = displayed(shown(&first)),
            last = displayed(shown(&last))
        );
        Err(refused_with(&film.path, why, hint))
    }
}

/// Text of a finding. For doubled times it adds that the frames are left out.
fn said(finding: &Finding) -> Words {
    match *finding {
        Finding::Doubled { count, time } => words!(
            "{count} frames have the same time as the one before and are left out, the first at {time} s",
            time = Words::each(move |language| fixed(time, 2, language.style()))
        ),
        _ => finding.words(),
    }
}

/// Requested part of a film, s of playback.
///
/// # Errors
///
/// An invalid or negative time.
pub fn part(arguments: &Arguments) -> Result<RangeInclusive<f64>, Failure> {
    let (from, until) = (arguments.from.as_deref(), arguments.until.as_deref());
    let part = limits(from, until, None)?;
    let given = [("--from", from, *part.start()), ("--until", until, *part.end())];
    for (name, text, time) in given {
        if let Some(text) = text.filter(|_| time < 0.0) {
            return Err(Failure::in_words(
                words!("{name} {text} lies before the first frame: a film begins at 0 s"),
                words!("write a time of the film as a player shows it, such as {name} 1.5, or leave {name} out"),
            ));
        }
    }
    Ok(part)
}
