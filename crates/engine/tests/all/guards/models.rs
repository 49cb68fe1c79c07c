//! Models whose equations have a value on one side of a corner only, behind a guard, for tests of several crates.

/// Exponents of a vessel that runs empty.
const EXPONENTS: [f64; 3] = [0.5, 0.3, 0.75];

/// A model of dimensionless numbers.
pub struct Guarded {
    /// The model.
    pub text: String,
    /// Time of its first corner, about.
    pub corner: f64,
}

/// The power `p` of h where h > 0, and 0 elsewhere, written with each guard.
fn guards(p: f64) -> [String; 8] {
    [
        format!("max(h, 0)^{p}"),
        format!("(-min(-h, 0))^{p}"),
        format!("(if h > 0 then h^{p} else 0)"),
        format!("(if h >= 0 then h^{p} else 0)"),
        format!("(if h <= 0 then 0 else h^{p})"),
        format!("sign(h)*abs(h)^{p}"),
        format!("(if floor(h) >= 0 then h^{p} else 0)"),
        format!("(0.5 + 0.5*sign(h))*exp({p}*ln(max(h, 1e-300)))"),
    ]
}

/// Vessels that run empty: h' = -h^p from h = 1 has the solution (1 - (1 - p) t)^(1/(1 - p)) until h = 0. Each has an event `n` before,
/// at or after the corner.
pub fn vessels() -> Vec<(f64, Guarded)> {
    let mut found = Vec::new();
    for p in EXPONENTS {
        let corner = 1.0 / (1.0 - p);
        for (number, guard) in guards(p).into_iter().enumerate() {
            let event = ["h < 0.25".to_owned(), "h <= 1e-8".to_owned(), format!("t > {}", corner + 0.35)];
            let text = format!(
                "independent t\nparameter c = 1\nh' = -c*{guard}\nh(0) = 1\ndiscrete n = 0\nwhen {} {{ n = n + 1 }}",
                event[(number + (10.0 * p) as usize) % 3]
            );
            found.push((p, Guarded { text, corner }));
        }
    }
    found
}

/// Other corners: roots, logarithms and arcsines of one and two states.
pub fn others() -> Vec<Guarded> {
    let model = |corner: f64, text: &str| Guarded { text: format!("independent t\nparameter c = 1\n{text}"), corner };
    vec![
        model(
            1.0,
            "d = a - b\na' = -0.5*c*sign(d)*sqrt(abs(d))\nb' = 0.5*sign(d)*sqrt(abs(d))\na(0) = 1.5\nb(0) = 1.25",
        ),
        model(
            1.0,
            "a' = if a > b then -0.5*c*sqrt(a - b) else 0.5*sqrt(b - a)\nb' = if a > b then 0.5*sqrt(a - b) else -0.5*sqrt(b - a)\n\
             a(0) = 1.5\nb(0) = 1.25",
        ),
        model(1.7, "h[i]' = -c*i*sqrt(max(h[i], 0)) for i in 1..2\nh[1](0) = 1\nh[2](0) = 3"),
        model(1.44, "x' = -c*acos(max(-1, min(1, 1 - x)))\nx(0) = 1"),
        model(0.75, "x' = -0.4*c - 0.3*asin(min(1, max(-1, 2*x)))\nx(0) = 1"),
        model(1.2, "x' = -c*(4 + ln(max(x, 0.05)))/3\nx(0) = 1"),
        model(0.9, "x' = -c - log10(max(x, 1e-3))/4\nx(0) = 1"),
        model(1.0, "x' = if x > 0 then -c - sqrt(x) else -0.2\nx(0) = 1.5"),
        model(1.57, "x'' = -c*sign(x)*sqrt(abs(x))\nx(0) = 0.6\nx'(0) = 0"),
        model(0.5, "y'' = 100*max(-y, 0)^1.5 - c\ny(0) = 0.1\ny'(0) = 0"),
        model(0.5, "y'' = (if y < 0 then 100*(-y)*sqrt(-y) else 0) - c\ny(0) = 0.1\ny'(0) = 0"),
        model(1.05, "x'' = -c*x + 0.1*asin(min(1, max(-1, 2*x)))\nx(0) = 1\nx'(0) = 0"),
        model(0.0, "x'' = -c*x - 0.02*x'/sqrt(abs(x') + 1e-6)\nx(0) = 1\nx'(0) = 0"),
        model(0.0, "y'' = c + (if y <= 0 then 100*(-y)^1.5 else -1.5*y)\ny(0) = 0\ny'(0) = 0"),
    ]
}

/// Two tanks that level through a pipe, with the flow written with each guard, inflows that pass through 0 or end, and two widths of the
/// pipe. Where the inflow is 0, the levels are equal up to rounding.
pub fn tanks() -> Vec<Guarded> {
    let flows = [
        "if a >= b then k*sqrt(a - b) else -k*sqrt(b - a)",
        "if a > b then k*sqrt(a - b) else -k*sqrt(b - a)",
        "k*sqrt(max(a - b, 0)) - k*sqrt(max(b - a, 0))",
        "k*sign(a - b)*sqrt(abs(a - b))",
    ];
    let inflows = ["0", "0.02*sin(0.3*t)", "0.01*max(sin(0.3*t), 0)", "if t < 20 then 0.01 else 0"];
    let mut found = Vec::new();
    for flow in flows {
        for inflow in inflows {
            for (width, corner) in [("0.03", 29.8), ("0.3", 2.98)] {
                let text = format!(
                    "independent t\nparameter k = {width}\nflow = {flow}\na' = {inflow} - flow\nb' = flow\na(0) = 1\nb(0) = 0.2"
                );
                found.push(Guarded { text, corner });
            }
        }
    }
    found
}
