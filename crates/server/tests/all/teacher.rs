//! Actions of the teacher.

use crate::client::{Running, block, parts};
use crate::storage::{Storage, cases};
use crate::streams::Stream;
use serde_json::{Value, json};

cases!(
    a_closed_class_accepts_nothing_until_it_is_opened,
    nobody_takes_a_seat_while_the_class_is_closed_or_gives_none,
    a_new_code_closes_the_former_one_and_keeps_the_seats,
    seats_without_work_are_erased_and_no_others,
    late_joiners_wait_for_the_teacher,
    others_answers_are_seen_after_ones_own_and_only_if_shown,
    settings_outlive_the_server,
    students_of_an_earlier_class_are_told_and_join_the_present_one,
    a_teacher_revokes_other_devices_and_unused_links,
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

fn a_teacher_revokes_other_devices_and_unused_links(storage: &Storage) {
    let running = Running::start(&storage.location);
    let (own, other, joined, link) = (running.teacher(), running.teacher(), running.join(), running.link());
    let status = |token: &str| running.get("/api/teacher/class", token).status;
    assert_eq!([status(&own), status(&other)], [200; 2]);
    assert_eq!(running.post("/api/teacher/revoke", token(&joined), &json!({})).status, 403);
    running.post("/api/teacher/revoke", &own, &json!({})).ok();
    assert_eq!([status(&own), status(&other)], [200, 401]);
    let exchange = |link: &str| running.post("/api/teacher/exchange", "", &json!({ "link": link }));
    assert_eq!(exchange(&link).why(), (403, "link".to_owned()));
    running.get("/api/state", token(&joined)).ok();
    // A new link works, and what was revoked stays so at the next start.
    let third = running.teacher();
    assert_eq!(status(&third), 200);
    drop(running);
    let running = Running::start(&storage.location);
    let status = |token: &str| running.get("/api/teacher/class", token).status;
    assert_eq!([status(&own), status(&other), status(&third)], [200, 401, 200]);
}

/// A line for each request, with nothing that tells who it was or what they have answered.
#[test]
fn the_log_has_routes_and_no_answers_names_or_secrets() {
    let storage = Storage::file();
    let running = Running::start(&storage.location);
    let joined = running.join();
    running.post("/api/events", token(&joined), &json!({ "events": parts(1, "4.56789", "correct") })).ok();
    running.get("/d/tube.md", "");
    running.get("/api/hand-in/tube.md", token(&joined)).ok();
    running.get("/mallory?who=me", "");
    running.send("BREW", "/health", "", "");
    let log = running.log.text();
    let lines: Vec<Value> = log.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let said: Vec<_> = lines.iter().map(|line| json!([line["method"], line["route"], line["status"]])).collect();
    assert_eq!(
        said,
        [
            json!(["POST", "/api/join", 200]),
            json!(["POST", "/api/events", 200]),
            json!(["GET", "/d/{name}", 200]),
            json!(["GET", "/api/hand-in/{document}", 200]),
            json!(["GET", null, 404]),
            json!(["other", "/health", 405]),
        ]
    );
    assert!(lines.iter().all(|line| line.as_object().unwrap().len() == 5 && line["ms"].is_u64()), "{log}");
    let pseudonym = joined["pseudonym"].as_str().unwrap();
    for secret in ["4.56789", "tube", "127.0.0.1", "mallory", token(&joined), &running.class.code(), pseudonym] {
        assert!(!log.contains(secret), "{secret}: {log}");
    }
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

fn students_of_an_earlier_class_are_told_and_join_the_present_one(storage: &Storage) {
    let running = Running::start(&storage.location);
    let joined = running.join();
    let (mut stream, _) = Stream::open(&running, "/api/stream", token(&joined));
    assert_eq!(stream.next().unwrap()["earlier"], false);
    // Classes are in the order of their times, which are in milliseconds.
    let present = block(running.server.classes().begin("Springs", 30, server::now() + 1)).unwrap();
    assert_eq!(stream.next().unwrap()["earlier"], true);
    assert_eq!(running.get("/api/state", token(&joined)).ok()["earlier"], true);
    // The earlier class keeps what arrives.
    running.post("/api/events", token(&joined), &json!({ "events": parts(1, "1", "wrong") })).ok();
    let again = running.post("/api/join", "", &json!({ "code": present.code() })).ok();
    assert_eq!(running.get("/api/state", token(&again)).ok()["earlier"], false);
    running.post("/api/events", token(&again), &json!({ "events": parts(1, "2", "wrong") })).ok();
    let mine = |joined: &Value| running.get("/api/mine", token(joined)).ok()["hand-ins"][0].to_string();
    assert!(mine(&joined).contains(r#"\"typed\":\"1\""#) && mine(&again).contains(r#"\"typed\":\"2\""#));
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
