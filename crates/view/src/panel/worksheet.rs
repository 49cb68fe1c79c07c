//! The worksheet: the printed form of the page. Title, text with equations, scene, plots, parameter values, and the
//! questions with space for answers. It is built when the browser is about to print and removed afterwards; the page
//! itself, with its buttons and its canvases of screen size, is not printed.

use crate::app::App;
use crate::browser;
use crate::pieces::symbols::symbol;
use crate::views::*;
use figure::{Palette, Settings};
use program::{Block, Section};
use web_sys::{Element, Event, ShadowRootInit, ShadowRootMode};

/// Size of a plot on paper, in CSS pixels: as wide as the text, so that its font size is that of the text.
const PLOT: Settings = Settings { width: 660.0, height: 240.0, font_size: 12.0, decimal_comma: false, level: None };
/// Number of ruled lines below a question.
const LINES: usize = 4;

/// Listens to the print events of the browser, as long as the page lives.
pub fn listen(app: App) {
    browser::listen("beforeprint", move |_: &Event| app.printing.set(true));
    browser::listen("afterprint", move |_: &Event| app.printing.set(false));
}

/// The worksheet, while the browser prints; empty if the document does not run, so that its errors are printed.
pub fn view(app: App) -> View {
    changing(move || {
        let prints = app.printing.get() && app.read(|_| true);
        if prints { sheet(app).into() } else { View::new() }
    })
}

fn sheet(app: App) -> HtmlArticle {
    let words = app.words();
    let language = app.language.get_untracked().tag();
    let sections: Vec<Section> = app.read(|play| play.program().sections(language).to_vec());
    let asks = |section: &&Section| section.blocks.iter().any(|block| matches!(block, Block::Question(_)));
    let first = sections.iter().position(|section| asks(&section)).unwrap_or(sections.len());
    // The text before the first heading precedes the apparatus; the rest follows it.
    let lead = sections.iter().take(first).take_while(|section| section.level == 0).count();
    let (lead, rest) = sections.split_at(lead);
    let blank = |name: &'static str| span().class("blank").child(name);
    let person = p().class("person").child(blank(words.sheet_name)).child(blank(words.sheet_date));
    article()
        .class("worksheet")
        .child(h1().child(crate::title(app)))
        .child(person)
        .each(lead, |section| passage(app, section))
        .child(apparatus(app))
        .child(plots(app))
        .each(rest, |section| passage(app, section))
        .child(p().class("sheet-foot").child(words.sheet_made))
}

fn passage(app: App, section: &Section) -> View {
    let heading: View = match (section.heading.is_empty(), section.level) {
        (true, _) => View::new(),
        (false, 0 | 1) => h2().inner_html(section.heading.clone()).into(),
        (false, _) => h3().inner_html(section.heading.clone()).into(),
    };
    let block = |block: &Block| match block {
        // The document has already made the HTML safe.
        Block::Html(html) => View::from(div().inner_html(html.clone())),
        Block::Question(index) => question(app, *index),
    };
    div().class("passage").child(heading).each(&section.blocks, block).into()
}

/// The scene beside the values of the parameters.
fn apparatus(app: App) -> HtmlDiv {
    let words = app.words();
    let parameters = app.read(|play| play.basis().parameters(play.course()));
    let row = |parameter: play::ParameterView| {
        tr().child(row_head(parameter.label).child(" ").child(symbol(&parameter.name)))
            .child(td().child(parameter.spoken))
    };
    let values = (!parameters.is_empty())
        .then(|| table().child(caption().child(words.parameters)).child(tbody().each(parameters, row)));
    div().class("sheet-apparatus").maybe(scene()).maybe(values)
}

/// Copy of the drawing on the screen.
fn scene() -> Option<HtmlDiv> {
    let drawing = crate::views::document().query_selector("#scene .drawing").ok().flatten()?;
    let svg = drawing.shadow_root()?.first_element_child()?;
    let copy = svg.clone_node_with_deep(true).ok()?;
    let mut place = div().class("drawing");
    let host: Element = place.node();
    let shadow = host.attach_shadow(&ShadowRootInit::new(ShadowRootMode::Open)).ok()?;
    shadow.append_child(&copy).ok()?;
    Some(place)
}

/// The plots that are shown, in colours for paper independent of the theme of the screen.
fn plots(app: App) -> View {
    let decimal_comma = app.language.get_untracked().style().decimal_comma;
    let settings = Settings { decimal_comma, ..PLOT };
    let shown = app.read(|play| play.plots().list());
    let shown = shown.into_iter().filter(|plot| plot.shown && plot.offered && !plot.apart);
    each(shown, |plot| {
        let svg = app.read(|play| play.plots_to_front().svg(plot.id, &settings, &Palette::LIGHT));
        tags::figure().inner_html(svg)
    })
}

/// A question with lines for the answer.
fn question(app: App, index: usize) -> View {
    let words = app.words();
    let language = app.language.get_untracked().tag();
    let asked = app.read(|play| Some(play.program().question_text(language, index).clone())).unwrap_or_default();
    let unit = app.read(|play| play.basis().question_unit(index));
    let options = super::choice::printed(asked.options);
    let lines = if options.is_some() { 0 } else { LINES };
    let supposed = app.read(|play| play.answers().setup(play.basis(), play.course(), index)).map(|(values, _)| {
        p().class("supposed").child(words.supposes).child(" ").child(crate::panel::question::supposed(values))
    });
    section()
        .class("sheet-question")
        .child(h4().child(format!("{} {}", words.question, index + 1)))
        .child(div().inner_html(asked.prompt))
        .maybe(supposed)
        .maybe(options)
        .child(div().class("lines").each(0..lines, |_| div()))
        .child(p().class("sheet-answer").child(span().class("blank").child(words.sheet_answer)).child(unit))
        .into()
}
