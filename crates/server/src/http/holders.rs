//! Holders of tokens, as arguments of routes.

use super::answer::{Refusal, refuse};
use super::guard;
use super::limits::Network;
use super::state::{Peer, Server};
use crate::class::{Class, Holder};
use crate::codes::{self, Hash};
use axum::extract::FromRequestParts;
use axum::http::request::Parts;
use axum::http::{StatusCode, header};
use std::sync::Arc;

/// The teacher of a class, with the hash of the token.
pub struct Teacher(pub Arc<Class>, pub Hash);

/// A student whom the teacher has let in or not.
pub struct Student(pub Arc<Class>, pub u32);

/// Any student of a class, without a seat.
pub struct Someone(pub Arc<Class>);

/// The network from which a request comes.
pub struct Origin(pub Network);

fn token(parts: &Parts) -> Option<&str> {
    parts.headers.get(header::AUTHORIZATION).and_then(|value| value.to_str().ok()?.strip_prefix("Bearer "))
}

async fn holder(parts: &Parts, server: &Server) -> Result<Holder, Refusal> {
    let token = token(parts);
    let holder = match token {
        Some(token) => server.classes.holder(token).await?,
        None => None,
    };
    holder.ok_or_else(|| refuse(StatusCode::UNAUTHORIZED, "token"))
}

fn other() -> Refusal {
    refuse(StatusCode::FORBIDDEN, "token")
}

impl FromRequestParts<Arc<Server>> for Teacher {
    type Rejection = Refusal;

    async fn from_request_parts(parts: &mut Parts, server: &Arc<Server>) -> Result<Self, Refusal> {
        match holder(parts, server).await? {
            Holder::Teacher(class) => Ok(Self(class, codes::hash(token(parts).unwrap_or_default()))),
            _ => Err(other()),
        }
    }
}

impl FromRequestParts<Arc<Server>> for Student {
    type Rejection = Refusal;

    async fn from_request_parts(parts: &mut Parts, server: &Arc<Server>) -> Result<Self, Refusal> {
        match holder(parts, server).await? {
            Holder::Student(class, seat) => Ok(Self(class, seat)),
            _ => Err(other()),
        }
    }
}

impl FromRequestParts<Arc<Server>> for Someone {
    type Rejection = Refusal;

    async fn from_request_parts(parts: &mut Parts, server: &Arc<Server>) -> Result<Self, Refusal> {
        match holder(parts, server).await? {
            Holder::Survey(class) => Ok(Self(class)),
            _ => Err(other()),
        }
    }
}

impl FromRequestParts<Arc<Server>> for Origin {
    type Rejection = Refusal;

    async fn from_request_parts(parts: &mut Parts, server: &Arc<Server>) -> Result<Self, Refusal> {
        let Some(peer) = parts.extensions.get::<Peer>() else { return Err(refuse(StatusCode::FORBIDDEN, "place")) };
        Ok(Self(guard::client(&parts.headers, *peer, &server.place).into()))
    }
}
