//! Bodies that are hard to follow, in drawn films of many seeds.

use crate::stage::{Kind, Stage};
use film::tracking::body::{Body, Settings};
use film::tracking::column::Click;
use film::tracking::{Known, Refusal, Similarity, Track};

/// Pixels beyond which a position is wrong.
const WRONG: f64 = 6.0;

/// Result of tracking a body, as numbers of frames.
#[derive(Debug, Default)]
struct Outcome {
    frames: usize,
    right: usize,
    /// Wrong and not doubtful.
    silent: usize,
    /// Right but doubtful.
    marked: usize,
}

/// Track from a click in the first of some frames, and the vector from the middle of the body to the click, px.
fn followed(
    stage: &Stage,
    body: usize,
    frames: std::ops::Range<usize>,
    seed: u64,
) -> Result<(Track, [f64; 2]), Refusal> {
    let first = frames.start;
    let position = stage.click(body, first, seed, 0.6);
    let keys = vec![Click { frame: first, position }];
    let mut tracker = Body::new(Settings { keys, radius: None, readout: Known::Estimated });
    for frame in frames {
        tracker.take(frame, frame as f64 / 30.0, &stage.frame(frame), Similarity::IDENTITY)?;
    }
    let [x, y] = stage.place(body, first as f64);
    Ok((tracker.finish(), [position[0] - x, position[1] - y]))
}

fn outcome(kind: Kind, seeds: std::ops::Range<u64>, frames: usize) -> Outcome {
    outcome_of(seeds.map(|seed| (seed, Stage::new(kind, seed, 240, frames, seed % 2 == 0), 0)), frames)
}

/// Sum over films, each with its seed and the frame of the click.
fn outcome_of(stages: impl Iterator<Item = (u64, Stage, usize)>, frames: usize) -> Outcome {
    let mut sum = Outcome::default();
    for (seed, stage, first) in stages {
        for body in 0..stage.bodies() {
            let (track, shift) = followed(&stage, body, first..first + frames, seed).expect("a track");
            sum.frames += frames;
            for point in &track.points {
                let truth = stage.place(body, point.frame as f64);
                let off = [0, 1].map(|k| point.position[k] - truth[k] - shift[k]);
                let wrong = libm::hypot(off[0], off[1]) > WRONG;
                sum.right += usize::from(!wrong);
                sum.silent += usize::from(wrong && !point.doubtful);
                sum.marked += usize::from(!wrong && point.doubtful);
            }
        }
    }
    sum
}

#[track_caller]
fn assert_right(kind: Kind, seeds: std::ops::Range<u64>, least: f64) {
    let outcome = outcome(kind, seeds, 40);
    assert_eq!(outcome.silent, 0, "{kind:?}: {outcome:?}");
    assert!(outcome.right as f64 >= least * outcome.frames as f64, "{kind:?}: {outcome:?}");
    assert!(outcome.marked as f64 <= 0.05 * outcome.right as f64, "{kind:?}: {outcome:?}");
}

#[test]
fn both_bobs_of_a_double_pendulum_are_followed() {
    assert_right(Kind::DoublePendulum, 0..4, 0.92);
}

#[test]
fn a_grey_bob_is_followed_before_leaves() {
    assert_right(Kind::Leaves, 0..4, 0.75);
}

#[test]
fn a_bob_that_is_lost_before_boards_of_its_own_grey_is_in_doubt() {
    let outcome = outcome(Kind::Boards, 0..6, 40);
    assert_eq!(outcome.silent, 0, "{outcome:?}");
}

#[test]
fn the_noise_of_colours_that_all_have_does_not_hide_a_body() {
    let stages = |coloured: bool| (0..8).map(move |seed| (seed, Stage::new(Kind::Boards, seed, 240, 40, coloured), 0));
    let [grey, coloured] = [false, true].map(|coloured| outcome_of(stages(coloured), 40));
    assert!(coloured.right as f64 >= 0.75 * grey.right as f64, "{coloured:?}, without colours {grey:?}");
}

#[test]
fn a_click_on_two_equal_bodies_one_of_which_covers_the_other_gives_no_wrong_frames_without_doubt() {
    let stages = (0..6).map(|seed| {
        let stage = Stage::new(Kind::Twins, seed, 240, 140, seed % 2 == 0);
        let apart = |frame: usize| {
            let [[x, y], [u, v]] = [0, 1].map(|body| stage.place(body, frame as f64));
            libm::hypot(x - u, y - v)
        };
        let closest = (0..100).min_by(|one, other| apart(*one).total_cmp(&apart(*other))).expect("frames");
        (seed, stage, closest)
    });
    let outcome = outcome_of(stages, 40);
    assert_eq!(outcome.silent, 0, "{outcome:?}");
}

#[test]
fn a_second_body_that_is_nowhere_in_the_frame_of_the_click_was_covered_there() {
    // Seed, rows, frame of the click and number of further frames until the other body has been seen.
    for (seed, rows, first, count, body) in [(2005, 240, 118, 60, 1), (2006, 360, 68, 60, 1)] {
        let stage = Stage::new(Kind::Twins, seed, rows, 240, seed % 2 == 0);
        let (track, shift) = followed(&stage, body, first..first + count, seed + 100 * body as u64).expect("a track");
        let silent = track.points.iter().filter(|point| !point.doubtful).filter(|point| {
            let truth = stage.place(body, point.frame as f64);
            let off = [0, 1].map(|k| point.position[k] - truth[k] - shift[k]);
            libm::hypot(off[0], off[1]) > WRONG
        });
        assert_eq!(silent.count(), 0, "film {seed}");
    }
}

#[test]
fn a_spot_of_a_larger_body_that_turns_is_in_doubt_from_end_to_end() {
    let stage = Stage::new(Kind::Ball, 4014, 1080, 40, true);
    let (track, _) = followed(&stage, 0, 18..36, 4014).expect("a track");
    assert!(track.outline.is_some_and(|outline| outline.radius < 0.3 * stage.radius), "{:?}", track.outline);
    assert!(track.points.len() > 8 && track.points.iter().all(|point| point.doubtful));
}

#[test]
fn a_body_whose_look_has_gone_over_to_the_wall_is_in_doubt() {
    // The bob turns back before a board of its own grey, at whose edge it is found for 30 frames.
    let stage = Stage::new(Kind::Wall, 9007, 480, 240, false);
    let outcome = outcome_of(std::iter::once((9007, stage, 9)), 110);
    assert!(outcome.right + 15 < outcome.frames && outcome.silent == 0, "{outcome:?}");
}

#[test]
fn a_second_body_that_was_covered_at_the_click_and_separates_at_once_is_noticed() {
    // Seed, rows, frame of the click and body. Both are out of each other's reach a frame or two later.
    for (seed, rows, first, body) in [(8001, 360, 38, 0), (8006, 360, 117, 1), (9001, 360, 52, 0)] {
        let stage = Stage::new(Kind::Twins, seed, rows, 240, seed % 2 == 0);
        let (track, _) = followed(&stage, body, first..first + 24, seed + 100 * body as u64).expect("a track");
        assert!(track.points.len() > 20 && track.points.iter().all(|point| point.doubtful), "film {seed}");
    }
}

#[test]
fn two_equal_bodies_that_meet_soon_after_the_click_are_told_apart() {
    // Seed, rows, frame of the click, and body: it meets the other one two, and five frames later.
    for (seed, rows, first, body) in [(6006, 120, 2, 1), (4002, 240, 14, 0)] {
        let stage = Stage::new(Kind::Twins, seed, rows, first + 30, seed % 2 == 0);
        let (track, shift) = followed(&stage, body, first..first + 30, seed + 100 * body as u64).expect("a track");
        for point in &track.points {
            let truth = stage.place(body, point.frame as f64);
            let off = [0, 1].map(|k| point.position[k] - truth[k] - shift[k]);
            assert!(libm::hypot(off[0], off[1]) < WRONG, "film {seed}, frame {}: {off:?}", point.frame);
        }
        let marked = track.points.iter().filter(|point| point.doubtful).count();
        assert!(marked <= 1, "film {seed}: {marked} of {} frames in doubt", track.points.len());
    }
}

#[test]
fn a_body_that_does_not_move_is_in_doubt_from_end_to_end() {
    let stage = Stage::new(Kind::Plain, 1, 240, 2, false);
    let position = stage.click(0, 0, 1, 0.6);
    let keys = vec![Click { frame: 0, position }];
    let mut tracker = Body::new(Settings { keys, radius: None, readout: Known::Estimated });
    for frame in 0..12 {
        tracker.take(frame, frame as f64, &stage.frame(0), Similarity::IDENTITY).expect("a frame");
    }
    assert!(tracker.finish().points.iter().all(|point| point.doubtful));
}

#[test]
fn the_outline_of_a_body_is_that_of_the_pixels_that_it_leaves() {
    let mut right = 0;
    for (kind, seed) in
        [Kind::Boards, Kind::Wall, Kind::Ball].into_iter().flat_map(|kind| (0..4).map(move |k| (kind, k)))
    {
        let stage = Stage::new(kind, seed, 240, 34, seed % 2 == 0);
        let keys = vec![Click { frame: 0, position: stage.click(0, 0, seed, 0.6) }];
        let mut tracker = Body::new(Settings { keys, radius: None, readout: Known::Estimated });
        for frame in 0..34 {
            tracker.take(frame, frame as f64 / 30.0, &stage.frame(frame), Similarity::IDENTITY).expect("a frame");
        }
        let radius = tracker.radius().expect("a radius");
        right += usize::from((radius / stage.radius - 1.0).abs() < 0.2);
    }
    assert!(right >= 10, "{right} of 12");
}
