//! A server in this process, and a small HTTP client.

use serde_json::{Value, json};
use server::class::{Class, Classes, MOST_OF_CLASS};
use server::http::{Log, Place, Server};
use server::pages::{Document, Given, Grader, Pages, Source};
use server::store::Location;
use server::{Store, listen, now};
use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::sync::{Arc, Mutex};
use std::time::Duration;
use tokio::runtime::Runtime;
use units::Language;

pub const POLICY: &str = "default-src 'none'";

pub struct Running {
    pub address: SocketAddr,
    pub server: Arc<Server>,
    pub class: Arc<Class>,
    /// Log of the server.
    pub log: Lines,
    /// Runs until the server is dropped.
    _runtime: Runtime,
}

pub fn place() -> Place {
    Place {
        address: "http://192.0.2.1:4242".to_owned(),
        hosts: vec!["class.example".to_owned()],
        is_encrypted: false,
        proxy: None,
    }
}

pub fn documents() -> Vec<Document> {
    let one = |name: &str| Document {
        name: name.to_owned(),
        title: name.to_owned(),
        has_seats: false,
        html: format!("<html><head><meta content=\"{POLICY}\"></head><body>{name}</body></html>"),
        sources: vec![Source { name: name.to_owned(), text: format!("# {name}") }],
        grader: Grader::new(|_, question, item| {
            let item: Value = serde_json::from_str(item).ok()?;
            let typed = item.pointer("/item/answer/typed")?.as_str()?.to_owned();
            (question == "q1").then(|| Given { is_right: typed == "4.5", typed })
        }),
    };
    vec![one("tube.md"), one("a b.md")]
}

/// Lines of a log.
#[derive(Clone, Debug, Default)]
pub struct Lines(Arc<Mutex<Vec<u8>>>);

impl Write for Lines {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.0.lock().unwrap().write(bytes)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

impl Lines {
    pub fn text(&self) -> String {
        String::from_utf8(self.0.lock().unwrap().clone()).unwrap()
    }
}

impl Running {
    pub fn start(store: &Location) -> Self {
        Self::start_at(store, place(), "127.0.0.1:0")
    }

    pub fn start_at(store: &Location, place: Place, address: &str) -> Self {
        Self::start_with(store, place, address, MOST_OF_CLASS)
    }

    /// `room`: most that each class stores, in bytes.
    pub fn start_with(store: &Location, place: Place, address: &str, room: u64) -> Self {
        let runtime = tokio::runtime::Builder::new_multi_thread().worker_threads(1).enable_all().build().unwrap();
        let log = Lines::default();
        let (server, class, address) = runtime.block_on(async {
            let store = Store::open(store).await.unwrap();
            let classes = Classes::open(store, Language::English, now()).await.unwrap().with_room(room);
            let class = classes.latest_or_begin("Tubes", 30, now()).await.unwrap();
            let pages = Pages::new(documents(), &documents()[0].html, POLICY, Language::English);
            let server = Server::new(classes, pages, place, Some(Log::new(log.clone())));
            let listener = tokio::net::TcpListener::bind(address).await.unwrap();
            let address = listener.local_addr().unwrap();
            tokio::spawn(listen::serve(listener, server.routes(), None));
            let follower = server.clone();
            tokio::spawn(async move { follower.classes().follow().await });
            (server, class, address)
        });
        Self { address, server, class, log, _runtime: runtime }
    }

    pub fn get(&self, path: &str, token: &str) -> Answer {
        self.send("GET", path, token, "")
    }

    pub fn post(&self, path: &str, token: &str, body: &Value) -> Answer {
        self.send("POST", path, token, &body.to_string())
    }

    pub fn send(&self, method: &str, path: &str, token: &str, body: &str) -> Answer {
        send(self.address, method, path, &[("Host", "127.0.0.1"), ("Authorization", &format!("Bearer {token}"))], body)
    }

    /// The hand-in of a seat for `tube.md`, as the teacher gets it.
    pub fn hand_in(&self, seat: u32, teacher: &str) -> Answer {
        self.post("/api/teacher/hand-in", teacher, &json!({ "seat": seat, "document": "tube.md" }))
    }

    /// Sends answers to a survey under this number.
    pub fn survey(&self, token: &str, id: &str, sheet: &Value) -> Answer {
        self.post("/api/survey", token, &json!({ "id": id, "sheet": sheet }))
    }

    /// Token of a new student.
    pub fn join(&self) -> Value {
        self.post("/api/join", "", &json!({ "code": self.class.code() })).ok()
    }

    /// A one-time link of the teacher.
    pub fn link(&self) -> String {
        block(self.server.classes().link(&self.class)).unwrap()
    }

    /// Token of the teacher.
    pub fn teacher(&self) -> String {
        let link = self.link();
        let token = self.post("/api/teacher/exchange", "", &json!({ "link": link })).ok();
        token["token"].as_str().unwrap().to_owned()
    }
}

/// An answer.
#[derive(Debug)]
pub struct Answer {
    pub status: u16,
    pub head: String,
    pub body: String,
}

impl Answer {
    pub fn ok(&self) -> Value {
        assert_eq!(self.status, 200, "{}", self.body);
        serde_json::from_str(&self.body).unwrap()
    }

    pub fn why(&self) -> (u16, String) {
        let body: Value = serde_json::from_str(&self.body).unwrap_or_default();
        (self.status, body["why"].as_str().unwrap_or_default().to_owned())
    }
}

/// Sends a request over a connection of its own.
pub fn send(address: SocketAddr, method: &str, path: &str, headers: &[(&str, &str)], body: &str) -> Answer {
    let mut stream = TcpStream::connect(address).unwrap();
    let text = request(method, path, headers, body);
    stream.write_all(text.as_bytes()).unwrap();
    read(&mut stream)
}

fn request(method: &str, path: &str, headers: &[(&str, &str)], body: &str) -> String {
    let headers: String = headers.iter().map(|(name, value)| format!("{name}: {value}\r\n")).collect();
    format!("{method} {path} HTTP/1.1\r\nConnection: close\r\nContent-Length: {}\r\n{headers}\r\n{body}", body.len())
}

/// Reads an answer to its end.
pub fn read(stream: &mut TcpStream) -> Answer {
    stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
    let mut bytes = Vec::new();
    // The server closes a connection whose body it does not read.
    let _ = stream.read_to_end(&mut bytes);
    let text = String::from_utf8_lossy(&bytes).into_owned();
    let (head, body) = text.split_once("\r\n\r\n").unwrap_or_default();
    let status = head.split(' ').nth(1).and_then(|status| status.parse().ok()).unwrap_or(0);
    Answer { status, head: head.to_lowercase(), body: body.to_owned() }
}

/// Parts of a hand-in with this answer, numbered from `seq`.
pub fn parts(seq: u64, typed: &str, grade: &str) -> Vec<Value> {
    let item = json!({ "name": "q1", "item": { "meniscus": 3, "since": 5, "item": { "answer": {
        "typed": typed, "grade": grade, "revealed": false, "found": false,
        "attempts": [{ "typed": typed, "grade": grade }] } } } });
    let parts = [
        ("documents", json!([{ "name": "tube.md", "text": "# Tube\n\"ñ\u{2028}" }])),
        ("state", json!("")),
        ("item:q1", item),
        ("order", json!(["q1"])),
        ("facts", json!([{ "part": "run", "item": "Tube", "quantity": "t", "number": 0.1 + 0.2 }])),
        ("head", json!({ "program": "0.1.0", "made": 5, "sender": { "name": "me" } })),
    ];
    let part = |((part, value), seq)| json!({ "seq": seq, "document": "tube.md", "part": part, "value": value });
    parts.into_iter().zip(seq..).map(part).collect()
}

pub fn block<T>(work: impl Future<Output = T>) -> T {
    tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap().block_on(work)
}
