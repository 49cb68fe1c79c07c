//! Pages made by `meniscus serve` follow the files of their document while these are edited in another program.

use crate::app::App;
use crate::{documents::opening, documents::visited, library, write};
use document::page::{self, Source};
use model::{Diagnostic, Severity};
use view::page::message::Message;
use view::views::window;
use view::{browser, page::messages};
use wasm_bindgen::JsCast;
use web_sys::{HtmlLinkElement, Response};

/// Polling interval, in milliseconds.
const PAUSE: i32 = 600;
/// Maximum polling interval, in milliseconds: it grows while the server does not answer.
const LONGEST_PAUSE: i32 = 20_000;
/// Number of consecutive refusals after which the files count as unreadable: an editor may remove them for a moment
/// while saving.
const REFUSALS: usize = 3;

/// Answer of the server.
enum Answer {
    /// The list of the present files.
    Files(String),
    /// The files cannot be read.
    Refused,
}

/// Follows the files as long as the page is open; does nothing in pages that are not served.
pub fn follow(app: App) {
    let Some(address) = browser::by_id::<HtmlLinkElement>("served").map(|link| link.href()) else { return };
    wasm_bindgen_futures::spawn_local(async move {
        let mut last = page::write_list(&library::home());
        let mut pause = PAUSE;
        let mut refusals = 0;
        let (mut of_text, mut of_file) = (None, None);
        loop {
            browser::pause(pause).await;
            let answer = asked(&address).await;
            pause = if answer.is_some() { PAUSE } else { (2 * pause).min(LONGEST_PAUSE) };
            match answer {
                Some(Answer::Files(list)) => {
                    refusals = 0;
                    replace(app, &mut of_file, None);
                    if list != last {
                        last.clone_from(&list);
                        if let Some(files) = page::read_list(&list) {
                            let message = take(app, files);
                            replace(app, &mut of_text, message);
                        }
                    }
                }
                Some(Answer::Refused) => {
                    refusals += 1;
                    if refusals == REFUSALS {
                        replace(app, &mut of_file, Some(unreadable(app)));
                    }
                }
                None => {}
            }
        }
    });
}

/// Answer of the server; `None` if it does not answer.
async fn asked(address: &str) -> Option<Answer> {
    let response: Response = browser::wait(window().fetch_with_str(address)).await.ok()?.dyn_into().ok()?;
    if !response.ok() {
        return Some(Answer::Refused);
    }
    browser::wait(response.text().ok()?).await.ok()?.as_string().map(Answer::Files)
}

/// Replaces the previous message, which is outdated.
fn replace(app: App, shown: &mut Option<Message>, message: Option<Message>) {
    if let Some(before) = shown.take() {
        messages::remove(app.page, &before);
    }
    if let Some(message) = message {
        app.report(message.clone());
        *shown = Some(message);
    }
}

fn unreadable(app: App) -> Message {
    let name = library::home().first().map_or_else(String::new, |file| file.name.clone());
    Message::error(format!("{name} {}", app.words().file_unreadable))
}

/// Shows the changed files if their document is open; time, view and parameters stay. Returns a message to be shown as
/// long as the files stay in this state.
fn take(app: App, files: Vec<Source>) -> Option<Message> {
    let open = visited::sources(app);
    let before = library::home();
    library::change_home(files.clone());
    let of = |files: &[Source], name: &str| files.iter().find(|file| file.name == name).map(|file| file.text.clone());
    if open.first().map(|file| &file.name) != files.first().map(|file| &file.name) {
        return None;
    }
    // A translation begun in this page does not belong to the files.
    let followed =
        open.iter().map(|file| &file.name).filter(|name| of(&before, name).is_some() || of(&files, name).is_some());
    if !followed.eq(files.iter().map(|file| &file.name)) || !app.read(|_| true) {
        let state = app.read(|play| play.share());
        opening::leave(app);
        opening::open(app, files, &state);
        visited::note(app, None);
        app.say(app.words().file_followed.to_owned());
        return None;
    }
    let texts = visited::files(app).into_iter().map(|file| of(&files, &file.name).unwrap_or(file.text));
    let texts: Vec<String> = texts.collect();
    if let Some(version) = write::follow_file(app, &before, &texts) {
        app.report(Message::error(app.words().file_replaced.to_owned()).restoring(version));
    }
    let is_error = |found: &&(usize, Diagnostic)| found.1.severity == Severity::Error;
    let faulty = app.read_writing(|writing| writing.findings().iter().find(is_error).map(|(file, _)| *file));
    let Some(file) = faulty.and_then(|file| open.get(file)) else {
        app.say(app.words().file_followed.to_owned());
        return None;
    };
    let sentence = format!("{}: {}", file.name, write::summary(app));
    Some(Message::error(sentence).leading_to(write::FINDINGS.to_owned()))
}
