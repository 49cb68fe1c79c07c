//! From joining to the teacher's hand-in.

use crate::client::{Running, parts};
use crate::storage::{Storage, cases};
use saved::hand_in::HandIn;
use serde_json::json;

cases!(
    a_hand_in_of_a_student_reaches_the_teacher,
    a_student_sees_downloads_and_erases_what_is_stored,
    another_device_takes_the_same_seat_and_numbers_do_not_collide,
    survey_answers_have_neither_seat_nor_order,
);

fn a_hand_in_of_a_student_reaches_the_teacher(storage: &Storage) {
    let running = Running::start(&storage.location);
    let joined = running.join();
    let token = joined["token"].as_str().unwrap();
    let sent = running.post("/api/events", token, &json!({ "events": parts(1, "4.5", "correct") })).ok();
    assert_eq!(sent["highest"], 6);

    let teacher = running.teacher();
    let news = running.get("/api/teacher/events?since=0", &teacher).ok();
    let lines = news["events"].as_array().unwrap();
    assert_eq!(lines.len(), 6);
    assert!(lines.iter().all(|line| line["document"] == "tube.md" && line["seat"] == 1));
    assert_eq!(running.get("/api/teacher/events?since=6", &teacher).ok()["events"], json!([]));

    let file = running.hand_in(1, &teacher);
    let hand_in = HandIn::read(&file.body).unwrap();
    // Of several documents the sender has the name of one.
    assert_eq!(hand_in.sender.name, format!("{} (tube.md)", joined["pseudonym"].as_str().unwrap()));
    assert_eq!(hand_in.work.documents[0].text, "# Tube\n\"ñ\u{2028}");
    assert_eq!(hand_in.work.items.len(), 1);
    assert!(file.body.contains("0.30000000000000004"), "numbers keep their bits: {}", file.body);
}

fn a_student_sees_downloads_and_erases_what_is_stored(storage: &Storage) {
    let running = Running::start(&storage.location);
    let joined = running.join();
    let token = joined["token"].as_str().unwrap();
    running.post("/api/events", token, &json!({ "events": parts(1, "4.5", "correct") })).ok();
    let mine = running.get("/api/mine", token).ok();
    assert_eq!(mine["events"].as_array().unwrap().len(), 6);
    assert!(HandIn::read(mine["hand-ins"][0].as_str().unwrap()).is_ok());
    running.post("/api/erase", token, &json!({})).ok();
    assert_eq!(running.get("/api/mine", token).why(), (401, "token".to_owned()));
    let teacher = running.teacher();
    let news = running.get("/api/teacher/events?since=0", &teacher).ok();
    assert_eq!((&news["events"], &news["seats"]), (&json!([]), &json!([])));
    // The number of an erased seat is not given again.
    assert_eq!(running.join()["seat"], 2);
}

fn another_device_takes_the_same_seat_and_numbers_do_not_collide(storage: &Storage) {
    let running = Running::start(&storage.location);
    let first = running.join();
    let second = running.post("/api/join", "", &json!({ "code": first["key"] })).ok();
    assert_eq!((&second["seat"], &second["pseudonym"]), (&first["seat"], &first["pseudonym"]));
    let [one, other] = [&first, &second].map(|joined| joined["token"].as_str().unwrap());
    running.post("/api/events", one, &json!({ "events": parts(1, "4.5", "correct") })).ok();
    let taken = running.post("/api/events", other, &json!({ "events": parts(1, "9", "wrong") }));
    assert_eq!((taken.why(), taken.body.contains("\"highest\":6")), ((409, "taken".to_owned()), true));
    // Each device gets what the other has handed in.
    let known = running.get("/api/hand-in/tube.md", other);
    assert!(known.status == 200 && known.body.contains("\"typed\":\"4.5\""), "{}", known.body);
    assert_eq!(running.get("/api/hand-in/a%20b.md", other).why(), (404, "missing".to_owned()));
    assert_eq!(running.get("/api/hand-in/tube.md", "x").status, 401);
    running.post("/api/events", other, &json!({ "events": parts(7, "9", "wrong") })).ok();
    let teacher = running.teacher();
    assert!(running.hand_in(1, &teacher).body.contains("\"typed\":\"9\""));
}

/// What a proxy logs beside the address of a student must not be of use with the store: no path or query that a page asks for has a
/// seat or the number of something stored.
#[test]
fn no_address_that_a_page_asks_for_has_a_seat_or_a_number_of_what_is_stored() {
    let storage = Storage::file();
    let running = Running::start(&storage.location);
    let pages = [running.get("/d/tube.md", ""), running.get("/teacher", "")].map(|page| page.body);
    let mut asked: Vec<&str> = Vec::new();
    for page in &pages {
        for call in page.split("/api/").skip(1) {
            let address = call.split(['"', '`']).next().unwrap();
            // What stands in the place of a variable.
            asked.extend(address.split("${").skip(1).map(|rest| rest.split('}').next().unwrap()));
        }
    }
    asked.sort_unstable();
    asked.dedup();
    // Names of documents, and the order of arrival that a dashboard has reached.
    assert_eq!(asked, ["encodeURIComponent(config.document)", "since", "wait"]);
    let student = running.join();
    let old = running.post("/api/survey/1-1", student["survey"].as_str().unwrap(), &json!({}));
    assert_eq!(old.status, 404);
}

#[test]
fn the_file_for_a_class_connects_to_its_server_alone() {
    let storage = Storage::file();
    let running = Running::start(&storage.location);
    let token = running.join()["token"].as_str().unwrap().to_owned();
    let file = running.get("/api/file/tube.md", &token);
    assert_eq!(file.status, 200);
    assert!(file.body.contains("default-src 'none'; connect-src http://192.0.2.1:4242\""), "{}", file.body);
    assert!(file.body.contains(&running.class.code()));
    let page = running.get("/d/tube.md", "");
    assert!(page.body.contains("connect-src 'self'") && !page.body.contains(&running.class.code()));
    let tag = page.head.lines().find_map(|line| line.strip_prefix("etag: ")).unwrap().to_owned();
    let again = crate::client::send(
        running.address,
        "GET",
        "/d/tube.md",
        &[("Host", "localhost"), ("If-None-Match", &tag)],
        "",
    );
    assert_eq!((again.status, again.body.len()), (304, 0));
    assert_eq!(running.get("/d/a%20b.md", "").status, 200);
    assert_eq!(running.get("/d/none.md", "").status, 404);
}

fn survey_answers_have_neither_seat_nor_order(storage: &Storage) {
    let running = Running::start(&storage.location);
    let joined = running.join();
    let survey = joined["survey"].as_str().unwrap();
    for number in 0..20 {
        let sheet = json!({ "meniscus survey": 1, "document": "T", "items": [], "n": number });
        // The reply to the first one was lost: it is sent again.
        (0..2).for_each(|_| drop(running.survey(survey, &format!("{number}-{number}"), &sheet).ok()));
    }
    let teacher = running.teacher();
    // They are sent at a random time, which may be after the end of the lesson.
    running.post("/api/teacher/settings", &teacher, &json!({ "open": false })).ok();
    running.survey(survey, "late", &json!({ "meniscus survey": 1, "items": [], "late": true })).ok();
    // The route takes nothing else.
    for other in [json!({ "late": true }), json!("x".repeat(5000)), json!({ "meniscus survey": 1, "items": [{}] })] {
        assert_eq!(running.survey(survey, "other", &other).why(), (400, "body".to_owned()), "{other}");
    }
    let sheets = running.get("/api/teacher/sheets", &teacher).ok();
    let numbers: Vec<String> = sheets["sheets"].as_array().unwrap().iter().map(|sheet| sheet.to_string()).collect();
    assert_eq!(numbers.len(), 21);
    let mut sorted = numbers.clone();
    sorted.sort_by_key(|sheet| sheet.len());
    assert_ne!(numbers, sorted);
    // The one event is that of the settings.
    let events = running.get("/api/teacher/events?since=0", &teacher).ok();
    assert_eq!(
        events["events"].as_array().unwrap().iter().map(|event| &event["seat"]).collect::<Vec<_>>(),
        [&json!(0)]
    );
    // The token of the survey opens nothing else.
    assert_eq!(running.get("/api/mine", survey).why(), (403, "token".to_owned()));
}
