//! `meniscus cycles`: input, output, and messages of refusals.

use crate::common::{Done, done, meniscus, numbers, program, root};
use analysis::spreadsheet::{Cell, Sheet, Workbook};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Stdio;

/// An oscillation of 9.6 rad/s with damping 0.4/s about 2, at 30 frames a second: time, height.
fn rows() -> Vec<(f64, f64)> {
    (0..120)
        .map(|frame| {
            let t = f64::from(frame) / 30.0;
            // Deterministic noise that no sinusoid follows.
            let noise = 0.01 * libm::sin(1.7 * f64::from(frame * frame));
            (t, 2.0 + 5.0 * libm::exp(-0.4 * t) * libm::cos(9.6 * t) + noise)
        })
        .collect()
}

fn text(header: &str, decimal_comma: bool) -> String {
    let mut text = format!("{header}\n");
    for (t, y) in rows() {
        let row = format!("{t:.9E}\t{y:.9E}\n");
        text.push_str(&if decimal_comma { row.replace('.', ",") } else { row });
    }
    text
}

/// The rows with times in milliseconds and heights in centimetres.
fn milliseconds() -> String {
    rows().iter().fold("t [ms];y [cm]\n".to_owned(), |text, (t, y)| format!("{text}{};{y}\n", t * 1e3))
}

fn directory_with(name: &str, bytes: &[u8]) -> (tempfile::TempDir, PathBuf) {
    let directory = tempfile::tempdir().expect("a temporary directory");
    let path = directory.path().join(name);
    std::fs::write(&path, bytes).expect("it can be written");
    (directory, path)
}

fn cycles(path: &Path, words: &[&str]) -> Done {
    let mut all = vec!["cycles", path.to_str().expect("UTF-8")];
    all.extend(words);
    meniscus(&all)
}

fn refused(bytes: &[u8], words: &[&str], expected: &[&str]) {
    let (_directory, path) = directory_with("data.txt", bytes);
    let done = cycles(&path, words);
    assert_eq!((done.code, done.stdout.as_str()), (2, ""), "{words:?}");
    for part in expected {
        assert!(done.stderr.contains(part), "{words:?} lacks «{part}»:\n{}", done.stderr);
    }
}

#[test]
fn the_table_has_values_errors_and_words() {
    let (_directory, path) = directory_with("run.txt", text("mass_A\nt\ty [cm]", true).as_bytes());
    let done = cycles(&path, &[]);
    assert_eq!((done.code, done.stderr.as_str()), (0, ""));
    let out = &done.stdout;
    assert!(out.contains("run.txt: y against t, 120 rows from 0.00 s to 3.97 s\n"), "{out}");
    assert!(out.contains("A [cm]") && out.contains("ω [rad/s]") && out.contains("γ [1/s]"), "{out}");
    let first = out.lines().find(|line| line.starts_with("  max")).expect("a maximum");
    for value in ["0.65", "0.26", "9.59", " ± "] {
        assert!(first.contains(value), "{first}");
    }
    assert!(out.contains("The angular frequency is the same in all cycles within its errors"), "{out}");
    assert!(out.lines().all(|line| line.chars().count() <= 110), "{out}");
}

#[test]
fn json_and_csv_hold_every_cycle() {
    let (directory, path) = directory_with("run.txt", milliseconds().as_bytes());
    let json: serde_json::Value = serde_json::from_str(&cycles(&path, &["--format", "json"]).stdout).expect("JSON");
    let all = json["cycles"].as_array().expect("an array");
    assert_eq!((&json["unit"], &json["rows"], &json["column"]), (&"cm".into(), &120.into(), &2.into()));
    assert!(all.len() >= 9, "{}", all.len());
    let csv = directory.path().join("cycles.csv");
    let done = cycles(&path, &["--output", csv.to_str().expect("UTF-8")]);
    assert_eq!((done.code, done.stdout.as_str()), (0, ""));
    let csv = std::fs::read_to_string(csv).expect("a file");
    assert!(csv.starts_with("t [s],t_stderr [s],amplitude [cm],amplitude_stderr [cm],period [s],"), "{csv}");
    assert_eq!(numbers(&csv).len(), all.len());
    assert_eq!(numbers(&csv)[3][8], all[3]["angular_frequency"]["value"].as_f64().expect("a number"));
}

#[test]
fn the_figure_is_one_picture() {
    let (directory, path) = directory_with("run.txt", text("t\ty", false).as_bytes());
    let svg = directory.path().join("cycles.svg");
    assert_eq!(cycles(&path, &["--output", svg.to_str().expect("UTF-8")]).code, 0);
    let svg = std::fs::read_to_string(svg).expect("a file");
    assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"));
    assert_eq!(svg.matches("<svg ").count(), 11);
    for title in ["Amplitude against time", "Damping against amplitude", "The record and its envelope"] {
        assert!(svg.contains(title), "{title}");
    }
}

#[test]
fn a_part_and_a_column_can_be_chosen() {
    let (_directory, path) = directory_with("run.txt", text("t\ty", false).as_bytes());
    let heading = |words: &[&str]| cycles(&path, words).stdout.lines().next().unwrap_or_default().to_owned();
    assert!(heading(&["--observe", "h=2"]).ends_with("run.txt: h (y) against t, 120 rows from 0.00 s to 3.97 s"));
    assert!(heading(&["--from", "1", "--until", "3000 [ms]"]).contains("61 rows from 1.00 s to 3.00 s"));
    let (_directory, path) = directory_with("bare.txt", text("", false).as_bytes());
    assert!(cycles(&path, &["--observe", "y"]).stdout.contains("bare.txt: y (column 2) against column 1"));
}

#[test]
fn spreadsheets_and_the_standard_input_are_read() {
    let (times, heights): (Vec<f64>, Vec<f64>) = rows().into_iter().unzip();
    let notes = Sheet { name: "Notes".to_owned(), rows: vec![vec![Cell::from("filmed in May")]], header: false };
    let data = Sheet::of_columns("Data", &["t [s]", "y [mm]"], &[&times, &heights]);
    let (_directory, path) = directory_with("run.xlsx", &Workbook { sheets: vec![notes, data] }.xlsx());
    let from_sheet = cycles(&path, &["--format", "csv"]);
    assert_eq!(from_sheet.code, 0, "{}", from_sheet.stderr);
    assert!(from_sheet.stdout.contains("amplitude [mm]"), "{}", from_sheet.stdout);

    let mut child = program()
        .args(["cycles", "-", "--format", "csv"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut text = "t [s]\ty [mm]\n".to_owned();
    rows().iter().for_each(|(t, y)| text.push_str(&format!("{t:?}\t{y:?}\n")));
    child.stdin.take().expect("a pipe").write_all(text.as_bytes()).expect("it reads");
    let from_text = done(child.wait_with_output().expect("it ends"));
    assert_eq!(from_text.stdout, from_sheet.stdout, "{}", from_text.stderr);
}

#[test]
fn what_cannot_be_read_is_refused_with_the_remedy() {
    refused(
        b"\x7fELF\x01\x01\0\0",
        &[],
        &["cannot read", "data.txt: this is not text", "hint: export the table as text"],
    );
    refused(
        b"PK\x03\x04 no workbook",
        &[],
        &["cannot read", "the workbook is damaged or incomplete", "hint: open it in the spreadsheet program"],
    );
    refused(b"Dear Ann,\nhow are you?\n", &[], &["line 1: there is no table", "hint: a table has one row a line"]);
    refused(b"t,y\n0,1\n1,1\n2,1\n", &[], &["does not oscillate", "--observe NAME=COLUMN"]);
    // Columns that oscillate are named, by what selects them.
    let with = |heads: &str, columns: &[usize]| {
        (0..60).fold(format!("{heads}\n"), |text, row| {
            let value = |place: &usize| match place {
                0 => format!("{}", 20.0 + 0.1 * f64::from(row)),
                _ => format!("{:.4}", *place as f64 * libm::cos(0.5 * f64::from(row))),
            };
            let cells: Vec<String> = columns.iter().map(value).collect();
            text + &format!("{},{}\n", f64::from(row) / 10.0, cells.join(","))
        })
    };
    for (heads, columns, hint) in [
        ("t [s],T [K],y [cm]", &[0, 1][..], "y oscillates: write --observe y\n"),
        ("t [s],T [K],y,y", &[0, 1, 2], "y #3 and y #4 oscillate: write --observe '#3' or --observe '#4'"),
        ("t [s],T [K],y [cm],y [V]", &[0, 1, 2], "y [cm] and y [V] oscillate: write --observe '#3' or"),
        ("t [s],T [K],p [Pa]", &[0, 0], "--observe NAME=COLUMN"),
        ("t [s],T [K],left wing", &[0, 1], "left wing oscillates: write --observe '#3'"),
    ] {
        refused(with(heads, columns).as_bytes(), &[], &["T, 60 rows. This column does not oscillate", hint]);
    }
    let open = "date,y\n01/02/2024,1\n03/01/2024,2\n02/04/2024,1\n05/03/2024,2\n";
    refused(open.as_bytes(), &[], &["the day first or the month first", "--dates day-first or --dates month-first"]);
    refused(open.as_bytes(), &["--dates", "month-first"], &["y, 4 rows. This column does not oscillate"]);
    refused(open.as_bytes(), &["--dates", "dmy"], &["write day-first or month-first"]);
    let good = text("t\ty", false);
    refused(
        good.as_bytes(),
        &["--observe", "z"],
        &["has no column `z`", "its columns are t and y", "--observe z=COLUMN"],
    );
    refused(good.as_bytes(), &["--observe", "y=t"], &["t is what the others are measured against"]);
    refused(good.as_bytes(), &["--from", "3.5"], &["does not oscillate", "15 rows"]);
    let done = meniscus(&["cycles", "no-such-file.txt"]);
    assert_eq!(done.code, 2);
    assert!(done.stderr.contains("cannot read no-such-file.txt: No such file"), "{}", done.stderr);
    let (_directory, path) = directory_with("run.txt", good.as_bytes());
    let done = cycles(&path, &["--output", path.to_str().expect("UTF-8")]);
    assert!(done.stderr.contains("is the data; choose another output"), "{}", done.stderr);
    assert_eq!(std::fs::read_to_string(&path).expect("a file"), good);
}

/// A sparse file of one gigabyte, which uses no disk space. It is refused by its size alone.
#[test]
fn a_file_that_is_too_large_is_not_read() {
    let (_directory, path) = directory_with("large.txt", b"t\ty\n");
    std::fs::OpenOptions::new().write(true).open(&path).and_then(|file| file.set_len(1 << 30)).expect("a sparse file");
    let done = cycles(&path, &[]);
    assert_eq!(done.code, 2);
    assert!(done.stderr.contains("it is larger than 256 MB"), "{}", done.stderr);
}

#[test]
#[ignore = "needs the measured records in ../shared/data/utube"]
fn a_measured_record_shows_its_frequency_rise() {
    let path = root().join("../shared/data/utube/U3.txt");
    let done = cycles(&path, &[]);
    assert_eq!((done.code, done.stderr.as_str()), (0, ""));
    for part in [
        "6 frames are missing: 16 to 21",
        "looks like 1/30 s rounded",
        "column 3 was computed from column 2",
        "The angular frequency changes by more than its errors explain",
    ] {
        // Sentences may be wrapped.
        let words: Vec<&str> = done.stdout.split_whitespace().collect();
        assert!(words.join(" ").contains(part), "lacks «{part}»:\n{}", done.stdout);
    }
}

#[test]
fn what_was_understood_of_the_columns_is_said() {
    let (_directory, path) = directory_with("run.txt", text("time_s\ty [cm]", false).as_bytes());
    let out = cycles(&path, &[]).stdout;
    for line in [
        "  time  [s]   from the end of the name; 120 values; independent: named as a time\n",
        "  y     [cm]  from the header; 120 values; against time\n",
    ] {
        assert!(out.contains(line), "{out}");
    }
    let done = cycles(&path, &["--format", "csv"]);
    assert!(
        done.stderr.contains("run.txt: tabs, decimal point, 1 header line, 120 rows\n  time  [s] "),
        "{}",
        done.stderr
    );
    let json: serde_json::Value = serde_json::from_str(&cycles(&path, &["--format", "json"]).stdout).expect("JSON");
    let column = &json["columns"][1];
    assert_eq!((&column["name"], &column["unit"]), (&"y".into(), &"cm".into()));
    assert_eq!((&column["unit_from"], &column["values"]), (&"header".into(), &120.into()));
}

#[test]
fn a_unit_can_be_stated() {
    let bare = milliseconds().replace("t [ms];y [cm]", "t;y");
    let (_directory, path) = directory_with("run.txt", bare.as_bytes());
    let assumed = cycles(&path, &[]).stdout;
    assert!(assumed.contains("they are taken for seconds") && assumed.contains("no unit stated"), "{assumed}");
    let stated = cycles(&path, &["--unit", "t=ms", "--unit", "y=cm"]).stdout;
    assert!(
        stated.contains("rows from 0.00 s to 3.97 s") && !stated.contains("they are taken for seconds"),
        "{stated}"
    );
    assert!(stated.contains("stated by you"), "{stated}");
    refused(bare.as_bytes(), &["--unit", "t=parsec"], &["`parsec` is not a known unit", "--unit t=ms"]);
    refused(bare.as_bytes(), &["--unit", "z=ms"], &["has no column `z`", "its columns are t and y"]);
    // A column with an unknown unit is refused until the unit is stated.
    let unknown = milliseconds().replace("t [ms]", "t [ticks]");
    refused(unknown.as_bytes(), &[], &["`ticks`, the unit of t, is not a known unit", "--unit t=ms"]);
    let (_directory, path) = directory_with("run.txt", unknown.as_bytes());
    assert_eq!(cycles(&path, &["--unit", "t=ms"]).code, 0);
}

#[test]
fn every_run_has_its_own_clock() {
    let mut text = "Time (s) Run #1,y (cm) Run #1,Time (s) Run #2,y (cm) Run #2\n".to_owned();
    rows().iter().for_each(|(t, y)| text.push_str(&format!("{t},{y},{},{y}\n", 2.0 * t)));
    let (_directory, path) = directory_with("run.csv", text.as_bytes());
    let frequency = |words: &[&str]| {
        let done = cycles(&path, &[&["--format", "json"], words].concat());
        let json: serde_json::Value = serde_json::from_str(&done.stdout).expect("JSON");
        json["cycles"][0]["angular_frequency"]["value"].as_f64().expect("a number")
    };
    let (first, second) = (frequency(&["--observe", "y"]), frequency(&["--observe", "Run 2.y"]));
    assert!((first / second - 2.0).abs() < 1e-6, "{first} {second}");
    assert_eq!(frequency(&["--observe", "y=Run #2.y"]), second);
}

#[test]
fn clock_times_are_seconds_and_times_of_no_use_are_refused() {
    let mut text = "t,y\n".to_owned();
    rows().iter().for_each(|(t, y)| text.push_str(&format!("23:59:{:08.5},{y}\n", 50.0 + t)));
    let (_directory, path) = directory_with("run.csv", text.as_bytes());
    let out = cycles(&path, &[]).stdout;
    assert!(out.contains("rows from 0.00 s to 3.97 s") && out.contains("holds clock times"), "{out}");
    let still: String = rows().iter().map(|(_, y)| format!("12:00:00,{y}\n")).collect();
    let expected = ["y cannot be measured against t: its times are missing or all the same", "10:00:00.050"];
    refused(format!("t,y\n{still}").as_bytes(), &[], &expected);
}

#[test]
fn limits_that_make_no_sense_are_refused() {
    let cases: [(&[&str], &[&str]); 9] = [
        (&["--from", "soon"], &["--from soon is not a number", "such as --from 1.5", "'1500 [ms]'"]),
        (&["--from", "1 [kg]"], &["--from 1 [kg]: kg is not a unit of time", "such as --from 1.5"]),
        (&["--until", "2 cm"], &["--until 2 cm: cm is not a unit of time"]),
        (&["--from", "1 [parsec]"], &["--from 1 [parsec]: `parsec` is not a known unit"]),
        (&["--until", "inf"], &["--until inf is not a finite number", "leave --until out"]),
        (&["--from", "NaN"], &["--from NaN is not a finite number"]),
        (&["--from", "1e999"], &["--from 1e999 is not a finite number"]),
        (&["--from", "2", "--until", "1"], &["--until 1 is not after --from 2", "give --until a later time"]),
        (&["--from", "1500 [ms]", "--until", "1.5"], &["--until 1.5 is not after --from 1500 [ms]"]),
    ];
    for (words, expected) in cases {
        refused(text("t\ty", false).as_bytes(), words, expected);
    }
    // A record may begin before time 0, as one that is synchronised at an event does.
    let (_directory, path) = directory_with("run.txt", text("t\ty", false).as_bytes());
    assert_eq!(cycles(&path, &["--from", "-1"]).code, 0);
    let spanish = cycles(&path, &["--from", "1 [kg]", "--language", "es"]);
    assert!(spanish.stderr.contains("kg no es una unidad de tiempo"), "{}", spanish.stderr);
    // With an angle as independent variable.
    let angles = rows().iter().fold("phi [deg],y\n".to_owned(), |text, (t, y)| format!("{text}{},{y}\n", t * 90.0));
    refused(angles.as_bytes(), &["--from", "1 [s]"], &["in deg, and s is another kind of unit", "--from '1 [deg]'"]);
}

/// A film whose time 0 is between two frames begins shortly before 0.
#[test]
fn no_time_is_less_than_nothing() {
    let rows: String = rows().iter().map(|(t, y)| format!("{:.6}\t{y:.6}\n", t - 0.00097)).collect();
    let (_directory, path) = directory_with("run.txt", format!("t\ty\n{rows}").as_bytes());
    let out = cycles(&path, &[]).stdout;
    assert!(out.contains("120 rows from 0.00 s to 3.97 s"), "{out}");
}

/// A decaying oscillation that ends in noise, and noise alone.
#[test]
fn noise_ends_the_table_or_refuses_it() {
    let mut state = 1_u32;
    let mut chance = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state >> 8) / f64::from(1 << 24) - 0.5
    };
    let mut scatter = || 0.5 * (0..12).map(|_| chance()).sum::<f64>();
    let mut record = |size: f64| {
        let times = (0..6_000).map(|row| f64::from(row) / 100.0);
        let value = |t: f64| size * libm::exp(-0.3 * t) * libm::cos(9.666 * t);
        times.fold("t [s]\ty [mm]\n".to_owned(), |text, t| format!("{text}{t}\t{:.4}\n", value(t) + scatter()))
    };
    let (_directory, path) = directory_with("run.txt", record(50.0).as_bytes());
    let out = cycles(&path, &[]).stdout;
    assert!(out.contains("s on the noise hides the oscillation."), "{out}");
    assert!(!out.contains("not a damped sinusoid"), "{out}");
    refused(record(0.0).as_bytes(), &[], &["y, 6000 rows. This column does not oscillate clearly above the noise"]);
}
