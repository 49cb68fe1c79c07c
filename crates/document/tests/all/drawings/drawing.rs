//! Graphical edits of a drawing.

use crate::editing::edit::documents;
use crate::editing::form::inverse;
use document::drawing::{Axis, Grip, drawable, follows, read};
use document::edit::{
    EditError, Measure, Obstacle, Order, add_element, add_scene, apply, duplicate_element, follow, remove_elements,
    reorder_element, set_attribute, set_text, shift,
};
use model::Edit;
use proptest::prelude::*;
use units::Language;

/// A document with `content` in the frame of its scene; 10 units of the drawing per centimetre, and the origin is at (200,
/// 150).
pub fn framed(content: &str) -> String {
    document_of(&format!("<frame x=\"-20..20 [cm]\" y=\"-15..15 [cm]\">\n    {content}\n  </frame>"))
}

pub fn document_of(content: &str) -> String {
    format!(
        "---\ntitle: A drawing\nlanguage: en\n---\n\n```model\nparameter a = 2 [cm] in 1..5\nparameter phi = 0.5 in 0..1\ny' = -y/(1 [s])\ny(0) = a\n```\n\n\
         ```scene\n<svg viewBox=\"0 0 400 300\">\n  {content}\n</svg>\n```\n"
    )
}

/// Measure with steps of 5 mm.
fn centimetres() -> Measure {
    Measure { unit: "cm".to_owned(), step: 0.005, scale: 1000.0 }
}

fn opens(text: &str) {
    let found = document::open(text, &[]).diagnostics;
    assert!(found.is_empty(), "{text}\n{found:?}");
}

/// Text of the first element after a grip was moved.
fn shifted(text: &str, grip: Grip, by: [f64; 2], measure: &Measure) -> String {
    opens(text);
    let edits = shift(&document::read(text), first(text), grip, by, measure).unwrap();
    let after = apply(text, &edits).unwrap();
    opens(&after);
    element(&after, first(text))
}

/// Index of the first element that is not a frame.
fn first(text: &str) -> usize {
    let drawing = read(&document::read(text)).unwrap();
    drawing.items.iter().position(|item| !item.is_frame()).unwrap()
}

fn element(text: &str, number: usize) -> String {
    let drawing = read(&document::read(text)).unwrap();
    text[drawing.items[number].span.range()].to_owned()
}

#[test]
fn elements_are_moved_sized_and_turned_where_they_stand_in_a_frame() {
    let whole = [0.02, -0.01];
    let cases = [
        ("<bob at=\"(0, y)\"/>", Grip::Whole, whole, "<bob at=\"(2 [cm], y - 1 [cm])\"/>"),
        ("<bob at=\"(3 [cm], y + 1 [cm])\"/>", Grip::Whole, whole, "<bob at=\"(5 [cm], y)\"/>"),
        ("<bob at=\"(0, a) + 2*(y, 0)\"/>", Grip::Whole, whole, "<bob at=\"(2 [cm], a - 1 [cm]) + 2*(y, 0)\"/>"),
        ("<bob at=\"2*(y, a)\"/>", Grip::Whole, whole, "<bob at=\"2*(y, a) + (2 [cm], -1 [cm])\"/>"),
        (
            "<spring from=\"(0, 0)\" to=\"(0, y)\"/>",
            Grip::End,
            whole,
            "<spring from=\"(0, 0)\" to=\"(2 [cm], y - 1 [cm])\"/>",
        ),
        (
            "<rod from=\"(0, 0)\" to=\"(a, y)\"/>",
            Grip::Beginning,
            whole,
            "<rod from=\"(2 [cm], -1 [cm])\" to=\"(a, y)\"/>",
        ),
        (
            "<rod from=\"(0, 0)\" to=\"(a, y)\"/>",
            Grip::Whole,
            [0.01, 0.0],
            "<rod from=\"(1 [cm], 0)\" to=\"(a + 1 [cm], y)\"/>",
        ),
        (
            "<block at=\"(0, y)\" size=\"(4 [cm], 30px)\"/>",
            Grip::Corner,
            whole,
            "<block at=\"(0, y)\" size=\"(8 [cm], 50px)\"/>",
        ),
        (
            "<rect x=\"0\" y=\"0\" width=\"a\" height=\"4 [cm]\"/>",
            Grip::Corner,
            [0.01, 0.01],
            "<rect x=\"0\" y=\"0\" width=\"a + 1 [cm]\" height=\"5 [cm]\"/>",
        ),
        ("<circle at=\"(0, y)\" r=\"5px\"/>", Grip::Edge, [0.01, 0.0], "<circle at=\"(0, y)\" r=\"15px\"/>"),
        ("<bob at=\"(0, y)\"/>", Grip::Edge, [0.01, 0.0], "<bob at=\"(0, y)\" r=\"22px\"/>"),
        (
            "<line x1=\"0\" y1=\"0\" x2=\"a\" y2=\"y\"/>",
            Grip::Whole,
            whole,
            "<line x1=\"2 [cm]\" y1=\"-1 [cm]\" x2=\"a + 2 [cm]\" y2=\"y - 1 [cm]\"/>",
        ),
        (
            "<polygon points=\"(0, 0) (a, 0), (a, y)\"/>",
            Grip::Whole,
            whole,
            "<polygon points=\"(2 [cm], -1 [cm]) (a + 2 [cm], -1 [cm]), (a + 2 [cm], y - 1 [cm])\"/>",
        ),
        (
            "<polyline points=\"(s, y) for s in 0 [cm]..5 [cm]\"/>",
            Grip::Whole,
            whole,
            "<polyline points=\"(s + 2 [cm], y - 1 [cm]) for s in 0 [cm]..5 [cm]\"/>",
        ),
        (
            "<path d=\"M (0, 0) L (a, y) Z\"/>",
            Grip::Whole,
            whole,
            "<path d=\"M (2 [cm], -1 [cm]) L (a + 2 [cm], y - 1 [cm]) Z\"/>",
        ),
        ("<g><bob at=\"(0, 0)\"/></g>", Grip::Whole, whole, "<g at=\"(2 [cm], -1 [cm])\"><bob at=\"(0, 0)\"/></g>"),
        (
            "<angle at=\"(0, 0)\" from=\"0\" to=\"phi\"/>",
            Grip::Whole,
            whole,
            "<angle at=\"(2 [cm], -1 [cm])\" from=\"0\" to=\"phi\"/>",
        ),
    ];
    for (before, grip, by, after) in cases {
        assert_eq!(shifted(&framed(before), grip, by, &centimetres()), after, "{before}");
    }
    let arc = shifted(&framed("<angle at=\"(0, 0)\" from=\"0\" to=\"phi\"/>"), Grip::Edge, [0.01, 0.0], &centimetres());
    assert_eq!(arc, "<angle at=\"(0, 0)\" from=\"0\" to=\"phi\" r=\"40px\"/>");
    let turn = |before: &str, by: f64| shifted(&framed(before), Grip::Turn, [by, 0.0], &Measure::degrees(15.0));
    assert_eq!(
        turn("<block at=\"(0, 0)\" size=\"(a, a)\"/>", 0.5),
        "<block at=\"(0, 0)\" size=\"(a, a)\" turn=\"30 [deg]\"/>"
    );
    assert_eq!(
        turn("<wheel at=\"(0, 0)\" r=\"a\" turn=\"phi\"/>", -0.25),
        "<wheel at=\"(0, 0)\" r=\"a\" turn=\"phi - 15 [deg]\"/>"
    );
}

#[test]
fn elements_are_moved_outside_of_frames_in_units_of_the_drawing() {
    let units = Measure { unit: String::new(), step: 5.0, scale: 1.0 };
    let cases = [
        ("<bob at=\"(20, 30)\"/>", Grip::Whole, "<bob at=\"(30, 25)\"/>"),
        (
            "<rect x=\"5\" y=\"{100 - 10*y/(1 [m])}\" width=\"9\" height=\"9\"/>",
            Grip::Whole,
            "<rect x=\"15\" y=\"{100 - 10*y/(1 [m]) - 5}\" width=\"9\" height=\"9\"/>",
        ),
        ("<path d=\"M0 0h9\"/>", Grip::Whole, "<path d=\"M0 0h9\" transform=\"translate(10 -5)\"/>"),
        ("<g transform=\"translate(5 5) rotate(9)\"/>", Grip::Whole, "<g transform=\"translate(15 0) rotate(9)\"/>"),
        (
            "<rect x=\"5\" y=\"5\" width=\"20\" height=\"20\"/>",
            Grip::Corner,
            "<rect x=\"5\" y=\"5\" width=\"30\" height=\"15\"/>",
        ),
    ];
    for (before, grip, after) in cases {
        assert_eq!(shifted(&document_of(before), grip, [11.0, -4.0], &units), after, "{before}");
    }
}

#[test]
fn points_follow_quantities_from_where_they_are() {
    let cases = [
        ("(0, 3 [cm])", Axis::Along, "y", "(0, y + 3 [cm])"),
        ("(0, -3 [cm])", Axis::Along, "y", "(0, y - 3 [cm])"),
        ("(0, 0)", Axis::Across, "a", "(a, 0)"),
        ("(a + 2 [cm], 0)", Axis::Across, "y", "(y + 2 [cm], 0)"),
        ("(a + 2 [cm], 0)", Axis::Across, "", "(2 [cm], 0)"),
        ("(a - 2 [cm], 0)", Axis::Across, "", "(-2 [cm], 0)"),
        ("(a, y)", Axis::Along, "", "(a, 0)"),
    ];
    for (before, axis, name, after) in cases {
        let text = framed(&format!("<bob at=\"{before}\"/>"));
        let edits = follow(&document::read(&text), first(&text), "at", axis, name).unwrap();
        let changed = apply(&text, &edits).unwrap();
        opens(&changed);
        assert_eq!(element(&changed, first(&text)), format!("<bob at=\"{after}\"/>"));
        let drawing = read(&document::read(&changed)).unwrap();
        let value = drawing.items[first(&text)].attribute("at").unwrap().value;
        assert_eq!(follows(&changed, value, axis), Some(name), "{after}");
    }
}

#[test]
fn everything_in_the_palette_can_be_put_on_a_drawing() {
    for (start, measure, length) in [
        (framed(""), centimetres(), 0.1),
        (document_of("<title>Empty</title>"), Measure { unit: String::new(), step: 5.0, scale: 1.0 }, 100.0),
    ] {
        let mut text = start;
        for kind in drawable() {
            let outline = document::read(&text);
            let middle = if measure.unit.is_empty() { [200.0, 150.0] } else { [0.01, 0.02] };
            let (edit, number) = add_element(&outline, kind, (middle, length), &measure, Language::English).unwrap();
            text = apply(&text, &[edit]).unwrap();
            let drawing = read(&document::read(&text)).unwrap();
            assert_eq!(drawing.items[number].kind, kind, "{text}");
            assert_eq!(number, drawing.items.len() - 1, "on top");
        }
        opens(&text);
    }
}

#[test]
fn a_text_that_would_end_its_element_is_refused_with_the_reason() {
    let text = framed("<bob at=\"(0, 0)\"/><label at=\"(0, y)\">y</label>");
    let outline = document::read(&text);
    let refused = |mark: &str| Err(EditError::NotOneElement(Obstacle::Mark(mark.to_owned())));
    assert_eq!(set_attribute(&outline, 1, "at", "(0, 0)\" r=\"9"), refused("\""));
    assert_eq!(set_text(&outline, 2, "a < b"), refused("<"));
}

/// An element exactly on another one hides it.
#[test]
fn new_elements_come_to_lie_beside_those_that_are_there() {
    let pixels = Measure { unit: String::new(), step: 5.0, scale: 1.0 };
    for (start, measure, kinds, places) in [
        (
            framed("<bob at=\"(1 [cm], 0)\"/>"),
            centimetres(),
            ["bob", "block", "spring", "spring"],
            ["at=\"(0, 0)\"", "at=\"(1 [cm], -1 [cm])\"", "from=\"(-5 [cm], 0)\"", "from=\"(-4 [cm], -1 [cm])\""],
        ),
        (
            document_of("<circle cx=\"9\" cy=\"9\" r=\"2\"/>"),
            pixels,
            ["circle", "circle", "line", "circle"],
            ["cx=\"0\" cy=\"0\"", "cx=\"10\" cy=\"10\"", "x1=\"0\" y1=\"0\"", "cx=\"20\" cy=\"20\""],
        ),
    ] {
        let mut text = start;
        for (name, place) in kinds.into_iter().zip(places) {
            let kind = drawable().find(|kind| kind.name == name).unwrap();
            let outline = document::read(&text);
            let (edit, number) = add_element(&outline, kind, ([0.0; 2], 0.1), &measure, Language::English).unwrap();
            text = apply(&text, &[edit]).unwrap();
            assert!(element(&text, number).contains(place), "{place}: {text}");
        }
        opens(&text);
    }
}

#[test]
fn a_document_without_a_scene_gets_one() {
    let text = "---\ntitle: <b>Decay</b>\n---\n\n```model\ny' = -y/(1 [s])\ny(0) = 2 [m]\n```\n\n```plots\n\"Decay\": y against t\n```\n";
    let edit = add_scene(&document::read(text), "<b>Decay</b>").unwrap();
    let text = apply(text, &[edit]).unwrap();
    opens(&text);
    let bob = drawable().find(|kind| kind.name == "bob").unwrap();
    let (edit, _) =
        add_element(&document::read(&text), bob, ([0.0, 0.0], 0.1), &centimetres(), Language::English).unwrap();
    let text = apply(&text, &[edit]).unwrap();
    opens(&text);
    assert!(
        text.contains("  <frame x=\"-20..20 [cm]\" y=\"-15..15 [cm]\">\n    <bob at=\"(0, 0)\"/>\n  </frame>\n"),
        "{text}"
    );
}

#[test]
fn elements_are_copied_reordered_named_and_removed() {
    let text = framed(
        "<bob id=\"one\" at=\"(0, y)\"/>\n    <g>\n      <rod from=\"(0, 0)\" to=\"(a, 0)\"/>\n    </g>\n    <label at=\"(0, 0)\">y = {y}</label>",
    );
    opens(&text);
    let names = |text: &str| -> Vec<&str> {
        read(&document::read(text)).unwrap().items.iter().map(|item| item.kind.name).collect()
    };
    assert_eq!(names(&text), ["frame", "bob", "g", "rod", "label"]);
    let copied = duplicate_element(&document::read(&text), 1, [0.01, -0.01], &centimetres()).unwrap();
    assert_eq!(copied.1, 2);
    let copied = apply(&text, &[copied.0]).unwrap();
    opens(&copied);
    assert_eq!(element(&copied, 2), "<bob at=\"(1 [cm], y - 1 [cm])\"/>");
    let forward = reorder_element(&document::read(&text), 1, Order::Forward).unwrap();
    assert_eq!(forward.1, 3);
    let forward = apply(&text, &forward.0).unwrap();
    opens(&forward);
    assert_eq!(names(&forward), ["frame", "g", "rod", "bob", "label"]);
    let back = reorder_element(&document::read(&forward), 3, Order::Backward).unwrap();
    assert_eq!((apply(&forward, &back.0).unwrap(), back.1), (text.clone(), 1));
    let named = set_text(&document::read(&text), 1, "Mass").unwrap();
    let named = apply(&text, &named).unwrap();
    opens(&named);
    assert_eq!(element(&named, 1), "<bob id=\"one\" at=\"(0, y)\"><title>Mass</title></bob>");
    let nameless = set_text(&document::read(&named), 1, "").unwrap();
    assert_eq!(element(&apply(&named, &nameless).unwrap(), 1), "<bob id=\"one\" at=\"(0, y)\"></bob>");
    let label = set_text(&document::read(&text), 4, "{y:.1}").unwrap();
    assert_eq!(element(&apply(&text, &label).unwrap(), 4), "<label at=\"(0, 0)\">{y:.1}</label>");
    let coloured = set_attribute(&document::read(&text), 1, "fill", "{if y > a then \"mark\" else \"glass\"}").unwrap();
    let coloured = apply(&text, &coloured).unwrap();
    opens(&coloured);
    let without = set_attribute(&document::read(&coloured), 1, "fill", "").unwrap();
    assert_eq!(apply(&coloured, &without).unwrap(), text);
    let removed = remove_elements(&document::read(&text), &[2, 4]).unwrap();
    let removed = apply(&text, &removed).unwrap();
    opens(&removed);
    assert_eq!(names(&removed), ["frame", "bob"]);
    for wrong in ["1\" onclick=\"x", "<b>", "a\nb\"><g>"] {
        let refused = set_attribute(&document::read(&text), 1, "r", wrong);
        let changed = refused.map(|edits| apply(&text, &edits).unwrap());
        assert!(changed.is_err() || names(&changed.unwrap()) == names(&text), "{wrong}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, ..ProptestConfig::default() })]

    /// Arbitrary graphical edits of the drawings of the gallery: the text can be read again, nothing outside the scene
    /// changes, and undoing the edits restores the text.
    #[test]
    fn any_sequence_of_changes_leaves_a_drawing(
        which in any::<prop::sample::Index>(),
        steps in prop::collection::vec((0_usize..7, 0_usize..40, -9_i32..9, -9_i32..9), 1..12),
    ) {
        let all = documents();
        let original = &all[which.index(all.len())];
        let (mut text, mut undo) = (original.clone(), Vec::new());
        for (action, number, x, y) in steps {
            let outline = document::read(&text);
            let Some(drawing) = read(&outline) else { continue };
            let number = number % drawing.items.len().max(1);
            let by = [f64::from(x)*0.01, f64::from(y)*0.01];
            let measure = Measure { unit: "cm".to_owned(), step: 0.005, scale: 1000.0 };
            let grips = drawing.items.get(number).map(document::drawing::Item::grips).unwrap_or_default();
            let grip = grips.get(x.unsigned_abs() as usize % grips.len().max(1)).copied().unwrap_or(Grip::Whole);
            let kinds: Vec<_> = drawable().collect();
            let kind = kinds[number % kinds.len()];
            let edits: Result<Vec<Edit>, _> = match action {
                0 | 1 => shift(&outline, number, grip, by, &measure),
                2 => add_element(&outline, kind, (by, 0.1), &measure, catalogues::with(Language::Spanish)).map(|(edit, _)| vec![edit]),
                3 => remove_elements(&outline, &[number]),
                4 => duplicate_element(&outline, number, by, &measure).map(|(edit, _)| vec![edit]),
                5 => reorder_element(&outline, number, if x > 0 { Order::Forward } else { Order::Backward }).map(|(edits, _)| edits),
                _ => set_attribute(&outline, number, "opacity", &format!("0.{}", x.unsigned_abs())),
            };
            let Ok(edits) = edits else { continue };
            let after = apply(&text, &edits).unwrap();
            let again = document::read(&after);
            let now = read(&again).unwrap();
            let expected = match action {
                2 => drawing.items.len() + 1,
                0 | 1 | 5 | 6 => drawing.items.len(),
                3 => drawing.items.len() - drawing.items.iter().filter(|one| one.span.start >= drawing.items[number].span.start && one.span.end <= drawing.items[number].span.end).count(),
                _ => now.items.len(),
            };
            prop_assert_eq!(now.items.len(), expected);
            prop_assert_eq!(again.blocks().len(), outline.blocks().len());
            undo.push(inverse(&text, &edits));
            text = after;
        }
        while let Some(edits) = undo.pop() {
            text = apply(&text, &edits).unwrap();
        }
        prop_assert_eq!(&text, original);
    }
}
