//! Grades in hand-ins of version 0.2.0, which lack the values of each attempt.

use crate::support::{check, lesson, of_seat, seated};
use class::collection::Collection;
use class::verify::verify;
use saved::hand_in::{HandIn, Part};
use units::Language;

/// Answers of version 0.2.0 have no values. They keep the grades that the page gave, and that is said.
#[test]
fn answers_of_version_0_2_0_count_as_stated() {
    let mut desk = seated(&lesson(), "7");
    check(&mut desk, 0, "7.1");
    let mut made = of_seat(&desk, lesson(), "old");
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
