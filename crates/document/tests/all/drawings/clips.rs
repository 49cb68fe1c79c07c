//! Clips: shapes are joined to one path, and what browsers draw as a mask is reported.

use super::scene::{open, print};
use document::Opened;

/// Message about a clip that WebKit draws as a mask.
const MASK: &str = "Safari cuts off strokes in this clip, and prints as if there were no clip";

/// A scene with a clip that holds `shapes`, as it was opened.
fn clipped(attributes: &str, shapes: &str) -> Opened {
    open(&format!(
        "<svg viewBox='0 0 9 9'><clipPath id='a' {attributes}>{shapes}</clipPath><g clip-path='url(#a)'/></svg>"
    ))
}

fn messages(opened: &Opened) -> Vec<String> {
    opened.diagnostics.iter().map(|(_, found)| found.message.english()).collect()
}

/// The clip as it is compiled, without messages.
fn compiled(attributes: &str, shapes: &str) -> String {
    let opened = clipped(attributes, shapes);
    assert_eq!(messages(&opened), [""; 0], "{shapes}");
    let text = print(&opened.document.expect("the model is good").program.scene("en").expect("a scene").root);
    let (_, clip) = text.split_once("<clipPath id=a").expect("the clip");
    clip.split_once(";;").expect("its end").0.to_owned()
}

/// Outlines of shapes with a known direction, and of two whose direction only the author knows.
const SQUARE: &str = "<rect x='1' width='2' height='3'/>";
const SQUARED: &str = "M1 0H3V3H1Z";
const DISC: &str = "<circle cx='4' cy='5' r='2' fill='red' stroke-width='3'/>";
const ROUND: &str = "M2 5A2 2 0 0 1 6 5A2 2 0 0 1 2 5Z";

#[test]
fn shapes_are_joined_to_one_path() {
    let joined = |data: &str| format!("><path d={data} clip-rule=nonzero>");
    for (shapes, data) in [
        (vec![SQUARE, SQUARE], vec![SQUARED, SQUARED]),
        (vec![SQUARE, DISC, "<line x1='3' y1='4'/>"], vec![SQUARED, ROUND]),
        (vec!["<ellipse cx='1' rx='2' ry='3'/>", SQUARE], vec!["M-1 0A2 3 0 0 1 3 0A2 3 0 0 1 -1 0Z", SQUARED]),
        (
            vec!["<rect y='1' width='6' height='4' rx='1'/>", SQUARE],
            vec!["M1 1H5A1 1 0 0 1 6 2V4A1 1 0 0 1 5 5H1A1 1 0 0 1 0 4V2A1 1 0 0 1 1 1Z", SQUARED],
        ),
        // A radius is at most half of the side.
        (
            vec!["<rect width='2' height='8' rx='5' ry='1'/>", SQUARE],
            vec!["M1 0H1A1 1 0 0 1 2 1V7A1 1 0 0 1 1 8H1A1 1 0 0 1 0 7V1A1 1 0 0 1 1 0Z", SQUARED],
        ),
        // Each outline that may run either way counts more than all before it.
        (vec!["<path d='M1 2L3 4 5 0'/>", SQUARE], vec!["M0 0M1 2L3 4 5 0Z", SQUARED, SQUARED]),
        (
            vec![DISC, "<path d='m1 2h3v4'/>", "<polygon points='1,2 3,4 5,0'/>"],
            vec!["M0 0m1 2h3v4Z", "M1,2 3,4 5,0Z", "M1,2 3,4 5,0Z", ROUND, ROUND, ROUND, ROUND],
        ),
    ] {
        assert_eq!(compiled("", &shapes.concat()), joined(&data.concat()), "{shapes:?}");
    }
}

#[test]
fn joined_shapes_follow_the_model() {
    // A rectangle of negative height is not drawn.
    let text =
        compiled("clipPathUnits='userSpaceOnUse'", &format!("<rect y='{{y/h}}' width='2' height='{{y/h}}'/>{SQUARE}"));
    assert_eq!(text, format!(" clipPathUnits=userSpaceOnUse><path d=M0 {{0}}H2V{{1}}H0Z{SQUARED} clip-rule=nonzero>"));
    let text = compiled("", &format!("<title>b</title>{SQUARE}{SQUARE}"));
    assert_eq!(text, format!("><title>(b);<path d={SQUARED}{SQUARED} clip-rule=nonzero>"));
    let text = compiled("", "<rect repeat='i in 1..3' x='{i}' width='1' height='{y/h}'/>");
    assert_eq!(text, "><path d=M1 0H2V{4}H1ZM2 0H3V{4}H2ZM3 0H4V{4}H3Z clip-rule=nonzero>");
    let source = "<svg viewBox='0 0 9 9'><frame x='0..9 [m]' y='0..9 [m]' box='0 0 9 9'><clipPath id='a'>\
                  <circle at='(2 [m], 3 [m])' r='1 [m]'/><path d='M (0 [m], 0 [m]) L (1 [m], y) Z'/></clipPath></frame>\
                  <g clip-path='url(#a)'/></svg>";
    let opened = open(source);
    assert_eq!(messages(&opened), [""; 0]);
    let text = print(&opened.document.unwrap().program.scene("en").unwrap().root);
    assert!(text.contains("d=M0 0M 0 9L 1 {1}ZZM1 6A1 1 0 0 1 3 6A1 1 0 0 1 1 6ZM1 6A"), "{text}");
}

/// One shape stays as it is written: every browser clips by its path.
#[test]
fn a_single_shape_stays() {
    for shape in
        ["<rect class='b' transform='rotate(3)' width='2' height='3'/>", "<path clip-rule='evenodd' d='M1 2'/>"]
    {
        let inside = shape.replace(['\'', '/'], "");
        assert_eq!(compiled("", shape), format!(">{}", inside.trim_end_matches('>').to_owned() + ">"));
    }
}

#[test]
fn clips_that_are_masks_are_reported() {
    let five = "<path d='M1 2h3v4z'/>".repeat(5);
    for (attributes, shapes) in [
        ("", "<text y='5'>U</text>"),
        ("clip-path='url(#a)'", SQUARE),
        ("", "<rect clip-path='url(#a)' width='2' height='3'/>"),
        ("", &format!("{SQUARE}<text>U</text>")),
        ("", &format!("{SQUARE}<rect transform='translate(0 {{y/h}})' width='2' height='3'/>")),
        ("", &format!("{SQUARE}<rect visible='y > 0 [m]' width='2' height='3'/>")),
        ("", &format!("{SQUARE}<rect class='b' width='2' height='3'/>")),
        ("", &format!("{SQUARE}<path clip-rule='evenodd' d='M1 2h3v4z'/>")),
        ("clip-rule='evenodd'", &format!("{SQUARE}{DISC}")),
        ("", &format!("{SQUARE}<rect width='50%' height='3'/>")),
        ("", &format!("{SQUARE}<circle cx='1'/>")),
        ("", &format!("{SQUARE}<rect width='2' height='3'><title>b</title></rect>")),
        ("", &five),
    ] {
        let opened = clipped(attributes, shapes);
        assert_eq!(messages(&opened), [MASK], "{attributes} {shapes}");
        let document = opened.document.expect("the model is good");
        let found = &opened.diagnostics[0].1;
        assert_eq!(&document.source[found.span().range()], "clipPath");
        let nests = [attributes, shapes].iter().any(|text| text.contains("clip-path"));
        assert!(found.hints[0].english().starts_with(if nests { "clip a group" } else { "clip by one `<path>`" }));
        // It is drawn as it is written: other browsers show it.
        assert!(!print(&document.program.scene("en").unwrap().root).contains("nonzero"), "{shapes}");
    }
}
