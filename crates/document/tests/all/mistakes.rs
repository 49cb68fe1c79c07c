//! Wrong settings, and statements as other programs have them: place, reason, and a remedy that works when it is applied.
//!
//! The mistakes are in `mistakes.txt`, one per line, as changes of one valid document. The first remedies are applied one
//! after the other, and the document is opened again. A line without a mended text has advice only.

use document::edit::apply;
use document::open;
use model::Diagnostic;
use std::path::Path;

/// A document in which every change of `mistakes.txt` is possible.
const BASE: &str = r#"---
title: Spring
language: en
method: rk4
step: 0.01 [s]
until: 10 [s]
speed: 2 [s]
tolerance: 1e-6
---

```model
parameter m = 0.5 [kg] in 0.1..2 "Mass"
parameter k = 20 [N/m] in 1..100 "Stiffness"
m*y'' = -k*y
y(0) = 10 [cm] "Displacement"
y'(0) = 0 "Velocity"
discrete n = 0 "Passages"
when y < 0 [m] { n = n + 1 }
E = m*y'^2/2 + k*y^2/2 in [J] "Energy"
T = 2*pi*sqrt(m/k) "Period"
```

```presets
"Heavy": m = 2 [kg]
```

```question
Measure the period.

answer: T within 3 %
```
"#;

/// Most remedies applied to one mistake.
const MOST: usize = 3;

fn findings(text: &str) -> Vec<Diagnostic> {
    open(text, &[]).diagnostics.into_iter().map(|(_, found)| found).collect()
}

/// Error in the report of a mistake, or `None`.
fn problem(line: &str) -> Option<String> {
    let whole = format!("{line} ");
    let fields: Vec<&str> = whole.split(" | ").map(str::trim).collect();
    let [before, after, place, message, mended] = fields.as_slice() else {
        return Some("it has not five fields".to_owned());
    };
    if BASE.matches(before).count() != 1 {
        return Some("the base document has this once".to_owned());
    }
    let wrong = BASE.replacen(before, &after.replace('¶', "\n"), 1);
    let mut found = findings(&wrong);
    let Some(first) = found.first() else { return Some("nothing is said".to_owned()) };
    let at = &wrong[first.span().range()];
    if at.trim() != *place || first.message.english() != *message {
        return Some(format!("{at} | {}", first.message.english()));
    }
    if mended.is_empty() {
        return (first.hints.is_empty() || !first.fixes.is_empty()).then(|| "it has no advice, or a remedy".to_owned());
    }
    let mut text = wrong;
    for _ in 0..MOST {
        let Some(fix) = found.first().and_then(|found| found.fixes.first()) else { break };
        text = apply(&text, &fix.edits).ok()?;
        found = findings(&text);
    }
    if let Some(left) = found.first() {
        return Some(format!("left is: {} {:?}", left.message.english(), &text[left.span().range()]));
    }
    let expected = BASE.replacen(before, &mended.replace('¶', "\n"), 1);
    let differing = text.lines().zip(expected.lines()).find(|(text, expected)| text != expected);
    differing.map(|(line, _)| format!("the remedy gives {line:?}"))
}

#[test]
fn mistakes_have_place_reason_and_a_remedy_that_works() {
    assert_eq!(findings(BASE), []);
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/all/mistakes.txt");
    let text = std::fs::read_to_string(file).unwrap();
    let lines: Vec<&str> = text.lines().filter(|line| line.contains(" | ")).collect();
    let problems: Vec<String> =
        lines.iter().filter_map(|line| Some(format!("{line}\n    {}", problem(line)?))).collect();
    println!("{} of {} mistakes", lines.len() - problems.len(), lines.len());
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    let mended = lines.iter().filter(|line| !line.ends_with('|')).count();
    assert!(mended >= 50 && lines.len() - mended <= 9, "{mended} of {}", lines.len());
}

/// The start of a state becomes a parameter, which is then set.
#[test]
fn a_start_that_is_set_becomes_a_parameter() {
    let wrong = BASE.replacen("m = 2 [kg]", "y = 2 [m]", 1);
    let found = findings(&wrong);
    assert_eq!(found.len(), 1, "{found:?}");
    let text = apply(&wrong, &found[0].fixes[0].edits).unwrap();
    assert!(text.contains("\nparameter y_0 = 10 [cm]\ny(0) = y_0 \"Displacement\"\n"), "{text}");
    assert!(text.contains("\"Heavy\": y_0 = 2 [m]\n") && findings(&text).is_empty(), "{text}");
    // If it is one already, that one is named.
    let own =
        BASE.replacen("y(0) = 10 [cm]", "parameter a = 10 [cm]\ny(0) = a", 1).replacen("m = 2 [kg]", "y = 2 [m]", 1);
    let found = findings(&own);
    let text = apply(&own, &found[0].fixes[0].edits).unwrap();
    assert!(text.contains("\"Heavy\": a = 2 [m]\n") && findings(&text).is_empty(), "{text}");
}
