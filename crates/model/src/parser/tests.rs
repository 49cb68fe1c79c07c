//! Syntax trees of valid texts. Invalid texts are in `tests/syntax_errors.rs`.

mod printed;

use crate::{StatementKind, parse, parse_assignments, parse_expression};
use printed::{in_unit, shown, shown_statement};

fn statements(source: &str) -> Vec<String> {
    let (statements, diagnostics) = parse(source, std::slice::from_ref(&(0..source.len())));
    assert!(diagnostics.is_empty(), "{source}: {diagnostics:?}");
    statements.iter().map(shown_statement).collect()
}

#[test]
fn operators_bind_as_in_a_textbook() {
    for (source, tree) in [
        ("a + b*c", "(a+(b*c))"),
        ("a - b - c", "((a-b)-c)"),
        ("a/b*c", "((a/b)*c)"),
        ("a/(b*c)", "(a/(b*c))"),
        ("-x^2", "(-(x^2))"),
        ("2^-3", "(2^(-3))"),
        ("2^-x^2", "(2^(-(x^2)))"),
        ("a^b^c", "(a^(b^c))"),
        ("(a^b)^c", "((a^b)^c)"),
        ("-a*b", "((-a)*b)"),
        ("a*-b", "(a*(-b))"),
        ("a - -b", "(a-(-b))"),
        ("+a", "a"),
        ("y''^2", "(y''^2)"),
        ("m*y'^2/2", "((m*(y'^2))/2)"),
        ("a < b and b < c or not d > e", "(((a<b) and (b<c)) or (not (d>e)))"),
        ("not not a < b", "(not (not (a<b)))"),
        ("a or b and c", "(a or (b and c))"),
        ("a + 1 < b*2", "((a+1)<(b*2))"),
        ("a == b", "(a==b)"),
        ("if a < b then c else d + 1", "(if (a<b) then c else (d+1))"),
        ("1 + if a < b then c else d", "(1+(if (a<b) then c else d))"),
        (
            "if b < c then \"under\" else if b == c then \"critical\" else \"over\"",
            "(if (b<c) then \"under\" else (if (b==c) then \"critical\" else \"over\"))",
        ),
        ("sin(omega*t + delta)", "sin(((omega*t)+delta))"),
        ("atan2(y, x)", "atan2(y, x)"),
        ("f()", "f()"),
        ("exp(0)", "exp(0)"),
        ("y(0) + y'(0)", "(y@0+y'@0)"),
        ("y(0.0)", "y@0"),
        ("9.8 [m/s^2]*2", "(9.8[m/s^2]*2)"),
        ("2e3 + 1.5E-3 + .5", "((2000+0.0015)+0.5)"),
        ("2*e", "(2*e)"),
        ("1[m]^2", "(1[m]^2)"),
    ] {
        let (expression, unit, diagnostics) = parse_expression(source, 0..source.len());
        assert!(diagnostics.is_empty() && unit.is_none(), "{source}: {diagnostics:?}");
        assert_eq!(shown(&expression), tree, "{source}");
        assert_eq!(expression.span.range(), 0..source.len(), "{source}");
    }
}

#[test]
fn unicode_is_read_as_its_ascii_spelling() {
    for (source, tree) in [
        ("γ·ω₀", "(gamma*omega_0)"),
        ("−2×π", "((-2)*pi)"),
        ("y″ + y′ + y’", "((y''+y')+y')"),
        ("x²", "(x^2)"),
        ("x⁻¹", "(x^-1)"),
        ("-x²", "(-(x^2))"),
        ("2*x³*y", "((2*(x^3))*y)"),
        ("y'²/2", "((y'^2)/2)"),
        ("√(g/L)", "sqrt((g/L))"),
        ("√2*a", "(sqrt(2)*a)"),
        ("a ≤ b", "(a<=b)"),
        ("a ≥ b", "(a>=b)"),
        ("a ≠ b", "(a!=b)"),
        ("hₗ - h_l", "(h_l-h_l)"),
        ("x₁₂", "x_12"),
        ("ω_₀", "omega_0"),
        ("Δx", "Deltax"),
        ("φ + ϕ", "(phi+phi)"),
        ("a÷b", "(a/b)"),
        ("5 [µm]", "5[µm]"),
        ("a\u{a0}+\u{2009}b", "(a+b)"),
    ] {
        let (expression, _, diagnostics) = parse_expression(source, 0..source.len());
        assert!(diagnostics.is_empty(), "{source}: {diagnostics:?}");
        assert_eq!(shown(&expression), tree, "{source}");
    }
}

#[test]
fn each_kind_of_statement_is_read() {
    for (source, statement) in [
        (
            "parameter rho = 1000 [kg/m^3] in 50..13600 step 50 \"Density of the liquid\"",
            "parameter rho=1000 in [kg/m^3] 50..13600 step 50 \"Density of the liquid\"",
        ),
        ("parameter n = -3", "parameter n=-3"),
        ("parameter v_0 = 0 [m/s] in -5..5", "parameter v_0=0 in [m/s] -5..5"),
        ("parameter step = 2 in 0..4 step 0.5", "parameter step=2 0..4 step 0.5"),
        ("independent x in [m]", "independent x in [m]"),
        ("independent x \"Place\"", "independent x \"Place\""),
        ("L = 2 [m] + h_l + h_r \"Length\"", "L := ((2[m]+h_l)+h_r) \"Length\""),
        ("T = m*y'^2/2 in [J]", "T := ((m*(y'^2))/2) in [J]"),
        ("y(0) = h in [cm] \"Displacement\"", "y@0 := h in [cm] \"Displacement\""),
        ("y'(0) = v_0", "y'@0 := v_0"),
        ("function f(x) = 2*x", "function f(x) := (2*x)"),
        ("function Re(v, d) = v*d/nu in [m] \"Number\"", "function Re(v, d) := ((v*d)/nu) in [m] \"Number\""),
        ("switch drag = on \"Drag\"", "switch drag=1 \"Drag\""),
        ("switch drag = false", "switch drag=0"),
        (
            "choice c \"C\" {\n  \"A\": a = 1 [m], b = 2\n  \"B\":\n a = 3,\n b = 4 }",
            "choice c \"C\" {\"A\": a := 1[m], b := 2; \"B\": a := 3, b := 4}",
        ),
        (
            "choice c { \"A\": hidden a = 1 in [m] \"Length\", b = 2\n\"B\": a = 3, b = 4 }",
            "choice c {\"A\": hidden a := 1 \"Length\", b := 2; \"B\": a := 3, b := 4}",
        ),
        ("choice c\n{ \"A\": a = 1; \"B\": a = 2 }", "choice c {\"A\": a := 1; \"B\": a := 2}"),
        ("function(x) = 2*x", "function(x) = (2*x)"),
        ("function = 2", "function := 2"),
        ("m*y'' + b*y' = 0", "((m*y'')+(b*y')) = 0"),
        ("y'' = -g*y/L", "y'' = (((-g)*y)/L)"),
        ("0 = m*y''", "0 = (m*y'')"),
        ("(m) = 1 [kg]", "m = 1[kg]"),
        ("regime = \"text\"", "regime := \"text\""),
        ("regime = if a < b then \"x\" else \"y\" \"Regime\"", "regime := (if (a<b) then \"x\" else \"y\") \"Regime\""),
        ("when y < 0 [m] { y' = -e*y' }", "when (y<0[m]) {y' := ((-e)*y')}"),
        (
            "when y < 0 [m] {\n  y' = 0 [m/s]\n\n  y = 0 [m]; z = 1, w = 2\n}",
            "when (y<0[m]) {y' := 0[m/s]; y := 0[m]; z := 1; w := 2}",
        ),
        ("when a < b\n{ y = 1 } \"Kick\"", "when (a<b) {y := 1} \"Kick\""),
    ] {
        assert_eq!(statements(source), [statement], "{source}");
    }
}

#[test]
fn a_statement_ends_with_its_line() {
    for (source, expected) in [
        ("a = 1\nb = 2", vec!["a := 1", "b := 2"]),
        ("a = 1 # one\r\n\r\n# nothing\r\nb = 2\r\n", vec!["a := 1", "b := 2"]),
        ("a = 1 +\n    2 # two\nb = 3", vec!["a := (1+2)", "b := 3"]),
        ("a = (1\n + 2\n)\nb = 3", vec!["a := (1+2)", "b := 3"]),
        ("a =\n 1", vec!["a := 1"]),
        ("a = max(1,\n 2)", vec!["a := max(1, 2)"]),
        ("a = if b < c then\n 1 else\n 2", vec!["a := (if (b<c) then 1 else 2)"]),
        ("a = b\n-c = d", vec!["a := b", "(-c) = d"]),
        ("y = 1 \"a # b\"", vec!["y := 1 \"a # b\""]),
        ("a = b and\n # why\n not c", vec!["a := (b and (not c))"]),
        ("", vec![]),
        ("# only a comment", vec![]),
    ] {
        assert_eq!(statements(source), expected, "{source}");
    }
}

#[test]
fn several_fences_are_one_model_with_places_in_the_document() {
    let source = "ab = 1\ntext between\ncd = 2\n";
    let (read, diagnostics) = parse(source, &[0..6, 20..26]);
    assert!(diagnostics.is_empty(), "{diagnostics:?}");
    let places: Vec<_> = read.iter().map(|statement| &source[statement.span.range()]).collect();
    assert_eq!(places, ["ab = 1", "cd = 2"]);
}

#[test]
fn places_are_exact() {
    let source = "  parameter ω₀ = -3 [1/s] in 0..5 \"W\"  # c\n y''(0) = 1 + ω₀*x in [m]";
    let (read, _) = parse(source, std::slice::from_ref(&(0..source.len())));
    let StatementKind::Parameter(parameter) = &read[0].kind else { panic!() };
    let at = |span: crate::Span| &source[span.range()];
    assert_eq!(at(read[0].span), "parameter ω₀ = -3 [1/s] in 0..5 \"W\"");
    assert_eq!(at(parameter.name.span), "ω₀");
    assert_eq!(at(parameter.value_span), "-3");
    assert_eq!(at(parameter.unit.as_ref().unwrap().span), "[1/s]");
    assert_eq!(at(parameter.range.as_ref().unwrap().span), "0..5");
    assert_eq!(at(read[0].label.as_ref().unwrap().span), "\"W\"");
    let StatementKind::InitialValue { name, value, unit, .. } = &read[1].kind else { panic!() };
    assert_eq!(at(name.span), "y");
    assert_eq!(at(value.span), "1 + ω₀*x");
    assert_eq!(at(unit.as_ref().unwrap().span), "[m]");
}

#[test]
fn expressions_of_the_document_may_state_a_unit() {
    let source = "{2*pi/\nomega in [ms]}";
    let (expression, unit, diagnostics) = parse_expression(source, 1..source.len() - 1);
    assert!(diagnostics.is_empty(), "{diagnostics:?}");
    assert_eq!(shown(&expression) + &in_unit(&unit), "((2*pi)/omega) in [ms]");
}

#[test]
fn assignments_are_separated_by_commas_semicolons_or_lines() {
    let source = "rho = 13534 [kg/m^3], b = 2*m*omega_0; h = 1 in [cm]\nc = 3";
    let (read, diagnostics) = parse_assignments(source, 0..source.len());
    assert!(diagnostics.is_empty(), "{diagnostics:?}");
    let shown: Vec<_> =
        read.iter().map(|a| format!("{}={}{}", a.name.text, shown(&a.value), in_unit(&a.unit))).collect();
    assert_eq!(shown, ["rho=13534[kg/m^3]", "b=((2*m)*omega_0)", "h=1 in [cm]", "c=3"]);
}

#[test]
fn families() {
    for (source, statement) in [
        ("size N = 20 in 2..200 \"Masses\"", "size N=20 2..200 \"Masses\""),
        ("m*x[i]'' = k*(x[i-1] - 2*x[i]) for i in 1..N", "(m*x[i]'') = (k*(x[(i-1)]-(2*x[i]))) for i in 1..N"),
        ("x[0] = 0 [m]", "Definitions x[0] := 0[m]"),
        (
            "x[i](0) = A*sin(pi*i/(N+1)) in [cm] for i in 1..N \"Place\"",
            "InitialValues x[i]@0 := (A*sin(((pi*i)/(N+1)))) in [cm] for i in 1..N \"Place\"",
        ),
        ("x[i]'(0) = 0 for i in 1..N", "InitialValues x[i]'@0 := 0 for i in 1..N"),
        ("u[i, j+1]' = 0 for i in 1..N, j in i+1..M", "u[i, (j+1)]' = 0 for i in 1..N for j in (i+1)..M"),
        ("E = sum(m*x[i]'^2/2 for i in 1..N) + 1", "E := (sum(((m*(x[i]'^2))/2) for i in 1..N)+1)"),
        ("discrete n[i] = 0 for i in 1..3", "Discrete n[i] := 0 for i in 1..3"),
        (
            "when x[i] < 0 { x[i]' = -x[i]', v = 0; y[j] = 1 for j in 1..2 } for i in 1..N",
            "when (x[i]<0) {x[i]' := (-x[i]'); v := 0; y[j] := 1 for j in 1..2} for i in 1..N",
        ),
        ("size = 3", "size := 3"),
        ("for = 2*sum", "for := (2*sum)"),
    ] {
        assert_eq!(statements(source), [statement], "{source}");
    }
}

#[test]
fn tables() {
    for (source, expected) in [
        ("table a(t) { 0 1, 2 3 }", "Linear a(t) {0 1, 2 3}"),
        ("table a(t) { 0 -1  -2 3e-2 }", "Linear a(t) {0 -1, -2 0.03}"),
        (
            "smooth table eta(T) in [mPa s] \"Viscosity\" { 273 [K] 1.792\n293 1 [Pa s] }",
            "Smooth eta(T in [K]) in [mPa s] {273 1.792, 293 1000}",
        ),
        (
            "steps table n(x)\n{ 0 [m] 2 [1/m]; 1 [km] 3 } \"Lines\"",
            "Steps n(x in [m]) in [1/m] {0 2, 1000 3} \"Lines\"",
        ),
        ("table a(t)\n0 [s] 1\n\n2 3", "Linear a(t in [s]) {0 1, 2 3}"),
        ("table = 2*steps", "table := (2*steps)"),
    ] {
        assert_eq!(statements(source), [expected], "{source}");
    }
}
