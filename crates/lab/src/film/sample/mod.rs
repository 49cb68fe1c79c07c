//! Sample film: a drawn film of a U-tube (`simulations/films`), a part of the page that is loaded when it is asked for.
//!
//! `story.rs` plays it, measures it, and lays drawing and fit over it: *See it measured*.

mod moment;
mod story;

pub use moment::Moment;
pub use story::{bar, begin, follow};

use super::access::Trouble;
use super::now::now;
use super::refusals::said;
use super::{opening, tracking};
use crate::app::App;
use desk::{Desk, FilmOpening, FilmedSurface, LengthsForm, Subject};
use film::tracking::column::Click;
use js_sys::Array;
use view::browser;
use view::page::opening::Opening;
use web_sys::File;

/// Name of the film as a file.
const NAME: &str = "sample-film.mp4";
/// Left surface in the first frame, px.
const SURFACE: [f64; 2] = [205.5, 223.8];
/// The surface at rest, px.
const REST: [f64; 2] = [205.5, 357.0];
/// The two black marks of the ruler, px, and the length between them.
const MARKS: [[f64; 2]; 2] = [[312.75, 573.0], [312.75, 141.0]];
const LENGTH: &str = "12 cm";

/// Opens the film; the length between its marks is typed already.
pub fn open(app: App) {
    app.tab.set(view::panel::tabs::MEASURE);
    wasm_bindgen_futures::spawn_local(async move {
        match take(app).await {
            Err(why) => app.complain(format!("{} {why}", super::words::of(app).not_opened)),
            Ok(_) => app.films.length.set(LENGTH.to_owned()),
        }
    });
}

/// Loads the film and opens it in place of the open one.
///
/// # Errors
///
/// A message why that was not possible.
async fn take(app: App) -> Result<FilmOpening, String> {
    app.films.opening.set(Some(NAME.to_owned()));
    let opened = match file().await {
        Some(file) => {
            let open =
                |desk: &mut Desk, identity, film| desk.change_films(|films, play| films.open(play, identity, film));
            opening::take(app, file, open).await
        }
        None => Err(said(app, &Trouble::Unreadable)),
    };
    app.films.opening.set(None);
    opened
}

async fn file() -> Option<File> {
    let bytes = browser::wait(Opening::of_page()?.bytes("sample-film")?).await.ok()?;
    File::new_with_u8_array_sequence(&Array::of1(&bytes), NAME).ok()
}

/// Marks surface, ruler and origin, and tracks the surface.
fn measure(app: App) {
    let Some(now) = now(app) else { return };
    if now.record.is_some() {
        return;
    }
    let click = Click { frame: 0, position: SURFACE };
    let subject = Subject::Surfaces(vec![FilmedSurface::new(click)]);
    let lengths = LengthsForm::Ruler { marks: MARKS, length: LENGTH.to_owned(), intervals: 1 };
    let mut form = now.form.clone();
    (form.lengths, form.origin) = (lengths, Some(REST));
    app.films.ruler.set(MARKS.to_vec());
    app.films.length.set(LENGTH.to_owned());
    app.attempt_on_desk(|desk| desk.work_on_film(|films, play| films.follow(play, subject)));
    app.attempt_on_desk(|desk| desk.work_on_film(|films, play| films.calibrate(play, form, None)));
    tracking::begin(app);
}
