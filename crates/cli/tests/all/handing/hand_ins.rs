//! Hand-ins: made from a project, verified, and told apart.

use crate::common::meniscus;
use document::page::Source;
use saved::Item;
use saved::format::{Content, Record};
use saved::project::Project;
use serde_json::Value;
use std::path::{Path, PathBuf};

const DOCUMENT: &str = include_str!("../../../../../simulations/theories/linear.md");

/// A project with one record, and its path.
fn project(directory: &Path) -> PathBuf {
    let row = |index: u32| {
        let scatter = f64::from(index * 7919 % 11) - 5.0;
        format!("{:.3},{:.5}\n", f64::from(index) / 30.0, f64::from(60 - index) * 1e-4 + 3e-4 * scatter)
    };
    let text = std::iter::once("t [s],y [m]\n".to_owned()).chain((0..60).map(row)).collect();
    let record = Record { name: "tube\u{1b}[31m.csv".to_owned(), text, ..Record::default() };
    let project = Project {
        documents: vec![Source { name: "linear.md".to_owned(), text: DOCUMENT.to_owned() }],
        items: vec![("r".to_owned(), Item(Content::Record(record)).write(5))],
        ..Project::default()
    };
    let path = directory.join("tube.meniscus");
    std::fs::write(&path, project.write()).unwrap();
    path
}

/// Makes a hand-in of this name in a folder, and returns its path.
fn handed(project: &Path, folder: &Path, name: &str) -> PathBuf {
    std::fs::create_dir_all(folder).unwrap();
    let path = folder.join(format!("{name}.hand-in"));
    let words = ["hand-in", project.to_str().unwrap(), "--name", name, "--output", path.to_str().unwrap()];
    let done = meniscus(&words);
    assert_eq!(done.code, 0, "{}", done.stderr);
    path
}

/// Exit code, and results by file name.
fn verified(folder: &Path) -> (i32, Value) {
    let done = meniscus(&["verify", folder.to_str().unwrap(), "--format", "json"]);
    (done.code, serde_json::from_str(&done.stdout).unwrap())
}

#[test]
fn an_honest_hand_in_holds() {
    let directory = tempfile::tempdir().unwrap();
    let path = handed(&project(directory.path()), &directory.path().join("in"), "blue heron");
    let done = meniscus(&["verify", path.to_str().unwrap()]);
    assert_eq!((done.code, done.stderr.as_str()), (0, ""));
    assert!(done.stdout.contains("(blue heron): 16 values computed again, all equal"), "{}", done.stdout);
    assert!(done.stdout.contains("does not show who took the data"), "{}", done.stdout);
    let spanish = meniscus(&["--language", "es", "verify", path.to_str().unwrap()]);
    assert!(spanish.stdout.contains("16 valores calculados de nuevo, todos iguales"), "{}", spanish.stdout);
}

#[test]
fn parts_without_values_are_named_with_the_reason() {
    let directory = tempfile::tempdir().unwrap();
    let path = project(directory.path());
    let mut project = Project::read(&std::fs::read_to_string(&path).unwrap()).unwrap();
    let fit = include_str!("../../../../desk/tests/all/stored/fit.json").trim().to_owned();
    project.items.push(("fit".to_owned(), fit));
    "2&b=9".clone_into(&mut project.state);
    std::fs::write(&path, project.write()).unwrap();
    let done = meniscus(&["hand-in", path.to_str().unwrap(), "--name", "a"]);
    assert_eq!(done.code, 0, "{}", done.stderr);
    for expected in [
        "Without values for fit of theories/linear.md: its record ",
        " is missing\n",
        "Without values for state of the run: it cannot be read\n",
    ] {
        assert!(done.stderr.contains(expected), "{expected}: {}", done.stderr);
    }
    let spanish = meniscus(&["--language", "es", "hand-in", path.to_str().unwrap(), "--name", "a"]);
    assert!(
        spanish.stderr.contains("Sin valores para ajuste de theories/linear.md: falta su registro "),
        "{}",
        spanish.stderr
    );
}

#[test]
fn damaged_repeated_changed_and_copied_hand_ins_are_told_apart() {
    let directory = tempfile::tempdir().unwrap();
    let (project, folder) = (project(directory.path()), directory.path().join("in"));
    let honest = std::fs::read_to_string(handed(&project, &folder, "a")).unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.join(name), text).unwrap();
    write("cut.hand-in", &honest[..honest.len() / 2]);
    write("other.hand-in", "{}");
    write("later.hand-in", &honest.replace("\"meniscus hand-in\":2", "\"meniscus hand-in\":3"));
    write("changed.hand-in", &honest.replace("1.967,", "1.968,").replace("\"name\":\"a\"", "\"name\":\"b\""));
    let before = honest.find("\"made\":").unwrap() + 7;
    write("again.hand-in", &format!("{}1{}", &honest[..before], &honest[before..]));
    let (code, found) = verified(&folder);
    assert_eq!(code, 1);
    let of = |name: &str| {
        let all = found["hand_ins"].as_array().unwrap();
        all.iter().find(|one| one["file"].as_str().unwrap().ends_with(name)).unwrap().clone()
    };
    assert_eq!(of("cut.hand-in")["unreadable"], "is damaged; ask for it again");
    assert_eq!(of("other.hand-in")["unreadable"], "is no hand-in of Meniscus");
    assert!(of("later.hand-in")["unreadable"].as_str().unwrap().contains("later version"));
    // The one that was made last counts.
    assert!(of("a.hand-in")["repeated_by"].as_str().unwrap().ends_with("again.hand-in"));
    assert_eq!(of("again.hand-in")["holds"], true);
    let changed = of("changed.hand-in");
    assert_eq!((&changed["holds"], &changed["differences"][0]["quantity"]), (&false.into(), &"content".into()));
    let shared = found["shared"].as_array().unwrap();
    assert_eq!((shared.len(), &shared[0]["common_source"]), (1, &false.into()));
}

#[test]
fn texts_of_strangers_do_not_reach_the_terminal_unescaped() {
    let directory = tempfile::tempdir().unwrap();
    let path = handed(&project(directory.path()), directory.path(), "x");
    let text = std::fs::read_to_string(&path).unwrap();
    std::fs::write(&path, text.replace("1.967,", "1.968,")).unwrap();
    let done = meniscus(&["verify", path.to_str().unwrap()]);
    assert_eq!(done.code, 1);
    assert!(done.stdout.contains("content") && !done.stdout.contains('\u{1b}'), "{}", done.stdout);
}

#[test]
fn wrong_arguments_are_refused() {
    let directory = tempfile::tempdir().unwrap();
    let folder = directory.path().to_str().unwrap();
    let empty = meniscus(&["verify", folder]);
    assert_eq!(empty.code, 2);
    assert!(empty.stderr.contains("has no hand-ins") && empty.stderr.contains(".hand-in"), "{}", empty.stderr);
    let project = project(directory.path());
    let same = meniscus(&["hand-in", project.to_str().unwrap(), "--name", "a", "--output", project.to_str().unwrap()]);
    assert_eq!(same.code, 2, "{}", same.stderr);
    assert_eq!(meniscus(&["hand-in", project.to_str().unwrap(), "--name", "a", "--seat", "0"]).code, 2);
}

#[test]
fn the_results_of_a_class_are_pooled() {
    let directory = tempfile::tempdir().unwrap();
    let folder = directory.path().join("in");
    let items = [
        ("159d2ddcf951f93c", include_str!("../../../../desk/tests/all/stored/record.json")),
        ("fit", include_str!("../../../../desk/tests/all/stored/fit.json")),
    ];
    let items = items.map(|(name, text)| (name.to_owned(), text.trim().to_owned())).to_vec();
    let documents = vec![Source { name: "linear.md".to_owned(), text: DOCUMENT.to_owned() }];
    let project = Project { documents, items, ..Project::default() };
    let path = directory.path().join("tube.meniscus");
    std::fs::write(&path, project.write()).unwrap();
    let folder_name = folder.to_str().unwrap();
    handed(&path, &folder, "a");
    let alone = meniscus(&["class", "report", folder_name]);
    assert_eq!(alone.code, 0, "{}", alone.stderr);
    assert!(
        alone.stdout.contains("Linear damping: gamma [1/s]") && alone.stdout.contains("two groups at least"),
        "{}",
        alone.stdout
    );
    handed(&path, &folder, "b");
    std::fs::write(folder.join("cut.hand-in"), "{").unwrap();
    let two = meniscus(&["class", "report", folder_name]);
    assert!(
        two.stdout.contains("Pooled, n = 2: ") && two.stdout.contains("agree within their errors"),
        "{}",
        two.stdout
    );
    assert!(two.stderr.contains("cut.hand-in is damaged"), "{}", two.stderr);
    let line = ["class", "report", folder_name, "--against", "1/drift", "--power"];
    let against = meniscus(&[&line[..], &["omega_0^2"]].concat());
    assert!(
        against.stdout.contains("omega_0^2 [1/s²] against 1/drift [s/m]") && against.stdout.contains("No line: "),
        "{}",
        against.stdout
    );
    for (words, expected) in [("omega_0^x", "is no power of a quantity"), ("b", "has drift held fixed")] {
        let refused = meniscus(&[&line[..], &[words]].concat());
        assert!(refused.code == 2 && refused.stderr.contains(expected), "{}", refused.stderr);
    }
    assert_eq!(meniscus(&[&line[..], &["omega_0", "--format", "csv"]].concat()).code, 2);
    let page = meniscus(&[&line[..], &["omega_0^2", "--format", "html"]].concat()).stdout;
    assert!(
        page.contains("Results against a parameter") && page.contains("omega_0^2 [1/s²] against 1/drift"),
        "{page:.3000}"
    );
    let found = meniscus(&["class", "report", folder_name, "--format", "json"]);
    let found: Value = serde_json::from_str(&found.stdout).unwrap();
    let gamma = found.as_array().unwrap().iter().find(|one| one["quantity"] == "gamma").unwrap();
    assert!((gamma["pooled"]["value"].as_f64().unwrap() - 0.402).abs() < 0.001, "{gamma}");
    assert_eq!(gamma["results"].as_array().unwrap().len(), 2);
    let table = meniscus(&["class", "report", folder_name, "--format", "csv"]).stdout;
    let rows: Vec<&str> = table.lines().filter(|line| line.contains(",gamma,")).collect();
    assert!(rows.len() == 3 && rows[0].starts_with("Linear damping,gamma,1/s,a,0.40"), "{table}");
    // The pooled value with n, interval and tau; every row has as many cells as the head.
    assert!(rows[2].starts_with("Linear damping,gamma,1/s,pooled,0.40") && rows[2].contains(",,2,"), "{table}");
    assert!(table.lines().all(|line| line.split(',').count() == 13), "{table}");
    // The form follows the ending of the file.
    for (file, expected) in [("class.html", "<!doctype html>"), ("class.xlsx", "PK"), ("class.csv", "theory,quantity")]
    {
        let path = directory.path().join(file);
        let made = meniscus(&["class", "report", folder_name, "--output", path.to_str().unwrap()]);
        assert_eq!(made.code, 0, "{}", made.stderr);
        assert!(std::fs::read(&path).unwrap().starts_with(expected.as_bytes()), "{file}");
        #[cfg(unix)]
        assert_eq!(crate::common::mode(&path), 0o600, "{file}");
    }
    // A hand-in is not overwritten by the report on its folder.
    let own = folder.join("a.hand-in");
    let before = std::fs::read(&own).unwrap();
    let over = meniscus(&["class", "report", folder_name, "--output", own.to_str().unwrap()]);
    assert_eq!((over.code, std::fs::read(&own).unwrap()), (2, before), "{}", over.stderr);
}

/// A tolerance that was changed in the document of one hand-in, beside the document of the lesson.
#[test]
fn a_document_that_is_not_the_given_one_is_named_with_its_lines() {
    let directory = tempfile::tempdir().unwrap();
    let (project, folder) = (project(directory.path()), directory.path().join("in"));
    handed(&project, &folder, "a");
    let changed = std::fs::read_to_string(&project).unwrap().replace("Damping rate", "Rate of damping");
    assert_ne!(changed, std::fs::read_to_string(&project).unwrap());
    std::fs::write(&project, changed).unwrap();
    handed(&project, &folder, "b");
    let document = directory.path().join("linear.md");
    std::fs::write(&document, DOCUMENT.replace('\n', "\r\n")).unwrap();
    let (document, folder) = (document.to_str().unwrap(), folder.to_str().unwrap());
    let done = meniscus(&["verify", folder, "--document", document, "--format", "json"]);
    let found: Value = serde_json::from_str(&done.stdout).unwrap();
    let of = |index: usize| found["hand_ins"][index]["document"].clone();
    assert_eq!((done.code, of(0)), (1, Value::Null));
    assert_eq!(of(1)["with"], "given document");
    assert!(of(1)["lines"][0]["own"].as_str().unwrap().contains("Rate of damping"), "{found:#}");
    let text = meniscus(&["verify", folder, "--document", document]).stdout;
    assert!(text.contains("its document differs from the given one; lines that differ: "), "{text}");
}

/// Without a given document, one that differs from that of the others is named, and the exit code says so.
#[test]
fn a_document_unlike_that_of_the_majority_sets_the_exit_code() {
    let directory = tempfile::tempdir().unwrap();
    let folder = directory.path().join("in");
    let add = |name: &str, text: String| {
        let documents = vec![Source { name: "linear.md".to_owned(), text }];
        let path = directory.path().join("work.meniscus");
        std::fs::write(&path, Project { documents, ..Project::default() }.write()).unwrap();
        handed(&path, &folder, name);
    };
    add("a", DOCUMENT.to_owned());
    add("b", DOCUMENT.to_owned());
    assert_eq!(verified(&folder).0, 0);
    add("c", DOCUMENT.replace("Damping rate", "Rate of damping"));
    let (code, found) = verified(&folder);
    assert_eq!((code, &found["hand_ins"][2]["document"]["with"]["hand_ins"]), (1, &Value::from(2)), "{found:#}");
}
