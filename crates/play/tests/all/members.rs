//! A family stands in one line with a picker for its member; likewise a vector.

use crate::support::{go_on, open};
use play::{Index, Play, Readout};

/// A chain between walls, a plate and two bodies in the plane.
fn several() -> Play {
    open(
        "---\nstep: 0.01 [s]\nlanguage: en\n---\n```model\nsize N = 4 in 2..200\n\
         x[i]'' = 4 [1/s^2]*(x[i-1] - 2*x[i] + x[i+1]) for i in 1..N\nx[0] = 0 [m] \"Wall\"\nx[N+1] = 0 [m] \"Wall\"\n\
         x[i](0) = i*1 [m] for i in 1..N \"Displacement\"\nx[i]'(0) = i*0.1 [m/s] for i in 1..N\n\
         E[i] = x[i]^2/(2 [m^2]) for i in 1..N \"Energy\"\nk[i] = i^2 for i in 1..N \"Square\"\n\
         u[i, j]' = -u[i, j]/(1 [s]) for i in 1..3, j in i..3\nu[i, j](0) = 10*i + j for i in 1..3, j in i..3 \"Heat\"\n\
         r[i]'' = -r[i]/(1 [s^2]) for i in 1..2\nr[i](0) = (i, 2*i) [m] for i in 1..2 \"Position\"\n\
         r[i]'(0) = 0 for i in 1..2 \"Velocity\"\nc = sum(r[i] for i in 1..2)/2 in [cm] \"Centre\"\n\
         B = (0, 3) [T] \"Field\"\n```\n",
        &["---\nlanguage: es\ntranslates: a.md\n---\n```translations\n\"Position x\" = \"Posición x\"\n\
           \"Position y\" = \"Posición y\"\n\"Field x\" = \"Componente x del campo\"\n\"Field y\" = \"Componente y del campo\"\n\
           \"Displacement\" = \"Desplazamiento\"\n\"Wall\" = \"Pared\"\n\"Energy\" = \"Energía\"\n\"Square\" = \"Cuadrado\"\n\
           \"Heat\" = \"Calor\"\n\"Velocity x\" = \"Velocidad x\"\n\"Velocity y\" = \"Velocidad y\"\n\
           \"Centre x\" = \"Centro x\"\n\"Centre y\" = \"Centro y\"\n```\n"],
    )
}

fn shown(play: &mut Play, family: &str) -> Readout {
    let is_meant = |one: &Readout| one.members.as_ref().is_some_and(|members| members.name == family);
    play.readouts().into_iter().find(is_meant).expect("the family has a line")
}

#[test]
fn each_family_and_each_vector_has_one_line() {
    let mut play = several();
    let lines: Vec<(String, String, String, String)> =
        play.readouts().into_iter().map(|one| (one.name, one.label, one.value, one.unit)).collect();
    let expected = [
        ("t", "", "0.00", "s"),
        ("x[1]", "Displacement", "1.000", "m"),
        ("x[1]'", "", "0.1000", "m/s"),
        ("u[1,1]", "Heat", "11.00", ""),
        ("r[1]", "Position", "(1.000, 2.000)", "m"),
        ("r[1]'", "Velocity", "(0, 0)", "m/s"),
        ("E[1]", "Energy", "0.5000", ""),
        ("k[1]", "Square", "1", ""),
        ("c", "Centre", "(150.0, 300.0)", "cm"),
        ("B", "Field", "(0, 3)", "T"),
    ];
    let lines: Vec<_> = lines.iter().map(|(a, b, c, d)| (a.as_str(), b.as_str(), c.as_str(), d.as_str())).collect();
    assert_eq!(lines, expected);
    let states: Vec<(String, String)> =
        play.values().state_lines().into_iter().map(|one| (one.name, one.text)).collect();
    let states: Vec<_> = states.iter().map(|(name, text)| (name.as_str(), text.as_str())).collect();
    let expected = [
        ("x", "1.000"),
        ("x'", "0.1000"),
        ("u", "11.00"),
        ("r.x", "1.000"),
        ("r.x'", "0"),
        ("r.y", "2.000"),
        ("r.y'", "0"),
    ];
    assert_eq!(states.iter().map(|(name, _)| *name).collect::<Vec<_>>(), expected.map(|(name, _)| name));
    assert_eq!(states[..3], expected[..3]);
    play.set_language("es");
    let labels: Vec<String> = play.readouts().into_iter().map(|one| one.label).collect();
    assert_eq!(labels[4], "Posición");
    assert_eq!(labels[9], "Componente del campo");
    let field = play.readouts().pop().expect("the field is the last line");
    assert_eq!((field.value.as_str(), field.symbol.contains('→')), ("(0; 3)", true));
}

#[test]
fn a_member_is_chosen_for_all_lines_of_its_family() {
    let mut play = several();
    let before = play.revision();
    play.change_values(|values| values.choose_member("x'", 0, 3));
    assert_ne!(play.revision(), before, "the page shows it");
    assert_eq!(shown(&mut play, "x").value, "3.000");
    assert_eq!(shown(&mut play, "x'").value, "0.3000");
    assert_eq!(play.values().state_lines()[0].text, "3.000");
    // The walls are members of the family, too. They have no velocity, so the nearest member is shown there.
    play.change_values(|values| values.choose_member("x", 0, 0));
    let wall = shown(&mut play, "x");
    assert_eq!((wall.label.as_str(), wall.value.as_str()), ("Wall", "0"));
    assert_eq!(shown(&mut play, "x'").members.unwrap().indices, [Index { value: 1, least: 1, greatest: 4 }]);
    play.change_values(|values| values.choose_member("x", 0, 99));
    assert_eq!(shown(&mut play, "x").members.unwrap().indices, [Index { value: 5, least: 0, greatest: 5 }]);
    // Two indices: the range of the second depends on the first.
    play.change_values(|values| values.choose_member("u", 1, 3));
    play.change_values(|values| values.choose_member("u", 0, 3));
    let heat = shown(&mut play, "u");
    assert_eq!(heat.value, "33.00");
    let index = |value, least, greatest| Index { value, least, greatest };
    assert_eq!(heat.members.unwrap().indices, [index(3, 1, 3), index(3, 3, 3)]);
    // A name that is not a family changes nothing.
    let before = play.revision();
    for (name, place) in [("c", 0), ("nothing", 0), ("x", 7), ("", 0)] {
        play.change_values(|values| values.choose_member(name, place, 2));
    }
    assert_eq!(play.revision(), before);
}

#[test]
fn the_member_shown_can_be_set_and_the_choice_is_no_part_of_a_link() {
    let mut play = several();
    play.change_values(|values| values.choose_member("x", 0, 2));
    assert_eq!(play.share(), "");
    let line = play.values().state_lines().remove(0);
    play.change_settings(|settings| settings.set_state_text(line.index, "7.5")).unwrap();
    assert_eq!(shown(&mut play, "x").value, "7.500");
    let second = play.values().states().into_iter().find(|state| state.name == "x[2]").unwrap();
    assert_eq!(second.value, 7.5);
    // Another program with this family keeps the selection.
    let program = play.program().clone();
    play.replace_program(program);
    assert_eq!(shown(&mut play, "x").members.unwrap().indices[0].value, 2);
    go_on(&mut play, [0.1]);
    assert_eq!(shown(&mut play, "x").name, "x[2]");
    // Files have one column per member, also for defined vectors.
    let head = play.values().csv().lines().next().unwrap_or_default().to_owned();
    for column in ["x[1] [m]", "x[4] [m]", "\"u[1,2]\"", "r[2].y [m]", "c.x [cm]", "E[3]"] {
        assert!(head.split(',').any(|one| one == column) || head.contains(column), "{column} in {head}");
    }
}
