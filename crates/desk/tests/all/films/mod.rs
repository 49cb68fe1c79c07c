//! Films in the laboratory: tracking, record, fit, and restoring at the next visit.

mod bodies;
mod filmed;
mod projects;
mod radius;
mod records;
mod scene;
mod work;
mod zero;

use crate::support::open;
use desk::film::containers::Orientation;
use desk::film::tracking::column::Click;
use desk::{CalibrationForm, Desk, FilmOpening, FilmedBody, FilmedSurface, LengthsForm, Refusal, Subject};
use scene::{AXIS, DECAY, HEIGHT, OMEGA, PIXEL, RATE, REST, WIDTH, container, identity, level, picture, track};

/// A damped oscillation about zero.
const THEORY: &str = r#"---
title: A damped oscillation
language: en
method: rk4
step: 0.01 [s]
---

A column swings.

```model
parameter omega = 7.5 [rad/s] in 5..11 "Angular frequency"
parameter beta  = 0.1 [1/s]   in 0..2  "Damping"
parameter y_0   = 3   [cm]    in -20..20  "Start"
parameter v_0   = 0   [cm/s]  in -50..50  "Initial velocity"

y'' + 2*beta*y' + omega^2*y = 0

y(0)  = y_0   "Displacement"
y'(0) = v_0   "Velocity"
```

```plots
"Motion": y against t
```
"#;

pub fn laboratory() -> Desk {
    open(THEORY, &[])
}

/// The click on the surface in the first frame, off by three pixels.
pub fn surface() -> Subject {
    let position = [AXIS + 1.5, REST - level(0.0) + 3.0];
    Subject::Surfaces(vec![FilmedSurface::new(Click { frame: 0, position })])
}

/// A ruler of 10 cm beside the tube, with the zero at rest.
pub fn ruler() -> CalibrationForm {
    let length = "10 cm".to_owned();
    let lengths = LengthsForm::Ruler { marks: [[27.0, 60.0], [27.0, 160.0]], length, intervals: 1 };
    CalibrationForm { lengths, origin: Some([AXIS, REST]), ..CalibrationForm::default() }
}

pub fn frame(frame: usize) -> desk::film::Plane {
    picture(frame as f64 / RATE, frame as u64)
}

/// A tracked and calibrated film of more than two seconds.
pub fn tracked() -> Desk {
    let mut desk = laboratory();
    assert_eq!(
        desk.change_films(|films, play| films.open(play, identity("swing.mp4"), container(75))),
        Ok(FilmOpening::New)
    );
    desk.work_on_film(|films, play| films.follow(play, surface())).unwrap();
    assert_eq!(track(&mut desk, &frame), 75);
    desk.work_on_film(|films, play| films.calibrate(play, ruler(), None)).unwrap();
    desk
}

/// Times, values and errors of the record, as its columns show them.
fn columns(desk: &Desk) -> Vec<Vec<f64>> {
    let record = &desk.records().list()[0];
    let column = |index: usize| -> Vec<f64> {
        let cells = desk.records().cells(record.id, index, 0..record.rows);
        cells.iter().map(|cell| desk::number::parse(cell, desk.play().basis().style()).unwrap().0).collect()
    };
    (0..record.columns.len()).map(column).collect()
}

#[test]
fn a_film_becomes_a_record_with_errors() {
    let desk = tracked();
    let record = &desk.records().list()[0];
    let heads: Vec<&str> = record.columns.iter().map(|column| column.head.as_str()).collect();
    assert_eq!((record.name.as_str(), record.rows, heads), ("swing.mp4", 75, vec!["t [s]", "y [m]", "sigma_y [m]"]));
    let quantities: Vec<&str> = record.columns.iter().map(|column| column.quantity.as_str()).collect();
    assert_eq!(quantities, ["t", "y", ""], "errors measure nothing");
    let columns = columns(&desk);
    // The tracked surface has a constant offset to the true one, here three pixels, set by the click.
    let off: Vec<f64> = columns[0].iter().zip(&columns[1]).map(|(t, y)| y - PIXEL * level(*t)).collect();
    let mean = off.iter().sum::<f64>() / off.len() as f64;
    let squares = off.iter().zip(&columns[2]).map(|(off, sigma)| ((off - mean) / sigma) * ((off - mean) / sigma));
    let rms = (squares.sum::<f64>() / off.len() as f64).sqrt();
    assert!(mean.abs() < 4e-3 && (0.3..2.0).contains(&rms), "{mean} {rms}");
    assert!(desk.films().current().unwrap().doubtful().is_empty());
    let text = desk.films().position(0, 0).unwrap();
    assert!(text.starts_with("y = 0.0") && text.ends_with(" m") && text.contains('±'), "{text}");
    assert_eq!((desk.films().position(0, 75), desk.films().position(1, 0)), (None, None));
}

#[test]
fn a_fit_of_a_film_finds_the_truth() {
    let mut desk = tracked();
    // All parameters and the zero of the scale.
    (0..4).chain([5]).for_each(|choice| desk.change_fits(|fits, data| fits.vary(data.play(), choice, true)));
    desk.change_fits(|fits, data| fits.begin(data, "column.md")).unwrap();
    while desk.advance_fit() {}
    let fit = desk.fits().list()[0].id;
    let detail = desk.fits().detail(fit).unwrap();
    assert!(
        detail.sentences.iter().any(|one| one.contains("The values of y are weighted by")),
        "{:?}",
        detail.sentences
    );
    // The marks are 100 pixels apart: 0.7 pixels are 0.7 %.
    let scale = "Scale of the film 1.000 ± 0.007 (prior 1 ± 0.0071)";
    assert!(detail.sentences.iter().any(|one| one.starts_with(scale)), "{:?}", detail.sentences);
    for (name, truth) in [("omega", (OMEGA * OMEGA + DECAY * DECAY).sqrt()), ("beta", DECAY)] {
        let text = &detail.estimates.iter().find(|one| one.name == name).unwrap().value;
        let number = |text: &str| desk::number::parse(text, desk.play().basis().style()).unwrap().0;
        let (value, error) = text.split_once('±').unwrap();
        let (off, error) = (number(value) - truth, number(error));
        assert!(off.abs() < 3.0 * error && error < 0.01, "{name} = {text} for {truth}");
    }
}

#[test]
fn the_model_lies_over_the_film() {
    let mut desk = tracked();
    for (name, value) in [("omega", (OMEGA * OMEGA + DECAY * DECAY).sqrt()), ("beta", DECAY)] {
        crate::support::set(&mut desk, name, value);
    }
    crate::support::play(&mut desk, [0.5; 6]);
    assert_eq!(desk.films().frame_at_model_time(1.01), Some(30));
    assert!((desk.films().model_time_of(45).unwrap() - 1.5).abs() < 1e-9);
    // The model begins at 3 cm instead of 4 cm above rest; its speed is zero, not quite that of the film.
    let [x, y] = desk.film_model(0, &[0])[0].unwrap();
    assert!((x - AXIS).abs() < 2.0 && (y - (REST - 30.0)).abs() < 0.2, "{x} {y}");
    let curve = desk.film_model(0, &[0, 30, 74]);
    assert!(curve.iter().all(Option::is_some) && desk.film_model(1, &[0])[0].is_none());
    let film = desk.films().current().unwrap();
    let picture = film.space_time(0).unwrap();
    assert_eq!((picture.frames.len(), picture.grey.len()), (75, 75 * picture.rows));
    let point = film.tracks()[0].points[30];
    assert!((picture.position(picture.row_of(point.position))[1] - point.position[1]).abs() < 1e-9);
}

#[test]
fn a_film_that_was_held_sideways_gives_the_same_record() {
    let upright = columns(&tracked());
    for (quarter_turns, mirrored) in [(1, false), (2, false), (3, true)] {
        let mut container = container(75);
        container.orientation = Orientation { quarter_turns, mirrored };
        container.size = container.orientation.upright_size([WIDTH as u32, HEIGHT as u32]);
        let size = container.size.map(f64::from);
        let orientation = container.orientation;
        let stored = move |at: usize| {
            let plane = frame(at);
            let pixel = |x: u32, y: u32| {
                let [u, v] = orientation.upright([f64::from(x) + 0.5, f64::from(y) + 0.5], size);
                plane.pixel(u as i64, v as i64)
            };
            let rows = (0..size[1] as u32).flat_map(|y| (0..size[0] as u32).map(move |x| (x, y)));
            desk::film::Plane::new(size[0] as usize, size[1] as usize, rows.map(|(x, y)| pixel(x, y)).collect())
                .unwrap()
        };
        let mut desk = laboratory();
        desk.change_films(|films, play| films.open(play, identity("sideways.mp4"), container)).unwrap();
        assert_eq!(desk.films().current().unwrap().clip().size(), [WIDTH as f64, HEIGHT as f64]);
        desk.work_on_film(|films, play| films.follow(play, surface())).unwrap();
        track(&mut desk, &stored);
        desk.work_on_film(|films, play| films.calibrate(play, ruler(), None)).unwrap();
        let turned = columns(&desk);
        let far = upright[1].iter().zip(&turned[1]).fold(0.0_f64, |far, (one, other)| far.max((one - other).abs()));
        assert!(far < 0.1 * PIXEL, "{quarter_turns} {mirrored}: {far}");
    }
}

#[test]
fn without_a_scale_the_record_is_in_pixels() {
    let mut desk = laboratory();
    desk.change_films(|films, play| films.open(play, identity("swing.mp4"), container(75))).unwrap();
    desk.work_on_film(|films, play| films.follow(play, surface())).unwrap();
    track(&mut desk, &frame);
    let record = &desk.records().list()[0];
    assert_eq!(record.rows, 75);
    assert!(
        desk.records().cells(record.id, 1, 0..1)[0].starts_with("15"),
        "{:?}",
        desk.records().cells(record.id, 1, 0..1)
    );
    assert!(desk.films().notes().iter().any(|note| note.contains("pixels")));
    assert!(desk.film_model(0, &[0])[0].is_none());
    // Positions in pixels are not lengths: no points are drawn, and a fit states the remedy.
    let column = &record.columns[1];
    assert_eq!((column.head.as_str(), column.quantity.as_str(), column.unit_asked), ("y [px]", "y", true));
    assert!(!desk.measured().has_points());
    desk.change_fits(|fits, data| fits.vary(data.play(), 0, true));
    let refused = desk.change_fits(|fits, data| fits.begin(data, "column.md")).unwrap_err();
    let text = refused.text(desk.play());
    assert!(text.contains("swing.mp4, y: in pixels: give the film a scale: two clicks on the ruler"), "{text}");
    desk.set_language("es");
    let refused = desk.change_fits(|fits, data| fits.begin(data, "column.md")).unwrap_err();
    assert!(refused.text(desk.play()).contains("dos clics en la regla"));
    desk.set_language("en");
    let id = record.id;
    desk.work_on_film(|films, play| films.calibrate(play, ruler(), None)).unwrap();
    assert!(desk.measured().has_points());
    assert_eq!((desk.records().list()[0].id, desk.records().list()[0].columns[1].head.as_str()), (id, "y [m]"));
}

#[test]
fn marks_between_two_refine_the_scale() {
    let mut desk = tracked();
    let mut form = ruler();
    form.lengths = LengthsForm::Ruler { marks: [[27.0, 60.6], [27.0, 160.0]], length: "10 cm".into(), intervals: 10 };
    assert!(
        matches!(desk.work_on_film(|films, play| films.calibrate(play, form.clone(), None)), Err(Refusal::Film { .. })),
        "it needs a picture"
    );
    desk.work_on_film(|films, play| films.calibrate(play, form, Some(&frame(0)))).unwrap();
    let desk::film::calibration::Lengths::Scale(scale) = desk.films().current().unwrap().calibration().lengths else {
        panic!()
    };
    assert!((scale.pixel / PIXEL - 1.0).abs() < 4e-3 && scale.relative_sigma < 7e-3, "{scale:?}");
}

#[test]
fn repeated_pictures_are_left_out() {
    let mut desk = laboratory();
    desk.change_films(|films, play| films.open(play, identity("converted.mp4"), container(75))).unwrap();
    desk.work_on_film(|films, play| films.follow(play, surface())).unwrap();
    // Every fifth frame repeats the one before.
    let shown = |at: usize| if at % 5 == 4 { at - 1 } else { at };
    let asked = track(&mut desk, &|at| frame(shown(at)));
    assert_eq!((asked, desk.records().list()[0].rows), (75 + 60, 60));
    assert!(desk.films().notes().iter().any(|note| note.contains("15 of 75")), "{:?}", desk.films().notes());
}

#[test]
fn times_follow_the_factor_and_the_part() {
    let mut desk = tracked();
    desk.work_on_film(|films, play| films.set_factor(play, "240/30")).unwrap();
    assert!((columns(&desk)[0][74] - 74.0 / RATE / 8.0).abs() < 1e-6);
    desk.work_on_film(|films, play| films.set_part(play, [Some(1.0), None])).unwrap();
    assert_eq!(desk.records().list()[0].rows, 45);
    for (typed, rows) in [("500 ms", 60), ("1/2", 60), ("0,5", 60), ("0.02 min", 39), ("", 75)] {
        desk.work_on_film(|films, play| films.set_end(play, 0, typed)).unwrap();
        assert_eq!(desk.records().list()[0].rows, rows, "{typed}");
    }
    desk.work_on_film(|films, play| films.set_factor(play, "")).unwrap();
    assert_eq!((desk.records().list()[0].rows, desk.films().current().unwrap().factor()), (75, 1.0));
}

#[test]
fn refusals_change_nothing_and_have_words_in_both_languages() {
    type Wrong = (&'static str, fn(&mut Desk) -> Result<(), Refusal>);
    let wrong: [Wrong; 11] = [
        ("click", |desk| {
            let position = [500.0, 10.0];
            desk.work_on_film(|films, play| {
                films.follow(play, Subject::Bodies(vec![FilmedBody::new(Click { frame: 0, position })]))
            })
        }),
        ("surfaces", |desk| match surface() {
            Subject::Surfaces(one) => {
                desk.work_on_film(|films, play| films.follow(play, Subject::Surfaces([&one[..], &one, &one].concat())))
            }
            _ => Ok(()),
        }),
        ("length", |desk| length(desk, "ten")),
        ("unit", |desk| length(desk, "10")),
        ("dimension", |desk| length(desk, "10 kg")),
        ("sign", |desk| length(desk, "-10 cm")),
        ("factor", |desk| desk.work_on_film(|films, play| films.set_factor(play, "fast"))),
        ("no time", |desk| desk.work_on_film(|films, play| films.set_end(play, 0, "abc"))),
        ("time in kg", |desk| desk.work_on_film(|films, play| films.set_end(play, 1, "3 kg"))),
        ("late", |desk| desk.work_on_film(|films, play| films.set_end(play, 0, "100 s"))),
        ("part", |desk| desk.work_on_film(|films, play| films.set_part(play, [Some(2.0), Some(1.0)]))),
    ];
    let mut desk = tracked();
    for (what, ask) in wrong {
        let before = format!("{:?} {:?}", desk.records().list(), desk.films().current());
        let refusal = ask(&mut desk).expect_err(what);
        assert_eq!(format!("{:?} {:?}", desk.records().list(), desk.films().current()), before, "{what}");
        desk.set_language("en");
        let english = ask(&mut desk).unwrap_err();
        let english = english.text(desk.play());
        desk.set_language("es");
        let spanish = ask(&mut desk).unwrap_err();
        let spanish = spanish.text(desk.play());
        desk.set_language("en");
        assert!(english != spanish && !english.is_empty(), "{what}: {refusal:?}");
    }
    assert!(laboratory().change_films(|films, play| films.begin_tracking(play)).is_err());
}

fn length(desk: &mut Desk, typed: &str) -> Result<(), Refusal> {
    let lengths = LengthsForm::Ruler { marks: [[27.0, 60.0], [27.0, 160.0]], length: typed.to_owned(), intervals: 1 };
    desk.work_on_film(|films, play| {
        films.calibrate(play, CalibrationForm { lengths, ..CalibrationForm::default() }, None)
    })
}

#[test]
fn a_point_is_clicked_by_hand() {
    let mut desk = laboratory();
    desk.change_films(|films, play| films.open(play, identity("ball.mp4"), container(75))).unwrap();
    let click = |frame: usize| Click { frame, position: [10.0 + frame as f64, HEIGHT as f64 - 20.0] };
    // A single point does not make a record.
    desk.work_on_film(|films, play| films.follow(play, Subject::Points { clicks: vec![click(9)], sigma: 1.0 }))
        .unwrap();
    assert!(desk.records().list().is_empty());
    desk.work_on_film(|films, play| {
        films.follow(play, Subject::Points { clicks: vec![click(9), click(3), click(6)], sigma: 1.0 })
    })
    .unwrap();
    let columns = columns(&desk);
    assert_eq!(columns[1], [13.0, 16.0, 19.0]);
    assert_eq!(columns[3], [1.0, 1.0, 1.0]);
    assert!(desk.films().notes().iter().any(|note| note.contains("1 px")), "{:?}", desk.films().notes());
    assert!(desk.change_films(|films, play| films.begin_tracking(play)).is_err(), "there is nothing to track");
}

/// A model whose lengths are pixels needs no scale.
#[test]
fn a_record_in_pixels_is_fitted_by_a_model_in_pixels() {
    let theory = THEORY.replace("[cm] ", "[px] ").replace("[cm/s]", "[px/s]").replace("in -20..20", "in -200..200");
    let mut desk = open(&theory.replace("in -50..50", "in -500..500"), &[]);
    desk.change_films(|films, play| films.open(play, identity("swing.mp4"), container(75))).unwrap();
    desk.work_on_film(|films, play| films.follow(play, surface())).unwrap();
    track(&mut desk, &frame);
    let columns = &desk.records().list()[0].columns;
    assert_eq!((columns[1].quantity.as_str(), columns[1].unit.as_str(), columns[1].unit_asked), ("y", "px", false));
    assert!(desk.measured().has_points());
    (0..4).chain([5]).for_each(|choice| desk.change_fits(|fits, data| fits.vary(data.play(), choice, true)));
    desk.change_fits(|fits, data| fits.begin(data, "column.md")).unwrap();
    while desk.advance_fit() {}
    let detail = desk.fits().detail(desk.fits().list()[0].id).unwrap();
    let start = detail.estimates.iter().find(|one| one.name == "y_0").unwrap();
    let (value, _) = desk::number::parse(&start.value, desk.play().basis().style()).unwrap();
    // Four centimetres above rest, in pixels of a millimetre.
    assert!(start.unit == "px" && (value - 40.0).abs() < 0.5, "{start:?}");
    assert!(!detail.sentences.iter().any(|one| one.contains("Scale of the film")));
}
