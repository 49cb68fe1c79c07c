//! Film in the archive of a Tracker project that has become a record.

use super::access::Trouble;
use super::opening::take;
use super::refusals::said;
use super::words;
use crate::app::App;
use crate::documents::packing;
use desk::{FilmOpening, ProjectFilm};
use js_sys::{Array, Uint8Array};
use view::browser;
use web_sys::{Blob, File};

/// Maximum size of an unpacked film in bytes. It stays in memory while it is open.
const MOST_UNPACKED: u64 = 256 << 20;

/// Opens the film in the archive of the last imported project, if any. If that fails, the record is unchanged and the
/// reason is shown.
pub async fn open(app: App, archive: &File) {
    let Some(own) = app.read_desk(|desk| desk.change_films(|films, _| films.take_project_film())) else { return };
    app.films.opening.set(Some(own.name().to_owned()));
    let opened = match extracted(archive, &own).await {
        Ok(file) => take(app, file, |desk, identity, film| desk.open_project_film(&own, identity, film)).await,
        Err(trouble) => {
            Err(trouble.map_or(words::of(app).unpacked_too_large.to_owned(), |trouble| said(app, &trouble)))
        }
    };
    app.films.opening.set(None);
    match opened {
        Err(why) => app.complain(format!("{} {}: {why}", words::of(app).project_film_not_opened, own.name())),
        Ok(FilmOpening::TakenUp) => app.notify(words::of(app).taken_up),
        Ok(_) => app.notify(words::of(app).project_film_opened),
    }
}

/// Film as a file: an unread part of the archive, or the unpacked content.
///
/// # Errors
///
/// The [`Trouble`], or `None` if the unpacked film would be too large.
async fn extracted(archive: &File, own: &ProjectFilm) -> Result<File, Option<Trouble>> {
    let unreadable = || Some(Trouble::Unreadable);
    let range = own.range();
    let part = archive.slice_with_f64_and_f64(range.start as f64, range.end as f64).map_err(|_| unreadable())?;
    let parts = if own.is_deflated() { unpacked(&part, own.size()).await? } else { Array::of1(&part) };
    File::new_with_blob_sequence(&parts, own.name()).map_err(|_| unreadable())
}

async fn unpacked(part: &Blob, size: u64) -> Result<Array, Option<Trouble>> {
    if size > MOST_UNPACKED {
        return Err(None);
    }
    let bytes = browser::wait(part.array_buffer()).await.map_err(|_| Some(Trouble::Unreadable))?;
    let parts = packing::inflate_parts(&Uint8Array::new(&bytes), size as usize).await;
    parts.ok_or(Some(Trouble::Unreadable))
}
