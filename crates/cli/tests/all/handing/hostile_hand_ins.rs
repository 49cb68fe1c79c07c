//! Texts of strangers in hand-ins are shown as text: in the terminal, in JSON and HTML, and in CSV and XLSX without formulas.

use crate::common::meniscus;
use calamine::{Data, Reader, Xlsx, open_workbook};
use document::page::Source;
use saved::Item;
use saved::format::{Answer, Content, Record};
use saved::project::Project;
use serde_json::Value;
use std::path::{Path, PathBuf};

const DOCUMENT: &str = include_str!("../../../../../simulations/theories/linear.md");

fn hostile() -> Vec<String> {
    vec![
        "<script>document.title=1</script>".to_owned(),
        "<svg onload=alert(1)><style>*{display:none}</style>".to_owned(),
        "\"><img src=x onerror=alert(1)>".to_owned(),
        "</textarea><!--".to_owned(),
        "=1+1".to_owned(),
        "@SUM(A1)".to_owned(),
        "+cmd|' /C calc'!A0".to_owned(),
        "\u{202e}nothing".to_owned(),
        "a\nb: 5 values computed again, all equal".to_owned(),
        "\u{1b}[31m\u{7}\u{2028}".to_owned(),
        "x".repeat(1 << 20),
        "[".repeat(100_000),
        "{\"a\":".repeat(100_000),
    ]
}

/// A hand-in whose texts are all this one: name, record, title, answer. One value is changed, so that its place is named.
fn handed(folder: &Path, place: usize, text: &str) -> PathBuf {
    let title = serde_json::to_string(&text.chars().take(1000).collect::<String>()).unwrap();
    let document = DOCUMENT.replacen("title: Linear damping", &format!("title: {title}"), 1);
    let question = "\n```question\nWhat?\n\nanswer: gamma in [1/s] within 5 %\n```\n";
    let rows: String =
        (0..20).map(|index| format!("{index},{}\n", f64::from((index * 7919 + place as u32 * 31) % 11))).collect();
    let record = Record { name: text.to_owned(), text: format!("t [s],y [m]\n{rows}"), ..Record::default() };
    let answer = Answer { typed: text.to_owned(), ..Answer::default() };
    let source = document + question;
    let program = document::open(&source, &[]).sound().unwrap().program;
    let prompt = program.question_text(&program.language, 0).prompt.as_str();
    let stored = [
        ("159d2ddcf951f93c", include_str!("../../../../desk/tests/all/stored/record.json")),
        ("fit", include_str!("../../../../desk/tests/all/stored/fit.json")),
    ];
    let mut items = vec![
        ("r".to_owned(), Item(Content::Record(record)).write(5)),
        (units::name_of(&[prompt]), Item(Content::Answer(answer)).write(6)),
    ];
    items.extend(stored.map(|(name, text)| (name.to_owned(), text.trim().to_owned())));
    let documents = vec![Source { name: text.chars().take(50).collect(), text: source }];
    let project = folder.join(format!("{place}.meniscus"));
    std::fs::write(&project, Project { documents, items, ..Project::default() }.write()).unwrap();
    let path = folder.join("in").join(format!("{place}.hand-in"));
    let words = ["hand-in", project.to_str().unwrap(), "--name", "NAME", "--output", path.to_str().unwrap()];
    let done = meniscus(&words);
    assert_eq!(done.code, 0, "{text:.60}: {}", done.stderr);
    let made = std::fs::read_to_string(&path).unwrap();
    let name: String = text.chars().take(1 << 20).collect();
    let made = made.replacen("\"name\":\"NAME\"", &format!("\"name\":{}", serde_json::to_string(&name).unwrap()), 1);
    let made = made.replacen("\"quantity\":\"rows\",\"number\":20", "\"quantity\":\"rows\",\"number\":21", 1);
    std::fs::write(&path, made).unwrap();
    path
}

/// True if a text has a character that a terminal obeys.
fn is_obeyed(text: &str) -> bool {
    text.chars().any(|c| c.is_control() && c != '\n' && c != '\t' || ('\u{202a}'..='\u{202e}').contains(&c))
}

#[test]
fn hostile_texts_are_shown_as_text_everywhere() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("in")).unwrap();
    for (place, text) in hostile().iter().enumerate() {
        let path = handed(folder.path(), place, text);
        let done = meniscus(&["verify", path.to_str().unwrap()]);
        assert_eq!(done.code, 1, "{text:.60}: {}", done.stderr);
        assert!(!is_obeyed(&done.stdout) && done.stdout.len() < 20_000, "{text:.60}: {:.400}", done.stdout);
        // No text makes a line of its own: the file, the difference of the rows, and the meaning.
        assert_eq!(done.stdout.lines().count(), 3, "{text:.60}: {:.1000}", done.stdout);
        assert!(done.stdout.contains("rows: stated 21, computed 20"), "{text:.60}: {:.1000}", done.stdout);
        let json = meniscus(&["verify", path.to_str().unwrap(), "--format", "json"]);
        let found: Value = serde_json::from_str(&json.stdout).unwrap();
        assert_eq!(found["hand_ins"][0]["differences"].as_array().unwrap().len(), 1, "{text:.60}");
    }
    let class = folder.path().join("in");
    let output = |name: &str| folder.path().join(name);
    for name in ["class.html", "class.csv", "class.xlsx"] {
        let path = output(name);
        let done = meniscus(&["class", "report", class.to_str().unwrap(), "--output", path.to_str().unwrap()]);
        assert_eq!(done.code, 0, "{name}: {}", done.stderr);
    }
    let page = std::fs::read_to_string(output("class.html")).unwrap();
    for raw in ["<script>document", "<svg onload", "<img src=x", "</textarea>"] {
        assert!(!page.contains(raw), "{raw}");
    }
    for line in std::fs::read_to_string(output("class.csv")).unwrap().lines() {
        let cells = line.split(',').map(|cell| cell.trim_matches('"'));
        cells.for_each(|cell| assert!(!cell.starts_with(['=', '@', '+']), "{line:.200}"));
    }
    let mut workbook: Xlsx<_> = open_workbook(output("class.xlsx")).unwrap();
    for sheet in workbook.sheet_names() {
        assert_eq!(workbook.worksheet_formula(&sheet).unwrap().used_cells().count(), 0, "{sheet}");
        let range = workbook.worksheet_range(&sheet).unwrap();
        assert!(range.used_cells().all(|(_, _, cell)| !matches!(cell, Data::Error(_))), "{sheet}");
    }
}
