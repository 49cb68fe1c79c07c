//! Coded films: with a decoder that is a script, with `ffmpeg` where it is installed, and without any.

use super::deviation;
use super::scenes::{level, narrow, noisy, y4m};
use super::{folder_with, tracked, tubes_film};
use crate::common::{Done, done, numbers, program};
use crate::fit::word;
use std::path::{Path, PathBuf};

/// A film of the tests of the crate `film`.
fn coded(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../film/tests/films").join(name).canonicalize().expect("it is there")
}

#[test]
fn without_ffmpeg_the_message_says_how_to_install_it() {
    let folder = tempfile::tempdir().unwrap();
    let film = coded("h264.mp4");
    let words = ["track", word(&film), "--surface", "20,20"];
    let done = done(program().args(words).env("PATH", folder.path()).output().expect("the program starts"));
    assert_eq!((done.code, done.stdout.as_str()), (2, ""));
    assert!(done.stderr.contains("ffmpeg is not installed") && done.stderr.contains(" install"), "{}", done.stderr);
}

/// Runs with an `ffmpeg` that writes these bytes, whatever it is asked for.
fn with_decoder(film: &Path, pixels: &[u8], words: &[&str]) -> Done {
    use std::os::unix::fs::PermissionsExt;
    let (folder, path) = folder_with("pixels", pixels);
    let script = folder.path().join("ffmpeg");
    std::fs::write(&script, format!("#!/bin/sh\necho a complaint >&2\nexec /bin/cat '{}'\n", word(&path))).unwrap();
    std::fs::set_permissions(&script, std::fs::Permissions::from_mode(0o755)).unwrap();
    let all = [&["track", word(film)], words].concat();
    done(program().args(all).env("PATH", folder.path()).output().expect("the program starts"))
}

#[test]
fn clicks_and_coordinates_are_those_of_the_upright_picture() {
    // Where a point of the stored picture, 96 times 64 pixels large, is in the upright one.
    type Turn = fn(f64, f64) -> [f64; 2];
    let turns: [(&str, Turn); 2] =
        [("rotated-90.mp4", |x, y| [64.0 - y, x]), ("rotated-270.mp4", |x, y| [y, 96.0 - x])];
    for (name, turn) in turns {
        let grey = |x: usize, y: usize, frame: u32| {
            let [u, v] = turn(x as f64 + 0.5, y as f64 + 0.5);
            noisy(narrow(u, v, frame), x, y, frame)
        };
        let done = with_decoder(&coded(name), &y4m([96, 64], 12, grey), &["--surface", "32,60"]);
        assert_eq!(done.code, 0, "{name}: {}", done.stderr);
        assert!(done.stderr.contains("64 x 96 pixels"), "{name}: {}", done.stderr);
        let rows = numbers(&done.stdout);
        assert_eq!(rows.len(), 12, "{name}");
        let (rms, _) = deviation(&rows, 1, 2, |t| 96.0 - level((30.0 * t).round() as u32));
        assert!(rms < 0.1 && (rows[0][1] - 36.0).abs() < 1.0, "{name}: {rms} {:?}", rows[0]);
        for (frame, row) in (0..).zip(&rows) {
            assert!((row[0] - f64::from(frame) / 30.0).abs() < 1e-9, "{name} {frame}: {row:?}");
        }
    }
}

#[test]
fn the_capture_rate_of_the_file_gives_the_times() {
    // An upright picture of 96 times 64 pixels: the tube is further to the right and its level higher.
    let grey = |x: usize, y: usize, frame: u32| {
        noisy(narrow(x as f64 + 0.5 - 16.0, y as f64 + 0.5 + 20.0, frame), x, y, frame)
    };
    let pixels = y4m([96, 64], 12, grey);
    for (words, factor, note) in [
        (&[][..], 8.0, "slow motion: taken at 240.00 frames/s"),
        (&["--rate", "4"][..], 4.0, "times are divided by 4, as --rate says"),
    ] {
        let done = with_decoder(&coded("capture-rate.mp4"), &pixels, &[&["--surface", "48,40"], words].concat());
        assert_eq!(done.code, 0, "{}", done.stderr);
        assert!(done.stderr.contains(note), "{}", done.stderr);
        let rows = numbers(&done.stdout);
        assert!((rows[11][0] - 11.0 / 30.0 / factor).abs() < 1e-9, "{:?}", rows[11]);
    }
}

#[test]
fn another_number_of_frames_is_an_error_with_both_numbers() {
    let grey = |x: usize, y: usize, frame: u32| noisy(narrow(x as f64, y as f64, frame), x, y, frame);
    for (frames, expected) in
        [(10, ["lists 12 frames", "10 could be decoded"]), (13, ["lists 12 frames", "13 were decoded"])]
    {
        let done = with_decoder(&coded("h264.mp4"), &y4m([96, 64], frames, grey), &["--surface", "32,60"]);
        assert_eq!((done.code, done.stdout.as_str()), (2, ""));
        for part in expected.into_iter().chain(["ffmpeg reports: a complaint"]) {
            assert!(done.stderr.contains(part), "lacks «{part}»: {}", done.stderr);
        }
    }
    let part = ["--surface", "32,60", "--until", "0.29"];
    let done = with_decoder(&coded("h264.mp4"), &y4m([96, 64], 10, grey), &part);
    assert_eq!((done.code, numbers(&done.stdout).len()), (0, 9), "{}", done.stderr);
}

/// Whether films can be decoded here.
fn has_ffmpeg() -> bool {
    std::process::Command::new("ffmpeg").arg("-version").output().is_ok_and(|output| output.status.success())
}

#[test]
fn where_ffmpeg_is_installed_a_coded_film_gives_the_same_track() {
    if !has_ffmpeg() {
        return;
    }
    let (folder, film) = tubes_film();
    let coded = folder.path().join("tubes.mov");
    let words = ["-v", "error", "-i", word(&film), "-c:v", "mjpeg", "-q:v", "2", "-pix_fmt", "yuvj420p", word(&coded)];
    let made = std::process::Command::new("ffmpeg").args(words).status().expect("it starts");
    assert!(made.success());
    let plain = tracked(&film, &["--surface", "50,42"]).1;
    let rows = tracked(&coded, &["--surface", "50,42"]).1;
    assert_eq!(rows.len(), plain.len());
    for (row, plain) in rows.iter().zip(&plain) {
        assert!((row[0] - plain[0]).abs() < 1e-6 && (row[1] - plain[1]).abs() < 0.15, "{row:?} {plain:?}");
    }
}
