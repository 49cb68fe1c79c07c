//! Settings of fits: units that files do not state, offsets of the readings, rows that are left out, and several starts.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use analysis::fit::Target;
use runner::fitting::{FitSettings, FitTask, Fitted, Theory, settle_units, task};
use runner::names::{assignment, observe};
use runner::records::{Measured, measured};
use runner::{Loaded, Refusal, Sources};
use std::fmt::Write;

/// A decaying oscillation of 4 cm with its level in a parameter if there is one. `unit`: the declared unit of `y`.
fn theory(unit: &str, level: &str, vary: &str) -> Theory {
    let text = format!(
        "---\ntitle: In {unit}\nvary: {vary}\n---\n\n```model\nparameter A = 0.04 [m] in -1..1\nparameter w = 9 [1/s] in \
         1..20\nparameter k = 0.4 [1/s] in 0..5\nparameter c = 0 [m] in -1..1\n\ny = A*exp(-k*t)*cos(w*t){level} in [{unit}]\n```\n"
    );
    let (sources, document) = Loaded::open(Sources::of_text("theory.md", &text)).sound().expect(&text);
    Theory { sources, document }
}

/// A record of such an oscillation with this level, m; numbers are those of metres times `size`.
fn record(heading: &str, size: f64, level: f64, rows: usize) -> String {
    let mut text = heading.to_owned();
    for row in 0..rows {
        let t = row as f64 * 0.03;
        let off = 2e-4 * libm::sin((37 * row * row + 11) as f64);
        let y = 0.035 * libm::exp(-0.5 * t) * libm::cos(9.4 * t) + level + off;
        let flag = u8::from((20..25).contains(&row));
        writeln!(text, "{t:.2} {:.9} {flag}", y * size).unwrap();
    }
    text
}

fn read(text: &str, settings: &FitSettings, theory: &Theory) -> Measured {
    measured("run.txt".to_owned(), text.as_bytes().to_vec(), settings.stated(&theory.document)).unwrap()
}

fn settings(change: impl FnOnce(&mut FitSettings)) -> FitSettings {
    let mut settings = FitSettings { observe: vec![observe("y=2").unwrap()], ..FitSettings::default() };
    change(&mut settings);
    settings
}

fn asked(theory: &mut Theory, text: &str, settings: &FitSettings) -> Result<FitTask, Refusal> {
    let mut data = vec![read(text, settings, theory)];
    settle_units(std::slice::from_mut(theory), &mut data, settings)?;
    task(&mut theory.document, &data, settings, &mut |_| {})
}

fn fitted(theory: &Theory, text: &str, settings: &FitSettings) -> Fitted {
    let mut theory = theory.clone();
    let task = asked(&mut theory, text, settings).unwrap();
    Fitted::complete(theory, task, false, &mut |_| true).unwrap()
}

fn message(refusal: &Refusal) -> String {
    match refusal {
        Refusal::Request { message, hint } => {
            format!("{}; {}", message.english(), hint.as_ref().map(|hint| hint.english()).unwrap_or_default())
        }
        Refusal::Expression { .. } => format!("{refusal:?}"),
    }
}

/// Theories in every order, and numbers of metres, centimetres and millimetres: all read them in one unit, or ask.
#[test]
fn all_theories_read_a_column_in_one_unit() {
    let cases: [(&[&str], f64, &str); 12] = [
        (&["m"], 1.0, "m"),
        (&["m"], 100.0, "m"),
        (&["cm"], 100.0, "cm"),
        (&["cm"], 1.0, "m"),
        (&["mm"], 1.0, "m"),
        (&["mm"], 1000.0, "mm"),
        (&["cm", "m"], 1.0, "m"),
        (&["cm", "m"], 100.0, "cm"),
        (&["mm", "m"], 1.0, "m"),
        (&["mm", "m"], 1000.0, "mm"),
        (&["cm", "mm"], 100.0, "asked"),
        (&["cm", "mm", "m"], 1.0, "m"),
    ];
    for (units, size, expected) in cases {
        for turn in 0..units.len() {
            let mut theories: Vec<Theory> =
                (0..units.len()).map(|place| theory(units[(place + turn) % units.len()], "", "A, w, k")).collect();
            let settings = settings(|_| {});
            let text = record("", size, 0.0, 100);
            let mut data = vec![read(&text, &settings, &theories[0])];
            let found = match settle_units(&mut theories, &mut data, &settings) {
                Ok(()) => data[0].table.columns[1].unit.as_ref().map(|unit| unit.text.clone()).unwrap(),
                Err(refusal) => {
                    let message = message(&refusal);
                    assert!(message.contains("--unit 2=cm"), "{message}");
                    "asked".to_owned()
                }
            };
            assert_eq!(found, expected, "{units:?} {size}");
        }
    }
    // A stated unit holds, in the file or by a person, however odd the numbers are.
    for (heading, unit) in [("t [s] y [cm] flag\n", None), ("", Some("#2=cm"))] {
        let settings =
            settings(|settings| settings.unit = unit.into_iter().map(|unit| assignment(unit).unwrap()).collect());
        let mut theories = [theory("m", "", "A, w, k"), theory("mm", "", "A, w, k")];
        let mut data = vec![read(&record(heading, 1.0, 0.0, 100), &settings, &theories[0])];
        settle_units(&mut theories, &mut data, &settings).unwrap();
        assert_eq!(data[0].table.columns[1].unit.as_ref().unwrap().text, "cm");
    }
}

#[test]
fn the_unit_is_said_where_the_result_stands() {
    let report = fitted(&theory("cm", "", "A, w, k"), &record("", 1.0, 0.0, 100), &settings(|_| {})).fit_report();
    let said = report.findings.join(" ");
    assert!(
        said.contains("The record states no unit of y: its numbers are read in m. In cm, the unit of the theory,"),
        "{said}"
    );
    let report = fitted(&theory("m", "", "A, w, k"), &record("t [s] y [m] flag\n", 1.0, 0.0, 100), &settings(|_| {}));
    assert!(!report.fit_report().findings.join(" ").contains("states no unit"));
}

/// The offset is varied by default unless a varied parameter is such a constant, a person holds it, or values are too few.
#[test]
fn an_offset_is_varied_where_the_theory_has_no_constant() {
    let cases: [(&str, &str, &[&str], usize, bool); 7] = [
        ("", "A, w, k", &[], 100, true),
        (" + c", "A, w, k, c", &[], 100, false),
        (" - 2*c", "A, w, k, c", &[], 100, false),
        (" + c*t/(1 [s])", "A, w, k, c", &[], 100, true),
        ("", "A, w, k", &["y_offset=0"], 100, false),
        (" + c", "A, w, k, c", &["c=0"], 100, false),
        ("", "A, w, k", &[], 4, false),
    ];
    for (level, vary, fix, rows, expected) in cases {
        let settings = settings(|settings| settings.fix = fix.iter().map(|fix| assignment(fix).unwrap()).collect());
        let mut theory = theory("m", level, vary);
        let task = asked(&mut theory, &record("t y flag\n", 1.0, 0.0, rows), &settings).unwrap().task;
        let has = task.varied.iter().any(|varied| varied.target == Target::Offset(0));
        assert_eq!(has, expected, "{level} {fix:?} {rows}");
    }
    let held = settings(|settings| settings.fix = vec![assignment("y_offset=0.1").unwrap()]);
    let refusal = asked(&mut theory("m", "", "A, w, k"), &record("", 1.0, 0.0, 100), &held).unwrap_err();
    assert!(message(&refusal).contains("an offset can only be held at 0"), "{}", message(&refusal));
    // The first sentence says whether the curve meets the data.
    let (text, plain) = (record("", 1.0, -0.008, 100), theory("m", "", "A, w, k"));
    let verdict = |fix: &[&str]| {
        let fix = fix.iter().map(|fix| assignment(fix).unwrap()).collect();
        fitted(&plain, &text, &settings(|settings| settings.fix = fix)).fit_report().verdict
    };
    assert!(verdict(&[]).starts_with("The curve meets the data: the RMS residual of y is 0."), "{}", verdict(&[]));
    assert!(verdict(&["y_offset=0"]).starts_with("The curve misses the data"), "{}", verdict(&["y_offset=0"]));
}

/// Each way to name rows gives the fit of a record without them.
#[test]
fn excluded_rows_count_for_nothing() {
    let theory = theory("m", "", "A, w, k");
    let whole = record("", 1.0, 0.0, 100);
    let without: String = whole
        .lines()
        .enumerate()
        .filter(|(row, _)| !(20..25).contains(row))
        .map(|(_, line)| format!("{line}\n"))
        .collect();
    let values = |text: &str, exclude: &[&str]| {
        let fitted = fitted(
            &theory,
            text,
            &settings(|settings| settings.exclude = exclude.iter().map(|one| (*one).to_owned()).collect()),
        );
        let values: Vec<f64> = fitted.outcome.parameters.iter().map(|one| one.value).collect();
        (values, fitted.outcome.n, fitted.task.records[0].excluded_count())
    };
    let (expected, n, _) = values(&without, &[]);
    for exclude in [&["21..25"][..], &["21", "22..24", "25"], &["1:21..25"], &["#1=0.6..0.72"], &["#3"]] {
        assert_eq!(values(&whole, exclude), (expected.clone(), n, 5), "{exclude:?}");
    }
    for (exclude, expected) in [
        ("0", "names no rows"),
        ("25..21", "names no rows"),
        ("99..101", "has 100 rows"),
        ("2:5", "there are 1 records"),
        ("#1=2..1", "names no rows"),
        ("bad", "has no column `bad`"),
    ] {
        let settings = settings(|settings| settings.exclude = vec![exclude.to_owned()]);
        let refusal = asked(&mut theory.clone(), &whole, &settings).unwrap_err();
        assert!(message(&refusal).contains(expected), "{exclude}: {}", message(&refusal));
    }
}

#[test]
fn the_best_of_several_starts_is_taken() {
    let (theory, text) = (theory("m", "", "A, w, k"), record("", 1.0, 0.0, 100));
    let from =
        |start: &str| fitted(&theory, &text, &settings(|settings| settings.start = vec![assignment(start).unwrap()]));
    for start in ["w=3,9,15", "w=3..15 step 6"] {
        let fitted = from(start);
        let scan = fitted.outcome.scan.unwrap();
        assert!(scan.starts == 3 && (1..=3).contains(&scan.ended), "{scan:?}");
        assert!((fitted.outcome.estimate("w").unwrap().value - 9.4).abs() < 0.02);
        let said = format!("from 3 given starts; {} of them ended here", scan.ended);
        assert!(fitted.fit_report().findings.join(" ").contains(&said));
    }
    assert!(from("w=9").outcome.scan.is_none());
    for (start, expected) in
        [("w=3..9", "without a step"), ("w=3,30", "lies outside"), ("w=1..20 step 0.01", "at most 200")]
    {
        let settings = settings(|settings| settings.start = vec![assignment(start).unwrap()]);
        let refusal = asked(&mut theory.clone(), &text, &settings).unwrap_err();
        assert!(message(&refusal).contains(expected), "{start}: {}", message(&refusal));
    }
}
