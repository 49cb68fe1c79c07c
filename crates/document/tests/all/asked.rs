//! Questions as they are written, and further ones.

use document::edit::{EditError, NewQuestion, add_question, apply};
use document::{asked, open, possible_answers, read};

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

/// The remedy of a wrong reference works.
#[test]
fn a_question_waits_for_earlier_ones() {
    let model = "```model\nparameter a = 1\ny' = a*1 [1/s]\ny(0) = 0\n```\n";
    let question = |after: &str| format!("```question\nQ\n{after}answer: a within 1 %\n```\n");
    let text = |third: &str| [model, &question(""), &question("after: previous\n"), &question(third)].concat();
    let after = |third: &str| {
        let opened = document::open(&text(third), &[]);
        let errors: Vec<_> = opened.diagnostics.iter().map(|(_, found)| found.message.english.clone()).collect();
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
    // A question that has errors is not waited for.
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
            matches!(refused, Err(EditError::NotOneCell | EditError::ChangesOthers))
                || refused.is_ok_and(|edit| { asked(&read(&apply(DOCUMENT, &[edit]).unwrap())).len() == 2 })
        );
    }
}
