//! `meniscus class serve`, `backup`, `restore`, `erase`, `export`: the class server on this computer.

use super::server_arguments::{Backup, ClassServer, Erase, ExportClass, ListClasses, Restore, ServeClass, StorePlace};
use super::stored;
use crate::failure::Failure;
use crate::load;
use crate::page;
use crate::terminal::{Terminal, output};
use class::grading;
use document::page::POLICY;
use program::{Program, Seat};
use runner::Loaded;
use server::class::{Class, Classes};
use server::http::{Log, Place, Server};
use server::pages::{Document, Given, Grader, Pages, Source};
use server::store::{Location, back_up, restore};
use server::{Fault, Store, export, listen, now, qr};
use std::future::Future;
use std::io;
use std::net::{IpAddr, Ipv4Addr, SocketAddr, UdpSocket};
use std::path::Path;
use std::sync::{Mutex, PoisonError};
use std::time::Duration;
use tokio::net::TcpListener;
use tokio::time::interval;
use units::{Language, Words, say, words};

/// First port that is tried, and the number of ports.
const PORT: u16 = 4250;
const TRIED: u16 = 20;

/// Time between two looks for classes whose time is over.
const LOOK: Duration = Duration::from_secs(3600);

/// Runs one of the commands.
///
/// # Errors
/// A document, a store or a port cannot be used.
pub fn run(command: &ClassServer, terminal: Terminal) -> Result<(), Failure> {
    match command {
        ClassServer::Serve(arguments) => serve(arguments, terminal),
        ClassServer::Backup(arguments) => blocking(backup(arguments)),
        ClassServer::Restore(Restore { backup, place }) => blocking(async {
            let location = location(place)?;
            let events = restore(backup, &location, now()).await.map_err(|fault| match fault {
                Fault::Away(_) => about(&location, &fault),
                fault => Failure::about(backup, &fault.words()),
            })?;
            let links = terminal.language.say(
                "No device of a teacher is taken from a backup: a start with `meniscus class serve` prints a new link.",
            );
            terminal.print(&format!("{}: {events}\n{links}\n", terminal.language.say("parts restored")));
            Ok(())
        }),
        ClassServer::Erase(arguments) => blocking(erase(arguments)),
        ClassServer::Export(arguments) => blocking(write_files(arguments, terminal)),
        ClassServer::List(arguments) => blocking(list(arguments, terminal)),
    }
}

fn blocking(work: impl Future<Output = Result<(), Failure>>) -> Result<(), Failure> {
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build();
    runtime.map_err(|error| network(&error))?.block_on(work)
}

/// Where the store is. The variable of the environment is that of Postgres's own programs: arguments can be read by other users.
fn location(place: &StorePlace) -> Result<Location, Failure> {
    let password = std::env::var("PGPASSWORD").ok();
    Location::read(&place.store, password.as_deref())
        .map_err(|fault| Failure::about(Path::new("--store"), &fault.words()))
}

fn about(location: &Location, fault: &Fault) -> Failure {
    Failure::about(Path::new(&location.to_string()), &fault.words())
}

fn network(error: &io::Error) -> Failure {
    Failure::in_words(words!("cannot serve: {}", error), words("choose another port with `--port`"))
}

async fn backup(Backup { place, class, output }: &Backup) -> Result<(), Failure> {
    let location = location(place)?;
    let fails = |fault| about(&location, &fault);
    let class = match class {
        None => None,
        Some(name) => {
            let store = Store::existing(&location).await.map_err(fails)?;
            Some(stored::chosen(store.classes().await.map_err(fails)?, Some(name), fails)?.class)
        }
    };
    back_up(&location, output, class.as_deref()).await.map_err(|fault| match fault {
        Fault::Exists => Failure::about(output, &fault.words()),
        fault => fails(fault),
    })
}

async fn erase(arguments: &Erase) -> Result<(), Failure> {
    let location = location(&arguments.place)?;
    let fails = |fault| about(&location, &fault);
    let store = Store::existing(&location).await.map_err(fails)?;
    let classes = store.classes().await.map_err(fails)?;
    match arguments.seat {
        Some(seat) => {
            let class = stored::chosen(classes, arguments.class.as_deref(), fails)?;
            store.erase_seats(class.class, vec![seat]).await.map_err(fails)?;
        }
        None => {
            let gone = match &arguments.class {
                Some(name) => vec![stored::chosen(classes, Some(name), fails)?],
                None => classes,
            };
            for class in gone {
                store.erase_class(class.class).await.map_err(fails)?;
            }
        }
    }
    store.rewrite().await.map_err(fails)
}

async fn list(arguments: &ListClasses, terminal: Terminal) -> Result<(), Failure> {
    let location = location(&arguments.place)?;
    let fails = |fault| about(&location, &fault);
    let store = Store::existing(&location).await.map_err(fails)?;
    let classes = store.classes().await.map_err(fails)?;
    let erased = store.erased().await.map_err(fails)?;
    let mut lines = String::new();
    for class in &classes {
        lines += &stored::line(&store, class, terminal.language).await.map_err(fails)?;
        let seats = erased.iter().filter(|(of, seat)| *of == class.class && *seat > 0).count();
        if seats > 0 {
            lines += &say!(terminal.language, "; seats that were erased: {seats}");
        }
        lines.push('\n');
    }
    let gone = erased.iter().filter(|(_, seat)| *seat == 0).count();
    if gone > 0 {
        lines += &say!(terminal.language, "classes that were erased with all that was in them: {gone}");
        lines.push('\n');
    }
    output::print(&lines)
}

async fn write_files(arguments: &ExportClass, terminal: Terminal) -> Result<(), Failure> {
    let location = location(&arguments.place)?;
    let fails = |fault| about(&location, &fault);
    let store = Store::existing(&location).await.map_err(fails)?;
    let classes = store.classes().await.map_err(fails)?;
    let class = stored::chosen(classes, arguments.class.as_deref(), fails)?;
    let files = export::files(&store, &class.class).await.map_err(fails)?;
    let folder = &arguments.output;
    std::fs::create_dir_all(folder).map_err(|error| Failure::file("write", folder, &error))?;
    for (name, content) in &files {
        let file = folder.join(name);
        std::fs::write(&file, content).map_err(|error| Failure::file("write", &file, &error))?;
    }
    terminal.print(&format!("{}: {}\n", terminal.language.say("files written"), files.len()));
    Ok(())
}

fn serve(arguments: &ServeClass, terminal: Terminal) -> Result<(), Failure> {
    let documents = documents(arguments, terminal)?;
    let title = documents.first().map_or_else(String::new, |document| document.title.clone());
    let pages = Pages::new(documents, page::own()?, POLICY, terminal.language);
    let location = location(&arguments.place)?;
    blocking(async {
        // A refused start makes neither a store nor a class.
        let listener = listener(listened(arguments), arguments.port).await.map_err(|error| network(&error))?;
        let port = listener.local_addr().map_err(|error| network(&error))?.port();
        let (place, tls) = place(arguments, port)?;
        let log = arguments.log.as_deref().map(log).transpose()?;
        let fails = |fault| about(&location, &fault);
        let store = Store::open(&location).await.map_err(fails)?;
        let classes = Classes::open(store, terminal.language, now()).await.map_err(fails)?;
        let classes = classes.with_room(arguments.room << 20);
        let known = classes.store().classes().await.map_err(fails)?;
        if let Some(class) = known.first() {
            let line = stored::line(classes.store(), class, terminal.language).await.map_err(fails)?;
            if !arguments.new && !arguments.goes_on {
                return Err(Failure::in_words(
                    words!("{location} has a class: {line}", location = location.to_string()),
                    words("`--continue` goes on with it, `--new` begins another one"),
                ));
            }
            if arguments.goes_on {
                terminal.print(&format!("{line}\n"));
            }
        }
        let class = match arguments.new {
            true => classes.begin(&title, arguments.keep, now()).await,
            false => classes.latest_or_begin(&title, arguments.keep, now()).await,
        };
        let class = class.map_err(fails)?;
        let server = Server::new(classes, pages, place, log);
        let link = server.classes().link(&class).await.map_err(fails)?;
        let own = arguments.listen.filter(IpAddr::is_loopback).unwrap_or(Ipv4Addr::LOCALHOST.into());
        announce(&server, &class, &link, SocketAddr::from((own, port)), terminal);
        let look = async {
            let mut looks = interval(LOOK);
            loop {
                looks.tick().await;
                // A store that cannot be written at the moment is looked at again.
                let _ = server.classes().erase_expired(now()).await;
            }
        };
        tokio::select! {
            () = listen::serve(listener, server.routes(), tls) => Ok(()),
            () = look => Ok(()),
            () = server.classes().follow() => Ok(()),
            interrupted = tokio::signal::ctrl_c() => interrupted.map_err(|error| network(&error)),
        }
    })
}

/// A log to which lines are added.
fn log(path: &Path) -> Result<Log, Failure> {
    let file = std::fs::OpenOptions::new().create(true).append(true).open(path);
    Ok(Log::new(file.map_err(|error| Failure::file("write", path, &error))?))
}

/// The documents with their pages. A document with errors is refused.
fn documents(arguments: &ServeClass, terminal: Terminal) -> Result<Vec<Document>, Failure> {
    let mut documents: Vec<Document> = Vec::new();
    for path in &arguments.documents {
        let loaded = Loaded::open(load::sources(path)?);
        terminal.report(&loaded);
        let Some(document) = loaded.opened.document.as_ref().filter(|_| !loaded.opened.has_errors()) else {
            return Err(Failure::Document);
        };
        let html = match arguments.lab {
            true => page::with(&loaded.sources, Some(document))?,
            false => page::player(&loaded.sources, document)?,
        };
        let name = loaded.sources.embedded().first().map_or_else(String::new, |source| source.name.clone());
        if documents.iter().any(|other| other.name == name) {
            let why = words("is the second document of this name");
            return Err(Failure::about(path, &why));
        }
        let (title, has_seats) = (document.program.title.clone(), document.program.has_seats());
        let grader = grader(document.program.clone(), terminal.language);
        let source = |source: document::page::Source| Source { name: source.name, text: source.text };
        let sources = loaded.sources.embedded().into_iter().map(source).collect();
        documents.push(Document { name, title, has_seats, html, sources, grader });
    }
    Ok(documents)
}

/// Grades by a program, with the values of the seat of each student.
fn grader(program: Program, language: Language) -> Grader {
    let grading = Mutex::new(grading::Grader::new(program, language.tag()));
    Grader::new(move |seat, question, item| {
        // A fault in the grading of one answer leaves nothing half done.
        let mut grading = grading.lock().unwrap_or_else(PoisonError::into_inner);
        let answer = grading.answer(Seat::new(seat), question, item)?;
        let typed = answer.attempts.last()?.typed.clone();
        Some(Given { typed, is_right: answer.found })
    })
}

/// True if a proxy in front of the server encrypts.
fn is_behind_proxy(arguments: &ServeClass) -> bool {
    arguments.tls.as_deref() == Some("behind-proxy")
}

/// Address on which the server listens. Between a proxy and the server nothing is encrypted: without another choice, it is
/// reached on this computer alone.
fn listened(arguments: &ServeClass) -> IpAddr {
    let default = if is_behind_proxy(arguments) { Ipv4Addr::LOCALHOST } else { Ipv4Addr::UNSPECIFIED };
    arguments.listen.unwrap_or(default.into())
}

async fn listener(address: IpAddr, port: Option<u16>) -> io::Result<TcpListener> {
    if let Some(port) = port {
        return TcpListener::bind((address, port)).await;
    }
    for port in PORT..PORT + TRIED {
        if let Ok(listener) = TcpListener::bind((address, port)).await {
            return Ok(listener);
        }
    }
    TcpListener::bind((address, 0)).await
}

/// Where the server is reached, and its encryption.
fn place(arguments: &ServeClass, port: u16) -> Result<(Place, Option<listen::Tls>), Failure> {
    let address = match &arguments.public {
        Some(url) => url.trim_end_matches('/').to_owned(),
        None => {
            let address = Some(listened(arguments)).filter(|address| !address.is_unspecified());
            format!("http://{}", SocketAddr::from((address.unwrap_or_else(|| own_address().into()), port)))
        }
    };
    let host = address.split_once("://").map(|(_, rest)| rest.split([':', '/']).next().unwrap_or_default().to_owned());
    let Some(host) = host.filter(|host| !host.is_empty()) else {
        return Err(Failure::in_words(
            words!("{} is no address", address),
            words("for example `--public https://class.example`"),
        ));
    };
    let is_behind_proxy = is_behind_proxy(arguments);
    if arguments.proxy.is_some() && !is_behind_proxy {
        return Err(Failure::in_words(
            words("--proxy names a proxy, but --tls names a certificate of the server itself"),
            words("leave out --proxy, or write `--tls behind-proxy`"),
        ));
    }
    let one = arguments.listen.filter(|address| !address.is_loopback() && !address.is_unspecified());
    if let (Some(address), None) = (one, &arguments.tls) {
        return Err(Failure::in_words(
            words!("the dashboard answers to this computer alone, which does not reach it through {}", address),
            words("leave out --listen, or encrypt with --tls"),
        ));
    }
    let proxy = is_behind_proxy.then(|| arguments.proxy.unwrap_or(Ipv4Addr::LOCALHOST.into()));
    let tls = match arguments.tls.as_deref().filter(|_| !is_behind_proxy) {
        None => None,
        Some(files) => Some(encryption(files)?),
    };
    let is_encrypted = arguments.tls.is_some();
    Ok((Place { address, hosts: vec![host], is_encrypted, proxy }, tls))
}

fn encryption(files: &str) -> Result<listen::Tls, Failure> {
    let hint = || words("`--tls CERT.pem,KEY.pem`, or `--tls behind-proxy`");
    let fails = |why: Words| Failure::in_words(why, hint());
    let Some((certificate, key)) = files.split_once(',') else {
        return Err(fails(words!("{} names no certificate and key", files)));
    };
    listen::tls(Path::new(certificate), Path::new(key)).map_err(|error| fails(Words::same(error.to_string())))
}

/// Address of this computer in its network; loopback without a network. Nothing is sent: a connected UDP socket only looks up the
/// route.
fn own_address() -> Ipv4Addr {
    let look = || -> io::Result<SocketAddr> {
        let socket = UdpSocket::bind((Ipv4Addr::UNSPECIFIED, 0))?;
        // An address for documentation (RFC 5737).
        socket.connect((Ipv4Addr::new(192, 0, 2, 1), 9))?;
        socket.local_addr()
    };
    match look() {
        Ok(SocketAddr::V4(address)) if !address.ip().is_unspecified() => *address.ip(),
        _ => Ipv4Addr::LOCALHOST,
    }
}

/// Prints how students and the teacher get in. `link`: the secret part of the teacher's link; `own`: address of the server on this
/// computer.
fn announce(server: &Server, class: &Class, link: &str, own: SocketAddr, terminal: Terminal) {
    let place = server.place();
    let base = if place.is_encrypted { place.address.clone() } else { format!("http://{own}") };
    let language = terminal.language;
    let (students, code) = (language.say("Students"), language.say("code"));
    let (teacher, once) = (language.say("Teacher"), language.say("open this link in a browser; it works once"));
    let ends = language.say("Ctrl-C ends the server; the class stays in");
    terminal.print(&format!(
        "{}\n{students}: {}   {code}: {}\n{teacher} ({once}): {base}/teacher#link={link}\n{ends} {}\n",
        qr::terminal(&place.join_address(&class.code())),
        place.address,
        class.code(),
        server.classes().store().location(),
    ));
}
