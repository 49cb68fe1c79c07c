//! `meniscus class assign` and `--seat`.

use crate::common::meniscus;
use serde_json::Value;

const TUBE: &str = "crates/play/tests/all/support/assigned.md";

#[test]
fn values_and_answers_of_all_seats_are_listed() {
    let text = meniscus(&["class", "assign", TUBE, "--seats", "40"]);
    assert_eq!((text.code, text.stderr.as_str()), (0, ""));
    let lines: Vec<&str> = text.stdout.lines().collect();
    assert_eq!(lines[0], "A tube: tube-2026");
    let heading: Vec<&str> = lines[2].split("  ").map(str::trim).filter(|cell| !cell.is_empty()).collect();
    assert_eq!(heading, ["seat", "b [kg/s]", "zeta_q [1/s]", "answer 1 [1/s]"]);
    let json = meniscus(&["class", "assign", TUBE, "--seats", "40", "--format", "json"]);
    let list: Value = serde_json::from_str(&json.stdout).unwrap();
    let seats = list["seats"].as_array().unwrap();
    assert_eq!((seats.len(), &list["equal"]), (40, &Value::Array(Vec::new())));
    assert_eq!(list["parameters"][1]["hidden"], true);
    for seat in seats {
        assert_eq!(seat["values"][1], seat["answers"][0]);
    }
    let csv = meniscus(&["class", "assign", TUBE, "--seats", "40", "--format", "csv"]);
    #[cfg(unix)]
    {
        let folder = tempfile::tempdir().unwrap();
        let list = folder.path().join("seats.csv");
        meniscus(&["class", "assign", TUBE, "--seats", "4", "--output", list.to_str().unwrap()]);
        assert_eq!(crate::common::mode(&list), 0o600);
    }
    let row = csv.stdout.lines().nth(7).unwrap();
    assert_eq!(row, format!("7,{0},{1},{1}", seats[6]["values"][0], seats[6]["values"][1]));
    let spanish = meniscus(&["class", "assign", TUBE, "--seats", "8", "--language", "es"]);
    assert!(spanish.stdout.contains("puesto") && spanish.stdout.contains("respuesta 1"), "{}", spanish.stdout);
}

#[test]
fn a_run_takes_the_values_of_a_seat() {
    let run = |more: &[&str]| meniscus(&[&["run", TUBE, "--until", "0.2", "--columns", "t,y,b"], more].concat());
    let list = meniscus(&["class", "assign", TUBE, "--seats", "8", "--format", "csv"]).stdout;
    let damping = list.lines().nth(7).unwrap().split(',').nth(1).unwrap();
    let seventh = run(&["--seat", "7"]);
    assert_eq!((seventh.code, seventh.stderr.as_str()), (0, ""));
    assert!(seventh.stdout.lines().skip(1).all(|row| row.ends_with(&format!(",{damping}"))), "{}", seventh.stdout);
    assert_ne!(seventh.stdout, run(&["--seat", "8"]).stdout);
    assert!(run(&[]).stdout.lines().skip(1).all(|row| row.ends_with(",0.02")));
}

#[test]
fn what_has_no_seat_says_so() {
    for seat in ["0", "-1", "seven", "1.5"] {
        assert_eq!(meniscus(&["run", TUBE, &format!("--seat={seat}")]).code, 2, "{seat}");
    }
    for words in
        [["run", "simulations/utube.md", "--seat", "7"], ["class", "assign", "simulations/utube.md", "--seats=9"]]
    {
        let done = meniscus(&words);
        assert_eq!(done.code, 2);
        assert!(done.stderr.contains("the document assigns no values to seats"), "{}", done.stderr);
        assert!(done.stderr.contains("`assignment: NAME`"), "{}", done.stderr);
    }
    // A hidden parameter is no column.
    let hidden = meniscus(&["run", TUBE, "--columns", "t,zeta_q"]);
    assert_eq!((hidden.code, hidden.stdout.as_str()), (2, ""));
}

/// Few values cannot differ for many seats, and that is said.
#[test]
fn equal_seats_are_named() {
    let text =
        "---\nassignment: few\n---\n```model\nparameter n = 1 [1/s] assigned 1..8 step 1\nx' = -n*x\nx(0) = 1\n```\n";
    let (_directory, few) = crate::common::directory_with(text);
    let done = meniscus(&["class", "assign", few.to_str().unwrap(), "--seats", "16"]);
    assert_eq!((done.code, done.stdout.matches("have equal values").count()), (0, 8), "{}", done.stdout);
}
