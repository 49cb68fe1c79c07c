//! Methods of EJS.

/// Method of the document for one of EJS, and true if it is the same method.
pub(crate) fn method_of(method: &str) -> (&'static str, bool) {
    match method.trim() {
        "Euler" => ("euler", true),
        "EulerRichardson" | "MidPoint" | "Midpoint" => ("euler-richardson", true),
        // Velocity-Verlet needs equations of second order; those of EJS are of first order.
        "VelocityVerlet" | "Verlet" => ("rk4", false),
        "RungeKutta" | "RungeKutta4" | "" => ("rk4", true),
        "DormandPrince45" | "DormandPrince" | "DormandPrince5" => ("dormand-prince", true),
        _ => ("dormand-prince", false),
    }
}
