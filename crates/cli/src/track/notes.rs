//! Notes on the tracks of a film.

use film::calibration::Calibration;
use film::table::Table;
use film::timing::displayed;
use film::tracking::{Track, of_several};
use units::number::fixed;
use units::{Words, words};

/// Maximum number of listed frames or gaps.
const LISTED: usize = 8;

/// Notes on tracks and calibration for the user. `shown`: presentation times of all frames of the film, s; `size`: width
/// and height of the upright picture, px.
pub fn notes(
    tracks: &[Track],
    table: &Table,
    calibration: &Calibration,
    (shown, size): (&[f64], [f64; 2]),
) -> Vec<Words> {
    let mut notes = Vec::new();
    for (number, track) in (1..).zip(tracks) {
        let found = of_track(track, table, (shown, size));
        notes.extend(found.into_iter().map(|words| of_several(number, tracks.len(), words)));
    }
    notes.extend(calibration.notes());
    notes
}

fn of_track(track: &Track, table: &Table, (shown, size): (&[f64], [f64; 2])) -> Vec<Words> {
    let mut notes = Vec::new();
    if track.points.is_empty() {
        notes.push(words("it was found in no frame"));
    }
    if rests(track) {
        notes.push(words("it moves by less than a pixel; if it should move, click the edge that does"));
    }
    notes.extend(track.camera());
    let doubtful: Vec<usize> = track.points.iter().filter(|point| point.doubtful).map(|point| point.frame).collect();
    if !doubtful.is_empty() {
        let (count, of) = (doubtful.len(), track.points.len());
        let listed: Vec<String> = doubtful.iter().take(LISTED).map(|frame| (frame + 1).to_string()).collect();
        let listed = listed.join(", ") + if count > LISTED { ", ..." } else { "" };
        notes.push(words!(
            "in doubt: {count} of {of} frames, {listed} (counted from 1); look at them before you use their rows"
        ));
    }
    let hidden = hidden(track);
    if !hidden.is_empty() {
        let listed: Vec<String> = hidden.iter().take(LISTED).map(|(from, to)| format!("{from}..{to}")).collect();
        let listed = listed.join(", ") + if hidden.len() > LISTED { ", ..." } else { "" };
        notes.push(words!("not seen in frames {listed} (counted from 1), which have no position of it"));
    }
    if let Some(outline) = track.outline {
        notes.push(words!(
            "the circle of the body has a radius of {radius} px",
            radius = Words::each(move |language| fixed(outline.radius, 1, language.style()))
        ));
    }
    let time = |frame: usize| displayed(shown.get(frame).copied().unwrap_or(f64::NAN));
    match (track.loss(size), track.lost) {
        (Some(loss), _) => {
            let rows = match table.frames.len() > track.points.len() {
                true => words("later rows have no value for it"),
                false => words("later frames have no row"),
            };
            notes.push(words!("{loss}; {rows}", loss = loss.words(time(loss.frame))));
        }
        (None, Some(frame)) => notes.push(words!(
            "lost from frame {frame} on (counted from 1; {time} s of the film), and found again later",
            frame = Words::same((frame + 1).to_string()),
            time = time(frame),
        )),
        (None, None) => {}
    }
    notes
}

/// First and last frame (from 1) of each gap between positions, except the one in which the body was lost. Repeated
/// frames, left out one at a time, are not gaps.
fn hidden(track: &Track) -> Vec<(usize, usize)> {
    let pairs = || track.points.windows(2).map(|pair| (pair[0].frame, pair[1].frame));
    let usual = pairs().map(|(before, after)| after.saturating_sub(before)).min().unwrap_or(1).max(1);
    let is_gap = |&(before, after): &(usize, usize)| {
        after.saturating_sub(before) > 2 * usual && !track.lost.is_some_and(|lost| (before..=after).contains(&lost))
    };
    pairs().filter(is_gap).map(|(before, after)| (before + usual + 1, after + 1 - usual)).collect()
}

/// True if all positions lie within 1 px, as for a mark on the wall instead of the surface.
fn rests(track: &Track) -> bool {
    (0..2).all(|axis| {
        let values = track.points.iter().map(|point| point.position[axis]);
        let (least, most) =
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), value| (least.min(value), most.max(value)));
        most - least < 1.0
    }) && track.points.len() > 1
}
