//! Vectors, expanded to components.

use crate::common::{At, assert_near, compile, quantity_value};
use program::Model;

/// Rate of change of each state, for these values of the states.
fn rates(model: &Model, states: &[f64]) -> Vec<f64> {
    let at = At::new(model, 0.0, states);
    model.states.iter().map(|state| at.value(&model.graph, state.derivative)).collect()
}

fn names(model: &Model) -> Vec<String> {
    model.states.iter().map(program::State::name).collect()
}

/// A vector expression compiles to the same nodes as its expansion, so the results are bit-identical.
#[test]
fn an_orbit_has_the_bits_of_its_components() {
    let parameters = "parameter GM = 1.327e20 [m^3/s^2]\nparameter v_0 = 30 [km/s]\n";
    let vector = compile(&format!(
        "{parameters}r'' = -GM*r/norm(r)^3\nr(0) = (1, 0) [km]\nr'(0) = (0, v_0)\nE = norm(r')^2/2 - GM/norm(r)\nL = cross(r, r')"
    ));
    let single = compile(&format!(
        "{parameters}x'' = -GM*x/sqrt(x^2 + y^2)^3\ny'' = -GM*y/sqrt(x^2 + y^2)^3\nx(0) = 1 [km]\ny(0) = 0 [km]\n\
         x'(0) = 0 [m/s]\ny'(0) = v_0\nE = sqrt(x'^2 + y'^2)^2/2 - GM/sqrt(x^2 + y^2)\nL = x*y' - y*x'"
    ));
    assert_eq!(names(&vector), ["r.x", "r.x'", "r.y", "r.y'"]);
    assert_eq!(vector.graph.len(), single.graph.len());
    let states = [1.1e11, -2.3e4, 0.7e11, 1.9e4];
    let bits = |values: Vec<f64>| values.into_iter().map(f64::to_bits).collect::<Vec<_>>();
    assert_eq!(bits(rates(&vector, &states)), bits(rates(&single, &states)));
    for name in ["E", "L"] {
        assert_eq!(
            quantity_value(&vector, &states, name).to_bits(),
            quantity_value(&single, &states, name).to_bits(),
            "{name}"
        );
    }
    let initial = |model: &Model| {
        let at = At::new(model, 0.0, &states);
        model.states.iter().map(|state| at.value(&model.graph, state.initial)).collect::<Vec<_>>()
    };
    assert_eq!(bits(initial(&vector)), bits(initial(&single)));
}

#[test]
fn components_are_told_apart_in_labels_and_are_no_hidden_states() {
    let model = compile("r' = -r\nindependent t\nr(0) = (1, 2) \"Position (au)\"\nv = 2*r \"Speed\"\n");
    assert_eq!(model.states[1].label.as_deref(), Some("Position y (au)"));
    assert!(model.states.iter().all(|state| state.role == program::Role::Own));
    assert_eq!(model.quantities[0].label.as_deref(), Some("Speed x"));
    assert_eq!(model.quantities[0].name, "v.x");
}

/// A literal 0 in a vector has the dimension of the other components; it is also the zero vector.
#[test]
fn zero_has_the_dimension_of_the_vector() {
    let model = compile(
        "parameter B_0 = 2 [T]\nparameter q = 3 [C]\nparameter m = 5 [kg]\nparameter v_0 = 7 [m/s]\nB = (0, 0, B_0)\n\
         m*r'' - q*cross(r', B) = 0\nr(0) = (0, 0, 0) in [m]\nr'(0) = (v_0, 0, 1 [m/s])\nF = if q > 0 [C] then q*cross(r', B) else 0",
    );
    assert_eq!(
        rates(&model, &[0.0, 7.0, 0.0, -4.0, 0.0, 1.0]),
        [7.0, 6.0 * -4.0 / 5.0, -4.0, -6.0 * 7.0 / 5.0, 1.0, 0.0]
    );
    let unit = |name: &str| model.quantities.iter().find(|quantity| quantity.name == name).unwrap().value.unit.clone();
    assert_eq!(unit("B.x").dimension, unit("B.z").dimension);
    assert_near(quantity_value(&model, &[0.0, 7.0, 0.0, -4.0, 0.0, 1.0], "F.y"), -42.0);
}

#[test]
fn products_follow_their_definitions() {
    let model = compile(
        "a = (1, 2, 3)\nb = (-4, 5, 0.5)\nc = cross(a, b)\nd = dot(a, b)\nn = norm(a)\ne = dot(a, c)\nf = cross((1, 2), (3, 4))\n\
         g = (a - 2*b/4).y + cross(a, b).x\nh = -a.z",
    );
    let of = |name: &str| quantity_value(&model, &[], name);
    assert_eq!(["c.x", "c.y", "c.z"].map(of), [2.0 * 0.5 - 3.0 * 5.0, 3.0 * -4.0 - 0.5, 5.0 + 8.0]);
    assert_eq!([of("d"), of("e"), of("f")], [7.5, 0.0, -2.0]);
    assert_near(of("n"), 14.0_f64.sqrt());
    assert_near(of("g"), -0.5 - 14.0);
    assert_near(of("h"), -3.0);
}

/// Vectors through definitions, choices, functions with components of their arguments, and members of families.
#[test]
fn what_follows_from_a_vector_is_one() {
    let model = compile(
        "size N = 3\nindependent t\n\
         function pull(r, s) = (s - r)/norm(s - r)^3\nfunction turned(r) = (-r.y, r.x)\nfunction product(a, b) = dot(a, b)\n\
         x[i]'' = sum(if i == j then 0 else pull(x[i], x[j]) for j in 1..N) + G for i in 1..N\n\
         x[i](0) = (i, i^2) for i in 1..N\nx[i]'(0) = 0 for i in 1..N\n\
         choice field { \"Down\": G = (0, -1)\n \"None\": G = 0 }\n\
         c = sum(x[i] for i in 1..N)/N\nturn = turned(c)\nw = product(c, turn)\nwhen x[i].y < -5 { x[i].y' = -x[i].y', x[i] = 0 } for i in 1..N\ns = x[2].y + c.x + x[3].x'",
    );
    assert_eq!(names(&model)[..4], ["x[1].x", "x[1].x'", "x[1].y", "x[1].y'"]);
    let states = [1.0, 0.0, 1.0, 0.0, 2.0, 0.0, 4.0, 0.0, 3.0, 0.5, 9.0, 0.0];
    assert_near(quantity_value(&model, &states, "c.y"), 14.0 / 3.0);
    assert_near(quantity_value(&model, &states, "turn.x"), -14.0 / 3.0);
    assert_near(quantity_value(&model, &states, "w"), 0.0);
    assert_near(quantity_value(&model, &states, "s"), 6.5);
    let distance = |x: f64, y: f64| libm::pow(x * x + y * y, 1.5);
    assert_near(rates(&model, &states)[3], 3.0 / distance(1.0, 3.0) + 8.0 / distance(2.0, 8.0) - 1.0);
}

/// Events set vectors, or single components, and remember them.
#[test]
fn events_set_vectors_and_components() {
    let model = compile(
        "parameter e = 0.5\nr'' = (0, -9.81) [m/s^2]\nr(0) = (0, 2) [m]\nr'(0) = (1, 0) [m/s]\n\
         when r.y < 0 [m] as landing { let u = -e*r', r' = u, r.x = 3 [m] }\n\
         when r.x > 5 [m] { r.x' = -r.x' }\nplace = landing.r\nfar = landing.r.x + landing.r'.x*1 [s]\ndiscrete p = (0, 0) [m]\n\
         when r.x < -5 [m] { r'.x = 0, p = r }\nmid = mean(r)\ntop = maximum(r.y)",
    );
    let changed = |event: usize| {
        let names = model.events[event].actions.iter().map(|action| model.states[action.0 as usize].name());
        names.filter(|name| !name.ends_with('.') && !name.contains(' ')).collect::<Vec<_>>()
    };
    assert_eq!(changed(0), ["r.x'", "r.y'", "r.x"]);
    assert_eq!(changed(1), ["r.x'"]);
    assert_eq!(changed(2), ["r.x'", "p.x", "p.y"]);
    assert!(model.quantities.iter().any(|quantity| quantity.name == "place.y"));
    assert!(model.quantities.iter().any(|quantity| quantity.name == "mid.x"));
}

/// The words are not reserved: they can still be names or functions.
#[test]
fn the_words_stay_names() {
    let model = compile("norm = 2\ndot = 3*norm\nfunction cross(a, b) = a*b + norm\nx = cross(dot, 2)\n");
    assert_near(quantity_value(&model, &[], "x"), 14.0);
    let model = compile("function norm(a, b) = a.x*b\nr = (2, 3)\nx = norm(r, 2)\n");
    assert_near(quantity_value(&model, &[], "x"), 4.0);
}

/// Initial values by components; all have one dimension.
#[test]
fn the_start_can_be_given_by_components() {
    let model = compile("independent t\nr' = (r.y, -r.x)\nr.x(0) = 1\nr.y(0) = 2\nd = norm(r - r(0)) + r(0).y");
    assert_eq!(names(&model), ["r.x", "r.y"]);
}
