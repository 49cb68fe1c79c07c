//! Attributes of the selected element: a field for each with its text, and for points the quantities that they follow.

use super::hand::Hand;
use super::{acts, layers, words};
use crate::write::fields::{follow, named};
use crate::write::{Panel, briefs, findings, panels};
use document::drawing::{Axis, Item, Part, draggable, followed, follows, shows_text};
use model::{Diagnostic, Severity};
use view::views::*;
use web_sys::HtmlInputElement;

/// Attributes that every element may have.
const COMMON: [&str; 4] = ["visible", "fill", "stroke", "stroke-width"];
/// SVG coordinates and lengths, and attributes that transform or repeat an element.
const PLAIN: [&str; 14] =
    ["x", "y", "width", "height", "cx", "cy", "x1", "y1", "x2", "y2", "rx", "ry", "transform", "repeat"];
/// Attributes that are points.
const POINTS: [&str; 3] = ["at", "from", "to"];

/// Fields of the selected element; only a single one is shown.
pub fn view(hand: Hand) -> HtmlDiv {
    let words = words::of(hand.app);
    // Rebuilt for another element, but not for another text of the same element.
    let shown = memo(move || {
        let chosen = hand.chosen.get_clone();
        let [number] = chosen[..] else { return Err(chosen.len()) };
        hand.drawing.with(|drawing| {
            let item = drawing.as_ref().and_then(|drawing| drawing.items.get(number)).ok_or(0_usize)?;
            let names: Vec<String> = item.attributes.iter().map(|attribute| attribute.name.clone()).collect();
            Ok((number, item.kind, names))
        })
    });
    let content = move || match shown.get_clone() {
        Err(0) => View::from(note(words.chosen_none)),
        Err(count) => note(format!("{count} {}", words.chosen_several)).into(),
        Ok((number, kind, names)) => {
            let is_frame = kind.name == "frame";
            let common = COMMON.into_iter().filter(|_| !is_frame);
            div()
                .class("inspector-fields")
                .child(title(hand, number))
                .each(attributes_of(kind, &names), |name| row(hand, number, name))
                .maybe((!is_frame).then(|| dragged(hand, number)))
                .each(common, |name| row(hand, number, name))
                .into()
        }
    };
    div().class("inspector").id("drawing-inspector").child(changing(content)).child(colours())
}

/// Attributes shown for an element: those of its kind, and SVG coordinates if present.
fn attributes_of(kind: &Part, written: &[String]) -> Vec<&'static str> {
    let is_written = |name: &str| written.iter().any(|own| own == name);
    // SVG coordinates make the point attributes superfluous.
    let is_plain = ["x", "cx", "x1"].into_iter().any(is_written) && kind.name != "frame";
    let is_place = |name: &str| POINTS.contains(&name) || name == "size";
    let own = kind.attributes.iter().copied().filter(|name| is_written(name) || !(is_plain && is_place(name)));
    let plain = PLAIN.into_iter().filter(|name| is_written(name) && !kind.attributes.contains(name));
    own.chain(plain).collect()
}

/// Signal with a value read from the present text of an element; `nothing` if the element does not exist.
fn reading<T: PartialEq + Clone + 'static>(
    hand: Hand,
    number: usize,
    read: impl Fn(&Item, &str) -> T + 'static,
    nothing: T,
) -> ReadSignal<T> {
    // Tracks the text, because the drawing may be equal although the places in the text differ.
    memo(move || {
        hand.text.with(|text| {
            hand.drawing.with(|drawing| {
                let item = drawing.as_ref().and_then(|drawing| drawing.items.get(number));
                item.map_or_else(|| nothing.clone(), |item| read(item, text))
            })
        })
    })
}

/// Name or text of the element, and a link to its place in the text.
fn title(hand: Hand, number: usize) -> View {
    let words = words::of(hand.app);
    let says =
        |item: &Item, text: &str| item.says.and_then(|says| text.get(says.range())).unwrap_or_default().to_owned();
    let shown = reading(hand, number, says, String::new());
    let item = hand.drawing.with_untracked(|drawing| drawing.as_ref()?.items.get(number).cloned());
    let Some(item) = item else { return View::new() };
    let is_text = shows_text(item.kind);
    let place = item.opening.start;
    let go = move |_| {
        panels::show(hand.app, Panel::Text);
        findings::go_to(hand.app, 0, place);
    };
    let name = if is_text { words.shows } else { words.called };
    let set = move |text: &str| acts::say(hand, number, text);
    let heading = h4().child(layers::name(hand, &Item { says: None, ..item.clone() }));
    let in_text = button().class("quiet").when(events::click, go).child(words.in_text);
    let field = (item.kind.name != "frame")
        .then(|| line("drawing-name".to_owned(), name, field("drawing-name".to_owned(), shown, set).into()));
    View::from((div().class("inspector-head").child(heading).child(in_text), field.map_or_else(View::new, View::from)))
}

fn line(id: String, name: &'static str, field: View) -> HtmlDiv {
    div().class("inspector-line").child(label().r#for(id).child(name)).child(field)
}

/// A field for a text of the element. The text is changed when the input is complete.
fn field(id: String, shown: ReadSignal<String>, set: impl Fn(&str) + 'static) -> HtmlInput {
    let mut field = input().r#type("text").class("cell").id(id).autocomplete("off").attr("spellcheck", "false");
    let node: HtmlInputElement = field.node();
    follow(node, shown);
    field.attr("autocapitalize", "off").when(events::change, move |event| set(&value_of(&event)))
}

/// Diagnostics of an attribute from the last check.
fn found(hand: Hand, number: usize, name: &'static str) -> ReadSignal<Vec<Diagnostic>> {
    memo(move || {
        hand.app.written.track();
        let value = hand.drawing.with(|drawing| Some(drawing.as_ref()?.items.get(number)?.attribute(name)?.value));
        let Some(value) = value else { return Vec::new() };
        let is_own = |(file, found): &&(usize, Diagnostic)| {
            *file == 0 && (value.start..=value.end).contains(&found.span().start)
        };
        hand.app
            .read_writing(|writing| writing.findings().iter().filter(is_own).map(|(_, found)| found.clone()).collect())
    })
}

/// Row of an attribute. For a point, the quantity that it follows can be selected.
fn row(hand: Hand, number: usize, name: &'static str) -> HtmlDiv {
    let shown =
        reading(hand, number, move |item, text| item.value(text, name).unwrap_or_default().to_owned(), String::new());
    let id = format!("attribute-{name}");
    let field = field(id.clone(), shown, move |text| acts::set(hand, number, name, text));
    let field = if matches!(name, "fill" | "stroke") { field.attr("list", "drawing-colours") } else { field };
    let found = found(hand, number, name);
    let is_wrong = move || found.with(|found| found.iter().any(|found| found.severity == Severity::Error));
    let (said, next) = (format!("{id}-faults"), id.clone());
    let field = field.attr("aria-invalid", move || is_wrong().then_some("true")).attr("aria-describedby", said.clone());
    let row = line(id, words::attribute(hand.app, name), field.into())
        .child(div().class("faults").id(said).child(briefs::view(hand.app, found, move |_| next.clone())));
    if !POINTS.contains(&name) {
        return row;
    }
    let is_arc = hand.drawing.with_untracked(|drawing| {
        drawing.as_ref().and_then(|drawing| Some(drawing.items.get(number)?.kind.name == "angle")) == Some(true)
    });
    if is_arc && name != "at" {
        return row;
    }
    row.child(following(hand, number, name, Axis::Across)).child(following(hand, number, name, Axis::Along))
}

/// Selection of the quantity that a component of a point follows.
fn following(hand: Hand, number: usize, name: &'static str, axis: Axis) -> View {
    let words = words::of(hand.app);
    let now = reading(
        hand,
        number,
        move |item, text| {
            let value = item.attribute(name)?.value;
            Some(follows(text, value, axis).map(str::to_owned))
        },
        None,
    );
    let framed = hand.drawing.with_untracked(|drawing| {
        drawing.as_ref().and_then(|drawing| drawing.items.get(number)).is_some_and(|item| item.framed)
    });
    let direction = match axis {
        Axis::Across => words.follows_across,
        Axis::Along if framed => words.follows_up,
        Axis::Along => words.follows_down,
    };
    let id = format!("follow-{name}-{axis:?}").to_lowercase();
    let names = memo(move || {
        hand.app.written.track();
        let dimension = hand.seen.with_untracked(|seen| seen.as_ref().map(|seen| seen.ground.dimension));
        dimension.map_or_else(Vec::new, |dimension| hand.app.read(|play| followed(play.model(), dimension)))
    });
    changing(move || {
        // Without a value there is no component.
        let Some(now) = now.get_clone() else { return View::new() };
        let own = now.is_none();
        let names = names.get_clone();
        let chosen = now.unwrap_or_default();
        let is_known = chosen.is_empty() || names.iter().any(|(name, _)| *name == chosen);
        let choice = |(value, title): (String, String), selected: bool| {
            option().value(value).prop("selected", selected).child(title)
        };
        let mut options: Vec<HtmlOption> = Vec::new();
        if own || !is_known {
            let title = if own { words.follows_own.to_owned() } else { chosen.clone() };
            options.push(choice(("?".to_owned(), title), true));
        }
        options.push(choice((String::new(), words.follows_nothing.to_owned()), !own && chosen.is_empty()));
        options.extend(names.into_iter().map(|(name, label)| {
            let title = named(&name, label);
            let selected = !own && name == chosen;
            choice((name, title), selected)
        }));
        let bind = move |event| {
            let name_of = value_of(&event);
            if name_of != "?" {
                acts::bind(hand, number, name, axis, &name_of);
            }
        };
        // Distinguishes the points of an element, whose directions have equal names.
        let point = span().class("visually-hidden").child(format!("{}: ", words::attribute(hand.app, name)));
        let field = select().class("cell").id(id.clone()).each(options, View::from).when(events::change, bind);
        div()
            .class("inspector-follow")
            .child(label().r#for(id.clone()).child(point).child(direction))
            .child(field)
            .into()
    })
}

/// Selection of the quantity that changes when the element is dragged in the simulation.
fn dragged(hand: Hand, number: usize) -> View {
    let words = words::of(hand.app);
    let now =
        reading(hand, number, |item, text| item.value(text, "drag").unwrap_or_default().to_owned(), String::new());
    let names = memo(move || {
        hand.app.written.track();
        hand.app.read(|play| draggable(play.model()))
    });
    changing(move || {
        let now = now.get_clone();
        let choice = |value: String, title: String| {
            let selected = value == now;
            option().value(value).prop("selected", selected).child(title)
        };
        let options = names.get_clone().into_iter().map(|(name, label)| {
            let title = named(&name, label);
            choice(name, title)
        });
        let field = select()
            .class("cell")
            .id("attribute-drag")
            .child(choice(String::new(), words.follows_nothing.to_owned()))
            .each(options, View::from)
            .when(events::change, move |event| acts::set(hand, number, "drag", &value_of(&event)));
        View::from(line("attribute-drag".to_owned(), words.dragged, field.into()))
    })
}

/// Names of the page's colours.
fn colours() -> HtmlDatalist {
    let names = document::drawing::colours();
    datalist().id("drawing-colours").each(names, |name| option().value(name))
}
