//! Erasing, backups and the end of a class.

use crate::client::{Running, block, parts};
use crate::storage::{Storage, cases, holds};
use crate::streams::Stream;
use serde_json::json;
use server::store::{Location, NewEvent, back_up, restore};
use server::{Fault, Store, export, now};

cases!(
    no_text_of_an_erased_seat_stays,
    a_backup_does_not_bring_an_erased_seat_back,
    a_backup_brings_no_device_of_a_teacher_back,
    nothing_is_stored_of_a_class_that_was_erased_beside_a_server,
    a_class_ends_after_its_days,
);

/// Answer that is looked for in the bytes of the files.
const SECRET: &str = "an answer that nobody else would type";

fn no_text_of_an_erased_seat_stays(storage: &Storage) {
    let running = Running::start(&storage.location);
    let joined: Vec<_> = (0..2).map(|_| running.join()).collect();
    let teacher = running.teacher();
    for (student, text) in joined.iter().zip([SECRET, "another"]) {
        let token = student["token"].as_str().unwrap();
        running.post("/api/events", token, &json!({ "events": parts(1, text, "wrong") })).ok();
        let long = format!("{text} {}", "x".repeat(50_000));
        let long = json!({ "events": [{ "seq": 7, "document": "tube.md", "part": "item:long", "value": long }] });
        running.post("/api/events", token, &long).ok();
    }
    assert!(storage.holds(SECRET));
    running.post("/api/teacher/erase", &teacher, &json!({ "seat": 1 })).ok();
    assert!(!storage.holds(SECRET));
    assert!(!storage.holds(joined[0]["pseudonym"].as_str().unwrap()));
    assert!(storage.holds("another"));
    assert_eq!(running.hand_in(2, &teacher).status, 200);
}

fn a_backup_does_not_bring_an_erased_seat_back(storage: &Storage) {
    let [backup, late] = ["backup.sqlite", "late.sqlite"].map(|name| storage.beside(name));
    let running = Running::start(&storage.location);
    for text in [SECRET, "another"] {
        let joined = running.join();
        running
            .post("/api/events", joined["token"].as_str().unwrap(), &json!({ "events": parts(1, text, "wrong") }))
            .ok();
    }
    let sheet =
        block(running.server.classes().store().add_sheet(running.class.id().to_owned(), [7; 16], "{}".to_owned()));
    sheet.unwrap();
    // While the server runs.
    block(back_up(&storage.location, &backup, None)).unwrap();
    assert!(block(back_up(&storage.location, &backup, None)).is_err(), "no file is overwritten");
    assert!(holds(&backup, SECRET));
    let class = running.class.id().to_owned();
    block(running.server.classes().erase(&running.class, 1)).unwrap();
    assert_eq!(block(restore(&backup, &storage.location, now())).unwrap(), 0);
    assert!(!storage.holds(SECRET) && storage.holds("another"));
    // Into a new store of either kind both come back, since nothing tells of the erasure; the time of the class still ends it.
    for new in [storage.other(), Storage::file()] {
        assert_eq!(block(restore(&backup, &new.location, now())).unwrap(), 12);
        assert_eq!(block(restore(&backup, &new.location, now())).unwrap(), 0, "what is there stays");
        let files = block(async { export::files(&Store::existing(&new.location).await.unwrap(), &class).await });
        assert_eq!(files.unwrap().len(), 3);
    }
    let late = Location::File(late);
    assert_eq!(block(restore(&backup, &late, now() + 31 * 86_400_000)).unwrap(), 0);
    let Location::File(late) = &late else { return };
    assert!(!holds(late, SECRET) && !holds(late, "another"));
}

fn a_backup_brings_no_device_of_a_teacher_back(storage: &Storage) {
    let backup = storage.beside("backup.sqlite");
    let running = Running::start(&storage.location);
    let (own, revoked, joined) = (running.teacher(), running.teacher(), running.join());
    block(back_up(&storage.location, &backup, None)).unwrap();
    running.post("/api/teacher/revoke", &own, &json!({})).ok();
    drop(running);
    let other = storage.other();
    // The store in which the token was revoked, and a new one that cannot tell.
    for (location, kept) in [(&storage.location, 200), (&other.location, 401)] {
        block(restore(&backup, location, now())).unwrap();
        let running = Running::start(location);
        let status = |token: &str| running.get("/api/teacher/class", token).status;
        assert_eq!([status(&own), status(&revoked), status(&running.teacher())], [kept, 401, 200]);
        // Students keep their seats.
        running.get("/api/state", joined["token"].as_str().unwrap()).ok();
    }
}

fn nothing_is_stored_of_a_class_that_was_erased_beside_a_server(storage: &Storage) {
    let running = Running::start(&storage.location);
    let (joined, teacher, link) = (running.join(), running.teacher(), running.link());
    let [token, survey] = ["token", "survey"].map(|name| joined[name].as_str().unwrap());
    let events = json!({ "events": parts(1, SECRET, "wrong") });
    running.post("/api/events", token, &events).ok();
    let (mut stream, _) = Stream::open(&running, "/api/stream", token);
    assert!(stream.next().is_some());
    let class = running.class.id();
    // As `meniscus class erase --all` does.
    block(async { Store::existing(&storage.location).await.unwrap().erase_class(class.to_owned()).await }).unwrap();
    // Requests that were let in before.
    let store = running.server.classes().store();
    let event = || NewEvent { seq: 7, kind: "part", body: SECRET.to_owned() };
    let late = block(store.append(class.to_owned(), 1, now(), vec![event()]));
    assert!(matches!(late, Err(Fault::Missing)), "{late:?}");
    let _ = block(store.add_sheet(class.to_owned(), [7; 16], SECRET.to_owned()));
    assert!(block(store.append_of_teacher(class.to_owned(), now(), "settings", SECRET.to_owned())).is_err());
    assert!(block(store.add_token(class.to_owned(), 1, [7; 32])).is_err());
    // Later ones, each with a reason for which the page has a sentence.
    let gone = (401, "token".to_owned());
    assert_eq!(running.post("/api/events", token, &events).why(), gone);
    assert_eq!(running.get("/api/state", token).why(), gone);
    assert_eq!(running.get("/api/teacher/class", &teacher).why(), gone);
    assert_eq!(running.survey(survey, "1-1", &json!({ "meniscus survey": 1, "items": [] })).why(), gone);
    for code in [running.class.code(), joined["key"].as_str().unwrap().to_owned()] {
        assert_eq!(running.post("/api/join", "", &json!({ "code": code })).why(), (404, "code".to_owned()));
    }
    assert_eq!(running.post("/api/teacher/exchange", "", &json!({ "link": link })).why(), (403, "link".to_owned()));
    assert!(stream.next().is_none());
    assert!(!storage.holds(SECRET));
    assert!(block(store.seats(class.to_owned())).unwrap().is_empty());
    assert!(block(store.tokens(class.to_owned())).unwrap().is_empty());
}

fn a_class_ends_after_its_days(storage: &Storage) {
    let running = Running::start(&storage.location);
    let joined = running.join();
    running
        .post("/api/events", joined["token"].as_str().unwrap(), &json!({ "events": parts(1, SECRET, "wrong") }))
        .ok();
    let classes = running.server.classes();
    block(classes.erase_expired(now() + 29 * 86_400_000)).unwrap();
    assert!(storage.holds(SECRET));
    block(classes.erase_expired(now() + 31 * 86_400_000)).unwrap();
    assert!(!storage.holds(SECRET));
    assert_eq!(running.get("/api/mine", joined["token"].as_str().unwrap()).status, 401);
    assert_eq!(running.post("/api/join", "", &json!({ "code": running.class.code() })).status, 404);
}

#[test]
fn other_files_are_no_store() {
    let folder = tempfile::tempdir().unwrap();
    let text = folder.path().join("text");
    std::fs::write(&text, "no database, but more than a hundred bytes of text ".repeat(20)).unwrap();
    assert!(block(Store::open(&Location::File(text.clone()))).is_err());
    assert!(std::fs::read_to_string(&text).unwrap().starts_with("no database"));
    let other = Location::File(folder.path().join("other"));
    assert!(block(back_up(&other, &folder.path().join("x"), None)).is_err());
    assert!(block(Store::existing(&other)).is_err());
    assert!(!folder.path().join("other").exists(), "nothing is made by looking");
}
