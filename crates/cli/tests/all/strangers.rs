//! Documents of unknown origin and interrupted programs: no control character is passed to the terminal, no run is
//! endless, and no incomplete file remains.

use crate::common::{SPRING, directory_with, meniscus, names, program};
use std::fmt::Write as _;

/// Characters that a terminal executes: an escape sequence, its eight-bit start, a bell, and marks that reverse the
/// direction of text.
const OBEYED: [char; 5] = ['\u{1b}', '\u{9b}', '\u{7}', '\u{202e}', '\u{2066}'];

#[test]
fn control_characters_of_a_document_do_not_reach_the_terminal() {
    for letter in OBEYED {
        // In names, equations, units, labels, the front matter, the scene and the prose, which messages may quote.
        let hostile = SPRING
            .replace("until: 2 [s]", &format!("until: 2 [{letter}s]\nst{letter}p: 1"))
            .replace("k*x = 0", &format!("k*x{letter}y = z{letter}"))
            .replace("\"Stiff\": k = 50 [N/m]", &format!("\"St{letter}iff\": q{letter} = 50 [N/m]"))
            + &format!("\n```scene\n<svg viewBox=\"0 0 1 1\"><g{letter} a{letter}=\"1\">{letter}</g></svg>\n```\n");
        let (_directory, path) = directory_with(&hostile);
        let path = path.to_str().expect("UTF-8");
        for words in [&["check", path][..], &["run", path], &["check", path, "--color", "always"]] {
            let done = meniscus(words);
            let shown = done.stdout + &done.stderr;
            assert!(shown.contains(&letter.escape_unicode().to_string()), "{words:?} quotes it: {shown}");
            // The program's own colours are escape sequences too.
            let shown = if words.contains(&"always") { shown.replace("\u{1b}[", "") } else { shown };
            assert!(!shown.contains(letter), "{words:?}: {shown:?}");
        }
    }
}

#[test]
fn findings_about_a_single_long_line_are_short() {
    let (directory, path) = directory_with("");
    let mut scene = String::from("<svg viewBox=\"0 0 1 1\">");
    for number in 0..20_000 {
        let _ = write!(scene, "<g><bad{number}/>");
    }
    let text = format!("{SPRING}\n```scene\n{scene}\n```\n");
    std::fs::write(&path, &text).expect("it can be written");
    let done = meniscus(&["check", path.to_str().expect("UTF-8")]);
    assert_eq!(done.code, 1);
    assert!(done.stdout.len() < 200_000, "{} bytes about {} bytes", done.stdout.len(), text.len());
    assert!(done.stdout.contains("are shown in part"), "{}", &done.stdout[..2000]);
    drop(directory);
    // The position is stated and shown anywhere in a long line.
    let long = format!("k*x + {}qq = 0", "k*x + ".repeat(200));
    let (_directory, path) = directory_with(&SPRING.replace("k*x = 0", &long));
    let done = meniscus(&["check", path.to_str().expect("UTF-8")]);
    assert!(done.stdout.contains(":15:1215"), "{}", done.stdout);
    assert!(done.stdout.contains("k*x + qq = 0") && done.stdout.contains("^^"), "{}", done.stdout);
}

#[cfg(unix)]
#[test]
fn an_interrupted_run_leaves_no_file() {
    use std::os::unix::process::ExitStatusExt as _;
    for signal in ["INT", "TERM", "HUP"] {
        let (directory, path) = directory_with(SPRING);
        let output = directory.path().join("run.csv");
        let words = ["run", path.to_str().expect("UTF-8"), "--until", "1e9", "--step", "1e-4", "--output"];
        let mut child = program().args(words).arg(&output).spawn().expect("the program starts");
        while names(directory.path()).len() < 2 {
            assert!(child.try_wait().expect("a child").is_none(), "it goes on until it is interrupted");
            std::thread::yield_now();
        }
        let sent = std::process::Command::new("kill").args(["-s", signal, &child.id().to_string()]).status();
        assert!(sent.expect("kill is there").success());
        let status = child.wait().expect("a child");
        assert!(status.code() == Some(130) || status.signal().is_some(), "{status}");
        assert_eq!(names(directory.path()), ["spring.md"], "after SIG{signal}");
    }
}
