//! Calibration from clicks and typed lengths.

use super::now::now;
use crate::app::App;
use desk::number::typed::whole;
use desk::{CalibrationForm, LengthsForm};

/// Maximum number of intervals of a ruler.
const MOST_INTERVALS: i64 = 1000;

/// Sets the ruler, if two marks and a length are given.
pub fn ruler(app: App) {
    let films = app.films;
    let length = films.length.get_clone_untracked();
    let marks = films.ruler.get_clone_untracked();
    let [from, to] = marks[..] else { return };
    if length.trim().is_empty() {
        return;
    }
    let Some(intervals) = intervals(app) else { return };
    change(app, move |form| form.lengths = LengthsForm::Ruler { marks: [from, to], length, intervals });
}

/// Number of intervals into which the marks divide the ruler; an empty field means one. `None` if another text is refused,
/// which is then shown at the field.
pub fn intervals(app: App) -> Option<u32> {
    let typed = app.films.intervals.get_clone_untracked();
    let style = app.language.get_untracked().style();
    let read = if typed.trim().is_empty() { Ok(1) } else { whole(&typed, 1..=MOST_INTERVALS, style) };
    let refused = read.as_ref().err().map(|why| why.words().text(app.language.get_untracked()).into_owned());
    app.films.intervals_refused.set(refused);
    read.ok().and_then(|number| u32::try_from(number).ok())
}

/// Sets the rectangle, if four corners and both lengths are given.
pub fn rectangle(app: App) {
    let films = app.films;
    let sides = films.sides.get_clone_untracked();
    let corners = films.corners.get_clone_untracked();
    let [a, b, c, d] = corners[..] else { return };
    if sides.iter().any(|side| side.trim().is_empty()) {
        return;
    }
    change(app, move |form| form.lengths = LengthsForm::Rectangle { corners: [a, b, c, d], size: sides });
}

/// Removes the scale.
pub fn none(app: App) {
    app.films.ruler.set(Vec::new());
    app.films.corners.set(Vec::new());
    change(app, |form| form.lengths = LengthsForm::Pixels);
}

/// Changes the calibration form and shows a refusal beside the fields. If marks of a ruler are needed, the picture of
/// the shown frame is read.
pub fn change(app: App, change: impl FnOnce(&mut CalibrationForm) + 'static) {
    let Some(now) = now(app) else { return };
    let mut form = now.form.clone();
    change(&mut form);
    let needs_picture = matches!(&form.lengths, LengthsForm::Ruler { intervals, .. } if *intervals > 1);
    let player = app.with(|lab| lab.player.clone()).flatten().filter(|_| needs_picture);
    let Some(player) = player else {
        return app
            .films
            .lengths_refused
            .set(app.attempt_on_desk(|desk| desk.work_on_film(|films, play| films.calibrate(play, form, None))));
    };
    let frame = app.films.frame.get_untracked();
    wasm_bindgen_futures::spawn_local(async move {
        let plane = player.plane(frame).await.ok();
        app.films.lengths_refused.set(
            app.attempt_on_desk(|desk| desk.work_on_film(|films, play| films.calibrate(play, form, plane.as_ref()))),
        );
    });
}
