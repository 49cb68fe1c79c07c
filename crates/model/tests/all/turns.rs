//! Cycles and angles: what a stated unit counts, where values are converted, and the remark about cycles in a sine.

use crate::common::{At, compile, diagnostics, quantity_value};
use std::f64::consts::TAU;

/// Units with their factors to turns per second.
const UNITS: [(&str, f64); 7] = [
    ("Hz", 1.0),
    ("kHz", 1e3),
    ("mHz", 1e-3),
    ("rad/s", 1.0 / TAU),
    ("rad/min", 1.0 / TAU / 60.0),
    ("deg/s", 1.0 / 360.0),
    ("rpm", 1.0 / 60.0),
];

/// Value of the quantity `q` of a model, in its unit.
fn value(source: &str) -> (f64, String) {
    let model = compile(source);
    let unit = model.quantities.iter().find(|quantity| quantity.name == "q").unwrap().value.unit.clone();
    (unit.from_si(quantity_value(&model, &[], "q")), unit.text)
}

#[test]
fn a_bare_name_is_converted_to_the_stated_unit_whatever_states_its_own() {
    for (from, own) in UNITS {
        for (to, other) in UNITS {
            for source in [
                format!("w = 3 [{from}]\nq = w in [{to}]"),
                format!("w = 3*1 [{from}] in [{from}]\nq = w in [{to}]"),
                format!("w = -3 [{from}]\nq = -w in [{to}]"),
                format!("q = 3 [{from}] in [{to}]"),
                // Also over another name, and what inherits the unit.
                format!("w = 3 [{from}]\nv = w\nq = v in [{to}]"),
                format!("a = 1 [{from}]\nw = max(a, 2*a) + a/1\nq = w in [{to}]"),
                format!("a = 3 [{from}]\nw = a*(1 + 0*t/(1 [s]))\nv = if a > 0 [1/s] then a else 2*a\nq = v in [{to}]"),
            ] {
                let (found, unit) = value(&source);
                assert!((found / (3.0 * own / other) - 1.0).abs() < 1e-14, "{source}\n{found} {unit}");
                assert_eq!(unit, to);
            }
            // The initial value of an unknown.
            let model = compile(&format!("w = 3 [{from}]\nx' = -x/(1 [s])\nx(0) = w in [{to}]\nq = x(0) in [{from}]"));
            let start = model.states[0].unit.from_si(At::new(&model, 0.0, &[0.0]).initial[0]);
            assert!((start / (3.0 * own / other) - 1.0).abs() < 1e-14, "{from} {to}: {start}");
        }
    }
    assert_eq!(value("w = 60 [rpm]\nq = w in [Hz]"), (1.0, "Hz".to_owned()));
    assert_eq!(value("w = 1 [Hz]\nq = w in [rpm]"), (60.0, "rpm".to_owned()));
}

/// The unit of the first alternative holds for all.
#[test]
fn numbers_of_alternatives_are_converted() {
    for (from, own) in UNITS {
        for (to, other) in UNITS {
            let source = format!("choice c {{\n    \"A\": q = 1 [{to}]\n    \"B\": q = 3 [{from}]\n}}");
            let model = compile(&source);
            let mut at = At::new(&model, 0.0, &[]);
            at.parameters[0] = model.parameters[0].chosen("B", &model.texts).unwrap();
            let found = model.quantities[0].value.unit.from_si(at.value(&model.graph, model.quantities[0].value.node));
            assert!((found / (3.0 * own / other) - 1.0).abs() < 1e-14, "{source}\n{found}");
        }
    }
}

/// A sum of many terms and a deep nesting count what their terms count.
#[test]
fn long_sums_are_followed() {
    let sum = vec!["f"; 200].join(" + ");
    assert_eq!(value(&format!("f = 1 [Hz]\nq = {sum}")), (200.0, "Hz".to_owned()));
    let nested = format!("{}f{}", "2*(".repeat(30), " + f)".repeat(30));
    assert_eq!(value(&format!("f = 1 [Hz]\nq = {nested}")).1, "Hz");
}

/// In an equation 1 rad is 1, and a unit stated for an expression converts nothing.
#[test]
fn expressions_are_not_converted() {
    for (source, expected, unit) in [
        ("w = 6 [rad/s]\nq = w/(2*pi) in [Hz]", 6.0 / TAU, "Hz"),
        ("T = 2 [s]\nq = 1/T in [Hz]", 0.5, "Hz"),
        ("T = 2 [s]\nq = 1/T in [rad/s]", 0.5, "rad/s"),
        ("T = 2 [s]\nq = 2*pi/T in [rad/s]", TAU / 2.0, "rad/s"),
        ("f = 3 [Hz]\nq = 2*pi*f in [rad/s]", 3.0 * TAU, "rad/s"),
        ("f = 3 [Hz]\nw = 2*pi*f\nq = w in [Hz]", 3.0 * TAU, "Hz"),
        ("f = 3 [Hz]\nw = 6.28*f\nq = w in [rad/s]", 18.84, "rad/s"),
        ("f = 3 [Hz]\nturn = 2*pi\nw = turn*f\nq = w in [rad/s]", 3.0 * TAU, "rad/s"),
        ("f = 3 [Hz]\nw = 360 [deg]*f\nq = w in [rad/s]", 3.0 * TAU, "rad/s"),
        ("w = 3 [rad/s]\nv = 2 [rad/s]\nq = w*(w/v) in [Hz]", 4.5, "Hz"),
        ("w = 3 [1/s]\nq = w in [Hz]", 3.0, "Hz"),
        ("w = 3 [Hz]\nq = w in [1/s]", 3.0, "1/s"),
        ("w = 3 [rad/s]\nq = w in [1/s]", 3.0, "1/s"),
        ("w = 3 [1/s]\nq = w in [rad/s]", 3.0, "rad/s"),
        ("w = 3 [rad/s]\nf = 2 [Hz]\nq = w + f", 5.0, "1/s"),
        ("M = 2 [N m]\nw = 3 [rad/s]\nq = M*w", 6.0, "W"),
        ("m = 2 [kg]\nw = 3 [rad/s]\nq = m*w", 6.0, "kg/s"),
        ("f = 2 [Hz]\nT = 3 [s]\nq = f*T", 6.0, ""),
    ] {
        let (found, stated) = value(source);
        assert!((found / expected - 1.0).abs() < 1e-14, "{source}\n{found}");
        assert_eq!(stated, unit, "{source}");
    }
}

#[test]
fn a_definition_without_a_unit_has_that_of_its_terms() {
    for (source, unit) in [
        ("f = 3 [Hz]\nq = 2*f", "Hz"),
        ("f = 3 [kHz]\nq = 2*f", "Hz"),
        ("f = 3 [kHz]\nq = f", "kHz"),
        ("q = 3 [kHz]", "kHz"),
        ("q = 60 [rpm]", "rpm"),
        ("f = 60 [rpm]\nq = f/2", "rad/s"),
        ("f = 3 [Hz]\nw = 2 [rad/s]\nq = f + w/(2*pi)", "Hz"),
        ("f = 3 [Hz]\nn = 2\nq = -n*f + 1 [1/s]", "Hz"),
        ("T = 3 [s]\nq = 1/T", "1/s"),
        ("q = 3 [1/min]", "1/s"),
        ("f = 3 [Hz]\nq = 2*pi*f", "1/s"),
        ("f = 3 [Hz]\nw = 2*pi*f\nq = 2*w", "1/s"),
        ("w = 3 [rad/s]\nq = w/6.28", "1/s"),
    ] {
        assert_eq!(value(source).1, unit, "{source}");
    }
}

#[test]
fn cycles_in_a_sine_are_remarked_on() {
    // The remark is about the quantity in «».
    for body in [
        "sin(«f»*t)",
        "cos(t*«f» + phi)",
        "cos(phi - 3*«f»*t)",
        "sin(2*(«f»*t + phi))",
        "sin(t/(2 [s])*«f»*s)",
        "if t > 1 [s] then 0 else 2*sin(«g»*t)",
        "sin(«3 [Hz]»*t)",
        "sin(«k»*t)",
        "sin(«h»*t)",
        "sin(«w»*t)",
        "sin(phase) + cos(«f»*t)",
    ] {
        let marked = format!(
            "parameter f = 3 [Hz]\nparameter k = 3 [kHz]\nphi = 0.2 [rad]\ns = 1 [s]\ng = 2*f\nh = f*(1 + t/s)\n\
             w = 6 [rad/s]*1 in [Hz]\nphase = 2*pi*f*t + phi\nq = {body}"
        );
        let (place, source) = (marked.find('«').unwrap(), marked.replace(['«', '»'], ""));
        let found = model::compile(&source, std::slice::from_ref(&(0..source.len()))).1;
        let [remark] = found.as_slice() else { panic!("{source}\n{found:?}") };
        assert_eq!((remark.code, remark.span().start), ("cycles-in-sine", place), "{source}");
        assert!(remark.hints.iter().any(|hint| hint.english().starts_with("write `2*pi*")), "{source}");
        // The fixes are applied.
        diagnostics(&source);
    }
    // A phase is followed to its definition.
    let text = diagnostics("parameter f = 3 [Hz]\nphase = f*t\nq = sin(phase)");
    assert!(text.contains("[cycles-in-sine]: `f` counts cycles, and a sine or cosine takes radians"), "{text}");
    for body in [
        "sin(2*pi*f*t)",
        "sin(f*t*2*pi)",
        "sin(pi*f*t)",
        "cos(6.283*f*t)",
        "sin(2*pi*(f*t + 0.1))",
        "sin(turn*f*t)",
        "sin(360 [deg]*f*t)",
        "sin(w*t)",
        "sin(w*t + 2*pi*f*t)",
        "sin(v*t)",
        "sin(t/(1 [s]))",
        "sin(f/(2 [Hz]))",
        "sin(r*t)",
        "exp(f*t)",
        "f*t*sin(1)",
        "sin(phase)",
    ] {
        let source = format!(
            "parameter f = 3 [Hz]\nparameter w = 3 [rad/s]\nparameter r = 3 [1/s]\nturn = 2*pi\nv = f in [rad/s]\n\
             phase = turn*f*t\nq = {body}"
        );
        assert_eq!(diagnostics(&source), "", "{source}");
    }
}
