//! Tied parameters of fits: expressions of others, in all records or between records.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use runner::fitting::{FitSettings, Fitted, Theory, fit_as_json, fit_as_text, task};
use runner::names::{assignment, observe};
use runner::records::{Measured, measured};
use runner::{Loaded, Refusal, Sources};
use std::fmt::Write;

const THEORY: &str = "---
title: Two decays
vary: A, B, a, b
---

```model
parameter A = 1 [V]
parameter B = 1 [V]
parameter a = 0.5 [1/ms]
parameter b = 1 [1/ms]

y = A*exp(-a*t) + B*exp(-b*t) in [V]
```
";

/// Record of A exp(-a t) + 2 A exp(-3 a t), with `a` in 1/s.
fn record(size: f64, rate: f64) -> String {
    let mut text = "t [ms] y [V]\n".to_owned();
    for row in 0..60 {
        let t = f64::from(row) * 0.05;
        let off = 1e-3 * libm::sin(f64::from(37 * row * row + 11));
        let y = size * (libm::exp(-rate * t) + 2.0 * libm::exp(-3.0 * rate * t)) + off;
        writeln!(text, "{t:.2} {y:.9}").unwrap();
    }
    text
}

fn asked(
    ties: &[&str],
    change: &dyn Fn(&mut FitSettings),
    records: &[String],
) -> Result<(Fitted, Vec<Measured>), Refusal> {
    let text = THEORY;
    let (sources, document) = Loaded::open(Sources::of_text("theory.md", text)).sound().expect(text);
    let mut theory = Theory { sources, document };
    let mut settings = FitSettings { observe: vec![observe("y").unwrap()], ..FitSettings::default() };
    settings.tie = ties.iter().map(|tie| assignment(tie).unwrap()).collect();
    change(&mut settings);
    let named = |(place, text): (usize, &String)| {
        measured(format!("run{}.txt", place + 1), text.as_bytes().to_vec(), settings.stated(&theory.document)).unwrap()
    };
    let data: Vec<Measured> = records.iter().enumerate().map(named).collect();
    let task = task(&mut theory.document, &data, &settings, &mut |_| {})?;
    Ok((Fitted::complete(theory, task, false, &mut |_| true)?, data))
}

#[test]
fn a_tied_parameter_stands_among_what_follows() {
    let (fitted, data) = asked(&["b=3*a", "B = 2*A"], &|_| {}, &[record(1.5, 0.8)]).unwrap();
    let names = |estimates: &[analysis::fit::Estimate]| -> Vec<String> {
        estimates.iter().map(|one| one.name.clone()).collect()
    };
    assert_eq!(names(&fitted.outcome.parameters), ["A", "a", "y_offset"]);
    assert_eq!(names(&fitted.outcome.derived), ["b", "B"]);
    let json = fit_as_json(&fitted, &data);
    for (name, expected) in [("b", 2.4), ("B", 3.0)] {
        let value = json["derived"][name]["value"].as_f64().unwrap();
        let error = json["derived"][name]["stderr"].as_f64().unwrap();
        assert!((value - expected).abs() < 4.0 * error && error < 0.01, "{name} {value} {error}");
    }
    assert!(fit_as_text(&fitted, &[Vec::new()]).contains("\nFrom these\n"));
}

#[test]
fn a_parameter_of_one_record_is_tied_to_that_of_another() {
    let records = [record(1.5, 0.8), record(0.9, 1.6), record(2.0, 1.1)];
    let ties = ["b=3*a", "B=2*A", "a:2=2*a:1"];
    let (fitted, _) =
        asked(&ties, &|settings| settings.start = vec![assignment("a:1=0.9").unwrap()], &records).unwrap();
    let named = |name: &str| -> Vec<(Option<usize>, f64)> {
        let all = fitted.outcome.parameters.iter().chain(&fitted.outcome.derived).filter(|one| one.name == name);
        all.map(|one| (one.record, (one.unit.from_si(one.value) * 100.0).round() / 100.0)).collect()
    };
    assert_eq!(named("a:1"), [(None, 0.8)]);
    assert_eq!(named("a:3"), [(None, 1.1)]);
    assert_eq!(named("a:2"), []);
    assert_eq!(named("a"), [(Some(0), 0.8), (Some(1), 1.6), (Some(2), 1.1)]);
    assert_eq!(named("b"), [(Some(0), 2.4), (Some(1), 4.8), (Some(2), 3.3)]);
    // A value of another record may hold an own value of it.
    let held = |settings: &mut FitSettings| settings.fix = vec![assignment("a=0.8,1.6,1.1").unwrap()];
    let (fitted, _) = asked(&["b:1=3*a:1", "b:2=3*a:2", "b:3=b:1*a:3/a:1", "B=2*A"], &held, &records).unwrap();
    let rates: Vec<f64> = fitted.outcome.settings.iter().map(|values| values[3] / 1000.0).collect();
    assert!(rates.iter().zip([2.4, 4.8, 3.3]).all(|(found, expected)| (found - expected).abs() < 1e-9), "{rates:?}");
}

#[test]
fn ties_that_make_no_sense_are_refused_with_the_reason() {
    let cases: [(&[&str], &str, &str); 14] = [
        (&["c=2*a"], "", "there is no parameter `c`"),
        (&["y=2*a"], "", "`y` is defined by the document"),
        (&["b=2*A"], "", "--tie b is in 1/ms, and 2*A is in V"),
        (&["b=3*t"], "", "1/ms"),
        (&["b=3*a/(1+t/(1 [s]))"], "", "changes during the run"),
        (&["b=2*"], "", "--tie b"),
        (&["b=2*b"], "", "tied to itself"),
        (&["b=a", "b=2*a"], "", "it is tied twice"),
        (&["b:3=2*a:1"], "", "--tie b:3: there are 2 records"),
        (&["b:2=2*a"], "", "a has a value in each record; say in which record, such as a:2"),
        (&["b:2=2*b:1", "b=a"], "", "named both with a record and without"),
        (&["b:2=2*b:1"], "share b", "b has one value in all records"),
        (&["b=2*a"], "vary b", "b stands in --vary and in --tie"),
        (&["b=2*a"], "fix b", "b stands in --fix and in --tie"),
    ];
    for (ties, also, expected) in cases {
        let change = |settings: &mut FitSettings| match also.split_once(' ') {
            Some(("share", name)) => settings.share = vec![name.to_owned()],
            Some(("vary", name)) => settings.vary = vec![name.to_owned(), "a".to_owned()],
            Some((_, name)) => settings.fix = vec![assignment(&format!("{name}=1")).unwrap()],
            None => {}
        };
        let Err(refusal) = asked(ties, &change, &[record(1.0, 1.0), record(1.0, 2.0)]) else { panic!("{ties:?}") };
        let said = match &refusal {
            Refusal::Request { message, hint } => {
                format!("{}; {}", message.english(), hint.as_ref().map(|hint| hint.english()).unwrap_or_default())
            }
            Refusal::Expression { setting, text, .. } => format!("{setting} {text}"),
        };
        assert!(said.contains(expected), "{ties:?}: {said}");
    }
}
