//! Surfaces in films with all that disturbs.

use crate::tubes::{Draw, Filmed, Taken, kind};
use film::tracking::column::{Click, Column, Settings};
use film::tracking::{Marks, Similarity, Track};

/// The track of a click near the surface, and how far each point is from the truth.
fn tracked(film: &Filmed, taken: &Taken, seed: u64) -> (Track, Vec<f64>) {
    let mut draw = Draw(seed);
    let frame = (draw.next() * 0.4 * taken.planes.len() as f64) as usize;
    let [x, y] = taken.seen[frame];
    let click = Click { frame, position: [x + draw.between(-1.5, 1.5), y + draw.between(-1.5, 1.5)] };
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
    assert_loud("hand", &[1, 2], 0.1);
    assert_loud("reflection", &[1, 2], 0.4);
    assert_loud("leaves", &[1, 2], 0.4);
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
