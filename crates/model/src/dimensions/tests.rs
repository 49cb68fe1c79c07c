//! The dimensions of a family are checked once, regardless of the number of its members.

use super::infer::INFERRED;
use crate::compile;

/// Number of types inferred during the check of a model, and its diagnostics.
fn inferred(model: &str, members: usize) -> (usize, Vec<(&'static str, String)>) {
    let source = model.replace("MEMBERS", &members.to_string());
    let before = INFERRED.get();
    let part = 0..source.len();
    let (_, diagnostics) = compile(&source, std::slice::from_ref(&part));
    let told = diagnostics.iter().map(|one| (one.code, one.message.english())).collect();
    (INFERRED.get() - before, told)
}

const BODIES: &str = "independent t in [s]
size N = MEMBERS
parameter G = 1 [m^3/(kg s^2)]
parameter m = 1 [kg]
s = 1 [m]
r[i]'' = sum(G*m*(r[j] - r[i])/(norm(r[j] - r[i])^2 + s^2)^1.5 for j in 1..N) for i in 1..N
r[i](0) = (i, i^2, 0) [m] for i in 1..N
r[i]'(0) = (0, 0, 0) [m/s] for i in 1..N
";

const CHAIN: &str = "independent t in [s]
size N = MEMBERS
parameter k = 1 [N/m]
parameter m = 1 [kg]
d[i] = x[i+1] - x[i] for i in 0..N
F[i] = k*d[i]*(1 + (d[i]/(2 [m]))^2) for i in 0..N
x[0] = 0 [m]
x[N+1] = 0 [m]
E[i] = m*x[i]'^2/2 in [J] for i in 1..N
m*x[i]'' = F[i] - F[i-1] for i in 1..N
x[i](0) = i*(1 [cm]) for i in 1..N
x[i]'(0) = 0 for i in 1..N
";

#[test]
fn a_family_is_checked_once() {
    for model in [BODIES, CHAIN] {
        let (few, told) = inferred(model, 5);
        assert_eq!(told, []);
        assert_eq!(inferred(model, 25), (few, vec![]));
    }
}

/// A mismatch in a single member is found.
#[test]
fn each_member_that_differs_is_checked() {
    for (model, code) in [
        (
            "independent t in [s]\nparameter a = 1 [m]\nx[i]' = a^i/(1 [s]) for i in 1..4\nx[i](0) = 0 [m] for i in 1..4",
            "dimension-mismatch",
        ),
        (
            "independent t in [s]\nparameter a = 1 [m]\nb[1] = a\nb[2] = a^2\nb[3] = a\nx[i]' = b[i]/(1 [s]) for i in 1..3\nx[i](0) = a for i in 1..3",
            "dimension-mismatch",
        ),
        (
            "independent t in [s]\nn[1] = 1\nn[2] = 2\nparameter a = 1 [m]\nx[i]' = a^n[i]/(1 [s]) for i in 1..2\nx[i](0) = a for i in 1..2",
            "dimension-mismatch",
        ),
        ("independent t in [s]\nparameter a = 1 [m]\nparameter b = 1 [s]\ny = sum(a, a, b)", "dimension-mismatch"),
    ] {
        let (_, told) = inferred(model, 0);
        assert!(told.iter().any(|(found, _)| *found == code), "{model}: {told:?}");
    }
    // Zeros with different dimensions.
    let apart = "independent t in [s]\na = 0\nb = 0\nx' = a + 1 [m/s]\ny' = b + 1 [kg/s]\nx(0) = 0\ny(0) = 0";
    assert_eq!(inferred(apart, 0).1, []);
}
