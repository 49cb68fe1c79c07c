//! Radius of a body: found around the click, or typed.

use crate::app::App;
use crate::film::aim::Kind;
use crate::film::{tracking, words};
use desk::Subject;
use units::number::plain;
use units::number::typed::counted;
use view::browser;
use view::views::*;

/// Radius of the chosen body; empty before the body was clicked.
pub fn view(app: App) -> View {
    let films = app.films;
    let clicked = memo(move || {
        let (kind, body) = (films.kind.get(), films.body.get());
        let count = films.now.with(|now| match now.as_ref().map(|now| &now.subject) {
            Some(Subject::Bodies(bodies)) => bodies.len(),
            _ => 0,
        });
        (kind == Kind::Body && body < count).then_some(body)
    });
    changing(move || clicked.get().map_or_else(View::new, |body| field(app, body)))
}

/// Field in px, the radius as a length, and a button that restores the radius found around the click.
fn field(app: App, body: usize) -> View {
    let words = words::of(app);
    let style = app.language.get_untracked().style();
    let refused = create_signal(None);
    let outline =
        memo(move || app.films.now.with(|now| now.as_ref().and_then(|now| now.outlines.get(body).copied().flatten())));
    let shown = memo(move || outline.get().map(|outline| plain(outline.radius, 4, style)).unwrap_or_default());
    let set = move |radius: Option<f64>| {
        let refusal = app.attempt_on_desk(|desk| desk.work_on_film(|films, play| films.set_radius(play, body, radius)));
        let is_taken = refusal.is_none();
        refused.set(refusal);
        if is_taken {
            tracking::begin(app);
        }
    };
    let take = move |event| {
        let typed = value_of(&event);
        let read = if typed.trim().is_empty() { Ok(None) } else { counted(&typed, "px", style).map(Some) };
        match read {
            Ok(radius) => set(radius),
            Err(why) => refused.set(Some(why.words().text(app.language.get_untracked()).into_owned())),
        }
    };
    let find = move |_| {
        set(None);
        browser::focus("film-radius");
    };
    let said = move || {
        let Some(outline) = outline.get() else { return String::new() };
        let length = outline.metres.map(|metres| format!("= {} m", plain(metres, 3, style)));
        let found = (!outline.is_set).then(|| words.radius_found.to_owned());
        length.into_iter().chain(found).collect::<Vec<_>>().join(" · ")
    };
    let field = short_field("film-radius".to_owned())
        .attr("inputmode", "decimal")
        .enterkeyhint("done")
        .attr("aria-invalid", move || refused.with(Option::is_some).then_some("true"))
        .attr("aria-describedby", "film-radius-said film-radius-note film-radius-refused")
        .prop("value", shown)
        .when(events::change, take);
    let find = button()
        .class("quiet")
        .id("film-radius-find")
        .hidden(move || outline.get().is_none_or(|outline| !outline.is_set))
        .when(events::click, find)
        .child(words.find_radius);
    let line = div()
        .class("step-line")
        .child(field_of("film-radius", words.radius).child(with_unit(field, "px")))
        .child(span().id("film-radius-said").role("status").child(text(said)))
        .child(find);
    View::from((line, refusal_of(refused).id("film-radius-refused"), note(words.radius_note).id("film-radius-note")))
}
