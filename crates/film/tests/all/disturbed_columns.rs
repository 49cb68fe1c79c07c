//! Surfaces in films with all that disturbs.

use crate::tubes::{Draw, Filmed, Taken, kind};
use film::tracking::column::{Click, Column, Settings};
use film::tracking::{Following, Marks, Plan, Similarity, Surface, Track};

/// The track of a click near the surface, and how far each point is from the truth.
fn tracked(film: &Filmed, taken: &Taken, seed: u64) -> (Track, Vec<f64>) {
    let mut draw = Draw::new(seed);
    let frame = (draw.next() * 0.4 * taken.planes.len() as f64) as usize;
    let [x, y] = taken.seen[frame];
    let click = Click { frame, position: [x + draw.between(-1.5, 1.5), y + draw.between(-1.5, 1.5)] };
    tracked_from(film, taken, click)
}

/// The track of a click, and how far each point is from the truth.
fn tracked_from(film: &Filmed, taken: &Taken, click: Click) -> (Track, Vec<f64>) {
    let tube = (film.tilt != 0.0).then_some(taken.axis);
    let mut column = Column::new(Settings { tube, ..Settings::new(click) });
    for (number, plane) in taken.planes.iter().enumerate() {
        column.take(number, number as f64 / 30.0, plane, Similarity::IDENTITY).unwrap();
    }
    let track = column.finish().unwrap();
    let (sine, cosine) = libm::sincos(film.tilt);
    let error = |[x, y]: [f64; 2], [u, v]: [f64; 2]| (y - v) * cosine - (x - u) * sine;
    let errors = track.points.iter().map(|point| error(point.position, taken.truth[point.frame])).collect();
    (track, errors)
}

/// Asserts that no unmarked frame is wrong, and that at most `most` of the right ones are in doubt.
fn assert_loud(name: &str, seeds: &[u64], most: f64) {
    let (mut right, mut doubted) = (0.0, 0.0);
    for seed in seeds {
        let film = kind(name, *seed, true);
        let taken = film.film();
        let (track, errors) = tracked(&film, &taken, *seed);
        for (point, error) in track.points.iter().zip(errors) {
            let wrong = error.abs() > 6.0;
            assert!(point.doubtful || !wrong, "{name} {seed}, frame {}: {error:.1} px", point.frame);
            if !wrong && !taken.hidden[point.frame] {
                right += 1.0;
                doubted += f64::from(u8::from(point.doubtful));
            }
        }
    }
    assert!(doubted <= most * right, "{name}: {doubted} of {right} right frames are in doubt");
}

#[test]
fn marks_at_rest_inside_the_bore_do_not_capture_the_curve() {
    for name in ["clean", "steps", "dark", "textured"] {
        assert_loud(name, &[1, 2], 0.02);
    }
    assert_loud("comb", &[1, 2], 0.05);
}

#[test]
fn what_moves_besides_the_surface_or_hides_it_is_marked() {
    assert_loud("hand", &[1, 2], 0.05);
    assert_loud("reflection", &[1, 2, 3, 4], 0.02);
    assert_loud("leaves", &[1, 2], 0.4);
}

#[test]
fn a_path_that_is_in_doubt_in_most_frames_is_in_doubt_in_all() {
    let film = kind("leaves", 1, false);
    let taken = film.film();
    // The path of this click is that of the leaves in the water.
    let [x, y] = taken.seen[105];
    let mut draw = Draw::new(1 ^ 0xc11c);
    let mut offset = || {
        let frame = (draw.next() * taken.planes.len() as f64) as usize;
        (frame, [draw.between(-2.0, 2.0), draw.between(-2.0, 2.0)])
    };
    let (_, [u, v]) = std::iter::repeat_with(&mut offset).find(|(frame, _)| *frame == 105).expect("a click");
    let (track, errors) = tracked_from(&film, &taken, Click { frame: 105, position: [x + u, y + v] });
    let wrong = track.points.iter().zip(&errors).filter(|(_, error)| error.abs() > 6.0);
    assert!(wrong.clone().count() > 50 && wrong.clone().all(|(point, _)| point.doubtful));
}

#[test]
fn a_surface_that_moves_by_more_than_an_eighth_of_the_picture_in_a_frame_is_followed() {
    // Half the range of the motion and the period; 20 to 70 rows in a frame, of 240.
    for (swing, period) in [(40.0, 12.0), (75.0, 11.0), (75.0, 9.0), (90.0, 8.0)] {
        let marks = Some((11.0, -40.0));
        let film = Filmed { frames: 60, swing, period, inner: 6.0, decay: 300.0, marks, ..Filmed::default() };
        let (track, errors) = tracked(&film, &film.film(), 5);
        assert_eq!(track.points.len(), 60);
        for (point, error) in track.points.iter().zip(errors) {
            assert!(!point.doubtful && error.abs() < 3.0, "{swing} {period}, frame {}: {error:.1} px", point.frame);
        }
    }
}

#[test]
fn small_motions_keep_their_amplitude() {
    // Half the range of the motion, half the width of the bore, and seed.
    for (swing, inner, seed) in [(2.0, 14.0, 1), (3.0, 9.0, 2), (5.0, 14.0, 3), (8.0, 14.0, 4)] {
        let marks = Some((11.0, -40.0));
        let film = Filmed { frames: 100, swing, inner, period: 25.0, decay: 400.0, marks, seed, ..Filmed::default() };
        let (track, errors) = tracked(&film, &film.film(), seed);
        assert_eq!(track.points.len(), 100);
        let mean = errors.iter().sum::<f64>() / 100.0;
        let rms = (errors.iter().map(|error| (error - mean) * (error - mean)).sum::<f64>() / 100.0).sqrt();
        assert!(rms < 0.03, "{swing}: {rms:.3} px");
    }
}

#[test]
fn errors_contain_the_lag_of_a_compressed_film() {
    for seed in [2, 3, 7, 12, 13, 14] {
        let film = kind("small", seed, false);
        let (track, errors) = tracked(&film, &film.film(), seed);
        let mean = errors.iter().sum::<f64>() / errors.len() as f64;
        let squares = track
            .points
            .iter()
            .zip(&errors)
            .map(|(point, error)| (error - mean) / libm::hypot(point.sigma[0], point.sigma[1]));
        let relative = (squares.map(|one| one * one).sum::<f64>() / errors.len() as f64).sqrt();
        assert!((0.3..1.6).contains(&relative), "{seed}: {relative:.2} standard errors");
    }
}

#[test]
fn a_hidden_surface_is_a_gap() {
    let mut gaps = 0;
    for seed in 1..=4 {
        let film = kind("hand", seed, true);
        let taken = film.film();
        let (track, _) = tracked(&film, &taken, seed);
        let point = |frame: usize| track.points.iter().find(|point| point.frame == frame);
        let hidden: Vec<usize> = (0..taken.hidden.len()).filter(|frame| taken.hidden[*frame]).collect();
        let seen = hidden.iter().filter_map(|frame| point(*frame));
        assert!(seen.clone().all(|point| point.doubtful), "{seed}: a hidden frame is in no doubt");
        gaps += usize::from(4 * seen.count() <= hidden.len());
        let lost = (0..taken.hidden.len()).filter(|frame| !taken.hidden[*frame] && point(*frame).is_none()).count();
        assert!(lost <= 4, "{seed}: {lost} frames that show the surface have no value");
    }
    // Before one of them the hand looks like the liquid: all its frames are in doubt.
    assert!(gaps >= 3, "{gaps} gaps");
}

/// Tracks a click in the first frame as the program does.
fn followed(taken: &Taken) -> (Track, Option<f64>) {
    let settings = Settings::new(Click { frame: 0, position: taken.seen[0] });
    let frames = (0..taken.planes.len()).map(|number| (number, number as f64 / 30.0)).collect();
    let surfaces = vec![Surface { settings, anchors: Vec::new() }];
    let mut following = Following::new(Plan { surfaces, bodies: Vec::new(), marks: Vec::new(), frames }).unwrap();
    while let Some(frame) = following.wanted() {
        following.take(taken.planes[frame].clone()).unwrap();
    }
    following.advance(usize::MAX).unwrap();
    (following.tracks()[0].clone(), following.camera_shift())
}

#[test]
fn the_background_shows_the_motion_of_the_camera() {
    let marks = Some((11.0, -40.0));
    let usual = Filmed { frames: 60, texture: 12.0, marks, ..Filmed::default() };
    let bumps = [
        (1, [0.0, 2.0], 12.0),
        (12, [0.0, -7.0], 12.0),
        (30, [5.0, 0.0], 12.0),
        (30, [-3.0, 8.0], 25.0),
        (45, [2.0, -4.0], 8.0),
        (57, [0.0, 6.0], 12.0),
    ];
    for (frame, by, texture) in bumps {
        assert_corrected(&Filmed { bump: Some((frame, by)), texture, ..usual.clone() }, libm::hypot(by[0], by[1]));
    }
    for by in [[0.0, 0.1], [-0.06, -0.05]] {
        assert_corrected(&Filmed { drift: by, ..usual.clone() }, 59.0 * libm::hypot(by[0], by[1]));
    }
}

fn assert_corrected(film: &Filmed, far: f64) {
    let taken = film.film();
    let (track, shift) = followed(&taken);
    let name = format!("{:?} {:?} {}", film.bump, film.drift, film.texture);
    assert!(shift.is_some_and(|shift| (shift - far).abs() < 0.5), "{name}: {shift:?}");
    assert!(track.camera().iter().any(|note| note.english().starts_with("the picture moved by up to ")), "{name}");
    for point in track.points {
        let error = point.position[1] - taken.truth[point.frame][1];
        assert!(error.abs() < 0.7 || point.doubtful, "{name}, frame {}: {error}", point.frame);
    }
}

#[test]
fn leaves_are_no_motion_of_the_camera() {
    for (name, seed) in [("leaves", 1), ("leaves", 2), ("plain leaves", 1), ("hand", 1), ("reflection", 1)] {
        let film = Filmed { tilt: 0.0, ..kind(name, seed, true) };
        assert_eq!(followed(&film.film()).1, None, "{name} {seed}");
    }
}

/// A camera that points lower shows the strip beyond the upper edge of the picture.
#[test]
fn one_mark_corrects_a_picture_that_moves_up() {
    for up in [3.0, 7.0] {
        let film = Filmed { bump: Some((20, [0.0, -up])), frames: 50, texture: 25.0, marks: None, ..Filmed::default() };
        let taken = film.film();
        let mut marks = Marks::new(vec![[22.0, 60.0]]).unwrap();
        let mut column = Column::new(Settings::new(Click { frame: 0, position: taken.seen[0] }));
        for (number, plane) in taken.planes.iter().enumerate() {
            let camera = marks.take(number, plane).unwrap();
            column.take(number, number as f64 / 30.0, plane, camera).unwrap();
        }
        for point in column.finish().unwrap().points {
            let error = point.position[1] - taken.truth[point.frame][1];
            assert!(error.abs() < 0.7, "{up}, frame {}: {error}", point.frame);
        }
    }
}

/// A camera that adjusts its exposure every few frames shows no picture twice.
#[test]
fn steps_of_the_exposure_are_no_repeated_pictures() {
    for (name, seed) in [("steps", 1), ("steps", 2), ("steps", 3), ("steps", 4), ("dark", 1), ("clean", 1)] {
        let taken = Filmed { tilt: 0.0, ..kind(name, seed, true) }.film();
        let (track, shift) = followed(&taken);
        assert_eq!((track.points.len(), shift), (taken.planes.len(), None), "{name} {seed}");
    }
}
