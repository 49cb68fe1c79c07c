//! What strangers and students must not be able to do.

use crate::client::{Running, block, parts, place, read, send};
use crate::storage::{Storage, cases};
use serde_json::{Value, json};
use server::http::{LARGEST, Place};
use server::store::Location;
use std::collections::BTreeSet;
use std::io::Write;
use std::net::TcpStream;
use std::sync::atomic::{AtomicUsize, Ordering};

cases!(
    two_thousand_students_join_from_one_address,
    tokens_open_their_own_class_and_seat_alone,
    the_link_of_the_teacher_works_once,
);

#[test]
fn wrong_codes_are_limited_and_right_ones_are_not() {
    let storage = Storage::file();
    let running = Running::start(&storage.location);
    let wrong = || running.post("/api/join", "", &json!({ "code": "22222I" })).why();
    for _ in 0..20 {
        assert_eq!(wrong(), (404, "code".to_owned()));
    }
    assert_eq!(wrong(), (429, "code".to_owned()));
    // Right codes pass, from the same address.
    running.join();
    let (passed, waits) = (AtomicUsize::new(0), AtomicUsize::new(0));
    std::thread::scope(|scope| {
        for _ in 0..60 {
            scope.spawn(|| match wrong() {
                (429, why) if why == "wait" => waits.fetch_add(1, Ordering::Relaxed),
                _ => passed.fetch_add(1, Ordering::Relaxed),
            });
        }
    });
    // Codes are tried one after the other; no more than 32 wait.
    assert!(waits.into_inner() > 0 && passed.into_inner() <= 50);
}

fn two_thousand_students_join_from_one_address(storage: &Storage) {
    let running = Running::start(&storage.location);
    std::thread::scope(|scope| {
        for _ in 0..20 {
            scope.spawn(|| (0..100).for_each(|_| drop(running.join())));
        }
    });
    let seats = running.class.seats();
    assert_eq!(seats.len(), 2000);
    let names: BTreeSet<&str> = seats.iter().map(|seat| seat.pseudonym.as_str()).collect();
    assert_eq!(names.len(), 2000);
}

#[test]
fn other_hosts_are_refused() {
    let storage = Storage::file();
    let running = Running::start(&storage.location);
    let asked = |host: &str| send(running.address, "GET", "/", &[("Host", host)], "").status;
    for host in ["127.0.0.1:4250", "localhost", "192.168.1.5:4250", "[::1]:4250", "class.example", "CLASS.example:443"]
    {
        assert_eq!(asked(host), 200, "{host}");
    }
    for host in ["attacker.example", "class.example.attacker.example", "127.0.0.1.attacker.example", "", "[attacker]"] {
        assert_eq!(asked(host), 403, "{host}");
    }
    assert_eq!(send(running.address, "GET", "/teacher", &[("Host", "attacker.example")], "").status, 403);
}

fn tokens_open_their_own_class_and_seat_alone(storage: &Storage) {
    let running = Running::start(&storage.location);
    let student = running.join()["token"].as_str().unwrap().to_owned();
    let teacher = running.teacher();
    running.post("/api/events", &student, &json!({ "events": parts(1, "4.5", "correct") })).ok();
    for path in ["class", "events?since=0", "stream?since=0", "sheets"] {
        let path = format!("/api/teacher/{path}");
        assert_eq!(running.get(&path, &student).why(), (403, "token".to_owned()), "{path}");
        assert_eq!(running.get(&path, "").why(), (401, "token".to_owned()), "{path}");
        assert_eq!(running.get(&path, &"A".repeat(43)).status, 401, "{path}");
    }
    for path in ["settings", "approve", "erase", "erase-unused", "renew-code", "hand-in"] {
        let path = format!("/api/teacher/{path}");
        assert_eq!(running.post(&path, &student, &json!({ "seat": 1, "document": "tube.md" })).status, 403, "{path}");
    }
    for path in ["state", "stream", "mine", "others", "file/tube.md"] {
        assert_eq!(running.get(&format!("/api/{path}"), &teacher).status, 403, "{path}");
    }
    // Another class in the same store.
    let classes = running.server.classes();
    let other = block(classes.begin("Other", 30, server::now())).unwrap();
    let link = block(classes.link(&other)).unwrap();
    let others = running.post("/api/teacher/exchange", "", &json!({ "link": link })).ok()["token"].clone();
    let others = others.as_str().unwrap();
    assert_eq!(running.hand_in(1, others).status, 404);
    assert_eq!(running.get("/api/teacher/events?since=0", others).ok()["events"], json!([]));
    assert_eq!(running.post("/api/teacher/erase", others, &json!({ "seat": 1 })).status, 404);
    assert_eq!(running.hand_in(1, &teacher).status, 200);
}

fn the_link_of_the_teacher_works_once(storage: &Storage) {
    let running = Running::start(&storage.location);
    let link = json!({ "link": running.link() });
    running.post("/api/teacher/exchange", "", &link).ok();
    assert_eq!(running.post("/api/teacher/exchange", "", &link).why(), (403, "link".to_owned()));
}

#[test]
fn the_dashboard_answers_to_this_computer_only_unless_encrypted() {
    let folder = tempfile::tempdir().unwrap();
    // A proxy on this computer passes the address of the client on; without encryption it is not believed to be a proxy.
    let proxied = |place: Place, name: &str| {
        let running = Running::start_at(&Location::File(folder.path().join(name)), place, "127.0.0.1:0");
        send(running.address, "GET", "/teacher", &[("Host", "localhost"), ("X-Forwarded-For", "192.0.2.7")], "").status
    };
    assert_eq!(proxied(place(), "a"), 200);
    let behind = |proxy: &str| Place { is_encrypted: true, proxy: Some(proxy.parse().unwrap()), ..place() };
    assert_eq!(proxied(behind("127.0.0.1"), "b"), 200);
    assert_eq!(proxied(behind("::1"), "d"), 200);
    // No request comes past the proxy, whatever it says of itself.
    assert_eq!(proxied(behind("192.0.2.80"), "e"), 403);
    // A connection from another address of this machine.
    let Some(own) = own_address() else { return assert!(std::net::UdpSocket::bind("127.0.0.1:0").is_ok()) };
    let running = Running::start_at(&Location::File(folder.path().join("c")), place(), &format!("{own}:0"));
    assert_eq!(running.get("/teacher", "").why(), (403, "place".to_owned()));
    assert_eq!(running.get("/", "").status, 200);
    let running = Running::start_at(&Location::File(folder.path().join("f")), behind("127.0.0.1"), &format!("{own}:0"));
    assert_eq!(running.get("/", "").why(), (403, "proxy".to_owned()));
    assert_eq!(running.get("/teacher", "").why(), (403, "proxy".to_owned()));
}

/// An address of this machine besides loopback, if it has one.
fn own_address() -> Option<std::net::IpAddr> {
    let socket = std::net::UdpSocket::bind("0.0.0.0:0").ok()?;
    socket.connect("192.0.2.1:9").ok()?;
    Some(socket.local_addr().ok()?.ip()).filter(|address| !address.is_loopback() && !address.is_unspecified())
}

#[test]
fn bodies_are_bounded() {
    let storage = Storage::file();
    let running = Running::start(&storage.location);
    let token = running.join()["token"].as_str().unwrap().to_owned();
    let claim = |length: &str| {
        let mut stream = TcpStream::connect(running.address).unwrap();
        let head = format!(
            "POST /api/events HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\nAuthorization: Bearer {token}\r\n{length}\r\n\r\n"
        );
        stream.write_all(head.as_bytes()).unwrap();
        read(&mut stream).why()
    };
    assert_eq!(claim(&format!("Content-Length: {}", LARGEST + 1)), (413, "large".to_owned()));
    assert_eq!(claim("Content-Length: 99999999999999999999").0, 400);
    assert_eq!(claim("Transfer-Encoding: chunked").0, 411);
    let large =
        json!({ "events": [{ "seq": 1, "document": "tube.md", "part": "state", "value": "x".repeat(4 << 20) }] });
    running.post("/api/events", &token, &large).ok();
    for (body, why) in [
        ("{\"events\":[]}", "none"),
        ("[", "no JSON"),
        (&*format!("{{\"events\":[{{\"x\":{}", "[".repeat(100_000)), "deep"),
        ("{\"events\":[{\"seq\":0,\"document\":\"tube.md\",\"part\":\"state\",\"value\":1}]}", "number 0"),
        (
            "{\"events\":[{\"seq\":9007199254740993,\"document\":\"tube.md\",\"part\":\"state\",\"value\":1}]}",
            "too high",
        ),
        ("{\"events\":[{\"seq\":2,\"document\":\"other.md\",\"part\":\"state\",\"value\":1}]}", "other document"),
        ("{\"events\":[{\"seq\":2,\"document\":\"tube.md\",\"part\":\"film\",\"value\":1}]}", "other part"),
    ] {
        assert_eq!(running.send("POST", "/api/events", &token, body).why(), (400, "body".to_owned()), "{why}");
    }
    // A seat has room for 64 MiB.
    let mut refused = (200, String::new());
    for seq in 2..20 {
        let body = json!({ "events": [{ "seq": seq, "document": "tube.md", "part": format!("item:{seq}"), "value": "x".repeat(7 << 20) }] });
        refused = running.post("/api/events", &token, &body).why();
        if refused.0 != 200 {
            break;
        }
    }
    assert_eq!(refused, (413, "seat_full".to_owned()));
}

/// Each reason for which a hand-in is refused has a sentence of its own in the pages.
#[test]
fn every_refusal_of_a_hand_in_has_its_own_sentence() {
    let storage = Storage::file();
    let running = Running::start(&storage.location);
    let page = running.get("/d/tube.md", "").body;
    let config = page.split("id=\"class-config\">").nth(1).unwrap().split("</script>").next().unwrap();
    let config: Value = serde_json::from_str(config).unwrap();
    let script = page.split("const REASONS = [").nth(1).unwrap().split(']').next().unwrap();
    let reasons: Vec<&str> = script.split(", ").map(|reason| reason.trim_matches('"')).collect();
    for reason in ["slow", "large", "seat_full", "class_full"] {
        assert!(reasons.contains(&reason), "{reason}");
    }
    for language in ["en", "es", "pt"] {
        let texts = &config["texts"][language];
        let sentences: BTreeSet<&str> = reasons.iter().map(|reason| texts[*reason].as_str().unwrap()).collect();
        assert_eq!(sentences.len(), reasons.len(), "{language}");
        assert!(!sentences.contains(texts["refused"].as_str().unwrap()));
    }
}

#[test]
fn a_student_who_claims_large_bodies_keeps_nobody_waiting() {
    let storage = Storage::file();
    let running = Running::start(&storage.location);
    let [idle, other] = [(); 2].map(|()| running.join()["token"].as_str().unwrap().to_owned());
    let claim = || {
        let mut stream = TcpStream::connect(running.address).unwrap();
        let head = format!(
            "POST /api/events HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\nAuthorization: Bearer {idle}\r\nContent-Length: {LARGEST}\r\n\r\n"
        );
        stream.write_all(head.as_bytes()).unwrap();
        stream
    };
    let claims: Vec<TcpStream> = (0..13).map(|_| claim()).collect();
    claims.iter().for_each(|stream| stream.set_nonblocking(true).unwrap());
    // A seat sends two at the same time; whichever they are, the others are refused.
    let refused = || claims.iter().filter(|stream| stream.peek(&mut [0]).is_ok()).count();
    assert!((0..20_000).any(|_| {
        std::thread::sleep(std::time::Duration::from_millis(1));
        refused() == 11
    }));
    let large =
        json!({ "events": [{ "seq": 1, "document": "tube.md", "part": "state", "value": "x".repeat(4 << 20) }] });
    running.post("/api/events", &other, &large).ok();
    running.join();
    // A small one, because the connection is closed while the bytes of a large one are on their way.
    let small = json!({ "events": parts(1, "5", "right") });
    assert_eq!(running.post("/api/events", &idle, &small).why(), (429, "many".to_owned()));
}

#[test]
fn a_client_that_sends_nothing_keeps_nobody_waiting() {
    let storage = Storage::file();
    let running = Running::start(&storage.location);
    let _silent: Vec<TcpStream> = (0..200)
        .map(|_| {
            let mut stream = TcpStream::connect(running.address).unwrap();
            stream.write_all(b"POST /api/join HTTP/1.1\r\nHost: localhost\r\nContent-Length: 20\r\n\r\n{").unwrap();
            stream
        })
        .collect();
    assert_eq!(running.get("/", "").status, 200);
    running.join();
}

#[test]
fn no_answer_sets_a_cookie_and_other_origins_need_a_token() {
    let storage = Storage::file();
    let running = Running::start(&storage.location);
    let joined = running.join();
    let token = joined["token"].as_str().unwrap();
    let teacher = running.teacher();
    let answers = [
        running.get("/", ""),
        running.get("/d/tube.md", ""),
        running.get("/stored", ""),
        running.get("/teacher", ""),
        running.get("/api/state", token),
        running.get("/api/mine", token),
        running.get("/api/teacher/class", &teacher),
        running.post("/api/join", "", &json!({ "code": running.class.code() })),
        running.post("/api/join", "", &json!({ "code": "x" })),
    ];
    for answer in &answers {
        assert!(!answer.head.contains("set-cookie"), "{}", answer.head);
        assert!(answer.head.contains("x-content-type-options: nosniff"), "{}", answer.head);
        assert!(!answer.head.contains("allow-credentials"), "{}", answer.head);
    }
    assert!(answers[4].head.contains("access-control-allow-origin: *"));
    assert!(!answers[6].head.contains("access-control-allow-origin"), "{}", answers[6].head);
    assert!(!answers[3].head.contains("access-control-allow-origin"));
    let preflight = send(running.address, "OPTIONS", "/api/events", &[("Host", "localhost"), ("Origin", "null")], "");
    assert_eq!(preflight.status, 204);
    assert!(preflight.head.contains("access-control-allow-headers: authorization"));
    let foreign = send(
        running.address,
        "OPTIONS",
        "/api/teacher/erase",
        &[("Host", "localhost"), ("Origin", "http://a.example")],
        "",
    );
    assert!(!foreign.head.contains("access-control-allow"), "{}", foreign.head);
}

#[test]
fn scripts_in_the_names_of_documents_stay_texts() {
    let storage = Storage::file();
    let running = Running::start(&storage.location);
    let page = running.get("/d/tube.md", "").body;
    let start = page.find("id=\"class-config\">").unwrap();
    let config = &page[start..start + page[start..].find("</script>").unwrap()];
    assert!(!config[20..].contains('<'), "{config}");
}
