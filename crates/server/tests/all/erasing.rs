//! Erasing, backups and the end of a class.

use crate::client::{Running, parts};
use serde_json::json;
use server::store::{back_up, files_beside, restore};
use server::{Store, export, now};
use std::path::Path;

/// Answer that is looked for in the bytes of the files.
const SECRET: &str = "an answer that nobody else would type";

fn holds(store: &Path, text: &str) -> bool {
    let mut files = vec![store.to_owned()];
    files.extend(files_beside(store));
    let bytes = files.iter().filter_map(|file| std::fs::read(file).ok());
    bytes.into_iter().any(|bytes| bytes.windows(text.len()).any(|window| window == text.as_bytes()))
}

fn block<T>(work: impl Future<Output = T>) -> T {
    tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap().block_on(work)
}

#[test]
fn no_byte_of_an_erased_seat_stays() {
    let folder = tempfile::tempdir().unwrap();
    let store = folder.path().join("class.sqlite");
    let running = Running::start(&store);
    let joined: Vec<_> = (0..2).map(|_| running.join()).collect();
    let teacher = running.teacher();
    for (student, text) in joined.iter().zip([SECRET, "another"]) {
        let token = student["token"].as_str().unwrap();
        running.post("/api/events", token, &json!({ "events": parts(1, text, "wrong") })).ok();
        let long = format!("{text} {}", "x".repeat(50_000));
        let long = json!({ "events": [{ "seq": 7, "document": "tube.md", "part": "item:long", "value": long }] });
        running.post("/api/events", token, &long).ok();
    }
    assert!(holds(&store, SECRET));
    running.post("/api/teacher/erase", &teacher, &json!({ "seat": 1 })).ok();
    assert!(!holds(&store, SECRET));
    assert!(!holds(&store, joined[0]["pseudonym"].as_str().unwrap()));
    assert!(holds(&store, "another"));
    assert_eq!(running.get("/api/teacher/hand-in/2/tube.md", &teacher).status, 200);
}

#[test]
fn a_backup_does_not_bring_an_erased_seat_back() {
    let folder = tempfile::tempdir().unwrap();
    let [store, backup, new] = ["class.sqlite", "backup.sqlite", "new.sqlite"].map(|name| folder.path().join(name));
    let running = Running::start(&store);
    for text in [SECRET, "another"] {
        let joined = running.join();
        running
            .post("/api/events", joined["token"].as_str().unwrap(), &json!({ "events": parts(1, text, "wrong") }))
            .ok();
    }
    // While the server runs.
    back_up(&store, &backup).unwrap();
    assert!(back_up(&store, &backup).is_err(), "no file is overwritten");
    assert!(holds(&backup, SECRET));
    let class = running.class.id().to_owned();
    block(running.server.classes().erase(&running.class, 1)).unwrap();
    drop(running);
    assert_eq!(restore(&backup, &store, now()).unwrap(), 0);
    assert!(!holds(&store, SECRET));
    // Into a new store both come back, since nothing tells of the erasure; the time of the class still ends it.
    assert_eq!(restore(&backup, &new, now()).unwrap(), 12);
    let files = block(export::files(&Store::open(&new).unwrap(), &class)).unwrap();
    assert_eq!(files.len(), 2);
    let late = folder.path().join("late.sqlite");
    assert_eq!(restore(&backup, &late, now() + 31 * 86_400_000).unwrap(), 0);
    assert!(!holds(&late, SECRET) && !holds(&late, "another"));
}

#[test]
fn a_class_ends_after_its_days() {
    let folder = tempfile::tempdir().unwrap();
    let store = folder.path().join("class.sqlite");
    let running = Running::start(&store);
    let joined = running.join();
    running
        .post("/api/events", joined["token"].as_str().unwrap(), &json!({ "events": parts(1, SECRET, "wrong") }))
        .ok();
    let classes = running.server.classes();
    block(classes.erase_expired(now() + 29 * 86_400_000)).unwrap();
    assert!(holds(&store, SECRET));
    block(classes.erase_expired(now() + 31 * 86_400_000)).unwrap();
    assert!(!holds(&store, SECRET));
    assert_eq!(running.get("/api/mine", joined["token"].as_str().unwrap()).status, 401);
    assert_eq!(running.post("/api/join", "", &json!({ "code": running.class.code() })).status, 404);
}

#[test]
fn other_files_are_no_store() {
    let folder = tempfile::tempdir().unwrap();
    let [text, other] = ["text", "other"].map(|name| folder.path().join(name));
    std::fs::write(&text, "no database, but more than a hundred bytes of text ".repeat(20)).unwrap();
    assert!(Store::open(&text).is_err());
    assert!(std::fs::read_to_string(&text).unwrap().starts_with("no database"));
    assert!(back_up(&other, &folder.path().join("x")).is_err());
    assert!(!other.exists(), "nothing is made by looking");
}
