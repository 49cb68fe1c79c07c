//! Routes for students.

use super::answer::{self, LARGEST, Refusal, refuse};
use super::holders::{Origin, Someone, Student};
use super::state::Server;
use crate::class::{Class, NotJoined};
use crate::codes;
use crate::fold::{PART, Part};
use crate::store::NewEvent;
use crate::time::now;
use axum::body::Body;
use axum::extract::{Path, Request, State};
use axum::http::{HeaderMap, StatusCode};
use axum::response::{IntoResponse, Redirect, Response};
use saved::survey::{LONGEST_SHEET, Sheet};
use serde::Deserialize;
use serde_json::value::RawValue;
use serde_json::{Value, json};
use std::sync::Arc;

/// Maximum number of events in one request.
const MOST_EVENTS: usize = 5000;

/// Maximum size of what stands around a sheet in its request, in bytes.
const AROUND: usize = 1 << 10;

/// List of the documents, or the only one. The fragment with the code of a class goes along.
pub async fn index(State(server): State<Arc<Server>>, headers: HeaderMap) -> Response {
    match server.pages.only() {
        Some(address) => Redirect::temporary(&address).into_response(),
        None => server.pages.index().respond(&headers),
    }
}

/// A document.
pub async fn document(State(server): State<Arc<Server>>, Path(name): Path<String>, headers: HeaderMap) -> Response {
    match server.pages.document(&name) {
        Some(page) => page.respond(&headers),
        None => refuse(StatusCode::NOT_FOUND, "missing").into_response(),
    }
}

/// *What is stored*.
pub async fn stored(State(server): State<Arc<Server>>, headers: HeaderMap) -> Response {
    server.pages.stored().respond(&headers)
}

#[derive(Deserialize)]
struct Join {
    code: String,
}

/// Exchanges a code for a token.
pub async fn join(
    State(server): State<Arc<Server>>,
    Origin(network): Origin,
    request: Request<Body>,
) -> Result<Response, Refusal> {
    let Join { code } = answer::small(request).await?;
    let Some(pass) = server.gate.enter(network.0).await else {
        return Err(refuse(StatusCode::TOO_MANY_REQUESTS, "wait"));
    };
    if !server.limits.join(network) {
        return Err(answer::MANY);
    }
    let joined = server.classes.join(&code, now()).await;
    if joined.is_err() {
        server.limits.unjoin(network);
    }
    match joined {
        Ok(joined) => Ok(answer::json(joined)),
        Err(NotJoined::Wrong) => {
            server.gate.count_wrong(network.0);
            let status = if pass.is_limited() { StatusCode::TOO_MANY_REQUESTS } else { StatusCode::NOT_FOUND };
            Err(refuse(status, "code"))
        }
        Err(NotJoined::Closed) => Err(refuse(StatusCode::FORBIDDEN, "closed")),
        Err(NotJoined::Full) => Err(refuse(StatusCode::FORBIDDEN, "full")),
        Err(NotJoined::Store(fault)) => Err(fault.into()),
    }
}

/// State of the class for a student; `None` if the seat was erased. A class is `earlier` if another one was begun after it.
pub fn state_of(server: &Server, class: &Class, seat: u32) -> Option<Value> {
    let (settings, now) = (class.settings(), now());
    let approved = class.seat(seat)?.approved;
    let is_earlier = server.classes.latest().is_some_and(|latest| *latest != *class);
    Some(json!({
        "now": now, "accepts": settings.accepts(now), "approved": approved, "earlier": is_earlier, "settings": settings,
    }))
}

/// State of the class, for pages that cannot have a stream.
pub async fn state(State(server): State<Arc<Server>>, Student(class, seat): Student) -> Response {
    match state_of(&server, &class, seat) {
        Some(state) => answer::json(state),
        None => refuse(StatusCode::UNAUTHORIZED, "token").into_response(),
    }
}

#[derive(Deserialize)]
struct Sent {
    seq: u64,
    document: String,
    part: String,
    value: Box<RawValue>,
}

#[derive(Deserialize)]
struct Batch {
    events: Vec<Sent>,
}

/// Stores parts of hand-ins. The answer is sent when they are on disk.
pub async fn events(
    State(server): State<Arc<Server>>,
    Student(class, seat): Student,
    Origin(network): Origin,
    request: Request<Body>,
) -> Result<Response, Refusal> {
    let at = now();
    if !class.seat(seat).is_some_and(|seat| seat.approved) {
        return Err(refuse(StatusCode::FORBIDDEN, "approval"));
    }
    if !class.settings().accepts(at) {
        return Err(refuse(StatusCode::FORBIDDEN, "closed"));
    }
    let room = server.limits.body(Some((class.id().to_owned(), seat)), network);
    let Batch { events } = answer::large(room, request, LARGEST).await?;
    let events: Option<Vec<NewEvent>> = events.into_iter().map(|event| event.checked(&server)).collect();
    let Some(events) = events.filter(|events| (1..=MOST_EVENTS).contains(&events.len())) else {
        return Err(refuse(StatusCode::BAD_REQUEST, "body"));
    };
    let outcome = server.classes.append(&class, seat, at, events).await?;
    class.tell(outcome.number);
    Ok(answer::json(json!({ "highest": outcome.highest, "now": at })))
}

impl Sent {
    /// The event to store; `None` if it is no part of a hand-in of a document of this server.
    fn checked(self, server: &Server) -> Option<NewEvent> {
        let Self { seq, document, part, value } = self;
        let part = Part { document, part, value };
        let is_known = part.is_known() && server.pages.document(&part.document).is_some();
        let is_numbered = (1..1 << 53).contains(&seq);
        (is_known && is_numbered).then_some(())?;
        Some(NewEvent { seq, kind: PART, body: serde_json::to_string(&part).ok()? })
    }
}

/// Answers of others and their results, as far as the teacher shows them.
pub async fn others(State(server): State<Arc<Server>>, Student(class, seat): Student) -> Result<Response, Refusal> {
    let settings = class.settings();
    if !settings.results && !settings.others {
        return Ok(answer::json(json!({ "questions": [] })));
    }
    let tally = server.tallies.of(&class, server.classes.store(), &server.pages).await?;
    Ok(answer::json(tally.for_student(seat, &settings)))
}

/// Answers of one person to a survey.
#[derive(Deserialize)]
struct Answers {
    /// Random number that the page makes. It is no part of the address, which a proxy may log beside that of the student.
    id: String,
    sheet: Box<RawValue>,
}

/// Stores the answers of one person to a survey, without seat and time: sent again with the same number, they add nothing. They may
/// arrive after the class has been closed, since they are sent at a random later time.
pub async fn survey(
    State(server): State<Arc<Server>>,
    Someone(class): Someone,
    Origin(network): Origin,
    request: Request<Body>,
) -> Result<Response, Refusal> {
    let room = server.limits.body(None, network);
    let Answers { id, sheet } = answer::large(room, request, LONGEST_SHEET + AROUND).await?;
    let sheet = sheet.get().to_owned();
    if Sheet::read(&sheet).is_err() {
        return Err(refuse(StatusCode::BAD_REQUEST, "body"));
    }
    server.classes.add_sheet(&class, codes::identifier(&id), sheet).await?;
    Ok(answer::json(json!({})))
}
