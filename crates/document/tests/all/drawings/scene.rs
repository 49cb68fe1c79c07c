//! Permitted and refused content of a scene, through the public interface.
use document::Opened;
use program::{Child, Dragged, Element, Piece, Template};

pub fn open(scene: &str) -> Opened {
    let source = format!(
        "```model\nparameter h = 2 [m]\ny'' = -9.8 [m/s^2]\ny(0) = h \"Height\"\ny'(0) = 0\nname = \"ball\"\n```\n\n```scene\n{scene}\n```\n"
    );
    document::open(&source, &[])
}

fn print_template(template: &Template) -> String {
    template
        .iter()
        .map(|piece| match piece {
            Piece::Literal(text) => text.clone(),
            Piece::Value { index, decimals: None } => format!("{{{index}}}"),
            Piece::Value { index, decimals: Some(decimals) } => format!("{{{index}:.{decimals}}}"),
            Piece::Trail(index) => format!("{{trail {index}}}"),
            Piece::Choice { index, texts } => {
                let texts: Vec<String> = texts.iter().map(|(number, text)| format!("{number} {text}")).collect();
                format!("{{{index}: {}}}", texts.join(", "))
            }
        })
        .collect()
}

pub fn print(element: &Element) -> String {
    let mut text = format!("<{}", element.name);
    for attribute in &element.attributes {
        text += &format!(" {}={}", attribute.name, print_template(&attribute.value));
    }
    if let Some(drag) = &element.drag {
        let target = match drag.target {
            Dragged::State(index) => format!("{index}"),
            Dragged::Parameter(index) => format!("parameter {index}"),
        };
        text += &format!(" drag {target} {:?} {:?}", drag.up, drag.right);
    }
    text += ">";
    for child in &element.children {
        match child {
            Child::Element(element) => text += &print(element),
            Child::Text(template) => text += &format!("({})", print_template(template)),
        }
    }
    text + ";"
}

fn check(scene: &str, expected: &str, messages: &[&str]) {
    let opened = open(scene);
    let found: Vec<String> = opened.diagnostics.iter().map(|(_, d)| d.message.english()).collect();
    assert_eq!(found, messages, "{scene}");
    let document = opened.document.expect("the model is good");
    let scene = document.program.scene("en").map(|scene| print(&scene.root)).unwrap_or_default();
    assert_eq!(scene, expected);
}

/// Values that browsers would silently ignore, and their fixes.
#[test]
fn colours_and_numbers_of_attributes_are_checked() {
    for (attribute, message, remedy) in [
        ("fill='bleu'", "\"bleu\" is not a colour", "blue"),
        ("stroke='rojo'", "\"rojo\" is not a colour", "red"),
        ("fill=' Liquit '", "\"Liquit\" is not a colour", "liquid"),
        ("fill='2'", "\"2\" is not a colour", ""),
        ("fill='#12345'", "\"#12345\" is not a colour", ""),
        ("fill='rgb(1, 2)'", "\"rgb(1, 2)\" is not a colour", ""),
        ("fill='rgb(1, {y/h}, x)'", "\"rgb(1, 0, x)\" is not a colour", ""),
        ("fill='{y/h}'", "a colour is a text, and this is none", ""),
        ("stroke-width='abc'", "`stroke-width` cannot be `abc`", ""),
        ("stroke-width='-1'", "`stroke-width` cannot be `-1`", ""),
        ("stroke-width='1,5 px'", "`stroke-width` cannot be `1,5 px`", "1.5px"),
        ("stroke-width='1,{y/h}'", "`stroke-width` cannot be `1,0`", ""),
        ("stroke-dasharray='5 a'", "`stroke-dasharray` cannot be `5 a`", ""),
        ("opacity='half'", "`opacity` cannot be `half`", ""),
        ("r='h'", "`r` cannot be `h`", ""),
    ] {
        let scene = format!("<svg viewBox='0 0 9 9'><circle {attribute}/></svg>");
        let opened = open(&scene);
        let [(0, found)] = &opened.diagnostics[..] else { panic!("{attribute}: {:?}", opened.diagnostics) };
        assert_eq!(found.message.english(), message);
        let remedies: Vec<&str> = found.fixes.iter().map(|fix| fix.edits[0].text.as_str()).collect();
        assert_eq!(remedies.join(" "), remedy, "{attribute}");
        assert!(attribute.contains(opened.document.unwrap().source[found.span().range()].trim_matches(['{', '}'])));
    }
    for attribute in [
        "fill=none",
        "fill=CornflowerBlue",
        "stroke=#1a2b3c4d",
        "fill=rgb(1 2 3 / 50%)",
        "fill=hsl(120deg, 50%, 50%)",
        "fill=var(--mark, #c4551d)",
        "stroke-width=2.5px",
        "stroke-width=5%",
        "stroke-dasharray=5, 3.5 2",
        "stroke-dasharray=none",
        "opacity=40%",
        "font-size=larger",
        "width=100%",
        "x=1 2.5 3",
    ] {
        let (name, value) = attribute.split_once('=').unwrap();
        inside(&format!("<circle {name}='{value}'/>"), &format!("<circle {attribute}>;"), &[]);
    }
}

/// A scene with one element.
fn inside(content: &str, expected: &str, messages: &[&str]) {
    check(&format!("<svg viewBox=\"0 0 9 9\">{content}</svg>"), &format!("<svg viewBox=0 0 9 9>{expected};"), messages);
}

#[test]
fn values_follow_the_model() {
    inside(
        "<rect y='{y}' height='{2*h}'/><text x=\"{y}\">y = {y in [cm]:.1}, {name}</text>",
        "<rect y={0} height={1}>;<text x={0}>(y = {2:.1}, {3});",
        &[],
    );
    inside("<text>{{y}} &lt;</text><path d='M0 {if y < h then 1 else 2}'/>", "<text>({y} <);<path d=M0 {0}>;", &[]);
}

/// A number in an attribute is in the stated unit; the same expression in a text keeps its own unit.
#[test]
fn a_stated_unit_holds_in_attributes() {
    let source = "```model\nparameter phi = 0.5 [rad]\n```\n\n```scene\n<svg viewBox='0 0 9 9'><g transform='rotate({phi in \
                  [deg]})'/><g transform='rotate({phi})'/><text>{phi in [deg]}</text></svg>\n```\n";
    let program = document::open(source, &[]).document.expect("a document").program;
    let values = &program.editions[0].scene.as_ref().expect("a scene").values;
    let mut readings =
        engine::Readings::new(&program.model, &values.iter().map(|value| value.node).collect::<Vec<_>>());
    let found = readings.at(&[0.5], &[], 0.0, &[]);
    assert!((found[0] - 0.5_f64.to_degrees()).abs() < 1e-13 && found[1..] == [0.5, 0.5], "{found:?}");
    assert_eq!(values.iter().map(|value| value.unit.text.as_str()).collect::<Vec<_>>(), ["", "rad", "deg"]);
}

#[test]
fn a_scene_has_names_of_its_own() {
    check(
        "half = h/2  # a comment\ntwice = 4*half\n<svg viewBox='0 0 9 9'><rect y='{twice}' x='{2*h}' width='{half}'/></svg>",
        "<svg viewBox=0 0 9 9><rect y={0} x={1} width={2}>;;",
        &[],
    );
    check(
        "h = 2 [m]\na = 1\na = 2\nb = h + 1\n<svg viewBox='0 0 9 9'><rect x='{b}' y='{a}'/></svg>",
        "<svg viewBox=0 0 9 9><rect y={0}>;;",
        &[
            "`h` is already a name of the model",
            "`a` is defined twice",
            "the term `1` has no unit, but a length is needed",
        ],
    );
}

#[test]
fn dragging_names_a_state_and_says_how_much() {
    inside(
        "<g drag='y' drag-up='0.01 [m]'/><g drag=\"y'\" drag-right='0.1 [m/s]' drag-up='-0.2 [m/s]'/>",
        "<g drag 0 Some(0) None>;<g drag 1 Some(1) Some(2)>;",
        &[],
    );
    inside(
        "<g drag='y' drag-right='0.01 [m]' drag-zero='7'/><g drag='y' drag-up='0.01 [m]' drag-zero='1 [m]'/>",
        "<g>;<g drag 0 Some(0) None>;",
        &[
            "`drag-zero` belongs to what moves up and down alone",
            "a length in the drawing is a pure number, in units of the `viewBox`",
        ],
    );
    inside(
        "<g drag='h' drag-up='1 [m]'/><g drag='k' drag-up='1 [m]'/><g drag='y' drag-up='1'/><g drag='y'/><g drag-up='1 [m]'/>",
        "<g drag parameter 0 Some(0) None>;<g>;<g>;<g>;<g>;",
        &[
            "`k` is neither a state nor a parameter, so it cannot be dragged",
            "one unit of the drawing must add to `y` something of its dimension",
            "dragging needs `drag-up`, `drag-right` or both",
            "what does the pointer change?",
        ],
    );
}

#[test]
fn colours_and_visibility_follow_the_model() {
    inside(
        "<rect fill='mark' stroke='{if y < h then \"liquid\" else \"#c4551d\"}' visible='y > 0 [m]'/>",
        "<rect fill=var(--mark, #c4551d) stroke={0: 1 var(--liquid, #3f9fc0), 2 #c4551d} display={1: 0 none, 1 inline}>;",
        &[],
    );
    inside("<g visible='1 < 2'/><g visible='{2 < 1}'/>", "<g display=inline>;<g display=none>;", &[]);
    inside(
        "<g visible='y'/><g fill='{if y < h then \"red\" else \"url(x)\"}'/>",
        "<g>;<g>;",
        &["`visible` needs a condition", "\"url(x)\" is not a colour"],
    );
}

#[test]
fn elements_that_run_load_or_move_by_themselves_are_refused() {
    for name in [
        "script",
        "foreignObject",
        "iframe",
        "a",
        "use",
        "animate",
        "set",
        "animateTransform",
        "object",
        "embed",
        "audio",
        "video",
        "handler",
        "filter",
        "feImage",
        "mask",
        "pattern",
        "symbol",
        "metadata",
        "SCRIPT",
        "svg:script",
    ] {
        inside(
            &format!("<{name}>alert(1)</{name}><g/>"),
            "<g>;",
            &[&format!("a scene cannot contain `<{name}>`; it is left out with what it holds")],
        );
    }
    inside("<svg/>", "", &["`<svg>` cannot contain `<svg>`"]);
}

#[test]
fn attributes_that_run_or_load_are_refused() {
    for name in [
        "onclick",
        "onload",
        "onbegin",
        "href",
        "xlink:href",
        "style",
        "filter",
        "mask",
        "src",
        "begin",
        "values",
        "ONCLICK",
        "formaction",
        "tabindex",
        "role",
        "xml:base",
    ] {
        inside(
            &format!("<g {name}=\"x\"/>"),
            "<g>;",
            &[&format!("the attribute `{name}` is not allowed in a scene; it is left out")],
        );
    }
}

#[test]
fn values_that_run_or_load_are_refused() {
    for (value, word) in [
        ("url(https://evil.example/x)", "url("),
        ("url( #a)", "url("),
        ("url(#a) url(//x)", "url("),
        ("java&#115;cript:alert(1)", "javascript:"),
        ("j&#x61;vascript :x", "javascript:"),
        ("\\75 rl(#a)", "\\"),
        ("data:x", "data:"),
        ("ur{y}l(x", ""),
    ] {
        if word.is_empty() {
            continue;
        }
        inside(
            &format!("<linearGradient id='a'/><g fill=\"{value}\"/>"),
            "<linearGradient id=a>;<g>;",
            &[&format!("`{word}` is not allowed in a scene; `fill` is left out")],
        );
    }
    // Digits between the letters do not hide a word.
    inside("<g fill='ur{y}l(x)'/>", "<g>;", &["`url(` is not allowed in a scene; `fill` is left out"]);
}

#[test]
fn references_stay_inside_the_scene() {
    inside(
        "<clipPath id='a'/><g clip-path='url(#a)' fill='url(#b)'/><g id='a b'/><g id='a'/>",
        "<clipPath id=a>;<g clip-path=url(#a) fill=url(#b)>;<g>;<g id=a>;",
        &["nothing in the scene has the id `b`", "`a b` cannot be an id", "the id `a` is used twice"],
    );
    inside("<g d='url(#a)'/>", "<g>;", &["`url(` is not allowed in a scene; `d` is left out"]);
}

#[test]
fn names_and_styles_hold_no_values() {
    inside(
        "<g id='a{y}' class='b{y}'/>",
        "<g>;",
        &["`a{y}` cannot be an id", "`id` cannot hold values of the model", "`class` cannot hold values of the model"],
    );
    inside("<g class='a b\"c'/>", "<g class=a>;", &["`a b\"c` is not a list of class names"]);
    inside(
        "<style>.a { fill: red } @import url(x); .b { fill: {y} }</style>",
        "<style>(.a{fill:red;});",
        &["this selector is not allowed in a scene", "a rule is `selector { property: value }`"],
    );
}

#[test]
fn text_in_attributes_and_text_outside_text_are_refused() {
    inside("<rect x='{name}'/>", "<rect>;", &["an attribute can hold numbers only, and this is a text"]);
    inside("<rect fill='{name}'/>", "<rect>;", &["\"ball\" is not a colour"]);
    inside("<g>loose</g>", "<g>;", &["text is shown inside `<text>` only"]);
    check("nothing", "", &["a scene needs a drawing"]);
    check("<svg/>", "<svg>;", &["the `svg` element needs a `viewBox`"]);
}
