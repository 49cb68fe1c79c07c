//! `meniscus class report --format gradebook`: marks by seat and question.

use crate::common::meniscus;
use document::page::Source;
use play::Play;
use saved::Item;
use saved::format::Content;
use saved::project::Project;
use std::path::Path;

/// The lesson that ships: two choices, two numbers, and a damping of each seat's own.
const LESSON: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/lessons/tube-damping.md");

/// Hands in these answers, question and text, of a seat.
fn hand_in(directory: &Path, name: &str, seat: &str, answers: &[(usize, &str)]) {
    let text = std::fs::read_to_string(LESSON).unwrap();
    let mut play = Play::open(document::open(&text, &[]).sound().unwrap().program);
    play.set_seat(seat).unwrap();
    for (question, answer) in answers {
        play.change_answers(|answers, run| answers.check(run, *question, answer));
    }
    let item = |(name, answer): (String, play::Answer)| (name, Item(Content::Answer(answer.stored())).write(5));
    let items = play.answers().saved(play.basis()).into_iter().map(item).collect();
    let documents = vec![Source { name: "tube-damping.md".to_owned(), text }];
    let work = Project { documents, state: play.share(), items };
    let project = directory.join(format!("{seat}.meniscus"));
    std::fs::write(&project, work.write()).unwrap();
    let path = directory.join("in").join(format!("{seat}.hand-in"));
    std::fs::create_dir_all(directory.join("in")).unwrap();
    let words = ["hand-in", project.to_str().unwrap(), "--name", name, "--output", path.to_str().unwrap()];
    let done = meniscus(&words);
    assert_eq!(done.code, 0, "{}", done.stderr);
}

/// Seat 2 has b = 16 g/s, T = 0.6661 s.
#[test]
fn marks_have_partial_credit_and_are_those_of_the_teachers_document() {
    let directory = tempfile::tempdir().unwrap();
    hand_in(directory.path(), "=1+1", "2", &[(0, "A, D"), (1, "B"), (2, "0.667 s"), (3, "16 g/s")]);
    hand_in(directory.path(), "red, fox", "3", &[(0, "A"), (1, "A"), (3, "999 g/s")]);
    let folder = directory.path().join("in");
    let words = ["class", "report", folder.to_str().unwrap(), "--document", LESSON, "--format", "gradebook"];
    let done = meniscus(&words);
    let expected = "\
Group,Seat,Question 1,Question 2,Question 3,Question 4,Total
'=1+1,2,100,100,100,100,100
\"red, fox\",3,50,0,,0,12.5
";
    assert_eq!((done.code, done.stdout.as_str()), (0, expected), "{}", done.stderr);
    // The grades follow from the answers.
    let verified = meniscus(&["verify", folder.to_str().unwrap(), "--document", LESSON]);
    assert_eq!(verified.code, 0, "{}", verified.stdout);
}

#[test]
fn the_lesson_has_no_fault_and_its_claims_hold() {
    let done = meniscus(&["check", "--run", LESSON]);
    assert_eq!(done.code, 0, "{}{}", done.stdout, done.stderr);
    assert!(done.stdout.contains("ok, 2 claims hold"), "{}", done.stdout);
}
