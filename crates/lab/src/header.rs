//! The top of the page: the mark, the document's title, and what concerns the page as a whole.

use crate::app::App;
use crate::theme::Theme;
use crate::words::Language;
use crate::{browser, icons, keys, library, opening};
use leptos::html;
use leptos::prelude::*;

/// The head of the page.
pub fn view(app: App) -> impl IntoView {
    let words = app.words();
    let title = title(app);
    view! {
        <header class="head">
            <p class="brand">{icons::mark()}<span>"Meniscus"</span></p>
            <h1>{title}</h1>
            <div class="head-tools">
                <button type="button" class="quiet with-icon" id="browse" title=words.library_title aria-haspopup="dialog" on:click=move |_| library::choose(app)>
                    {icons::books()}<span>{words.library}</span>
                </button>
                {open_button(app)}
                <button type="button" class="quiet with-icon" id="share" title=words.share_title on:click=move |_| share(app)>
                    {icons::link()}<span>{words.share}</span>
                </button>
                <button type="button" class="icon" id="help" title=format!("{} (?)", words.keys_title) aria-label=words.keys_title aria-haspopup="dialog"
                    on:click=move |_| keys::open()>{icons::keyboard()}</button>
                {theme(app)}
                {languages(app)}
            </div>
        </header>
    }
}

/// The document's title; the program's name where none is open.
pub fn title(app: App) -> String {
    let language = app.language.get_untracked().tag();
    app.read(|session| Some(session.document().edition(language).title.clone()))
        .filter(|title| !title.is_empty())
        .unwrap_or_else(|| "Meniscus".to_owned())
}

fn languages(app: App) -> impl IntoView {
    let words = app.words();
    let buttons = Language::ALL
        .into_iter()
        .map(|language| {
            view! {
                <button type="button" id=format!("language-{}", language.tag()) lang=language.tag() title=language.name()
                    aria-label=format!("{} – {}", language.tag().to_uppercase(), language.name())
                    aria-pressed=move || (app.language.get() == language).to_string()
                    on:click=move |_| {
                        app.set_language(language);
                        // The page has been built anew, the button with it.
                        browser::focus_later(format!("language-{}", language.tag()));
                    }>{language.tag().to_uppercase()}</button>
            }
        })
        .collect_view();
    view! { <div class="segments" role="group" aria-label=words.language>{buttons}</div> }
}

fn theme(app: App) -> impl IntoView {
    let words = app.words();
    let theme = RwSignal::new(Theme::remembered());
    let label = move || match theme.get() {
        Theme::System => words.theme_system,
        Theme::Light => words.theme_light,
        Theme::Dark => words.theme_dark,
    };
    let next = move |_| {
        theme.update(|theme| *theme = theme.next());
        theme.get_untracked().choose(app);
        app.say(label().to_owned());
    };
    view! { <button type="button" class="icon" id="theme" title=label aria-label=label on:click=next>{icons::theme()}</button> }
}

fn open_button(app: App) -> impl IntoView {
    let words = app.words();
    let input = NodeRef::<html::Input>::new();
    view! {
        <button type="button" class="quiet with-icon" id="open" title=words.open_title on:click=move |_| if let Some(input) = input.get_untracked() { input.click() }>
            {icons::folder()}<span>{words.open}</span>
        </button>
        <input node_ref=input type="file" id="open-file" hidden multiple accept=".md,.markdown,.html,.htm,text/markdown,text/html" aria-label=words.open_title
            on:change=move |_| if let Some(input) = input.get_untracked() {
                if let Some(files) = input.files() { opening::open_files(app, &files); }
                input.set_value("");
            } />
    }
}

/// Puts the state into the address bar and the clipboard.
fn share(app: App) {
    let words = app.words();
    let fragment = app.read(|session| session.share());
    let location = window().location();
    let href = location.href().unwrap_or_default();
    let base = href.split('#').next().unwrap_or_default();
    let link = if fragment.is_empty() { base.to_owned() } else { format!("{base}#{fragment}") };
    // Refused inside some frames; the clipboard may still work.
    if let Ok(history) = window().history() {
        let _ = history.replace_state_with_url(&wasm_bindgen::JsValue::NULL, "", Some(&link));
    }
    browser::copy(&link, move |allowed| {
        app.say(if allowed { words.link_copied } else { words.link_not_copied }.to_owned())
    });
}
