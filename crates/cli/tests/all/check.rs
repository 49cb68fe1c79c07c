//! `meniscus check`: findings as text and JSON.

use crate::common::{SPRING, directory_with, meniscus, names, root};

/// A project of the laboratory is checked as the documents in it.
#[test]
fn a_project_is_checked_and_run_as_its_document() {
    let directory = tempfile::tempdir().expect("a directory");
    let source =
        document::page::Source { name: "a.md".to_owned(), text: "```model\nx' = 1 [1/s]\nx(0) = 0\n```\n".to_owned() };
    let whole = saved::project::Project { documents: vec![source], ..Default::default() }.write();
    let path = directory.path().join("a.meniscus");
    let file = path.to_str().expect("UTF-8");
    std::fs::write(&path, &whole).expect("it can be written");
    assert_eq!(meniscus(&["check", file]).code, 0);
    assert!(meniscus(&["run", file, "--until", "1"]).stdout.starts_with("t [s],x"));
    for (content, reason) in
        [(&whole[..40], "damaged or no project"), (&whole.replace("\":1,", "\":2,"), "later version")]
    {
        std::fs::write(&path, content).expect("it can be written");
        let done = meniscus(&["check", file]);
        assert_eq!(done.code, 2);
        assert!(done.stderr.contains(reason), "{}", done.stderr);
    }
}

#[test]
fn the_documents_that_ship_have_no_findings() {
    let simulations = root().join("simulations");
    // Translations are checked with their documents.
    let is_document = |name: &String| name.ends_with(".md") && name.matches('.').count() == 1;
    let documents: Vec<String> = names(&simulations).into_iter().filter(is_document).collect();
    assert!(documents.len() >= 2, "{documents:?}");
    let paths: Vec<String> = documents.iter().map(|document| format!("simulations/{document}")).collect();
    let words: Vec<&str> = std::iter::once("check").chain(paths.iter().map(String::as_str)).collect();
    let done = meniscus(&words);
    assert_eq!((done.code, done.stderr.as_str()), (0, ""), "{}", done.stdout);
    for path in &paths {
        assert!(done.stdout.contains(&format!("{path}: ok\n")), "{path}: {}", done.stdout);
    }
    assert_eq!(meniscus(&["check", &paths[0], &paths[1], "--format", "json"]).stdout, "[]\n");
}

/// Proposals are printed with their lines; a suspicion is no error.
#[test]
fn claims_are_proposed_as_text_and_as_json() {
    let fault = "---\ntitle: A spring\nuntil: 10 [s]\n---\n\n```model\nm = 1 [kg]\nk = 4 [N/m]\n\
        m*y'' = -k*y\ny(0) = 1 [m]\ny'(0) = 0 [m/s]\nE = m*y'^2/2 + k*y^2 \"Energy\"\n```\n";
    let (_directory, path) = directory_with(fault);
    let path = path.to_str().expect("UTF-8");
    let done = meniscus(&["check", "--propose", path]);
    assert_eq!((done.code, done.stderr.as_str()), (0, ""), "{}", done.stdout);
    assert!(done.stdout.contains(": ok, proposals: 1, suspicions: 1\n"), "{}", done.stdout);
    assert!(done.stdout.contains("  ? energy E: "), "{}", done.stdout);
    assert!(done.stdout.contains("      \"E is kept\": E within 0.1 % of E(0) always\n"), "{}", done.stdout);

    let done = meniscus(&["check", "--propose", "--format", "json", path]);
    let all: serde_json::Value = serde_json::from_str(&done.stdout).expect("JSON");
    assert_eq!(all["findings"], serde_json::json!([]));
    let proposal = &all["documents"][0]["proposals"][0];
    assert_eq!((proposal["key"].as_str(), proposal["holds"].as_bool()), (Some("energy E"), Some(false)));
    assert!(proposal["suspicion"].as_str().is_some_and(|text| text.contains("-1 times")), "{all}");
}

#[test]
fn findings_name_file_line_column_and_remedy() {
    let (_directory, path) = directory_with(&SPRING.replace("k*x = 0", "kk*x = 0"));
    let path = path.to_str().expect("UTF-8");
    let done = meniscus(&["check", path]);
    assert_eq!((done.code, done.stderr.as_str()), (1, ""));
    assert!(done.stdout.contains(&format!("{path}:15:9")), "{}", done.stdout);
    assert!(done.stdout.contains("m*x'' + kk*x = 0"), "the line itself: {}", done.stdout);
    assert!(done.stdout.contains("hint: "), "{}", done.stdout);
    assert!(done.stdout.ends_with(": 1 error\n"), "{}", done.stdout);
    assert!(!done.stdout.contains('\u{1b}'), "no colours in a pipe");

    let done = meniscus(&["check", path, "--format", "json"]);
    assert_eq!(done.code, 1);
    let findings: serde_json::Value = serde_json::from_str(&done.stdout).expect("JSON");
    let finding = &findings[0];
    assert_eq!(findings.as_array().map(Vec::len), Some(1), "{findings}");
    assert_eq!(finding["file"], path);
    assert_eq!(finding["severity"], "error");
    assert_eq!(finding["code"], "unknown-name");
    assert_eq!((&finding["line"], &finding["column"]), (&15.into(), &9.into()));
    assert_eq!((&finding["end"]["line"], &finding["end"]["column"]), (&15.into(), &11.into()));
    assert!(finding["hints"].as_array().is_some_and(|hints| !hints.is_empty()), "{finding}");
    assert!(finding["notes"].is_array() && finding["labels"].is_array(), "{finding}");
}

#[test]
fn a_translation_is_checked_with_its_base() {
    let (directory, base) = directory_with(SPRING);
    let translation = directory.path().join("spring.es.md");
    std::fs::write(&translation, "---\ntitle: Un muelle\nlanguage: es\ntranslates: spring.md\n---\n\nUn cuerpo.\n")
        .expect("it can be written");
    let (base, translation) = (base.to_str().expect("UTF-8"), translation.to_str().expect("UTF-8"));
    let done = meniscus(&["check", translation]);
    assert_eq!(done.code, 0, "{}{}", done.stdout, done.stderr);
    let both = meniscus(&["check", base, translation]);
    assert_eq!(both.stdout.lines().filter(|line| line.starts_with(&format!("{base}: "))).count(), 1, "checked once");
    let rows = |path: &str| meniscus(&["run", path, "--until", "1"]).stdout;
    assert_eq!(rows(translation), rows(base), "one model");
    std::fs::remove_file(base).expect("it is there");
    let alone = meniscus(&["check", translation]);
    assert_eq!(alone.code, 2);
    assert!(alone.stderr.contains("translates: spring.md"), "{}", alone.stderr);
}

#[test]
fn messages_are_in_the_language_asked_for_or_that_of_the_environment() {
    let (_directory, path) = directory_with(&SPRING.replace("k*x = 0", "kk*x = 0"));
    let path = path.to_str().expect("UTF-8");
    let spanish = meniscus(&["check", path, "--language", "es-MX"]);
    assert!(spanish.stdout.contains("error[unknown-name]: no se conoce `kk`"), "{}", spanish.stdout);
    assert!(spanish.stdout.contains("ayuda: ") && !spanish.stdout.contains("hint"), "{}", spanish.stdout);
    let from = |variables: &[(&str, &str)], arguments: &[&str]| {
        let mut command = crate::common::program();
        command.env_remove("LC_ALL").env_remove("LC_MESSAGES").env_remove("LANG").envs(variables.iter().copied());
        crate::common::done(command.args(arguments).output().expect("the program starts")).stdout
    };
    assert_eq!(from(&[("LANG", "es_ES.UTF-8")], &["check", path]), spanish.stdout);
    assert_eq!(from(&[("LANG", "en_GB"), ("LC_ALL", "es")], &["check", path]), spanish.stdout);
    assert_eq!(from(&[("LC_ALL", ""), ("LC_MESSAGES", "es"), ("LANG", "C")], &["check", path]), spanish.stdout);
    let english = meniscus(&["check", path]).stdout;
    assert_eq!(from(&[("LANG", "es"), ("LC_ALL", "fr_FR.UTF-8")], &["check", path]), english);
    assert_eq!(from(&[("LANG", "es")], &["check", path, "--language", "en"]), english);
    let json = meniscus(&["check", path, "--format", "json", "--language", "es"]).stdout;
    assert!(json.contains(r#""code": "unknown-name""#) && json.contains("no se conoce"), "{json}");
    let unknown = meniscus(&["check", path, "--language", "fr"]);
    assert_eq!(unknown.code, 2);
    assert!(unknown.stderr.contains("the languages are en and es"), "{}", unknown.stderr);
}

#[test]
fn refused_data_are_explained_in_spanish() {
    let directory = tempfile::tempdir().expect("a temporary directory");
    let path = directory.path().join("words.csv");
    std::fs::write(&path, "only\nwords\nhere\n").expect("it can be written");
    let done = meniscus(&["--language", "es", "cycles", path.to_str().expect("UTF-8")]);
    assert_eq!(done.code, 2);
    assert!(done.stderr.contains("no se puede leer") && done.stderr.contains("ayuda: "), "{}", done.stderr);
}

#[test]
fn colours_are_there_when_asked_for() {
    let (_directory, path) = directory_with("```model\nx'' = \n```\n");
    let done = meniscus(&["check", path.to_str().expect("UTF-8"), "--color", "always"]);
    assert!(done.stdout.contains("\u{1b}["), "{}", done.stdout);
}

#[test]
fn every_command_explains_itself_with_examples() {
    for command in ["serve", "run", "check", "cycles", "export"] {
        let done = meniscus(&[command, "--help"]);
        assert_eq!((done.code, done.stderr.as_str()), (0, ""));
        assert!(done.stdout.contains("Examples:\n  meniscus "), "{}", done.stdout);
    }
    let done = meniscus(&["--help"]);
    assert!(done.stdout.contains("Exit codes:"), "{}", done.stdout);
}

/// The claims of all documents are judged by the tests of `document`.
#[test]
fn the_claims_of_several_documents_hold() {
    let documents = ["simulations/tube.md", "simulations/pendulum.md", "simulations/theories/linear.md"];
    let done = meniscus(&[&["check", "--run"][..], &documents].concat());
    assert_eq!((done.code, done.stderr.as_str()), (0, ""), "{}", done.stdout);
    for document in documents {
        let line =
            done.stdout.lines().find(|line| line.starts_with(&format!("{document}: "))).expect("a line for each");
        assert!(line.contains(": ok, ") && line.ends_with("claims hold"), "{line}");
    }
}

/// A spring with two claims, the second of which is given.
fn claiming(claim: &str) -> String {
    let checks = "```check\nset: m = 1 [kg], k = 4*pi^2*1 [N/m]\n\"Energy is kept\": E within 0.1 % of E(0) always\n";
    let spring = SPRING.replace("step: 0.1 [s]", "step: 0.01 [s]");
    format!("{spring}\n{checks}\"Period\": {claim}\n```\n")
}

#[test]
fn claims_are_run_when_asked_for() {
    let (_directory, path) = directory_with(&claiming("x within 0.1 % of 5 [cm] at 1 [s]"));
    let path = path.to_str().expect("UTF-8");
    let done = meniscus(&["check", path, "--run"]);
    assert_eq!((done.code, done.stderr.as_str()), (0, ""), "{}", done.stdout);
    let lines: Vec<&str> = done.stdout.lines().collect();
    assert_eq!(lines.len(), 3, "{}", done.stdout);
    assert_eq!(lines[0], format!("{path}: ok, 2 claims hold"));
    assert!(
        lines[1].starts_with("  ✓ Energy is kept: at worst 0.0493") && lines[1].contains(" J at t = "),
        "{}",
        lines[1]
    );
    assert!(lines[2].starts_with("  ✓ Period: 5 cm at t = 1 s; expected 5 cm, off by "), "{}", lines[2]);
    assert_eq!(meniscus(&["check", path, "--run", "--format", "json"]).stdout, "[]\n");
    assert_eq!(meniscus(&["check", path]).stdout, format!("{path}: ok\n"), "nothing is run unasked");
}

#[test]
fn a_claim_that_does_not_hold_is_an_error_with_its_place() {
    // After half a period the body is on the opposite side.
    let (_directory, path) = directory_with(&claiming("x within 0.1 % of 5 [cm] at 0.5 [s]"));
    let (_other, sound) = directory_with(&claiming("x < 6 [cm] always"));
    let (path, sound) = (path.to_str().expect("UTF-8"), sound.to_str().expect("UTF-8"));
    let done = meniscus(&["check", path, sound, "--run"]);
    assert_eq!((done.code, done.stderr.as_str()), (1, ""));
    assert!(done.stdout.contains(&format!("{path}: 1 of 2 claims do not hold\n")), "{}", done.stdout);
    assert!(done.stdout.contains("  ✗ Period: −5 cm at t = 0.5 s; expected 5 cm, off by 200 % (0.1 % allowed) (line "));
    assert!(done.stdout.contains(&format!("{sound}: ok, 2 claims hold\n")), "{}", done.stdout);
    let spanish = meniscus(&["check", path, "--run", "--language", "es"]).stdout;
    assert!(
        spanish.contains("1 de 2 afirmaciones no se cumplen") && spanish.contains("en t = 0,5 s; se espera"),
        "{spanish}"
    );
    let done = meniscus(&["check", path, "--run", "--format", "json"]);
    assert_eq!(done.code, 1);
    let findings: serde_json::Value = serde_json::from_str(&done.stdout).expect("JSON");
    assert_eq!((&findings[0]["severity"], &findings[0]["code"]), (&"error".into(), &"check-failed".into()));
    let line = claiming("").lines().position(|line| line.starts_with("\"Period\"")).expect("it is there") + 1;
    assert_eq!((&findings[0]["line"], &findings[0]["column"]), (&line.into(), &1.into()));
}

#[test]
fn what_a_document_claims_may_come_to_nothing() {
    let (_directory, path) = directory_with(SPRING);
    let path = path.to_str().expect("UTF-8");
    assert_eq!(meniscus(&["check", path, "--run"]).stdout, format!("{path}: ok, no claims\n"));
    let (_directory, path) = directory_with(&claiming("x within 1 % of z always"));
    let done = meniscus(&["check", path.to_str().expect("UTF-8"), "--run"]);
    assert_eq!(done.code, 1);
    assert!(done.stdout.ends_with(": 1 error\n"), "a document with errors is not run: {}", done.stdout);
}
