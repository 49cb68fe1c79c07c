//! Texts of the document beside those of a translation.

use super::{changes, typing};
use crate::app::App;
use crate::documents::visited;
use document::edit::set_translation;
use document::page::Source;
use document::translating::{LANGUAGES, Pair, TextKey, beginning, likely_language, pairs, short_texts};
use view::browser;
use view::views::*;
use wasm_bindgen::JsCast;
use web_sys::HtmlTextAreaElement;

/// The panel: texts side by side, or a form to begin a translation.
pub fn view(app: App) -> View {
    let names: Vec<String> = visited::sources(app).into_iter().map(|source| source.name).skip(1).collect();
    let begin = begin_form(app);
    if names.is_empty() {
        return View::from((note(app.words().translation_none), begin));
    }
    let chosen = create_signal(app.written_file.get_untracked().max(1).min(names.len()));
    let option = |(number, name): (usize, &String)| {
        let selected = move || chosen.get() == number;
        option().value(number.to_string()).prop("selected", selected).child(name.clone())
    };
    let choose = move |event| chosen.set(value_of(&event).parse().unwrap_or(1));
    let select = (names.len() > 1).then(|| {
        select()
            .id("translation-file")
            .attr("aria-label", app.words().writing_file)
            .when(events::change, choose)
            .each(names.iter().enumerate().map(|(place, name)| (place + 1, name)), option)
    });
    let only_missing = create_signal(false);
    let sides = move || {
        let file = chosen.get();
        sides(app, file, only_missing)
    };
    let more = details().class("fold").child(summary().child(app.words().translation_another)).child(begin);
    View::from((div().class("form-tools").maybe(select), changing(sides), more))
}

/// All texts with their translations in one file.
fn sides(app: App, file: usize, only_missing: Signal<bool>) -> View {
    let words = app.words();
    let short = memo(move || {
        app.written.track();
        short_texts(&typing::text(app, 0))
    });
    let all = memo(move || {
        app.typed.track();
        app.written.track();
        let (document, translation) = (typing::text(app, 0), typing::text(app, file));
        short.with(|short| pairs(&document::read(&document), short, &document::read(&translation)))
    });
    let missing = memo(move || all.with(|all| all.iter().filter(|pair| is_missing(pair)).count()));
    let count = move || match missing.get() {
        0 => words.translation_complete.to_owned(),
        1 => words.translation_one_missing.to_owned(),
        number => format!("{number} {}", words.translation_missing),
    };
    let ticked = tick("only-missing".to_owned(), only_missing.get_untracked(), move |on| only_missing.set(on));
    // Rows stay while they are being typed, even if they are no longer missing.
    let keys = memo(move || {
        let only = only_missing.get();
        let keys = |all: &Vec<Pair>| -> Vec<(TextKey, String)> {
            let shown = all.iter().filter(|pair| !only || is_missing(pair));
            shown.map(|pair| (pair.key.clone(), pair.original.clone())).collect()
        };
        if only { all.with_untracked(keys) } else { all.with(keys) }
    });
    let list = move || {
        let rows = keys.get_clone().into_iter().enumerate();
        ol().class("sides").each(rows, |(number, (key, original))| row(app, file, all, number, key, original))
    };
    View::from((
        div()
            .class("sides-head")
            .child(p().class("sides-count").role("status").child(text(count)))
            .child(switch(ticked, words.translation_only_missing)),
        changing(list),
    ))
}

fn is_missing(pair: &Pair) -> bool {
    pair.is_needed && pair.translation.is_empty()
}

fn row(app: App, file: usize, all: ReadSignal<Vec<Pair>>, number: usize, key: TextKey, original: String) -> HtmlLi {
    let refusal = create_signal(None::<String>);
    let (own, id) = (key.clone(), id_of(number));
    let pair = memo(move || all.with(|all| all.iter().find(|pair| pair.key == own).cloned()));
    let missing = move || pair.with(|pair| pair.as_ref().is_some_and(is_missing));
    let is_long = original.contains('\n') || original.chars().count() > 60 || matches!(key, TextKey::Prose(..));
    let is_label = matches!(key, TextKey::Short(_));
    let mut field = textarea().class("cell prose-cell").id(id.clone());
    let node: HtmlTextAreaElement = field.node();
    effect(move || {
        let text = pair.with(|pair| pair.as_ref().map(|pair| pair.translation.clone()).unwrap_or_default());
        if node.value().trim() != text.trim() {
            node.set_value(&text);
        }
    });
    let title = title(app, &key);
    let write = move |event: web_sys::Event| {
        let typed =
            event.target().map(|field| field.unchecked_into::<HtmlTextAreaElement>().value()).unwrap_or_default();
        let text = typing::text(app, file);
        refusal.set(typing::change(app, file, &text, |outline| set_translation(outline, &key, &typed)).err());
    };
    let field = field
        .attr("rows", if is_long { "3" } else { "1" })
        .attr("aria-describedby", format!("{id}-original"))
        .attr("aria-invalid", move || refusal.with(Option::is_some).then_some("true"))
        .when(events::input, write);
    let mark = move || {
        if missing() { View::from(span().class("missing").child(app.words().translation_mark)) } else { View::new() }
    };
    let kind = if is_label && !is_long { " short-side" } else { "" };
    li().class(move || format!("side{kind}{}", if missing() { " missing-side" } else { "" }))
        .child(label().r#for(id.clone()).class("side-title").child(title))
        .child(changing(mark))
        .child(p().class("original").id(format!("{id}-original")).child(original))
        .child(field)
        .child(refusal_of(refusal))
}

/// Description of a text in a word.
fn title(app: App, key: &TextKey) -> String {
    let words = app.words();
    let question = |number: &usize, part: &str| format!("{} {}: {part}", words.question, number + 1);
    match key {
        TextKey::Front("title") => words.text_title.to_owned(),
        TextKey::Front("summary") => words.text_summary.to_owned(),
        TextKey::Front("topics") => words.text_topics.to_owned(),
        TextKey::Front(_) => words.text_keywords.to_owned(),
        TextKey::Short(_) => words.column_label.to_owned(),
        TextKey::Prose(..) => words.text_prose.to_owned(),
        TextKey::Prompt(number) => question(number, words.question_prompt),
        TextKey::Hint(number) => question(number, words.hint),
        TextKey::Explanation(number) => question(number, words.question_explanation),
    }
}

/// Form for a new translation: its language, and a button.
fn begin_form(app: App) -> HtmlDiv {
    let words = app.words();
    let matter = document::read(&typing::text(app, 0)).front_matter().clone();
    let language = create_signal(likely_language(&matter));
    let option = |(tag, name): (&'static str, &'static str)| {
        option().value(tag).prop("selected", move || language.get() == tag).child(name)
    };
    let choose = move |event| {
        let chosen = value_of(&event);
        if let Some((tag, _)) = LANGUAGES.iter().find(|(tag, _)| *tag == chosen) {
            language.set(tag);
        }
    };
    let select = select().id("translation-language").when(events::change, choose).each(LANGUAGES, option);
    let begin = button()
        .class("quiet outlined")
        .when(events::click, move |_| begin(app, language.get_untracked()))
        .child(words.translation_begin);
    div()
        .class("form-tools")
        .child(label().r#for("translation-language").child(words.language))
        .child(select)
        .child(begin)
}

/// Adds the file of a translation to the document.
fn begin(app: App, language: &str) {
    super::flush(app);
    let sources = visited::files(app);
    let Some(base) = sources.first() else { return };
    let matter = document::read(&base.text).front_matter().clone();
    let stem = base.name.strip_suffix(".md").unwrap_or(&base.name);
    let (name, text) = (format!("{stem}.{language}.md"), beginning(&base.name, &matter, language));
    if sources.iter().any(|source| source.name == name) {
        return app.complain(app.words().translation_exists.to_owned());
    }
    changes::add(app, Source { name, text });
    // The button was removed with the other views.
    browser::focus_later(id_of(0));
}

/// Id of the field of a text.
fn id_of(number: usize) -> String {
    format!("translation-{number}")
}
