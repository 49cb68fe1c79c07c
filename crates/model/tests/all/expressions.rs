//! Expressions of documents, compiled against a model.

use crate::common::{At, compile, render};
use program::{Compiled, Kind, Model};

const OSCILLATOR: &str = "parameter m = 2 [kg]\nparameter k = 50 [N/m]\nm*y'' + k*y = 0\n\
    y(0) = 3 [cm] in [cm]\ny'(0) = 0 in [cm/s]\nomega_0 = sqrt(k/m)\nT = 2*pi/omega_0 in [s]\nE = m*y'^2/2 + k*y^2/2 in [J]\n\
    stiff = k > 10 [N/m]\n";

fn expression(model: &mut Model, text: &str) -> Result<Compiled, String> {
    let (expression, unit, diagnostics) = model::parse_expression(text, 0..text.len());
    assert!(diagnostics.is_empty(), "{}", render(text, &diagnostics));
    model::Compiler::new(model).compile(&expression, unit.as_ref()).map_err(|diagnostics| render(text, &diagnostics))
}

#[test]
fn values_units_and_kinds() {
    let mut model = compile(OSCILLATOR);
    let at = At::new(&model, 1.5, &[0.02, -0.1]);
    for (text, kind, unit, expected) in [
        ("y", Kind::Number, "cm", 0.02),
        ("y'", Kind::Number, "cm/s", -0.1),
        ("y''", Kind::Number, "m/s^2", -0.5),
        ("y'''", Kind::Number, "m/s^3", 2.5),
        ("t", Kind::Number, "s", 1.5),
        ("m", Kind::Number, "kg", 2.0),
        ("T", Kind::Number, "s", 2.0 * std::f64::consts::PI / 5.0),
        ("E", Kind::Number, "J", 0.02),
        ("E'", Kind::Number, "W", 0.0),
        ("y(0)", Kind::Number, "cm", 0.03),
        ("E(0)", Kind::Number, "J", 0.0225),
        ("2*E(0)", Kind::Number, "J", 0.045),
        ("2*y in [mm]", Kind::Number, "mm", 0.04),
        ("0", Kind::Number, "", 0.0),
        ("0 in [m]", Kind::Number, "m", 0.0),
        ("stiff", Kind::Truth, "", 1.0),
        ("y < 0 [m]", Kind::Truth, "", 0.0),
    ] {
        let compiled = expression(&mut model, text).unwrap_or_else(|error| panic!("{text}: {error}"));
        assert_eq!((compiled.kind, compiled.unit.text.as_str()), (kind, unit), "{text}");
        crate::common::assert_near(at.value(&model.graph, compiled.node), expected);
    }
    let text = expression(&mut model, "if y > 0 then \"up\" else \"down\"").unwrap();
    assert_eq!(text.kind, Kind::Text);
    assert_eq!(model.texts[at.value(&model.graph, text.node) as usize], "up");
}

#[test]
fn errors() {
    let mut model = compile(OSCILLATOR);
    for (text, expected) in [
        (
            "omega0*t",
            "error [unknown-name]: `omega0` is not known\n  1: `omega0`\n  hint: did you mean `omega_0`?\n  fix: replace `omega0` by `omega_0`\n",
        ),
        (
            "y + t",
            "error [dimension-mismatch]: the term `t` lacks a factor with the dimension of velocity\n  1: `t`: a time\n  1: `y`: a length\n  | the term `t`     s  time\n  | the term `y`  m     length\n  hint: multiply it by a velocity\n",
        ),
        (
            "E in [N]",
            "error [dimension-mismatch]: `E` has one length too many for the stated unit [N]\n  1: `E`: an energy\n  1: `[N]`: a force\n  | `E`  kg  m^2  s^-2  energy\n  | [N]  kg  m    s^-2  force\n  hint: divide it by a length\n  hint: or state the unit that it has: [J]\n  fix: replace `[N]` by `[J]`\n",
        ),
    ] {
        assert_eq!(expression(&mut model, text).unwrap_err(), expected, "{text}");
    }
}

#[test]
fn what_names_stand_for() {
    let model = compile(OSCILLATOR);
    assert_eq!(model.lookup("y", 1).unwrap().unit.text, "cm/s");
    assert_eq!(model.lookup("y", 2).unwrap().unit.text, "m/s^2");
    assert!(model.lookup("y", 3).is_none());
    assert!(model.lookup("E", 1).is_none());
    assert!(model.lookup("z", 0).is_none());
    assert_eq!(model.lookup("t", 0).unwrap().unit.text, "s");
}

#[test]
fn what_values_depend_on() {
    let mut model = compile(OSCILLATOR);
    let dependence = |model: &mut Model, text: &str| {
        let compiled = expression(model, text).unwrap();
        model.depends(compiled.node)
    };
    let energy = dependence(&mut model, "E");
    assert_eq!((energy.parameters.as_slice(), energy.states.as_slice()), (&[0, 1][..], &[0, 1][..]));
    assert!(energy.varies() && !energy.independent);
    assert!(!dependence(&mut model, "T").varies());
    assert_eq!(dependence(&mut model, "y(0)").initial, [0]);
    assert!(dependence(&mut model, "omega_0*t").independent);
}
