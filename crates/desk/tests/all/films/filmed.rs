//! Films of the simulation itself: recipe, truth, and the same film at the next visit.

use super::scene::{AXIS, HEIGHT, PIXEL, REST, WIDTH, level, picture};
use super::{ruler, surface};
use crate::support::open;
use desk::film::Plane;
use desk::film::tracking::column::Click;
use desk::{CameraSettings, Desk, FILMED_SIZE, FilmOpening, FilmRecipe, FilmTruth, Subject};
use units::Language;

/// A level in a frame of 24 cm.
const SIMULATION: &str = r#"---
title: A swinging level
language: en
method: rk4
step: 0.01 [s]
until: 60 [s]
---

A column swings.

```model
parameter omega = 8 [rad/s] in 5..11   "Angular frequency"
parameter y_0   = 4 [cm]    in -20..20 "Start"

y'' + omega^2*y = 0

y(0)  = y_0         "Displacement"
y'(0) = 0 [cm/s]    "Velocity"
```

```scene
<svg viewBox="0 0 160 240">
  <frame x="0 [m]..0.16 [m]" y="-0.12 [m]..0.12 [m]">
    <circle at="(0.08 [m], y)" r="4px"/>
  </frame>
</svg>
```
"#;

fn recipe(desk: &Desk, change: impl FnOnce(&mut CameraSettings)) -> FilmRecipe {
    let mut settings = desk.films().usual_camera().unwrap();
    change(&mut settings);
    desk.films().recipe(settings).unwrap()
}

/// The drawn tube in a picture of the camera.
fn plane(time: f64, seed: u64) -> Plane {
    let [width, height] = FILMED_SIZE;
    let drawn = picture(time, seed);
    let mut grey = vec![200; width * height];
    for (line, own) in grey.chunks_mut(width).zip(drawn.grey().chunks(WIDTH)).take(HEIGHT) {
        line[..WIDTH].copy_from_slice(own);
    }
    Plane::new(width, height, grey).unwrap()
}

/// True positions of moving points in the drawing: the level, another object, and one that is not always visible.
fn truth(settings: &CameraSettings, frames: usize) -> FilmTruth {
    let times: Vec<f64> = (0..frames).map(|frame| settings.time(frame)).collect();
    let part = |place: &dyn Fn(f64) -> [f64; 2]| times.iter().map(|time| place(*time)).collect::<Vec<_>>();
    FilmTruth {
        pixel: Some(PIXEL),
        ruler: None,
        parts: vec![
            part(&|time| [AXIS, REST + level(time)]),
            part(&|time| [AXIS, REST - level(time)]),
            part(&|time| if time < 1.0 { [AXIS, REST - level(time)] } else { [f64::NAN; 2] }),
        ],
    }
}

/// Films, follows the level and calibrates.
fn filmed(desk: &mut Desk, recipe: &FilmRecipe, frames: usize) -> FilmOpening {
    let opening = desk
        .change_films(|films, play| films.open_filmed(play, recipe.clone(), frames, truth(&recipe.settings, frames)))
        .unwrap();
    if opening == FilmOpening::New {
        desk.work_on_film(|films, play| films.follow(play, surface())).unwrap();
        super::scene::track(desk, &|frame| plane(recipe.settings.time(frame), frame as u64));
    }
    opening
}

#[test]
fn a_track_is_compared_with_the_truth() {
    let mut desk = open(SIMULATION, &[]);
    let recipe = recipe(&desk, |_| ());
    assert_eq!(filmed(&mut desk, &recipe, 75), FilmOpening::New);
    assert!(
        desk.films().notes().iter().any(|note| note.starts_with("Virtual camera: exposure 4.0 ms")),
        "{:?}",
        desk.films().notes()
    );
    let [comparison] = &desk.films().compare_with_truth()[..] else { panic!("one surface") };
    assert!((0.001..0.1).contains(&comparison.rms), "{}", comparison.rms);
    assert_eq!(comparison.metres, Some(comparison.rms * PIXEL));
    assert_eq!((comparison.scale_error, comparison.differences.len()), (None, 75));
    let mean = comparison.differences.iter().map(|(_, both)| both[0]).sum::<f64>() / 75.0;
    assert!(mean.abs() < 1e-9, "{mean}");
    // The clicked point moves like the level.
    let [first, later] = [0, 40].map(|at| comparison.path[at].1[1] + level(recipe.settings.time(at)));
    assert!((first - later).abs() < 1e-9, "{first} {later}");
    // The marks are 100 pixels apart, which are 10 cm: the scale is right.
    desk.work_on_film(|films, play| films.calibrate(play, ruler(), None)).unwrap();
    let error = desk.films().compare_with_truth()[0].scale_error.unwrap();
    assert!(error.abs() < 1e-9, "{error}");
}

#[test]
fn the_same_recipe_is_the_same_film_at_the_next_visit() {
    let mut desk = open(SIMULATION, &[]);
    crate::support::set(&mut desk, "y_0", 0.05);
    let recipe = recipe(&desk, |settings| settings.noise = 3.0);
    filmed(&mut desk, &recipe, 75);
    let saved = desk.films().saved();
    let mut next = open(SIMULATION, &[]);
    for (name, item) in &saved {
        assert_eq!(next.restore_item(item).as_ref(), Some(name));
    }
    assert_eq!(next.films().recipes(), std::slice::from_ref(&recipe));
    let play = next.films().filmed_play(&recipe).unwrap();
    assert_eq!(play.course().parameters(), desk.play().course().parameters());
    assert_eq!(filmed(&mut next, &recipe, 75), FilmOpening::TakenUp);
    assert_eq!(next.films().recipes(), [], "the open one is not offered again");
    // The tracks are shown at once. Only the strips are read; nothing is computed.
    let found = next.films().current().unwrap().tracks();
    assert_eq!(found, desk.films().current().unwrap().tracks());
    next.change_films(|films, play| films.take_up_tracking(play)).unwrap();
    while let Some(frame) = next.films().wanted_frame() {
        next.change_films(|films, play| {
            films.give_frame(play, frame, plane(recipe.settings.time(frame), frame as u64))
        })
        .unwrap();
        if frame == 30 {
            next.change_films(|films, _| films.show_strips());
            let picture = next.films().current().unwrap().space_time(0).unwrap();
            assert_eq!((picture.frames.len(), picture.read), (75, 31));
        }
    }
    assert_eq!(next.advance_tracking(1), Ok(true));
    assert!(!next.films().is_tracking() && next.films().current().unwrap().tracks() == found);
    assert_eq!(next.films().current().unwrap().space_time(0), desk.films().current().unwrap().space_time(0));
    // A correction does not need the frames again.
    let at = found[0].points[20].position;
    next.change_films(|films, play| films.anchor_surface(play, 0, Click { frame: 20, position: at })).unwrap();
    assert_eq!(next.films().wanted_frame(), None);
    while !next.advance_tracking(10).unwrap() {}
    let again = next.films().current().unwrap().tracks();
    assert!((again[0].points[40].position[1] - found[0].points[40].position[1]).abs() < 0.02);
}

#[test]
fn another_number_is_another_film() {
    let desk = open(SIMULATION, &[]);
    let usual = recipe(&desk, |_| ());
    let others = [
        recipe(&desk, |settings| settings.seed = 2),
        recipe(&desk, |settings| settings.noise = 1.0),
        recipe(&desk, |settings| settings.exposure = 0.0),
        recipe(&desk, |settings| settings.rate = 60.0),
    ];
    assert_eq!(usual.identity(), recipe(&desk, |_| ()).identity());
    assert!(others.iter().all(|other| !other.identity().is_same_film(&usual.identity())));
    // The first exposure begins with the run, and frames follow at whole microseconds.
    let settings = CameraSettings { seconds: 2.0, rate: 30.0, exposure: 0.01, noise: 0.0, seed: 1 };
    assert_eq!([0, 1, 30].map(|frame| settings.time(frame)), [0.005, 0.038334, 1.005]);
}

#[test]
fn what_no_camera_can_film_is_refused_in_both_languages() {
    let mut desk = super::laboratory();
    for (language, reason) in [("en", "no scene"), ("es", "no tiene escena")] {
        desk.set_language(language);
        let why = desk.films().usual_camera().unwrap_err();
        assert!(why.text(desk.play()).contains(reason), "{}", why.text(desk.play()));
    }
    let mut desk = open(SIMULATION, &[]);
    let usual = desk.films().usual_camera().unwrap();
    for wrong in [
        CameraSettings { seconds: f64::NAN, ..usual },
        CameraSettings { seconds: 1e9, ..usual },
        CameraSettings { rate: 0.0, ..usual },
        CameraSettings { exposure: 1.0, ..usual },
        CameraSettings { exposure: -1e-3, ..usual },
        CameraSettings { noise: 1e3, ..usual },
    ] {
        let words = wrong.check().unwrap_err();
        assert!(words.text(Language::English) != words.text(catalogues::with(Language::Spanish)));
        assert!(desk.films().recipe(wrong).is_err(), "{wrong:?}");
    }
    // Another version of the document is another simulation.
    let recipe = recipe(&desk, |_| ());
    assert!(open(&SIMULATION.replace("= 8 ", "= 9 "), &[]).films().filmed_play(&recipe).is_err());
    // Without known truth there is no comparison.
    assert_eq!(desk.films().compare_with_truth(), []);
    desk.change_films(|films, play| films.open(play, super::identity("file.mp4"), super::container(20))).unwrap();
    desk.work_on_film(|films, play| films.follow(play, Subject::Nothing)).unwrap();
    assert_eq!(desk.films().compare_with_truth(), []);
}
