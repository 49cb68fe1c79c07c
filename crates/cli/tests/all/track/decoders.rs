//! Coded films: with a decoder that is a script, with `ffmpeg` where it is installed, and without any.

use super::deviation;
use super::scenes::{level, narrow, noisy, y4m};
use super::{folder_with, track, tracked, tubes_film};
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

/// Codings and containers: those that browsers decode, and those that they do not.
#[test]
#[ignore = "needs ffmpeg"]
fn a_coded_film_gives_the_same_track() {
    let (folder, film) = tubes_film();
    let plain = tracked(&film, &["--surface", "50,42"]).1;
    for (name, codec, pixels, options) in [
        ("mjpeg.mov", "mjpeg", "yuvj420p", &["-q:v", "2"][..]),
        ("asp.avi", "mpeg4", "yuv420p", &["-q:v", "2", "-vtag", "XVID"]),
        ("reordered.avi", "mpeg4", "yuv420p", &["-q:v", "2", "-vtag", "DX50", "-bf", "2"]),
        ("asp.mp4", "mpeg4", "yuv420p", &["-q:v", "2", "-bf", "2"]),
        ("asp.mov", "mpeg4", "yuv420p", &["-q:v", "2"]),
        ("prores.mov", "prores_ks", "yuv422p10le", &["-profile:v", "3"]),
        ("prores.mkv", "prores_ks", "yuv422p10le", &[]),
        ("lossless.avi", "ffvhuff", "yuv420p", &[]),
    ] {
        let coded = folder.path().join(name);
        let words = [&["-v", "error", "-i", word(&film), "-c:v", codec, "-pix_fmt", pixels], options, &[word(&coded)]];
        let made = std::process::Command::new("ffmpeg").args(words.concat()).status().expect("it starts");
        assert!(made.success(), "{name}");
        let rows = tracked(&coded, &["--surface", "50,42"]).1;
        assert_eq!(rows.len(), plain.len(), "{name}");
        for (row, plain) in rows.iter().zip(&plain) {
            // Matroska keeps times in milliseconds.
            assert!((row[0] - plain[0]).abs() < 6e-4 && (row[1] - plain[1]).abs() < 0.2, "{name}: {row:?} {plain:?}");
        }
    }
    // Cut in the middle of a frame, which ffmpeg decodes as far as it is there.
    let file = std::fs::read(folder.path().join("asp.avi")).expect("it was made");
    let cut = folder.path().join("cut.avi");
    std::fs::write(&cut, &file[..file.len() / 2]).expect("it can be written");
    let done = track(&cut, &["--surface", "50,42"]);
    assert_eq!(done.code, 0, "{}", done.stderr);
    let rows = numbers(&done.stdout);
    assert!((20..plain.len() - 20).contains(&rows.len()), "{}", rows.len());
    let note = format!("of {} frames, {} are in its", plain.len(), rows.len());
    assert!(done.stderr.contains(&note), "lacks «{note}»: {}", done.stderr);
}

/// More frames may be decoded of a cut film than are there as a whole: those are not used.
#[test]
fn a_cut_film_gives_the_frames_that_are_there() {
    let file = std::fs::read(coded("mjpeg.avi")).expect("it is there");
    let (_folder, film) = folder_with("cut.avi", &file[..file.len() * 2 / 3]);
    let grey = |x: usize, y: usize, frame: u32| noisy(narrow(x as f64, y as f64, frame), x, y, frame);
    let done = with_decoder(&film, &y4m([96, 64], 12, grey), &["--surface", "32,60"]);
    assert_eq!(done.code, 0, "{}", done.stderr);
    let rows = numbers(&done.stdout).len();
    assert!(
        (5..12).contains(&rows) && done.stderr.contains(&format!("of 12 frames, {rows} are in its")),
        "{}",
        done.stderr
    );
}

/// The limit is known from the file: no decoder is started.
#[test]
fn too_many_frames_are_refused_before_they_are_decoded() {
    let little = |numbers: &[u32]| numbers.iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<u8>>();
    let chunk = |id: &[u8], content: &[u8]| [id, &little(&[content.len() as u32]), content].concat();
    let header = [&b"vidsXVID"[..], &little(&[0, 0, 0, 1, 25, 0, 30_000, 0, 0, 0])].concat();
    let format = [&little(&[40, 160, 120, 0x18_0001])[..], b"XVID", &[0; 20]].concat();
    let stream = [&b"strl"[..], &chunk(b"strh", &header), &chunk(b"strf", &format)].concat();
    let headers = chunk(b"LIST", &[&b"hdrl"[..], &chunk(b"LIST", &stream)].concat());
    let frames = chunk(b"LIST", &[&b"movi"[..], &chunk(b"00dc", &[1, 2]).repeat(30_000)].concat());
    let file = chunk(b"RIFF", &[&b"AVI "[..], &headers, &frames].concat());
    let (folder, film) = folder_with("long.avi", &file);
    let words = ["track", word(&film), "--surface", "50,42"];
    let done = done(program().args(words).env("PATH", folder.path()).output().expect("the program starts"));
    assert_eq!((done.code, done.stdout.as_str()), (2, ""));
    for part in ["at most 27962 frames", "the part has 30000 frames", "--until 1118.44"] {
        assert!(done.stderr.contains(part), "lacks «{part}»: {}", done.stderr);
    }
}
