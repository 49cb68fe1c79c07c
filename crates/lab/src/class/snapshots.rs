//! Work collected for the wall, in the order in which it is shown.

use super::{wall, words};
use crate::app::App;
use class::collection::Snapshot;
use view::pieces::icons;
use view::views::*;

/// The section: the list, and the button that shows it.
pub fn view(app: App) -> View {
    let words = words::of(app);
    changing(move || {
        let snapshots = app.class.snapshots();
        if snapshots.list().is_empty() {
            return note(words.snapshots_none).into();
        }
        let named = snapshots.list().iter().copied().zip(snapshots.letters()).enumerate();
        let list =
            ol().class("collected").each(named, |(place, (snapshot, letter))| row(app, place, snapshot, &letter));
        let show = button().class("primary").id("class-wall").when(events::click, move |_| wall::show(app));
        View::from((list, div().class("ways").child(show.child(words.wall_show))))
    })
}

fn row(app: App, place: usize, snapshot: Snapshot, letter: &str) -> HtmlLi {
    let words = words::of(app);
    let (sender, what) = app.class.read_once(|collection| {
        let what = match snapshot {
            Snapshot::Curve(member) => collection.curve(member).map(|curve| curve.quantity.name.clone()),
            Snapshot::Answer { hand_in, answer } => {
                collection.answer(hand_in, answer).map(|own| format!("{} {}", words.wall_answer, own.question + 1))
            }
        };
        (collection.sender(snapshot.hand_in()).to_owned(), what.unwrap_or_default())
    });
    let label = format!("{letter}: {what}, {}", app.class.called(&sender));
    let up = button()
        .class("icon small")
        .called(format!("{}: {label}", words.move_up))
        .attr("aria-disabled", (place == 0).then_some("true"))
        .when(events::click, move |_| app.class.move_up(place))
        .child("↑");
    let remove = button()
        .class("icon small")
        .called(format!("{}: {label}", words.remove))
        .when(events::click, move |_| app.class.toggle(snapshot))
        .child(icons::cross());
    li().child(span().child(label)).child(up).child(remove)
}
