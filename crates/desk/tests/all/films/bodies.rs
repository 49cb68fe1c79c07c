//! From a simulation to its constants: a pendulum and a thrown ball are filmed, tracked, calibrated and fitted.

use super::scene::track;
use crate::support::{open, set};
use desk::film::Plane;
use desk::film::camera::{Exposure, Noise, instants};
use desk::film::tracking::column::Click;
use desk::{CalibrationForm, CameraSettings, Desk, FILMED_SIZE, FilmTruth, FilmedBody, LengthsForm, Subject};

/// A bob on a thread, with its coordinates about the pivot.
const PENDULUM: &str = r#"---
title: A pendulum
language: en
method: dormand-prince
step: 0.02 [s]
until: 60 [s]
tolerance: 1e-9
---

A bob swings on a thread.

```model
parameter l       = 1    [m]     in 0.1..10   "Length"
parameter g       = 9.81 [m/s^2] in 1..30     "Gravitational acceleration"
parameter theta_0 = 20   [deg]   in -179..179 "Angle at the start"
parameter gamma   = 0.05 [1/s]   in 0..10     "Damping rate"

theta'' = -g/l*sin(theta) - 2*gamma*theta'

theta(0)  = theta_0      "Angle"
theta'(0) = 0 [rad/s]    "Angular velocity"

x = l*sin(theta)  in [m] "To the right"
y = -l*cos(theta) in [m] "Upwards"
```

```scene
<svg viewBox="0 0 10 10"><circle cx="5" cy="5" r="1"/></svg>
```
"#;
const PROJECTILE: &str = include_str!("../../../../../simulations/projectile.md");

/// A filmed scene: a document, the position of its body in metres as a function of the states, the zero, and the size
/// of a pixel.
struct Scene {
    source: &'static str,
    settings: CameraSettings,
    body: fn(&[f64]) -> [f64; 2],
    origin: [f64; 2],
    pixel: f64,
}

/// A dark ball of nine pixels on a bright wall.
fn drawing([x, y]: [f64; 2]) -> Plane {
    let [width, height] = FILMED_SIZE;
    let grey = |at: usize| {
        let far = libm::hypot((at % width) as f64 + 0.5 - x, (at / width) as f64 + 0.5 - y);
        let dark = if far < 14.0 { 0.5 * (1.0 - libm::erf((far - 9.0) / 1.1)) } else { 0.0 };
        (200.0 - 140.0 * dark).round() as u8
    };
    Plane::new(width, height, (0..width * height).map(grey).collect()).expect("a picture")
}

/// Films the simulation of the desk, clicks the body slightly off its centre, and marks a ruler of 500 pixels.
fn filmed(scene: &Scene) -> Desk {
    let mut desk = open(scene.source, &[]);
    let recipe = desk.films().recipe(scene.settings).expect("a recipe");
    let mut play = desk.films().filmed_play(&recipe).expect("its run");
    play.change_run(|line, _| line.play());
    while play.course().front() < scene.settings.seconds + 0.1 && !play.course().has_ended() {
        play.change_run(|line, _| line.tick(0.05));
    }
    let mut state = vec![0.0; play.model().states.len()];
    let mut place = |time: f64| {
        play.change_run(|line, _| line.state_at(time, &mut state)).expect("the run has come there");
        let [x, y] = (scene.body)(&state);
        [scene.origin[0] + x / scene.pixel, scene.origin[1] - y / scene.pixel]
    };
    let noise = Noise::new(scene.settings.noise, 1);
    let mut planes = Vec::new();
    for frame in 0..scene.settings.frames() {
        let mut drawings =
            instants(scene.settings.time(frame), scene.settings.exposure, 4).map(|time| drawing(place(time)));
        let mut exposure = Exposure::new(&drawings.next().expect("a drawing"));
        drawings.for_each(|drawing| assert!(exposure.add(&drawing)));
        planes.push(exposure.develop(&noise, frame as u64).expect("a picture"));
    }
    let [x, y] = place(scene.settings.time(0));
    desk.change_films(|films, play| {
        films.open_filmed(
            play,
            recipe,
            planes.len(),
            FilmTruth { pixel: Some(scene.pixel), ruler: None, parts: Vec::new() },
        )
    })
    .expect("opened");
    desk.work_on_film(|films, play| {
        films.follow(play, Subject::Bodies(vec![FilmedBody::new(Click { frame: 0, position: [x + 1.5, y - 1.0] })]))
    })
    .expect("a body");
    track(&mut desk, &|frame| planes[frame].clone());
    let lengths = LengthsForm::Ruler {
        marks: [[70.0, 350.0], [570.0, 350.0]],
        length: format!("{} m", 500.0 * scene.pixel),
        intervals: 1,
    };
    let form = CalibrationForm { lengths, origin: Some(scene.origin), ..CalibrationForm::default() };
    desk.work_on_film(|films, play| films.calibrate(play, form, None)).expect("a scale");
    desk
}

/// Fits some parameters from other starts, and the zeros of clock and scale: the first exposure ends slightly after the
/// start, and the click off the centre shifts positions. Returns value and standard error by name.
fn fitted(desk: &mut Desk, varied: &[(&str, f64)]) -> impl Fn(&str) -> [f64; 2] + use<> {
    let choices = desk.fits().choices();
    let parameters = desk.play().model().parameters.len();
    for choice in &choices {
        let zero = choice.index >= parameters;
        desk.change_fits(|fits, data| {
            fits.vary(data.play(), choice.index, zero || varied.iter().any(|(name, _)| *name == choice.name))
        });
    }
    varied.iter().for_each(|(name, value)| set(desk, name, *value));
    desk.change_fits(|fits, data| fits.begin(data, "theory.md")).expect("a fit");
    while desk.advance_fit() {}
    let detail = desk.fits().detail(desk.fits().list()[0].id).expect("it is finished");
    let style = desk.play().basis().style();
    move |name: &str| {
        let text = &detail.estimates.iter().find(|one| one.name == name).unwrap_or_else(|| panic!("{name}")).value;
        let number = |text: &str| desk::number::parse(text, style).expect("a number").0;
        let (value, error) = text.split_once('±').unwrap_or_else(|| panic!("{name}: {text}"));
        [number(value), number(error)]
    }
}

fn near(name: &str, [value, error]: [f64; 2], truth: f64, most: f64) {
    assert!((value - truth).abs() < 3.0 * error && error < most, "{name}: {value} ± {error}, not {truth}");
}

#[test]
fn a_filmed_pendulum_gives_g() {
    let settings = CameraSettings { seconds: 8.0, rate: 30.0, exposure: 0.004, noise: 2.0, seed: 1 };
    let body = |state: &[f64]| [libm::sin(state[0]), -libm::cos(state[0])];
    let mut desk = filmed(&Scene { source: PENDULUM, settings, body, origin: [320.0, 20.0], pixel: 1.0 / 300.0 });
    assert_eq!(desk.films().current().expect("it is open").tracks()[0].points.len(), 240);
    let found = fitted(&mut desk, &[("g", 9.0), ("theta_0", 18.0_f64.to_radians()), ("gamma", 0.1)]);
    // The length of the thread is known, so that the period gives g.
    near("g", found("g"), 9.81, 0.02);
    near("theta_0", found("theta_0"), 20.0, 0.1);
    near("gamma", found("gamma"), 0.05, 1e-3);
}

#[test]
fn a_filmed_throw_gives_g() {
    let settings = CameraSettings { seconds: 2.5, rate: 60.0, exposure: 0.002, noise: 2.0, seed: 1 };
    let body = |state: &[f64]| [state[0], state[1]];
    let mut desk = filmed(&Scene { source: PROJECTILE, settings, body, origin: [40.0, 330.0], pixel: 0.1 });
    assert_eq!(desk.films().current().expect("it is open").tracks()[0].points.len(), 150);
    let found = fitted(&mut desk, &[("g", 9.0), ("v_0", 28.0), ("alpha", 47.0_f64.to_radians())]);
    near("g", found("g"), 9.81, 0.1);
    near("v_0", found("v_0"), 30.0, 0.2);
    near("alpha", found("alpha"), 45.0, 0.2);
}
