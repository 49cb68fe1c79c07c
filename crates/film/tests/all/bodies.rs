//! Bodies.

use crate::agreement::{Agreement, agreement, assert_exact};
use crate::scenes::{Camera, Frame, Pendulum, film};
use film::Plane;
use film::tracking::body::{Body, Settings, Sight};
use film::tracking::column::Click;
use film::tracking::{Known, Marks, Refusal, Similarity, Track};

fn settings(keys: Vec<Click>) -> Settings {
    Settings { keys, radius: None, readout: Known::Estimated }
}

fn click(frames: &[Frame], frame: usize, beside: [f64; 2]) -> Click {
    let [x, y] = frames[frame].seen;
    Click { frame, position: [x + beside[0], y + beside[1]] }
}

fn taken(frames: &[Frame], keys: Vec<Click>) -> (Body, Vec<Sight>) {
    let mut body = Body::new(settings(keys));
    let take = |(number, frame): (usize, &Frame)| {
        body.take(number, frame.time, &frame.plane, Similarity::IDENTITY).expect("a frame")
    };
    let sights = frames.iter().enumerate().map(take).collect();
    (body, sights)
}

fn compared(frames: &[Frame], track: &Track) -> [Agreement; 2] {
    [0, 1].map(|axis| agreement(&track.points, axis, |point| frames[point.frame].seen[axis]))
}

#[test]
fn positions_are_exact_and_their_errors_are_as_stated() {
    for (noise, error, radius) in [(2.0, 0.02, 11.0), (6.0, 0.06, 11.0), (4.0, 0.05, 6.0)] {
        let pendulum = Pendulum { radius, ..Pendulum::default() };
        let frames = film(&pendulum, &Camera { noise, ..Camera::default() });
        for beside in [[0.0, 0.0], [2.0, -2.0]] {
            let (mut body, _) = taken(&frames, vec![click(&frames, 0, beside)]);
            let track = body.finish();
            assert_eq!(track.points.len(), frames.len());
            for found in compared(&frames, &track) {
                assert_exact(&format!("noise {noise}, radius {radius}, click {beside:?}"), &found, error);
            }
        }
    }
}

#[test]
fn a_body_that_disappears_is_lost_until_it_is_clicked_again() {
    let pendulum = Pendulum { hidden: (1.49, 2.01), ..Pendulum::default() };
    let frames = film(&pendulum, &Camera { frames: 90, ..Camera::default() });
    let (mut body, sights) = taken(&frames, vec![click(&frames, 0, [0.0, 0.0])]);
    assert!(matches!(sights[44], Sight::At(..)), "{:?}", sights[44]);
    assert!(sights[45..55].iter().all(|sight| *sight == Sight::Hidden));
    assert!(sights[55..].iter().all(|sight| *sight == Sight::Lost));
    let track = body.finish();
    assert_eq!((track.lost, track.points.len()), (Some(45), 45));
    let (mut body, sights) = taken(&frames, vec![click(&frames, 10, [0.0, 0.0]), click(&frames, 61, [1.0, 0.0])]);
    assert!(sights[..10].iter().all(|sight| *sight == Sight::Before));
    assert!(sights[61..].iter().all(|sight| matches!(sight, Sight::At(..))));
    let track = body.finish();
    assert_eq!((track.lost, track.points.len()), (Some(45), 35 + 29));
}

#[test]
fn a_key_frame_beside_the_body_does_not_shift_the_track() {
    let frames = film(&Pendulum::default(), &Camera::default());
    let keys = vec![click(&frames, 0, [0.0, 0.0]), click(&frames, 50, [2.0, 1.0])];
    let (mut body, _) = taken(&frames, keys);
    for found in compared(&frames, &body.finish()) {
        assert!(found.worst < 0.25, "{found:?}");
    }
}

#[test]
fn frames_can_be_taken_backwards_and_the_track_is_in_order() {
    let frames = film(&Pendulum::default(), &Camera { frames: 60, ..Camera::default() });
    let mut body = Body::new(settings(vec![click(&frames, 59, [0.0, 0.0])]));
    for (number, frame) in frames.iter().enumerate().rev() {
        body.take(number, frame.time, &frame.plane, Similarity::IDENTITY).expect("a frame");
    }
    let track = body.finish();
    assert!(track.points.is_sorted_by(|a, b| a.frame + 1 == b.frame));
    for found in compared(&frames, &track) {
        assert!(found.error < 0.05, "{found:?}");
    }
}

#[test]
fn portions_of_work_change_no_bit() {
    let frames = film(&Pendulum::default(), &Camera { frames: 30, ..Camera::default() });
    let (mut whole, _) = taken(&frames, vec![click(&frames, 0, [0.0, 0.0])]);
    let (mut body, _) = taken(&frames, vec![click(&frames, 0, [0.0, 0.0])]);
    while !body.advance(1) {}
    assert_eq!(body.track(), Some(&whole.finish()));
}

#[test]
fn what_cannot_be_tracked_is_refused() {
    let flat = Plane::new(100, 80, vec![90; 8000]).expect("a plane");
    let at = |position| Body::new(settings(vec![Click { frame: 0, position }]));
    let take = |body: &mut Body, plane: &Plane| body.take(0, 0.0, plane, Similarity::IDENTITY);
    assert_eq!(take(&mut at([50.0, 40.0]), &flat), Err(Refusal::Plain));
    assert_eq!(take(&mut at([50.0, 81.0]), &flat), Err(Refusal::Click { x: 50.0, y: 81.0 }));
    assert!(matches!(take(&mut at([f64::NAN, 1.0]), &flat), Err(Refusal::Click { .. })));
    let mut idle = Body::new(settings(Vec::new()));
    assert_eq!(take(&mut idle, &flat), Ok(Sight::Before));
    assert_eq!(take(&mut idle, &flat), Err(Refusal::Order { frame: 0 }));
    assert_eq!(idle.finish(), Track::default());
    let marks = Marks::new(vec![[1.0, 1.0]; 5]);
    assert_eq!(marks.err(), Some(Refusal::Many { greatest: 4 }));
    let mut marks = Marks::new(vec![[50.0, 40.0]]).expect("a mark");
    assert_eq!(marks.take(0, &flat), Err(Refusal::PlainMark { number: 1 }));
}

#[test]
fn a_mark_that_disappears_is_named() {
    let frames = film(&Pendulum::default(), &Camera { frames: 2, ..Camera::default() });
    let mut marks = Marks::new(vec![[20.0, 25.0], [160.0, 30.0]]).expect("two marks");
    assert_eq!(marks.take(0, &frames[0].plane), Ok(Similarity::IDENTITY));
    let still = marks.take(1, &frames[1].plane).expect("the marks");
    assert!(still.c.abs() < 0.05 && still.d.abs() < 0.05, "{still:?}");
    let (wide, high) = (frames[0].plane.width(), frames[0].plane.height());
    let flat = Plane::new(wide, high, vec![90; wide * high]).expect("a plane");
    assert_eq!(marks.take(2, &flat), Err(Refusal::Mark { number: 1, frame: 2 }));
}

#[test]
fn a_body_like_another_one_is_not_left_for_it() {
    // Three bright discs on a dark wall; one of them passes between the others, and becomes faint for some frames.
    let (wide, high) = (200_usize, 160_usize);
    let disc = |x: f64, y: f64, u: f64, v: f64| (8.5 - libm::hypot(x - u, y - v)).clamp(0.0, 1.0);
    let place = |n: usize| [60.0 + 2.3 * n as f64, 80.0];
    let mut body = Body::new(settings(vec![Click { frame: 0, position: place(0) }]));
    for n in 0..30 {
        let mut grey = Vec::new();
        for at in 0..wide * high {
            let (x, y) = ((at % wide) as f64 + 0.5, (at / wide) as f64 + 0.5);
            let texture = 12.0 * libm::sin(0.7 * x) * libm::sin(0.5 * y);
            let still = [57.0, 103.0].map(|v| disc(x, y, 92.0, v)).iter().sum::<f64>();
            let faint = if (12..16).contains(&n) { 0.26 } else { 1.0 };
            grey.push((60.0 + texture + 100.0 * (still + faint * disc(x, y, place(n)[0], place(n)[1]))) as u8);
        }
        let plane = Plane::new(wide, high, grey).expect("a plane");
        let sight = body.take(n, n as f64 / 30.0, &plane, Similarity::IDENTITY).expect("a frame");
        let Sight::At([x, y], _) = sight else {
            assert!(sight == Sight::Hidden && (12..16).contains(&n), "{sight:?} in frame {n}");
            continue;
        };
        assert!((x - place(n)[0]).abs() + (y - 80.0).abs() < 1.5, "frame {n}: {x}, {y}");
    }
}
