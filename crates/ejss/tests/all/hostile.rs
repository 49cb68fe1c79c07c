//! Damaged and hostile files: a document or a refusal, never a panic and never more than plain text.

use crate::support::{import, simulations};
use units::split_mix::SplitMix64;

#[test]
fn damaged_files_give_a_document_or_a_refusal() {
    let all = simulations();
    let mut numbers = SplitMix64::new(53);
    let mut documents = 0;
    for round in 0..400 {
        let (_, simulation) = &all[round % all.len()];
        let text = if round % 2 == 0 { simulation.ejss() } else { simulation.json() };
        let mut bytes = text.into_bytes();
        for _ in 0..1 + round % 5 {
            let number = numbers.bits();
            let at = number as usize % bytes.len();
            match number >> 61 {
                0 => bytes.truncate(at.max(1)),
                1 => bytes[at] = (number >> 32) as u8,
                2 => bytes[at] = b"<>[](){}\"'`$\\/*=;&\n"[(number >> 40) as usize % 19],
                3 => {
                    let end = (at + 200).min(bytes.len());
                    let part = bytes[at..end].to_vec();
                    bytes.splice(at..at, part);
                }
                _ => _ = bytes.remove(at),
            }
        }
        let Ok(imported) = import(&bytes) else { continue };
        documents += 1;
        let opened = document::open(&imported.document, &[]);
        let errors: Vec<String> = opened.diagnostics.iter().map(|(_, found)| found.message.english()).collect();
        assert!(!opened.has_errors(), "{errors:?}\n{}", imported.document);
        assert!(imported.document.lines().all(|line| line.chars().count() <= 200), "{}", imported.document);
    }
    assert!(documents > 100, "{documents} documents");
}

#[test]
fn nothing_of_a_file_ends_its_place_in_the_document() {
    let evil = "a\n```\n---\n```model\nparameter EVIL = 1\n```\n</svg><script>alert(1)</script> ![x](javascript:alert(1)) $\\fraq{$";
    let all = simulations();
    let (_, simulation) = all.iter().find(|(name, _)| name == "01-spring").expect("a simulation");
    let text = simulation.ejss();
    for known in [
        "Mass and spring",
        "Example",
        "A mass on a spring &amp; a damper",
        "energy",
        "k [N/m] = ",
        "damping",
        "Displacement",
        "ball",
        "low",
        "plot",
    ] {
        assert!(text.contains(known), "{known}");
        let imported = import(text.replace(known, evil).as_bytes()).expect(known);
        let opened = document::open(&imported.document, &[]);
        assert!(!opened.has_errors(), "{known}\n{}", imported.document);
        let program = opened.sound().expect(known).program;
        assert!(
            program.model.parameters.iter().all(|parameter| parameter.name != "EVIL"),
            "{known}\n{}",
            imported.document
        );
        // Code is shown as it is; in prose nothing of it is a link.
        let prose: String = imported.document.split("```").step_by(2).collect();
        assert!(!prose.contains("[x]("), "{known}\n{prose}");
    }
}
