//! A server that is killed.

use crate::client::{Answer, Running, parts, read};
use crate::storage::{Storage, cases, long_cases};
use serde_json::json;
use server::store::Location;
use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Write};
use std::net::{SocketAddr, TcpStream};
use std::process::{Child, Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

cases!(nothing_acknowledged_is_lost_when_the_server_is_killed);
long_cases!(twenty_kills);

/// Store of the child process.
const STORE: &str = "MENISCUS_TEST_STORE";

/// The child process: a server until it is killed.
#[test]
#[ignore = "a server for the other tests"]
fn child() {
    let store = std::env::var(STORE).expect("the other tests start it");
    let running = Running::start(&Location::read(&store, None).unwrap());
    println!("\nready {} {}", running.address, running.class.code());
    std::thread::sleep(Duration::from_secs(120));
}

#[allow(clippy::zombie_processes, reason = "its callers wait for it; a child without a first line fails the test")]
pub fn start_with(storage: &Storage, environment: &[(&str, &str)]) -> (Child, SocketAddr, String) {
    let mut child = Command::new(std::env::current_exe().unwrap())
        .args(["--ignored", "--exact", "--nocapture", "durable::child"])
        .env(STORE, &storage.address)
        .envs(environment.iter().copied())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    for line in BufReader::new(child.stdout.take().unwrap()).lines() {
        if let Some((address, code)) = line.unwrap().strip_prefix("ready ").and_then(|rest| rest.split_once(' ')) {
            return (child, address.parse().unwrap(), code.to_owned());
        }
    }
    panic!("the child has ended");
}

pub fn start(storage: &Storage) -> (Child, SocketAddr, String) {
    start_with(storage, &[])
}

/// Sends a body; `None` if the server does not answer.
pub fn post(address: SocketAddr, path: &str, token: &str, body: &str) -> Option<Answer> {
    let mut stream = TcpStream::connect_timeout(&address, Duration::from_secs(5)).ok()?;
    let head = format!(
        "POST {path} HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\nAuthorization: Bearer {token}\r\nContent-Length: {}\r\n\r\n{body}",
        body.len()
    );
    stream.write_all(head.as_bytes()).ok()?;
    Some(read(&mut stream)).filter(|answer| answer.status == 200)
}

/// Kills the server `times` times while eight students hand in. Returns the number of acknowledged hand-ins.
fn kills(storage: &Storage, times: usize) -> usize {
    let acknowledged: Mutex<BTreeMap<(u64, u64), String>> = Mutex::default();
    let mut tokens: Vec<(u64, String)> = Vec::new();
    for round in 0..times {
        let (mut child, address, code) = start(storage);
        while tokens.len() < 8 {
            let joined = post(address, "/api/join", "", &json!({ "code": code }).to_string()).unwrap().ok();
            tokens.push((joined["seat"].as_u64().unwrap(), joined["token"].as_str().unwrap().to_owned()));
        }
        let ends = AtomicBool::new(false);
        std::thread::scope(|scope| {
            for (seat, token) in &tokens {
                let (acknowledged, ends) = (&acknowledged, &ends);
                scope.spawn(move || {
                    let mut seq = 1 + 1_000_000 * round as u64;
                    while !ends.load(Ordering::Relaxed) {
                        let typed = format!("{seat} {seq}");
                        let body = json!({ "events": parts(seq, &typed, "wrong") }).to_string();
                        // Each hand-in is sent twice.
                        if [(); 2].into_iter().filter_map(|()| post(address, "/api/events", token, &body)).count() > 0 {
                            acknowledged.lock().unwrap().insert((*seat, seq), typed);
                        }
                        seq += 6;
                    }
                });
            }
            // Some moment in the middle of the work; results do not depend on which.
            std::thread::sleep(Duration::from_millis(150 + 37 * round as u64));
            child.kill().unwrap();
            ends.store(true, Ordering::Relaxed);
        });
        child.wait().unwrap();
    }
    let acknowledged = acknowledged.into_inner().unwrap();
    let running = Running::start(&storage.location);
    let teacher = running.teacher();
    let mut found: BTreeMap<(u64, u64), u32> = BTreeMap::new();
    for (seat, token) in &tokens {
        for event in running.get("/api/mine", token).ok()["events"].as_array().unwrap() {
            *found.entry((*seat, event["seq"].as_u64().unwrap())).or_default() += 1;
        }
        assert_eq!(
            running.post("/api/teacher/hand-in", &teacher, &json!({ "seat": seat, "document": "tube.md" })).status,
            200
        );
    }
    for (seat, seq) in acknowledged.keys() {
        for part in 0..6 {
            assert_eq!(found.get(&(*seat, seq + part)), Some(&1), "seat {seat}, part {seq} + {part}");
        }
    }
    // All parts of a hand-in or none: their numbers come in sixes.
    assert!(found.len().is_multiple_of(6));
    acknowledged.len()
}

fn nothing_acknowledged_is_lost_when_the_server_is_killed(storage: &Storage) {
    assert!(kills(storage, 3) > 0);
}

/// `cargo test --release -p server --test all twenty_kills -- --ignored --nocapture`
fn twenty_kills(storage: &Storage) {
    println!("{} hand-ins acknowledged, none lost, none doubled", kills(storage, 20));
}
