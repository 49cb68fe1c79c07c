//! Connections: plain and TLS, each with limits.

use crate::http::Peer;
use axum::Router;
use hyper::Request;
use hyper::body::Incoming;
use hyper::server::conn::http1;
use hyper::service::{Service as _, service_fn};
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};
use std::io;
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;
use tokio::io::{AsyncRead, AsyncWrite};
use tokio::net::TcpListener;
use tokio::sync::Semaphore;
use tokio::time::{sleep, timeout};
pub use tokio_rustls::TlsAcceptor as Tls;
use tokio_rustls::rustls::ServerConfig;
use tokio_rustls::rustls::crypto::ring;
use tokio_rustls::rustls::pki_types::pem::PemObject;
use tokio_rustls::rustls::pki_types::{CertificateDer, PrivateKeyDer};

/// Maximum time for the head of a request, also of the next one of an open connection.
const HEAD: Duration = Duration::from_secs(20);
/// Maximum time of a connection: a client that does not read gives its place back. Pages go on with another one by themselves.
const LONGEST: Duration = Duration::from_secs(15 * 60);
/// Maximum time for a TLS handshake.
const HANDSHAKE: Duration = Duration::from_secs(10);
/// Pause after a connection could not be accepted.
const PAUSE: Duration = Duration::from_millis(50);
/// Maximum number of connections. Each needs a file descriptor; `SPARE` are left for the store.
const CONNECTIONS: u64 = 8192;
const SPARE: u64 = 64;

/// Serves until the future is dropped.
pub async fn serve(listener: TcpListener, routes: Router, tls: Option<Tls>) {
    let places = Arc::new(Semaphore::new(descriptors()));
    loop {
        let Ok(place) = places.clone().acquire_owned().await else { return };
        let Ok((stream, peer)) = listener.accept().await else {
            sleep(PAUSE).await;
            continue;
        };
        // Answers are small and waited for.
        let _ = stream.set_nodelay(true);
        let (routes, tls, peer) = (routes.clone(), tls.clone(), Peer(peer.ip()));
        tokio::spawn(async move {
            match tls {
                None => one(stream, routes, peer).await,
                Some(tls) => {
                    if let Ok(Ok(stream)) = timeout(HANDSHAKE, tls.accept(stream)).await {
                        one(stream, routes, peer).await;
                    }
                }
            }
            drop(place);
        });
    }
}

async fn one(stream: impl AsyncRead + AsyncWrite + Unpin + Send + 'static, routes: Router, peer: Peer) {
    // The routes are shared: a layer with the address would be a copy of them for each connection.
    let routes = TowerToHyperService::new(routes);
    let service = service_fn(|mut request: Request<Incoming>| {
        request.extensions_mut().insert(peer);
        routes.call(request)
    });
    let connection = http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(HEAD)
        .serve_connection(TokioIo::new(stream), service);
    // A failure of one connection does not affect the others.
    let _ = timeout(LONGEST, connection).await;
}

/// Number of connections for which there are file descriptors, after the limit was raised.
fn descriptors() -> usize {
    let Rlimit { current, maximum } = getrlimit(Resource::Nofile);
    let wanted = maximum.unwrap_or(CONNECTIONS + SPARE).min(CONNECTIONS + SPARE);
    let raised = setrlimit(Resource::Nofile, Rlimit { current: Some(wanted), maximum }).is_ok();
    let allowed = if raised { wanted } else { current.unwrap_or(wanted) };
    usize::try_from(allowed.saturating_sub(SPARE).clamp(1, CONNECTIONS)).unwrap_or(1)
}

/// TLS with a certificate chain and a key in PEM.
///
/// # Errors
/// A file cannot be read, or the key does not belong to the certificate.
pub fn tls(certificate: &Path, key: &Path) -> io::Result<Tls> {
    let chain: Result<Vec<CertificateDer<'static>>, _> =
        CertificateDer::pem_file_iter(certificate).map_err(io::Error::other)?.collect();
    let key = PrivateKeyDer::from_pem_file(key).map_err(io::Error::other)?;
    let config = ServerConfig::builder_with_provider(Arc::new(ring::default_provider()))
        .with_safe_default_protocol_versions()
        .map_err(io::Error::other)?
        .with_no_client_auth()
        .with_single_cert(chain.map_err(io::Error::other)?, key)
        .map_err(io::Error::other)?;
    Ok(Tls::from(Arc::new(config)))
}
