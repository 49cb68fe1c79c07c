//! Work of a student, made as the laboratory makes it.

use class::verify::hand_in;
use desk::play::Grade;
use desk::{Desk, ExportKind, Imprint};
use document::page::Source;
use miniz_oxide::deflate::compress_to_vec_zlib;
use saved::carried::carry;
use saved::format::{Content, Film, Followed, FoundInFilm, TrackInFilm};
use saved::hand_in::{HandIn, Sender};
use saved::project::Project;
use saved::{Item, Number};
use std::path::Path;
use units::Language;

/// A question, put to the theory of linear damping.
const QUESTION: &str = "\n```question\nWhat is the damping rate?\n\nanswer: gamma in [1/s] within 5 %\n```\n";

/// The theory of linear damping with a question.
pub fn linear() -> Vec<Source> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../simulations/theories/linear.md");
    let text = std::fs::read_to_string(path).unwrap() + QUESTION;
    vec![Source { name: "linear.md".to_owned(), text }]
}

/// A lesson with an assigned length, an assigned hidden damping, and a question on each. Seat 7 has L = 39 cm.
pub fn lesson() -> Vec<Source> {
    let text = include_str!("support/lesson.md").to_owned();
    vec![Source { name: "lesson.md".to_owned(), text }]
}

/// A desk with a document, at a seat.
pub fn seated(documents: &[Source], seat: &str) -> Desk {
    let mut desk = Desk::open(document::open(&documents[0].text, &[]).sound().unwrap());
    desk.play_mut().set_seat(seat).unwrap();
    desk
}

/// Sets the parameter of this name.
pub fn set(desk: &mut Desk, name: &str, value: f64) {
    let index = desk.play().model().parameters.iter().position(|one| one.name == name).unwrap();
    desk.play_mut().change_settings(|settings| settings.set_parameter(index, value)).unwrap();
}

/// The grade that the page shows for an answer.
pub fn check(desk: &mut Desk, question: usize, typed: &str) -> Grade {
    desk.play_mut().change_answers(|answers, run| answers.check(run, question, typed)).grade
}

/// The hand-in of the work at a seat, as it is read from its file.
pub fn of_seat(desk: &Desk, documents: Vec<Source>, name: &str) -> HandIn {
    let seat = desk.play().basis().seat().unwrap();
    let sender = Sender { name: name.to_owned(), seat: seat.number, assignment: seat.assignment };
    let work = Project { documents, state: desk.play().share(), items: desk::project_items(desk, 5) };
    HandIn::read(&hand_in(work, sender, 6).unwrap().write()).unwrap()
}

/// Pseudo-random numbers, normal with standard deviation 1: sums of 12 uniform ones of a linear congruential generator.
pub struct Noise(u64);

impl Noise {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.uniform()).sum::<f64>() - 6.0
    }
}

/// Times and levels of a measured column of 18 cm, with noise of 0.5 mm, in seconds and metres: 3 s at 30 frames a second.
pub fn measured(seed: u64) -> Vec<(f64, f64)> {
    sampled(seed, 90, 30.0)
}

/// Times and levels as [`measured`]: `count` rows at `rate` frames a second.
pub fn sampled(seed: u64, count: u32, rate: f64) -> Vec<(f64, f64)> {
    let mut noise = Noise::new(seed);
    let row = |index: u32| {
        let time = f64::from(index) / rate;
        let swing = 0.04 * libm::exp(-0.42 * time) * libm::cos(10.4 * time);
        (time, swing + 5e-4 * noise.normal())
    };
    (0..count).map(row).collect()
}

/// The rows as a file of data.
pub fn file(rows: &[(f64, f64)]) -> String {
    let rows = rows.iter().map(|(time, level)| format!("{time:.4},{level:.5}\n"));
    std::iter::once("t [s],y [m]\n".to_owned()).chain(rows).collect()
}

/// Work with a record of these rows, a fit of linear damping to it, and answers.
pub fn work(rows: &[(f64, f64)]) -> Project {
    answered(rows, &["0.3"])
}

/// Work as [`work`], with these answers to the question, one after the other.
pub fn answered(rows: &[(f64, f64)], answers: &[&str]) -> Project {
    let documents = linear();
    let mut desk = Desk::open(document::open(&documents[0].text, &[]).sound().unwrap());
    desk.add_record("tube.csv", file(rows).as_bytes()).unwrap();
    desk.change_fits(|fits, data| fits.begin(data, "theories/linear.md")).unwrap();
    while desk.advance_fit() {}
    assert_eq!(desk.fits().list().len(), 1);
    for typed in answers {
        desk.play_mut().change_answers(|answers, run| answers.check(run, 0, typed));
    }
    Project { documents, state: desk.play().share(), items: desk::project_items(&desk, 1_763_812_800_000) }
}

/// A hand-in of this work.
pub fn handed(rows: &[(f64, f64)], name: &str) -> HandIn {
    let sender = Sender { name: name.to_owned(), ..Sender::default() };
    hand_in(work(rows), sender, 1_763_812_900_000).unwrap()
}

/// Hand-in of a group that held the length of its column, in m, fixed and fitted g to these rows.
pub fn weighed(length: f64, rows: &[(f64, f64)], name: &str) -> HandIn {
    let mut documents = linear();
    let changes = [
        ("vary: L,", "vary: g,"),
        ("g       = 9.8 [m/s^2]\n", ""),
        ("parameter y_0", "parameter g = 9.5 [m/s^2] in 1..100 \"Gravity\"\nparameter y_0"),
    ];
    for (from, to) in changes {
        assert!(documents[0].text.contains(from), "{from}");
        documents[0].text = documents[0].text.replacen(from, to, 1);
    }
    let mut desk = Desk::open(document::open(&documents[0].text, &[]).sound().unwrap());
    let index = desk.play().model().parameters.iter().position(|one| one.name == "L").unwrap();
    desk.play_mut().change_settings(|settings| settings.set_parameter(index, length)).unwrap();
    desk.add_record("tube.csv", file(rows).as_bytes()).unwrap();
    desk.change_fits(|fits, data| fits.begin(data, "linear.md")).unwrap();
    while desk.advance_fit() {}
    let project =
        Project { documents, state: desk.play().share(), items: desk::project_items(&desk, 1_763_812_800_000) };
    let sender = Sender { name: name.to_owned(), ..Sender::default() };
    hand_in(project, sender, 1_763_812_900_000).unwrap()
}

/// Copy of a work with a film whose points have these rows, in pixels of a millimetre.
pub fn with_film(made: HandIn, rows: &[(f64, f64)]) -> HandIn {
    let point = |(frame, (time, level)): (usize, &(f64, f64))| {
        (frame, [*time, 100.0, 500.0 - level * 1000.0, 0.1, 0.1, 1.0].map(Number), false)
    };
    let points: Vec<_> = rows.iter().enumerate().map(point).collect();
    let track = TrackInFilm { direction: Some([0.0, 1.0].map(Number)), points, ..TrackInFilm::default() };
    let frames = rows.iter().enumerate().map(|(frame, (time, _))| (frame, Number(*time))).collect();
    let found = FoundInFilm { factor: Some(Number(1.0)), frames, tracks: vec![track], ..FoundInFilm::default() };
    let film = Film {
        name: "tube.mp4".to_owned(),
        size: 5,
        hash: "00ff".to_owned(),
        kind: "surfaces".to_owned(),
        followed: vec![Followed { clicks: vec![(0, [100.0, 500.0].map(Number))], ..Followed::default() }],
        points: vec![[0.0, 0.0].map(Number), [0.0, 100.0].map(Number)],
        lengths: vec!["10 cm".to_owned()],
        intervals: 1,
        scale: Some([1e-3, 1e-3].map(Number)),
        zero: Some([0.0, 500.0].map(Number)),
        stated_factor: Some(Number(1.0)),
        ends: [0, rows.len()],
        found: Some(found),
        ..Film::default()
    };
    let mut work = made.work;
    work.items.push(("film".to_owned(), Item(Content::Film(Box::new(film))).write(0)));
    hand_in(work, made.sender, made.made).unwrap()
}

/// The report of a fit of linear damping to these rows, as the laboratory saves it.
pub fn report(rows: &[(f64, f64)]) -> String {
    let documents = linear();
    let mut desk = Desk::open(document::open(&documents[0].text, &[]).sound().unwrap());
    desk.add_record("tube.csv", file(rows).as_bytes()).unwrap();
    desk.change_fits(|fits, data| fits.begin(data, "theories/linear.md")).unwrap();
    while desk.advance_fit() {}
    let fit = desk.fits().list()[0].id;
    let page = desk.fits().export(fit, ExportKind::Report, Imprint::default()).unwrap();
    let page = String::from_utf8(page.bytes).unwrap();
    let work = Project { documents, state: desk.play().share(), items: desk::items_of_fit(&desk, fit, false, 5) };
    let made = hand_in(work, Sender::default(), 6).unwrap().of_page(&page, Language::English);
    carry(&page, &compress_to_vec_zlib(made.write().as_bytes(), 9), Language::English)
}
