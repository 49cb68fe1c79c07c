//! Answers as JSON, and bodies of bounded size and time.

use super::state::Server;
use crate::store::Fault;
use axum::body::{Body, to_bytes};
use axum::extract::Request;
use axum::http::{HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::json;
use std::time::Duration;
use tokio::time::timeout;

/// Maximum size of a body, in bytes.
pub const LARGEST: usize = 8 << 20;

/// Maximum time in which a body must arrive.
const ARRIVES: Duration = Duration::from_secs(60);

/// Time after which a request to a store that does not answer is sent again, in seconds.
const RETRY_AFTER: HeaderValue = HeaderValue::from_static("2");

/// A value as JSON.
pub fn json(value: impl Serialize) -> Response {
    let body = serde_json::to_vec(&value).unwrap_or_default();
    ([(header::CONTENT_TYPE, "application/json")], body).into_response()
}

/// A refusal. Pages have a sentence for each reason in every language.
#[derive(Clone, Copy, Debug)]
pub struct Refusal {
    status: StatusCode,
    why: &'static str,
    /// Highest number of a seat, for [`Fault::Taken`].
    highest: Option<u64>,
}

/// A refusal with a reason for the page.
pub fn refuse(status: StatusCode, why: &'static str) -> Refusal {
    Refusal { status, why, highest: None }
}

impl IntoResponse for Refusal {
    fn into_response(self) -> Response {
        let mut response = (self.status, json(json!({ "why": self.why, "highest": self.highest }))).into_response();
        if self.status == StatusCode::SERVICE_UNAVAILABLE {
            response.headers_mut().insert(header::RETRY_AFTER, RETRY_AFTER);
        }
        response
    }
}

impl From<Fault> for Refusal {
    fn from(fault: Fault) -> Self {
        match fault {
            Fault::Taken(highest) => Self { highest: Some(highest), ..refuse(StatusCode::CONFLICT, "taken") },
            Fault::SeatFull | Fault::SheetsFull => refuse(StatusCode::PAYLOAD_TOO_LARGE, "full"),
            Fault::Missing => refuse(StatusCode::NOT_FOUND, "missing"),
            Fault::Away(_) => refuse(StatusCode::SERVICE_UNAVAILABLE, "store"),
            Fault::Unwritable(_) | Fault::NoStore(_) => refuse(StatusCode::INSUFFICIENT_STORAGE, "store"),
            // Faults of the command line.
            Fault::NoFile | Fault::Exists | Fault::Address => refuse(StatusCode::INTERNAL_SERVER_ERROR, "store"),
            Fault::Ending => refuse(StatusCode::SERVICE_UNAVAILABLE, "ending"),
        }
    }
}

/// Reads a body of JSON.
///
/// # Errors
/// Its length is not stated or is above `most`, it arrives too slowly, or it is no such JSON.
pub async fn body<T: DeserializeOwned>(server: &Server, request: Request<Body>, most: usize) -> Result<T, Refusal> {
    let stated: Option<usize> =
        request.headers().get(header::CONTENT_LENGTH).and_then(|value| value.to_str().ok()?.parse().ok());
    let Some(length) = stated else { return Err(refuse(StatusCode::LENGTH_REQUIRED, "length")) };
    if length > most {
        return Err(refuse(StatusCode::PAYLOAD_TOO_LARGE, "large"));
    }
    let share = u32::try_from(length / 1024 + 1).unwrap_or(u32::MAX);
    let read = async {
        let permit = server.bodies.acquire_many(share).await.ok()?;
        let bytes = to_bytes(request.into_body(), most).await.ok()?;
        let value = serde_json::from_slice(&bytes);
        drop(permit);
        Some(value)
    };
    match timeout(ARRIVES, read).await {
        Ok(Some(Ok(value))) => Ok(value),
        Ok(Some(Err(_))) => Err(refuse(StatusCode::BAD_REQUEST, "body")),
        Ok(None) => Err(refuse(StatusCode::BAD_REQUEST, "body")),
        Err(_) => Err(refuse(StatusCode::REQUEST_TIMEOUT, "slow")),
    }
}
