//! Run beside the film. It is computed to the end of the film and shows the time of the shown frame, so that plots and
//! film agree and the model can be drawn over the film.

use super::now::now;
use crate::app::App;
use view::browser;
use view::views::*;

/// Duration of a slice of work, ms; the page reacts between slices.
const SLICE: f64 = 10.0;

/// Keeps the run at the time of the film as long as the page exists.
pub fn follow(app: App) {
    let films = app.films;
    effect(move || {
        films.frame.track();
        films.now.track();
        app.changes.parameters.track();
        if films.open.get() && films.shown.get() && now(app).is_some_and(|now| now.record.is_some()) {
            bring(app);
        }
    });
}

/// Times of the run (SI) at the shown frame and at the last frame of the used part.
fn ends(app: App) -> Option<[f64; 2]> {
    let last = now(app)?.ends[1];
    let frame = app.films.frame.get_untracked();
    app.read_desk(|desk| desk.films().model_time_of(frame).zip(desk.films().model_time_of(last)))
        .map(|(time, until)| [time, until])
}

/// Computes the run to the end of the film and shows the time of the frame, in slices between which the page reacts.
fn bring(app: App) {
    if app.with(|lab| std::mem::replace(&mut lab.bringing, true)) != Some(false) {
        return;
    }
    wasm_bindgen_futures::spawn_local(async move {
        // Starts outside of the change that caused it.
        browser::breathe().await;
        while let Some([_, until]) = ends(app) {
            let end = js_sys::Date::now() + SLICE;
            let more = app.read(|play| {
                let mut more = true;
                while more && js_sys::Date::now() < end {
                    more = play.change_run(|line, _| line.compute_on(until));
                }
                more
            });
            if !more {
                break;
            }
            browser::breathe().await;
        }
        app.with(|lab| lab.bringing = false);
        if let Some([time, _]) = ends(app) {
            app.slide(|play| play.change_run(|line, _| line.show_time(time)));
        }
    });
}
