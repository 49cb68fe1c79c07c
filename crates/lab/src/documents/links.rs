//! Links: evaluates the address, and creates links to the present state.

use crate::app::App;
use crate::{documents::packing, documents::visited, library};
use document::page::{self, Source};
use play::{Embedding, LONGEST_PACKED, LONGEST_UNPACKED, Link, Refusal, Subject, packed_length};
use view::browser::{self, address, fragment, is_heading};
use view::{page::everything, page::shell};

/// Document and state that a link refers to.
pub struct Arrival {
    /// Files of the document.
    pub sources: Vec<Source>,
    /// State of the document; empty if there is none.
    pub state: String,
    /// Reason if the link could not be followed completely.
    pub refusal: Option<Refusal>,
    /// Name of the file that the link needs, and the state of that document.
    pub awaited: Option<(String, String)>,
}

/// Document at the start of the page: that of the present history entry, otherwise that of the address.
pub async fn first() -> Arrival {
    match visited::present() {
        Some(visited::Visited { sources, .. }) => {
            Arrival { sources, state: String::new(), refusal: None, awaited: None }
        }
        None => read(&fragment()).await,
    }
}

/// Document of a fragment, or the page's own document if it cannot be opened.
pub async fn read(fragment: &str) -> Arrival {
    let mut arrival = Arrival { sources: library::home(), state: String::new(), refusal: None, awaited: None };
    if is_heading(fragment) {
        return arrival;
    }
    let Link { subject, state } = match Link::read(fragment) {
        Ok(link) => link,
        Err(refusal) => {
            arrival.refusal = Some(refusal);
            return arrival;
        }
    };
    let found = match &subject {
        Subject::Home => Ok(library::unnamed(&state)),
        Subject::Library(name) => library::find(name).ok_or_else(|| Refusal::DocumentNeeded { name: name.to_owned() }),
        Subject::Packed(bytes) => {
            let list = packing::inflate(bytes, LONGEST_UNPACKED).await;
            list.and_then(|list| page::read_list(&list)).ok_or(Refusal::UnreadableState)
        }
        Subject::File(name) => Err(Refusal::DocumentNeeded { name: name.to_owned() }),
    };
    match found {
        Ok(sources) => (arrival.sources, arrival.state) = (sources, state),
        Err(Refusal::DocumentNeeded { name }) => {
            arrival.awaited = Some((name.clone(), state));
            arrival.refusal = Some(Refusal::DocumentNeeded { name });
        }
        Err(refusal) => arrival.refusal = Some(refusal),
    }
    arrival
}

/// Prefixes of addresses that are reachable from this computer only.
const LOCAL: [&str; 4] = ["file:", "http://127.0.0.1", "http://localhost", "http://[::1]"];

/// True if an address is reachable from this computer only.
pub fn is_local(address: &str) -> bool {
    LOCAL.iter().any(|start| address.starts_with(start))
}

/// Link to the present state, and a remark on its document, if any.
pub async fn present(app: App) -> (String, Option<String>) {
    let sources = app.with(|lab| lab.sources.clone()).unwrap_or_default();
    let (subject, remark) = pack(app, &sources).await;
    let state = app.read_desk(|desk| desk.play().share());
    let options = Embedding { everything: everything::in_link(app.page), ..shell::embedding() };
    (options.in_address(&address(&Link { subject, state }.write())), remark)
}

/// Puts a link to the present state into the address bar and the clipboard. `say` is called with a message: success or
/// failure, what the link does not contain, and who cannot open it.
pub fn share(app: App, say: impl FnOnce(String) + 'static) {
    wasm_bindgen_futures::spawn_local(async move {
        let words = app.words();
        let (link, remark) = present(app).await;
        let missing = app.read_desk(|desk| desk::missing_in_link(desk));
        // Refused inside some frames; the clipboard may still work.
        visited::note(app, Some(&link));
        let shown = link.clone();
        browser::copy(&link, move |allowed| {
            let copied = if allowed { words.link_copied } else { words.link_not_copied };
            let mut sentences = vec![format!("{copied}.")];
            sentences.extend(remark);
            if !missing.is_empty() {
                sentences.push(format!("{}: {}.", words.link_without, missing.join(", ")));
            }
            sentences.extend(is_local(&shown).then(|| words.link_local.to_owned()));
            say(sentences.join(" "));
        });
    });
}

/// Document part of a link, and a remark on it, if any. Contains the document with its translations if short enough,
/// otherwise without them, otherwise only its name.
async fn pack(app: App, sources: &[Source]) -> (Subject, Option<String>) {
    let words = app.words();
    let known = library::subject_of_state(sources);
    if !matches!(known, Subject::File(_)) {
        return (known, None);
    }
    for count in [sources.len(), 1] {
        let files = sources.get(..count).unwrap_or_default();
        let packed = packing::deflate(&page::write_list(files)).await;
        let size: usize = files.iter().map(|file| file.text.len()).sum();
        if let Some(bytes) = packed.filter(|bytes| packed_length(bytes.len()) <= LONGEST_PACKED)
            && size <= LONGEST_UNPACKED / 2
        {
            let remark = (count < sources.len()).then(|| words.link_without_translations.to_owned());
            return (Subject::Packed(bytes), remark);
        }
    }
    let name = sources.first().map_or("", |file| &file.name);
    (known, Some(format!("{} {name}.", words.link_needs_file)))
}
