//! Documents with one fault each, in English and Spanish: one message, at the right place, with a working fix.
//!
//! The faults are in `remedies.txt`, one per line, as changes of one valid document. Each fix is applied, and the document
//! is opened again.

use document::edit::apply;
use document::open;
use model::Diagnostic;
use std::path::Path;
use units::Language;

/// A document in which every change of `remedies.txt` is possible.
const BASE: &str = r#"---
title: Base
language: en
until: 10 [s]
---

```model
parameter alpha = 30 [deg] in 0..90 "Angle"
parameter phase = 0.5 [rad] in 0..3 "Phase"
parameter eta = 50 [%] in 0..100 "Efficiency"
parameter m = 200 [g] in 50..500 "Mass"
parameter k = 2 [N/m] in 1..9 "Stiffness"
function f(a) = 2*a
discrete n = 0 "Count"
discrete open = false
F = if t < 1 [s] then f(1 [N]) else 0 [N]
m*x'' = -k*x + F*eta*cos(alpha + phase)
theta'' = -9.81 [1/s^2]*sin(theta)
x(0) = 0 [m]
x'(0) = 0 [m/s]
theta(0) = 10 [deg] in [deg]
theta'(0) = 0 [1/s]
when x > 1 [m] and n < 5 as far { n = n + 1, open = true }
every 1 [s] { n = n + 1 }
button "Push" { theta = 5 [deg] }
r = x/(1 [m])
T = 3 [yr] in [d]
```

```plots
"Run": x against t
```

```presets
"Steep": alpha = 60 [deg], eta = 80 [%], m = 100 [g]
```

```question
How heavy is it?

answer: m within 2 %
```

```check
set: alpha = 45 [deg]
"Settles": r within 50 % of 2 at end
```
"#;

fn findings(text: &str) -> Vec<Diagnostic> {
    open(text, &[]).diagnostics.into_iter().map(|(_, found)| found).collect()
}

/// Error in the report of a fault, or `None`.
fn problem(line: &str) -> Option<String> {
    let fields: Vec<&str> = line.split(" | ").collect();
    let [language, code, before, after, place, number, mended] = fields.as_slice() else {
        return Some("it has not seven fields".to_owned());
    };
    let language = Language::of(language);
    if BASE.matches(before).count() != 1 {
        return Some("the base document has this once".to_owned());
    }
    let wrong = BASE.replacen(before, after, 1);
    let found = findings(&wrong);
    let [only] = found.as_slice() else {
        let said = found.iter().map(|found| format!("{}: {}", found.code, found.message.text(language)));
        return Some(format!("{} messages: {:?}", found.len(), said.collect::<Vec<_>>()));
    };
    if only.code != *code || &wrong[only.span().range()] != *place {
        return Some(format!("{} at `{}`", only.code, &wrong[only.span().range()]));
    }
    if only.message.english() == only.message.text(catalogues::with(Language::Spanish))
        || only.hints.iter().any(|hint| hint.english() == hint.text(catalogues::with(Language::Spanish)))
    {
        return Some("not said in both languages".to_owned());
    }
    let number: usize = number.parse().ok()?;
    let Some(fix) = only.fixes.get(number - 1) else { return Some("no such remedy".to_owned()) };
    let Ok(text) = apply(&wrong, &fix.edits) else { return Some("the remedy cannot be applied".to_owned()) };
    if text != BASE.replacen(before, mended, 1) {
        let line = text.lines().zip(BASE.lines()).find(|(now, base)| now != base);
        return Some(format!("the remedy gives {line:?}"));
    }
    let left: Vec<String> = findings(&text).iter().map(|found| found.message.english()).collect();
    // The SI value can be outside the range of the parameter, which is then reported.
    let is_of_range = left.iter().all(|said| said.contains("cannot have this value")) && number == 2;
    (!left.is_empty() && !is_of_range).then(|| format!("after the remedy: {left:?}"))
}

#[test]
fn the_base_has_no_fault() {
    let said: Vec<_> = findings(BASE).into_iter().map(|found| (found.code, found.message.english())).collect();
    assert_eq!(said, []);
}

#[test]
fn every_fault_has_one_message_with_a_remedy_that_works() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/all/remedies.txt");
    let text = std::fs::read_to_string(file).unwrap();
    let lines: Vec<&str> = text.lines().filter(|line| line.contains(" | ")).collect();
    let problems: Vec<String> =
        lines.iter().filter_map(|line| Some(format!("{line}\n    {}", problem(line)?))).collect();
    println!("{} of {} faults with a remedy that works", lines.len() - problems.len(), lines.len());
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    assert!(lines.len() >= 40);
}
