//! `meniscus run`: output, messages of refusals, and complete files only.

use crate::common::{Done, SPRING, directory_with, done, meniscus, names, numbers, program};
use std::path::Path;
use std::process::Stdio;

/// Runs a spring with these arguments after its name.
fn run_spring(words: &[&str]) -> Done {
    let (_directory, path) = directory_with(SPRING);
    run(&path, words)
}

fn run(path: &Path, words: &[&str]) -> Done {
    let mut all = vec!["run", path.to_str().expect("UTF-8")];
    all.extend(words);
    meniscus(&all)
}

/// Asserts a refusal with this exit code and this text, and nothing on the standard output.
fn refused(words: &[&str], code: i32, expected: &[&str]) {
    let done = run_spring(words);
    assert_eq!(done.code, code, "{words:?}: {}", done.stderr);
    assert_eq!(done.stdout, "", "{words:?}");
    for part in expected {
        assert!(done.stderr.contains(part), "{words:?} lacks «{part}»:\n{}", done.stderr);
    }
}

#[test]
fn the_table_has_a_header_with_units_and_every_step() {
    let done = run_spring(&[]);
    assert_eq!((done.code, done.stderr.as_str()), (0, ""));
    let mut lines = done.stdout.lines();
    assert_eq!(lines.next(), Some("t [s],x [cm],x' [m/s],E [J]"));
    assert_eq!(lines.next(), Some("0,5,0,0.010000000000000002"));
    assert_eq!(numbers(&done.stdout).len(), 21);
    assert!(done.stdout.ends_with('\n'));
}

#[test]
fn columns_can_be_chosen_and_ordered() {
    let done = run_spring(&["--columns", "E, t,k"]);
    assert!(done.stdout.starts_with("E [J],t [s],k [N/m]\n0.010000000000000002,0,8\n"), "{}", done.stdout);
}

#[test]
fn json_and_json_lines_hold_the_same_numbers() {
    let array = run_spring(&["--columns", "t,x", "--format", "json"]).stdout;
    let rows: Vec<serde_json::Value> = serde_json::from_str(&array).expect("an array");
    let lines = run_spring(&["--columns", "t,x", "--format", "jsonl"]).stdout;
    let parsed: Vec<serde_json::Value> =
        lines.lines().map(|line| serde_json::from_str(line).expect("an object")).collect();
    assert_eq!(rows.len(), 21);
    assert_eq!(rows, parsed);
    let csv = numbers(&run_spring(&["--columns", "t,x"]).stdout);
    let values = rows[7].as_object().expect("an object").values().map(|value| value.as_f64().expect("a number"));
    assert_eq!(values.collect::<Vec<_>>(), csv[7]);
}

#[test]
fn json_has_texts_truth_values_and_nulls() {
    let model = "y' = 2 [cm/s]\ny(0) = 0 [m] in [cm]\nx = 1e-6 [m]*t/(2 [s]) in [nm]\n\
                 kind = if t > 0.05 [s] then \"late, very\" else \"early\"\nlate = t > 0.05 [s]\nw = ln(t/(1 [s]))\n";
    let document = format!("---\ntitle: T\nuntil: 0.1 [s]\nstep: 0.1 [s]\nmethod: euler\n---\n```model\n{model}```\n");
    let (_directory, path) = directory_with(&document);
    let first = r#"{"t [s]":0,"y [cm]":0,"x [nm]":0,"kind":"early","late":false,"w":null}"#;
    let second = r#"{"t [s]":0.1,"y [cm]":0.2,"x [nm]":50,"kind":"late, very","late":true,"w":-2.3025850929940455}"#;
    assert_eq!(run(&path, &["--format", "json"]).stdout, format!("[\n{first},\n{second}\n]\n"));
    assert_eq!(run(&path, &["--format", "jsonl"]).stdout, format!("{first}\n{second}\n"));
}

#[test]
fn settings_take_units_bare_numbers_and_expressions() {
    for same in ["x_0=5", "x_0=50 [mm]", "x_0 = 0.05 [m]", "x_0=2*25 [mm]", "x_0=m*5 [cm]/2 [kg]"] {
        assert_eq!(run_spring(&["--set", same]).stdout, run_spring(&[]).stdout, "{same}");
    }
    let done = run_spring(&["--set", "x_0=-10", "--until", "0.1"]);
    assert!(done.stdout.contains("\n0,-10,0,0.04"), "{}", done.stdout);
    assert_eq!(numbers(&run_spring(&["--until", "500 [ms]", "--step", "0.25"]).stdout).len(), 3);
    let stiff = run_spring(&["--preset", "stiff", "--columns", "k,omega", "--until", "0.1"]);
    assert!(stiff.stdout.contains("\n50,5\n"), "{}", stiff.stdout);
    let moved = run_spring(&["--start", "x=1", "--start", "x'=20 [cm/s]", "--columns", "x,x'", "--until", "0.1"]);
    assert!(moved.stdout.starts_with("x [cm],x' [m/s]\n1,0.2\n"), "{}", moved.stdout);
}

/// A preset sets its parameters one after the other, as in the page: a later value follows from the ones before it, and so does a
/// value at the start in it.
#[test]
fn the_values_of_a_preset_follow_from_the_ones_before_them() {
    let presets = "\n```presets\n\"Chain\": m = 8 [kg], k = 2 [N/(kg m)]*m, x_0 = m/(1 [kg])*1 [cm]\n\
                   \"Start\": x_0 = 3 [cm], k = x(0)*1000 [N/m^2]\n```\n";
    let (_directory, path) = directory_with(&(SPRING.to_owned() + presets));
    let path = path.to_str().unwrap();
    for (preset, expected) in [("Chain", "\n8,16,8\n"), ("Start", "\n2,30,3\n")] {
        let done = meniscus(&["run", path, "--preset", preset, "--columns", "m,k,x_0", "--until", "0.1"]);
        assert!(done.stdout.contains(expected), "{preset}: {}{}", done.stdout, done.stderr);
    }
    // Each is checked in its range, with the values before it.
    let wrong = presets.replace("m = 8", "m = 10").replace("2 [N/(kg m)]", "11 [N/(kg m)]");
    let (_directory, path) = directory_with(&(SPRING.to_owned() + &wrong));
    let done = meniscus(&["run", path.to_str().unwrap(), "--preset", "Chain"]);
    assert!(done.code == 2 && done.stderr.contains("k = 110 N/m is out of range"), "{}", done.stderr);
}

#[test]
fn wrong_settings_are_refused_with_the_remedy() {
    refused(&["--set", "x_0=30"], 2, &["x_0 = 30 cm is out of range", "from -20 cm to 20 cm"]);
    refused(&["--set", "m=0"], 2, &["from 0.5 kg to 10 kg"]);
    refused(&["--set", "mm=1"], 2, &["no parameter `mm`", "did you mean `m`?"]);
    refused(&["--set", "viscosity=1"], 2, &["no parameter `viscosity`", "m, k and x_0"]);
    refused(&["--set", "omega=1"], 2, &["`omega` is defined by the document"]);
    refused(&["--set", "x=1"], 2, &["--start"]);
    refused(&["--set", "m=1 [s]"], 2, &["--set m", "kg", "in s"]);
    refused(&["--set", "m=1 [kgs]"], 2, &["kgs"]);
    refused(&["--set", "m=abc"], 2, &["abc"]);
    refused(&["--set", "x_0=x"], 2, &["changes during the run"]);
    refused(&["--set", "m=inf"], 2, &["--set m"]);
    refused(&["--set", "m"], 2, &["NAME=VALUE"]);
    refused(&["--preset", "Stif"], 2, &["no preset `Stif`", "did you mean `Stiff`?"]);
    refused(&["--start", "z=1"], 2, &["no variable `z`"]);
    refused(&["--columns", "t,Energy"], 2, &["no column `Energy`"]);
    refused(&["--method", "rk5"], 2, &["no method `rk5`", "did you mean `rk4`?"]);
    refused(&["--step", "0"], 2, &["--step must be greater than 0"]);
    refused(&["--until", "-1"], 2, &["--until must be greater than 0"]);
    refused(&["--until", "5 [m]"], 2, &["--until is in s"]);
    refused(&["--until", "1e300"], 2, &["too many steps"]);
    refused(&["--format", "xml"], 2, &["xml", "csv"]);
}

#[test]
fn missing_files_and_other_bytes_are_named() {
    let done = meniscus(&["run", "no-such-file.md"]);
    assert_eq!(done.code, 2);
    assert!(done.stderr.contains("cannot read no-such-file.md: No such file"), "{}", done.stderr);
    let (directory, path) = directory_with("");
    std::fs::write(&path, b"title\n\xff\xfe").expect("it can be written");
    let done = run(&path, &[]);
    assert_eq!(done.code, 2);
    assert!(done.stderr.contains("is not text in UTF-8 (line 2)"), "{}", done.stderr);
    assert_eq!(meniscus(&["run", directory.path().to_str().expect("UTF-8")]).code, 2);
    assert_eq!(meniscus(&[]).code, 2);
    assert_eq!(meniscus(&["fly"]).code, 2);
}

#[test]
fn a_document_with_errors_does_not_run() {
    let (_directory, path) = directory_with(&SPRING.replace("k*x = 0", "k*y = 0"));
    let done = run(&path, &[]);
    assert_eq!((done.code, done.stdout.as_str()), (1, ""));
    assert!(done.stderr.contains("error["), "{}", done.stderr);
    assert!(done.stderr.contains("spring.md:15:"), "{}", done.stderr);
}

#[test]
fn files_appear_whole() {
    let (directory, path) = directory_with(SPRING);
    let table = directory.path().join("table.csv");
    let done = run(&path, &["--output", table.to_str().expect("UTF-8")]);
    assert_eq!((done.code, done.stdout.as_str(), done.stderr.as_str()), (0, "", ""));
    assert_eq!(std::fs::read_to_string(&table).expect("a file"), run(&path, &[]).stdout);
    let lines = directory.path().join("table.jsonl");
    assert_eq!(run(&path, &["--output", lines.to_str().expect("UTF-8")]).code, 0);
    assert!(std::fs::read_to_string(&lines).expect("a file").starts_with('{'));
    assert_eq!(names(directory.path()), ["spring.md", "table.csv", "table.jsonl"]);
}

#[test]
fn a_run_that_fails_leaves_the_old_file() {
    let exploding = SPRING.replace("m*x'' + k*x = 0", "m*x'' + k*x = 1e300 [N/m^3]*x^3");
    let (directory, path) = directory_with(&exploding);
    let table = directory.path().join("table.csv");
    std::fs::write(&table, "old").expect("it can be written");
    let done = run(&path, &["--output", table.to_str().expect("UTF-8")]);
    assert_eq!(done.code, 1, "{}", done.stderr);
    assert!(done.stderr.contains("spring.md:"), "it says where: {}", done.stderr);
    assert_eq!(std::fs::read_to_string(&table).expect("a file"), "old");
    assert_eq!(names(directory.path()), ["spring.md", "table.csv"]);
    let array = run(&path, &["--format", "json"]);
    assert_eq!(array.code, 1);
    assert!(serde_json::from_str::<serde_json::Value>(&array.stdout).is_ok(), "{}", array.stdout);
}

#[test]
fn outputs_that_cannot_be_written_are_named() {
    let (directory, path) = directory_with(SPRING);
    let inside = |name: &str| directory.path().join(name).to_str().expect("UTF-8").to_owned();
    for (output, words) in [
        (inside("no/such/table.csv"), "No such file"),
        (inside(""), "it is a directory"),
        (inside("spring.md"), "is the document itself"),
    ] {
        let done = run(&path, &["--output", &output]);
        assert_eq!(done.code, 2, "{output}");
        assert!(done.stderr.contains(words), "{}", done.stderr);
    }
    assert_eq!(names(directory.path()), ["spring.md"]);
}

#[cfg(unix)]
#[test]
fn devices_are_written_to_and_not_replaced() {
    use std::os::unix::fs::{FileTypeExt, PermissionsExt};
    assert_eq!(run_spring(&["--output", "/dev/null"]).code, 0);
    assert!(std::fs::metadata("/dev/null").expect("it is there").file_type().is_char_device());
    let (directory, path) = directory_with(SPRING);
    let table = directory.path().join("table.csv");
    std::fs::write(&table, "old").expect("it can be written");
    std::fs::set_permissions(&table, std::fs::Permissions::from_mode(0o640)).expect("it is ours");
    assert_eq!(run(&path, &["--output", table.to_str().expect("UTF-8")]).code, 0);
    assert_eq!(std::fs::metadata(&table).expect("it is there").permissions().mode() & 0o777, 0o640);
}

#[test]
fn a_reader_that_has_seen_enough_is_no_error() {
    let (_directory, path) = directory_with(SPRING);
    let mut command = program();
    command.args(["run", path.to_str().expect("UTF-8"), "--until", "100000"]);
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts");
    drop(child.stdout.take());
    let done = done(child.wait_with_output().expect("it ends"));
    assert_eq!((done.code, done.stderr.as_str()), (0, ""));
}

#[test]
fn a_document_comes_from_the_standard_input_too() {
    use std::io::Write;
    let mut child =
        program().args(["run", "-"]).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().expect("it starts");
    child.stdin.take().expect("a pipe").write_all(SPRING.as_bytes()).expect("it reads");
    let done = done(child.wait_with_output().expect("it ends"));
    assert_eq!(done.stdout, run_spring(&[]).stdout);
}

#[test]
fn long_runs_are_the_same_as_short_ones_put_together() {
    let long = run_spring(&["--until", "5000", "--columns", "t,x,x'"]).stdout;
    assert_eq!(long.lines().count(), 50_002, "more than is kept in memory at once");
    let short = run_spring(&["--until", "20", "--columns", "t,x,x'"]).stdout;
    assert!(long.starts_with(&short));
    assert!(long.lines().last().is_some_and(|row| row.starts_with("5000,")));
}

#[test]
fn a_model_that_counts_leaves_a_row_at_each_count_and_takes_no_step() {
    let map = "---\ntitle: A map\nuntil: 4\n---\n\n```model\nindependent k by 1\nparameter r = 2 in 0..4\n\
               next x = r*x*(1 - x)\nx(0) = 0.25\n```\n";
    let (_directory, path) = directory_with(map);
    let done = run(&path, &["--set", "r=4"]);
    assert_eq!(
        (done.code, done.stdout.as_str()),
        (0, "k,x\n0,0.25\n1,0.75\n2,0.75\n3,0.75\n4,0.75\n"),
        "{}",
        done.stderr
    );
    for option in ["--step", "--tolerance"] {
        let done = run(&path, &[option, "0.5"]);
        assert!(
            done.code == 2 && done.stderr.contains("counts by 1") && done.stderr.contains(option),
            "{}",
            done.stderr
        );
    }
}

#[test]
fn buttons_are_pressed_by_title_name_and_translated_title() {
    let document = "---\ntitle: Kicked\nstep: 0.05 [s]\nuntil: 5 [s]\nmethod: dormand-prince\ntolerance: 1e-12\n---\n```model\n\
                    x'' = -4*x/(1 [s^2])\nx(0) = 0 [m]\nx'(0) = 0 [m/s]\n\
                    button \"Kick\" as kick { x' = x' + 1 [m/s] }\nbutton \"Stop, =\" { x' = 0 [m/s] }\n```\n";
    let (directory, path) = directory_with(document);
    let translation = "---\nlanguage: es\ntranslates: spring.md\n---\n```translations\n\"Kick\" = \"Patada\"\n\"Stop, =\" = \"Parar\"\n```\n";
    std::fs::write(directory.path().join("spring.es.md"), translation).expect("written");
    let done = run(&path, &["--press", "Kick=3.2"]);
    assert_eq!((done.code, done.stderr.as_str()), (0, ""));
    for row in numbers(&done.stdout) {
        let expected = libm::sin(2.0 * (row[0] - 3.2).max(0.0)) / 2.0;
        assert!((row[1] - expected).abs() < 1e-9, "{row:?}");
    }
    for same in ["kick=3.2", "Patada=3.2 [s]", " KICK = 3200 [ms]"] {
        assert_eq!(run(&path, &["--press", same]).stdout, done.stdout, "{same}");
    }
    let last = run(&path, &["--press", "Kick=5"]);
    assert_eq!(numbers(&last.stdout).iter().filter(|row| row[0] == 5.0).count(), 2, "before and after");
    let both = run(&path, &["--press", "Stop, ==4.01", "--press", "Kick=1"]);
    assert_eq!(numbers(&both.stdout).iter().filter(|row| row[0] == 4.01).count(), 2, "before and after");
    for (wrong, expected) in [
        ("Kik=1", "did you mean `Kick`?"),
        ("Kick=5.001", "between 0 and the end, 5 s"),
        ("Kick=-1", "between 0 and the end, 5 s"),
        ("Kick=1 [m]", "is in s"),
        ("Kick", "write BUTTON=TIME"),
    ] {
        let done = run(&path, &["--press", wrong]);
        assert!(done.code != 0 && done.stderr.contains(expected), "{wrong}: {}", done.stderr);
    }
    refused(&["--press", "Kick=1"], 2, &["the document has no buttons"]);
}

#[test]
fn a_table_is_drawn_through_the_points_of_a_file() {
    let document = "---\ntitle: Pushed\nstep: 0.1 [s]\nuntil: 2 [s]\n---\n```model\n\
                    table a(t) in [m/s^2] \"Push\" drawn in -5..5 until 10 [s]\n\
                    x'' = a(t)\nx(0) = 0 [m]\nx'(0) = 0 [m/s]\n```\n";
    let (directory, path) = directory_with(document);
    let file = |name: &str, text: &str| {
        let file = directory.path().join(name);
        std::fs::write(&file, text).expect("written");
        format!("a={}", file.display())
    };
    let still = run(&path, &[]);
    assert!(numbers(&still.stdout).iter().all(|row| row[1] == 0.0));
    for push in
        [file("push.csv", "t,a\n0,3\n10,3\n"), file("units.csv", "t [ms],a [cm/s^2]\n0,300\n5000,300\n10000,300\n")]
    {
        let done = run(&path, &["--draw", &push]);
        assert_eq!((done.code, done.stderr.as_str()), (0, ""), "{push}");
        for row in numbers(&done.stdout) {
            assert!((row[1] - 1.5 * row[0] * row[0]).abs() < 1e-9, "{row:?}");
        }
    }
    for (wrong, expected) in [
        (file("three.csv", "t,a,b\n0,3,1\n10,3,1\n"), "must have two"),
        (file("far.csv", "t,a\n0,3\n10,30\n"), "leaves the range from -5 to 5 m/s^2"),
        (file("back.csv", "t,a\n5,3\n0,3\n"), "must increase"),
        (file("unit.csv", "t [s],a [kg]\n0,3\n10,3\n"), "must be in m/s^2"),
        ("b=push.csv".to_owned(), "there is no drawn table `b`"),
    ] {
        let done = run(&path, &["--draw", &wrong]);
        assert!(done.code != 0 && done.stderr.contains(expected), "{wrong}: {}", done.stderr);
    }
}
