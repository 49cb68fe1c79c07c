//! `meniscus class survey`: counts, forms, hidden comments, and files from strangers.

use crate::common::meniscus;
use serde_json::Value;
use std::path::Path;

/// A file with answers.
fn sheet(role: usize, step: usize, comment: &str) -> String {
    let comment = serde_json::to_string(comment).unwrap();
    format!(
        r#"{{"meniscus survey":1,"document":"U-tube","items":[
        {{"name":"r","kind":"role","asked":"You are a","words":["student","=HYPERLINK(1)"],"of":2,"chosen":{role}}},
        {{"name":"c","kind":"scale","asked":"It was clear","words":["no","yes"],"of":5,"chosen":{step}}},
        {{"name":"t","kind":"text","asked":"Why?","typed":{comment}}}]}}"#
    )
}

/// Writes these files into a folder.
fn folder(directory: &Path, texts: &[String]) -> String {
    for (index, text) in texts.iter().enumerate() {
        std::fs::write(directory.join(format!("{index}.survey")), text).unwrap();
    }
    directory.to_str().unwrap().to_owned()
}

const COMMENTS: [&str; 6] = [
    "Las gráficas son claras",
    "La gráfica no funciona",
    "<script>alert(1)</script><svg onload=alert(1)>",
    "=1+1",
    "\u{202e}reversed\u{1b}[31m",
    "No funciona",
];

fn class(directory: &Path) -> String {
    let texts: Vec<String> =
        COMMENTS.iter().enumerate().map(|(index, one)| sheet(1 + index / 5, 1 + index.min(4), one)).collect();
    folder(directory, &texts)
}

#[test]
fn answers_are_counted_and_comments_hidden_until_they_are_released() {
    let directory = tempfile::tempdir().unwrap();
    let folder = class(directory.path());
    let done = meniscus(&["class", "survey", &folder]);
    assert_eq!((done.code, done.stderr.as_str()), (0, ""));
    for line in [
        "U-tube, n = 6",
        "  You are a, n = 6",
        "83 % (44 to 97 %, n = 6)",
        "  1: no; 5: yes",
        "    gráfica 2, no funciona 2",
    ] {
        assert!(done.stdout.lines().any(|own| own.contains(line)), "{line}\n{}", done.stdout);
    }
    assert!(done.stdout.contains("--comments releases them") && !done.stdout.contains("1+1"), "{}", done.stdout);
    let released = meniscus(&["--language", "es", "class", "survey", &folder, "--comments"]);
    assert!(
        released.stdout.contains("    - =1+1\n") && released.stdout.contains("(de 44 a 97 %, n = 6)"),
        "{}",
        released.stdout
    );
    assert!(!released.stdout.contains(['\u{1b}', '\u{202e}']));
    for format in ["html", "csv", "json"] {
        let hidden = meniscus(&["class", "survey", &folder, "--format", format]);
        assert!(
            hidden.code == 0 && !hidden.stdout.contains("1+1") && !hidden.stdout.contains("alert"),
            "{}",
            hidden.stdout
        );
    }
}

#[test]
fn texts_of_strangers_are_inert_in_every_form() {
    let directory = tempfile::tempdir().unwrap();
    let folder = class(directory.path());
    let page = directory.path().join("survey.html");
    let done = meniscus(&["class", "survey", &folder, "--comments", "--output", page.to_str().unwrap()]);
    assert_eq!(done.code, 0, "{}", done.stderr);
    #[cfg(unix)]
    assert_eq!(crate::common::mode(&page), 0o600);
    let html = std::fs::read_to_string(&page).unwrap();
    assert!(html.contains("&lt;script&gt;alert(1)&lt;/script&gt;&lt;svg onload=alert(1)&gt;"));
    assert!(!html.contains("<script") && !html.contains("<svg onload") && html.contains("default-src 'none'"));
    assert!(html.contains("<svg") && html.contains(">gráfica</text>") && html.contains("<bdi>no funciona</bdi>"));
    let csv = meniscus(&["class", "survey", &folder, "--comments", "--format", "csv"]).stdout;
    assert!(csv.contains(",comment,\"'=1+1\",") && csv.contains(",role,\"'=HYPERLINK(1)\",1,6,"), "{csv}");
    let json: Value =
        serde_json::from_str(&meniscus(&["class", "survey", &folder, "--comments", "--format", "json"]).stdout)
            .unwrap();
    let items = &json[0]["items"];
    assert_eq!((&json[0]["n"], &items[1]["answers"][4]["persons"]), (&Value::from(6), &Value::from(2)));
    assert_eq!(items[2]["comments"].as_array().unwrap().len(), 6);
    // The answers themselves are not overwritten.
    let over = directory.path().join("0.survey");
    let refused = meniscus(&["class", "survey", &folder, "--output", over.to_str().unwrap()]);
    assert_eq!(refused.code, 2, "{}", refused.stdout);
}

#[test]
fn few_answers_and_damaged_files_are_said() {
    let directory = tempfile::tempdir().unwrap();
    let good = sheet(1, 2, "a secret");
    let damaged = [
        good[..good.len() / 2].to_owned(),
        "{}".to_owned(),
        good.replace("survey\":1", "survey\":2"),
        good.replace("a secret", &"x".repeat(1_000_000)),
        format!("{{\"meniscus survey\":1,\"x\":{}", "[".repeat(1 << 19)),
    ];
    let texts: Vec<String> = damaged.into_iter().chain(vec![good; 4]).collect();
    let folder = folder(directory.path(), &texts);
    let done = meniscus(&["class", "survey", &folder]);
    assert_eq!(done.code, 0, "{}", done.stderr);
    for (index, why) in
        ["is damaged", "has no answers to a survey", "later version", "is too large", "is damaged"].iter().enumerate()
    {
        assert!(
            done.stderr.lines().any(|line| line.contains(&format!("{index}.survey {why}"))
                || line.contains(&format!("{index}.survey was made by a {why}"))),
            "{index} {why}\n{}",
            done.stderr
        );
    }
    assert!(
        done.stdout.contains("U-tube, n = 4") && done.stdout.contains("3 items have fewer than 5 answers"),
        "{}",
        done.stdout
    );
    assert!(!done.stdout.contains("secret") && !done.stdout.contains("student"), "{}", done.stdout);
    let empty = tempfile::tempdir().unwrap();
    let none = meniscus(&["class", "survey", empty.path().to_str().unwrap()]);
    assert!(none.code == 2 && none.stderr.contains("their names end in .survey"), "{}", none.stderr);
}
