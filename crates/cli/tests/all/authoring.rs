//! `meniscus new` and `meniscus format`: templates and layout.

use crate::common::{SPRING, directory_with, done, meniscus, program};
use std::fs;
use std::io::Write;
use std::process::Stdio;

#[test]
fn a_new_document_is_without_findings_and_in_the_layout() {
    let directory = tempfile::tempdir().unwrap();
    for (template, language) in [("oscillator", "en"), ("projectile", "es"), ("empty", "en")] {
        let folder = directory.path().join(template);
        let folder = folder.to_str().unwrap();
        let document = format!("{folder}/{template}.md");
        let made = meniscus(&["new", folder, "--template", template, "--language", language]);
        assert_eq!((made.code, made.stdout.as_str()), (0, ""), "{}", made.stderr);
        assert!(made.stderr.contains(&format!("meniscus serve {document}")), "{}", made.stderr);
        assert!(fs::read_to_string(&document).unwrap().contains(&format!("language: {language}\n")));
        assert_eq!(meniscus(&["format", "--check", &document]).code, 0);
        assert_eq!(meniscus(&["check", &document]).stdout, format!("{document}: ok\n"));
    }
}

/// The printed commands work when copied into a shell.
#[cfg(unix)]
#[test]
fn a_folder_with_blanks_is_quoted_in_commands() {
    let directory = tempfile::tempdir().unwrap();
    let folder = directory.path().join("my simulations");
    let made = meniscus(&["new", folder.to_str().unwrap()]);
    let document = format!("'{}/my simulations.md'", folder.display());
    for command in [format!("meniscus check {document} "), format!("meniscus build '{}' --", folder.display())] {
        assert!(made.stderr.contains(&command), "{}", made.stderr);
    }
}

#[cfg(unix)]
#[test]
fn a_folder_is_no_document_and_its_documents_are_named() {
    let directory = tempfile::tempdir().unwrap();
    let folder = directory.path().join("my folder");
    let path = folder.to_str().unwrap();
    fs::create_dir(&folder).unwrap();
    let empty = meniscus(&["check", path]);
    assert_eq!(empty.code, 2);
    assert!(empty.stderr.contains(&format!("`meniscus new '{path}'` begins one")), "{}", empty.stderr);
    for name in ["b.md", "a.es.md", "a.txt"] {
        fs::write(folder.join(name), "").unwrap();
    }
    for (language, message, hint) in [
        ("en", "is a folder, not a document", format!("such as '{path}/b.md'; `meniscus check '{path}'/*.md`")),
        ("es", "es una carpeta, no un documento", format!("por ejemplo '{path}/b.md'; `meniscus check '{path}'/*.md`")),
    ] {
        let refused = meniscus(&["check", path, "--language", language]);
        assert_eq!(refused.code, 2);
        assert!(
            refused.stderr.contains(&format!("{path} {message}")) && refused.stderr.contains(&hint),
            "{}",
            refused.stderr
        );
    }
}

#[test]
fn a_new_document_overwrites_nothing() {
    let directory = tempfile::tempdir().unwrap();
    let folder = directory.path().join("spring");
    fs::create_dir(&folder).unwrap();
    fs::write(folder.join("spring.md"), "mine").unwrap();
    let refused = meniscus(&["new", folder.to_str().unwrap()]);
    assert_eq!(refused.code, 2);
    assert!(refused.stderr.contains("spring.md exists already"), "{}", refused.stderr);
    assert_eq!(fs::read_to_string(folder.join("spring.md")).unwrap(), "mine");
    let unknown = meniscus(&["new", folder.to_str().unwrap(), "--template", "nothing"]);
    assert_eq!(unknown.code, 2);
    assert!(unknown.stderr.contains("oscillator"), "{}", unknown.stderr);
}

#[test]
fn a_layout_is_checked_and_then_written() {
    let (_directory, path) = directory_with(&SPRING.replace("m*x'' + k*x = 0", "m * x''+k*x=0"));
    let file = path.to_str().unwrap();
    let before = fs::read_to_string(&path).unwrap();
    let checked = meniscus(&["format", "--check", file]);
    assert_eq!((checked.code, checked.stdout), (1, format!("{file}: the layout differs, first in line 11\n")));
    assert_eq!(fs::read_to_string(&path).unwrap(), before, "only checked");
    let written = meniscus(&["format", file]);
    assert_eq!((written.code, written.stderr), (0, format!("{file}: formatted\n")));
    let after = fs::read_to_string(&path).unwrap();
    let lines = "parameter m   = 2 [kg]  in 0.5..10  \"Mass\"\nparameter k   = 8 [N/m] in 0..100   \"Stiffness\"\nparameter x_0 = 5 [cm]  in -20..20  \"Start\"\n\n\
                 m*x'' + k*x = 0\n";
    assert!(after.contains(lines), "{after}");
    let again = meniscus(&["format", file]);
    assert_eq!((again.code, again.stderr.as_str()), (0, ""), "the layout is reached in one step");
    assert_eq!(meniscus(&["run", file]).stdout, through("run", &before), "the same numbers");
}

/// Output of a command for a document on the standard input.
fn through(command: &str, text: &str) -> String {
    let mut child = program().args([command, "-"]).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    child.stdin.take().unwrap().write_all(text.as_bytes()).unwrap();
    done(child.wait_with_output().unwrap()).stdout
}

#[test]
fn the_standard_input_goes_to_the_standard_output() {
    assert_eq!(through("format", "```model\nx'=-x\n```"), "```model\nx' = -x\n```\n");
}

#[test]
fn what_has_errors_stays_and_that_is_said() {
    let text = "```model\nx' = (1\n```\n\n```plots\n\"x\":x  against t\n```\n";
    let (_directory, path) = directory_with(text);
    let file = path.to_str().unwrap();
    let written = meniscus(&["format", file]);
    assert_eq!(written.code, 1);
    assert!(written.stderr.contains("this part keeps its layout, because it has errors"), "{}", written.stderr);
    assert!(written.stderr.contains(&format!("{file}:1:1")), "{}", written.stderr);
    assert_eq!(fs::read_to_string(&path).unwrap(), text.replace(":x  against", ": x against"));
    let page = meniscus(&["format", "page.html"]);
    assert!(page.stderr.contains("page.html holds a document and is none itself"), "{}", page.stderr);
}
