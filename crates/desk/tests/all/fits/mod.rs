//! Fits of several records with shared numbers, and fits that are restored at the next visit.

mod first;
mod saved;
mod several;
mod workers;

use desk::document;
use desk::{Desk, FitDetail};
use figure::{Direction, Settings};
use play::PlotId;
use std::path::Path;

fn theory(name: &str) -> document::Document {
    let [text, translation] = ["md", "es.md"].map(|ending| theory_text(&format!("{name}.{ending}")));
    document::open(&text, &[&translation]).document.unwrap()
}

fn theory_text(file: &str) -> String {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../simulations/theories");
    std::fs::read_to_string(directory.join(file)).unwrap()
}

fn place(desk: &Desk, name: &str) -> usize {
    desk.fits().choices().iter().find(|choice| choice.name == name).expect(name).index
}

/// A film of a column that is released at 4 cm: 30 frames per second, with reproducible noise.
fn film(length: f64, damping: f64, seed: u64) -> String {
    let omega = (19.6 / length - damping * damping).sqrt();
    let mut state = seed;
    let row = |frame: u32| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let noise = ((state >> 33) as f64 / f64::from(1_u32 << 31) - 0.5) * 4e-4;
        let t = f64::from(frame) / 30.0;
        let swing = libm::cos(omega * t) + damping / omega * libm::sin(omega * t);
        format!("{t} {}\n", 0.04 * libm::exp(-damping * t) * swing + noise)
    };
    (0..180).map(row).collect()
}

const LENGTHS: [f64; 3] = [0.18, 0.24, 0.3];
const DAMPING: f64 = 0.4;

/// Linear damping and three records with different lengths and the same friction.
fn three() -> Desk {
    let mut desk = Desk::open(theory("linear"));
    for (length, seed) in LENGTHS.into_iter().zip(1..) {
        desk.add_record(&format!("tube {seed}.txt"), film(length, DAMPING, seed).as_bytes()).unwrap();
    }
    desk
}

fn together(desk: &mut Desk) {
    desk.fits().records().iter().for_each(|record| desk.change_fits(|fits, _| fits.include(record.id, true)));
}

fn fit(desk: &mut Desk) -> FitDetail {
    desk.change_fits(|fits, data| fits.begin(data, "theories/linear.md")).unwrap();
    while desk.advance_fit() {}
    let last = desk.fits().list().iter().map(|fit| fit.id).max().unwrap();
    desk.fits().detail(last).unwrap()
}

/// A single 9999 for a missing measurement dominates a fit of least squares.
#[test]
fn a_fit_that_one_value_decides_is_in_doubt() {
    let mut desk = Desk::open(theory("linear"));
    let record = film(0.24, DAMPING, 1);
    let (time, _) = record.lines().nth(100).unwrap().split_once(' ').unwrap();
    let wrong = |row: &str| if row.starts_with(time) { format!("{time} 9999") } else { row.to_owned() };
    let record: Vec<String> = record.lines().map(wrong).collect();
    desk.add_record("sentinel.txt", record.join("\n").as_bytes()).unwrap();
    let detail = fit(&mut desk);
    assert_eq!(detail.doubt.as_deref(), Some("Outliers dominate the fit."), "{:?}", detail.sentences);
}

/// A column of 2 m or more oscillates too slowly for the record.
#[test]
fn a_fit_that_misses_the_record_is_in_doubt() {
    let mut desk = Desk::open(document::open(&theory_text("../utube.md"), &[]).document.unwrap());
    desk.add_record("film.txt", film(0.24, DAMPING, 1).as_bytes()).unwrap();
    let before = desk.play().course().parameters().to_vec();
    desk.change_fits(|fits, data| fits.begin(data, "utube.md")).unwrap();
    while desk.advance_fit() {}
    assert_eq!(desk.play().course().parameters(), before);
    let detail = desk.fits().detail(desk.fits().list()[0].id).unwrap();
    assert!(detail.sentences[0].starts_with("The curve misses the data"), "{detail:?}");
    assert_eq!(detail.doubt.unwrap(), "The model does not describe these data.");
    let said = std::iter::from_fn(|| desk.take_announcement()).last().unwrap();
    let why = said.text(desk.play());
    assert!(why.contains("The model does not describe these data."), "{why}");
}

#[test]
fn a_best_value_at_an_end_of_its_range_is_in_doubt() {
    for (damping, doubtful) in [(-0.1, true), (DAMPING, false)] {
        let mut desk = Desk::open(theory("linear"));
        // A growing oscillation has negative damping, which the theory excludes.
        desk.add_record("grows.txt", film(0.24, damping, 1).as_bytes()).unwrap();
        let detail = fit(&mut desk);
        let doubt = "gamma = 0 1/s is in doubt: it stands at an end of the range";
        assert_eq!(detail.sentences.iter().any(|one| one.starts_with(doubt)), doubtful, "{:?}", detail.sentences);
        // A doubtful result is not applied automatically, and the message states the reason.
        let length = |desk: &Desk| desk.play().course().parameters()[place(desk, "L")];
        assert_eq!(length(&desk) == 0.2, doubtful);
        let said = std::iter::from_fn(|| desk.take_announcement()).last().unwrap();
        let why = said.text(desk.play());
        assert_eq!(why.contains("The search has stopped at an end of the range: γ."), doubtful, "{why}");
        desk.apply_fit(desk.fits().list()[0].id);
        assert_ne!(length(&desk), 0.2);
    }
}

/// Points are drawn from the beginning of the model, but the window counts on the record's clock.
#[test]
fn the_part_in_a_plot_is_that_of_the_record_wherever_its_clock_begins() {
    for begin in [0.0, 2.5, -1.25, 1000.0] {
        let mut desk = Desk::open(theory("linear"));
        let shifted = |row: &str| {
            let (time, value) = row.split_once(' ').unwrap();
            format!("{} {value}\n", time.parse::<f64>().unwrap() + begin)
        };
        let record: String = film(0.24, DAMPING, 1).lines().map(shifted).collect();
        desk.add_record("tube.txt", record.as_bytes()).unwrap();
        assert!(!desk.fits().has_part_in_plot());
        let plot = PlotId::at(0);
        desk.follow();
        desk.play_mut().layout_plot(plot, &Settings::default());
        desk.play_mut().change_plots(|plots, _| plots.zoom(plot, None, 2.0, Direction::Horizontal));
        let part = desk.play().plots().zoomed_part().unwrap();
        desk.change_fits(|fits, data| fits.take_part_in_plot(data));
        let [from, until] = desk.fits().fitted_part().map(Option::unwrap);
        assert!(
            (from - part.low - begin).abs() < 1e-9 && (until - part.high - begin).abs() < 1e-9,
            "{begin}: {from} {until}"
        );
        // With two records whose clocks begin at different readings there is no such part.
        desk.add_record("other.txt", film(0.24, DAMPING, 2).as_bytes()).unwrap();
        together(&mut desk);
        assert_eq!(desk.fits().has_part_in_plot(), begin == 0.0, "{begin}");
    }
}
