//! Log of the requests: one object in JSON a line. It has no answers, names, codes, tokens or network addresses, and no addresses of
//! pages, in which names of documents stand.
//!
//! ```json
//! {"at":1763812800000,"method":"POST","route":"/api/events","status":200,"ms":3}
//! ```

use crate::time::now;
use axum::extract::{MatchedPath, Request, State};
use axum::middleware::Next;
use axum::response::Response;
use serde_json::json;
use std::fmt;
use std::io::Write;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Instant;

/// Place of the lines.
pub struct Log(Mutex<Box<dyn Write + Send>>);

impl Log {
    /// A log that is written to this file.
    pub fn new(file: impl Write + Send + 'static) -> Self {
        Self(Mutex::new(Box::new(file)))
    }

    fn line(&self, line: &str) {
        let mut file = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        // A class goes on without its log, as when the disk is full.
        let _ = file.write_all(line.as_bytes()).and_then(|()| file.flush());
    }
}

impl fmt::Debug for Log {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("Log")
    }
}

/// Writes a line about a request once its answer begins. `route` is the pattern of the address, `null` for an address without a route.
pub async fn request(State(log): State<Option<Arc<Log>>>, request: Request, next: Next) -> Response {
    let Some(log) = log else { return next.run(request).await };
    let route = request.extensions().get::<MatchedPath>().map(|route| route.as_str().to_owned());
    let (method, at, began) = (request.method().clone(), now(), Instant::now());
    let response = next.run(request).await;
    let ms = u64::try_from(began.elapsed().as_millis()).unwrap_or(u64::MAX);
    // A method may be any word.
    let method = if ["GET", "POST", "HEAD", "OPTIONS"].contains(&method.as_str()) { method.as_str() } else { "other" };
    let line = json!({ "at": at, "method": method, "route": route, "status": response.status().as_u16(), "ms": ms });
    log.line(&format!("{line}\n"));
    response
}
