//! Third step: scale and origin.

use super::tool::{fold, tool_button};
use crate::app::App;
use crate::film::aim::Tool;
use crate::film::state::Now;
use crate::film::{calibrating, words};
use desk::{Lacking, ParallaxForm};
use view::views::*;

/// Ruler, and the less common settings.
pub fn view(app: App) -> View {
    let words = words::of(app);
    let take = move |field: Signal<String>, typed: String, apply: fn(App)| {
        field.set(typed);
        apply(app);
    };
    let films = app.films;
    let length = short_field("film-length".to_owned())
        .enterkeyhint("done")
        .attr("aria-invalid", move || films.lengths_refused.with(Option::is_some).then_some("true"))
        .attr("placeholder", "10 cm")
        .attr("aria-describedby", "film-lengths-refused")
        .prop("value", move || films.length.get_clone())
        .when(events::change, move |event| take(films.length, value_of(&event), calibrating::ruler));
    let intervals = number_field("film-intervals", films.intervals_refused)
        .attr("inputmode", "numeric")
        .prop("value", move || films.intervals.get_clone())
        .when(events::change, move |event| {
            films.intervals.set(value_of(&event));
            if calibrating::intervals(app).is_some() {
                calibrating::ruler(app);
            }
        });
    let pixels = button()
        .class("quiet")
        .id("film-pixels")
        .hidden(move || films.ruler.with(Vec::is_empty) && films.corners.with(Vec::is_empty))
        .when(events::click, move |_| calibrating::none(app))
        .child(words.in_pixels);
    let tools = div()
        .class("chips")
        .child(tool_button(app, "film-ruler", Tool::Ruler, words.click_ruler))
        .child(tool_button(app, "film-set-origin", Tool::Origin, words.set_origin))
        .child(tool_button(app, "film-set-axis", Tool::Axis, words.set_axis));
    let fields = div()
        .class("fields")
        .child(field_of("film-length", words.length).child(length))
        .child(field_of("film-intervals", words.intervals).child(intervals));
    let ruler = move || app.films.now.with(|now| now.as_ref().and_then(|now| now.ruler.clone()));
    let ruler = changing(move || match ruler() {
        Some(length) => View::from(note(format!("{} {length}.", words.ruler_is))),
        None => View::new(),
    });
    let lacks_origin = memo(move || {
        let lacking = |now: &Now| now.form.lacking(&now.subject) == Some(Lacking::Origin);
        films.now.with(|now| now.as_deref().is_some_and(lacking))
    });
    View::from((
        note(words.hint_ruler),
        ruler,
        tools,
        fields,
        why_refused("film-intervals", films.intervals_refused),
        refusal_of(films.lengths_refused).id("film-lengths-refused"),
        changing(move || {
            if lacks_origin.get() { note(words.lacks_origin).id("film-lacks-origin").into() } else { View::new() }
        }),
        fold(words.more_lengths).child(rectangle(app)).child(parallax(app)),
        pixels,
    ))
}

/// Rectangle in the plane of the motion.
fn rectangle(app: App) -> View {
    let words = words::of(app);
    let side = move |number: usize, id: &'static str, name: &'static str| {
        let now = move || app.films.sides.with(|sides| sides.get(number).cloned().unwrap_or_default());
        let take = move |event| {
            let typed = value_of(&event);
            app.films.sides.update(|sides| sides.get_mut(number).into_iter().for_each(|side| *side = typed.clone()));
            calibrating::rectangle(app);
        };
        let field = short_field(id.to_owned())
            .attr("placeholder", "20 cm")
            .attr("aria-describedby", "film-lengths-refused")
            .prop("value", now)
            .when(events::change, take);
        field_of(id, name).child(field)
    };
    View::from((
        div().class("chips").child(tool_button(app, "film-corners", Tool::Corners, words.rectangle)),
        div().class("step-line").child(side(0, "film-width", words.width)).child(side(1, "film-height", words.height)),
    ))
}

/// Ruler outside the plane of the motion.
fn parallax(app: App) -> View {
    let words = words::of(app);
    let behind = create_signal(String::new());
    let distance = create_signal(String::new());
    effect(move || {
        let form = app.films.now.with(|now| now.as_ref().and_then(|now| now.form.parallax.clone())).unwrap_or_default();
        behind.set(form.behind);
        distance.set(form.distance);
    });
    let apply = move || {
        let form = ParallaxForm { behind: behind.get_clone_untracked(), distance: distance.get_clone_untracked() };
        let none = form.behind.trim().is_empty();
        if none || !form.distance.trim().is_empty() {
            calibrating::change(app, move |all| all.parallax = (!none).then_some(form));
        }
    };
    let field = move |id: &'static str, name: &'static str, now: Signal<String>, example: &'static str| {
        let take = move |event| {
            now.set(value_of(&event));
            apply();
        };
        let field = short_field(id.to_owned()).attr("aria-describedby", "film-lengths-refused");
        let field =
            field.attr("placeholder", example).prop("value", move || now.get_clone()).when(events::change, take);
        field_of(id, name).child(field)
    };
    View::from((
        note(words.parallax_note),
        div().class("step-line").child(field("film-behind", words.behind, behind, "1 cm")).child(field(
            "film-distance",
            words.distance,
            distance,
            "80 cm",
        )),
    ))
}
