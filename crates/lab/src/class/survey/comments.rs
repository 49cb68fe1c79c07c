//! Comments on an item, one after another: marked and released by the teacher.

use super::words;
use crate::app::App;
use class::survey::Mark;
use view::views::*;
use web_sys::KeyboardEvent;

/// The comment that is shown with its buttons, the share of positive ones, and the list of those released.
pub fn view(app: App, item: (usize, usize)) -> View {
    let words = words::of(app);
    let room = app.survey;
    let by_key = move |event: KeyboardEvent| {
        match event.key().as_str() {
            "ArrowRight" => room.turn(item, 1),
            "ArrowLeft" => room.turn(item, -1),
            key => match Mark::of_key(key) {
                Some(mark) => {
                    room.mark(item, mark);
                    room.turn(item, 1);
                }
                None => return,
            },
        }
        event.prevent_default();
    };
    let shown = memo(move || {
        let comments = room.comments(item);
        let place = (comments.shown + 1, comments.marked.all().len());
        (place, comments.marked.all().get(comments.shown).cloned())
    });
    let place = move || shown.with(|((place, count), _)| format!("{place}/{count}"));
    let written = move || shown.with(|(_, comment)| comment.as_ref().map(|one| one.text.clone()).unwrap_or_default());
    let is_released = move || shown.with(|(_, comment)| comment.as_ref().is_some_and(|one| one.released));
    let mark = |sign: &'static str, name: &'static str, mark: Mark| {
        let pressed =
            move || shown.with(|(_, comment)| comment.as_ref().and_then(|one| one.mark) == Some(mark)).to_string();
        button()
            .class("quiet")
            .attr("aria-pressed", pressed)
            .when(events::click, move |_| room.mark(item, mark))
            .child(format!("{sign} {name}"))
    };
    let turn = |sign: &'static str, name: &'static str, by: isize| {
        button().class("quiet").when(events::click, move |_| room.turn(item, by)).child(format!("{sign} {name}"))
    };
    let tick = input()
        .r#type("checkbox")
        .prop("checked", is_released)
        .when(events::change, move |event| room.release(item, is_checked(&event)));
    let positive = move || {
        let share = room.comments(item).marked.positive();
        share
            .map(|share| format!("{}: {}", words.positive, share.text(app.language.get_untracked())))
            .unwrap_or_default()
    };
    let released = move || {
        let comments = room.comments(item);
        let released: Vec<String> =
            comments.marked.all().iter().filter(|one| one.released).map(|one| one.text.clone()).collect();
        if released.is_empty() {
            return View::new();
        }
        let list = ul().class("comments").each(released, |text| li().dir("auto").child(text));
        View::from((h4().child(words.released), list))
    };
    let tools = div()
        .class("ways")
        .child(turn("←", words.previous, -1))
        .child(span().role("status").child(text(place)))
        .child(turn("→", words.next, 1))
        .child(mark("+", words.positive_mark, Mark::Positive))
        .child(mark("0", words.neutral_mark, Mark::Neutral))
        .child(mark("−", words.negative_mark, Mark::Negative))
        .child(switch(tick, words.release));
    div()
        .class("survey-comments")
        .role("group")
        .attr("aria-label", words.comments)
        .attr("tabindex", "0")
        .when(events::keydown, by_key)
        .child(p().class("survey-comment").dir("auto").attr("aria-live", "polite").child(text(written)))
        .child(tools)
        .child(note(words.comments_keys))
        .child(note(text(positive)))
        .child(changing(released))
        .into()
}
