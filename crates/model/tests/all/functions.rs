//! User-defined functions.

use crate::common::{At, assert_near, compile, quantity_value};

/// A call compiles to the same nodes as its expansion, so the results are bit-identical.
#[test]
fn a_call_is_the_body_with_its_arguments() {
    let equations = |drag: &str| {
        format!(
            "parameter rho = 1.2 [kg/m^3]\nparameter eta = 18 [uPa s]\nparameter d = 4 [cm]\nparameter m = 3 [g]\n\
             m*x'' = -{drag}*x'\nx(0) = 0 [m]\nx'(0) = 2 [m/s]\n"
        )
    };
    let functions = "function Re(v, d) = rho*abs(v)*d/eta\n\
        function drag(v) = if Re(v, d) < 2 then 3*pi*eta*d else c(Re(v, d))*rho*d^2*abs(v)\n\
        function c(number) = 24/number + 0.4\n";
    let with = compile(&(functions.to_owned() + &equations("drag(x')")));
    let re = "(rho*abs(x')*d/eta)";
    let written = format!("(if {re} < 2 then 3*pi*eta*d else (24/{re} + 0.4)*rho*d^2*abs(x'))");
    let without = compile(&equations(&written));
    assert_eq!(with.graph.len(), without.graph.len());
    for speed in [-3.0, 1e-6, 0.4] {
        let [one, other] = [&with, &without]
            .map(|model| At::new(model, 0.0, &[0.0, speed]).value(&model.graph, model.states[1].derivative));
        assert_eq!(one.to_bits(), other.to_bits());
    }
}

/// An argument hides a name of the model, but only inside the function.
#[test]
fn arguments_hide_names_of_the_model() {
    let model = compile("a = 2\nb = 3\nfunction f(a) = a*b\nfunction g(b, a) = f(b) - a\nx = f(10) + a\ny = g(a, b)");
    assert_near(quantity_value(&model, &[], "x"), 32.0);
    assert_near(quantity_value(&model, &[], "y"), 3.0);
}

#[test]
fn a_function_takes_texts_conditions_and_quantities_with_their_derivatives() {
    let model = compile(
        "function chosen(c, a, b) = if c then a else b\nfunction power(F, s) = F*s'\n\
         x' = -2 [1/s]*x\nx(0) = 3 [m]\nP = power(4 [N], x) in [W]\n\
         t_0 = chosen(P > 0 [W], 1, f(0))\nfunction f(x) = cos(x) + 4\nway = chosen(x > 1 [m], \"far\", \"near\")\n",
    );
    let quantity = |name: &str| quantity_value(&model, &[3.0], name);
    assert_near(quantity("P"), -24.0);
    assert_near(quantity("t_0"), 5.0);
    assert_eq!(model.texts[quantity("way") as usize], "far");
}

/// The word is not reserved: it can still be a name.
#[test]
fn the_word_stays_a_name() {
    let model = compile("function = 2\nx = 3*function\n");
    assert_near(quantity_value(&model, &[], "x"), 6.0);
}
