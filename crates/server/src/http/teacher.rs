//! Routes for the teacher.

use super::answer::{self, Refusal, refuse};
use super::holders::Teacher;
use super::state::Server;
use crate::class::Settings;
use crate::fold::{Folded, sender};
use crate::qr;
use crate::time::now;
use axum::body::Body;
use axum::extract::{Request, State};
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde::Deserialize;
use serde_json::json;
use std::sync::Arc;

/// The dashboard.
pub async fn page(State(server): State<Arc<Server>>, headers: HeaderMap) -> Response {
    server.pages.teacher().respond(&headers)
}

#[derive(Deserialize)]
struct Link {
    link: String,
}

/// Exchanges the one-time link for a token.
pub async fn exchange(State(server): State<Arc<Server>>, request: Request<Body>) -> Result<Response, Refusal> {
    let Link { link } = answer::small(request).await?;
    match server.classes.exchange(&link).await? {
        Some(token) => Ok(answer::json(json!({ "token": token }))),
        None => Err(refuse(StatusCode::FORBIDDEN, "link")),
    }
}

/// The class.
pub async fn class(State(server): State<Arc<Server>>, Teacher(class, _): Teacher) -> Response {
    let (documents, code) = (server.pages.names(), class.code());
    answer::json(json!({
        "title": class.title(), "code": code, "address": server.place.address, "qr": qr::svg(&server.place.join_address(&code)), "expires": class.expires(),
        "documents": documents, "sources": server.pages.sources(), "settings": class.settings(), "now": now(),
    }))
    .into_response()
}

/// Changes the settings.
pub async fn set(
    State(server): State<Arc<Server>>,
    Teacher(class, _): Teacher,
    request: Request<Body>,
) -> Result<Response, Refusal> {
    let settings: Settings = answer::small(request).await?;
    if settings.pace.as_ref().is_some_and(|name| server.pages.document(name).is_none()) {
        return Err(refuse(StatusCode::BAD_REQUEST, "body"));
    }
    server.classes.set(&class, settings, now()).await?;
    Ok(answer::json(json!({ "settings": class.settings(), "now": now() })))
}

#[derive(Deserialize)]
struct OfSeat {
    seat: u32,
}

/// Lets a student in.
pub async fn approve(
    State(server): State<Arc<Server>>,
    Teacher(class, _): Teacher,
    request: Request<Body>,
) -> Result<Response, Refusal> {
    let OfSeat { seat } = answer::small(request).await?;
    server.classes.approve(&class, seat).await?;
    Ok(answer::json(json!({})))
}

/// Erases a seat.
pub async fn erase(
    State(server): State<Arc<Server>>,
    Teacher(class, _): Teacher,
    request: Request<Body>,
) -> Result<Response, Refusal> {
    let OfSeat { seat } = answer::small(request).await?;
    server.classes.erase(&class, seat).await?;
    Ok(answer::json(json!({})))
}

/// Erases the seats that have handed in nothing.
pub async fn erase_unused(State(server): State<Arc<Server>>, Teacher(class, _): Teacher) -> Result<Response, Refusal> {
    server.classes.erase_unused(&class).await?;
    Ok(answer::json(json!({})))
}

/// Gives the class another code.
pub async fn renew_code(State(server): State<Arc<Server>>, Teacher(class, _): Teacher) -> Result<Response, Refusal> {
    server.classes.renew_code(&class).await?;
    Ok(answer::json(json!({})))
}

/// Revokes the tokens of all other devices of the teacher, and the links that nobody has used.
pub async fn revoke(State(server): State<Arc<Server>>, Teacher(class, own): Teacher) -> Result<Response, Refusal> {
    server.classes.revoke_teachers(&class, own).await?;
    Ok(answer::json(json!({})))
}

#[derive(Deserialize)]
struct OfDocument {
    seat: u32,
    document: String,
}

/// The hand-in of a seat for a document, as a file.
pub async fn hand_in(
    State(server): State<Arc<Server>>,
    Teacher(class, _): Teacher,
    request: Request<Body>,
) -> Result<Response, Refusal> {
    let OfDocument { seat, document } = answer::small(request).await?;
    let Some(row) = class.seat(seat) else { return Err(refuse(StatusCode::NOT_FOUND, "missing")) };
    let events = server.classes.store().events_of_seat(class.id().to_owned(), seat).await?;
    let hand_in =
        Folded::of(&events).hand_in(&document, &sender(&row.pseudonym, &document, server.pages.names().len()));
    let Some(hand_in) = hand_in else { return Err(refuse(StatusCode::NOT_FOUND, "missing")) };
    Ok(([(header::CONTENT_TYPE, "application/json")], hand_in).into_response())
}

/// Answers to surveys.
pub async fn sheets(State(server): State<Arc<Server>>, Teacher(class, _): Teacher) -> Result<Response, Refusal> {
    let sheets = server.classes.store().sheets(class.id().to_owned()).await?;
    Ok(answer::json(json!({ "sheets": sheets })))
}
