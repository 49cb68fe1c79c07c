//! Parts of a scene: their SVG elements.

use engine::Readings;
use program::{Child, Element, Program, write_attribute};

const MODEL: &str = "```model\nparameter l = 2 [m] in 1..3\nx' = 0 [m/s]\nx(0) = 0.5 [m]\ntheta' = 0 [1/s]\n\
                     theta(0) = 0.5 [rad]\n```\n\n";
/// 100 units per metre; the origin is at (200, 200).
const FRAME: &str = "<frame x='-2..2 [m]' y='-1..2 [m]'>";

fn open(scene: &str) -> (Program, Vec<String>) {
    let source = format!("{MODEL}```scene\n<svg viewBox='0 0 400 300'>{scene}</svg>\n```\n");
    let opened = document::open(&source, &["---\nlanguage: es\ntranslates: a.md\ntitle: B\n---\n"]);
    let found = opened.diagnostics.iter().filter(|(file, _)| *file == 0);
    let found = found.map(|(_, one)| one.message.english()).collect();
    (opened.document.expect("the model is good").program, found)
}

fn print(element: &Element, values: &[f64]) -> String {
    let mut text = format!("<{}", element.name);
    for attribute in &element.attributes {
        let mut value = String::new();
        assert!(write_attribute(&attribute.value, values, &mut value), "{attribute:?} {values:?}");
        text += &format!(" {}={value}", attribute.name);
    }
    text += ">";
    for child in &element.children {
        match child {
            Child::Element(child) => text += &print(child, values),
            Child::Text(template) => {
                for piece in template {
                    if let program::Piece::Literal(literal) = piece {
                        text += literal;
                    }
                }
            }
        }
    }
    text + ";"
}

fn drawn(scene: &str, language: &str) -> String {
    let (program, found) = open(scene);
    assert_eq!(found, [""; 0], "{scene}");
    let scene = program.scene(language).expect("a scene");
    let nodes: Vec<_> = scene.values.iter().map(|value| value.node).collect();
    let state = [0.5, 0.5];
    print(&scene.root, Readings::new(&program.model, &nodes).at(&[2.0], &state, 0.0, &state))
}

/// Elements of a part in a frame, for x = 0.5 m and theta = 0.5.
fn check(part: &str, expected: &str) {
    let drawn = drawn(&format!("{FRAME}{part}</frame>"), "en");
    assert!(drawn.contains(expected), "{part}\nhas   {drawn}\nwants {expected}");
}

#[test]
fn a_spring_goes_from_one_point_to_the_other() {
    check(
        "<spring from='(-1 [m], 0)' to='(x, 0)' turns='1' width='10px'/>",
        "<g fill=none stroke=currentColor stroke-width=2 stroke-linejoin=round role=img><title>Spring;\
         <g transform=translate(100 200) rotate(0)><path d=M0 0h50l12.5 -5l25 10l12.5 -5h50>;;;",
    );
    // Straight down.
    check("<spring from='(0, x)' to='(0, -x)' turns='2'/>", "translate(200 150) rotate(90)");
}

#[test]
fn parts_stand_where_they_are_placed_and_are_as_large_as_said() {
    check("<block at='(x, 0)' size='(40 [cm], 20px)'/>", "<rect rx=3 x=230 y=190 width=40 height=20>;");
    check("<bob at='(x, l/2)' r='5 [cm]' fill='liquid'/>", "<g fill=var(--liquid, #3f9fc0) stroke=currentColor");
    check("<bob at='(x, l/2)' r='5 [cm]'/>", "<circle cx=250 cy=100 r=5>;");
    check("<wheel at='(0, 0)' r='10px' turn='90 [deg]'/>", "translate(200 200) rotate(-90)");
    check("<rod from='(0, 0)' to='(x, -1 [m])'/>", "<line x1=200 y1=200 x2=250 y2=300>;");
    check("<ramp from='(0, 0)' to='(1 [m], 1 [m])'/>", "d=M200 200L300 100V200Z");
    check("<tube from='(0, 0)' to='(0, 1 [m])' width='20 [cm]' level='x'/>", "y=-10 width=50 height=20");
    check("<switch from='(0, 0)' to='(1 [m], 0)' closed='x < l'/>", "translate(-16 0) rotate(0)");
    check("<switch from='(0, 0)' to='(1 [m], 0)' closed='x > l'/>", "translate(-16 0) rotate(-28)");
}

/// An arrow ends at the sum of its point and its vector; outside frames y points down.
#[test]
fn arrows_are_as_long_as_their_vectors() {
    check(
        "<arrow at='(0, 0)' vector='2*(x, 0)'/>",
        "<line x2=90>;<path d=M0 0L-13-5.5L-13 5.5Z stroke=none transform=translate(100 0) scale(1)>;",
    );
    check("<arrow at='(0, 0)' vector='(0 [m], 0)'/>", "scale(0)");
    let plain = drawn("<arrow at='(10, 20)' vector='(0, 30*x/l)' stroke='mark'/>", "en");
    assert!(plain.contains("translate(10 20) rotate(90)"), "{plain}");
}

/// The smaller arc between two angles, counterclockwise: large-arc 0, sweep 0.
#[test]
fn an_angle_is_an_arc_between_two_directions() {
    check("<angle at='(0, 0)' from='0' to='90 [deg]' r='10px'/>", "d=M210 200A10 10 0 0 0 200 190");
    check("<angle at='(0, 0)' from='0' to='-270 [deg]' r='10px'/>", "A10 10 0 1 1 200 190");
}

#[test]
fn axes_cross_at_the_origin_and_are_numbered_in_the_unit_of_their_step() {
    let axes = drawn(&format!("{FRAME}<axes x='-1..2 [m]' y='-1..2 [m]' step='50 [cm]'/></frame>"), "en");
    // Two lines with seven marks each.
    assert_eq!(axes.matches("<line").count(), 16, "{axes}");
    for line in ["<line x1=100 y1=200 x2=400 y2=200>", "<line x1=200 y1=300 x2=200 y2=0>"] {
        assert!(axes.contains(line), "{axes}");
    }
    for (number, count) in [(">-100;", 2), (">50;", 2), (">200 cm;", 2), (">0;", 0)] {
        assert_eq!(axes.matches(number).count(), count, "{number}: {axes}");
    }
    // Axes cross at the nearest ends if 0 is in no range.
    let beside = drawn(&format!("{FRAME}<axes x='1..2 [m]' y='-1..-0.5 [m]' step='0.5 [m]'/></frame>"), "es");
    assert!(beside.contains("<title>Ejes;") && beside.contains("<line x1=300 y1=250 x2=400 y2=250>"), "{beside}");
}

#[test]
fn a_ruler_has_marks_at_its_steps_and_numbers_in_its_unit() {
    let ruler = drawn(&format!("{FRAME}<ruler from='(0, 0)' to='(1 [m], 0)' step='20 [cm]'/></frame>"), "en");
    assert_eq!(ruler.matches("<line").count(), 7, "{ruler}");
    assert!(ruler.contains(">0;") && ruler.contains(">100 cm;"), "{ruler}");
    let about_zero = "<ruler from='(-1 [m], 0)' to='(1 [m], 0)' step='20 [cm]' first='-1 [m]'/>";
    let ruler = drawn(&format!("{FRAME}{about_zero}</frame>"), "en");
    assert!([">-100;", ">0;", ">100 cm;"].iter().all(|number| ruler.contains(number)), "{ruler}");
}

#[test]
fn a_part_has_a_name_in_the_language_of_the_reader() {
    let scene =
        format!("{FRAME}<bob at='(x, 0)' drag='x'><title>Ball</title></bob><coil from='(0, 0)' to='(x, 0)'/></frame>");
    assert!(drawn(&scene, "en").contains("<title>Ball;") && drawn(&scene, "en").contains("<title>Coil;"));
    assert!(drawn(&scene, "es").contains("<title>Ball;") && drawn(&scene, "es").contains("<title>Bobina;"));
}

#[test]
fn what_a_part_lacks_is_said() {
    let refused = |part: &str, message: &str| {
        let (_, found) = open(&format!("{FRAME}{part}</frame>"));
        assert_eq!(found, [message], "{part}");
    };
    refused("<spring from='(0, 0)'/>", "`<spring>` needs `to`");
    refused("<spring from='(0, 0)' to='(x, 0)' turns='1000'/>", "this must be a whole number from 1 to 60");
    refused(
        "<ruler from='(0, 0)' to='(x, 0)' step='1 [cm]'/>",
        "a ruler has from 1 to 200 marks, and their number never changes",
    );
    refused("<axes x='-1..2 [m]' y='0..x' step='1 [m]'/>", "the ends of axes never change");
    refused("<axes x='-1..2 [m]' y='0..1 [m]' step='1 [mm]'/>", "each axis has 100 marks at most");
    refused(
        "<axes x='0..2 [s]' y='0..1 [m]' step='1 [m]'/>",
        "a length in a frame must have the dimension of its axes",
    );
    refused("<ruler from='(0, 0)' to='(1 [m], 0)' step='10 [cm]' first='x'/>", "the numbers of a ruler never change");
    refused("<block at='(0, 0)' size='(1, 1 [m])'/>", "a length in a frame must have the dimension of its axes");
    refused("<switch from='(0, 0)' to='(x, 0)' closed='x'/>", "`closed` needs a condition");
    for address in
        ["https://example.org/x.png", "data:image/svg+xml;base64,AA", "data:image/png;base64,A\"", "javascript:x"]
    {
        refused(
            &format!("<image at='(0, 0)' size='(9px, 9px)' href='{address}'/>"),
            "a picture of a scene must stand in the document itself",
        );
    }
    refused(
        "<block at='(x, 0)' size='(9px, 9px)' onclick='x'/>",
        "the attribute `onclick` is not allowed in a scene; it is left out",
    );
}

#[test]
fn the_size_of_a_drawing_is_bounded() {
    let many = "<ruler from='(0, 0)' to='(1 [m], 0)' step='1 [cm]'/>".repeat(400);
    let (program, found) = open(&format!("{FRAME}{many}</frame>"));
    assert_eq!(found, ["there are too many parts in this scene"]);
    assert!(program.scene("en").is_some());
}

/// The words between the parts of a plot or of a claim can be names of quantities.
#[test]
fn connecting_words_are_names_too() {
    for name in ["at", "from", "every", "by", "of", "within"] {
        let source = format!(
            "---\nuntil: 5\nstep: 0.1\n---\n\n```model\nindependent t\nparameter k = 1 in 0..2\n{name}' = -k*{name}\n{name}(0) = 1\n```\n\n```plots\n\"A\": {name}, 2*{name} against t\n\"B\": t against {name}\n\
             \"C\": {name} at end against k in 1..2\n\"D\": maximum({name}) from 1 against k in 1..2\n\"E\": points {name} against {name} every 1 from 2\n```\n\n\
             ```check\n\"F\": {name} < 2 always\n\"G\": {name} within 1 % of {name} at end\n\"H\": 1 + {name} > {name} at 1\n```\n"
        );
        let opened = document::open(&source, &[]);
        let errors = opened.diagnostics.iter().filter(|(_, found)| found.severity == model::Severity::Error);
        let errors: Vec<String> = errors.map(|(_, found)| found.message.english()).collect();
        assert_eq!(errors, [""; 0], "{name}");
        let program = opened.document.unwrap().program;
        assert_eq!((program.plots.len(), program.checks.iter().map(|check| check.claims.len()).sum::<usize>()), (5, 3));
    }
}
