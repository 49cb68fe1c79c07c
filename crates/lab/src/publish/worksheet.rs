//! Choice of the parts of the worksheet, and its solutions.

use super::sheet::Sheet;
use super::words;
use crate::app::App;
use view::views::*;

/// Parts of the worksheet that can be left out: names in the attribute `data-sheet-without` of the page.
const PARTS: [&str; 6] = ["theory", "scene", "values", "plots", "questions", "lines"];

/// Section of the dialog: the parts, and a button that prints.
pub fn view(app: App) -> View {
    let words = words::of(app);
    let names = [
        words.sheet_theory,
        words.part_scene,
        words.sheet_values,
        words.part_plots,
        words.part_activities,
        words.sheet_lines,
    ];
    let Sheet { left_out, solves } = app.sheet;
    let part = |(part, name): (&'static str, &'static str)| {
        let include = move |on: bool| {
            left_out.update(|left_out| {
                left_out.retain(|other| *other != part);
                if !on {
                    left_out.push(part);
                }
            });
        };
        let is_included = left_out.with_untracked(|left_out| !left_out.contains(&part));
        switch(tick(format!("sheet-{part}"), is_included, include), name)
    };
    let solutions = tick("sheet-solutions".to_owned(), solves.get_untracked(), move |on| solves.set(on));
    let print = button().class("action").id("print").child(words.sheet_print).when(events::click, move |_| {
        let _ = window().print();
    });
    let parts =
        fieldset().class("ticks").child(legend().child(words.sheet_parts)).each(PARTS.into_iter().zip(names), part);
    let parts = parts.child(switch(solutions, words.sheet_solutions));
    View::from((note(words.sheet_intro), parts, div().class("ways").child(print)))
}

/// Leaves out the parts by the style sheet, and adds the solutions while the browser prints.
pub fn solutions(app: App) -> View {
    let Sheet { left_out, solves } = app.sheet;
    effect(move || {
        if let Some(root) = document().document_element() {
            let _ = root.set_attribute("data-sheet-without", &left_out.with(|left_out| left_out.join(" ")));
        }
    });
    changing(move || {
        let count = app.read(|play| play.program().questions.len());
        let prints = app.printing.get() && solves.get() && count > 0;
        if prints { answers(app, count).into() } else { View::new() }
    })
}

fn answers(app: App, count: usize) -> HtmlArticle {
    let language = app.language.get_untracked().tag();
    let answer = |index: usize| {
        let right = app.read(|play| play.answers().right_text(play.basis(), play.course(), index));
        let text = app.read(|play| Some(play.program().question_text(language, index).clone())).unwrap_or_default();
        let words = app.words();
        section()
            .child(h4().child(format!("{} {}", words.question, index + 1)))
            .child(p().child(words.right_answer).child(": ").child(strong().child(right)))
            .maybe(text.explanation.map(|explanation| div().inner_html(explanation)))
    };
    article().class("worksheet solutions").child(h2().child(words::of(app).sheet_solutions)).each(0..count, answer)
}
