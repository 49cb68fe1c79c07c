//! Tracking: decodes the frames that the desk requests, and lets it compute between them.

use super::access::{Greys, Reader, Trouble};
use super::aim::Tool;
use super::frames::go;
use super::refusals::{refuse, said};
use crate::app::App;
use film::tracking::lost_from;
use view::browser;
use view::views::*;

/// Duration of a slice of work, ms; the page reacts between slices.
const SLICE: f64 = 20.0;
/// Interval between updates of the space-time pictures, ms.
const STRIPS: f64 = 300.0;
/// Number of steps between readings of the clock.
const STEPS: usize = 10;
/// Number of successive frames without a picture beyond which the film counts as damaged.
const DAMAGED: usize = 10;

/// Starts the tracking.
pub fn begin(app: App) {
    let refusal = app.attempt_on_desk(|desk| desk.change_films(|films, play| films.begin_tracking(play)));
    let refused = refusal.is_some();
    refuse(app, refusal);
    if !refused {
        go_on(app);
    }
}

/// Continues from the results of an earlier visit.
pub fn take_up(app: App) {
    refuse(app, app.attempt_on_desk(|desk| desk.change_films(|films, play| films.take_up_tracking(play))));
    go_on(app);
}

/// Continues the tracking of the desk, unless this already runs.
pub fn go_on(app: App) {
    if app.with(|lab| std::mem::replace(&mut lab.tracking, true)) != Some(false) {
        return;
    }
    wasm_bindgen_futures::spawn_local(async move {
        let refusal = loop {
            let refusal = follow(app).await;
            // The views of the record are built in a separate slice. Another tracking may begin before it.
            browser::breathe().await;
            if refusal.is_some() || !app.read_desk(|desk| desk.films().is_tracking()) {
                break refusal;
            }
        };
        app.with(|lab| lab.tracking = false);
        app.films.progress.set(None);
        refuse(app, refusal);
        app.act(|_| ());
        ask_again(app);
    });
}

/// Shows the frame in which a body was lost, for a click on it, unless the ruler has been begun.
fn ask_again(app: App) {
    let lost_from = app.read_desk(|desk| desk.films().current().and_then(|film| lost_from(&film.doubtful())));
    if let Some(frame) = lost_from.filter(|_| app.films.ruler.with_untracked(Vec::is_empty)) {
        app.films.tool.set(Tool::Subject);
        go(app, frame);
    }
}

fn show_progress(app: App) {
    app.films.progress.set(app.read_desk(|desk| desk.films().tracking_progress()));
}

/// Runs the tracking. Returns the message of an error that ended it.
async fn follow(app: App) -> Option<String> {
    let player = app.with(|lab| lab.player.clone()).flatten()?;
    let source = player.source.clone();
    let (mut reader, mut greys) = (Reader::new(source.clone()), Greys::of(&source));
    let clock = window().performance();
    let now = || clock.as_ref().map_or(0.0, |clock| clock.now());
    let mut end = now() + SLICE;
    let mut shown = now();
    let mut failed = 0;
    while app.read_desk(|desk| desk.films().is_tracking()) {
        let refusal = match app.read_desk(|desk| desk.films().wanted_frame()) {
            None => app.read_desk(|desk| {
                let refused = desk.advance_tracking(STEPS).err();
                refused.map(|refusal| refusal.text(desk.play()))
            }),
            Some(frame) => {
                let plane = match reader.picture(frame).await {
                    Ok(picture) => greys.read(&picture).await,
                    Err(Trouble::Frame(_)) => None,
                    Err(trouble) => {
                        app.act_on_desk(|desk| desk.change_films(|films, _| films.cancel_tracking()));
                        return Some(said(app, &trouble));
                    }
                };
                failed = if plane.is_some() { 0 } else { failed + 1 };
                if failed > DAMAGED {
                    app.act_on_desk(|desk| desk.change_films(|films, _| films.cancel_tracking()));
                    return Some(said(app, &Trouble::Frame(frame + 1)));
                }
                app.read_desk(|desk| {
                    let refused = match plane {
                        Some(plane) => desk.change_films(|films, play| films.give_frame(play, frame, plane)),
                        None => desk.change_films(|films, play| films.leave_out_frame(play, frame)),
                    };
                    refused.err().map(|refusal| refusal.text(desk.play()))
                })
            }
        };
        if refusal.is_some() {
            return refusal;
        }
        if now() > end {
            show_progress(app);
            if now() > shown + STRIPS && app.read_desk(|desk| desk.films().wanted_frame()).is_some() {
                app.act_on_desk(|desk| desk.change_films(|films, _| films.show_strips()));
                shown = now();
            }
            browser::breathe().await;
            end = now() + SLICE;
        }
    }
    None
}
