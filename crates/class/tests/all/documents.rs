//! Documents of hand-ins that are not the teacher's.

use crate::support::lesson;
use class::collection::{Collection, References};
use class::verify::documents::ComparedWith;
use class::verify::hand_in;
use desk::Desk;
use document::page::Source;
use saved::hand_in::{HandIn, Sender};
use saved::project::Project;
use units::Language;

/// Work of seat 7 with this document, as its page hands it in, with an answer that is far off.
fn handed(name: &str, document: &[Source]) -> HandIn {
    let mut desk = Desk::open(document::open(&document[0].text, &[]).sound().unwrap());
    desk.play_mut().set_seat("7").unwrap();
    desk.play_mut().change_answers(|answers, run| answers.check(run, 0, "5"));
    let sender = Sender { name: name.to_owned(), seat: Some(7), assignment: "tube-2026".to_owned() };
    let work =
        Project { documents: document.to_vec(), state: "1&seat=7".to_owned(), items: desk::project_items(&desk, 5) };
    hand_in(work, sender, 6).unwrap()
}

fn changed(from: &str, to: &str) -> Vec<Source> {
    let mut document = lesson();
    assert!(document[0].text.contains(from), "{from}");
    document[0].text = document[0].text.replace(from, to);
    document
}

fn computed(references: Option<References>, hand_ins: &[HandIn]) -> Collection {
    let mut class = Collection::new(Language::English);
    references.into_iter().for_each(|references| class.set_references(references));
    for (index, one) in hand_ins.iter().enumerate() {
        class.add(&format!("{index}.hand-in"), Ok(one.clone()));
    }
    while class.advance() {}
    class
}

fn lines(class: &Collection, index: usize) -> String {
    class::page::state_lines(&class.entries()[index], class, Language::English).join("\n")
}

#[test]
fn a_changed_tolerance_or_word_is_named_and_counts_by_the_teachers_document() {
    for (from, to, line) in [
        (
            "within 2 %",
            "within 5000 %",
            "lesson.md, line 24: \"answer: omega_0 within 5000 %\" instead of \"answer: omega_0 within 2 %\"",
        ),
        ("hidden parameter", "parameter", "\"parameter gamma"),
        ("answer: omega_0 within 2 %", "answer: 5 [rad/s] within 2 %", "instead of \"answer: omega_0"),
    ] {
        let hand_ins = [handed("forged", &changed(from, to)), handed("honest", &lesson())];
        let class = computed(Some(References::given(vec![lesson()])), &hand_ins);
        let text = lines(&class, 0);
        assert!(
            text.contains("its document differs from the given one; lines that differ: 1") && text.contains(line),
            "{text}"
        );
        assert_eq!(class.entries()[1].document(), None);
        assert_eq!(class.questions().iter().map(|tally| tally.found.count).collect::<Vec<_>>(), [0, 0], "{from}");
        // Without the teacher's document it stands out among three.
        let others = [handed("a", &lesson()), handed("forged", &changed(from, to)), handed("b", &lesson())];
        let class = computed(None, &others);
        assert!(lines(&class, 1).contains("from that of 2 other hand-ins"), "{}", lines(&class, 1));
        assert!(class.entries()[0].document().is_none() && class.entries()[2].document().is_none());
    }
}

#[test]
fn other_documents_and_line_ends() {
    let mut windows = lesson();
    windows[0].text = format!("\u{feff}{}", windows[0].text.replace('\n', "\r\n"));
    let other = vec![Source {
        name: "other.md".to_owned(),
        text: "---\nassignment: tube-2026\n---\n```model\nparameter a = 1 in 0..3 assigned 1..2 step 0.1\nx' = a\nx(0) = 0\n```\n\n```question\nA?\nanswer: a within 1 %\n```\n".to_owned(),
    }];
    let hand_ins = [handed("a", &windows), handed("b", &lesson()), handed("c", &other)];
    let class = computed(Some(References::given(vec![lesson()])), &hand_ins);
    assert!(class.entries()[0].document().is_none() && class.entries()[1].document().is_none());
    assert!(lines(&class, 2).contains("none of the given documents"));
    // Without a given one, another lesson is no form of this one.
    let class = computed(None, &hand_ins);
    assert!(class.entries().iter().all(|entry| entry.document().is_none()));
    // The document that is open counts only if a hand-in has its text.
    for (open, expected) in [(lesson(), true), (changed("Moon", "Mars"), false)] {
        let mut class = Collection::new(Language::English);
        class.offer_document(open);
        for (index, one) in
            [handed("a", &lesson()), handed("b", &changed("within 2 %", "within 9 %"))].into_iter().enumerate()
        {
            class.add(&index.to_string(), Ok(one));
        }
        while class.advance() {}
        let with = class.entries()[1].document().map(|difference| difference.with.clone());
        assert_eq!(with == Some(ComparedWith::Teacher), expected, "{with:?}");
    }
}
