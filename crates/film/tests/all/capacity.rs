//! The length of a film is refused before a frame is decoded, with the number at which the tracker would stop.

use film::capacity::check;
use film::tracking::body;
use film::tracking::column::{Click, Settings};
use film::tracking::{Following, Known, Plan, Refusal, Surface};

/// A plan for one surface in so many frames.
fn plan(settings: &Settings, frames: usize) -> Plan {
    Plan {
        surfaces: vec![Surface { settings: settings.clone(), anchors: Vec::new() }],
        bodies: Vec::new(),
        marks: Vec::new(),
        frames: (0..frames).map(|frame| (frame, frame as f64 / 30.0)).collect(),
    }
}

/// Pictures are large, so that the memory is full soon.
#[test]
fn the_limit_is_that_of_the_tracker() {
    let [wide, high] = [40_usize, 9000];
    let start = Settings::new(Click { frame: 0, position: [20.0, 4000.0] });
    let ends = |tube| Settings { tube: Some(tube), ..start.clone() };
    for settings in [
        Settings { half_width: Some(f64::NAN), ..start.clone() },
        Settings { half_width: Some(7.3), ..ends([[3.0, 100.5], [37.0, 8000.2]]) },
    ] {
        let Err(Refusal::Long { frames: most }) = check(&plan(&settings, 1_000_000), [wide, high]) else { panic!() };
        assert_eq!(check(&plan(&settings, most), [wide, high]), Ok(()));
        assert_eq!(check(&plan(&settings, most + 1), [wide, high]), Err(Refusal::Long { frames: most }));
        let mut following = Following::new(plan(&settings, most + 1)).unwrap();
        let plane = film::Plane::new(wide, high, vec![100; wide * high]).unwrap();
        for frame in 0..most {
            assert_eq!(following.take(plane.clone()), Ok(()), "{frame} of {most}");
        }
        assert_eq!(following.take(plane), Err(Refusal::Long { frames: most }));
    }
    let start = Settings::new(Click { frame: 0, position: [80.0, 60.0] });
    assert_eq!(check(&plan(&start, 27_962), [160, 120]), Ok(()));
    assert_eq!(check(&plan(&start, 30_000), [160, 120]), Err(Refusal::Long { frames: 27_962 }));
}

/// Result of taking the first frames of so many, in which a disc rests.
fn taken(frames: usize, first: usize) -> Result<(), Refusal> {
    let [wide, high] = [300_usize, 240];
    let far = |at: usize| libm::hypot((at % wide) as f64 - 150.0, (at / wide) as f64 - 120.0);
    let grey = (0..wide * high).map(|at| if far(at) < 60.0 { 90 } else { 160 }).collect();
    let plane = film::Plane::new(wide, high, grey).unwrap();
    let keys = vec![Click { frame: 0, position: [150.0, 120.0] }];
    let body = body::Settings { keys, radius: Some(60.0), readout: Known::Estimated };
    let frames = (0..frames).map(|frame| (frame, frame as f64 / 30.0)).collect();
    let mut following = Following::new(Plan { surfaces: Vec::new(), bodies: vec![body], marks: Vec::new(), frames })?;
    (0..first).try_for_each(|_| following.take(plane.clone()))
}

#[test]
fn a_film_that_is_too_long_for_a_body_is_refused_at_its_beginning() {
    let Err(Refusal::Long { frames: most }) = taken(1_000_000, 70) else { panic!() };
    assert!((3000..6000).contains(&most), "{most}");
    assert_eq!(taken(most, 70), Ok(()));
    assert_eq!(taken(most + 1, 70), Err(Refusal::Long { frames: most }));
}
