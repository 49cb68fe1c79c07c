//! Any text as a project; what is read is taken by a desk and written again.

#![no_main]

use desk::Desk;
use desk::saved::project::Project;
use libfuzzer_sys::fuzz_target;

const DOCUMENT: &str = "```model\nx' = -k*x\nparameter k = 1 [1/s]\nx(0) = 1 [m]\n```\n";

fuzz_target!(|text: &str| {
    let Ok(project) = Project::read(text) else { return };
    assert_eq!(Project::read(&project.write()), Ok(project.clone()));
    let Some(document) = document::open(DOCUMENT, &[]).document else { panic!("a document") };
    let mut desk = Desk::open(document);
    let _ = desk::restore(&mut desk, &project.state);
    desk::take_project_items(&mut desk, &project.items);
});
