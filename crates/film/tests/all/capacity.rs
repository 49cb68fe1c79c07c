//! The length of a film is refused before a frame is decoded, with the number at which the tracker would stop.

use film::capacity::check;
use film::tracking::column::{Click, Settings};
use film::tracking::{Following, Plan, Refusal, Surface};

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
