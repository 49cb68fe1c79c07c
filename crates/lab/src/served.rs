//! A page that `meniscus serve` has made follows the files of its document while they are written in another program.

use crate::app::App;
use crate::{library, opening, visited, write};
use document::page::{self, Source};
use view::browser;
use view::views::window;
use wasm_bindgen::JsCast;
use web_sys::{HtmlLinkElement, Response};

/// The files are asked for so often, in milliseconds.
const PAUSE: i32 = 600;
/// While no answer comes, more and more seldom, up to this.
const LONGEST_PAUSE: i32 = 20_000;

/// Follows the files as long as the page is open; does nothing in pages that are not served.
pub fn follow(app: App) {
    let Some(address) = browser::by_id::<HtmlLinkElement>("served").map(|link| link.href()) else { return };
    wasm_bindgen_futures::spawn_local(async move {
        let mut last = page::write_list(&library::home());
        let mut pause = PAUSE;
        loop {
            browser::pause(pause).await;
            match asked(&address).await {
                Some(list) => {
                    pause = PAUSE;
                    if list != last {
                        last.clone_from(&list);
                        page::read_list(&list).into_iter().for_each(|files| take(app, files));
                    }
                }
                None => pause = (2 * pause).min(LONGEST_PAUSE),
            }
        }
    });
}

/// The list of the files as they are now.
async fn asked(address: &str) -> Option<String> {
    let response: Response = browser::wait(window().fetch_with_str(address)).await.ok()?.dyn_into().ok()?;
    if !response.ok() {
        return None;
    }
    browser::wait(response.text().ok()?).await.ok()?.as_string()
}

/// Shows the files where the document is open; time, view and parameters stay.
fn take(app: App, files: Vec<Source>) {
    let open = visited::sources(app);
    let names = |files: &[Source]| files.iter().map(|file| file.name.clone()).collect::<Vec<_>>();
    let first = |files: &[Source]| files.first().map(|file| file.name.clone());
    let (same_document, same_files) = (first(&open) == first(&files), names(&open) == names(&files));
    library::change_home(files.clone());
    if !same_document {
        return;
    }
    if same_files && app.read(|_| true) {
        let texts: Vec<String> = files.into_iter().map(|file| file.text).collect();
        write::follow_file(app, &texts);
    } else {
        let state = app.read(|play| play.share());
        opening::leave(app);
        opening::open(app, files, &state);
        visited::note(app, None);
    }
    app.say(app.words().file_followed.to_owned());
}
