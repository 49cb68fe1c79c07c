//! Streams of events, resumed by number, and polling where a proxy swallows streams.

use super::answer::{self, Refusal};
use super::holders::{Origin, Student, Teacher};
use super::state::Server;
use super::student;
use crate::class::{Class, Classes};
use crate::fold::Part;
use crate::store::{EventRow, Fault};
use crate::time::now;
use axum::body::{Body, Bytes};
use axum::extract::State;
use axum::http::{Uri, header};
use axum::response::{IntoResponse, Response};
use futures_util::stream::{self, Stream};
use serde_json::{Value, json};
use std::convert::Infallible;
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::watch;
use tokio::time::{sleep, timeout};

/// Time after which a silent stream sends a comment, so that a proxy does not end it.
const SILENCE: Duration = Duration::from_secs(15);
/// Pause of a stream after a message: many hand-ins of one moment make one message.
const PAUSE: Duration = Duration::from_millis(200);
/// Number of events in one message.
const PORTION: u32 = 500;
/// Longest wait of a poll, in seconds.
const LONGEST_WAIT: u64 = 25;

/// Number in the query of an address; 0 if there is none.
fn number(address: &Uri, name: &str) -> u64 {
    let mut pairs = address.query().unwrap_or_default().split('&').filter_map(|pair| pair.split_once('='));
    pairs.find_map(|(own, value)| (own == name).then(|| value.parse().ok())?).unwrap_or(0)
}

fn events(messages: impl Stream<Item = Result<Bytes, Infallible>> + Send + 'static) -> Response {
    let headers =
        [(header::CONTENT_TYPE, "text/event-stream"), (header::HeaderName::from_static("x-accel-buffering"), "no")];
    (headers, Body::from_stream(messages)).into_response()
}

fn message(id: Option<u64>, data: &Value) -> Bytes {
    let id = id.map_or_else(String::new, |id| format!("id: {id}\n"));
    format!("{id}data: {data}\n\n").into()
}

/// Waits for a change. Returns false if there will be none.
async fn changed<T>(receiver: &mut watch::Receiver<T>) -> Option<bool> {
    match timeout(SILENCE, receiver.changed()).await {
        Ok(Ok(())) => Some(true),
        Ok(Err(_)) => None,
        Err(_) => Some(false),
    }
}

/// State of the class for a student: at once, and after each change.
///
/// # Errors
/// The seat or its network follows as many streams as it may; the page asks for the state from time to time then.
pub async fn of_student(
    State(server): State<Arc<Server>>,
    Student(class, seat): Student,
    Origin(network): Origin,
) -> Result<Response, Refusal> {
    let place = server.limits.stream((class.id().to_owned(), seat), network).ok_or(answer::MANY)?;
    let mut receiver = class.follow_settings();
    receiver.mark_changed();
    let from = (server, class, receiver, place);
    Ok(events(stream::unfold(from, move |(server, class, mut receiver, place)| async move {
        if !changed(&mut receiver).await? {
            // The seat may have been erased.
            class.seat(seat)?;
            return Some((Ok(Bytes::from_static(b":\n\n")), (server, class, receiver, place)));
        }
        let state = student::state_of(&server, &class, seat)?;
        Some((Ok(message(None, &state)), (server, class, receiver, place)))
    })))
}

/// Events after a number, and the seats.
async fn news(class: &Class, classes: &Classes, since: u64) -> Result<(u64, bool, Value), Fault> {
    let events = classes.store().events(class.id().to_owned(), since, PORTION).await?;
    let is_whole = events.len() < PORTION as usize;
    let last = events.last().map_or(since, |event| event.number);
    let events: Vec<Value> = events.iter().map(line).collect();
    let seats: Vec<Value> = class
        .seats()
        .into_iter()
        .map(|seat| json!({ "seat": seat.seat, "pseudonym": seat.pseudonym, "approved": seat.approved }))
        .collect();
    let (settings, room) = (class.settings(), classes.room(class));
    let news = json!({
        "last": last, "now": now(), "events": events, "seats": seats, "settings": settings, "room": room,
    });
    Ok((last, is_whole, news))
}

/// An event without its content.
fn line(event: &EventRow) -> Value {
    let document = serde_json::from_str::<Part>(&event.body).map(|part| part.document).unwrap_or_default();
    json!({ "number": event.number, "seat": event.seat, "at": event.at, "kind": event.kind, "document": document })
}

/// Events of the class for the teacher.
///
/// # Errors
/// The teachers of the class follow as many streams as they may; the page polls then.
pub async fn of_teacher(
    State(server): State<Arc<Server>>,
    Teacher(class, token): Teacher,
    Origin(network): Origin,
    address: Uri,
) -> Result<Response, Refusal> {
    let place = server.limits.stream((class.id().to_owned(), 0), network).ok_or(answer::MANY)?;
    let since = number(&address, "since");
    let mut receiver = class.follow_events();
    receiver.mark_changed();
    let from = (server, class, receiver, since, place);
    Ok(events(stream::unfold(from, move |(server, class, mut receiver, since, place)| async move {
        let has_changed = changed(&mut receiver).await?;
        // The token may have been revoked.
        server.classes.is_known(&token).then_some(())?;
        if !has_changed {
            return Some((Ok(Bytes::from_static(b":\n\n")), (server, class, receiver, since, place)));
        }
        sleep(PAUSE).await;
        let (last, is_whole, news) = news(&class, &server.classes, since).await.ok()?;
        if !is_whole {
            receiver.mark_changed();
        }
        Some((Ok(message(Some(last), &news)), (server, class, receiver, last, place)))
    })))
}

/// News as one message instead of a stream, after a wait of at most `wait` seconds.
pub async fn poll(
    State(server): State<Arc<Server>>,
    Teacher(class, _): Teacher,
    address: Uri,
) -> Result<Response, Refusal> {
    let (since, wait) = (number(&address, "since"), number(&address, "wait"));
    let mut receiver = class.follow_events();
    let mut found = news(&class, &server.classes, since).await?;
    if found.0 == since && wait > 0 {
        let _ = timeout(Duration::from_secs(wait.min(LONGEST_WAIT)), receiver.changed()).await;
        found = news(&class, &server.classes, since).await?;
    }
    Ok(answer::json(found.2))
}
