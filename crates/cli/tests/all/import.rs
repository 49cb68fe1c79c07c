//! `meniscus import`: a document and a report from a simulation of Easy JavaScript Simulations.

use crate::common::{Done, done, meniscus, names, program};
use std::fs;
use std::path::Path;

/// A spring; the page of fixed relations has a loop, which is not carried over.
const SIMULATION: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<Osejs version="6.0" password="">
<Osejs.Information><Title>A spring</Title><Author>An author</Author></Osejs.Information>
<Osejs.Description></Osejs.Description>
<Osejs.Model>
<Osejs.Model.FramesPerSecond>20</Osejs.Model.FramesPerSecond>
<Osejs.Model.StepsPerDisplay>1</Osejs.Model.StepsPerDisplay>
<Osejs.Model.Variables><Osejs.Model.Variables.Page><Active>true</Active><Name>Table</Name>
<Variable><Name><![CDATA[x]]></Name><Value><![CDATA[0.1]]></Value><Type><![CDATA[double]]></Type><Dimension><![CDATA[]]></Dimension></Variable>
<Variable><Name><![CDATA[v]]></Name><Value><![CDATA[0]]></Value><Type><![CDATA[double]]></Type><Dimension><![CDATA[]]></Dimension></Variable>
<Variable><Name><![CDATA[n]]></Name><Value><![CDATA[0]]></Value><Type><![CDATA[double]]></Type><Dimension><![CDATA[]]></Dimension></Variable>
<Variable><Name><![CDATA[t]]></Name><Value><![CDATA[0]]></Value><Type><![CDATA[double]]></Type><Dimension><![CDATA[]]></Dimension></Variable>
</Osejs.Model.Variables.Page></Osejs.Model.Variables>
<Osejs.Model.Evolution><Osejs.Model.Evolution.Page><Type>ODE_EDITOR</Type><Active>true</Active><Name>Motion</Name>
<IndependentVariable><![CDATA[t]]></IndependentVariable><Increment><![CDATA[0.05]]></Increment>
<Rate state="x"><![CDATA[v]]></Rate><Rate state="v"><![CDATA[-4*x]]></Rate><Method>RungeKutta</Method>
</Osejs.Model.Evolution.Page></Osejs.Model.Evolution>
<Osejs.Model.Constraints><Osejs.Model.Constraints.Page><Active>true</Active><Name>Loop</Name>
<Code><![CDATA[for (var i = 0; i < 3; i++) { n = n + i; }]]></Code></Osejs.Model.Constraints.Page></Osejs.Model.Constraints>
</Osejs.Model>
</Osejs>
"#;

fn run_in(folder: &Path, words: &[&str]) -> Done {
    done(program().current_dir(folder).args(words).output().expect("the program starts"))
}

#[test]
fn a_simulation_becomes_a_document_with_a_report() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("spring.ejss"), SIMULATION).unwrap();
    let made = run_in(folder.path(), &["import", "spring.ejss"]);
    assert_eq!((made.code, made.stderr.as_str()), (0, ""));
    assert!(made.stdout.starts_with("Wrote spring.md: the model is translated.\n"), "{}", made.stdout);
    assert!(made.stdout.contains("it has a loop"), "{}", made.stdout);
    assert_eq!(run_in(folder.path(), &["check", "spring.md"]).stdout, "spring.md: ok\n");
    let document = fs::read_to_string(folder.path().join("spring.md")).unwrap();
    assert!(document.contains("x' = v\nv' = -4*x\n") && document.contains("by An author"), "{document}");

    let again = run_in(folder.path(), &["import", "spring.ejss"]);
    assert_eq!(again.code, 2);
    assert!(
        again.stderr.contains("spring.md exists already") && again.stderr.contains("--output DOC"),
        "{}",
        again.stderr
    );
    assert_eq!(names(folder.path()), ["spring.ejss", "spring.md"]);
}

#[test]
fn the_report_for_programs_has_page_line_reason_and_count() {
    let folder = tempfile::tempdir().unwrap();
    let [file, document] = ["spring.ejss", "a.md"].map(|name| folder.path().join(name).to_str().unwrap().to_owned());
    fs::write(&file, SIMULATION).unwrap();
    let made = meniscus(&["import", &file, "--output", &document, "--report", "json"]);
    assert_eq!((made.code, made.stderr.as_str()), (0, ""));
    let report: serde_json::Value = serde_json::from_str(&made.stdout).unwrap();
    assert_eq!((&report["title"], &report["translated"]), (&"A spring".into(), &true.into()));
    let entry = &report["entries"][0];
    assert_eq!(
        (&entry["section"], &entry["page"], &entry["line"]),
        (&"fixed-relations".into(), &"Loop".into(), &1.into())
    );
    let line = entry["documentLine"].as_u64().unwrap() as usize;
    let text = fs::read_to_string(&document).unwrap();
    assert!(text.lines().nth(line - 1).unwrap().starts_with("- Fixed relations, \"Loop\", line 1"), "{text}");
}

#[test]
fn what_gives_no_document_is_refused_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("page.html"), "<!DOCTYPE html><html><body></body></html>").unwrap();
    fs::write(folder.path().join("text.ejss"), "no simulation").unwrap();
    for (file, language, message) in [
        ("page.html", "en", "This is an exported page."),
        ("page.html", "es", "Esto es una página exportada."),
        ("text.ejss", "en", "This is no simulation of Easy JavaScript Simulations."),
        ("missing.ejss", "en", "cannot read missing.ejss"),
    ] {
        let refused = run_in(folder.path(), &["import", file, "--language", language]);
        assert_eq!((refused.code, refused.stdout.as_str()), (2, ""), "{file}");
        assert!(refused.stderr.contains(message), "{file}: {}", refused.stderr);
    }
    assert_eq!(names(folder.path()), ["page.html", "text.ejss"]);
}
