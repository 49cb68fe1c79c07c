//! Switches and choices.

use crate::common::{At, assert_near, compile};
use program::{Choices, Kind};

const SPHERE: &str = "switch drag = on \"With drag\"\n\
    parameter rho_own = 5 [kg/m^3]\n\
    choice liquid \"Liquid\" {\n\
        \"Water\":     rho = 998 [kg/m^3], eta = 1 [mPa s]\n\
        \"Glycerine\": rho = 1261 [kg/m^3], eta = 1.41 [Pa s]\n\
        \"My own\":    rho = rho_own,\n            eta = 2*rho_own*(1 [m^2/s])\n\
    }\n\
    m = 1 [kg]\n\
    m*v' = -(if drag then eta*(1 [m])*v else 0)\n\
    v(0) = 1 [m/s]\n\
    own = liquid == \"My own\"\n";

#[test]
fn alternatives_define_quantities() {
    let model = compile(SPHERE);
    let liquid = &model.parameters[2];
    assert_eq!((liquid.name.as_str(), liquid.label.as_deref()), ("liquid", Some("Liquid")));
    assert_eq!(liquid.words(&model.texts), ["Water", "Glycerine", "My own"]);
    let quantity = |name: &str| model.quantities.iter().find(|quantity| quantity.name == name).unwrap();
    assert_eq!(
        (quantity("rho").value.unit.text.as_str(), quantity("eta").value.unit.text.as_str()),
        ("kg/m^3", "mPa s")
    );
    for (text, rho, eta, own) in
        [("Water", 998.0, 1e-3, 0.0), ("Glycerine", 1261.0, 1.41, 0.0), ("My own", 5.0, 10.0, 1.0)]
    {
        let mut at = At::new(&model, 0.0, &[1.0]);
        at.parameters[2] = liquid.chosen(text, &model.texts).unwrap();
        assert_near(at.value(&model.graph, quantity("rho").value.node), rho);
        assert_near(at.value(&model.graph, quantity("eta").value.node), eta);
        assert_near(at.value(&model.graph, quantity("own").value.node), own);
        assert_near(at.value(&model.graph, model.states[0].derivative), -eta);
        at.parameters[0] = 0.0;
        assert_near(at.value(&model.graph, model.states[0].derivative), 0.0);
    }
}

/// A label and `hidden` in one alternative hold for the quantity.
#[test]
fn what_a_choice_defines_is_labelled_and_hidden() {
    let model = compile(
        "choice liquid {\n\"Water\": rho = 998 [kg/m^3] \"Density\", c = 1480 [m/s]\n\
         \"Oil\": rho = 900 [kg/m^3], hidden c = 1300 [m/s] \"Speed of sound\"\n}\n",
    );
    let shown = |name: &str| {
        let quantity = model.quantities.iter().find(|quantity| quantity.name == name).unwrap();
        (quantity.label.as_deref(), quantity.hidden)
    };
    assert_eq!(shown("rho"), (Some("Density"), false));
    assert_eq!(shown("c"), (Some("Speed of sound"), true));
}

#[test]
fn a_switch_is_a_truth_value_and_a_choice_a_text() {
    let model = compile(SPHERE);
    let drag = &model.parameters[0];
    assert_eq!((drag.value, &drag.choices, drag.label.as_deref()), (1.0, &Choices::Switch, Some("With drag")));
    let kinds = ["drag", "liquid", "rho_own"].map(|name| model.lookup(name, 0).unwrap().kind);
    assert_eq!(kinds, [Kind::Truth, Kind::Text, Kind::Number]);
    assert_eq!(
        (drag.chosen("off", &[]), drag.chosen("perhaps", &[]), drag.word(1.0, &[])),
        (Some(0.0), None, Some("on"))
    );
    assert!(drag.takes(1.0) && !drag.takes(0.5));
}

/// The words are not reserved: they can still be names.
#[test]
fn the_words_stay_names() {
    let model = compile("choice = 2\nswitch = 3*choice\non = 2\n");
    assert_eq!(model.quantities.len(), 3);
}

/// A discrete quantity can also be a text or a truth value; the state behind it is hidden.
#[test]
fn a_discrete_quantity_can_be_a_text_or_a_truth_value() {
    let model = compile(
        "discrete phase = \"rise\" \"Phase\"\ndiscrete moving = true\nhidden discrete count = 0\ny' = 1 [m/s]\ny(0) = 0 [m]\n\
         when y > 1 [m] { phase = if moving then \"fall\" else \"rest\", moving = not moving, count = count + 1 }\n",
    );
    let names: Vec<(String, program::Role)> = model.states.iter().map(|state| (state.name(), state.role)).collect();
    let role = |name: &str| names.iter().find(|(own, _)| own == name).map(|(_, role)| *role);
    assert_eq!(role("y"), Some(program::Role::Own));
    assert_eq!(role("count"), Some(program::Role::Hidden));
    assert_eq!(role("phase so far"), Some(program::Role::Remembered));
    let phase = model.quantities.iter().find(|quantity| quantity.name == "phase").unwrap();
    assert_eq!((phase.value.kind, phase.label.as_deref(), phase.varies), (Kind::Text, Some("Phase"), true));
    assert_eq!(model.lookup("moving", 0).unwrap().kind, Kind::Truth);
    let place = |name: &str| model.states.iter().position(|state| state.name() == name).unwrap();
    let mut states = vec![0.0; model.states.len()];
    for (number, text) in [(0.0, "rise"), (1.0, "fall"), (2.0, "rest")] {
        states[place("phase so far")] = number;
        let value = At::new(&model, 0.0, &states).value(&model.graph, phase.value.node);
        assert_eq!(model.texts[value as usize], text);
    }
}
