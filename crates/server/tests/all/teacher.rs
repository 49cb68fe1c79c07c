//! Actions of the teacher.

use crate::client::{Running, parts};
use crate::storage::{Storage, cases};
use serde_json::{Value, json};

cases!(
    a_closed_class_accepts_nothing_until_it_is_opened,
    nobody_takes_a_seat_while_the_class_is_closed_or_gives_none,
    a_new_code_closes_the_former_one_and_keeps_the_seats,
    seats_without_work_are_erased_and_no_others,
    late_joiners_wait_for_the_teacher,
    others_answers_are_seen_after_ones_own_and_only_if_shown,
    settings_outlive_the_server,
);

fn token(joined: &Value) -> &str {
    joined["token"].as_str().unwrap()
}

fn a_closed_class_accepts_nothing_until_it_is_opened(storage: &Storage) {
    let running = Running::start(&storage.location);
    let (joined, teacher) = (running.join(), running.teacher());
    let send = |seq| running.post("/api/events", token(&joined), &json!({ "events": parts(seq, "1", "wrong") })).why();
    let set = |settings: Value| drop(running.post("/api/teacher/settings", &teacher, &settings).ok());
    set(json!({ "open": false }));
    assert_eq!(send(1), (403, "closed".to_owned()));
    assert_eq!(running.get("/api/state", token(&joined)).ok()["accepts"], false);
    set(json!({ "open": true }));
    assert_eq!(send(1).0, 200);
    // The server's clock decides, whatever the student's clock says.
    set(json!({ "open": true, "closes": server::now() }));
    assert_eq!(send(10), (403, "closed".to_owned()));
    set(json!({ "open": true, "closes": server::now() + 60_000 }));
    assert_eq!(send(10).0, 200);
}

fn nobody_takes_a_seat_while_the_class_is_closed_or_gives_none(storage: &Storage) {
    let running = Running::start(&storage.location);
    let (joined, teacher) = (running.join(), running.teacher());
    let set = |settings: Value| drop(running.post("/api/teacher/settings", &teacher, &settings).ok());
    let join = |code: &str| running.post("/api/join", "", &json!({ "code": code })).why();
    for (settings, why) in [
        (json!({ "open": false }), "closed"),
        (json!({ "closes": server::now() }), "closed"),
        (json!({ "joining": false }), "full"),
    ] {
        set(settings);
        assert_eq!(join(&running.class.code()), (403, why.to_owned()));
        // A seat takes another device, on which its student sees and erases what is stored.
        assert_eq!(join(joined["key"].as_str().unwrap()).0, 200);
    }
    set(json!({}));
    assert_eq!(join(&running.class.code()).0, 200);
    assert_eq!(running.class.seats().len(), 2);
}

fn a_new_code_closes_the_former_one_and_keeps_the_seats(storage: &Storage) {
    let running = Running::start(&storage.location);
    let (joined, teacher, former) = (running.join(), running.teacher(), running.class.code());
    running.post("/api/teacher/renew-code", &teacher, &json!({})).ok();
    assert_eq!(running.post("/api/join", "", &json!({ "code": former })).why(), (404, "code".to_owned()));
    assert_eq!(running.get("/api/teacher/class", &teacher).ok()["code"], json!(running.class.code()));
    running.get("/api/state", token(&joined)).ok();
    running.join();
    let code = running.class.code();
    drop(running);
    assert_eq!(Running::start(&storage.location).class.code(), code);
}

fn seats_without_work_are_erased_and_no_others(storage: &Storage) {
    let running = Running::start(&storage.location);
    let ([worked, idle], teacher) = ([(); 2].map(|()| running.join()), running.teacher());
    running.post("/api/events", token(&worked), &json!({ "events": parts(1, "1", "wrong") })).ok();
    running.post("/api/teacher/erase-unused", &teacher, &json!({})).ok();
    assert_eq!(running.get("/api/state", token(&idle)).status, 401);
    assert_eq!(running.get("/api/mine", token(&worked)).ok()["events"].as_array().unwrap().len(), 6);
    assert_eq!(running.class.seats().len(), 1);
    // Without such seats nothing happens, and new ones have new numbers.
    running.post("/api/teacher/erase-unused", &teacher, &json!({})).ok();
    assert_eq!(running.join()["seat"], 3);
}

fn late_joiners_wait_for_the_teacher(storage: &Storage) {
    let running = Running::start(&storage.location);
    let (early, teacher) = (running.join(), running.teacher());
    running.post("/api/teacher/settings", &teacher, &json!({ "open": true, "approve": true })).ok();
    let late = running.join();
    assert_eq!((&early["approved"], &late["approved"]), (&json!(true), &json!(false)));
    let send = || running.post("/api/events", token(&late), &json!({ "events": parts(1, "1", "wrong") })).why();
    assert_eq!(send(), (403, "approval".to_owned()));
    running.post("/api/teacher/approve", &teacher, &json!({ "seat": 2 })).ok();
    assert_eq!(send().0, 200);
    assert_eq!(running.post("/api/teacher/approve", &teacher, &json!({ "seat": 9 })).status, 404);
}

fn others_answers_are_seen_after_ones_own_and_only_if_shown(storage: &Storage) {
    let running = Running::start(&storage.location);
    let teacher = running.teacher();
    let students: Vec<Value> = (0..3).map(|_| running.join()).collect();
    // The grades that browsers send are not believed.
    for (student, (typed, grade)) in students.iter().zip([("4.5", "wrong"), ("9", "correct")]) {
        running.post("/api/events", token(student), &json!({ "events": parts(1, typed, grade) })).ok();
    }
    let seen = |student: usize| running.get("/api/others", token(&students[student])).ok()["questions"].clone();
    assert_eq!(seen(0), json!([]));
    running.post("/api/teacher/settings", &teacher, &json!({ "open": true, "results": true, "others": true })).ok();
    assert_eq!(seen(0), json!([{ "question": "q1", "results": { "answered": 2, "right": 1 }, "others": ["9"] }]));
    assert_eq!(seen(2), json!([]));
}

fn settings_outlive_the_server(storage: &Storage) {
    let (teacher, joined) = {
        let running = Running::start(&storage.location);
        assert_eq!(running.get("/health", "").ok()["store"], "ok");
        let (teacher, joined) = (running.teacher(), running.join());
        running
            .post("/api/teacher/settings", &teacher, &json!({ "open": true, "paused": true, "pace": "a b.md" }))
            .ok();
        assert_eq!(running.post("/api/teacher/settings", &teacher, &json!({ "pace": "none.md" })).status, 400);
        (teacher, joined)
    };
    let running = Running::start(&storage.location);
    let class = running.get("/api/teacher/class", &teacher).ok();
    assert_eq!((&class["settings"]["paused"], &class["settings"]["pace"]), (&json!(true), &json!("a b.md")));
    assert_eq!(running.get("/api/state", token(&joined)).ok()["settings"]["paused"], true);
    // Keys and the token of surveys, too.
    let again = running.post("/api/join", "", &json!({ "code": joined["key"] })).ok();
    assert_eq!((&again["seat"], &again["survey"]), (&joined["seat"], &joined["survey"]));
}
