//! Honest work in every order of answer, slider, fit and preset: no false alarm, and each grade as the student saw it.

use crate::support::{Noise, check, file, lesson, measured, of_seat, seated, set};
use class::collection::{Collection, References};
use class::page::state_lines;
use desk::Desk;
use desk::play::Grade;
use units::Language;

/// A grade as the page showed it.
type Seen = (usize, String, Grade);

fn give(desk: &mut Desk, seen: &mut Vec<Seen>, question: usize, typed: &str) {
    let number = |desk: &Desk| desk.play().answers().answer(desk.play().basis(), question).attempts.len();
    let before = number(desk);
    let grade = check(desk, question, typed);
    // Without an attempt left the page grades nothing, and the same answer again is no other attempt.
    if number(desk) > before {
        seen.push((question, typed.to_owned(), grade));
    }
}

fn pick(chance: &mut Noise, all: &[&'static str]) -> &'static str {
    all[(chance.uniform() * all.len() as f64) as usize]
}

/// One thing that a student does.
fn act(desk: &mut Desk, chance: &mut Noise, seen: &mut Vec<Seen>) {
    match (chance.uniform() * 15.0) as usize {
        0 => set(desk, "L", 0.1 + 0.8 * chance.uniform()),
        1 => set(desk, "g", 1.0 + 20.0 * chance.uniform()),
        2 => desk.play_mut().change_settings(|settings| settings.apply_preset(0)).unwrap(),
        3 => desk.play_mut().apply_question_setup(0).unwrap(),
        // The right answer that the page would show, as it is typed.
        4 | 5 => {
            let right = desk.play().answers().right_text(desk.play().basis(), desk.play().course(), 0);
            give(desk, seen, 0, &right);
        }
        6 => give(desk, seen, 0, &format!("{:.3}", 20.0 * chance.uniform())),
        7 => give(desk, seen, 0, pick(chance, &["x", "-7.1", "71", "7,1", "3 kg", "2*pi/(0.9 s)", "sqrt(2*9.81/0.4)"])),
        8 | 9 => give(desk, seen, 1, pick(chance, &["0,55 ± 0,01", "0.55", "0.3 1/s", "x", "0.9", "-0.4", "25 %"])),
        10 => {
            let question = (chance.uniform() * 2.0) as usize;
            desk.play_mut().change_answers(|answers, run| answers.reveal(run, question));
        }
        11 => {
            desk.play_mut().change_run(|line, _| line.play());
            desk.play_mut().change_run(|line, _| line.tick(0.3));
            desk.play_mut().change_run(|line, _| line.pause());
            // A run like one that is kept already is refused.
            let _ = desk.play_mut().change_run(|line, basis| line.keep(basis));
        }
        12 => desk.play_mut().set_language(pick(chance, &["en", "es", "pt"])),
        // A text that is not checked.
        13 => {
            desk.play_mut().change_answers(|answers, _| answers.type_text(0, "7.2"));
        }
        _ => fit(desk, chance),
    }
}

/// A fit of g to a record, whose result goes on the sliders.
fn fit(desk: &mut Desk, chance: &mut Noise) {
    if desk.fits().list().is_empty() {
        let rows = measured((1e6 * chance.uniform()) as u64);
        desk.add_record("tube.csv", file(&rows).as_bytes()).unwrap();
        let index = desk.play().model().parameters.iter().position(|one| one.name == "g").unwrap();
        desk.change_fits(|fits, data| fits.vary(data.play(), index, true));
        desk.change_fits(|fits, data| fits.begin(data, "lesson.md")).unwrap();
        while desk.advance_fit() {}
    }
    let fit = desk.fits().list()[0].id;
    desk.apply_fit(fit);
}

fn is_honest(case: u64) -> usize {
    let mut chance = Noise::new(5000 + case);
    let mut desk = seated(&lesson(), &((chance.uniform() * 40.0) as u32 + 1).to_string());
    let mut seen = Vec::new();
    for _ in 0..6 + case % 9 {
        act(&mut desk, &mut chance, &mut seen);
    }
    let made = of_seat(&desk, lesson(), "honest");
    let mut class = Collection::new(Language::Portuguese);
    class.set_references(References::given(vec![lesson()]));
    class.add("a.hand-in", Ok(made));
    while class.advance() {}
    let entry = &class.entries()[0];
    let (_, work) = class.works().next().unwrap();
    let lines = state_lines(entry, &class, Language::English);
    assert!(work.verdict.holds() && work.verdict.unknown == 0 && lines.len() == 1, "{case}: {lines:?}");
    for question in 0..2 {
        let shown = desk.play().answers().answer(desk.play().basis(), question);
        let counted = &work.answers[question];
        let graded: Vec<(String, Grade)> =
            counted.attempts.iter().map(|one| (one.typed.clone(), one.grade())).collect();
        let own = seen.iter().filter(|(of, ..)| *of == question);
        let own: Vec<(String, Grade)> = own.map(|(_, typed, grade)| (typed.clone(), *grade)).collect();
        assert_eq!(graded, own, "{case}, question {question}");
        let limit = if question == 0 { usize::MAX } else { 3 };
        assert_eq!((counted.found, &counted.typed), (shown.found, &shown.typed), "{case}, question {question}");
        assert!(own.iter().filter(|(_, grade)| grade.is_attempt()).count() <= limit, "{case}: {own:?}");
    }
    seen.len()
}

#[test]
fn two_hundred_honest_hand_ins_hold_and_are_graded_as_their_students_saw_it() {
    let answers: usize = (0..200).map(is_honest).sum();
    assert!(answers > 400, "{answers}");
}
