//! The notebook below the apparatus: the document's prose in tabs, its equations, the recorded data, its source.

use crate::app::App;
use crate::views::*;
use crate::{browser, data, diagnostics, measurements, question};
use document::page::Source;
use program::{Block, Section};
use sycamore_reactive::untrack;
use web_sys::KeyboardEvent;

/// A tab: its title and what it holds, which is built when it is first looked at.
struct Tab {
    title: String,
    content: Box<dyn Fn() -> View>,
}

impl Tab {
    fn new<V: Into<View>>(title: &str, content: impl Fn() -> V + 'static) -> Self {
        Self { title: title.to_owned(), content: Box::new(move || content().into()) }
    }
}

/// The notebook.
pub fn view(app: App) -> View {
    let words = app.words();
    let mut tabs = prose(app);
    tabs.push(Tab::new(words.equations, move || equations(app)));
    let number = tabs.len();
    tabs.push(Tab::new(words.data, move || data::view(app, number)));
    app.measurements_tab.set(tabs.len());
    tabs.push(Tab::new(words.measurements, move || measurements::view(app)));
    tabs.push(Tab::new(words.source, move || source(app)));
    let count = tabs.len();
    if app.tab.get_untracked() >= count {
        app.tab.set(0);
    }
    let mut buttons = div().class("tabs").role("tablist").attr("aria-label", words.notebook);
    let mut panels: Vec<View> = Vec::new();
    for (number, tab) in tabs.into_iter().enumerate() {
        let selected = move || app.tab.get() == number;
        buttons = buttons.child(
            button()
                .role("tab")
                .id(format!("tab-{number}"))
                .attr("aria-controls", format!("panel-{number}"))
                .attr("aria-selected", move || selected().to_string())
                .tabindex(move || if selected() { "0" } else { "-1" })
                .when(events::click, move |_| app.tab.set(number))
                .when(events::keydown, move |event| turn(app, count, &event))
                .child(tab.title),
        );
        let mut seen = false;
        let seen = memo(move || {
            seen = seen || selected();
            seen
        });
        let content = tab.content;
        let content = move || if seen.get() { untrack(&content) } else { View::new() };
        panels.push(
            div()
                .role("tabpanel")
                .id(format!("panel-{number}"))
                .attr("aria-labelledby", format!("tab-{number}"))
                .tabindex("0")
                .hidden(move || !selected())
                .child(changing(content))
                .into(),
        );
    }
    part("notebook", "notebook", words.notebook).child(buttons).child(panels).into()
}

/// Arrow keys go from tab to tab, around the ends.
fn turn(app: App, count: usize, event: &KeyboardEvent) {
    let now = app.tab.get_untracked();
    let next = match event.key().as_str() {
        "ArrowRight" => (now + 1) % count,
        "ArrowLeft" => (now + count - 1) % count,
        "Home" => 0,
        "End" => count - 1,
        _ => return,
    };
    event.prevent_default();
    app.tab.set(next);
    browser::focus(&format!("tab-{next}"));
}

/// The prose. What is read stands together in one tab, each section that asks questions in one of its own.
fn prose(app: App) -> Vec<Tab> {
    let language = app.language.get_untracked().tag();
    let sections: Vec<Section> = app.read(|session| session.document().program.sections(language).to_vec());
    let top = sections.iter().map(|section| section.level).filter(|&level| level > 0).min().unwrap_or(1);
    let mut chapters: Vec<Vec<Section>> = Vec::new();
    for section in sections {
        match chapters.last_mut() {
            Some(chapter) if section.level > top => chapter.push(section),
            _ if section.level == 0 && section.blocks.is_empty() => {}
            _ => chapters.push(vec![section]),
        }
    }
    let mut tabs: Vec<(String, bool, Vec<Section>)> = Vec::new();
    for chapter in chapters {
        let asks = chapter.iter().flat_map(|section| &section.blocks).any(|block| matches!(block, Block::Question(_)));
        match tabs.last_mut() {
            Some((_, false, members)) if !asks => members.extend(chapter),
            _ => {
                let title =
                    chapter.first().map(|section| section.title.clone()).filter(|title| asks && !title.is_empty());
                tabs.push((title.unwrap_or_else(|| app.words().introduction.to_owned()), asks, chapter));
            }
        }
    }
    tabs.into_iter()
        .map(|(title, _, members)| {
            Tab::new(&title, move || {
                let contents = contents(app, &members, top);
                let prose = div().class("prose").lang(language);
                let prose = prose.each(&members, |section| passage(app, section, top));
                div().class("reading").child(contents).child(prose)
            })
        })
        .collect()
}

/// The way to the sections of a long text.
fn contents(app: App, sections: &[Section], top: u8) -> View {
    let listed: Vec<&Section> =
        sections.iter().filter(|section| section.level == top && !section.title.is_empty()).collect();
    if listed.len() < 3 {
        return View::new();
    }
    let link = |section: &Section| li().child(a().href(format!("#{}", section.id)).child(section.title.clone()));
    nav().class("contents").attr("aria-label", app.words().contents).child(ol().each(listed, link)).into()
}

fn passage(app: App, section: &Section, top: u8) -> View {
    let (id, heading) = (section.id.clone(), section.heading.clone());
    let heading = if heading.is_empty() {
        View::new()
    } else if section.level <= top {
        h3().id(id).inner_html(heading).into()
    } else if section.level == top + 1 {
        h4().id(id).inner_html(heading).into()
    } else {
        h5().id(id).inner_html(heading).into()
    };
    let block = |block: &Block| match block {
        // The document has made it safe.
        Block::Html(html) => div().inner_html(html.clone()).into(),
        Block::Question(index) => question::view(app, *index),
    };
    View::from((heading, each(&section.blocks, block)))
}

/// The model, typeset from its own syntax.
fn equations(app: App) -> HtmlDiv {
    let words = app.words();
    let language = app.language.get_untracked().tag();
    let lines = app.read(|session| session.document().program.edition(language).equations.clone());
    let list = ol().each(lines, |math| li().inner_html(math));
    let equations =
        div().class("equations").role("region").tabindex("0").attr("aria-label", words.equations).child(list);
    div().class("model").child(note(words.equations_intro)).child(equations)
}

/// The text of the document.
fn source(app: App) -> HtmlDiv {
    let words = app.words();
    let sources = app.with(|lab| lab.sources.clone()).unwrap_or_default();
    let file = |file: Source| {
        let (name, text, copied) = (file.name.clone(), file.text.clone(), file.text.clone());
        let copy = button()
            .class("quiet")
            .attr("aria-label", format!("{}: {}", words.copy, file.name))
            .when(events::click, move |_| copy(app, &copied))
            .child(words.copy);
        let save = button()
            .class("quiet")
            .attr("aria-label", format!("{}: {}", words.save_source, file.name))
            .when(events::click, move |_| browser::save_text(&name, "text/markdown", &text))
            .child(words.save_source);
        let actions = div().class("actions").child(copy).child(save);
        div()
            .class("file")
            .child(div().class("block-head").child(h3().child(file.name.clone())).child(actions))
            .child(pre().tabindex("0").attr("aria-label", file.name).child(code().child(file.text)))
    };
    div().class("source").child(note(words.source_intro)).child(diagnostics::remarks(app)).each(sources, file)
}

/// Copies a text and says whether that worked.
pub fn copy(app: App, text: &str) {
    let words = app.words();
    browser::copy(
        text,
        move |allowed| {
            if allowed { app.notify(words.copied) } else { app.complain(words.not_copied.to_owned()) }
        },
    );
}
