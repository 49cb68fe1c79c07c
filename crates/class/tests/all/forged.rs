//! Forged hand-ins: documents, tolerances, seats, flags, attempts, reports and times. Each is named by its place.

use crate::support::{check, handed, lesson, linear, measured, of_seat, report, seated, set, with_film};
use class::collection::{Collection, References};
use class::page::state_lines;
use desk::Desk;
use desk::play::Grade;
use document::page::Source;
use saved::hand_in::{FactValue, HandIn, Part};
use saved::{Item, Number};
use units::Language;

/// Work of a student: a wrong answer, a look, a right one, two answers to the other question, a kept run.
fn work(documents: &[Source]) -> Desk {
    let mut desk = seated(documents, "7");
    check(&mut desk, 0, "5");
    desk.play_mut().change_answers(|answers, run| answers.reveal(run, 0));
    check(&mut desk, 0, "7.1");
    set(&mut desk, "g", 5.0);
    check(&mut desk, 1, "0.9");
    check(&mut desk, 1, "0.1");
    desk.play_mut().change_run(|line, _| line.play());
    desk.play_mut().change_run(|line, _| line.tick(0.5));
    desk.play_mut().change_run(|line, _| line.pause());
    desk.play_mut().change_run(|line, basis| line.keep(basis)).unwrap();
    desk
}

/// Lines about a file, in a class with this document of the teacher; true if it holds.
fn lines(teachers: Vec<Source>, file: &[u8]) -> (Vec<String>, bool) {
    let mut class = Collection::new(Language::English);
    class.set_references(References::given(vec![teachers]));
    class.add("forged.hand-in", HandIn::open(file));
    while class.advance() {}
    let entry = &class.entries()[0];
    let holds = class.works().all(|(_, work)| work.verdict.holds()) && entry.document().is_none();
    (state_lines(entry, &class, Language::English), holds)
}

/// Checks that a forged file is found and named by a line with this text; counts it.
fn is_named(count: &mut usize, teachers: &[Source], file: &str, place: &str) {
    let (lines, holds) = lines(teachers.to_vec(), file.as_bytes());
    assert!(!holds && lines.iter().any(|line| line.contains(place)), "{place}: {lines:#?}");
    *count += 1;
}

/// Copy with a text in the items replaced once.
fn item(honest: &HandIn, from: &str, to: &str) -> HandIn {
    let mut changed = honest.clone();
    let text = changed.work.items.iter_mut().map(|(_, text)| text).find(|text| text.contains(from));
    let text = text.unwrap_or_else(|| panic!("{from}: {:?}", honest.work.items));
    *text = text.replacen(from, to, 1);
    changed
}

/// Copy with a stated value replaced.
fn fact(honest: &HandIn, quantity: &str, value: FactValue) -> HandIn {
    let mut changed = honest.clone();
    changed.facts.iter_mut().find(|fact| fact.quantity == quantity).unwrap().value = value;
    changed
}

fn text(text: &str) -> FactValue {
    FactValue::Text(text.to_owned())
}

/// The work was done with another document, and everything in the hand-in follows from it.
fn documents(count: &mut usize) {
    for (from, to, place) in [
        ("within 2 %", "within 5000 %", "line 24: \"answer: omega_0 within 5000 %\""),
        ("within 5 %", "within 9 [1/s]", "within 9 [1/s]"),
        ("hidden parameter", "parameter", "\"parameter gamma"),
        ("answer: omega_0 within", "answer: 5 [rad/s] within", "instead of \"answer: omega_0"),
        ("assigned 20..60", "assigned 30..60", "assigned 30..60"),
        ("attempts: 3", "attempts: 50", "\"attempts: 50\" instead of \"attempts: 3\""),
        ("attempts: 3\n", "", "attempts: 3"),
        ("2*gamma*y'", "0.1*gamma*y'", "0.1*gamma*y'"),
        ("answer: omega_0", "set: L = 50 [cm]\nanswer: omega_0", "set: L = 50 [cm]"),
    ] {
        let mut document = lesson();
        assert!(document[0].text.contains(from), "{from}");
        document[0].text = document[0].text.replacen(from, to, 1);
        is_named(count, &lesson(), &of_seat(&work(&document), document, "forged").write(), place);
    }
    // Another document than the one of which the work is.
    let mut other = of_seat(&work(&lesson()), lesson(), "forged");
    other.work.documents[0].text = other.work.documents[0].text.replace("Measure the", "Guess the");
    is_named(count, &lesson(), &other.write(), "text of the document");
}

fn seats(count: &mut usize, honest: &HandIn) {
    let sender = |seat, assignment: &str| {
        let mut changed = honest.clone();
        (changed.sender.seat, changed.sender.assignment) = (seat, assignment.to_owned());
        changed
    };
    let mut state = honest.clone();
    state.work.state = state.work.state.replace("seat=7", "seat=8");
    // Everything that names the seat says another one.
    let mut whole = fact(&state, "seat", FactValue::Number(Number(8.0)));
    whole.sender.seat = Some(8);
    for (forged, place) in [
        (sender(Some(3), "tube-2026"), "seat: stated 3, computed 7"),
        (sender(None, "tube-2026"), "seat: stated nothing"),
        (sender(Some(7), "other"), "assignment"),
        (state, "seat: stated 7, computed 8"),
        (whole, "parameter L"),
    ] {
        is_named(count, &lesson(), &forged.write(), place);
    }
}

fn flags_and_attempts(count: &mut usize, honest: &HandIn) {
    let attempt = "{\"typed\":\"5\",\"grade\":\"wrong\",\"language\":\"en\",\"values\":[[\"g\",9.81]]}";
    let right = attempt.replace("\"5\"", "\"7.1\"").replace("wrong", "correct");
    let mut graded = item(honest, "\"grade\":\"wrong\",\"language\"", "\"grade\":\"correct\",\"language\"");
    graded = fact(&graded, "given:1", text("correct"));
    let shown = "attempts before the right answer was shown";
    for (forged, place) in [
        // Looks at the answer.
        (item(honest, "\"shown\":1", "\"shown\":2"), shown),
        (item(honest, "\"shown\":1,\"revealed\":true,", ""), shown),
        (item(honest, "\"shown\":1,\"revealed\":true", "\"revealed\":true,\"found\":true"), shown),
        (fact(honest, "shown", FactValue::Number(Number(2.0))), shown),
        // Grades.
        (
            item(honest, "\"grade\":\"wrong\",\"language\"", "\"grade\":\"correct\",\"language\""),
            "grade given to attempt 1",
        ),
        (fact(honest, "grade:1", text("correct")), "grade of attempt 1"),
        (graded, "question 1, attempt 1: stated \"right\", computed \"wrong\""),
        // Attempts with their conditions.
        (item(honest, "\"typed\":\"5\"", "\"typed\":\"7.1\""), "attempt 1"),
        (item(honest, "[\"g\",9.81]", "[\"g\",4.9]"), "values at attempt 1"),
        (item(honest, "\"language\":\"en\"", "\"language\":\"es\""), "values at attempt 1"),
        (item(honest, &format!("{attempt},"), ""), "attempt 2"),
        (item(honest, attempt, &format!("{right},{attempt}")), "attempt 3"),
        (item(honest, attempt, &right), "grade given to attempt 1"),
        (fact(honest, "attempt:2", text("7.2")), "attempt 2"),
        (fact(honest, "made", FactValue::Number(Number(1.0))), "attempts made"),
        (fact(honest, "allowed", FactValue::Number(Number(9.0))), "attempts allowed"),
    ] {
        is_named(count, &lesson(), &forged.write(), place);
    }
    let mut left_out = honest.clone();
    left_out.facts.retain(|fact| fact.quantity != "shown");
    is_named(count, &lesson(), &left_out.write(), shown);
}

fn times_and_values(count: &mut usize, honest: &HandIn) {
    let rows = measured(3);
    let measured = with_film(handed(&rows, "forged"), &rows);
    let time = |honest: &HandIn| honest.facts.iter().filter(|fact| fact.quantity == "value:t").count();
    assert_eq!(time(honest), 2, "of the run and of the kept one");
    let mut kept = honest.clone();
    kept.facts.iter_mut().rev().find(|fact| fact.quantity == "value:t").unwrap().value =
        FactValue::Number(Number(0.75));
    let film = item(&measured, "[0,[0.0,", "[0,[0.01,");
    for (teachers, forged, place) in [
        (lesson(), fact(honest, "value:t", FactValue::Number(Number(0.75))), "run \"The damped tube\", t: "),
        (lesson(), kept, ", t: stated 0.75"),
        (lesson(), fact(honest, "parameter:g", FactValue::Number(Number(9.81))), "parameter g"),
        (linear(), item(&measured, "t [s],y [m]", "t [ms],y [m]"), "record \"tube.csv\", content"),
        (linear(), film, "film \"tube.mp4\""),
        (linear(), fact(&measured, "value:gamma", FactValue::Number(Number(0.3))), "gamma: stated 0.3"),
        (linear(), fact(&measured, "stderr:value:gamma", FactValue::Number(Number(1e-9))), "standard error of gamma"),
    ] {
        is_named(count, &teachers, &forged.write(), place);
    }
}

fn reports(count: &mut usize) {
    let page = report(&measured(5));
    for (from, to, place) in [
        ("</style>", "td { display: none }</style>", "style sheet"),
        ("</head>", "<script>document.title = 1</script></head>", "element that Meniscus does not write"),
        ("<body>", "<h1>g = 10.50</h1><body>", "head of the page"),
        ("<section id=\"hand-in\">", "<section id=\"hand-in\"><h1>g = 10.50</h1>", "report \"g = 10.50\""),
        ("<h2", "<p>g = 10.50</p><h2", "report \""),
    ] {
        assert!(page.contains(from), "{from}");
        is_named(count, &linear(), &page.replacen(from, to, 1), place);
    }
}

#[test]
fn forty_forged_hand_ins_are_named_by_their_places() {
    let honest = of_seat(&work(&lesson()), lesson(), "honest");
    let (said, holds) = lines(lesson(), honest.write().as_bytes());
    assert!(holds && said.len() == 1, "{said:?}");
    let mut count = 0;
    documents(&mut count);
    seats(&mut count, &honest);
    flags_and_attempts(&mut count, &honest);
    times_and_values(&mut count, &honest);
    reports(&mut count);
    assert!(count >= 40, "{count}");
}

/// Attempts beyond the limit are no forgery, since two devices of a student can make them. They do not count, and that is said.
#[test]
fn attempts_beyond_the_limit_do_not_count() {
    let first = work(&lesson());
    let mut second = seated(&lesson(), "7");
    let wrong = ["0.01", "0.02"].map(|typed| check(&mut second, 1, typed));
    let right = second.play().answers().right_text(second.play().basis(), second.play().course(), 1);
    assert_eq!(check(&mut second, 1, &right), Grade::Correct);
    desk::merge_project_items(&mut second, &desk::project_items(&first, 5));
    let given = second.play().answers().answer(second.play().basis(), 1);
    assert_eq!((given.limit.map(|limit| (limit.made, limit.left())), given.found), (Some((5, 0)), false), "{wrong:?}");
    let made = of_seat(&second, lesson(), "two devices");
    assert!(made.work.items.iter().all(|(_, text)| Item::read(text).is_some()));
    assert!(made.facts.iter().any(|fact| fact.part == Part::Answer && fact.quantity == "made"));
    let (said, holds) = lines(lesson(), made.write().as_bytes());
    assert!(holds, "{said:?}");
    assert_eq!(said[1], "question 2: 5 attempts, of which only the first 3 count");
}
