//! `meniscus check`: findings for people and for programs.

use crate::common::{SPRING, directory_with, meniscus, names, root};

#[test]
fn the_documents_that_ship_have_no_findings() {
    let simulations = root().join("simulations");
    let documents: Vec<String> = names(&simulations).into_iter().filter(|name| name.ends_with(".md")).collect();
    assert!(documents.len() >= 2, "{documents:?}");
    for document in &documents {
        let path = format!("simulations/{document}");
        let done = meniscus(&["check", &path]);
        assert_eq!((done.code, done.stderr.as_str()), (0, ""), "{}", done.stdout);
        assert!(done.stdout.ends_with(": ok\n"), "{}", done.stdout);
        assert_eq!(meniscus(&["check", &path, "--format", "json"]).stdout, "[]\n");
    }
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
