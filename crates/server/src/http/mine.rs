//! Own data of a student: download, erase, and the page as a file.

use super::answer::{self, Refusal, refuse};
use super::holders::Student;
use super::state::Server;
use crate::fold::Folded;
use axum::extract::{Path, State};
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde_json::json;
use std::sync::Arc;

/// Everything that is stored of a student: events, and the hand-ins that follow from them.
pub async fn download(State(server): State<Arc<Server>>, Student(class, seat): Student) -> Result<Response, Refusal> {
    let Some(row) = class.seat(seat) else { return Err(refuse(StatusCode::UNAUTHORIZED, "token")) };
    let events = server.classes.store().events_of_seat(class.id().to_owned(), seat).await?;
    let folded = Folded::of(&events);
    let hand_ins: Vec<_> = folded.documents().filter_map(|name| folded.hand_in(name, &row.pseudonym)).collect();
    let events: Vec<_> = events
        .iter()
        .map(|event| json!({ "seq": event.seq, "at": event.at, "kind": event.kind, "body": event.body }))
        .collect();
    let all = json!({ "pseudonym": row.pseudonym, "seat": seat, "events": events, "hand-ins": hand_ins });
    Ok(answer::json(all))
}

/// The hand-in of the student's seat for a document, as all its devices have made it.
pub async fn hand_in(
    State(server): State<Arc<Server>>,
    Student(class, seat): Student,
    Path(document): Path<String>,
) -> Result<Response, Refusal> {
    let Some(row) = class.seat(seat) else { return Err(refuse(StatusCode::UNAUTHORIZED, "token")) };
    let events = server.classes.store().events_of_seat(class.id().to_owned(), seat).await?;
    match Folded::of(&events).hand_in(&document, &row.pseudonym) {
        Some(hand_in) => Ok(([(header::CONTENT_TYPE, "application/json")], hand_in).into_response()),
        None => Err(refuse(StatusCode::NOT_FOUND, "missing")),
    }
}

/// Erases a student's seat.
pub async fn erase(State(server): State<Arc<Server>>, Student(class, seat): Student) -> Result<Response, Refusal> {
    server.classes.erase(&class, seat).await?;
    Ok(answer::json(json!({})))
}

/// The file for this class.
pub async fn file(
    State(server): State<Arc<Server>>,
    Student(class, _): Student,
    Path(name): Path<String>,
) -> Result<Response, Refusal> {
    let page = server.pages.file(&name, &server.place.address, &class.code());
    let Some(page) = page else { return Err(refuse(StatusCode::NOT_FOUND, "missing")) };
    Ok(([(header::CONTENT_TYPE, "text/html; charset=utf-8")], page).into_response())
}
