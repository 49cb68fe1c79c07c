//! The notebook below the apparatus: the document's prose in tabs, its equations, the recorded data, its source.

use crate::app::App;
use crate::{browser, data, diagnostics, measurements, question};
use document::{Block, Section};
use leptos::prelude::*;
use web_sys::KeyboardEvent;

/// A tab: its title and what it holds, which is built when it is first looked at.
struct Tab {
    title: String,
    content: Box<dyn Fn() -> AnyView + Send>,
}

impl Tab {
    fn new(title: &str, content: impl Fn() -> AnyView + Send + 'static) -> Self {
        Self { title: title.to_owned(), content: Box::new(content) }
    }
}

/// The notebook.
pub fn view(app: App) -> impl IntoView {
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
    let mut buttons = Vec::new();
    let mut panels = Vec::new();
    for (number, tab) in tabs.into_iter().enumerate() {
        let selected = move || app.tab.get() == number;
        buttons.push(view! {
            <button type="button" role="tab" id=format!("tab-{number}") aria-controls=format!("panel-{number}")
                aria-selected=move || selected().to_string() tabindex=move || if selected() { "0" } else { "-1" }
                on:click=move |_| app.tab.set(number)
                on:keydown=move |event| turn(app, count, &event)>{tab.title}</button>
        });
        let seen = Memo::new(move |before: Option<&bool>| before == Some(&true) || selected());
        let content = tab.content;
        let content = move || if seen.get() { untrack(&content) } else { ().into_any() };
        panels.push(view! {
            <div role="tabpanel" id=format!("panel-{number}") aria-labelledby=format!("tab-{number}") tabindex="0" hidden=move || !selected()>
                {content}
            </div>
        });
    }
    view! {
        <section class="notebook" id="notebook" aria-labelledby="notebook-title">
            <h2 id="notebook-title" class="visually-hidden">{words.notebook}</h2>
            <div class="tabs" role="tablist" aria-label=words.notebook>{buttons}</div>
            {panels}
        </section>
    }
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
    let sections: Vec<Section> = app.read(|session| session.document().sections(language).to_vec());
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
                let parts = members.iter().map(|section| self::section(app, section, top)).collect_view();
                view! { <div class="reading">{contents}<div class="prose" lang=language>{parts}</div></div> }.into_any()
            })
        })
        .collect()
}

/// The way to the sections of a long text.
fn contents(app: App, sections: &[Section], top: u8) -> AnyView {
    let listed: Vec<&Section> =
        sections.iter().filter(|section| section.level == top && !section.title.is_empty()).collect();
    if listed.len() < 3 {
        return ().into_any();
    }
    let links = listed
        .into_iter()
        .map(|section| view! { <li><a href=format!("#{}", section.id)>{section.title.clone()}</a></li> })
        .collect_view();
    view! { <nav class="contents" aria-label=app.words().contents><ol>{links}</ol></nav> }.into_any()
}

fn section(app: App, section: &Section, top: u8) -> impl IntoView + use<> {
    let (id, heading) = (section.id.clone(), section.heading.clone());
    let heading = if heading.is_empty() {
        ().into_any()
    } else if section.level <= top {
        view! { <h3 id=id inner_html=heading></h3> }.into_any()
    } else if section.level == top + 1 {
        view! { <h4 id=id inner_html=heading></h4> }.into_any()
    } else {
        view! { <h5 id=id inner_html=heading></h5> }.into_any()
    };
    let blocks = section
        .blocks
        .iter()
        .map(|block| match block {
            // The document has made it safe.
            Block::Html(html) => view! { <div inner_html=html.clone()></div> }.into_any(),
            Block::Question(index) => question::view(app, *index),
        })
        .collect_view();
    view! { {heading} {blocks} }
}

/// The model, typeset from its own syntax.
fn equations(app: App) -> AnyView {
    let words = app.words();
    let lines = app
        .read(|session| session.model().typeset(&|text| session.text(text).to_owned()))
        .into_iter()
        .map(|math| view! { <li inner_html=math></li> })
        .collect_view();
    view! {
        <div class="model">
            <p class="note">{words.equations_intro}</p>
            <div class="equations" role="region" tabindex="0" aria-label=words.equations><ol>{lines}</ol></div>
        </div>
    }
    .into_any()
}

/// The text of the document.
fn source(app: App) -> AnyView {
    let words = app.words();
    let sources = app.with(|lab| lab.sources.clone()).unwrap_or_default();
    let files = sources
        .into_iter()
        .map(|file| {
            let (name, text, copied) = (file.name.clone(), file.text.clone(), file.text.clone());
            view! {
                <div class="file">
                    <div class="block-head">
                        <h3>{file.name.clone()}</h3>
                        <div class="actions">
                            <button type="button" class="quiet" aria-label=format!("{}: {}", words.copy, file.name) on:click=move |_| copy(app, &copied)>{words.copy}</button>
                            <button type="button" class="quiet" aria-label=format!("{}: {}", words.save_source, file.name)
                                on:click=move |_| browser::save_text(&name, "text/markdown", &text)>{words.save_source}</button>
                        </div>
                    </div>
                    <pre tabindex="0" aria-label=file.name><code>{file.text}</code></pre>
                </div>
            }
        })
        .collect_view();
    view! {
        <div class="source">
            <p class="note">{words.source_intro}</p>
            {diagnostics::remarks(app)}
            {files}
        </div>
    }
    .into_any()
}

/// Copies a text and says whether that worked.
pub fn copy(app: App, text: &str) {
    let words = app.words();
    browser::copy(text, move |allowed| app.say(if allowed { words.copied } else { words.not_copied }.to_owned()));
}
