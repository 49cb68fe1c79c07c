//! From pixels to metres.

use film::Plane;
use film::calibration::{Calibration, Lengths, Mark, Parallax, Rectangle, Refusal, Rotation, Scale, by_marks};
use std::f64::consts::FRAC_PI_6;

#[track_caller]
fn assert_near(found: [f64; 2], expected: [f64; 2], tolerance: f64) {
    let far = (found[0] - expected[0]).abs().max((found[1] - expected[1]).abs());
    assert!(far < tolerance, "{found:?} for {expected:?}");
}

#[test]
fn two_marks_give_the_scale_and_its_error() {
    let scale = Scale::between([[100.0, 50.0], [100.0, 250.0]], 0.1, 0.5).expect("a scale");
    assert!((scale.pixel - 0.0005).abs() < 1e-15);
    assert!((scale.relative_sigma - 0.5 * 2.0_f64.sqrt() / 200.0).abs() < 1e-15);
    assert_eq!(Scale::between([[1.0, 1.0], [2.0, 1.0]], 0.1, 0.5), Err(Refusal::Close));
    assert_eq!(Scale::between([[1.0, 1.0], [f64::NAN, 90.0]], 0.1, 0.5), Err(Refusal::Close));
    for length in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(Scale::between([[0.0, 0.0], [90.0, 0.0]], length, 0.5), Err(Refusal::Length));
    }
}

#[test]
fn more_marks_give_a_smaller_error() {
    // A centimetre every 20 pixels, clicked with errors of up to half a pixel.
    let errors = [0.3, -0.4, 0.1, 0.5, -0.2, -0.3];
    let mark = |k: usize| Mark { position: [50.0, 300.0 - 20.0 * k as f64 + errors[k]], number: 0.01 * k as f64 };
    let marks: Vec<Mark> = (0..6).map(mark).collect();
    let scale = Scale::along(&marks, 0.5).expect("a scale");
    assert!((scale.pixel / 0.0005 - 1.0).abs() < 3.0 * scale.relative_sigma);
    assert!(scale.relative_sigma < 0.006, "{scale:?}");
    let two = Scale::along(&marks[..2], 0.5).expect("a scale");
    assert!((two.relative_sigma - 0.5 * 2.0_f64.sqrt() / 20.7).abs() < 1e-3, "{two:?}");
    assert_eq!(Scale::along(&marks[..1], 0.5), Err(Refusal::Length));
    assert_eq!(Scale::along(&[], 0.5), Err(Refusal::Length));
}

#[test]
fn the_marks_of_a_ruler_correct_the_clicks() {
    let spacing = 14.73;
    let line = |x: usize, y: usize| {
        let phase = ((y as f64 + 0.5 - 7.0) / spacing).fract();
        if (60..90).contains(&x) && phase < 0.15 { 40 } else { 220 + ((x * 7 + y * 13) % 5) as u8 }
    };
    let grey = (0..300).flat_map(|y| (0..120).map(move |x| line(x, y))).collect();
    let plane = Plane::new(120, 300, grey).expect("a plane");
    // Fifteen intervals, clicked a pixel too long.
    let ends = [[75.0, 21.0], [75.0, 21.0 + 15.0 * spacing + 1.0]];
    let scale = by_marks(&plane, ends, 15, 0.01).expect("a scale");
    let clicks = Scale::between(ends, 0.15, 0.5).expect("a scale");
    let wrong = |scale: Scale| (scale.pixel * spacing / 0.01 - 1.0).abs();
    assert!(wrong(scale) < 1.5e-3 && wrong(clicks) > 4e-3, "{} and {}", wrong(scale), wrong(clicks));
    assert!(wrong(scale) < 3.0 * scale.relative_sigma && scale.relative_sigma < 5e-3, "{scale:?}");
    assert_eq!(by_marks(&plane, ends, 2, 0.01), Err(Refusal::Marks));
    assert_eq!(by_marks(&plane, ends, 100, 0.01), Err(Refusal::Marks));
    assert_eq!(by_marks(&plane, [[20.0, 21.0], [20.0, 240.0]], 15, 0.01), Err(Refusal::Marks), "beside the ruler");
}

#[test]
fn axes_have_an_origin_and_an_angle() {
    let scale = Scale { pixel: 0.01, relative_sigma: 0.004 };
    let plain = Calibration { lengths: Lengths::Scale(scale), origin: [100.0, 200.0], ..Calibration::default() };
    assert_near(plain.apply([150.0, 180.0]), [0.5, 0.2], 1e-12);
    assert_eq!(plain.relative_sigma(), Some(0.004));
    // An axis that rises to the right: a point on it has no second coordinate.
    let turned = Calibration { angle: FRAC_PI_6, ..plain };
    let (sine, cosine) = (0.5, 3.0_f64.sqrt() / 2.0);
    assert_near(turned.apply([100.0 + 100.0 * cosine, 200.0 - 100.0 * sine]), [1.0, 0.0], 1e-12);
    assert_near(turned.sigma([0.0, 0.0], [0.3, 0.0]), [0.003 * cosine, 0.003 * sine], 1e-12);
    let pixels = Calibration::default();
    assert_near(pixels.apply([3.0, 4.0]), [3.0, -4.0], 1e-12);
    assert_eq!(pixels.relative_sigma(), None);
}

#[test]
fn a_film_that_was_held_upright_is_turned() {
    let size = [640.0, 360.0];
    for rotation in [Rotation::None, Rotation::Quarter, Rotation::Half, Rotation::ThreeQuarters] {
        assert_near(rotation.undo(rotation.apply([30.0, 50.0], size), size), [30.0, 50.0], 1e-12);
    }
    // Turned to the right by a quarter, the left edge of the stored picture is above.
    assert_near(Rotation::Quarter.apply([0.0, 360.0], size), [0.0, 0.0], 1e-12);
    let calibration = Calibration { rotation: Rotation::Quarter, ..Calibration::default() };
    assert_near(calibration.apply([-5.0, 0.0]), [0.0, 5.0], 1e-12);
    assert_near(calibration.apply([0.0, -5.0]), [5.0, 0.0], 1e-12);
}

#[test]
fn a_ruler_behind_the_tube_shows_lengths_too_large() {
    let parallax = Parallax { behind: 0.02, distance: 1.0 };
    let scale = Scale { pixel: 0.01, relative_sigma: 0.0 };
    let calibration =
        Calibration { lengths: Lengths::Scale(scale), parallax: Some(parallax), ..Calibration::default() };
    assert_near(calibration.apply([102.0, 0.0]), [1.0, 0.0], 1e-12);
}

#[test]
fn a_rectangle_seen_at_an_angle_becomes_one() {
    // A camera at the origin looks along z at a board 2 m away that is turned about the vertical by 0.5.
    let (sine, cosine) = libm::sincos(0.5);
    let project = |u: f64, v: f64| {
        let (x, y, z) = (u * cosine, v, 2.0 + u * sine);
        [320.0 + 500.0 * x / z, 180.0 - 500.0 * y / z]
    };
    let corners = [project(-0.3, -0.2), project(0.3, -0.2), project(0.3, 0.2), project(-0.3, 0.2)];
    let rectangle = Rectangle::new(corners, [0.6, 0.4], 0.5).expect("a rectangle");
    let calibration =
        Calibration { lengths: Lengths::Rectangle(rectangle), origin: project(0.0, 0.0), ..Calibration::default() };
    for (u, v) in [(0.1, 0.05), (-0.25, 0.17), (0.4, -0.3)] {
        assert_near(calibration.apply(project(u, v)), [u, v], 1e-12);
    }
    assert!(calibration.relative_sigma().is_some_and(|sigma| (0.002..0.006).contains(&sigma)));
    let mut wrong = corners;
    wrong.swap(0, 1);
    assert_eq!(Rectangle::new(wrong, [0.6, 0.4], 0.5), Err(Refusal::Corners));
    assert_eq!(Rectangle::new([[1.0, 1.0]; 4], [0.6, 0.4], 0.5), Err(Refusal::Corners));
    assert_eq!(Rectangle::new(corners, [0.6, 0.0], 0.5), Err(Refusal::Length));
}

#[test]
fn coordinates_lead_back_to_their_pixel() {
    let corners = [[40.0, 220.0], [290.0, 200.0], [270.0, 40.0], [60.0, 30.0]];
    let scale = Lengths::Scale(Scale { pixel: 4e-4, relative_sigma: 1e-3 });
    let rectangle = Lengths::Rectangle(Rectangle::new(corners, [0.2, 0.15], 0.5).expect("a rectangle"));
    let parallax = Some(Parallax { behind: 0.02, distance: 0.8 });
    for lengths in [Lengths::Pixels, scale, rectangle] {
        for rotation in [Rotation::None, Rotation::Quarter, Rotation::Half, Rotation::ThreeQuarters] {
            let calibration = Calibration { lengths, origin: [100.0, 150.0], angle: FRAC_PI_6, rotation, parallax };
            for point in [[100.0, 150.0], [131.5, 77.25], [3.0, 210.0]] {
                assert_near(calibration.undo(calibration.apply(point)), point, 1e-9);
            }
        }
    }
}

#[test]
fn points_of_a_turned_picture_lead_back_to_the_stored_one() {
    for quarter_turns in 0..4 {
        for mirrored in [false, true] {
            let orientation = film::containers::Orientation { quarter_turns, mirrored };
            let upright = orientation.upright([12.0, 30.0], [320.0, 180.0]);
            let [wide, high] = orientation.upright_size([320.0, 180.0]);
            assert!((0.0..=wide).contains(&upright[0]) && (0.0..=high).contains(&upright[1]));
            assert_near(orientation.stored(upright, [320.0, 180.0]), [12.0, 30.0], 1e-12);
        }
    }
}
