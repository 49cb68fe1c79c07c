//! `meniscus class export`, `backup`, `erase` and `restore`.

use crate::common::meniscus;
#[cfg(unix)]
use crate::common::mode;
use serde_json::json;
use server::class::Classes;
use server::fold::PART;
use server::store::NewEvent;
use server::{Store, now};
use std::path::Path;
use units::Language;

/// A store with the hand-ins of these students and a sheet.
fn store(path: &Path, typed: &[&str]) {
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
    runtime.block_on(async {
        let store = Store::open(&path.into()).await.unwrap();
        let classes = Classes::open(store.clone(), Language::English, now()).await.unwrap();
        let class = classes.begin("Tubes", 30, now()).await.unwrap();
        for typed in typed {
            let seat = classes.join(&class.code(), now()).await.unwrap().seat;
            let parts = [
                ("documents", json!([{ "name": "tube.md", "text": format!("# {typed}") }])),
                ("state", json!("")),
                ("order", json!([])),
                ("head", json!({ "program": "0.1.0", "sender": {} })),
            ];
            let event = |((part, value), seq): ((&str, _), u64)| {
                let body = json!({ "document": "tube.md", "part": part, "value": value }).to_string();
                NewEvent { seq, kind: PART, body }
            };
            let events = parts.into_iter().zip(1..).map(event).collect();
            store.append(class.id().to_owned(), seat, now(), events).await.unwrap();
        }
        store.add_sheet(class.id().to_owned(), [7; 16], "{}".to_owned()).await.unwrap();
    });
}

#[test]
fn a_store_is_exported_backed_up_erased_and_restored() {
    let folder = tempfile::tempdir().unwrap();
    let [file, backup, out] = ["class.sqlite", "backup.sqlite", "out"].map(|name| folder.path().join(name));
    let [file, backup, out] = [&file, &backup, &out].map(|path| path.to_str().unwrap());
    store(Path::new(file), &["first", "second"]);
    let run = |words: &[&str]| {
        let done = meniscus(&[&["class"], words].concat());
        assert_eq!(done.code, 0, "{words:?}: {}", done.stderr);
        done.stderr
    };
    let texts = || {
        let entries = std::fs::read_dir(out).unwrap().map(|entry| entry.unwrap().path());
        let mut texts: Vec<String> = entries.map(|path| std::fs::read_to_string(path).unwrap()).collect();
        // Parts of one moment would be in the order of their senders' names, which are drawn.
        texts.sort_by_key(|text| ["# first", "# second"].iter().position(|part| text.contains(part)).unwrap_or(2));
        std::fs::remove_dir_all(out).unwrap();
        texts
    };
    assert_eq!(run(&["export", "--store", file, "--output", out]), "files written: 3\n");
    #[cfg(unix)]
    assert_eq!(mode(out.as_ref()), 0o700);
    let before = texts();
    assert!(before[0].contains("# first") && before[1].contains("# second") && before[2] == "{}", "{before:?}");
    run(&["backup", "--store", file, "--output", backup]);
    #[cfg(unix)]
    assert_eq!(mode(backup.as_ref()), 0o600);
    run(&["erase", "--store", file, "--seat", "1"]);
    let restored = run(&["restore", backup, "--store", file]);
    assert!(restored.starts_with("parts restored: 0\n") && restored.contains("prints a new link"), "{restored}");
    run(&["export", "--store", file, "--output", out]);
    assert_eq!(texts(), before[1..]);
    run(&["erase", "--store", file, "--all"]);
    assert_eq!(meniscus(&["class", "export", "--store", file, "--output", out]).code, 2);
}

/// A store with two classes: the second one is the latest.
#[test]
fn every_class_of_a_store_can_be_reached_and_none_is_continued_unasked() {
    let folder = tempfile::tempdir().unwrap();
    let [file, out] = ["class.sqlite", "out"].map(|name| folder.path().join(name));
    store(&file, &["first"]);
    store(&file, &["second", "third"]);
    let [file, out] = [&file, &out].map(|path| path.to_str().unwrap());
    let listed = meniscus(&["class", "list", "--store", file]).stdout;
    let lines: Vec<&str> = listed.lines().collect();
    assert!(
        lines.len() == 2 && lines[0].contains(": Tubes, begun on 20") && lines[1].contains("seats: 1, erased on"),
        "{listed}"
    );
    let code = lines[1].split(':').next().unwrap();
    let export = |class: &str| meniscus(&["class", "export", "--store", file, "--class", class, "--output", out]);
    assert_eq!(export(code).stderr, "files written: 2\n");
    assert!(export("Tubes").stderr.contains("several classes Tubes") && export("x").stderr.contains("no class x"));
    // A backup of one class has nothing of the others, and is restored by itself.
    let [backup, new] = ["backup.sqlite", "new.sqlite"].map(|name| folder.path().join(name));
    let [backup, new] = [&backup, &new].map(|path| path.to_str().unwrap());
    let done = meniscus(&["class", "backup", "--store", file, "--class", code, "--output", backup]);
    assert_eq!((done.code, done.stderr.as_str()), (0, ""));
    let bytes = std::fs::read(backup).unwrap();
    let holds = |text: &str| bytes.windows(text.len()).any(|window| window == text.as_bytes());
    assert!(holds("# first") && !holds("# second") && !holds("# third"));
    assert_eq!(meniscus(&["class", "restore", backup, "--store", new]).code, 0);
    let listed = meniscus(&["class", "list", "--store", new]).stdout;
    assert!(listed.lines().count() == 1 && listed.starts_with(code), "{listed}");
    assert_eq!(meniscus(&["class", "erase", "--store", file, "--class", code, "--seat", "1"]).code, 0);
    let listed = meniscus(&["class", "list", "--store", file]).stdout;
    assert!(listed.lines().next().unwrap().contains("seats: 2"), "{listed}");
    let second = listed.lines().nth(1).unwrap();
    assert!(second.contains("seats: 0,") && second.ends_with("; seats that were erased: 1"), "{listed}");
    let document = concat!(env!("CARGO_MANIFEST_DIR"), "/../../simulations/utube.md");
    let served = meniscus(&["class", "serve", document, "--store", file]);
    assert_eq!(served.code, 2);
    assert!(served.stderr.contains("has a class: ") && served.stderr.contains("--continue"), "{}", served.stderr);
    // One class is erased, and the other stays.
    assert_eq!(meniscus(&["class", "erase", "--store", file, "--class", code, "--all"]).code, 0);
    let listed = meniscus(&["class", "list", "--store", file]).stdout;
    let lines: Vec<&str> = listed.lines().collect();
    assert!(lines.len() == 2 && !listed.contains(code) && lines[1].ends_with(": 1"), "{listed}");
}

#[test]
fn a_refused_start_leaves_neither_a_store_nor_a_class() {
    let folder = tempfile::tempdir().unwrap();
    let [new, known] = ["new.sqlite", "known.sqlite"].map(|name| folder.path().join(name));
    store(&known, &["first"]);
    let [new, known] = [&new, &known].map(|path| path.to_str().unwrap());
    let taken = std::net::TcpListener::bind("0.0.0.0:0").unwrap();
    let port = taken.local_addr().unwrap().port().to_string();
    let document = concat!(env!("CARGO_MANIFEST_DIR"), "/../../simulations/utube.md");
    let [text, no_log] = ["Cargo.toml", "none/class.log"];
    for words in [
        vec![document, "--port", &port],
        vec![text],
        vec![document, "--public", "https://class.example", "--tls", "none.pem,none.pem"],
        vec![document, "--public", "class"],
        vec![document, "--log", no_log],
    ] {
        let serve = |more: &[&str]| meniscus(&[&["class", "serve"], words.as_slice(), more].concat());
        let (first, second) = (serve(&["--store", new]), serve(&["--store", known, "--new"]));
        assert!(first.code > 0 && second.code > 0, "{words:?}: {}", first.stderr);
        assert!(!Path::new(new).exists(), "{words:?}");
        assert_eq!(meniscus(&["class", "list", "--store", known]).stdout.lines().count(), 1, "{words:?}");
    }
}

#[test]
fn a_file_that_is_no_store_is_named_with_the_remedy() {
    let folder = tempfile::tempdir().unwrap();
    let missing = folder.path().join("none.sqlite");
    let missing = missing.to_str().unwrap();
    for words in [vec!["erase", "--all"], vec!["export", "-o", "x"], vec!["backup", "-o", "x"]] {
        let done = meniscus(&[vec!["class"], words, vec!["--store", missing]].concat());
        assert!(done.code == 2 && done.stderr.contains("none.sqlite"), "{}", done.stderr);
    }
    assert!(!Path::new(missing).exists());
    let text = "Cargo.toml";
    let done = meniscus(&["class", "restore", text, "--store", missing]);
    assert!(done.code == 2 && done.stderr.contains("is no store of classes"), "{}", done.stderr);
    let seat = meniscus(&["class", "erase", "--store", missing]);
    assert!(seat.code == 2 && seat.stderr.contains("--seat"), "{}", seat.stderr);
}
