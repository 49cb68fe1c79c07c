//! `meniscus sweep`: the rows are what single runs give, in any division of the work.

use crate::common::{Done, SPRING, directory_with, meniscus, numbers};
use arrow_array::cast::AsArray;
use arrow_array::types::Float64Type;
use arrow_array::{Array, ArrayRef, RecordBatch};
use arrow_ipc::reader::FileReader;
use arrow_schema::Field;

/// A damped oscillation, whose closed form is known, and a switch.
const DAMPED: &str = "---\nuntil: 2 [s]\nstep: 0.001\n---\n\n```model\nparameter gamma = 0.3 [1/s] in 0..5\nparameter x_0 = 2 [cm] in 1..9\n\
switch damped = on\nx'' = if damped then -2*gamma*x' - 100 [1/s^2]*x else -100 [1/s^2]*x\nx(0) = x_0 in [cm]\nx'(0) = 0\nfunction half(u) = u/2\n```\n";

fn sweep(text: &str, words: &[&str]) -> Done {
    let (_directory, path) = directory_with(text);
    let mut all = vec!["sweep", path.to_str().expect("UTF-8")];
    all.extend(words);
    meniscus(&all)
}

fn rows(text: &str, words: &[&str]) -> Vec<Vec<f64>> {
    let done = sweep(text, words);
    assert_eq!((done.code, done.stderr.as_str()), (0, ""), "{words:?}");
    numbers(&done.stdout)
}

#[test]
fn values_at_the_end_are_those_of_the_closed_form() {
    let found = rows(
        DAMPED,
        &[
            "--over",
            "gamma in 0..4 step 1",
            "--over",
            "x_0 = 20, 30 [mm]",
            "--keep",
            "x at end, half(x) in [cm] at end",
        ],
    );
    assert_eq!(found.len(), 10);
    for row in &found {
        let [_, gamma, start, end, half] = row.as_slice() else { panic!("{row:?}") };
        let omega = libm::sqrt(100.0 - gamma * gamma);
        let phase = 2.0 * omega;
        let expected = start * libm::exp(-2.0 * gamma) * (libm::cos(phase) + gamma / omega * libm::sin(phase));
        assert!((end - expected).abs() < 1e-7, "{row:?} {expected}");
        assert!((half - end / 2.0).abs() < 1e-14);
    }
    assert_eq!(found.iter().map(|row| row[0]).collect::<Vec<_>>(), (1..=10).map(f64::from).collect::<Vec<_>>());
}

/// Each row has the bits of the run with the same settings.
#[test]
fn rows_are_those_of_single_runs() {
    let (_directory, path) = directory_with(DAMPED);
    let path = path.to_str().expect("UTF-8");
    let keep = "maximum(x) from 0.5 [s] in [cm], minimum(x) in [cm], x at end, maximum(x) - minimum(x) in [cm]";
    let words =
        ["sweep", path, "--over", "gamma = 0.1, 0.7", "--keep", keep, "--set", "x_0=3", "--method", "dormand-prince"];
    let found = numbers(&meniscus(&words).stdout);
    for row in found {
        let gamma = format!("gamma={}", row[1]);
        let words = ["run", path, "--set", &gamma, "--set", "x_0=3", "--method", "dormand-prince", "--columns", "t,x"];
        let run = numbers(&meniscus(&words).stdout);
        let from = |start: f64| run.iter().filter(move |row| row[0] >= start).map(|row| row[1]);
        let (greatest, least) = (from(0.5).fold(f64::MIN, f64::max), from(0.0).fold(f64::MAX, f64::min));
        assert_eq!(row[2..5], [greatest, least, run.last().unwrap()[1]]);
        // Both count from the same row here.
        let all = from(0.0).fold(f64::MIN, f64::max);
        assert!((row[5] - (all - least)).abs() < 1e-12, "{row:?}");
    }
}

/// Any number of processors and any division into shards give the same characters.
#[test]
fn the_division_of_the_work_does_not_matter() {
    let over =
        ["--over", "gamma in 0..5", "--over", "x_0 in 1..9 step 1", "--over", "damped = on, off", "--keep", "mean(x)"];
    for sample in [["--random", "23"], ["--halton", "23"]] {
        let words = [&over[..], &sample].concat();
        let whole = sweep(DAMPED, &[&words[..], &["--threads", "1"]].concat()).stdout;
        assert_eq!(whole.lines().count(), 24);
        assert_eq!(sweep(DAMPED, &words).stdout, whole);
        let shards = ["1/5", "2/5", "3/5", "4/5", "5/5"];
        let parts = shards.map(|shard| sweep(DAMPED, &[&words[..], &["--shard", shard]].concat()).stdout);
        let rows = |text: &str| text.lines().skip(1).map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(parts.iter().flat_map(|part| rows(part)).collect::<Vec<_>>(), rows(&whole));
        assert!(parts.iter().all(|part| part.lines().next() == whole.lines().next()));
    }
    let other = sweep(DAMPED, &[&over[..], &["--random", "23", "--seed", "2"]].concat()).stdout;
    assert_ne!(other, sweep(DAMPED, &[&over[..], &["--random", "23"]].concat()).stdout);
}

#[test]
fn columns_have_names_units_and_words() {
    let found = sweep(
        DAMPED,
        &["--over", "damped = off, on", "--keep", "maximum(x) in [mm], x at end \"Last, x\"", "--until", "1"],
    );
    let mut lines = found.stdout.lines();
    assert_eq!(lines.next(), Some("run,damped,maximum(x) [mm],\"Last, x [cm]\""));
    let rows: Vec<&str> = lines.collect();
    assert!(rows[0].starts_with("1,off,20,") && rows[1].starts_with("2,on,20,"), "{rows:?}");
}

/// A run that cannot be computed has empty cells, and it is said why; it is a failure if there is no other.
#[test]
fn runs_that_fail_are_gaps() {
    let text = "---\nuntil: 2\nstep: 0.01\n---\n\n```model\nparameter k = 0 [1/s] in 0..9\nx' = k*x^2\nx(0) = 1\n```\n";
    let found = sweep(text, &["--over", "k in 0..2 step 1", "--keep", "x at end", "--set", "k=0"]);
    assert_eq!(found.code, 0, "{}", found.stderr);
    let lines: Vec<&str> = found.stdout.lines().skip(1).collect();
    assert_eq!(lines[..1], ["1,0,1"]);
    assert_eq!(lines[2], "3,2,", "{lines:?}");
    assert!(found.stderr.contains("of 3 runs could not be computed; the first is run"), "{}", found.stderr);
    let found = sweep(text, &["--over", "k = 5, 6", "--keep", "x at end"]);
    assert_eq!((found.code, found.stdout.lines().count()), (1, 3), "{}", found.stderr);
}

#[test]
fn what_cannot_be_swept_is_said() {
    for (over, keep, more, code, expected) in [
        ("k 1", "x at end", "", 2, "this is no range of values"),
        ("q in 1..2", "x at end", "", 2, "`q` is not a parameter"),
        ("k in 1..20", "x at end", "", 2, "give a step"),
        ("k in 2..1 step 1", "x at end", "", 2, "the smaller one first"),
        ("k in 1..1e9 step 1", "x at end", "", 2, "out of range"),
        ("k in 1..2 [m] step 1", "x at end", "", 2, "wrong dimension"),
        ("k = 1, 2 [m]", "x at end", "", 2, "--over k"),
        ("k = 1,,2", "x at end", "", 2, "comma without a value"),
        ("x = 1", "x at end", "", 2, "not a parameter"),
        ("k in 1..2 step 1", "x", "", 2, "changes during a run"),
        ("k in 1..2 step 1", "nothing at end", "", 2, "`nothing`"),
        ("k in 1..2 step 1", "x at end,", "", 2, "expected"),
        ("k in 1..2 step 1", "x at end", "--shard=3/2", 2, "write I/N"),
        ("k in 1..2 step 1", "x at end", "--shard=0/2", 2, "write I/N"),
        ("k in 1..20 step 1e-15", "x at end", "", 2, "more runs than"),
    ] {
        let mut words = vec!["--over", over, "--keep", keep];
        words.extend(Some(more).filter(|more| !more.is_empty()));
        let found = sweep(SPRING, &words);
        assert_eq!((found.code, found.stdout.as_str()), (code, ""), "{words:?}: {}", found.stderr);
        assert!(found.stderr.contains(expected), "{words:?} lacks «{expected}»:\n{}", found.stderr);
    }
    let twice = sweep(SPRING, &["--over", "k = 1", "--over", "k = 2", "--keep", "x at end"]);
    assert!(twice.stderr.contains("--over names the parameter k twice"), "{}", twice.stderr);
}

/// A file of Arrow's format has the bits, units and words of the table.
#[test]
fn arrow_files_have_the_same_numbers_with_units() {
    let directory = tempfile::tempdir().unwrap();
    let output = directory.path().join("runs.arrow");
    let words = [
        "--over",
        "x_0 = 2, 3 [cm]",
        "--over",
        "damped = on, off",
        "--keep",
        "x at end in [mm], sqrt(x_0/(1 [cm]) - 3) at end",
    ];
    let whole = [&words[..], &["--output", output.to_str().unwrap()]].concat();
    let done = sweep(DAMPED, &whole);
    assert_eq!((done.code, done.stdout.as_str()), (0, ""), "{}", done.stderr);
    let reader = FileReader::try_new(std::fs::File::open(&output).unwrap(), None).unwrap();
    let schema = reader.schema();
    let named = |field: &Field| (field.name().clone(), field.metadata().get("unit").cloned().unwrap_or_default());
    let fields: Vec<(String, String)> = schema.fields().iter().map(|field| named(field)).collect();
    let expected =
        [("run", ""), ("x_0", "cm"), ("damped", ""), ("x at end", "mm"), ("sqrt(x_0/(1 [cm]) - 3) at end", "")];
    assert_eq!(fields, expected.map(|(name, unit)| (name.to_owned(), unit.to_owned())));
    let batches: Vec<RecordBatch> = reader.map(Result::unwrap).collect();
    let mut lines = vec!["run,x_0 [cm],damped,x at end [mm],sqrt(x_0/(1 [cm]) - 3) at end".to_owned()];
    for batch in &batches {
        for row in 0..batch.num_rows() {
            let cell = |column: &ArrayRef| match column.as_string_opt::<i32>() {
                _ if column.is_null(row) => String::new(),
                Some(texts) => texts.value(row).to_owned(),
                None => column.as_primitive::<Float64Type>().value(row).to_string(),
            };
            lines.push(batch.columns().iter().map(cell).collect::<Vec<_>>().join(","));
        }
    }
    let numbers = |text: &str| -> Vec<Vec<String>> {
        let cell =
            |cell: &str| cell.parse::<f64>().map_or(cell.to_owned(), |number| format!("{:016x}", number.to_bits()));
        text.lines().map(|line| line.split(',').map(cell).collect()).collect()
    };
    assert_eq!(numbers(&lines.join("\n")), numbers(&sweep(DAMPED, &words).stdout));
}
