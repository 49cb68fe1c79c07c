//! Form of the front matter: title and texts for lists of documents, and settings of the run.

use crate::app::App;
use crate::write::fields::{Piece, Write, refuse};
use crate::write::typing;
use document::edit::set_front_matter;
use program::Method;
use view::views::*;

/// Form of the front matter.
pub fn view(app: App) -> HtmlDiv {
    let words = app.words();
    let texts = [
        ("title", words.text_title, ""),
        ("summary", words.text_summary, words.summary_example),
        ("topics", words.text_topics, words.topics_example),
        ("keywords", words.text_keywords, words.keywords_example),
    ];
    let numbers = [
        ("step", words.column_step, "0.01 [s]"),
        ("until", words.run_until, "20 [s]"),
        ("speed", words.run_speed, "1 [s]"),
        ("tolerance", words.run_tolerance, "1e-9"),
        ("vary", words.run_vary, "k, b"),
        ("main", words.run_main, "k, m"),
    ];
    let line = |(key, name, example)| line(app, key, name, example);
    let run = details()
        .class("description-run")
        .child(summary().child(words.run_settings))
        .child(chosen(
            app,
            "method",
            words.run_method,
            Method::ALL.map(|method| (method.name(), method.name())).to_vec(),
        ))
        .each(numbers, line);
    div()
        .class("form-section description")
        .role("group")
        .attr("aria-labelledby", "form-description")
        .child(h3().id("form-description").child(words.form_description))
        .each(texts, line)
        .child(chosen(app, "language", words.document_language, vec![("en", "English"), ("es", "Español")]))
        .child(run)
}

/// Present value of a key in the text; empty if it is missing.
fn value_in(app: App, key: &'static str) -> ReadSignal<String> {
    memo(move || {
        app.typed.track();
        app.written.track();
        let text = typing::text(app, 0);
        let outline = document::read(&text);
        outline.front_matter().get(key).map(|value| value.text.clone()).unwrap_or_default()
    })
}

/// Function that sets the value of a key, or removes the key if the value is empty.
fn setting(app: App, key: &'static str) -> Write {
    Box::new(move |typed| {
        let typed = typed.trim();
        let text = typing::text(app, 0);
        let value = (!typed.is_empty()).then_some(typed);
        typing::change(app, 0, &text, |outline| set_front_matter(outline, key, value)).map(|_| ())
    })
}

/// A field. Its line in the text stays while the field is empty and focused, so that the order of the keys is kept.
fn line(app: App, key: &'static str, name: &'static str, example: &'static str) -> HtmlDiv {
    let refusal = create_signal(None::<String>);
    let (write, remove) = (setting(app, key), setting(app, key));
    let piece = Piece {
        id: format!("front-{key}"),
        name: name.to_owned(),
        text: value_in(app, key),
        refusal,
        write: Box::new(move |typed| if typed.trim().is_empty() { Ok(()) } else { write(typed) }),
    };
    let leave = move |event: web_sys::FocusEvent| {
        let typed = value_of(&event);
        if typed.trim().is_empty() {
            refuse(refusal, remove(&typed).err());
        }
    };
    let field = piece.line(app).attr("placeholder", example).when(events::blur, leave);
    div()
        .class("front-line")
        .child(label().r#for(format!("front-{key}")).child(name))
        .child(field)
        .child(refusal_of(refusal))
}

/// A list of values, including the present one if it is not in the list.
fn chosen(app: App, key: &'static str, name: &'static str, values: Vec<(&'static str, &'static str)>) -> HtmlDiv {
    let refusal = create_signal(None::<String>);
    let (text, write) = (value_in(app, key), setting(app, key));
    let unset = app.words().front_unset;
    let options = move || {
        let now = text.get_clone();
        let other = (!values.iter().any(|(value, _)| *value == now)).then(|| (now.clone(), now.clone()));
        let other = other.map(|(value, name)| if value.is_empty() { (value, unset.to_owned()) } else { (value, name) });
        let known = values.iter().map(|(value, name)| ((*value).to_owned(), (*name).to_owned()));
        each(other.into_iter().chain(known), |(value, name)| {
            let is_chosen = value == now;
            option().value(value).prop("selected", is_chosen).child(name)
        })
    };
    let field = select()
        .class("cell")
        .id(format!("front-{key}"))
        .when(events::change, move |event| refuse(refusal, write(&value_of(&event)).err()))
        .child(changing(options));
    div()
        .class("front-line")
        .child(label().r#for(format!("front-{key}")).child(name))
        .child(field)
        .child(refusal_of(refusal))
}
