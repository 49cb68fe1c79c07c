//! Frames: drawings in units of the problem.

use engine::Readings;
use program::{Child, Dragged, Element, Program, write_attribute};

const MODEL: &str = "```model\nparameter l = 2 [m] in 1..3\nx' = 0 [m/s]\nx(0) = 0.5 [m]\ntheta' = 0 [1/s]\n\
                     theta(0) = 0.3 [rad]\n```\n\n";

fn open(scene: &str) -> (Program, Vec<String>) {
    let source = format!("{MODEL}```scene\n<svg viewBox='0 0 400 300'>{scene}</svg>\n```\n");
    let opened = document::open(&source, &[]);
    let found = opened.diagnostics.iter().map(|(_, one)| one.message.english()).collect();
    (opened.document.expect("the model is good").program, found)
}

/// Values of the drawing for these states.
fn values(program: &Program, state: &[f64]) -> Vec<f64> {
    let values = &program.scene("en").expect("a scene").values;
    let nodes: Vec<_> = values.iter().map(|value| value.node).collect();
    Readings::new(&program.model, &nodes).at(&[2.0], state, 0.0, state).to_vec()
}

fn print(element: &Element, values: &[f64]) -> String {
    let mut text = format!("<{}", element.name);
    for attribute in &element.attributes {
        let mut value = String::new();
        assert!(write_attribute(&attribute.value, values, &mut value), "{attribute:?}");
        text += &format!(" {}={value}", attribute.name);
    }
    text += ">";
    for child in &element.children {
        if let Child::Element(child) = child {
            text += &print(child, values);
        }
    }
    text + ";"
}

/// SVG of a scene for x = 0.5 m and theta = 0.3.
fn check(scene: &str, expected: &str) {
    let (program, found) = open(scene);
    assert_eq!(found, [""; 0], "{scene}");
    let drawn = print(&program.scene("en").expect("a scene").root, &values(&program, &[0.5, 0.3]));
    assert_eq!(drawn, format!("<svg viewBox=0 0 400 300>{expected};"));
}

fn refused(scene: &str, messages: &[&str]) {
    let (_, found) = open(scene);
    assert_eq!(found, messages, "{scene}");
}

/// 4 m by 3 m in 400 by 300 units: 100 units per metre; the origin is at (200, 200).
const FRAME: &str = "<frame x='-2..2 [m]' y='-1..2 [m]'>";

#[test]
fn lengths_are_those_of_the_problem_and_y_goes_up() {
    check(
        &format!("{FRAME}<circle cx='x' cy='1 [m]' r='5px'/><circle at='(x, 0)' r='{{20 [cm]}}'/></frame>"),
        "<g><circle cx=250 cy=100 r=5>;<circle cx=250 cy=200 r=20>;;",
    );
    check(
        &format!("{FRAME}<rect x='0' y='0' width='1 [m]' height='x'/><rect at='(x, 0)' size='(1 [m], 10px)'/></frame>"),
        "<g><rect x=200 y=150 width=100 height=50>;<rect x=200 y=195 width=100 height=10>;;",
    );
    check(
        &format!(
            "{FRAME}<line from='(0, 0)' to='2*(x, x)'/><polyline points='(0, 0), (x, 1 [m])'/>\
             <path d='M (0, 0) L(x, 0) Z'/><text x='x' y='0'>x</text></frame>"
        ),
        "<g><line x1=200 y1=200 x2=300 y2=100>;<polyline points= 200 200 250 100>;<path d=M 200 200L 250 200Z>;\
         <text x=250 y=200>;;",
    );
}

#[test]
fn the_scale_is_equal_on_both_axes_and_the_frame_stands_in_its_box() {
    check(
        "<frame x='0..1 [m]' y='0..3 [m]'><circle at='(0, 0)' r='1 [m]'/></frame>",
        "<g><circle cx=150 cy=300 r=100>;;",
    );
    check(
        "<frame x='-l..l' y='0 [m]..l' box='100 0 200 100'><circle at='(x, 0)' r='x'/></frame>",
        "<g><circle cx=225 cy=100 r=25>;;",
    );
    check("<frame x='-1..1' y='-1..1'><circle at='(x/l, 0)' r='0.5'/></frame>", "<g><circle cx=237.5 cy=150 r=75>;;");
}

#[test]
fn groups_of_a_frame_have_an_origin_and_turn_against_the_clock() {
    check(
        &format!("{FRAME}<g at='(x, 0)' turn='90 [deg]'><circle at='(0, 1 [m])' r='5px'/></g></frame>"),
        "<g><g transform=translate( 250 200) rotate(-90)><circle cx=0 cy=-100 r=5>;;;",
    );
}

#[test]
fn what_does_not_fit_is_refused_at_its_place() {
    let length = "a length in a frame must have the dimension of its axes";
    refused(&format!("{FRAME}<circle cx='1' cy='theta' r='l'/></frame>"), &[length, length]);
    refused(&format!("{FRAME}<g turn='x'/></frame>"), &["an angle is a pure number, such as `30 [deg]`"]);
    refused(
        &format!("{FRAME}<circle at='x' r='1px'/></frame>"),
        &["a point is two numbers in parentheses, or a vector"],
    );
    refused(&format!("{FRAME}<polyline points='0,0 1,1'/></frame>"), &["in a frame this consists of points"]);
    refused(&format!("{FRAME}<rect at='(0, 0)' size='2'/></frame>"), &["a size is two lengths in parentheses"]);
    refused(&format!("{FRAME}<g transform='rotate(3)'/></frame>"), &["`transform` counts in units of the drawing"]);
    refused(&format!("{FRAME}{FRAME}</frame></frame>"), &["a frame cannot stand inside another one"]);
    refused("<frame x='0..1 [m]'/>", &["a frame needs the ranges of `x` and `y`"]);
    refused("<frame x='0..1 [m]' y='1'/>", &["a range is two values with `..` between them"]);
    refused("<frame x='1..0 [m]' y='0..1 [m]'/>", &["the range is empty"]);
    refused(
        "<frame x='0..1 [m]' y='0..1'/>",
        &["both axes of a frame have one scale, so they must have one dimension"],
    );
    refused("<frame x='0..1' y='0..1' box='1 2 3'/>", &["a frame is fitted into a box, and there is none"]);
}

/// The drag target, and its change per unit upwards and to the right, for x = 0.5 m and theta = 0.3.
fn handle(scene: &str) -> (program::Drag, Vec<f64>) {
    let (program, found) = open(scene);
    assert_eq!(found, [""; 0], "{scene}");
    let values = values(&program, &[0.5, 0.3]);
    fn find(element: &Element) -> Option<&program::Drag> {
        element.drag.as_ref().or_else(|| {
            element.children.iter().find_map(|child| match child {
                Child::Element(child) => find(child),
                Child::Text(_) => None,
            })
        })
    }
    (find(&program.scene("en").expect("a scene").root).expect("a handle").clone(), values)
}

fn dragged(scene: &str) -> (Dragged, Option<f64>, Option<f64>) {
    let (drag, values) = handle(scene);
    (drag.target, drag.up.map(|index| values[index]), drag.right.map(|index| values[index]))
}

#[test]
fn a_part_of_a_frame_follows_the_hand_along_its_way() {
    assert_eq!(
        dragged(&format!("{FRAME}<circle at='(x, 0)' r='9px' drag='x'/></frame>")),
        (Dragged::State(0), None, Some(0.01))
    );
    assert_eq!(
        dragged(&format!("{FRAME}<circle at='(0, -l)' r='9px' drag='l'/></frame>")),
        (Dragged::Parameter(0), Some(-0.01), None)
    );
    // On a circle of 2 m a unit of the drawing along the tangent is 1/200 radian.
    let bob = "<circle at='(l*sin(theta), -l*cos(theta))' r='9px' drag='theta'/>";
    let (target, up, right) = dragged(&format!("{FRAME}{bob}</frame>"));
    assert_eq!(target, Dragged::State(1));
    assert!((up.expect("up") - libm::sin(0.3) / 200.0).abs() < 1e-12);
    assert!((right.expect("right") - libm::cos(0.3) / 200.0).abs() < 1e-12);
    // In a group turned by 90 degrees to the left, its x axis points up.
    let (_, up, right) = dragged(&format!("{FRAME}<g turn='pi/2'><circle at='(x, 0)' r='9px' drag='x'/></g></frame>"));
    assert!((up.expect("up") - 0.01).abs() < 1e-12 && right.is_none_or(|right| right.abs() < 1e-12));
    assert_eq!(
        dragged(&format!("{FRAME}<circle at='(0, 0)' r='9px' drag='theta' drag-up='2 [1/m]'/></frame>")),
        (Dragged::State(1), Some(0.02), None)
    );
    refused(
        &format!("{FRAME}<circle at='(0, 0)' r='9px' drag='x'/></frame>"),
        &["where this part lies does not depend on `x`"],
    );
}

#[test]
fn what_moves_up_and_down_alone_says_where_its_quantity_is_zero() {
    let zero = |inside: &str| {
        let (drag, values) = handle(&format!("{FRAME}{inside}</frame>"));
        drag.zero.map(|index| values[index])
    };
    let origin = zero("<circle at='(0, x)' r='9px' drag='x'/>").expect("a straight way");
    assert!(
        (zero("<circle at='(0, 0.5 [m] - x)' r='9px' drag='x'/>").expect("a straight way") - (origin - 50.0)).abs()
            < 1e-9
    );
    assert!((zero("<g drag='x' drag-up='1' drag-zero='0.25 [m]'/>").expect("stated") - (origin - 25.0)).abs() < 1e-9);
    // Sideways, along a circle, and along a curve.
    assert_eq!(zero("<circle at='(x, 0)' r='9px' drag='x'/>"), None);
    assert_eq!(zero("<circle at='(l*sin(theta), -l*cos(theta))' r='9px' drag='theta'/>"), None);
    assert_eq!(zero("<circle at='(0, x^2/(1 [m]))' r='9px' drag='x'/>"), None);
}
