//! State of the open film for views.

use super::aim::Pixel;
use super::state::Now;
use super::words;
use crate::app::App;
use desk::{Lacking, Subject};
use film::tracking::column::Click;
use std::rc::Rc;
use units::number::fixed;

/// Distance of the model in px beyond which its origin is probably wrong.
const FAR: f64 = 60.0;

/// State of the open film, without tracking the signal.
pub fn now(app: App) -> Option<Rc<Now>> {
    app.films.now.get_clone_untracked()
}

/// Updates the state from the desk.
pub fn refresh(app: App) {
    let films = app.films;
    let read = app.read_desk(|desk| {
        let before = films.pictures.get_clone_untracked();
        let pictures: Vec<_> =
            desk.films().current().into_iter().flat_map(|film| (0..2).map_while(move |n| film.space_time(n))).collect();
        let same =
            pictures.len() == before.len() && pictures.iter().zip(&before).all(|(now, before)| **now == **before);
        let changed = (!same).then(|| pictures.into_iter().cloned().map(Rc::new).collect::<Vec<_>>());
        Some((Now::of(desk).map(Rc::new), changed))
    });
    let Some((now, pictures)) = read else { return };
    films.now.set(now);
    // An open comparison with the truth is updated after a correction.
    if films.truth.with_untracked(|truth| !truth.is_empty()) {
        films.truth.set(app.read_desk(|desk| desk.films().compare_with_truth()));
    }
    if let Some(pictures) = pictures {
        wasm_bindgen_futures::spawn_local(async move {
            // The pictures are prepared for painting in a separate slice.
            view::browser::breathe().await;
            films.pictures.set(pictures);
        });
    }
}

/// Index of each track with a model, and the position of the model in this frame, px.
pub fn models(app: App, frame: usize) -> Vec<(usize, Pixel)> {
    let tracks = now(app).map_or(0, |now| now.tracks.len());
    app.read_desk(|desk| {
        let at = |track: usize| Some((track, desk.film_model(track, &[frame])[0]?));
        (0..tracks).filter_map(at).collect()
    })
}

/// Frames and positions of the model along a track, px.
pub fn model_path(app: App, track: usize, frames: &[usize]) -> Vec<(usize, Pixel)> {
    let path = app.read_desk(|desk| desk.film_model(track, frames));
    frames.iter().zip(path).filter_map(|(frame, at)| Some((*frame, at?))).collect()
}

/// Measured position in a frame and its distance from the model, as text.
pub fn values(app: App, frame: usize) -> String {
    let Some(now) = now(app) else { return String::new() };
    let words = words::of(app);
    let style = app.language.get_untracked().style();
    let models = models(app, frame);
    let lacks_origin = now.form.lacking(&now.subject) == Some(Lacking::Origin);
    let mut parts = Vec::new();
    for (number, track) in now.tracks.iter().enumerate() {
        let Ok(place) = track.points.binary_search_by_key(&frame, |point| point.frame) else { continue };
        let Some(point) = track.points.get(place) else { continue };
        let mut part = app.read_desk(|desk| desk.films().position(number, frame)).unwrap_or_default();
        if let Some((_, [x, y])) = models.iter().find(|(other, _)| *other == number) {
            let [across, down] = [x - point.position[0], y - point.position[1]];
            let residual = (across * across + down * down).sqrt();
            part += &if residual > FAR {
                format!(" · {}", if lacks_origin { words.model_far_without_origin } else { words.model_far })
            } else {
                format!(" · {} {} px", words.from_model, fixed(residual, 2, style))
            };
        }
        parts.push(part);
    }
    parts.join("   ")
}

/// Corrections of a surface.
pub fn anchors(now: &Now, surface: usize) -> &[Click] {
    match &now.subject {
        Subject::Surfaces(surfaces) => surfaces.get(surface).map_or(&[], |surface| &surface.anchors),
        _ => &[],
    }
}
