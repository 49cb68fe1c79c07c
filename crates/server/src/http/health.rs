//! Health of the server, for programs that watch it.

use super::answer::{self, Refusal};
use super::state::Server;
use axum::extract::State;
use axum::response::Response;
use serde_json::json;
use std::sync::Arc;

/// States that the store can be read, and the version of the program.
///
/// # Errors
/// The store cannot be read.
pub async fn health(State(server): State<Arc<Server>>) -> Result<Response, Refusal> {
    server.classes.store().classes().await?;
    Ok(answer::json(json!({ "store": "ok", "version": env!("CARGO_PKG_VERSION") })))
}
