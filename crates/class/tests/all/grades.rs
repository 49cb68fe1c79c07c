//! Grades in hand-ins: they follow from the values of each attempt and of the seat, and stated ones are compared with them.

use crate::support::lesson;
use class::collection::Collection;
use class::verify::{hand_in, verify};
use desk::Desk;
use desk::play::Grade;
use document::page::Source;
use saved::hand_in::{HandIn, Part, Sender};
use saved::project::Project;
use units::Language;

fn index(desk: &Desk, name: &str) -> usize {
    desk.play().model().parameters.iter().position(|one| one.name == name).unwrap()
}

fn set(desk: &mut Desk, name: &str, value: f64) {
    let index = index(desk, name);
    desk.play_mut().change_settings(|settings| settings.set_parameter(index, value)).unwrap();
}

fn check(desk: &mut Desk, question: usize, typed: &str) -> Grade {
    desk.play_mut().change_answers(|answers, run| answers.check(run, question, typed)).grade
}

fn handed(desk: &Desk, documents: Vec<Source>, name: &str) -> HandIn {
    let seat = desk.play().basis().seat().unwrap();
    let sender = Sender { name: name.to_owned(), seat: seat.number, assignment: seat.assignment };
    let work = Project { documents, state: desk.play().share(), items: desk::project_items(desk, 5) };
    HandIn::read(&hand_in(work, sender, 6).unwrap().write()).unwrap()
}

/// Orders of answer, slider and preset; the work of a seat as its page grades it.
#[test]
fn honest_work_in_every_order_holds_and_is_graded_as_the_student_saw_it() {
    let steps: [fn(&mut Desk); 6] = [
        |desk| set(desk, "L", 0.6),
        |desk| set(desk, "g", 5.0),
        |desk| desk.play_mut().change_settings(|settings| settings.apply_preset(0)).unwrap(),
        |desk| {
            check(desk, 0, "7.1");
        },
        |desk| {
            check(desk, 1, "0,55 ± 0,01");
        },
        |desk| {
            desk.play_mut().change_answers(|answers, run| answers.reveal(run, 1));
        },
    ];
    for order in 0..60_usize {
        let mut desk = Desk::open(document::open(&lesson()[0].text, &[]).sound().unwrap());
        desk.play_mut().set_seat(&(order % 9 + 1).to_string()).unwrap();
        desk.play_mut().set_language(["en", "es"][order % 2]);
        let mut left: Vec<usize> = (0..6).collect();
        let mut rest = order * 7919;
        while !left.is_empty() {
            let next = left.remove(rest % left.len());
            rest = rest / 3 + 17;
            steps[next](&mut desk);
        }
        let made = handed(&desk, lesson(), "honest");
        let verdict = verify(&made).unwrap();
        assert!(verdict.holds() && verdict.unknown == 0, "{order}: {:?}", verdict.lines(Language::English));
        let mut class = Collection::new(Language::Portuguese);
        class.add("a.hand-in", Ok(made));
        while class.advance() {}
        let (_, work) = class.works().next().unwrap();
        for question in 0..2 {
            let seen = desk.play().answers().answer(desk.play().basis(), question);
            let counted = &work.answers[question];
            let grades =
                |attempts: &[desk::play::GradedAttempt]| attempts.iter().map(|one| one.grade()).collect::<Vec<_>>();
            assert_eq!(grades(&counted.attempts), grades(&seen.attempts), "{order}");
            assert_eq!(counted.found, seen.found, "{order}");
        }
    }
}

fn seated() -> Desk {
    let mut desk = Desk::open(document::open(&lesson()[0].text, &[]).sound().unwrap());
    desk.play_mut().set_seat("7").unwrap();
    desk
}

/// Changes that a forger makes; each is named by its place.
#[test]
fn forged_grades_values_looks_and_seats_are_named() {
    let mut desk = seated();
    check(&mut desk, 0, "5");
    desk.play_mut().change_answers(|answers, run| answers.reveal(run, 0));
    check(&mut desk, 0, "7.1");
    let honest = handed(&desk, lesson(), "honest");
    assert!(verify(&honest).unwrap().holds());
    let item = |from: &str, to: &str| {
        let mut changed = honest.clone();
        let text = &mut changed.work.items[0].1;
        assert!(text.contains(from), "{from}: {text}");
        *text = text.replacen(from, to, 1);
        changed
    };
    let sender = |seat, assignment: &str| {
        let mut changed = honest.clone();
        (changed.sender.seat, changed.sender.assignment) = (seat, assignment.to_owned());
        changed
    };
    let mut other_state = honest.clone();
    other_state.work.state = "1&seat=8".to_owned();
    let cases = [
        (item("\"grade\":\"wrong\"", "\"grade\":\"correct\""), "given:1"),
        (item("\"typed\":\"5\"", "\"typed\":\"7.1\""), "attempt:1"),
        (item("\"shown\":1", "\"shown\":2"), "shown"),
        (item("[\"g\",9.81]", "[\"g\",4.9]"), "conditions:1"),
        (sender(Some(3), "tube-2026"), "seat"),
        (sender(None, "tube-2026"), "seat"),
        (sender(Some(7), "other"), "assignment"),
        (other_state, "seat"),
    ];
    for (forged, place) in cases {
        let verdict = verify(&forged).unwrap();
        assert!(!verdict.holds());
        assert!(verdict.differences.iter().any(|one| one.quantity == place), "{place}: {:?}", verdict.differences);
    }
    // A grade that is stated in the facts, too, is shown beside the computed one.
    let mut graded = item("\"grade\":\"wrong\"", "\"grade\":\"correct\"");
    let fact = graded.facts.iter_mut().find(|fact| fact.part == Part::Answer && fact.quantity == "given:1").unwrap();
    fact.value = saved::hand_in::FactValue::Text("correct".to_owned());
    let verdict = verify(&graded).unwrap();
    assert!(verdict.differences.is_empty() && !verdict.holds());
    let expected = "question 1, attempt 1: stated \"right\", computed \"wrong\"";
    assert_eq!(verdict.lines(Language::English).last().map(String::as_str), Some(expected));
}

/// Answers of version 0.2.0 have no values. They keep the grades that the page gave, and that is said.
#[test]
fn answers_of_version_0_2_0_count_as_stated() {
    let mut desk = Desk::open(document::open(&lesson()[0].text, &[]).sound().unwrap());
    desk.play_mut().set_seat("7").unwrap();
    check(&mut desk, 0, "7.1");
    let mut made = handed(&desk, lesson(), "old");
    made.version = 1;
    (made.program, made.bits) = ("0.2.0".to_owned(), None);
    made.work.state = "1&seat=7&p=g:20".to_owned();
    made.work.items[0].1 =
        r#"{"meniscus":3,"since":5,"item":{"answer":{"typed":"7.1","grade":"correct","attempts":[{"typed":"7.1","grade":"correct"}]}}}"#
            .to_owned();
    let fact = |part, item: &str, quantity: &str, value| saved::hand_in::Fact {
        part,
        item: item.to_owned(),
        quantity: quantity.to_owned(),
        value: saved::hand_in::FactValue::Text(String::from(value)),
    };
    made.facts
        .retain(|fact| ["document", "value:t", "value:y", "value:y'", "parameter:L"].contains(&fact.quantity.as_str()));
    for fact in &mut made.facts {
        fact.quantity = fact.quantity.replace("value:", "").replace("parameter:", "parameter ");
    }
    let gravity = made.facts.iter().find(|fact| fact.quantity == "parameter L").unwrap().clone();
    made.facts.push(saved::hand_in::Fact {
        quantity: "parameter g".to_owned(),
        value: saved::hand_in::FactValue::Number(saved::Number(20.0)),
        ..gravity
    });
    let question = "question 1";
    made.facts.extend([
        fact(Part::Answer, question, "text", "7.1"),
        fact(Part::Answer, question, "grade given", "correct"),
        fact(Part::Answer, question, "grade", "wrong"),
        fact(Part::Answer, question, "attempt 1", "7.1"),
        fact(Part::Answer, question, "grade given to attempt 1", "correct"),
        fact(Part::Answer, question, "grade of attempt 1", "wrong"),
    ]);
    let verdict = verify(&HandIn::read(&made.write()).unwrap()).unwrap();
    assert!(verdict.holds(), "{:?}", verdict.lines(Language::English));
    assert_eq!(verdict.unknown, 1);
    let mut class = Collection::new(Language::English);
    class.add("a.hand-in", Ok(made));
    while class.advance() {}
    assert_eq!(class.questions()[0].found.count, 1);
}
