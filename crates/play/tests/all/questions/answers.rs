//! Answers to questions: parsing and storage; values hidden by questions.

use crate::support::{UTUBE, utube};
use play::{Answer, Attempt, Grade, Play};

const DOCUMENT: &str = r#"---
title: A pendulum
---

```model
parameter g = 9.8 [m/s^2] in 1..30 "Gravity"
parameter l = 3.5 [m] in 1..9 "Length"
parameter w = 1 [rad/s] in 0..50 "Angular frequency"
x'' = -g/l*x
x(0) = 0.1
x'(0) = 0
omega_0 = sqrt(g/l) in [rad/s] "Angular frequency"
f_0 = omega_0/(2*pi) in [Hz] "Frequency"
T_0 = 1/f_0 "Period"
E = x'^2/2 + g/l*x^2/2 "Energy"
```

```question
What is the period?
hide: T_0, f_0, E
answer: T_0 in [s] within 1 %
```

```question
What is the angular frequency?
hide: omega_0, f_0
answer: omega_0 in [rad/s] within 1 %
```

```question
What is the frequency?
answer: f_0 in [Hz] within 1 %
```

```question
How many degrees are the sixth part of a half turn?
answer: pi/6 in [deg] within 1 %
```

```question
What is the part in per cent?
answer: 0.18 in [%] within 1 %
```
"#;

fn judged(play: &mut Play, question: usize, typed: &str) -> (Grade, String) {
    let verdict = play.change_answers(|answers, run| answers.check(run, question, typed));
    (verdict.grade, verdict.text)
}

/// T = 2 pi sqrt(3.5/9.8) s = 3.7549 s, omega = 1.6733 rad/s, f = 0.26632 Hz.
#[test]
fn arithmetic_units_and_errors_are_understood() {
    use Grade::{Close, Correct, Unreadable, Wrong, WrongScale};
    let mut play = crate::support::open(DOCUMENT, &[]);
    for (question, typed, grade, words) in [
        (0, "15/4", Correct, "Correct."),
        (0, "15/4 s", Correct, "Correct."),
        (0, "7.5 s/2", Correct, "Correct."),
        (0, "3.5 s + 250 ms", Correct, "Correct."),
        (0, "2*pi/1.672", Correct, "Correct."),
        (0, "2*pi/1.672 1/s", Correct, "Correct."),
        (0, "2*pi/(1.672 1/s)", Correct, "Correct."),
        (0, "2π/(1.672 rad/s)", Correct, "Correct."),
        (0, "2·π/(1.672 rad/s)", Correct, "Correct."),
        (0, "2*pi*sqrt(3.5 m/(9.8 m/s^2))", Correct, "Correct."),
        (0, "1/(0.2663 Hz)", Correct, "Correct."),
        (0, "15/4 ms", WrongScale, "The digits"),
        (0, "15/4 m", Unreadable, "m measures something else; a unit such as s is needed."),
        (0, "T_0", Unreadable, "An answer consists of numbers and units; “T_0” is a quantity of the simulation."),
        (0, "2*pi/omega_0", Unreadable, "An answer consists of numbers"),
        (0, "2*", Unreadable, "“2*” is not a number. Write one such as 2.5 s."),
        (0, "3.76 ± 0.02 s", Correct, "Correct. The true value lies within your error."),
        (0, "3.76 +- 0.02", Correct, "Correct. The true value lies within your error."),
        (0, "3.76 +/- 0.02 s", Correct, "Correct. The true value lies within your error."),
        (0, "(3.76 ± 0.02) s", Correct, "Correct. The true value lies within your error."),
        (0, "3.76 s ± 20 ms", Correct, "Correct. The true value lies within your error."),
        (0, "3.76 s ± 1 %", Correct, "Correct. The true value lies within your error."),
        (0, "3.76 ± 0.001 s", Correct, "Correct. But the true value lies outside your error: it is too small."),
        (0, "15/4 ± 1/100", Correct, "Correct. The true value lies within your error."),
        (
            0,
            "3.6 ± 0.05 s",
            Close,
            "Close, but not close enough. Measure again. The true value lies outside your error.",
        ),
        (0, "1 ± 100 s", Wrong, "Not yet. Your error covers the true value, but the value itself is what counts."),
        (0, "± 0.02 s", Unreadable, "Type a number."),
        (0, "3.76 ± some s", Unreadable, ""),
        (1, "1.673 rad/s", Correct, "Correct."),
        (1, "95.87 deg/s", Correct, "Correct."),
        (1, "1.673 1/s", Correct, "Correct."),
        // Numbers are converted through the turn.
        (1, "0.2663 Hz", Correct, "Correct."),
        (1, "0.2663 [Hz]", Correct, "Correct."),
        (1, "266.3 mHz ± 1 mHz", Correct, "Correct. The true value lies within your error."),
        (1, "15.98 rpm", Correct, "Correct."),
        (1, "1.4 Hz", Wrong, ""),
        (1, "1.673 Hz", Wrong, ""),
        // Arithmetic may be converted already.
        (1, "2*pi*0.2663 Hz", Correct, "Correct."),
        (1, "2.8/2 Hz", Unreadable, "1.4 Hz is a frequency; the angular frequency is 8.8 rad/s."),
        (1, "0.7 Hz + 0.7 Hz", Unreadable, "1.4 Hz is a frequency; the angular frequency is 8.8 rad/s."),
        (2, "3.346/2 rad/s", Unreadable, "1.673 rad/s is an angular frequency; the frequency is 0.266 Hz."),
        (1, "2*pi*(0.2663 Hz)", Correct, "Correct."),
        (1, "sqrt(2.8)", Correct, "Correct."),
        (2, "0.2663", Correct, "Correct."),
        (2, "266.3 mHz", Correct, "Correct."),
        (2, "1.673 rad/s", Correct, "Correct."),
        (2, "95.87 deg/s", Correct, "Correct."),
        (2, "15.98 rpm", Correct, "Correct."),
        (3, "30", Correct, "Correct."),
        (3, "60/2", Correct, "Correct."),
        (3, "30 deg", Correct, "Correct."),
        (3, "30°", Correct, "Correct."),
        (3, "0.5236 rad", Correct, "Correct."),
        (3, "pi/6", Correct, "Correct."),
        (4, "18", Correct, "Correct."),
        (4, "36/2", Correct, "Correct."),
        (4, "18 % ± 1 %", Correct, "Correct. The true value lies within your error."),
        (4, "18 ± 1 %", Correct, "Correct. The true value lies within your error."),
    ] {
        let (found, text) = judged(&mut play, question, typed);
        assert_eq!(found, grade, "{question} {typed}: {text}");
        assert!(text.contains(words), "{question} {typed}: {text}");
    }
}

#[test]
fn answers_in_spanish_have_decimal_commas() {
    use Grade::{Correct, Unreadable, Wrong};
    let mut play = crate::support::open(DOCUMENT, &[]);
    play.set_language("es");
    for (question, typed, grade, words) in [
        (0, "3,76 s", Correct, "Correcto."),
        (0, "2*pi/1,672", Correct, "Correcto."),
        (0, "2*pi/(1,672 1/s)", Correct, "Correcto."),
        (0, "hypot(2,25; 3)", Correct, "Correcto."),
        (0, "3,76 ± 0,02 s", Correct, "Correcto. El valor verdadero está dentro de tu error."),
        (
            0,
            "3,76 ± 0,001 s",
            Correct,
            "Correcto. Pero el valor verdadero queda fuera de tu error, que es demasiado pequeño.",
        ),
        (
            0,
            "1 ± 100 s",
            Wrong,
            "Todavía no. Tu error abarca el valor verdadero, pero lo que cuenta es el valor mismo.",
        ),
        (0, "T_0", Unreadable, "Una respuesta consta de números y unidades; «T_0» es una magnitud de la simulación."),
        (1, "2,8/2 Hz", Unreadable, "1,4 Hz es una frecuencia; la frecuencia angular es 8,8 rad/s."),
        (2, "3,346/2 rad/s", Unreadable, "1,673 rad/s es una frecuencia angular; la frecuencia es 0,266 Hz."),
    ] {
        let (found, text) = judged(&mut play, question, typed);
        assert_eq!(found, grade, "{question} {typed}: {text}");
        assert!(text.contains(words), "{question} {typed}: {text}");
    }
}

#[test]
fn fields_take_arithmetic_and_convert_between_cycles_and_angles() {
    let mut play = crate::support::open(DOCUMENT, &[]);
    for (name, typed, expected) in [
        ("l", "7/2 m", 3.5),
        ("l", "3 m + 20 cm", 3.2),
        ("l", "2*l", 6.4),
        ("w", "2*pi*(2 Hz)", 4.0 * std::f64::consts::PI),
        ("w", "2 Hz", 4.0 * std::f64::consts::PI),
        ("w", "0.002 [kHz]", 4.0 * std::f64::consts::PI),
        ("w", "60 rpm", std::f64::consts::TAU),
        ("w", "3 rad/s", 3.0),
        ("w", "3 1/s", 3.0),
        ("w", "2*w", 6.0),
    ] {
        let index = crate::support::parameter(&play, name);
        assert_eq!(play.change_settings(|settings| settings.set_parameter_text(index, typed)), Ok(()), "{typed}");
        let value = play.course().parameters()[index];
        assert!((value - expected).abs() < 1e-12, "{typed}: {value}");
    }
    let index = crate::support::parameter(&play, "w");
    let refusal = play.change_settings(|settings| settings.set_parameter_text(index, "2.8/2 Hz")).unwrap_err();
    assert_eq!(play.basis().refusal_text(&refusal), "1.4 Hz is a frequency; the angular frequency is 8.8 rad/s.");
}

#[test]
fn values_are_hidden_until_their_questions_are_answered() {
    let mut play = crate::support::open(DOCUMENT, &[]);
    let value = |play: &mut Play, name: &str| {
        let found = play.readouts().into_iter().find(|readout| readout.name == name).unwrap();
        assert_eq!(found.hidden, found.value == "hidden" || found.value == "oculto", "{found:?}");
        assert!(!found.hidden || found.unit.is_empty(), "{found:?}");
        found.value
    };
    assert!(play.basis().hides_values());
    let all = |play: &mut Play| ["T_0", "f_0", "omega_0"].map(|name| value(play, name));
    assert_eq!(all(&mut play), ["hidden", "hidden", "hidden"]);
    // Its column in the table is hidden, too.
    let place = play.values().table_header().iter().position(|head| head.starts_with("E ")).unwrap();
    assert_eq!(play.values().table_rows(0..1)[0][place], "hidden");
    // A wrong answer reveals no value. A right answer reveals the values that no other open question hides.
    play.change_answers(|answers, run| answers.check(run, 0, "1"));
    assert_eq!(all(&mut play), ["hidden", "hidden", "hidden"]);
    play.change_answers(|answers, run| answers.check(run, 0, "3.755 s"));
    assert_eq!(all(&mut play), ["3.755", "hidden", "hidden"]);
    assert_ne!(play.values().table_rows(0..1)[0][place], "hidden");
    let link = play.share();
    // In the teacher's view all values are shown, and the link contains this choice.
    play.change_answers(|answers, _| answers.show_hidden(true));
    assert_eq!(all(&mut play), ["3.755", "0.2663", "1.673"]);
    let open = play.share();
    play.change_answers(|answers, _| answers.show_hidden(false));
    assert_eq!(play.share(), link);
    assert_eq!(all(&mut play), ["3.755", "hidden", "hidden"]);
    play.set_language("es");
    assert_eq!(value(&mut play, "f_0"), "oculto");
    let mut other = crate::support::open(DOCUMENT, &[]);
    other.restore(&open).unwrap();
    assert!(other.answers().shows_hidden());
    assert_eq!(value(&mut other, "omega_0"), "1.673");
    // Showing the right answer reveals the value.
    play.change_answers(|answers, run| answers.reveal(run, 1));
    assert_eq!(all(&mut play), ["3,755", "0,2663", "1,673"]);
}

#[test]
fn what_cannot_be_hidden_is_reported() {
    for (hide, message) in [
        ("T_1", "`T_1` is not a quantity of the model"),
        ("l", "`l` is not a quantity of the model"),
        ("x'", "`hide:` names quantities, with a comma between them"),
        ("T_0 [s]", "only names stand in `hide:`"),
    ] {
        let source = DOCUMENT.replace("hide: T_0, f_0, E", &format!("hide: {hide}"));
        let opened = document::open(&source, &[]);
        let found: Vec<String> = opened.diagnostics.iter().map(|(_, found)| found.message.english()).collect();
        assert_eq!(found, [message], "{hide}");
    }
}

#[test]
fn questions_appear_when_those_before_are_answered() {
    let text = "```model\nparameter a = 2\ny' = a*1 [1/s]\ny(0) = 0\n```\n\n```question\nOne\nanswer: a within 1 %\n```\n\n\
                ```question\nTwo\nafter: previous\nanswer: 2*a within 1 %\n```\n\n\
                ```question\nThree\nafter: 1, 2\nanswer: 3*a within 1 %\n```\n";
    let open = || crate::support::open(text, &[]);
    let awaited = |play: &Play| [0, 1, 2, 3].map(|question| play.answers().awaited(play.basis(), question));
    let mut play = open();
    assert_eq!(awaited(&play), [vec![], vec![0], vec![0, 1], vec![]]);
    play.change_answers(|answers, run| answers.check(run, 0, "3"));
    assert_eq!(awaited(&play)[1], [0], "a wrong answer opens nothing");
    play.change_answers(|answers, run| answers.check(run, 0, "2"));
    assert_eq!(awaited(&play), [vec![], vec![], vec![1], vec![]]);
    // A solved question stays solved after a wrong attempt and at the next visit.
    play.change_answers(|answers, run| answers.check(run, 0, "3"));
    assert!(awaited(&play)[1].is_empty());
    play.change_answers(|answers, run| answers.check(run, 0, "2"));
    let mut later = open();
    for (name, answer) in play.answers().saved(play.basis()) {
        assert!(later.change_answers(|answers, run| answers.restore(run, &name, &answer)));
    }
    assert_eq!(awaited(&later), awaited(&play));
    later.change_answers(|answers, run| answers.reveal(run, 1));
    assert!(awaited(&later)[2].is_empty());
}

#[test]
fn answers_stay_with_their_questions() {
    let mut play = utube();
    play.change_answers(|answers, run| answers.check(run, 0, "123456"));
    play.change_answers(|answers, _| answers.type_text(1, "1"));
    play.change_answers(|answers, run| answers.check(run, 1, "1"));
    play.change_answers(|answers, run| answers.reveal(run, 1));
    play.change_answers(|answers, run| answers.check(run, 99, "1"));
    let saved = play.answers().saved(play.basis());
    assert_eq!(saved.len(), 2);
    play.set_language("es");
    assert_eq!(play.answers().saved(play.basis()), saved, "the same in both languages");
    let answer = play.answers().answer(play.basis(), 0);
    assert_eq!(answer.verdict.map(|verdict| verdict.text).as_deref(), Some("Todavía no."));
    assert_eq!((answer.typed.as_str(), answer.shown), ("123456", None));
    // Another question is inserted before them, and the next visit is in Spanish.
    let source =
        UTUBE.replacen("```question\n", "```question\nWhat is g?\nanswer: g within 1 %\n```\n\n```question\n", 1);
    let mut later = crate::support::open(&source, &[]);
    later.set_language("es");
    for (name, answer) in &saved {
        assert_eq!(Answer::of_lines(&answer.lines()).as_ref(), Some(answer));
        assert!(later.change_answers(|answers, run| answers.restore(run, name, answer)));
    }
    assert_eq!(
        (later.answers().answer(later.basis(), 0), later.answers().answer(later.basis(), 1)),
        (play::AnswerView::default(), play.answers().answer(play.basis(), 0))
    );
    assert_eq!(later.answers().answer(later.basis(), 2), play.answers().answer(play.basis(), 1));
    assert_eq!(
        later.answers().answer(later.basis(), 2).verdict.map(|verdict| verdict.grade),
        Some(play::Grade::Correct)
    );
    assert_eq!(later.answers().answer(later.basis(), 2).shown, Some(1), "what was shown stays shown");
    // Typing removes the verdict. Invalid stored data change nothing.
    later.change_answers(|answers, _| answers.type_text(2, "2\n3"));
    assert_eq!(
        (later.answers().answer(later.basis(), 2).typed.as_str(), later.answers().answer(later.basis(), 2).verdict),
        ("2 3", None)
    );
    let before = later.answers().saved(later.basis());
    for name in ["", "0000000000000000"] {
        assert!(!later.change_answers(|answers, run| answers.restore(run, name, &saved[0].1)));
    }
    assert_eq!(later.answers().saved(later.basis()), before);
    assert_eq!(Answer::of_lines("one line"), None);
    let unknown = Answer { typed: "1".into(), ..Answer::default() };
    assert_eq!(Answer::of_lines("1\nright\n"), Some(unknown));
}

#[test]
fn all_attempts_are_kept() {
    let attempt = |typed: &str, grade| Attempt { typed: typed.to_owned(), grade, conditions: None };
    let mut play = utube();
    for typed in ["?\n", "123456", "123456", "-1", "123456"] {
        play.change_answers(|answers, run| answers.check(run, 0, typed));
    }
    play.change_answers(|answers, _| answers.type_text(0, "not checked"));
    let expected = ["?", "123456", "-1", "123456"];
    let answer = play.answers().answer(play.basis(), 0);
    let typed: Vec<&str> = answer.attempts.iter().map(|attempt| attempt.typed.trim()).collect();
    assert_eq!(typed, expected, "the same twice in a row is one attempt");
    assert_eq!(answer.attempts[0].grade(), Grade::Unreadable);
    // Stored, for pages without a JSON parser too.
    let (_, saved) = play.answers().saved(play.basis()).remove(0);
    assert_eq!(Answer::of_lines(&saved.lines()), Some(saved.clone()));
    let with_noise = format!("{}\nright 1\nwrong\nwrong 7 kg", saved.lines());
    let read = Answer::of_lines(&with_noise).expect("an answer");
    assert_eq!(read.attempts[expected.len()..], [attempt("7 kg", Grade::Wrong)]);
    // Of very many the latest are kept, whatever was stored.
    let many: Vec<Attempt> = (0..5000).map(|number| attempt(&format!("{number}\n"), Grade::Wrong)).collect();
    let (name, _) = play.answers().saved(play.basis()).remove(0);
    assert!(play.change_answers(|answers, run| answers.restore(run, &name, &Answer { attempts: many, ..saved })));
    let kept = play.answers().answer(play.basis(), 0).attempts;
    let last = kept.last().map(|attempt| (attempt.typed.as_str(), attempt.stated, attempt.computed));
    assert_eq!((kept.len(), last), (100, Some(("4999 ", Grade::Wrong, None))), "without conditions as it was stated");
}

#[test]
fn a_limit_of_attempts_is_kept() {
    let limited = DOCUMENT.replace("answer: T_0 in [s] within 1 %", "answer: T_0 in [s] within 1 %\nattempts: 2");
    let mut play = crate::support::open(&limited, &[]);
    let limit = |play: &Play| play.answers().answer(play.basis(), 0).limit.map(|limit| (limit.allowed, limit.made));
    assert_eq!(limit(&play), Some((2, 0)));
    assert_eq!(play.answers().answer(play.basis(), 1).limit, None);
    assert_eq!(judged(&mut play, 0, "9").0, Grade::Wrong);
    // What cannot be read is no attempt, and pushes none out.
    for number in 0..150 {
        assert_eq!(judged(&mut play, 0, &format!("x{number}")).0, Grade::Unreadable);
    }
    assert_eq!(limit(&play), Some((2, 1)));
    assert_eq!(judged(&mut play, 0, "8").0, Grade::Wrong);
    assert_eq!(limit(&play), Some((2, 2)));
    let (_, text) = judged(&mut play, 0, "3.755");
    assert_eq!(text, "No attempts are left.");
    let given = play.answers().answer(play.basis(), 0);
    assert!(!given.found && given.attempts.iter().all(|attempt| attempt.typed != "3.755"));
    assert_eq!(play.answers().score(play.basis()), Some(0.0));
    // The next visit.
    let saved = play.answers().saved(play.basis());
    let mut again = crate::support::open(&limited, &[]);
    for (name, answer) in &saved {
        let stored = Answer::of_lines(&answer.lines()).unwrap();
        assert_eq!(Answer::of_stored(&answer.stored()), stored);
        again.change_answers(|answers, run| answers.restore(run, name, &stored));
    }
    assert_eq!(limit(&again), Some((2, 2)));
    // A document without the limit counts all of them.
    let mut free = crate::support::open(DOCUMENT, &[]);
    assert_eq!(judged(&mut free, 0, "3.755").0, Grade::Correct);
}
