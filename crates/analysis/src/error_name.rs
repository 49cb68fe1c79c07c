//! Names of columns that hold the standard errors of another column: `sigma_y`, `y_err`, `u(y)`, `dy`, `±`.

/// Column to which the errors of a name belong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Belongs<'a> {
    /// The column of this name.
    To(&'a str),
    /// The column of this name, if its numbers can be errors: `dy` and `Δy` are often differences.
    Perhaps(&'a str),
    /// The column before.
    ToPrevious,
}

/// Prefixes of the name.
const BEFORE: [&str; 27] = [
    "sigma_",
    "sigma ",
    "σ_",
    "σ",
    "err_",
    "error_",
    "err ",
    "error of ",
    "error in ",
    "error de ",
    "unc_",
    "sd_",
    "std_",
    "se_",
    "stderr_",
    "uncertainty of ",
    "uncertainty in ",
    "uncertainty_",
    "incertidumbre de ",
    "incertidumbre_",
    "fehler von ",
    "fehler_",
    "fehler ",
    "unsicherheit ",
    "standard error of ",
    "±",
    "+/-",
];
/// Prefixes of the name, followed by a closing parenthesis.
const AROUND: [&str; 7] = ["u(", "σ(", "sigma(", "err(", "error(", "std(", "sd("];
/// Suffixes of the name.
const BEHIND: [&str; 22] = [
    "_err",
    "_error",
    "_sigma",
    "_std",
    "_sd",
    "_se",
    "_unc",
    "_stderr",
    "_fehler",
    " err",
    " err.",
    " error",
    " sd",
    " std",
    " se",
    " uncertainty",
    " incertidumbre",
    " fehler",
    "-fehler",
    " standard error",
    " ±",
    "±",
];
/// Names without that of another column.
const ALONE: [&str; 17] = [
    "±",
    "+/-",
    "+-",
    "error",
    "err",
    "err.",
    "sigma",
    "σ",
    "uncertainty",
    "incertidumbre",
    "fehler",
    "unsicherheit",
    "std",
    "sd",
    "stderr",
    "standard error",
    "error estándar",
];

/// Column whose standard errors a column of this name holds; `None` for other names.
pub(crate) fn of(name: &str) -> Option<Belongs<'_>> {
    let name = name.trim();
    let lower = name.to_lowercase();
    if ALONE.contains(&lower.as_str()) {
        return Some(Belongs::ToPrevious);
    }
    let begin =
        |sign: &str| name.get(..sign.len()).filter(|first| first.to_lowercase() == sign).map(|_| &name[sign.len()..]);
    let end = |sign: &str| {
        let at = name.len().checked_sub(sign.len())?;
        name.get(at..).filter(|last| last.to_lowercase() == sign).and_then(|_| name.get(..at))
    };
    let filled = |rest: &&str| !rest.trim().is_empty();
    let around = AROUND.iter().find_map(|sign| begin(sign)?.strip_suffix(')'));
    let certain = around
        .or_else(|| BEFORE.iter().find_map(|sign| begin(sign)))
        .or_else(|| BEHIND.iter().find_map(|sign| end(sign)))
        .or_else(|| name.strip_suffix("err").filter(|rest| rest.chars().count() == 1));
    if let Some(rest) = certain.filter(filled) {
        return Some(Belongs::To(rest.trim()));
    }
    let differences = ["Δ", "∆", "delta_", "Delta_", "delta ", "Delta ", "d"];
    differences.iter().find_map(|sign| name.strip_prefix(sign)).filter(filled).map(|rest| Belongs::Perhaps(rest.trim()))
}

#[cfg(test)]
mod tests {
    use super::Belongs::{Perhaps, To, ToPrevious};
    use super::*;

    #[test]
    fn errors_are_known_by_many_names() {
        for (name, expected) in [
            ("sigma_y", Some(To("y"))),
            ("σ_x", Some(To("x"))),
            ("σx", Some(To("x"))),
            ("u(y)", Some(To("y"))),
            ("err_y", Some(To("y"))),
            ("y_err", Some(To("y"))),
            ("yerr", Some(To("y"))),
            ("y error", Some(To("y"))),
            ("error de y", Some(To("y"))),
            ("± y", Some(To("y"))),
            ("y ±", Some(To("y"))),
            ("±", Some(ToPrevious)),
            ("Error", Some(ToPrevious)),
            ("dy", Some(Perhaps("y"))),
            ("Δy", Some(Perhaps("y"))),
            ("y", None),
            ("d", None),
            ("v_x", None),
        ] {
            assert_eq!(of(name), expected, "{name}");
        }
    }
}
