//! The surface in a tube.

use crate::agreement::{agreement, assert_exact};
use crate::scenes::{Camera, Frame, HEIGHT, MARKS, Scene, Tube, WIDTH, film, held};
use film::Plane;
use film::tracking::column::{Click, Column, Settings};
use film::tracking::{Exposure, Known, Marks, Refusal, Similarity, Track};

fn taken(frames: &[Frame], settings: Settings) -> Column {
    let mut column = Column::new(settings);
    for (number, frame) in frames.iter().enumerate() {
        column.take(number, frame.time, &frame.plane, Similarity::IDENTITY).expect("a frame");
    }
    column
}

/// The settings of a click beside the surface in the first frame.
fn clicked(frames: &[Frame], beside: [f64; 2]) -> Settings {
    let [x, y] = frames[0].seen;
    Settings::new(Click { frame: 0, position: [x + beside[0], y + beside[1]] })
}

fn tracked(frames: &[Frame], beside: [f64; 2]) -> Track {
    taken(frames, clicked(frames, beside)).finish().expect("a track")
}

fn compared(frames: &[Frame], track: &Track) -> crate::agreement::Agreement {
    assert_eq!(track.points.len(), frames.len());
    agreement(&track.points, 1, |point| frames[point.frame].seen[1])
}

#[test]
fn positions_are_exact_and_their_errors_are_as_stated() {
    let usual = Camera::default();
    let cases = [
        ("good", Tube::default(), usual.clone(), 0.015),
        ("noisy", Tube::default(), Camera { noise: 8.0, seed: 2, ..usual.clone() }, 0.05),
        ("faint", Tube { contrast: 0.25, ..Tube::default() }, Camera { noise: 3.0, seed: 3, ..usual.clone() }, 0.12),
        ("bright", Tube { contrast: -0.6, ..Tube::default() }, Camera { seed: 4, ..usual.clone() }, 0.05),
        ("drops", Tube { drops: true, ..Tube::default() }, Camera { noise: 3.0, seed: 5, ..usual.clone() }, 0.06),
        ("flicker", Tube::default(), Camera { flicker: 0.08, rate: 29.0, seed: 6, ..usual.clone() }, 0.05),
        ("blur", Tube::default(), Camera { exposure: 0.025, seed: 7, ..usual }, 0.08),
    ];
    for (name, tube, camera, error) in cases {
        assert_exact(
            name,
            &{
                let frames = film(&tube, &camera);
                compared(&frames, &tracked(&frames, [0.0, 0.0]))
            },
            error,
        );
    }
}

#[test]
fn a_click_beside_the_surface_changes_nothing() {
    let frames = film(&Tube::default(), &Camera::default());
    for beside in [[2.0, 2.2], [-2.0, -2.2], [0.0, 3.0]] {
        assert_exact(&format!("{beside:?}"), &compared(&frames, &tracked(&frames, beside)), 0.04);
    }
}

#[test]
fn a_click_in_a_later_frame_serves_as_well() {
    let frames = film(&Tube::default(), &Camera::default());
    let settings = Settings::new(Click { frame: 70, position: frames[70].seen });
    let track = taken(&frames, settings).finish().expect("a track");
    assert_exact("frame 70", &compared(&frames, &track), 0.04);
}

#[test]
fn the_exposure_time_is_found() {
    for (exposure, tolerance) in [(0.025, 0.002), (0.015, 0.002)] {
        let frames = film(&Tube::default(), &Camera { exposure, seed: 8, ..Camera::default() });
        let Some(Exposure::Seconds(found)) = tracked(&frames, [0.0, 0.0]).exposure else { panic!("{exposure}") };
        assert!((found - exposure).abs() < tolerance, "{found} for {exposure}");
    }
    let still = Tube { amplitude: 0.5, ..Tube::default() };
    let frames = film(&still, &Camera::default());
    assert!(matches!(tracked(&frames, [0.0, 0.0]).exposure, Some(Exposure::Under(_))), "without smear");
}

#[test]
fn the_readout_time_is_found_and_corrects_the_times() {
    let frames = film(&Tube::default(), &Camera { readout: 0.025, noise: 6.0, seed: 9, ..Camera::default() });
    let track = tracked(&frames, [0.0, 0.0]);
    let readout = track.readout.expect("a readout time");
    assert!((readout.seconds - 0.025).abs() < 0.001, "{readout:?}");
    let late = |point: &film::tracking::Point| (point.time - frames[point.frame].instant).abs();
    assert!(track.points.iter().all(|point| late(point) < 2e-4));
    assert_exact("rolling", &compared(&frames, &track), 0.05);
    // A camera that reads all rows at once.
    let frames = film(&Tube::default(), &Camera::default());
    assert_eq!(tracked(&frames, [0.0, 0.0]).readout, None);
}

#[test]
fn fixed_marks_take_the_shake_away() {
    let camera = Camera { shake: 2.0, seed: 10, ..Camera::default() };
    let tube = Tube::default();
    let frames = film(&tube, &camera);
    let first = held(&camera, 0);
    let mut marks = Marks::new(MARKS.map(|mark| first.apply(mark)).to_vec()).expect("four marks");
    let mut column = Column::new(clicked(&frames, [0.0, 0.0]));
    for (number, frame) in frames.iter().enumerate() {
        let camera = marks.take(number, &frame.plane).expect("the marks");
        column.take(number, frame.time, &frame.plane, camera).expect("a frame");
    }
    let track = column.finish().expect("a track");
    let truth = |point: &film::tracking::Point| first.apply(tube.place(frames[point.frame].time))[1];
    assert_exact("shaken", &agreement(&track.points, 1, truth), 0.06);
}

#[test]
fn a_tube_at_an_angle_is_followed_along_its_axis() {
    // The camera is turned: shake without time.
    let frames = film(&Tube::default(), &Camera::default());
    let turned: Vec<Frame> = frames
        .iter()
        .map(|frame| {
            let grey = (0..HEIGHT).flat_map(|row| (0..WIDTH).map(move |column| (row, column)));
            let turn = |(row, column): (usize, usize)| {
                let [x, y] = TURN.undo([column as f64 + 0.5, row as f64 + 0.5]);
                frame.plane.cubic(&[x], &[y])[0].round().clamp(0.0, 255.0) as u8
            };
            let plane = Plane::new(WIDTH, HEIGHT, grey.map(turn).collect()).expect("a plane");
            Frame { time: frame.time, plane, seen: TURN.apply(frame.seen), instant: frame.instant }
        })
        .collect();
    let tube = Tube::default();
    let ends = [[tube.axis, 30.0], [tube.axis, 220.0]].map(|end| TURN.apply(end));
    let settings = Settings { tube: Some(ends), ..clicked(&turned, [0.0, 0.0]) };
    let track = taken(&turned, settings).finish().expect("a track");
    assert_exact("down", &agreement(&track.points, 1, |point| turned[point.frame].seen[1]), 0.06);
    let across = agreement(&track.points, 0, |point| turned[point.frame].seen[0]);
    assert!(across.error < 0.06, "{across:?}");
}

/// A turn by 0.15 about the middle of the picture.
const TURN: Similarity = Similarity { a: 0.988_771, b: 0.149_438, c: 18.943_18, d: -12.101_96 };

#[test]
fn an_anchor_leads_the_path_to_another_surface() {
    let tube = Tube { amplitude: 12.0, jump: Some((1.5, [-30.0, 55.0])), ..Tube::default() };
    let frames = film(&tube, &Camera { frames: 90, ..Camera::default() });
    let mut column = taken(&frames, clicked(&frames, [0.0, 0.0]));
    let level = |track: &Track, frame: usize| track.points[frame].position[1] - frames[frame].seen[1];
    let track = column.finish().expect("a track");
    assert!(level(&track, 80).abs() < 1.0, "the nearer one");
    let [x, y] = frames[60].seen;
    column.anchor(Click { frame: 60, position: [x, y + 85.0 + 2.0] });
    let track = column.finish().expect("a track");
    assert!((level(&track, 80) - 85.0).abs() < 1.0, "the one with the anchor");
    assert!(level(&track, 20).abs() < 1.0);
    column.release(60);
    let track = column.finish().expect("a track");
    assert!(level(&track, 80).abs() < 1.0, "the nearer one again");
}

#[test]
fn frames_without_a_surface_are_doubtful() {
    let tube = Tube { amplitude: 20.0, hidden: (1.99, 2.18), ..Tube::default() };
    let frames = film(&tube, &Camera::default());
    let track = tracked(&frames, [0.0, 0.0]);
    for point in &track.points {
        let hidden = (60..=65).contains(&point.frame);
        assert!(!hidden || point.doubtful, "frame {} is hidden", point.frame);
        let near = (55..=70).contains(&point.frame);
        assert!(near || !point.doubtful, "frame {} is not", point.frame);
    }
}

#[test]
fn portions_of_work_change_no_bit() {
    let frames = film(&Tube::default(), &Camera { frames: 40, ..Camera::default() });
    let whole = tracked(&frames, [0.0, 0.0]);
    let mut column = taken(&frames, clicked(&frames, [0.0, 0.0]));
    assert_eq!(column.track(), None);
    let mut portions = 0;
    while !column.advance(7).expect("a portion") {
        portions += 1;
    }
    assert!(portions > 20, "{portions}");
    assert_eq!(column.track(), Some(&whole));
    let picture = column.space_time().expect("the space-time picture");
    assert_eq!((picture.columns.len(), picture.columns[0].len()), (40, HEIGHT));
}

#[test]
fn a_known_exposure_is_used() {
    let frames = film(&Tube::default(), &Camera { exposure: 0.02, frames: 60, ..Camera::default() });
    let settings = Settings { exposure: Known::Seconds(0.02), ..clicked(&frames, [0.0, 0.0]) };
    let track = taken(&frames, settings).finish().expect("a track");
    assert_eq!(track.exposure, Some(Exposure::Seconds(0.02)));
    assert!(compared(&frames, &track).error < 0.08);
}

#[test]
fn what_cannot_be_tracked_is_refused() {
    let frames = film(&Tube::default(), &Camera { frames: 4, ..Camera::default() });
    let plane = &frames[0].plane;
    let at = |position: [f64; 2]| Settings::new(Click { frame: 0, position });
    let take = |settings: Settings| Column::new(settings).take(0, 0.0, plane, Similarity::IDENTITY);
    assert_eq!(take(at([91.0, 1e9])), Err(Refusal::Click { x: 91.0, y: 1e9 }));
    assert!(matches!(take(at([f64::NAN, 3.0])), Err(Refusal::Click { .. })));
    let short = Settings { tube: Some([[90.0, 50.0], [90.0, 60.0]]), ..at([91.0, 100.0]) };
    assert_eq!(take(short), Err(Refusal::Tube { length: 10.0, least: 24.0 }));
    let mut column = Column::new(at([91.0, 100.0]));
    assert_eq!(column.finish(), Err(Refusal::Short { frames: 3 }));
    column.take(0, 0.0, plane, Similarity::IDENTITY).expect("the first frame");
    assert_eq!(column.take(1, 0.0, plane, Similarity::IDENTITY), Err(Refusal::Order { frame: 1 }));
    assert_eq!(column.take(1, f64::NAN, plane, Similarity::IDENTITY), Err(Refusal::Order { frame: 1 }));
    let other = Plane::new(2, 2, vec![0; 4]).expect("a plane");
    assert_eq!(column.take(1, 0.1, &other, Similarity::IDENTITY), Err(Refusal::Size { frame: 1 }));
    // A uniform picture, and pictures of a few pixels.
    for (wide, high) in [(100, 100), (1, 30), (3, 40)] {
        let plane = Plane::new(wide, high, vec![9; wide * high]).expect("a plane");
        let mut column = Column::new(at([0.5, 20.0]));
        for n in 0..5 {
            column.take(n, n as f64, &plane, Similarity::IDENTITY).expect("a frame");
        }
        assert_eq!(column.finish(), Err(Refusal::Plain));
    }
}

#[test]
fn a_click_where_no_surface_is_gives_no_track() {
    let empty = Tube { hidden: (-1.0, f64::INFINITY), ..Tube::default() };
    let finish = |frames: &[Frame], frame: usize, position: [f64; 2]| {
        taken(frames, Settings::new(Click { frame, position })).finish().map(|_| ())
    };
    for noise in [0.5, 2.0, 8.0] {
        let wall = film(&empty, &Camera { noise, frames: 40, ..Camera::default() });
        let tube = film(&Tube::default(), &Camera { noise, frames: 60, ..Camera::default() });
        for place in [[91.0, 100.0], [91.0, 180.0], [50.0, 60.0]] {
            assert_eq!(finish(&wall, 7, place), Err(Refusal::Noise { frame: 7 }), "wall, {noise}, {place:?}");
        }
        let [x, y] = tube[0].seen;
        for place in [[x, y + 60.0], [x, y - 60.0], [x + 40.0, y], [x - 40.0, y + 10.0]] {
            assert_eq!(finish(&tube, 0, place), Err(Refusal::Noise { frame: 0 }), "tube, {noise}, {place:?}");
        }
    }
    // Without noise the empty tube has a profile, which the path leaves for the surface.
    let tube = film(&Tube::default(), &Camera { noise: 0.0, frames: 60, ..Camera::default() });
    for beside in [60.0, -60.0] {
        let [x, y] = tube[0].seen;
        assert_eq!(finish(&tube, 0, [x, y + beside]), Err(Refusal::Left { frame: 0 }), "{beside}");
    }
}

#[test]
fn numbers_without_sense_do_no_harm() {
    let frames = film(&Tube::default(), &Camera { frames: 20, ..Camera::default() });
    let odd = [f64::NAN, f64::INFINITY, -1.0, 0.0, 1e300, 1e-300];
    let finish = |settings: Settings, time: &dyn Fn(usize) -> f64, camera: Similarity| {
        let mut column = Column::new(settings);
        for (number, frame) in frames.iter().enumerate() {
            if column.take(number, time(number), &frame.plane, camera).is_err() {
                return;
            }
        }
        // A track or a message, and an end.
        let _ = column.finish();
    };
    let usual = clicked(&frames, [0.0, 0.0]);
    let clock = |number: usize| number as f64 / 30.0;
    for number in odd {
        finish(Settings { half_width: Some(number), ..usual.clone() }, &clock, Similarity::IDENTITY);
        finish(Settings { exposure: Known::Seconds(number), ..usual.clone() }, &clock, Similarity::IDENTITY);
        finish(Settings { readout: Known::Seconds(number), ..usual.clone() }, &clock, Similarity::IDENTITY);
        finish(Settings { tube: Some([[1.0, 1.0], [number, 200.0]]), ..usual.clone() }, &clock, Similarity::IDENTITY);
        finish(usual.clone(), &clock, Similarity { a: number, b: number, c: number, d: number });
        finish(usual.clone(), &|frame| clock(frame) * number, Similarity::IDENTITY);
        finish(
            usual.clone(),
            &|frame| if frame < 9 { clock(frame) } else { clock(frame) + number },
            Similarity::IDENTITY,
        );
    }
}
