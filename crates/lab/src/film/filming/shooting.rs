//! Filming: a second run of the simulation proceeds from frame to frame, and its scene is drawn at instants within each
//! exposure.

use super::drawing::Drawing;
use crate::app::App;
use crate::film::opening;
use desk::{FilmOpening, FilmRecipe, FilmTruth};
use film::Plane;
use film::camera::{Exposure, Noise, instants};
use play::Play;
use view::browser;
use view::views::*;

/// Duration of a slice of work, ms; the page reacts between slices.
const SLICE: f64 = 12.0;
/// Number of drawings per pixel of motion during an exposure, and the maximum number of drawings.
const DRAWINGS_PER_PIXEL: f64 = 2.0;
const MOST_DRAWINGS: f64 = 12.0;
/// Extent of the motion below which a shape is at rest, px.
const REST: f64 = 0.05;

/// Films a recipe and opens the film. Progress is in [`crate::film::Films::filming`]; clearing it cancels the filming.
pub fn film(app: App, recipe: FilmRecipe) {
    if app.films.filming.get_untracked().is_some() {
        return;
    }
    app.films.filming.set(Some([0, recipe.settings.frames()]));
    wasm_bindgen_futures::spawn_local(async move {
        let filmed = shoot(app, &recipe).await;
        // The film is opened and shown in separate tasks.
        browser::breathe().await;
        let cancelled = app.films.filming.take().is_none();
        match filmed {
            _ if cancelled => {}
            Err(why) => app.complain(why),
            Ok((planes, truth)) => match opening::open_filmed(app, recipe, planes, truth) {
                Err(why) => app.complain(why),
                Ok(FilmOpening::TakenUp) => app.notify(crate::film::words::of(app).taken_up),
                Ok(_) => app.say(crate::film::words::of(app).filmed.to_owned()),
            },
        }
    });
}

/// Frames and true positions.
///
/// # Errors
///
/// A message, empty if the filming was cancelled.
async fn shoot(app: App, recipe: &FilmRecipe) -> Result<(Vec<Plane>, FilmTruth), String> {
    let words = crate::film::words::of(app);
    // The page shows the click first. Each step of the preparation is a separate task.
    browser::breathe().await;
    let play = app.with(|lab| {
        let desk = lab.desk.as_ref()?;
        Some(desk.films().filmed_play(recipe).map_err(|why| why.text(desk.play())))
    });
    let mut play = play.flatten().unwrap_or_else(|| Err(words.no_document.to_owned()))?;
    browser::breathe().await;
    let mut drawing = Drawing::of(&mut play).ok_or_else(|| words.not_drawn.to_owned())?;
    browser::breathe().await;
    let settings = recipe.settings;
    let noise = Noise::new(settings.noise, u64::from(settings.seed));
    let mut clock = Slices::new();
    let mut planes = Vec::new();
    let mut truth = FilmTruth {
        pixel: drawing.ruler.as_ref().map(|ruler| ruler.pixel),
        ruler: drawing.ruler.as_ref().map(|ruler| ruler.length.clone()),
        parts: vec![Vec::new(); drawing.places().len()],
    };
    for frame in 0..settings.frames() {
        let time = settings.time(frame);
        if !reach(&mut play, time + settings.exposure / 2.0, &mut clock).await {
            break;
        }
        let mut at = |play: &mut Play, time: f64| {
            play.change_run(|line, _| line.show_time(time));
            drawing.follow(play);
            drawing.places()
        };
        let (begin, end) =
            (at(&mut play, time - settings.exposure / 2.0), at(&mut play, time + settings.exposure / 2.0));
        let middle = at(&mut play, time);
        clock.breathe().await;
        let count = (DRAWINGS_PER_PIXEL * farthest(&begin, &end)).ceil().clamp(1.0, MOST_DRAWINGS) as usize;
        let mut exposure: Option<Exposure> = None;
        for instant in instants(time, settings.exposure, count) {
            play.change_run(|line, _| line.show_time(instant));
            drawing.follow(&mut play);
            let plane = drawing.plane().await.ok_or_else(|| words.not_drawn.to_owned())?;
            match &mut exposure {
                None => exposure = Some(Exposure::new(&plane)),
                Some(exposure) => drop(exposure.add(&plane)),
            }
            clock.breathe().await;
        }
        planes.extend(exposure.and_then(|exposure| exposure.develop(&noise, frame as u64)));
        clock.breathe().await;
        truth.parts.iter_mut().zip(middle).for_each(|(part, place)| part.push(place));
        if app.films.filming.get_untracked().is_none() {
            return Err(String::new());
        }
        app.films.filming.set(Some([frame + 1, settings.frames()]));
    }
    truth.parts.retain(|part| moves(part));
    Ok((planes, truth))
}

/// Computes the run up to a time (SI). Returns false if it ends before.
async fn reach(play: &mut Play, time: f64, clock: &mut Slices) -> bool {
    while play.course().front() < time {
        if !play.change_run(|line, _| line.compute_on(time)) {
            return false;
        }
        clock.breathe().await;
    }
    true
}

/// Largest displacement of a shape, px.
fn farthest(begin: &[[f64; 2]], end: &[[f64; 2]]) -> f64 {
    let square = |(from, to): (&[f64; 2], &[f64; 2])| {
        let [across, down] = [to[0] - from[0], to[1] - from[1]];
        across * across + down * down
    };
    begin.iter().zip(end).map(square).filter(|square| square.is_finite()).fold(0.0, f64::max).sqrt()
}

fn moves(part: &[[f64; 2]]) -> bool {
    (0..2).any(|k| {
        let places = || part.iter().map(|place| place[k]).filter(|place| place.is_finite());
        places().fold(f64::MIN, f64::max) - places().fold(f64::MAX, f64::min) > REST
    })
}

/// Lets the page react after each slice of work.
struct Slices {
    end: f64,
}

impl Slices {
    fn new() -> Self {
        Self { end: Self::now() + SLICE }
    }

    fn now() -> f64 {
        window().performance().map_or(0.0, |clock| clock.now())
    }

    async fn breathe(&mut self) {
        if Self::now() > self.end {
            browser::breathe().await;
            self.end = Self::now() + SLICE;
        }
    }
}
