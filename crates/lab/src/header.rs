//! The top of the page: the mark, the document's title, and what concerns the page as a whole.

use crate::app::App;
use crate::theme::Theme;
use crate::views::*;
use crate::{browser, icons, keys, library, links, opening, presenter};
use units::Language;
use web_sys::HtmlInputElement;

/// The head of the page.
pub fn view(app: App) -> HtmlHeader {
    let words = app.words();
    let title = title(app);
    let browse = labelled(icons::books(), words.library)
        .id("browse")
        .title(words.library_title)
        .attr("aria-haspopup", "dialog")
        .when(events::click, move |_| library::choose(app));
    let share = labelled(icons::link(), words.share)
        .id("share")
        .title(words.share_title)
        .when(events::click, move |_| links::share(app));
    let help = button()
        .class("icon")
        .id("help")
        .title(format!("{} (?)", words.keys_title))
        .attr("aria-label", words.keys_title)
        .attr("aria-haspopup", "dialog")
        .when(events::click, move |_| keys::open())
        .child(icons::keyboard());
    let tools = div()
        .class("head-tools")
        .child(browse)
        .child(open_button(app))
        .child(share)
        .child(help)
        .child(presenter::button_of(app))
        .child(theme(app))
        .child(languages(app));
    header()
        .class("head")
        .child(p().class("brand").child(icons::mark()).child(span().child("Meniscus")))
        .child(h1().child(title))
        .child(tools)
}

/// The document's title; the program's name where none is open.
pub fn title(app: App) -> String {
    let language = app.language.get_untracked().tag();
    app.read_desk(|desk| Some(desk.document().program.edition(language).title.clone()))
        .filter(|title| !title.is_empty())
        .unwrap_or_else(|| "Meniscus".to_owned())
}

fn languages(app: App) -> HtmlDiv {
    let words = app.words();
    let choose = |language: Language| {
        button()
            .id(format!("language-{}", language.tag()))
            .lang(language.tag())
            .title(language.name())
            .attr("aria-label", format!("{} – {}", language.tag().to_uppercase(), language.name()))
            .attr("aria-pressed", move || (app.language.get() == language).to_string())
            .when(events::click, move |_| {
                app.set_language(language);
                // The page has been rebuilt, and the button with it.
                browser::focus_later(format!("language-{}", language.tag()));
            })
            .child(language.tag().to_uppercase())
    };
    div().class("segments").role("group").attr("aria-label", words.language).each(Language::ALL, choose)
}

fn theme(app: App) -> HtmlButton {
    let words = app.words();
    let theme = create_signal(Theme::remembered());
    let label = move || match theme.get() {
        Theme::System => words.theme_system,
        Theme::Light => words.theme_light,
        Theme::Dark => words.theme_dark,
    };
    let next = move |_| {
        theme.update(|theme| *theme = theme.next());
        theme.get_untracked().choose(app);
        app.notify(label());
    };
    button()
        .class("icon")
        .id("theme")
        .title(label)
        .attr("aria-label", label)
        .when(events::click, next)
        .child(icons::theme())
}

fn open_button(app: App) -> View {
    let words = app.words();
    let mut input = input().r#type("file");
    let node: HtmlInputElement = input.node();
    let chosen = node.clone();
    let read = move |_| {
        if let Some(files) = chosen.files() {
            opening::open_files(app, &files);
        }
        chosen.set_value("");
    };
    let open = labelled(icons::folder(), words.open)
        .id("open")
        .title(words.open_title)
        .when(events::click, move |_| node.click());
    let input = input
        .id("open-file")
        .hidden(true)
        .multiple(true)
        .accept(".md,.markdown,.html,.htm,text/markdown,text/html")
        .attr("aria-label", words.open_title)
        .when(events::change, read);
    View::from((open, input))
}
