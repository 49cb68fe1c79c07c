//! Navigation between frames.

use super::refusals::said;
use crate::app::App;
use view::browser;

/// Goes to a frame, at most to the last one.
pub fn go(app: App, frame: usize) {
    let Some(player) = app.with(|lab| lab.player.clone()).flatten() else { return };
    let frame = frame.min(player.source.count().saturating_sub(1));
    if app.films.frame.get_untracked() != frame {
        app.films.frame.set(frame);
    }
    player.show(frame, move |frame, trouble| {
        app.films.painted.set(Some(frame));
        if let Some(trouble) = trouble {
            app.complain(said(app, &trouble));
        }
    });
}

/// Shows the frame of a time of the run (SI) under the pointer.
pub fn look_at(app: App, time: &mut dyn FnMut() -> Option<f64>) {
    let films = app.films;
    if !(films.open.get_untracked() && films.shown.get_untracked()) || films.playing.get_untracked() {
        return;
    }
    let Some(time) = time() else { return };
    if let Some(frame) = app.read_desk(|desk| desk.films().frame_at_model_time(time)) {
        go(app, frame);
    }
}

/// Plays the film from the shown frame at the speed of the file, or pauses it.
pub fn play(app: App) {
    let films = app.films;
    let playing = !films.playing.get_untracked();
    films.playing.set(playing);
    let Some(player) = app.with(|lab| lab.player.clone()).flatten().filter(|_| playing) else { return };
    wasm_bindgen_futures::spawn_local(async move {
        let times = player.source.film.times();
        let first = films.frame.get_untracked();
        let first = if first + 1 >= times.len() { 0 } else { first };
        let begun = js_sys::Date::now();
        while films.playing.get_untracked() && films.open.get_untracked() {
            let seconds = times.get(first).copied().unwrap_or(0.0) + (js_sys::Date::now() - begun) / 1000.0;
            let frame = times.partition_point(|time| *time <= seconds).saturating_sub(1);
            go(app, frame);
            if frame + 1 >= times.len() {
                break;
            }
            browser::breathe().await;
        }
        films.playing.set(false);
    });
}

/// Moves by `by` frames.
pub fn step(app: App, by: isize) {
    go(app, app.films.frame.get_untracked().saturating_add_signed(by));
}
