//! Header of the page: logo, title, and controls for the whole page.

use crate::app::{App, title};
use crate::theme::Theme;
use crate::views::*;
use crate::{browser, icons, keys, presenter};
use units::Language;

/// The header, with the page's `own` buttons before the others.
pub fn view(app: App, own: View) -> HtmlHeader {
    let words = app.words();
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
        .child(own)
        .child(help)
        .child(presenter::button_of(app))
        .child(theme(app))
        .child(languages(app));
    header()
        .class("head")
        .child(p().class("brand").child(icons::mark()).child(span().child("Meniscus")))
        .child(h1().child(text(move || {
            app.changes.program.track();
            title(app)
        })))
        .child(tools)
}

fn languages(app: App) -> HtmlDiv {
    let words = app.words();
    let choose = |language: Language| {
        button()
            .id(format!("language-{}", language.tag()))
            .lang(language.tag())
            .title(language.name())
            .attr("aria-label", format!("{} – {}", language.tag().to_ascii_uppercase(), language.name()))
            .attr("aria-pressed", move || (app.language.get() == language).to_string())
            .when(events::click, move |_| {
                app.set_language(language);
                // The page and the button have been rebuilt.
                browser::focus_later(format!("language-{}", language.tag()));
            })
            .child(language.tag().to_ascii_uppercase())
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
