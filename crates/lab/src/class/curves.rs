//! The measured curves of all groups, and what their fits leave over.

use super::drawn::{figure_of, look};
use super::empty::nothing;
use super::room::Part;
use super::words;
use crate::app::App;
use class::collection::{CurveGroup, Member, Snapshot};
use class::page;
use view::browser;
use view::views::*;

/// Maximum number of groups offered for the wall before all are asked for.
const FEW: usize = 100;

/// The section: choice of the quantity, figures, and a button for each group.
pub fn view(app: App) -> View {
    let words = words::of(app);
    let chosen = create_signal(0_usize);
    let groups = memo(move || app.class.read(Part::Curves, |collection| collection.curve_groups()));
    // The chosen group of curves, for a part that is drawn after the choice.
    let shown = move |part: Part| {
        app.class.follow(part);
        let chosen = chosen.get();
        groups.with_untracked(|groups| groups.get(chosen).or(groups.first()).cloned())
    };
    let choice = move || {
        let groups = groups.get_clone();
        if groups.len() < 2 {
            return View::new();
        }
        let option = |(number, group): (usize, CurveGroup)| {
            let name = format!("{} ({})", group.quantity.name, group.members.len());
            option().value(number.to_string()).selected(number == chosen.get_untracked()).child(name)
        };
        let choose = move |event| {
            chosen.set(value_of(&event).parse().unwrap_or(0));
            browser::focus_later("class-quantity".to_owned());
        };
        let list = select().id("class-quantity").when(events::change, choose);
        let list = list.each(groups.into_iter().enumerate(), option);
        field_of("class-quantity", words.curves_quantity).child(list).into()
    };
    let upper = move || {
        let Some(group) = shown(Part::Curves) else { return nothing(app) };
        let look = look(app);
        figure_of(app.class.read_once(|collection| page::curves(collection, &group, &group.members, &[], look))).into()
    };
    let lower = move || {
        let Some(group) = shown(Part::Residuals) else { return View::new() };
        let look = look(app);
        let (svg, caption) = app.class.read_once(|collection| {
            (
                page::residuals(collection, &group, &group.members, look),
                page::curves_caption(collection, &group, look.language),
            )
        });
        View::from((svg.map_or_else(View::new, |svg| figure_of(svg).into()), note(caption)))
    };
    let collecting = move || shown(Part::Chips).map_or_else(View::new, |group| chips(app, group.members));
    View::from((changing(choice), changing(upper), changing(lower), changing(collecting)))
}

/// A button for each curve that collects it for the wall.
fn chips(app: App, members: Vec<Member>) -> View {
    let words = words::of(app);
    let is_whole = create_signal(members.len() <= FEW);
    let count = members.len();
    let chip = move |member: Member| {
        let sender = app.class.read_once(|collection| collection.sender(member.hand_in).to_owned());
        collecting_chip(app, app.class.called(&sender), Snapshot::Curve(member))
    };
    let list = move || {
        let most = if is_whole.get() { usize::MAX } else { FEW };
        each(members.iter().take(most).copied(), chip)
    };
    let more = move || {
        if is_whole.get() {
            return View::new();
        }
        let label = words.show_all.replace('#', &count.to_string());
        button().class("quiet").when(events::click, move |_| is_whole.set(true)).child(label).into()
    };
    let chips = div().class("chips").role("group").attr("aria-label", words.collect);
    View::from((note(words.collect), chips.child(changing(list)).child(changing(more))))
}

/// Button that collects a piece of work for the wall, or removes it.
pub fn collecting_chip(app: App, label: String, snapshot: Snapshot) -> HtmlButton {
    button()
        .class("chip")
        .attr("aria-pressed", move || app.class.is_collected(snapshot).to_string())
        .when(events::click, move |_| app.class.toggle(snapshot))
        .child(label)
}
