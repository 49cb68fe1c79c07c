//! `meniscus serve`: the laboratory at 127.0.0.1, accessible from this computer only.

use crate::arguments::Serve;
use crate::failure::Failure;
use crate::load;
use crate::page;
use crate::terminal::Terminal;
use axum::Router;
use axum::extract::{Request, State};
use axum::http::{HeaderMap, StatusCode, header};
use axum::middleware::{self, Next};
use axum::response::{IntoResponse, Response};
use axum::routing::get;
use document::page::{POLICY, write_list};
use hyper::server::conn::http1;
use hyper_util::rt::TokioIo;
use hyper_util::service::TowerToHyperService;
use runner::Loaded;
use std::io;
use std::net::{Ipv4Addr, TcpListener};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::Semaphore;
use tokio::time::{sleep, timeout};

/// Maximum duration of a connection. The page is a single response over the loopback device; a longer connection waits
/// for a request that does not come.
const CONNECTION: Duration = Duration::from_secs(10);
/// Maximum number of simultaneous connections.
const CONNECTIONS: usize = 64;
/// Pause after a connection could not be accepted, for example for lack of file descriptors.
const PAUSE: Duration = Duration::from_millis(200);

/// Default port. `TRIED`: number of ports that are tried from there on.
const PORT: u16 = 4242;
const TRIED: u16 = 20;

/// Path at which the page requests the present files of the document, so that it follows their edits.
const DOCUMENT: &str = "/document";

/// State of the server.
#[derive(Clone, Debug)]
struct Laboratory {
    /// Document whose files the page follows; `None` if there is none.
    followed: Option<PathBuf>,
    /// The page at the start of the server.
    page: Arc<str>,
    terminal: Terminal,
    port: u16,
}

/// Serves until Ctrl-C.
pub fn serve(arguments: &Serve, terminal: Terminal) -> Result<(), Failure> {
    page::own()?;
    // The document is read once before anything is opened, so that a wrong name is reported here.
    let document = arguments.document.as_deref();
    let page: Arc<str> = laboratory_page(document, terminal)?.into();
    let listener = listen(arguments.port)?;
    let port = listener.local_addr().map_err(|error| network(&error))?.port();
    let address = format!("http://127.0.0.1:{port}/");
    terminal.print(&format!("The laboratory is at {address} (Ctrl-C ends it)\n"));
    if !arguments.no_open && webbrowser::open(&address).is_err() {
        terminal.print("No browser could be opened; open the address yourself\n");
    }
    let laboratory = Laboratory { followed: followed(document).map(Path::to_owned), page, terminal, port };
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build();
    runtime.and_then(|runtime| runtime.block_on(answer(listener, laboratory))).map_err(|error| network(&error))
}

fn listen(asked: Option<u16>) -> Result<TcpListener, Failure> {
    if let Some(port) = asked {
        return TcpListener::bind((Ipv4Addr::LOCALHOST, port)).map_err(|error| {
            let hint = "without --port, the next free one is taken";
            match error.kind() {
                io::ErrorKind::AddrInUse => Failure::with_hint(format!("port {port} is in use"), hint),
                _ => Failure::with_hint(format!("cannot listen on port {port}: {error}"), hint),
            }
        });
    }
    let mut candidates = (PORT..PORT + TRIED).chain([0]);
    candidates
        .find_map(|port| TcpListener::bind((Ipv4Addr::LOCALHOST, port)).ok())
        .ok_or_else(|| Failure::request("no port is free"))
}

fn network(error: &io::Error) -> Failure {
    Failure::request(format!("cannot serve: {error}"))
}

async fn answer(listener: TcpListener, laboratory: Laboratory) -> io::Result<()> {
    listener.set_nonblocking(true)?;
    let listener = tokio::net::TcpListener::from_std(listener)?;
    let guard = middleware::from_fn_with_state(laboratory.clone(), only_this_computer);
    let routes =
        Router::new().route("/", get(index)).route(DOCUMENT, get(document)).layer(guard).with_state(laboratory);
    tokio::select! {
        () = accept(listener, routes) => Ok(()),
        interrupted = tokio::signal::ctrl_c() => interrupted,
    }
}

/// Serves one request per connection, within a limited time.
async fn accept(listener: tokio::net::TcpListener, routes: Router) {
    let places = Arc::new(Semaphore::new(CONNECTIONS));
    loop {
        let Ok(place) = places.clone().acquire_owned().await else { return };
        let Ok((stream, _)) = listener.accept().await else {
            sleep(PAUSE).await;
            continue;
        };
        let service = TowerToHyperService::new(routes.clone());
        let connection = http1::Builder::new().keep_alive(false).serve_connection(TokioIo::new(stream), service);
        tokio::spawn(async move {
            // A failure or timeout of one connection does not affect the others.
            let _ = timeout(CONNECTION, connection).await;
            drop(place);
        });
    }
}

/// Refuses requests with another host name. Otherwise a foreign page could point its name to 127.0.0.1 (DNS rebinding)
/// and read the document through the user's browser.
async fn only_this_computer(State(laboratory): State<Laboratory>, request: Request, next: Next) -> Response {
    if is_local(request.headers(), laboratory.port) {
        next.run(request).await
    } else {
        (StatusCode::FORBIDDEN, "This laboratory is served to this computer alone.\n").into_response()
    }
}

fn is_local(headers: &HeaderMap, port: u16) -> bool {
    let host = headers.get(header::HOST).and_then(|value| value.to_str().ok());
    ["127.0.0.1", "localhost"]
        .iter()
        .any(|name| host == Some(&format!("{name}:{port}")) || (port == 80 && host == Some(*name)))
}

/// The page with the present document.
async fn index(State(laboratory): State<Laboratory>) -> Response {
    // Only a header, not the page itself, can forbid that other sites frame the page.
    let policy = format!("{}; frame-ancestors 'self'", policy(laboratory.followed.as_deref()));
    let headers = [
        (header::CONTENT_SECURITY_POLICY, policy.as_str()),
        (header::CONTENT_TYPE, "text/html; charset=utf-8"),
        (header::CACHE_CONTROL, "no-store"),
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (header::REFERRER_POLICY, "no-referrer"),
    ];
    let page = match laboratory.followed.as_deref() {
        Some(path) => laboratory_page(Some(path), laboratory.terminal),
        // The standard input can be read only once.
        None => Ok(laboratory.page.to_string()),
    };
    match page {
        Ok(page) => (headers, page).into_response(),
        Err(Failure::Request { message, .. }) => {
            (StatusCode::INTERNAL_SERVER_ERROR, format!("{}\n", message.text(laboratory.terminal.language)))
                .into_response()
        }
        Err(_) => StatusCode::INTERNAL_SERVER_ERROR.into_response(),
    }
}

/// The files of the document as JSON.
async fn document(State(laboratory): State<Laboratory>) -> Response {
    let headers = [
        (header::CONTENT_TYPE, "application/json"),
        (header::CACHE_CONTROL, "no-store"),
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
    ];
    let sources = laboratory.followed.as_deref().map(load::sources);
    match sources {
        Some(Ok(sources)) => (headers, write_list(&sources.embedded())).into_response(),
        // An editor may remove the file for a moment while it saves.
        _ => StatusCode::NOT_FOUND.into_response(),
    }
}

/// Document whose files the page follows; `None` for the standard input, which can be read only once.
fn followed(document: Option<&Path>) -> Option<&Path> {
    document.filter(|path| *path != Path::new("-"))
}

/// Content security policy of the page. A page that follows a document may connect to its server.
fn policy(document: Option<&Path>) -> String {
    let asks = if followed(document).is_some() { "; connect-src 'self'" } else { "" };
    format!("{POLICY}{asks}")
}

/// The page with a document. Findings are also written to the terminal; a document with errors is shown with them.
fn laboratory_page(document: Option<&Path>, terminal: Terminal) -> Result<String, Failure> {
    let Some(path) = document else {
        return page::own().map(str::to_owned);
    };
    let loaded = Loaded::open(load::sources(path)?);
    terminal.report(&loaded);
    let page = page::with(&loaded.sources, loaded.opened.document.as_ref())?;
    if followed(document).is_none() {
        return Ok(page);
    }
    let follows =
        format!("<link rel=\"alternate\" type=\"application/json\" id=\"served\" href=\"{DOCUMENT}\">\n</head>");
    Ok(page.replacen(POLICY, &policy(document), 1).replacen("</head>", &follows, 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn other_names_for_this_address_are_refused() {
        let host = |name: &str| {
            let mut headers = HeaderMap::new();
            headers.insert(header::HOST, name.parse().expect("a header value"));
            headers
        };
        for name in ["127.0.0.1:4242", "localhost:4242"] {
            assert!(is_local(&host(name), 4242), "{name}");
        }
        for name in ["attacker.example:4242", "127.0.0.1", "127.0.0.1:4243", "localhost.attacker.example:4242"] {
            assert!(!is_local(&host(name), 4242), "{name}");
        }
        assert!(!is_local(&HeaderMap::new(), 4242));
    }
}
