//! Answers as JSON, and bodies of bounded size and time.

use super::limits::BodyRoom;
use crate::store::Fault;
use axum::body::{Body, to_bytes};
use axum::extract::Request;
use axum::http::{HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use futures_util::StreamExt as _;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::json;
use std::time::Duration;
use tokio::time::timeout;

/// Maximum size of a body, in bytes.
pub const LARGEST: usize = 8 << 20;
/// Maximum size of a small body, in bytes.
const SMALL: usize = 1 << 12;

/// Maximum time in which a body must arrive.
const ARRIVES: Duration = Duration::from_secs(60);
/// Maximum time between two parts of a large body.
const SILENCE: Duration = Duration::from_secs(20);

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
pub const fn refuse(status: StatusCode, why: &'static str) -> Refusal {
    Refusal { status, why, highest: None }
}

const BODY: Refusal = refuse(StatusCode::BAD_REQUEST, "body");
const SLOW: Refusal = refuse(StatusCode::REQUEST_TIMEOUT, "slow");
const BUSY: Refusal = refuse(StatusCode::SERVICE_UNAVAILABLE, "busy");
/// The client has as many requests at the same time as it may.
pub const MANY: Refusal = refuse(StatusCode::TOO_MANY_REQUESTS, "many");

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
            Fault::SeatFull => refuse(StatusCode::PAYLOAD_TOO_LARGE, "seat_full"),
            Fault::ClassFull => refuse(StatusCode::INSUFFICIENT_STORAGE, "class_full"),
            Fault::SheetsFull => refuse(StatusCode::PAYLOAD_TOO_LARGE, "full"),
            Fault::Missing => refuse(StatusCode::NOT_FOUND, "missing"),
            Fault::Away(_) => refuse(StatusCode::SERVICE_UNAVAILABLE, "store"),
            Fault::Unwritable(_) | Fault::NoStore(_) => refuse(StatusCode::INSUFFICIENT_STORAGE, "store"),
            // Faults of the command line.
            Fault::NoFile | Fault::Exists | Fault::Address => refuse(StatusCode::INTERNAL_SERVER_ERROR, "store"),
            Fault::Ending => refuse(StatusCode::SERVICE_UNAVAILABLE, "ending"),
        }
    }
}

/// Reads a small body of JSON, which needs no room of others.
///
/// # Errors
/// Its length is not stated or is above [`SMALL`], it arrives too slowly, or it is no such JSON.
pub async fn small<T: DeserializeOwned>(request: Request<Body>) -> Result<T, Refusal> {
    is_bounded(&request, SMALL)?;
    let read = to_bytes(request.into_body(), SMALL);
    let bytes = timeout(ARRIVES, read).await.map_err(|_| SLOW)?.map_err(|_| BODY)?;
    serde_json::from_slice(&bytes).map_err(|_| BODY)
}

/// Reads a large body of JSON. It takes room as its bytes arrive, and gives it back at the end. `room`: `None` if its sender has
/// no more.
///
/// # Errors
/// Its length is not stated or is above `most`, there is no room, it arrives too slowly, or it is no such JSON.
pub async fn large<T: DeserializeOwned>(
    room: Option<BodyRoom>,
    request: Request<Body>,
    most: usize,
) -> Result<T, Refusal> {
    is_bounded(&request, most)?;
    let mut room = room.ok_or(MANY)?;
    let read = async {
        let mut chunks = request.into_body().into_data_stream();
        let mut bytes = Vec::new();
        while let Some(chunk) = timeout(SILENCE, chunks.next()).await.map_err(|_| SLOW)? {
            let chunk = chunk.map_err(|_| BODY)?;
            room.grow(bytes.len() + chunk.len()).await.ok_or(BUSY)?;
            bytes.extend_from_slice(&chunk);
        }
        serde_json::from_slice(&bytes).map_err(|_| BODY)
    };
    timeout(ARRIVES, read).await.unwrap_or(Err(SLOW))
}

/// The length of a body is stated, and no more than that arrives.
fn is_bounded(request: &Request<Body>, most: usize) -> Result<(), Refusal> {
    let stated: Option<usize> =
        request.headers().get(header::CONTENT_LENGTH).and_then(|value| value.to_str().ok()?.parse().ok());
    match stated {
        None => Err(refuse(StatusCode::LENGTH_REQUIRED, "length")),
        Some(length) if length > most => Err(refuse(StatusCode::PAYLOAD_TOO_LARGE, "large")),
        Some(_) => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::http::limits::{Limits, Network};
    use futures_util::stream;
    use serde_json::Value;
    use std::convert::Infallible;
    use std::net::Ipv4Addr;

    /// A body of a stated length of which nothing arrives, and one that is longer than it may be.
    #[tokio::test(start_paused = true)]
    async fn a_body_that_is_late_and_one_that_is_too_large_have_reasons_of_their_own() {
        let limits = Limits::default();
        let request = |length: usize| {
            let silent = stream::pending::<Result<Vec<u8>, Infallible>>();
            let builder = Request::builder().header(header::CONTENT_LENGTH, length);
            builder.body(Body::from_stream(silent)).unwrap()
        };
        for (length, status, why) in [(9, 408, "slow"), (LARGEST + 1, 413, "large")] {
            let room = limits.body(None, Network(Ipv4Addr::LOCALHOST.into()));
            let refusal = large::<Value>(room, request(length), LARGEST).await.unwrap_err();
            assert_eq!((refusal.status.as_u16(), refusal.why), (status, why));
        }
    }
}
