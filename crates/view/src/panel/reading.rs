//! Text of the document with its questions, and the equations.

use crate::app::App;
use crate::views::*;
use crate::{browser, page::everything, panel::question, panel::survey};
use program::{Block, Section};

/// Sections of the document in the language of the page, and the level of their top headings.
fn sections(app: App) -> (Vec<Section>, u8) {
    let language = app.language.get_untracked().tag();
    let mut sections: Vec<Section> = app.read(|play| play.program().sections(language).to_vec());
    let top = sections.iter().map(|section| section.level).filter(|&level| level > 0).min().unwrap_or(1);
    sections.retain(|section| section.level > 0 || !section.blocks.is_empty());
    (sections, top)
}

/// True if the document contains questions or a survey.
pub fn asks(app: App) -> bool {
    survey::asks(app) || sections(app).0.iter().any(section_asks)
}

fn section_asks(section: &Section) -> bool {
    section.blocks.iter().any(|block| matches!(block, Block::Question(_)))
}

/// Sections of the chapters with questions (`asking`) or without, and the level of the top headings. A section below
/// another one belongs to its chapter.
fn chapters(app: App, asking: bool) -> (Vec<Section>, u8) {
    let (sections, top) = sections(app);
    let mut chapters: Vec<Vec<Section>> = Vec::new();
    for section in sections {
        match chapters.last_mut() {
            Some(chapter) if section.level > top => chapter.push(section),
            _ => chapters.push(vec![section]),
        }
    }
    chapters.retain(|chapter| chapter.iter().any(section_asks) == asking);
    (chapters.into_iter().flatten().collect(), top)
}

/// Content of the tab of questions.
pub fn questions(app: App) -> HtmlDiv {
    let (sections, top) = chapters(app, true);
    prose(app, &sections, top).child(survey::view(app))
}

/// Content of the tab of prose and equations; with everything shown, also `besides`.
pub fn theory(app: App, besides: Box<dyn Fn() -> View>) -> HtmlDiv {
    let (sections, top) = chapters(app, false);
    div()
        .class("theory")
        .child(contents(app, &sections, top))
        .child(prose(app, &sections, top))
        .child(equations(app))
        .child(everything::only(app, besides))
}

fn prose(app: App, sections: &[Section], top: u8) -> HtmlDiv {
    // That of the document where it is not translated.
    let language = app.read(|play| play.program().edition(play.basis().language().tag()).language.clone());
    div().class("prose").lang(language).each(sections, |section| passage(app, section, top))
}

/// Table of contents of a long text.
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
        // The document has already made the HTML safe.
        Block::Html(html) => div().inner_html(html.clone()).into(),
        Block::Question(index) => question::view(app, *index),
    };
    View::from((heading, each(&section.blocks, block)))
}

/// Equations of the model, typeset from its syntax.
fn equations(app: App) -> HtmlDiv {
    let words = app.words();
    let language = app.language.get_untracked().tag();
    let lines = app.read(|play| play.program().edition(language).equations.clone());
    let list = ol().each(lines, |math| li().inner_html(math));
    let equations =
        div().class("equations").role("region").tabindex("0").attr("aria-label", words.equations).child(list);
    let heading = h3().id("equations").child(words.equations);
    div().class("model").child(heading).child(note(words.equations_intro)).child(equations)
}

/// Copies a text and reports success or failure.
pub fn copy(app: App, text: &str) {
    let words = app.words();
    browser::copy(
        text,
        move |allowed| {
            if allowed { app.notify(words.copied) } else { app.complain(words.not_copied.to_owned()) }
        },
    );
}
