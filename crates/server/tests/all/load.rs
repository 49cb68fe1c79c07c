//! Load, with the client on the same machine: `cargo test --release -p server --test all load:: -- --ignored --nocapture --test-threads 1`
//!
//! Durations are printed and not checked.

use crate::client::{Running, parts};
use crate::storage::{Storage, long_cases};
use serde_json::{Value, json};
use std::net::SocketAddr;
use std::time::{Duration, Instant};
use tokio::io::{AsyncBufReadExt, AsyncReadExt, AsyncWriteExt, BufReader};
use tokio::net::TcpStream;
use tokio::task::JoinSet;

long_cases!(forty_students, two_thousand_at_the_same_instant, hand_ins_a_second, two_thousand_streams);

fn client<T>(work: impl Future<Output = T>) -> T {
    tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap().block_on(work)
}

/// A connection that stays open.
struct Connection(BufReader<TcpStream>);

impl Connection {
    async fn open(address: SocketAddr) -> Self {
        loop {
            if let Ok(stream) = TcpStream::connect(address).await {
                stream.set_nodelay(true).unwrap();
                return Self(BufReader::new(stream));
            }
        }
    }

    async fn post(&mut self, path: &str, token: &str, body: &str) -> (u16, Value) {
        let head = format!(
            "POST {path} HTTP/1.1\r\nHost: localhost\r\nAuthorization: Bearer {token}\r\nContent-Length: {}\r\n\r\n{body}",
            body.len()
        );
        self.0.get_mut().write_all(head.as_bytes()).await.unwrap();
        let (mut length, mut status) = (0, 0);
        loop {
            let mut line = String::new();
            assert!(self.0.read_line(&mut line).await.unwrap() > 0, "the connection was closed");
            if let Some(rest) = line.strip_prefix("HTTP/1.1 ") {
                status = rest[..3].parse().unwrap();
            }
            if let Some(rest) = line.to_lowercase().strip_prefix("content-length: ") {
                length = rest.trim().parse().unwrap();
            }
            if line == "\r\n" {
                break;
            }
        }
        let mut body = vec![0; length];
        self.0.read_exact(&mut body).await.unwrap();
        (status, serde_json::from_slice(&body).unwrap_or_default())
    }
}

async fn students(running: &Running, number: usize) -> Vec<(Connection, String)> {
    let mut all = Vec::new();
    for _ in 0..number {
        let mut connection = Connection::open(running.address).await;
        let body = json!({ "code": running.class.code() }).to_string();
        let (status, joined) = connection.post("/api/join", "", &body).await;
        assert_eq!(status, 200, "{joined}");
        all.push((connection, joined["token"].as_str().unwrap().to_owned()));
    }
    all
}

/// One part of about 600 bytes.
fn one(seq: u64) -> String {
    let value = "x".repeat(500);
    json!({ "events": [{ "seq": seq, "document": "tube.md", "part": "item:q1", "value": value }] }).to_string()
}

fn report(title: &str, mut times: Vec<Duration>, whole: Duration) {
    times.sort();
    let of = |share: f64| times[((times.len() - 1) as f64 * share) as usize].as_secs_f64() * 1e3;
    let memory = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let memory = memory.lines().find(|line| line.starts_with("VmHWM")).unwrap_or_default().to_owned();
    println!(
        "{title}: {} requests, {:.0}/s, p50 {:.1} ms, p99 {:.1} ms, client and server together {memory}",
        times.len(),
        times.len() as f64 / whole.as_secs_f64(),
        of(0.5),
        of(0.99),
    );
}

fn forty_students(storage: &Storage) {
    let running = Running::start(&storage.location);
    client(async {
        let mut set = JoinSet::new();
        let begun = Instant::now();
        for (place, (mut connection, token)) in students(&running, 40).await.into_iter().enumerate() {
            set.spawn(async move {
                let mut times = Vec::new();
                tokio::time::sleep(Duration::from_millis(50 * place as u64)).await;
                for round in 0..10 {
                    let body = json!({ "events": parts(1 + 6 * round, "4.5", "correct") }).to_string();
                    let begun = Instant::now();
                    assert_eq!(connection.post("/api/events", &token, &body).await.0, 200);
                    times.push(begun.elapsed());
                    tokio::time::sleep(Duration::from_secs(2)).await;
                }
                times
            });
        }
        let times = set.join_all().await.concat();
        report("40 students, a hand-in of six parts every 2 s", times, begun.elapsed());
    });
}

fn two_thousand_at_the_same_instant(storage: &Storage) {
    let running = Running::start(&storage.location);
    client(async {
        let mut all = students(&running, 2000).await;
        for round in 1..=5 {
            let begun = Instant::now();
            let mut set = JoinSet::new();
            for (mut connection, token) in all.drain(..) {
                set.spawn(async move {
                    let begun = Instant::now();
                    let (status, _) = connection.post("/api/events", &token, &one(round)).await;
                    (connection, token, status, begun.elapsed())
                });
            }
            let mut times = Vec::new();
            for (connection, token, status, time) in set.join_all().await {
                assert_eq!(status, 200);
                times.push(time);
                all.push((connection, token));
            }
            report(&format!("2,000 students at the same instant, round {round}"), times, begun.elapsed());
        }
    });
}

fn hand_ins_a_second(storage: &Storage) {
    let running = Running::start(&storage.location);
    client(async {
        let mut set = JoinSet::new();
        let all = students(&running, 256).await;
        let begun = Instant::now();
        for (mut connection, token) in all {
            set.spawn(async move {
                let mut times = Vec::new();
                for seq in 1..=100 {
                    let begun = Instant::now();
                    assert_eq!(connection.post("/api/events", &token, &one(seq)).await.0, 200);
                    times.push(begun.elapsed());
                }
                times
            });
        }
        let times = set.join_all().await.concat();
        report("durable parts, 256 connections", times, begun.elapsed());
    });
}

fn two_thousand_streams(storage: &Storage) {
    let running = Running::start(&storage.location);
    let teacher = running.teacher();
    client(async {
        let mut set = JoinSet::new();
        let (told, mut heard) = tokio::sync::mpsc::unbounded_channel();
        for (mut connection, token) in students(&running, 2000).await {
            let told = told.clone();
            let head = format!("GET /api/stream HTTP/1.1\r\nHost: localhost\r\nAuthorization: Bearer {token}\r\n\r\n");
            connection.0.get_mut().write_all(head.as_bytes()).await.unwrap();
            set.spawn(async move {
                let mut messages = 0;
                while messages < 11 {
                    let mut line = String::new();
                    assert!(connection.0.read_line(&mut line).await.unwrap() > 0);
                    if line.starts_with("data: ") {
                        messages += 1;
                        told.send(()).unwrap();
                    }
                }
            });
        }
        let mut connection = Connection::open(running.address).await;
        let mut times = Vec::new();
        let begun = Instant::now();
        for round in 0..=10 {
            let begun = Instant::now();
            if round > 0 {
                let body = json!({ "open": true, "paused": round % 2 == 1 }).to_string();
                assert_eq!(connection.post("/api/teacher/settings", &teacher, &body).await.0, 200);
            }
            for _ in 0..2000 {
                heard.recv().await.unwrap();
                times.push(begun.elapsed());
            }
        }
        report("a change of settings at 2,000 streams, ten times", times, begun.elapsed());
        set.join_all().await;
    });
}
