//! Edits of questions.

use document::edit::{EditError, NewQuestion, Obstacle, add_question, apply, remove_question, set_question};
use document::{QuestionPart, asked, open, possible_answers, read};

const DOCUMENT: &str = "---\ntitle: A\nlanguage: en\n---\n```model\nparameter k = 4 [N/m]\nparameter m = 1 [kg]\nm*x'' = -k*x\nx(0) = 1 [m]\nx'(0) = 0 [m/s]\nT = 2*pi*sqrt(m/k) \"Period\"\nhidden w = 1/T\nE = k*x^2\n```\n\n```question\nHow long?\n\nset: k = 9 [N/m]\nhide: T\nanswer: T within 2 %\nhint: Count.\n```\n";

fn new(prompt: &str, answer: &str, hint: &str) -> NewQuestion {
    let text = str::to_owned;
    NewQuestion {
        prompt: text(prompt),
        answer: text(answer),
        percent: text("3"),
        hides: true,
        follows: false,
        hint: text(hint),
    }
}

#[test]
fn questions_are_read_as_they_are_written() {
    let found = asked(&read(DOCUMENT));
    let one = &found[0];
    assert_eq!(found.len(), 1);
    assert_eq!(
        [&one.prompt, &one.set, &one.hide, &one.answer, &one.hint, &one.explanation],
        ["How long?", "k = 9 [N/m]", "T", "T within 2 %", "Count.", ""]
    );
    assert!(DOCUMENT[one.place.range()].starts_with("How long?"));
}

#[test]
fn what_the_model_computes_from_parameters_can_be_an_answer() {
    let program = open(DOCUMENT, &[]).document.unwrap().program;
    let found = possible_answers(&read(DOCUMENT), &program);
    assert_eq!(found, [("T".to_owned(), Some("Period".to_owned()))]);
}

/// The fix of a wrong reference works.
#[test]
fn a_question_waits_for_earlier_ones() {
    let model = "```model\nparameter a = 1\ny' = a*1 [1/s]\ny(0) = 0\n```\n";
    let question = |after: &str| format!("```question\nQ\n{after}answer: a within 1 %\n```\n");
    let text = |third: &str| [model, &question(""), &question("after: previous\n"), &question(third)].concat();
    let after = |third: &str| {
        let opened = document::open(&text(third), &[]);
        let errors: Vec<_> = opened.diagnostics.iter().map(|(_, found)| found.message.english()).collect();
        (opened.document.unwrap().program.questions.pop().unwrap().after, errors)
    };
    assert_eq!(after("after: previous\n"), (vec![1], vec![]));
    assert_eq!(after("after: 1, 2, 1\n"), (vec![0, 1], vec![]));
    for (wrong, named) in [("3", "3"), ("0", "0"), ("later", "later"), ("-1", "-1"), ("1 2", "1 2"), ("", "")] {
        let (_, errors) = after(&format!("after: {wrong}\n"));
        assert_eq!(errors, [format!("there is no question `{named}` before this one")], "{wrong}");
        let wrong = text(&format!("after: {wrong}\n"));
        let opened = document::open(&wrong, &[]);
        let mended = document::edit::apply(&wrong, &opened.diagnostics[0].1.fixes[0].edits).unwrap();
        assert_eq!(document::open(&mended, &[]).diagnostics, [], "{mended}");
    }
    let first = document::open(&[model, &question("after: previous\n")].concat(), &[]);
    assert!(first.diagnostics[0].1.fixes.is_empty() && first.diagnostics.len() == 1);
    // A question does not depend on one that has errors.
    let faulty = text("after: 2\n").replacen("after: previous\nanswer: a", "after: previous\nanswer: b", 1);
    let opened = document::open(&faulty, &[]).document.unwrap();
    let questions: Vec<_> = opened.program.questions.iter().map(|question| question.after.clone()).collect();
    assert_eq!(questions, [Vec::<usize>::new(), Vec::new()]);
}

#[test]
fn a_question_is_added_behind_the_last_and_works() {
    let edit = add_question(&read(DOCUMENT), &new("Again?", "T", "Twice.")).unwrap();
    let text = apply(DOCUMENT, &[edit]).unwrap();
    let added = "\n```question\nAgain?\n\nhide: T\nanswer: T within 3 %\nhint: Twice.\n```\n";
    assert_eq!(text, format!("{DOCUMENT}{added}"));
    let opened = open(&text, &[]);
    assert!(opened.diagnostics.is_empty(), "{:?}", opened.diagnostics);
    assert_eq!(opened.document.unwrap().program.questions.len(), 2);
    for wrong in [new("a\nhint: b", "T", ""), new("a", "T\nhint: c", ""), new("a", "T", "b\n```")] {
        let refused = add_question(&read(DOCUMENT), &wrong);
        assert!(
            matches!(
                refused,
                Err(EditError::NotOneCell(Obstacle::Mark(_) | Obstacle::LineEnd) | EditError::ChangesOthers)
            ) || refused.is_ok_and(|edit| { asked(&read(&apply(DOCUMENT, &[edit]).unwrap())).len() == 2 })
        );
    }
}

/// Edits of each part of the only question of [`DOCUMENT`], and the expected content of its block.
#[test]
fn each_part_of_a_question_is_written_in_its_place() {
    use QuestionPart::{After, Answer, Explanation, Hide, Hint, Prompt, Set};
    let block = |text: &str| text.split("```question\n").nth(1).unwrap().trim_end_matches("```\n").to_owned();
    let own = block(DOCUMENT);
    for (part, text, expected) in [
        (Prompt, "How long is it?\n\nCount.", own.replace("How long?", "How long is it?\n\nCount.")),
        (Answer, "2*T within 0.1 [s]", own.replace("T within 2 %", "2*T within 0.1 [s]")),
        (Hint, "", own.replace("hint: Count.\n", "")),
        (Explanation, "So it is.", format!("{own}explanation: So it is.\n")),
        (Hide, " T, w ", own.replace("hide: T", "hide: T, w")),
        (Set, "k = 9 [N/m]", own.clone()),
        (After, "previous", format!("{own}after: previous\n")),
    ] {
        let edits = set_question(&read(DOCUMENT), 0, part, text).unwrap();
        let text = apply(DOCUMENT, &edits).unwrap();
        assert_eq!(block(&text), expected, "{part:?}");
    }
    let asked_in = |text: &str| asked(&read(text));
    let refused = |part, text| set_question(&read(DOCUMENT), 0, part, text).unwrap_err();
    assert_eq!(refused(Hint, "a\nanswer: b"), EditError::NotOneCell(Obstacle::Mark("answer:".to_owned())));
    assert!(matches!(refused(Prompt, "a\n```"), EditError::NotOneCell(_) | EditError::ChangesOthers));
    assert_eq!(set_question(&read(DOCUMENT), 1, Hint, "a"), Err(EditError::UnknownCell));
    assert_eq!(asked_in(DOCUMENT).len(), 1);
}

/// References between questions before and after one of four is removed.
#[test]
fn a_removed_question_leaves_its_translation_and_later_questions_wait_for_those_that_are_left() {
    let question = |name: &str, after: &str| {
        let after = if after.is_empty() { String::new() } else { format!("after: {after}\n") };
        format!("```question\n{name}\n\n{after}answer: a within 1 %\n```\n\n")
    };
    for (removed, before, expected) in [
        (0, ["", "previous", "1, 2", "3"], vec!["", "1", "2"]),
        (1, ["", "previous", "2", "1, 2, 3"], vec!["", "", "1, 2"]),
        (3, ["", "previous", "1, 2", "3"], vec!["", "previous", "1, 2"]),
    ] {
        let names = ["A", "B", "C", "D"];
        let of =
            |all: &[&str; 4]| -> String { names.iter().zip(all).map(|(name, after)| question(name, after)).collect() };
        let text = format!("```model\nparameter a = 1\n```\n\n{}End.\n", of(&before));
        let translation = "---\ntranslates: a.md\n---\n\n```question\nUna\n```\n\n```question\nDos\n```\n";
        let edits = remove_question(&read(&text), removed, &[translation]).unwrap();
        let (text, translation) = (apply(&text, &edits[0]).unwrap(), apply(translation, &edits[1]).unwrap());
        let left = asked(&read(&text));
        let after: Vec<&str> = left.iter().map(|one| one.after.as_str()).collect();
        assert_eq!(after, expected, "{removed}: {text}");
        assert!(!text.contains("\n\n\n"), "{text}");
        let translated: Vec<String> = asked(&read(&translation)).into_iter().map(|one| one.prompt).collect();
        let expected: &[&str] = [&["Dos"][..], &["Una"], &[], &["Una", "Dos"]][removed];
        assert_eq!(translated, expected, "{translation}");
    }
    assert_eq!(remove_question(&read(DOCUMENT), 1, &[]), Err(EditError::UnknownCell));
}

#[test]
fn a_question_may_limit_its_attempts() {
    let limited = |attempts: &str| DOCUMENT.replace("hint: Count.", &format!("attempts:{attempts}\nhint: Count."));
    let opened = open(&limited(" 3"), &[]);
    assert_eq!(opened.diagnostics, []);
    assert_eq!(opened.document.unwrap().program.questions[0].attempts, Some(3));
    assert_eq!(open(DOCUMENT, &[]).document.unwrap().program.questions[0].attempts, None);
    for wrong in ["", " ", " 0", " 51", " -1", " 2.5", " three", " 3, 4", " 99999999999"] {
        let opened = open(&limited(wrong), &[]);
        let messages: Vec<_> = opened.diagnostics.iter().map(|(_, found)| found.message.english()).collect();
        assert_eq!(messages, ["the number of attempts is a whole number from 1 to 50"], "{wrong}");
    }
    let edits = set_question(&read(DOCUMENT), 0, QuestionPart::Attempts, "2").unwrap();
    let text = edits.iter().fold(DOCUMENT.to_owned(), |text, edit| {
        [&text[..edit.span.start], &edit.text, &text[edit.span.end..]].concat()
    });
    assert_eq!(asked(&read(&text))[0].attempts, "2");
}
