//! Streams of events.

use crate::client::{Running, parts};
use crate::storage::{Storage, cases};
use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Write};
use std::net::TcpStream;
use std::time::Duration;

cases!(
    a_stream_of_the_teacher_goes_on_where_it_ended,
    a_seat_has_three_streams_at_the_same_time,
    a_stream_of_a_student_follows_the_settings_and_ends_with_the_seat,
);

pub struct Stream(BufReader<TcpStream>);

impl Stream {
    pub fn open(running: &Running, path: &str, token: &str) -> (Self, String) {
        let mut stream = TcpStream::connect(running.address).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        write!(
            stream,
            "GET {path} HTTP/1.1\r\nConnection: close\r\nHost: localhost\r\nAuthorization: Bearer {token}\r\n\r\n"
        )
        .unwrap();
        let mut stream = Self(BufReader::new(stream));
        let mut head = String::new();
        while !head.ends_with("\r\n\r\n") {
            assert!(stream.0.read_line(&mut head).unwrap() > 0, "{head}");
        }
        (stream, head.to_lowercase())
    }

    /// The next message; `None` at the end. Fails if none comes for half a minute.
    pub fn next(&mut self) -> Option<Value> {
        let mut comments = 0;
        loop {
            let mut line = String::new();
            if self.0.read_line(&mut line).unwrap() == 0 {
                return None;
            }
            if let Some(data) = line.strip_prefix("data: ") {
                return Some(serde_json::from_str(data).unwrap());
            }
            comments += u32::from(line.starts_with(':'));
            assert!(comments < 3, "the stream is silent");
        }
    }
}

fn a_stream_of_the_teacher_goes_on_where_it_ended(storage: &Storage) {
    let running = Running::start(&storage.location);
    let (joined, teacher) = (running.join(), running.teacher());
    let send = |seq| {
        running
            .post("/api/events", joined["token"].as_str().unwrap(), &json!({ "events": parts(seq, "1", "wrong") }))
            .ok()
    };
    let (mut stream, head) = Stream::open(&running, "/api/teacher/stream?since=0", &teacher);
    assert!(head.contains("x-accel-buffering: no") && head.contains("text/event-stream"), "{head}");
    assert_eq!(stream.next().unwrap()["events"], json!([]));
    send(1);
    let news = stream.next().unwrap();
    assert_eq!(news["last"], 6);
    drop(stream);
    send(7);
    let (mut stream, _) = Stream::open(&running, "/api/teacher/stream?since=6", &teacher);
    let events = stream.next().unwrap()["events"].clone();
    let numbers: Vec<u64> = events.as_array().unwrap().iter().map(|event| event["number"].as_u64().unwrap()).collect();
    assert_eq!(numbers, [7, 8, 9, 10, 11, 12]);
}

fn a_seat_has_three_streams_at_the_same_time(storage: &Storage) {
    let running = Running::start(&storage.location);
    let [one, other] = [(); 2].map(|()| running.join()["token"].as_str().unwrap().to_owned());
    let open = |token: &str| Stream::open(&running, "/api/stream", token).0;
    let mut held: Vec<Stream> = (0..3).map(|_| open(&one)).collect();
    assert_eq!(running.get("/api/stream", &one).why(), (429, "many".to_owned()));
    // The page asks for the state instead, and other seats have streams of their own.
    running.get("/api/state", &one).ok();
    assert!(open(&other).next().is_some());
    // A stream that ends gives its place back, as soon as the server notices.
    held.pop();
    let opens = || Stream::open(&running, "/api/stream", &one).1.starts_with("http/1.1 200");
    assert!((0..1000).any(|_| {
        std::thread::sleep(Duration::from_millis(10));
        opens()
    }));
}

fn a_stream_of_a_student_follows_the_settings_and_ends_with_the_seat(storage: &Storage) {
    let running = Running::start(&storage.location);
    let (joined, teacher) = (running.join(), running.teacher());
    let (mut stream, _) = Stream::open(&running, "/api/stream", joined["token"].as_str().unwrap());
    assert_eq!(stream.next().unwrap()["settings"]["paused"], false);
    running.post("/api/teacher/settings", &teacher, &json!({ "open": true, "paused": true })).ok();
    assert_eq!(stream.next().unwrap()["settings"]["paused"], true);
    running.post("/api/teacher/erase", &teacher, &json!({ "seat": 1 })).ok();
    running.post("/api/teacher/settings", &teacher, &json!({ "open": true })).ok();
    assert!(stream.next().is_none());
}
