//! Kinds of questions: choices with partial credit, remarks on expected wrong answers, and answers of another kind.

use crate::support::open;
use play::{Answer, Attempt, Grade, Play};

const DOCUMENT: &str = r#"---
title: A pendulum
---

```model
parameter g = 9.8 [m/s^2] in 1..30 "Gravity"
parameter l = 3.5 [m] in 1..9 "Length"
T = 2*pi*sqrt(l/g) in [s] "Period"
phi'' = -g/l*phi
phi(0) = 0.1
phi'(0) = 0
```

```question
What lengthens the period?

choose: several
option: "A longer thread" right
option: "A heavier bob" "The **mass** cancels."
option: "A smaller $g$" right "As on the Moon."
```

```question
Which is the unit of the period?

choose: one
option: "s" right
option: "1/s" "That is a frequency."
```

```question
How long is the period?

hide: T
answer: T in [s] within 1 %
wrong: T/2 "Half a period."
wrong: 2*T within 10 % "Twice the period."
```
"#;

const SPANISH: &str = r#"---
title: Un péndulo
language: es
translates: pendulum.md
---

```translations
"Gravity" = "Gravedad"
"Length" = "Longitud"
"Period" = "Periodo"
```

```question
¿Qué alarga el periodo?

option: "Un hilo más largo"
option: "Una masa mayor" "La **masa** se cancela."
option: "Una $g$ menor" "Como en la Luna."
```

```question
¿Cuál es la unidad del periodo?

option: "s"
option: "1/s" "Eso es una frecuencia."
```

```question
¿Cuánto dura el periodo?

wrong: "Medio periodo."
wrong: "El doble del periodo."
```
"#;

fn checked(play: &mut Play, question: usize, typed: &str) -> (Grade, Vec<String>) {
    let verdict = play.change_answers(|answers, run| answers.check(run, question, typed));
    (verdict.grade, verdict.remarks)
}

#[test]
fn several_options_get_a_part_of_the_credit() {
    let mut play = open(DOCUMENT, &[]);
    assert_eq!(checked(&mut play, 0, "A"), (Grade::Partly(50), vec![]));
    let (grade, remarks) = checked(&mut play, 0, "A, B, C");
    assert_eq!(grade, Grade::Partly(50), "two right ones less a wrong one, of two");
    assert_eq!(remarks[0], "The <strong>mass</strong> cancels.");
    assert_eq!(remarks[1], "As on the Moon.");
    assert_eq!(checked(&mut play, 0, "B").0, Grade::Wrong);
    assert_eq!(play.answers().score(play.basis()), Some(0.5 / 3.0), "the best attempt counts");
    assert_eq!(checked(&mut play, 0, "C,A").0, Grade::Correct);
    let answer = play.answers().answer(play.basis(), 0);
    assert!(answer.found && answer.credit == 1.0 && answer.attempts[0].right == "A, C");
    for typed in ["", "D", "A B", "AC", "3", "a", "A,,C"] {
        assert_eq!(checked(&mut play, 0, typed).0, Grade::Unreadable, "{typed}");
    }
    assert_eq!(play.answers().answer(play.basis(), 0).credit, 1.0, "what cannot be read is no attempt");
}

#[test]
fn one_option_is_right_or_wrong() {
    let mut play = open(DOCUMENT, &[]);
    assert_eq!(checked(&mut play, 1, "B"), (Grade::Wrong, vec!["That is a frequency.".to_owned()]));
    assert_eq!(checked(&mut play, 1, "A, B").0, Grade::Unreadable);
    assert_eq!(checked(&mut play, 1, "A"), (Grade::Correct, vec![]));
    // A shown answer ends the credit.
    let mut other = open(DOCUMENT, &[]);
    assert_eq!(checked(&mut other, 0, "A").0, Grade::Partly(50));
    assert_eq!(other.change_answers(|answers, run| answers.reveal(run, 0)), "A, C");
    checked(&mut other, 0, "A, C");
    let answer = other.answers().answer(other.basis(), 0);
    assert!(!answer.found && answer.credit == 0.5);
}

/// T = 2 pi sqrt(3.5/9.8) s = 3.7549 s; at g = 2.45 m/s² it is twice that.
#[test]
fn an_expected_wrong_value_has_its_remark_under_the_values_at_that_time() {
    let mut play = open(DOCUMENT, &[]);
    assert_eq!(checked(&mut play, 2, "1.877 s"), (Grade::Wrong, vec!["Half a period.".to_owned()]));
    assert_eq!(checked(&mut play, 2, "1877 ms").1, ["Half a period."]);
    assert_eq!(checked(&mut play, 2, "7 s").1, ["Twice the period."], "its own tolerance is 10 %");
    assert_eq!(checked(&mut play, 2, "3.75"), (Grade::Correct, vec![]));
    assert_eq!(checked(&mut play, 2, "5"), (Grade::Wrong, vec![]));
    play.change_settings(|settings| settings.set_parameter(0, 2.45)).unwrap();
    assert_eq!(checked(&mut play, 2, "3.75").1, ["Half a period."]);
}

#[test]
fn the_texts_are_those_of_the_language_and_letters_stay() {
    let mut play = open(DOCUMENT, &[SPANISH]);
    play.set_language("es");
    assert_eq!(checked(&mut play, 0, "B").1, ["La <strong>masa</strong> se cancela."]);
    assert_eq!(checked(&mut play, 1, "B").1, ["Eso es una frecuencia."]);
    assert_eq!(checked(&mut play, 2, "1,877 s").1, ["Medio periodo."]);
    let options = &play.program().question_text("es", 0).options;
    assert_eq!(options.iter().map(|option| option.text.as_str()).collect::<Vec<_>>()[0], "Un hilo más largo");
}

#[test]
fn an_answer_keeps_its_credit_in_every_stored_form() {
    let mut play = open(DOCUMENT, &[]);
    checked(&mut play, 0, "A");
    let saved = play.answers().saved(play.basis());
    let (name, answer) = &saved[0];
    assert_eq!(Answer::of_lines(&answer.lines()).as_ref(), Some(answer));
    assert_eq!(&Answer::of_stored(&answer.stored()), answer);
    assert_eq!(answer.stored().attempts[0].grade, "partly:50");
    // Without its text the stated credit counts.
    let mut fresh = open(DOCUMENT, &[]);
    let bare = answer.without_texts(true);
    assert!(fresh.change_answers(|answers, run| answers.restore(run, name, &bare)));
    assert_eq!(fresh.answers().answer(fresh.basis(), 0).credit, 0.5);
    // A stated credit that does not follow from the text does not count.
    let mut forged = answer.clone();
    forged.attempts[0] = Attempt { grade: Grade::Correct, ..forged.attempts[0].clone() };
    assert!(fresh.change_answers(|answers, run| answers.restore(run, name, &forged)));
    assert_eq!(fresh.answers().answer(fresh.basis(), 0).credit, 0.5);
    // A number that was typed before the question became a choice names no option.
    forged.attempts[0].typed = "3.76 s".to_owned();
    assert!(fresh.change_answers(|answers, run| answers.restore(run, name, &forged)));
    assert_eq!(fresh.answers().answer(fresh.basis(), 0).credit, 0.0);
    for code in ["partly:0", "partly:100", "partly:", "partly:x", "partly:-1", "partly:999"] {
        assert_eq!(Grade::from_code(code), None, "{code}");
    }
}
