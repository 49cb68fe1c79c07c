//! Copies of elements and computed lines.

use engine::Readings;
use program::{Child, Element, Program, write_attribute};

const MODEL: &str = "```model\nparameter N = 3\nl = 2 [m]\nx' = 0 [m/s]\nx(0) = 0.5 [m]\n```\n\n";
/// 100 units per metre; the origin is at (200, 200).
const FRAME: &str = "<frame x='-2..2 [m]' y='-1..2 [m]'>";

fn open(scene: &str) -> (Program, Vec<String>) {
    let source = format!("{MODEL}```scene\n<svg viewBox='0 0 400 300'>{scene}</svg>\n```\n");
    let opened = document::open(&source, &[]);
    let found = opened.diagnostics.iter().map(|(_, one)| one.message.english()).collect();
    (opened.document.expect("the model is good").program, found)
}

/// Values of an attribute, in the order of the drawing, for x = 0.5 m.
fn drawn(scene: &str, attribute: &str) -> Vec<String> {
    fn collect(element: &Element, attribute: &str, values: &[f64], found: &mut Vec<String>) {
        for one in element.attributes.iter().filter(|one| one.name == attribute) {
            let mut text = String::new();
            assert!(write_attribute(&one.value, values, &mut text));
            found.push(text);
        }
        for child in &element.children {
            if let Child::Element(child) = child {
                collect(child, attribute, values, found);
            }
        }
    }
    let (program, found) = open(scene);
    assert_eq!(found, [""; 0], "{scene}");
    let scene = program.scene("en").expect("a scene");
    let nodes: Vec<_> = scene.values.iter().map(|value| value.node).collect();
    let mut found = Vec::new();
    let state = [0.5];
    collect(&scene.root, attribute, Readings::new(&program.model, &nodes).at(&[3.0], &state, 0.0, &state), &mut found);
    found
}

fn refused(scene: &str, messages: &[&str]) {
    assert_eq!(open(scene).1, messages, "{scene}");
}

#[test]
fn an_element_is_repeated_for_each_value_of_its_index() {
    assert_eq!(drawn("<circle repeat='i in 1..3' cx='{10*i}' r='2'/>", "cx"), ["10", "20", "30"]);
    assert_eq!(
        drawn(&format!("{FRAME}<circle repeat='i in -1..1' at='(i*x, 0)' r='2px'/></frame>"), "cx"),
        ["150", "200", "250"]
    );
    let grid = "<g repeat='i in 0..1'><circle repeat='j in 1..2' cx='{10*i + j}' r='2'/></g>";
    assert_eq!(drawn(grid, "cx"), ["1", "2", "11", "12"]);
}

#[test]
fn a_line_has_a_point_for_each_value_or_is_a_curve() {
    let line = format!("{FRAME}<polyline points='(i*x, i*1 [m]) for i in 0..2'/></frame>");
    assert_eq!(drawn(&line, "points"), [" 200 200 250 100 300 0"]);
    let curve = drawn(&format!("{FRAME}<polyline points='(s, s^2/l) for s in 0 [m]..l'/></frame>"), "points");
    let numbers: Vec<f64> = curve[0].split_whitespace().map(|number| number.parse().expect("a number")).collect();
    assert_eq!(numbers.len(), 202);
    for pair in numbers.chunks(2) {
        let (x, y) = ((pair[0] - 200.0) / 100.0, (200.0 - pair[1]) / 100.0);
        assert!((y - x * x / 2.0).abs() < 1e-5, "({x}, {y})");
    }
}

#[test]
fn indices_are_checked_and_bounded() {
    refused("<g repeat='i in 1..N'/>", &["the ends of an index must be whole numbers that never change"]);
    refused("<g repeat='x in 1..2'/>", &["`x` has a meaning already"]);
    refused("<g repeat='3'/>", &["an index is a name and its first and last value"]);
    refused("<g repeat='i in 1..3000'/>", &["the elements of a scene cannot have more than 2000 copies"]);
    refused("<g repeat='i in 1..9' id='a'/>", &["what is repeated cannot have an `id`"]);
    refused("<circle repeat='i in 1..9' r='{j}'/>", &["`j` is not known"]);
    refused(
        &format!("{FRAME}<polyline points='(x, x) for i in 1..900'/></frame>"),
        &["a line cannot have more than 500 points"],
    );
    let many = format!("<g repeat='i in 1..2000'>{}</g>", "<g/>".repeat(2_000));
    refused(&many, &["there are too many parts in this scene"]);
    let lines = format!("{FRAME}<polyline repeat='i in 1..2000' points='(0, 0) for j in 1..500'/></frame>");
    refused(&lines, &["there are too many parts in this scene"]);
}

/// Each copy by itself is small enough.
#[test]
fn the_calls_of_all_copies_together_are_bounded() {
    let source = "```model\nfunction f(x) = x*(1 - x)\nfunction g(x) = f(f(f(x)))\nx' = -x/1 [s]\nx(0) = 0.5\n```\n\n\
                  ```scene\n<svg viewBox='0 0 9 9'><circle repeat='i in 1..2000' r='{g(g(g(g(i/2000))))}'/></svg>\n```\n";
    let opened = document::open(source, &[]);
    let found: Vec<&str> = opened.diagnostics.iter().map(|(_, one)| one.code).collect();
    assert!(!found.is_empty() && found.iter().all(|code| *code == "model-too-large"), "{found:?}");
}

#[test]
fn members_of_families_are_drawn_and_dragged_by_their_index() {
    let source = "```model\nsize N = 3\nx[i]' = 0 [m/s] for i in 1..N\nx[i](0) = i*0.5 [m] for i in 1..N\n```\n\n\
                  ```scene\n<svg viewBox='0 0 400 300'><frame x='-2..2 [m]' y='-1..2 [m]'>\
                  <circle repeat='i in 1..N' at='(x[i], 0 [m])' r='5px' drag='x[i]'/></frame></svg>\n```\n";
    let opened = document::open(source, &[]);
    let found: Vec<String> = opened.diagnostics.iter().map(|(_, one)| one.message.english()).collect();
    assert_eq!(found, [""; 0]);
    let program = opened.document.expect("it is good").program;
    fn dragged(element: &Element, found: &mut Vec<program::Dragged>) {
        found.extend(element.drag.as_ref().map(|drag| drag.target));
        for child in &element.children {
            if let Child::Element(child) = child {
                dragged(child, found);
            }
        }
    }
    let mut found = Vec::new();
    dragged(&program.scene("en").expect("a scene").root, &mut found);
    assert_eq!(found, [0, 1, 2].map(program::Dragged::State));
}
