//! Header of the page: logo, title, and controls for the whole page.

use crate::app::{App, title};
use crate::page::theme::Theme;
use crate::views::*;
use crate::{browser, page::keys, pieces::icons};
use units::number::fixed;
use units::{Catalogue, Language};
use wasm_bindgen::JsCast;
use web_sys::{FocusEvent, HtmlElement, KeyboardEvent, Node};

/// The header, with a `line` beside the title, the page's `own` buttons before the menu, and `in_menu` as its first entries.
pub fn view(app: App, line: View, own: View, in_menu: View) -> HtmlHeader {
    let tools = div().class("head-tools").child(own).child(menu(app, in_menu));
    header()
        .class("head")
        .child(p().class("brand").child(icons::mark()).child(span().child("Meniscus")))
        .child(h1().child(text(move || {
            app.changes.program.track();
            title(app)
        })))
        .child(line)
        .child(tools)
}

/// Button with a menu of what is needed seldom. The menu closes when the focus leaves it.
fn menu(app: App, first: View) -> HtmlDiv {
    let words = app.words();
    let open = create_signal(false);
    let mut place = div().class("head-menu-place");
    let node: Node = place.node();
    let left = move |event: FocusEvent| {
        let to = event.related_target().and_then(|to| to.dyn_into::<Node>().ok());
        if to.is_some() && !node.contains(to.as_ref()) {
            open.set(false);
        }
    };
    let escape = move |event: KeyboardEvent| {
        if event.key() == "Escape" && open.get_untracked() {
            event.prevent_default();
            open.set(false);
            browser::focus("menu");
        }
    };
    let more = button()
        .class("icon")
        .id("menu")
        .called(words.menu)
        .attr("aria-expanded", move || open.get().to_string())
        .attr("aria-controls", "head-menu")
        .when(events::click, move |_| open.update(|open| *open = !*open))
        .child(icons::more());
    let keys = labelled(icons::keyboard(), words.keys_title)
        .id("help")
        .title(format!("{} (?)", words.keys_title))
        .attr("aria-haspopup", "dialog")
        .when(events::click, move |_| {
            open.set(false);
            // The dialog returns the focus to this button: its own entry is hidden then.
            browser::focus("menu");
            keys::open();
        });
    let entries = div()
        .class("head-menu card")
        .id("head-menu")
        .role("group")
        .attr("aria-label", words.menu)
        .hidden(move || !open.get())
        .child(first)
        .child(keys)
        .child(theme(app))
        .child(languages(app))
        .maybe(untranslated(app));
    place.when(events::focusout, left).when(events::keydown, escape).child(more).child(entries)
}

/// Button of the laboratory for the list of documents, with their number.
pub fn browse(app: App) -> HtmlButton {
    let count = browser::by_id::<HtmlElement>("lab").and_then(|place| place.get_attribute("data-simulations"));
    labelled(icons::books(), app.words().library)
        .id("browse")
        .attr("aria-haspopup", "dialog")
        .maybe(count.map(|count| span().class("count").child(count)))
}

/// Button of the laboratory that opens a file.
pub fn open(app: App) -> HtmlButton {
    labelled(icons::folder(), app.words().open).id("open")
}

/// Button of the laboratory for sharing and publishing.
pub fn publish(app: App) -> HtmlButton {
    labelled(icons::link(), app.words().publish).id("share").attr("aria-haspopup", "dialog")
}

/// Switch of the laboratory: shows also what teachers and authors need; see [`crate::page::everything`].
pub fn everything(app: App) -> HtmlButton {
    labelled(icons::pile(), app.words().everything)
        .id("everything")
        .attr("aria-pressed", move || app.everything.get().to_string())
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
                // The page and the button are rebuilt.
                app.set_language(language, || browser::focus_later("menu".to_owned()));
            })
            .child(language.tag().to_ascii_uppercase())
    };
    div().class("segments").role("group").attr("aria-label", words.language).each(Language::ALL, choose)
}

/// What is not in the chosen language: a part of the interface, or the document.
fn untranslated(app: App) -> Option<HtmlP> {
    let language = app.language.get_untracked();
    let (words, share) = (app.words(), Catalogue::share(language));
    let interface = (share < 1.0).then(|| words.translated.replace('#', &fixed(100.0 * share, 0, language.style())));
    let is_left = app.read(|play| !play.program().is_in(language.tag()));
    let document = is_left.then(|| words.document_untranslated.to_owned());
    let lines: Vec<String> = interface.into_iter().chain(document).collect();
    (!lines.is_empty()).then(|| p().class("note").child(lines.join(" ")))
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
        .class("quiet with-icon")
        .id("theme")
        .when(events::click, next)
        .child(icons::theme())
        .child(span().child(text(move || label().to_owned())))
}
