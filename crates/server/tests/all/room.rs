//! Room of a class.

use crate::client::{Running, block, place};
use crate::storage::{Storage, cases};
use serde_json::{Value, json};
use server::class::MOST_OF_CLASS;

cases!(a_full_class_refuses_what_is_new_and_loses_nothing, a_class_goes_on_with_more_room_after_a_start);

/// Room of the class, in bytes.
const ROOM: u64 = 1 << 20;

fn start(storage: &Storage, room: u64) -> Running {
    Running::start_with(&storage.location, place(), "127.0.0.1:0", room)
}

fn token(joined: &Value) -> &str {
    joined["token"].as_str().unwrap()
}

fn send(running: &Running, joined: &Value, seq: u64) -> (u16, String) {
    let part = json!({ "seq": seq, "document": "tube.md", "part": format!("item:{seq}"), "value": "x".repeat(50_000) });
    running.post("/api/events", token(joined), &json!({ "events": [part] })).why()
}

fn sheet(running: &Running, joined: &Value, id: &str) -> (u16, String) {
    let sheet = json!({ "meniscus survey": 1, "items": [], "long": "x".repeat(50_000) });
    running.survey(joined["survey"].as_str().unwrap(), id, &sheet).why()
}

fn full() -> (u16, String) {
    (507, "class_full".to_owned())
}

fn room(running: &Running, teacher: &str) -> Value {
    running.get("/api/teacher/events?since=0", teacher).ok()["room"].clone()
}

/// Students who send at the same time until the class has no more room.
fn filled(running: &Running, students: &[Value]) -> Vec<Vec<u64>> {
    std::thread::scope(|scope| {
        let fill = |joined| move || (1..).take_while(|&seq| send(running, joined, seq).0 == 200).collect::<Vec<_>>();
        let threads: Vec<_> = students.iter().map(|joined| scope.spawn(fill(joined))).collect();
        threads.into_iter().map(|thread| thread.join().unwrap()).collect()
    })
}

fn stored(running: &Running, joined: &Value) -> Vec<u64> {
    let mine = running.get("/api/mine", token(joined)).ok();
    mine["events"].as_array().unwrap().iter().map(|event| event["seq"].as_u64().unwrap()).collect()
}

fn a_full_class_refuses_what_is_new_and_loses_nothing(storage: &Storage) {
    let running = start(storage, ROOM);
    let (students, teacher) = ([(); 4].map(|()| running.join()), running.teacher());
    assert_eq!(sheet(&running, &students[0], "1").0, 200);
    assert_eq!(room(&running, &teacher)["full"], false);
    let acknowledged = filled(&running, &students);
    for (joined, acknowledged) in students.iter().zip(&acknowledged) {
        assert_eq!(send(&running, joined, 1000), full());
        assert_eq!(&stored(&running, joined), acknowledged);
    }
    let said = room(&running, &teacher);
    let used = said["used"].as_u64().unwrap();
    assert_eq!((&said["full"], &said["most"]), (&json!(true), &json!(ROOM)));
    assert!(used <= ROOM && used > ROOM - 60_000, "{used}");
    assert_eq!(sheet(&running, &students[0], "2"), full());
    // The teacher can still do everything.
    running.post("/api/teacher/settings", &teacher, &json!({ "paused": true })).ok();
    // Another class of the store has room of its own.
    let other = block(running.server.classes().begin("Other", 30, server::now() + 1)).unwrap();
    let elsewhere = running.post("/api/join", "", &json!({ "code": other.code() })).ok();
    assert_eq!(send(&running, &elsewhere, 1).0, 200);
    // An erased seat gives its room back.
    running.post("/api/teacher/erase", &teacher, &json!({ "seat": students[0]["seat"] })).ok();
    assert_eq!(room(&running, &teacher)["full"], false);
    assert_eq!(send(&running, &students[1], 1000).0, 200);
}

fn a_class_goes_on_with_more_room_after_a_start(storage: &Storage) {
    let running = start(storage, ROOM);
    let joined = running.join();
    // What is sent again, because its reply was lost, counts once.
    for _ in 0..3 {
        assert_eq!((send(&running, &joined, 1).0, sheet(&running, &joined, "1").0), (200, 200));
    }
    let acknowledged = filled(&running, std::slice::from_ref(&joined)).remove(0);
    let used = running.server.classes().room(&running.class).used;
    drop(running);
    let running = start(storage, MOST_OF_CLASS);
    let room = running.server.classes().room(&running.class);
    assert_eq!((room.used, room.full), (used, false));
    assert_eq!(stored(&running, &joined), acknowledged);
    assert_eq!(send(&running, &joined, 1000).0, 200);
}
