//! Grades follow from the values under which an answer was given, and from those of the seat.

use crate::support::{open, parameter, set};
use play::{Answer, Conditions, Grade, Play};

/// The right answers: omega_0 = sqrt(2 g/L), gamma, and omega_0 with L = 10 cm and twice the gravity.
const LESSON: &str = r#"---
title: A tube
assignment: tube-2026
---

```model
parameter L = 40 [cm] in 10..90 assigned 20..60 step 0.5 "Length"
hidden parameter gamma = 0.3 [1/s] in 0..20 assigned 0.2..0.9 step 0.05 "Damping"
parameter g = 9.81 [m/s^2] in 0..30 "Gravity"
parameter y_0 = 5 [cm] in 0..10 "Start"
y'' + 2*gamma*y' + 2*g/L*y = 0
y(0) = y_0 "Level"
y'(0) = 0
omega_0 = sqrt(2*g/L) in [rad/s] "Angular frequency"
```

```presets
"Moon": g = 1.62 [m/s^2]
```

```question
Angular frequency?
answer: omega_0 within 2 %
```

```question
Damping?
answer: gamma within 5 %
```

```question
Angular frequency of a short tube with twice the gravity?
set: L = 10 [cm], g = 2*g
answer: omega_0 within 2 %
```

```question
Height of the start?
answer: 2*y(0) in [cm] within 1 %
```
"#;

fn lesson() -> Play {
    open(LESSON, &[])
}

fn check(play: &mut Play, question: usize, typed: &str) -> Grade {
    play.change_answers(|answers, run| answers.check(run, question, typed)).grade
}

/// Grades of the attempts: stated and computed.
fn grades(play: &Play, question: usize) -> Vec<(Grade, Option<Grade>)> {
    let attempts = play.answers().answer(play.basis(), question).attempts;
    attempts.into_iter().map(|attempt| (attempt.stated, attempt.computed)).collect()
}

/// A later visit: the stored answers in a fresh simulation with this state.
fn later(play: &Play, state: &str) -> Play {
    let mut later = lesson();
    later.restore(state).unwrap();
    for (name, answer) in play.answers().saved(play.basis()) {
        let answer = Answer::of_lines(&answer.lines()).unwrap();
        assert!(later.change_answers(|answers, run| answers.restore(run, &name, &answer)));
    }
    later
}

#[test]
fn what_moves_after_an_answer_changes_no_grade() {
    use Grade::{Correct, Wrong};
    let mut play = lesson();
    set(&mut play, "y_0", 0.03);
    assert_eq!((check(&mut play, 3, "6"), check(&mut play, 3, "10")), (Correct, Wrong));
    set(&mut play, "g", 5.0);
    assert_eq!(check(&mut play, 0, "5"), Correct);
    let expected = [(0, vec![(Correct, Some(Correct))]), (3, vec![(Correct, Some(Correct)), (Wrong, Some(Wrong))])];
    let score = play.answers().score(play.basis());
    let changes: [fn(&mut Play); 4] = [
        |play| set(play, "g", 20.0),
        |play| play.change_settings(|settings| settings.apply_preset(0)).unwrap(),
        |play| play.change_settings(|settings| settings.restore_defaults()),
        |play| set(play, "y_0", 0.09),
    ];
    for change in changes {
        change(&mut play);
        for (question, grades_of) in &expected {
            for play in [&play, &later(&play, &play.share())] {
                assert_eq!(grades(play, *question), *grades_of);
                assert_eq!(play.answers().score(play.basis()), score);
            }
        }
    }
    assert_eq!(score, Some(0.5));
}

/// Seat 7 has L = 39 cm: 7.092 1/s is right, and 5.718 1/s would be for 60 cm.
#[test]
fn assigned_values_are_those_of_the_seat_whatever_a_slider_says() {
    let mut play = lesson();
    play.set_seat("7").unwrap();
    let names = |play: &Play, question| {
        let setup = play.answers().setup(play.basis(), play.course(), question);
        setup.map(|(values, is_set)| (values.into_iter().map(|(name, _)| name).collect::<Vec<_>>().join(" "), is_set))
    };
    assert_eq!(names(&play, 0), Some(("L".to_owned(), true)), "the page says for which values a question asks");
    assert_eq!((names(&play, 1), names(&play, 3)), (None, None), "a hidden value is not named");
    assert_eq!(names(&play, 2), Some(("L g".to_owned(), false)), "assumed values replace assigned ones");
    set(&mut play, "L", 0.6);
    assert_eq!(names(&play, 0), Some(("L".to_owned(), false)));
    assert_eq!((check(&mut play, 0, "5.718"), check(&mut play, 0, "7.092")), (Grade::Wrong, Grade::Correct));
    play.apply_question_setup(0).unwrap();
    assert_eq!(play.course().parameters()[parameter(&play, "L")], 0.39);
    // A friend's answer with a friend's seat is none for one's own.
    let mut friend = lesson();
    friend.set_seat("3").unwrap();
    let right = friend.answers().right_text(friend.basis(), friend.course(), 0);
    assert_eq!(check(&mut friend, 0, &right), Grade::Correct);
    let stolen = later(&friend, "1&seat=7");
    assert_eq!(grades(&stolen, 0)[0].0, Grade::Correct);
    assert_ne!(grades(&stolen, 0)[0].1, Some(Grade::Correct));
    assert_eq!(stolen.answers().score(stolen.basis()), Some(0.0));
    assert_ne!(stolen.answers().answer(stolen.basis(), 0).verdict.map(|one| one.grade), Some(Grade::Correct));
    // A page that gets another seat grades its own answers again.
    friend.set_seat("7").unwrap();
    let [(stated, computed)] = grades(&friend, 0)[..] else { panic!("one attempt") };
    assert_eq!(Some(stated), computed);
    assert_ne!(stated, Grade::Correct);
}

#[test]
fn an_answer_is_read_in_the_language_in_which_it_was_typed() {
    let mut play = open(
        "---\ntitle: a\nlanguage: en\n---\n```model\nparameter a = 1.234\ny' = a\ny(0) = 0\n```\n\n```question\nA?\nanswer: a within 1 %\n```\n",
        &[],
    );
    play.set_language("es");
    assert_eq!(check(&mut play, 0, "1,234"), Grade::Correct);
    play.set_language("en");
    assert_eq!(grades(&play, 0), [(Grade::Correct, Some(Grade::Correct))]);
    assert_eq!(check(&mut play, 0, "1,234"), Grade::WrongScale);
}

#[test]
fn an_answer_counts_as_found_by_its_attempts_before_the_look() {
    let mut play = lesson();
    check(&mut play, 3, "9");
    play.change_answers(|answers, run| answers.reveal(run, 3));
    check(&mut play, 3, "10");
    let view = play.answers().answer(play.basis(), 3);
    assert_eq!((view.shown, view.found, view.attempts.len()), (Some(1), false, 2));
    // Neither the stored grade nor the order of a second look changes it.
    let (name, mut saved) = play.answers().saved(play.basis()).remove(0);
    saved.attempts[0].grade = Grade::Correct;
    play.change_answers(|answers, run| answers.restore(run, &name, &saved));
    play.change_answers(|answers, run| answers.reveal(run, 3));
    let view = play.answers().answer(play.basis(), 3);
    assert_eq!((view.shown, view.found), (Some(1), false));
}

#[test]
fn stored_answers_of_version_0_2_0_keep_their_grades() {
    let mut play = lesson();
    let names: Vec<String> = {
        for question in 0..4 {
            check(&mut play, question, "1");
        }
        play.answers().saved(play.basis()).into_iter().map(|(name, _)| name).collect()
    };
    let restored = |play: &mut Play, question: usize, lines: &str| {
        let answer = Answer::of_lines(lines).unwrap();
        play.change_answers(|answers, run| answers.restore(run, &names[question], &answer));
        play.answers().answer(play.basis(), question)
    };
    set(&mut play, "y_0", 0.09);
    let answer = restored(&mut play, 3, "6\ncorrect\n\nwrong 5\ncorrect 6");
    let last = answer.attempts.last().unwrap();
    assert_eq!((last.stated, last.computed, last.grade()), (Grade::Correct, None, Grade::Correct));
    assert_eq!((answer.found, answer.verdict.unwrap().grade), (true, Grade::Correct));
    for (third, shown, found) in [("revealed", Some(0), false), ("found", Some(1), true)] {
        let answer = restored(&mut play, 3, &format!("6\ncorrect\n{third}\ncorrect 6"));
        assert_eq!((answer.shown, answer.found), (shown, found));
    }
    // Nothing that a reader sets decides about this one.
    let answer = restored(&mut play, 1, "0.3\nwrong\n\nwrong 0.3");
    assert_eq!(answer.attempts[0].computed, Some(Grade::Correct));
}

#[test]
fn damaged_conditions_are_bounded() {
    assert_eq!(Answer::of_lines("1\n\n\ncorrect;en 1\nwrong;en;a 1\nwrong;en;a:x 1").unwrap().attempts.len(), 0);
    let read = Answer::of_lines("1\n\n\ncorrect;en;a:1e5,b:-0.5 1").unwrap();
    let conditions = Conditions { language: "en".into(), values: vec![("a".into(), 1e5), ("b".into(), -0.5)] };
    assert_eq!(read.attempts[0].conditions, Some(conditions));
    let mut play = lesson();
    check(&mut play, 3, "1");
    let (name, mut saved) = play.answers().saved(play.basis()).remove(0);
    saved.attempts[0].conditions =
        Some(Conditions { language: "x\n".repeat(5000), values: vec![("a".repeat(5000), f64::NAN); 5000] });
    play.change_answers(|answers, run| answers.restore(run, &name, &saved));
    let kept = play.answers().saved(play.basis()).remove(0).1.lines();
    assert!(kept.len() < 20_000 && kept.lines().count() == 4, "{}", kept.len());
}

/// Two devices of one person: attempts in the order `a b`, `a c`, and so on.
#[test]
fn attempts_of_two_devices_are_merged_and_none_is_lost() {
    let answer = |attempts: &str, shown: Option<usize>| Answer {
        typed: attempts.chars().last().map(String::from).unwrap_or_default(),
        grade: Some(Grade::Wrong),
        shown,
        attempts: attempts
            .chars()
            .map(|typed| play::Attempt { typed: typed.to_string(), grade: Grade::Wrong, conditions: None })
            .collect(),
    };
    let none = Answer { grade: None, ..answer("", None) };
    for (own, stored, expected) in [
        (none.clone(), answer("abc", None), ("abc", None)),
        (answer("d", None), answer("abc", None), ("abcd", None)),
        (answer("ab", None), answer("abc", Some(2)), ("abc", Some(2))),
        (answer("abd", Some(3)), answer("abc", None), ("abcd", Some(4))),
        (answer("abd", Some(1)), answer("abc", Some(3)), ("abcd", Some(1))),
        (answer("abcd", None), answer("abc", None), ("abcd", None)),
    ] {
        let mut play = lesson();
        check(&mut play, 3, "1");
        let name = play.answers().saved(play.basis()).remove(0).0;
        play.change_answers(|answers, run| answers.restore(run, &name, &own));
        // A second time adds nothing.
        for _ in 0..2 {
            assert!(play.change_answers(|answers, run| answers.merge(run, &name, &stored)));
            let view = play.answers().answer(play.basis(), 3);
            let typed: String = view.attempts.iter().map(|attempt| attempt.typed.clone()).collect();
            let again = play.answers().saved(play.basis()).remove(0).1;
            assert_eq!((typed.as_str(), view.shown), expected);
            play.change_answers(|answers, run| answers.merge(run, &name, &again));
        }
    }
}
