//! Encrypted connections.

use crate::client::{POLICY, documents, place};
use server::class::Classes;
use server::http::{Place, Server};
use server::pages::Pages;
use server::store::Location;
use server::{Store, listen, now};
use std::path::PathBuf;
use std::sync::Arc;
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::{TcpListener, TcpStream};
use tokio_rustls::TlsConnector;
use tokio_rustls::rustls::crypto::ring;
use tokio_rustls::rustls::pki_types::pem::PemObject;
use tokio_rustls::rustls::pki_types::{CertificateDer, ServerName};
use tokio_rustls::rustls::{ClientConfig, RootCertStore};
use units::Language;

/// A certificate for `localhost` that signs itself, for these tests alone.
fn file(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/all").join(name)
}

#[tokio::test]
async fn connections_are_encrypted_with_a_certificate() {
    let folder = tempfile::tempdir().unwrap();
    let tls = listen::tls(&file("tls-cert.pem"), &file("tls-key.pem")).unwrap();
    let store = Store::open(&Location::File(folder.path().join("class.sqlite"))).await.unwrap();
    let classes = Classes::open(store, Language::English, now()).await.unwrap();
    let pages = Pages::new(documents(), "", POLICY, Language::English);
    let server = Server::new(classes, pages, Place { is_encrypted: true, ..place() }, None);
    let listener = TcpListener::bind("127.0.0.1:0").await.unwrap();
    let address = listener.local_addr().unwrap();
    tokio::spawn(listen::serve(listener, server.routes(), Some(tls)));

    let mut roots = RootCertStore::empty();
    roots.add(CertificateDer::from_pem_file(file("tls-cert.pem")).unwrap()).unwrap();
    let config = ClientConfig::builder_with_provider(Arc::new(ring::default_provider()))
        .with_safe_default_protocol_versions()
        .unwrap()
        .with_root_certificates(roots)
        .with_no_client_auth();
    let stream = TcpStream::connect(address).await.unwrap();
    let name = ServerName::try_from("localhost").unwrap();
    let mut stream = TlsConnector::from(Arc::new(config)).connect(name, stream).await.unwrap();
    stream.write_all(b"GET /stored HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n").await.unwrap();
    let mut answer = Vec::new();
    stream.read_to_end(&mut answer).await.unwrap();
    assert!(String::from_utf8_lossy(&answer).starts_with("HTTP/1.1 200 OK"));

    // Without encryption the same port says nothing.
    let mut plain = TcpStream::connect(address).await.unwrap();
    plain.write_all(b"GET /stored HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n").await.unwrap();
    let mut answer = Vec::new();
    let _ = plain.read_to_end(&mut answer).await;
    assert!(!String::from_utf8_lossy(&answer).contains("200 OK"));
}

#[test]
fn a_key_of_another_file_is_refused() {
    assert!(listen::tls(&file("tls-cert.pem"), &file("tls-cert.pem")).is_err());
    assert!(listen::tls(&file("none.pem"), &file("tls-key.pem")).is_err());
}
