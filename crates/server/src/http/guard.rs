//! Guards before the routes: host names, other origins, the place of the teacher.

use super::answer::refuse;
use super::state::{Peer, Place, Server};
use axum::extract::{Request, State};
use axum::http::{HeaderMap, HeaderValue, Method, StatusCode, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use std::net::{IpAddr, Ipv4Addr};
use std::sync::Arc;

/// Refuses requests that come past the proxy, and those with another host name: another site could point its name to this address (DNS rebinding). A name that is an
/// IP address cannot be pointed elsewhere.
pub async fn host(State(server): State<Arc<Server>>, request: Request, next: Next) -> Response {
    if !server.place.admits(address(&request)) {
        return refuse(StatusCode::FORBIDDEN, "proxy").into_response();
    }
    if !is_known(request.headers(), &server.place) {
        return refuse(StatusCode::FORBIDDEN, "host").into_response();
    }
    let mut response = next.run(request).await;
    let headers = response.headers_mut();
    for (name, value) in [
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (header::REFERRER_POLICY, "no-referrer"),
        (header::X_FRAME_OPTIONS, "SAMEORIGIN"),
    ] {
        headers.insert(name, HeaderValue::from_static(value));
    }
    headers.entry(header::CACHE_CONTROL).or_insert(HeaderValue::from_static("no-store"));
    response
}

fn is_known(headers: &HeaderMap, place: &Place) -> bool {
    let Some(host) = headers.get(header::HOST).and_then(|value| value.to_str().ok()) else { return false };
    let name = match host.strip_prefix('[').and_then(|rest| rest.split_once(']')) {
        Some((name, _)) => name,
        None => host.split(':').next().unwrap_or_default(),
    };
    name.parse::<IpAddr>().is_ok()
        || name.eq_ignore_ascii_case("localhost")
        || place.hosts.iter().any(|known| known.eq_ignore_ascii_case(name))
}

/// Lets pages of every origin use the routes for students: a page opened from disk has the origin `null`. They need a token, and
/// browsers add none by themselves.
pub async fn any_origin(request: Request, next: Next) -> Response {
    let mut response = match *request.method() {
        Method::OPTIONS => StatusCode::NO_CONTENT.into_response(),
        _ => next.run(request).await,
    };
    let headers = response.headers_mut();
    for (name, value) in [
        ("access-control-allow-origin", "*"),
        ("access-control-allow-headers", "authorization, content-type"),
        ("access-control-allow-methods", "GET, POST"),
        ("access-control-allow-private-network", "true"),
        ("access-control-max-age", "600"),
    ] {
        headers.insert(name, HeaderValue::from_static(value));
    }
    response
}

/// The dashboard answers to this computer only, unless connections are encrypted.
pub async fn teacher_place(State(server): State<Arc<Server>>, request: Request, next: Next) -> Response {
    if server.place.is_encrypted || address(&request).is_loopback() {
        next.run(request).await
    } else {
        refuse(StatusCode::FORBIDDEN, "place").into_response()
    }
}

fn address(request: &Request) -> IpAddr {
    // Without an address the request is treated like one from elsewhere.
    request.extensions().get::<Peer>().map_or(IpAddr::V4(Ipv4Addr::UNSPECIFIED), |peer| peer.0.to_canonical())
}

/// Address of a client, also behind a proxy.
pub fn client(headers: &HeaderMap, peer: Peer, place: &Place) -> IpAddr {
    let forwarded = headers.get_all("x-forwarded-for").iter().next_back().and_then(|value| value.to_str().ok());
    let last = forwarded.and_then(|list| list.rsplit(',').next()?.trim().parse().ok());
    last.filter(|_| place.proxy.is_some()).unwrap_or(peer.0).to_canonical()
}
