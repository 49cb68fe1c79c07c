//! `meniscus export` and `meniscus serve`, with and without the embedded page.

use crate::common::{SPRING, directory_with, meniscus, names};

#[cfg(not(page_inside))]
#[test]
fn a_program_without_the_page_says_what_is_missing() {
    let (directory, path) = directory_with(SPRING);
    let output = directory.path().join("spring.html");
    let (path, output) = (path.to_str().expect("UTF-8"), output.to_str().expect("UTF-8"));
    let folder = directory.path().to_str().expect("UTF-8");
    for words in [
        &["export", path, "--output", output][..],
        &["build", folder, "--output", &(folder.to_owned() + "-site")],
        &["serve", path, "--no-open"],
        &["serve", "--no-open"],
    ] {
        let done = meniscus(words);
        assert_eq!(done.code, 2);
        assert!(done.stderr.contains("cargo xtask page"), "{}", done.stderr);
    }
    assert_eq!(names(directory.path()), ["spring.md"]);
}

#[cfg(page_inside)]
mod with_the_page {
    use super::*;
    use crate::common::program;
    use std::io::{BufRead, BufReader, Read, Write};
    use std::net::TcpStream;
    use std::process::{Child, Stdio};

    #[test]
    fn an_exported_page_is_a_document_again() {
        let (directory, path) = directory_with(SPRING);
        let output = directory.path().join("spring.html");
        let (path, output) = (path.to_str().expect("UTF-8"), output.to_str().expect("UTF-8"));
        let done = meniscus(&["export", path, "--output", output]);
        assert_eq!((done.code, done.stdout.as_str(), done.stderr.as_str()), (0, "", ""));
        assert_eq!(names(directory.path()), ["spring.html", "spring.md"]);
        let page = std::fs::read_to_string(output).expect("a page");
        assert!(page.contains("<title>A spring"), "its title");
        assert_eq!(meniscus(&["run", output]).stdout, meniscus(&["run", path]).stdout);
        let again = meniscus(&["export", output, "--output", "-"]);
        assert_eq!(again.stdout, page, "exporting it again changes nothing");
    }

    #[test]
    fn a_document_with_errors_is_not_exported() {
        let (directory, path) = directory_with(&SPRING.replace("k*x = 0", "k*y = 0"));
        let output = directory.path().join("spring.html");
        let done = meniscus(&["export", path.to_str().expect("UTF-8"), "--output", output.to_str().expect("UTF-8")]);
        assert_eq!(done.code, 1);
        assert_eq!(names(directory.path()), ["spring.md"]);
    }

    /// A running server that ends when dropped.
    struct Server {
        child: Child,
        port: u16,
    }

    impl Server {
        fn start(words: &[&str]) -> Self {
            let mut child = program()
                .args(["serve", "--no-open"])
                .args(words)
                .stderr(Stdio::piped())
                .spawn()
                .expect("the program starts");
            let mut line = String::new();
            BufReader::new(child.stderr.take().expect("a pipe")).read_line(&mut line).expect("a line");
            let port = line.split("127.0.0.1:").nth(1).and_then(|rest| rest.split('/').next()?.parse().ok());
            Self { child, port: port.unwrap_or_else(|| panic!("no address in {line}")) }
        }

        /// Response to one request.
        fn get(&self, path: &str, host: &str) -> String {
            let mut stream = TcpStream::connect(("127.0.0.1", self.port)).expect("it listens");
            write!(stream, "GET {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n").expect("it reads");
            let mut answer = String::new();
            stream.read_to_string(&mut answer).expect("it answers");
            answer
        }
    }

    impl Drop for Server {
        fn drop(&mut self) {
            let _ = self.child.kill();
            let _ = self.child.wait();
        }
    }

    #[test]
    fn the_laboratory_is_served_to_this_computer_alone() {
        let (_directory, path) = directory_with(SPRING);
        let server = Server::start(&[path.to_str().expect("UTF-8")]);
        let own = format!("127.0.0.1:{}", server.port);
        let answer = server.get("/", &own);
        assert!(answer.starts_with("HTTP/1.1 200"), "{}", &answer[..100]);
        assert!(answer.to_lowercase().contains("cache-control: no-store"));
        assert!(answer.contains("<title>A spring"));
        std::fs::write(&path, SPRING.replace("A spring", "Another spring")).expect("it can be written");
        assert!(server.get("/", &own).contains("<title>Another spring"), "read anew at each reload");
        std::fs::remove_file(&path).expect("it is there");
        assert!(server.get("/", &own).starts_with("HTTP/1.1 500"));
        assert!(server.get("/", "attacker.example").starts_with("HTTP/1.1 403"));
        assert!(server.get("/other", &own).starts_with("HTTP/1.1 404"));
    }

    #[test]
    fn the_files_of_the_document_are_served_as_they_are_now() {
        let (_directory, path) = directory_with(SPRING);
        let server = Server::start(&[path.to_str().expect("UTF-8")]);
        let own = format!("127.0.0.1:{}", server.port);
        let page = server.get("/", &own);
        assert!(page.contains("id=\"served\" href=\"/document\">\n</head>"), "the page asks for them");
        assert_eq!(page.matches("connect-src 'self'").count(), 2, "and may, by header and by element");
        let files = |answer: String| {
            let (_, body) = answer.split_once("\r\n\r\n").expect("a head and a body");
            document::page::read_list(body)
        };
        let text = |files: Option<Vec<document::page::Source>>| files.map(|files| files[0].text.clone());
        assert_eq!(text(files(server.get("/document", &own))).as_deref(), Some(SPRING));
        std::fs::write(&path, "other").expect("it can be written");
        assert_eq!(text(files(server.get("/document", &own))).as_deref(), Some("other"), "also where it has errors");
        std::fs::remove_file(&path).expect("it is there");
        assert!(server.get("/document", &own).starts_with("HTTP/1.1 404"));
        assert!(server.get("/document", "attacker.example").starts_with("HTTP/1.1 403"));
        let without = Server::start(&[]);
        let own = format!("127.0.0.1:{}", without.port);
        assert!(without.get("/document", &own).starts_with("HTTP/1.1 404"));
    }

    #[test]
    fn the_policy_is_sent_and_no_other_site_can_frame_the_page() {
        let server = Server::start(&[]);
        let answer = server.get("/", &format!("127.0.0.1:{}", server.port)).to_lowercase();
        let (head, page) = answer.split_once("\r\n\r\n").expect("a head and a page");
        let policy = head.lines().find_map(|line| line.strip_prefix("content-security-policy: ")).expect("a policy");
        let (own, frames) = policy.rsplit_once("; ").expect("several rules");
        assert_eq!(frames, "frame-ancestors 'self'");
        assert!(page.contains(&format!("content=\"{own}\"")), "the page says the same of itself");
    }

    #[test]
    fn connections_without_a_request_are_closed() {
        let server = Server::start(&[]);
        let connect = || TcpStream::connect(("127.0.0.1", server.port)).expect("the server listens");
        let mut silent = [connect(), connect(), connect()];
        silent[1].write_all(b"GET / HTTP/1.1\r\nHost:").expect("a part of a request");
        silent[2].write_all(b"GET / HTTP/1.1\r\n").expect("a part of a request");
        for stream in &mut silent {
            // Returns only when the server closes the connection.
            let mut rest = Vec::new();
            let _ = stream.read_to_end(&mut rest);
        }
    }

    #[test]
    fn a_port_that_is_asked_for_is_taken_or_refused() {
        let server = Server::start(&["--port", "0"]);
        let port = server.port.to_string();
        let done = meniscus(&["serve", "--no-open", "--port", &port]);
        assert_eq!(done.code, 2);
        assert!(done.stderr.contains(&format!("port {port} is in use")), "{}", done.stderr);
        assert_ne!(Server::start(&[]).port, server.port, "without --port, another one");
    }
}
