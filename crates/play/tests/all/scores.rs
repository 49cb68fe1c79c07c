//! Answers as a course receives them: score, plain numbers, attempts without texts.

use play::Play;

/// Document with questions whose right answers are 2 m and 3.
const TWO: &str = "```model\nparameter a = 2 [m]\ny' = a/(1 [s])\ny(0) = 0\n```\n\n```question\nOne\nanswer: a in [cm] within 1 %\n```\n\n\
                   ```question\nTwo\nanswer: 3 within 1 %\n```\n";

#[test]
fn the_score_counts_what_was_found_before_it_was_shown() {
    let mut play = crate::support::open(TWO, &[]);
    let state = |play: &Play| (play.answers().score(play.basis()), play.answers().are_complete());
    assert_eq!(state(&play), (Some(0.0), false));
    play.change_answers(|answers, run| answers.check(run, 0, "2 m"));
    assert_eq!(state(&play), (Some(0.5), false));
    // Neither a look at the answer that was found nor another attempt takes the point away.
    play.change_answers(|answers, run| answers.reveal(run, 0));
    play.change_answers(|answers, run| answers.check(run, 0, "5 m"));
    assert_eq!(state(&play), (Some(0.5), false));
    play.change_answers(|answers, run| answers.check(run, 1, "4"));
    assert_eq!(state(&play), (Some(0.5), true));
    play.change_answers(|answers, run| answers.reveal(run, 1));
    play.change_answers(|answers, run| answers.check(run, 1, "3"));
    assert_eq!(state(&play), (Some(0.5), true));
    let none = crate::support::open("```model\ny' = 1 [1/s]\ny(0) = 0\n```\n", &[]);
    assert_eq!(none.answers().score(none.basis()), None);
}

#[test]
fn an_answer_is_a_number_in_the_unit_that_is_asked_for() {
    let play = crate::support::open(TWO, &[]);
    let number = |text: &str| play.answers().number(play.basis(), 0, text);
    assert_eq!(["2 m", "0.495 m", "2*3", "1e-3 m"].map(number), [Some(200.0), Some(49.5), Some(6.0), Some(0.1)]);
    assert_eq!(["2 ± 0.1 m", "two", "a", "2 kg", ""].map(number), [None; 5]);
}

#[test]
fn texts_of_attempts_can_be_left_out() {
    let mut play = crate::support::open(TWO, &[]);
    for text in ["1", "2", "200"] {
        play.change_answers(|answers, run| answers.check(run, 0, text));
    }
    let answer = play.answers().saved(play.basis()).remove(0).1;
    let texts = |all| {
        let answer = answer.without_texts(all);
        let attempts: Vec<String> = answer.attempts.iter().map(|attempt| attempt.typed.clone()).collect();
        let grades: Vec<play::Grade> = answer.attempts.iter().map(|attempt| attempt.grade).collect();
        (answer.typed.clone(), answer.grade, attempts.concat(), grades)
    };
    let grades: Vec<play::Grade> = answer.attempts.iter().map(|attempt| attempt.grade).collect();
    assert_eq!(grades.len(), 3);
    assert_eq!(texts(false), ("200".to_owned(), answer.grade, "200".to_owned(), grades.clone()));
    assert_eq!(texts(true), (String::new(), answer.grade, String::new(), grades));
}
