//! Several servers before one database. `cargo test -p server --test all postgres:: -- --ignored`

use crate::client::{Running, block, parts};
use crate::durable;
use crate::storage::{Cluster, Storage};
use crate::streams::Stream;
use serde_json::{Value, json};
use server::store::Location;
use server::{Fault, Store};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// Two servers that start at the same time before an empty database.
fn two() -> (Storage, [Running; 2]) {
    let storage = Storage::database();
    let servers = std::thread::scope(|scope| {
        [(); 2].map(|()| scope.spawn(|| Running::start(&storage.location))).map(|server| server.join().unwrap())
    });
    assert_eq!(servers[0].class.code(), servers[1].class.code());
    (storage, servers)
}

fn text<'a>(value: &'a Value, name: &str) -> &'a str {
    value[name].as_str().unwrap()
}

#[test]
#[ignore = "needs Postgres"]
fn a_class_takes_so_many_answers_to_surveys_and_says_when_it_is_full() {
    let storage = Storage::database();
    let running = Running::start(&storage.location);
    let joined = running.join();
    let class = running.class.id();
    let rows = format!(
        "INSERT INTO meniscus.sheet SELECT '{class}', decode(lpad(to_hex(n), 32, '0'), 'hex'), '{{}}' FROM generate_series(1, 9999) n"
    );
    Cluster::shared().sql(storage.name(), &rows);
    let send =
        |number: &str| running.survey(text(&joined, "survey"), number, &json!({ "meniscus survey": 1, "items": [] }));
    assert_eq!(send("1-1").status, 200);
    assert_eq!(send("2-2").why(), (413, "full".to_owned()));
    assert_eq!(send("1-1").status, 200);
}

#[test]
#[ignore = "needs Postgres"]
fn what_is_said_to_one_server_holds_on_the_other_at_once() {
    let (_storage, [one, other]) = two();
    // A link works once, wherever.
    let link = json!({ "link": one.link() });
    let teacher = other.post("/api/teacher/exchange", "", &link).ok()["token"].as_str().unwrap().to_owned();
    assert_eq!(one.post("/api/teacher/exchange", "", &link).why(), (403, "link".to_owned()));
    one.get("/api/teacher/class", &teacher).ok();

    // Seats and tokens.
    let joined: Vec<Value> = (0..10).map(|turn| [&one, &other][turn % 2].join()).collect();
    let seats: BTreeSet<u64> = joined.iter().map(|joined| joined["seat"].as_u64().unwrap()).collect();
    assert_eq!(seats, (1..=10).collect());
    let token = text(&joined[0], "token");
    let send = |server: &Running, seq| {
        server.post("/api/events", token, &json!({ "events": parts(seq, "4.5", "correct") })).why()
    };
    assert_eq!(send(&one, 1).0, 200);
    // The same once more, to the other one.
    assert_eq!(send(&other, 1).0, 200);
    assert_eq!(other.get("/api/mine", token).ok()["events"].as_array().unwrap().len(), 6);
    let again = other.post("/api/join", "", &json!({ "code": joined[0]["key"] })).ok();
    assert_eq!((&again["seat"], &again["pseudonym"]), (&joined[0]["seat"], &joined[0]["pseudonym"]));

    // Settings, each way, many times: no message has to arrive in between.
    let set = |server: &Running, settings: Value| drop(server.post("/api/teacher/settings", &teacher, &settings).ok());
    for round in 0..20 {
        let (here, there) = if round % 2 == 0 { (&one, &other) } else { (&other, &one) };
        set(here, json!({ "open": false }));
        assert_eq!(send(there, 100), (403, "closed".to_owned()));
        set(there, json!({ "open": true, "pace": "a b.md" }));
        assert_eq!(send(here, 100 + 10 * round).0, 200);
        assert_eq!(here.get("/api/state", token).ok()["settings"]["pace"], "a b.md");
    }
    set(&one, json!({ "open": true, "approve": true, "others": true, "results": true }));
    let late = other.join();
    assert_eq!(late["approved"], false);
    one.post("/api/teacher/approve", &teacher, &json!({ "seat": late["seat"] })).ok();
    other.post("/api/events", text(&late, "token"), &json!({ "events": parts(1, "9", "wrong") })).ok();
    let seen = one.get("/api/others", token).ok();
    assert_eq!(seen["questions"][0]["results"], json!({ "answered": 2, "right": 1 }));

    // A class that begins later, and its end.
    let class = block(other.server.classes().begin("Other", 30, server::now())).unwrap();
    let third = one.post("/api/join", "", &json!({ "code": class.code() })).ok();
    assert_eq!(third["seat"], 1);
    block(other.server.classes().store().erase_class(class.id().to_owned())).unwrap();
    assert_eq!(one.get("/api/mine", text(&third, "token")).status, 401);
    assert_eq!(one.post("/api/join", "", &json!({ "code": class.code() })).status, 404);

    // Erasing.
    one.post("/api/teacher/erase", &teacher, &json!({ "seat": 1 })).ok();
    assert_eq!(other.get("/api/mine", token).status, 401);
    assert_eq!(other.post("/api/join", "", &json!({ "code": joined[0]["key"] })).status, 404);
}

#[test]
#[ignore = "needs Postgres"]
fn streams_of_one_server_show_what_arrives_at_the_other() {
    let (_storage, [one, other]) = two();
    let (joined, teacher) = (one.join(), other.teacher());
    let (mut dashboard, _) = Stream::open(&other, "/api/teacher/stream?since=0", &teacher);
    assert_eq!(dashboard.next().unwrap()["seats"].as_array().unwrap().len(), 1);
    one.post("/api/events", text(&joined, "token"), &json!({ "events": parts(1, "4.5", "correct") })).ok();
    let news = dashboard.next().unwrap();
    let last = news["last"].as_u64().unwrap();
    assert_eq!(news["events"].as_array().unwrap().len(), 6);
    one.join();
    assert_eq!(dashboard.next().unwrap()["seats"].as_array().unwrap().len(), 2);
    // It goes on at the other server by its number.
    drop(dashboard);
    other.post("/api/events", text(&joined, "token"), &json!({ "events": parts(7, "5", "wrong") })).ok();
    let (mut dashboard, _) = Stream::open(&one, &format!("/api/teacher/stream?since={last}"), &teacher);
    assert_eq!(dashboard.next().unwrap()["events"].as_array().unwrap().len(), 6);

    let (mut student, _) = Stream::open(&one, "/api/stream", text(&joined, "token"));
    assert_eq!(student.next().unwrap()["settings"]["paused"], false);
    other.post("/api/teacher/settings", &teacher, &json!({ "open": true, "paused": true })).ok();
    assert_eq!(student.next().unwrap()["settings"]["paused"], true);
}

#[test]
#[ignore = "needs Postgres"]
fn who_reads_by_number_misses_nothing_that_several_servers_write() {
    let (_storage, servers) = two();
    let teacher = servers[0].teacher();
    let tokens: Vec<String> = (0..8).map(|_| text(&servers[0].join(), "token").to_owned()).collect();
    let ends = AtomicBool::new(false);
    let seen = std::thread::scope(|scope| {
        let reader = scope.spawn(|| {
            let mut seen: BTreeSet<(u64, u64)> = BTreeSet::new();
            let mut since = 0;
            loop {
                let is_last = ends.load(Ordering::Relaxed);
                let news = servers[1].get(&format!("/api/teacher/events?since={since}"), &teacher).ok();
                let events = news["events"].as_array().unwrap();
                for event in events {
                    let number = event["number"].as_u64().unwrap();
                    assert!(number > since);
                    assert!(seen.insert((event["seat"].as_u64().unwrap(), number)));
                    since = number;
                }
                if is_last && events.is_empty() {
                    return seen.len();
                }
            }
        });
        let writers: Vec<_> = tokens
            .iter()
            .enumerate()
            .map(|(place, token)| {
                let server = &servers[place % 2];
                scope.spawn(move || {
                    for round in 0..30 {
                        let body = json!({ "events": parts(1 + 6 * round, "1", "wrong") });
                        server.post("/api/events", token, &body).ok();
                    }
                })
            })
            .collect();
        writers.into_iter().for_each(|writer| writer.join().unwrap());
        ends.store(true, Ordering::Relaxed);
        reader.join().unwrap()
    });
    assert_eq!(seen, 8 * 30 * 6);
}

/// Acknowledged hand-ins by seat and first number, and those that the servers have of them.
fn nothing_is_lost_or_doubled(running: &Running, tokens: &[(u64, String)], acknowledged: &BTreeSet<(u64, u64)>) {
    let mut found: BTreeMap<(u64, u64), u32> = BTreeMap::new();
    for (seat, token) in tokens {
        for event in running.get("/api/mine", token).ok()["events"].as_array().unwrap() {
            *found.entry((*seat, event["seq"].as_u64().unwrap())).or_default() += 1;
        }
    }
    assert!(!acknowledged.is_empty());
    for (seat, seq) in acknowledged {
        for part in 0..6 {
            assert_eq!(found.get(&(*seat, seq + part)), Some(&1), "seat {seat}, part {seq} + {part}");
        }
    }
    assert!(found.len().is_multiple_of(6));
}

fn join(address: std::net::SocketAddr, code: &str) -> (u64, String) {
    let joined = durable::post(address, "/api/join", "", &json!({ "code": code }).to_string()).unwrap().ok();
    (joined["seat"].as_u64().unwrap(), text(&joined, "token").to_owned())
}

#[test]
#[ignore = "needs Postgres"]
fn one_server_is_killed_and_the_other_carries_on() {
    let storage = Storage::database();
    let (mut victim, first, code) = durable::start(&storage);
    let (mut heir, second, same) = durable::start(&storage);
    assert_eq!(code, same);
    let tokens: Vec<(u64, String)> = (0..8).map(|turn| join([first, second][turn % 2], &code)).collect();
    let acknowledged: Mutex<BTreeSet<(u64, u64)>> = Mutex::default();
    let (is_killed, ends) = (AtomicBool::new(false), AtomicBool::new(false));
    let after = AtomicBool::new(false);
    std::thread::scope(|scope| {
        for (seat, token) in &tokens {
            let (acknowledged, is_killed, ends, after) = (&acknowledged, &is_killed, &ends, &after);
            scope.spawn(move || {
                let mut seq = 1;
                while !ends.load(Ordering::Relaxed) {
                    let was_killed = is_killed.load(Ordering::Relaxed);
                    let body = json!({ "events": parts(seq, "1", "wrong") }).to_string();
                    let servers = if seq % 12 == 1 { [first, second] } else { [second, first] };
                    // As a balancer does: the other one, if one does not answer.
                    if servers.into_iter().any(|server| durable::post(server, "/api/events", token, &body).is_some()) {
                        acknowledged.lock().unwrap().insert((*seat, seq));
                        after.fetch_or(was_killed, Ordering::Relaxed);
                        seq += 6;
                    }
                }
            });
        }
        std::thread::sleep(Duration::from_millis(300));
        victim.kill().unwrap();
        is_killed.store(true, Ordering::Relaxed);
        std::thread::sleep(Duration::from_millis(400));
        ends.store(true, Ordering::Relaxed);
    });
    assert!(after.into_inner(), "the other one takes hand-ins");
    victim.wait().unwrap();
    heir.kill().unwrap();
    heir.wait().unwrap();
    let running = Running::start(&storage.location);
    nothing_is_lost_or_doubled(&running, &tokens, &acknowledged.into_inner().unwrap());
}

#[test]
#[ignore = "needs Postgres"]
fn outboxes_empty_themselves_when_the_database_is_restarted() {
    let cluster = Cluster::start();
    let storage = Storage::in_cluster(&cluster);
    let servers = [(); 2].map(|()| Running::start(&storage.location));
    let teacher = servers[0].teacher();
    let tokens: Vec<(u64, String)> = (0..8).map(|_| join(servers[0].address, &servers[0].class.code())).collect();
    let acknowledged: Mutex<BTreeSet<(u64, u64)>> = Mutex::default();
    let (ends, refused) = (AtomicBool::new(false), AtomicBool::new(false));
    std::thread::scope(|scope| {
        for (seat, token) in &tokens {
            let (acknowledged, ends, refused, servers) = (&acknowledged, &ends, &refused, &servers);
            scope.spawn(move || {
                let (mut seq, mut turn) = (1, 0);
                while !ends.load(Ordering::Relaxed) {
                    let body = json!({ "events": parts(seq, "1", "wrong") });
                    // The hand-in stays in the outbox until one of the servers acknowledges it.
                    loop {
                        turn += 1;
                        let answer = servers[turn % 2].post("/api/events", token, &body);
                        if answer.status == 200 {
                            break;
                        }
                        assert_eq!(answer.why(), (503, "store".to_owned()), "{}", answer.body);
                        assert!(answer.head.contains("retry-after: 2"), "{}", answer.head);
                        refused.store(true, Ordering::Relaxed);
                        std::thread::sleep(Duration::from_millis(50));
                    }
                    acknowledged.lock().unwrap().insert((*seat, seq));
                    seq += 6;
                }
            });
        }
        std::thread::sleep(Duration::from_millis(200));
        cluster.restart("fast");
        std::thread::sleep(Duration::from_millis(500));
        cluster.restart("immediate");
        std::thread::sleep(Duration::from_millis(500));
        ends.store(true, Ordering::Relaxed);
    });
    assert!(refused.into_inner(), "there was a time without a database");
    nothing_is_lost_or_doubled(&servers[1], &tokens, &acknowledged.into_inner().unwrap());
    // The servers hear each other again.
    let (mut student, _) = Stream::open(&servers[0], "/api/stream", &tokens[0].1);
    student.next().unwrap();
    servers[1].post("/api/teacher/settings", &teacher, &json!({ "open": true, "paused": true })).ok();
    assert_eq!(student.next().unwrap()["settings"]["paused"], true);
}

#[test]
#[ignore = "needs Postgres"]
fn no_byte_of_an_erased_class_stays_in_the_files_of_rewritten_tables() {
    const SECRET: &str = "an answer that no other test has typed";
    let cluster = Cluster::shared();
    let storage = Storage::database();
    let running = Running::start(&storage.location);
    let joined = running.join();
    let long = format!("{SECRET} {}", "x".repeat(50_000));
    for value in [SECRET, &long] {
        let events = json!([{ "seq": value.len(), "document": "tube.md", "part": "item:q1", "value": value }]);
        running.post("/api/events", text(&joined, "token"), &json!({ "events": events })).ok();
    }
    assert!(cluster.files_hold(storage.name(), SECRET));
    let store = running.server.classes().store();
    block(running.server.classes().erase(&running.class, 1)).unwrap();
    block(store.rewrite()).unwrap();
    assert!(!cluster.files_hold(storage.name(), SECRET));
    assert_eq!(running.join()["seat"], 2);
}

#[test]
#[ignore = "needs Postgres"]
fn other_databases_are_refused_with_a_reason_and_without_the_password() {
    let storage = Storage::database();
    let open = |address: &str| block(async { Store::open(&Location::read(address, None).unwrap()).await }).err();
    // There is no store yet, and looking makes none.
    assert!(matches!(block(Store::existing(&storage.location)), Err(Fault::NoStore(_))));
    assert!(matches!(block(Store::existing(&storage.location)), Err(Fault::NoStore(_))));
    let wrong =
        storage.address.replacen("postgres:", "postgres:a-secret", 2).replacen("postgres:a-secret", "postgres:", 1);
    let fault = open(&wrong).unwrap();
    assert!(fault.to_string().contains("password authentication failed"), "{fault}");
    assert!(!fault.to_string().contains("secret"), "{fault}");
    let (start, _) = storage.address.rsplit_once('/').unwrap();
    let fault = open(&format!("{start}/no_such_database")).unwrap();
    assert!(fault.to_string().contains("no_such_database"), "{fault}");
}

#[test]
#[ignore = "needs Postgres"]
fn connections_are_encrypted_if_the_address_says_so() {
    let cluster = Cluster::shared();
    let mut storage = Storage::database();
    storage.address = storage.address.replace("127.0.0.1", "localhost") + "?sslmode=require";
    // Nobody trusts the certificate.
    let location = Location::read(&storage.address, None).unwrap();
    let fault = block(async { Store::open(&location).await }).err().unwrap();
    assert!(matches!(&fault, Fault::Away(why) if why.contains("certificate")), "{fault}");
    let certificate = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/all/tls-cert.pem");
    let (mut child, address, code) = durable::start_with(&storage, &[("SSL_CERT_FILE", certificate)]);
    join(address, &code);
    let encrypted = format!(
        "SELECT bool_and(ssl) FROM pg_stat_ssl JOIN pg_stat_activity USING (pid) WHERE application_name = 'meniscus' AND datname = '{}'",
        storage.name()
    );
    assert_eq!(cluster.sql("postgres", &encrypted), "t\n");
    child.kill().unwrap();
    child.wait().unwrap();
}

#[test]
fn no_text_of_a_location_has_its_password() {
    let read = |text: &str| Location::read(text, Some("from-environment"));
    let location = read("postgres://meniscus:p%40ss@db.example:5433/class?sslmode=prefer").unwrap();
    assert_eq!(location.to_string(), "postgres://meniscus@db.example:5433/class");
    assert!(!format!("{location:?}").contains("p@ss"));
    let location = read("postgresql://meniscus@db.example/class").unwrap();
    assert_eq!(location.to_string(), "postgres://meniscus@db.example/class");
    let Location::Database(config) = &location else { panic!("{location}") };
    assert_eq!(config.get_password(), Some(&b"from-environment"[..]));
    for wrong in ["postgres://", "postgres://u:secret@h:port/d", "postgres://u:secret@h/d?secret=1", "postgres:///d"] {
        assert!(matches!(read(wrong), Err(Fault::Address)), "{wrong}");
    }
    assert!(matches!(read("a.sqlite"), Ok(Location::File(_))));
}
