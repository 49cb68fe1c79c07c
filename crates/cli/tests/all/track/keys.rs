//! Where something is at further times: key frames of bodies, anchors of surfaces.

use super::scenes::{FRAMES, HEIGHT, WIDTH, noisy, place, scene, tubes, y4m};
use super::{deviation, folder_with, track, tracked};
use crate::common::numbers;

/// A ball behind a post in the frames of the first range, and a second one 60 pixels further to the right behind another in those of
/// the second.
fn two_balls(x: usize, y: usize, frame: u32) -> u8 {
    let [u, v] = place(frame);
    let dark = |shift: f64, visible: bool| {
        let far = libm::hypot(x as f64 + 0.5 - u - shift, y as f64 + 0.5 - v);
        if visible { 1.0 / (1.0 + libm::exp((far - 6.0) / 0.5)) } else { 0.0 }
    };
    let dark = dark(0.0, !(15..30).contains(&frame)) + dark(60.0, !(34..49).contains(&frame));
    noisy(190.0 - 110.0 * dark, x, y, frame)
}

#[test]
fn bodies_are_found_again_by_key_frames_of_their_own() {
    let (_folder, film) = folder_with("balls.y4m", &y4m([WIDTH, HEIGHT], 60, two_balls));
    let at = |frame: u32, shift: f64| {
        let [x, y] = place(frame);
        format!("{:.1},{:.1}", x + shift, y)
    };
    // In the unit of its own, and to a millisecond as a player shows it: 1.666 s are within frame 50.
    let first = format!("{},7 {}@1033[ms]", at(0, 0.0), at(31, 0.0));
    let second = format!("{} {}@1.666", at(0, 60.0), at(50, 60.0));
    let done = track(&film, &["--body", &first, "--body", &second, "--format", "json"]);
    assert_eq!(done.code, 0, "{}", done.stderr);
    for part in [
        "track 1: lost from frame 16 on (counted from 1; 0.500 s of the film)",
        "track 2: lost from frame 35 on (counted from 1; 1.133 s of the film)",
        "and found again later",
    ] {
        assert!(done.stderr.contains(part), "lacks «{part}»: {}", done.stderr);
    }
    let json: serde_json::Value = serde_json::from_str(&done.stdout).expect("JSON");
    assert_eq!(json["settings"]["bodies"][1]["keys"][0]["time"], 1.666);
    for (track, shift, gap) in [(0, 0.0, 15..31), (1, 60.0, 34..50)] {
        let points = json["tracks"][track]["points"].as_array().expect("points");
        let frames: Vec<u64> = points.iter().map(|point| point["frame"].as_u64().expect("a number")).collect();
        assert_eq!(frames, (0..60).filter(|frame| !gap.contains(frame)).collect::<Vec<u64>>(), "{track}");
        // A click beside the middle of the body does not move its track.
        let error = |point: &serde_json::Value| {
            let frame = point["frame"].as_u64().expect("a number") as u32;
            point["x"].as_f64().expect("a number") - place(frame)[0] - shift
        };
        let [before, after] = [&points[..gap.start as usize], &points[gap.start as usize..]]
            .map(|points| points.iter().map(error).sum::<f64>() / points.len() as f64);
        assert!((before - after).abs() < 0.2, "{track}: {before} {after}");
    }
}

#[test]
fn a_click_at_a_time_begins_there() {
    let (_folder, film) = folder_with("balls.y4m", &y4m([WIDTH, HEIGHT], 60, two_balls));
    let [x, y] = place(30);
    let (_, rows) = tracked(&film, &["--body", &format!("{x},{y}@1")]);
    assert_eq!((rows.len(), rows[0][0]), (30, 1.0));
    // A surface is followed from the click towards both ends.
    let (_folder, film) = folder_with("tubes.y4m", &y4m([WIDTH, HEIGHT], FRAMES, tubes));
    let click = format!("50,{}@2.1", 60.0 - super::height(2.1));
    let (_, rows) = tracked(&film, &["--surface", &click]);
    assert_eq!(rows.len(), FRAMES as usize);
    let (rms, _) = deviation(&rows, 1, 2, super::height);
    assert!(rms < 0.05, "{rms}");
}

#[test]
fn an_anchor_holds_the_path_of_a_surface() {
    // Each tube has a second surface at rest in it, 100 pixels below the top.
    let double = |x: usize, y: usize, frame: u32| {
        let (u, v) = (x as f64 + 0.5, y as f64 + 0.5);
        let grey = if v > 90.0 {
            190.0 - (190.0 - scene(u, v, frame)) / (1.0 + libm::exp((100.0 - v) / 0.5))
        } else {
            scene(u, v, frame)
        };
        noisy(grey, x, y, frame)
    };
    let (_folder, film) = folder_with("double.y4m", &y4m([WIDTH, HEIGHT], FRAMES, double));
    let row_at = |clicks: &str, row: usize| tracked(&film, &["--surface", clicks]).1[row][1];
    assert!((row_at("50,42", 60) - 60.0 - super::height(2.0)).abs() < 2.0);
    assert!((row_at("50,42 50,100@2", 60) - 20.0).abs() < 3.0);
}

#[test]
fn a_click_in_a_repeated_frame_is_one_in_the_frame_with_that_picture() {
    // Every fourth picture is shown twice, and the ball hides for a while.
    let shown = |frame: u32| frame * 4 / 5;
    let converted = y4m([WIDTH, HEIGHT], 70, |x, y, frame| two_balls(x, y, shown(frame)));
    let (_folder, film) = folder_with("converted.y4m", &converted);
    // Frame 41 shows picture 32 again, as frame 40 does.
    let [x, y] = place(32);
    let done = track(&film, &["--body", &format!("{x},{y}@1.3666")]);
    assert_eq!(done.code, 0, "{}", done.stderr);
    assert!(done.stderr.contains("repeat the picture before"), "{}", done.stderr);
    let rows = numbers(&done.stdout);
    assert!((rows[0][0] - 40.0 / 30.0).abs() < 1e-9 && rows.len() == 24, "{} {:?}", rows.len(), rows[0]);
}

#[test]
fn clicks_that_the_film_does_not_have_are_refused() {
    let (_folder, film) = folder_with("tubes.y4m", &y4m([WIDTH, HEIGHT], FRAMES, tubes));
    let cases: [(&[&str], [&str; 2]); 6] = [
        (
            &["--body", "50,42 60,50@3"],
            ["60,50@3: no frame that is tracked has this time", "are from 0.000 s to 2.966 s of the film"],
        ),
        (
            &["--surface", "50,42 50,60@0.5", "--from", "1", "--until", "2"],
            ["50,60@0.5: no frame", "from 1.000 s to 2.000 s"],
        ),
        (&["--body", "50,42 200,50@1"], ["--body 200,50 lies outside the picture", "160 pixels wide"]),
        (&["--body", "50,42 60,50"], ["60,50: say at which time of the film it is there", "60,50@3.5"]),
        (
            &["--body", "50,42 60,50@soon"],
            ["60,50@soon: `soon` does not begin with a number; a time is in seconds", "@3500[ms]"],
        ),
        (&["--surface", "50,42,7"], ["a surface has no radius", "255,130"]),
    ];
    for (words, expected) in cases {
        let done = track(&film, words);
        assert_eq!((done.code, done.stdout.as_str()), (2, ""), "{words:?}");
        for part in expected {
            assert!(done.stderr.contains(part), "{words:?} lacks «{part}»:\n{}", done.stderr);
        }
    }
    let spanish = track(&film, &["--body", "50,42 60,50@3", "--language", "es"]);
    assert!(spanish.stderr.contains("van de 0,000 s a 2,966 s del vídeo"), "{}", spanish.stderr);
}
