//! `meniscus track` on films that are formulas. They are Y4M films, so that no test needs `ffmpeg`.

use crate::common::{Done, done, meniscus, numbers, program};
use crate::fit::word;
use std::path::{Path, PathBuf};

const WIDTH: usize = 160;
const HEIGHT: usize = 120;
const FRAMES: u32 = 90;
const PERIOD: f64 = 0.8;
const DECAY: f64 = 3.0;

/// The height of the liquid in the left arm above its rest, in pixels; the right arm has the opposite one.
fn height(t: f64) -> f64 {
    20.0 * libm::exp(-t / DECAY) * libm::cos(std::f64::consts::TAU / PERIOD * t + 0.4)
}

/// A grey value with some noise that is a function of the place.
fn noisy(grey: f64, x: usize, y: usize, frame: u32) -> u8 {
    let seed =
        (x as u32).wrapping_mul(73_856_093) ^ (y as u32).wrapping_mul(19_349_663) ^ frame.wrapping_mul(83_492_791);
    let seed = (seed ^ (seed >> 13)).wrapping_mul(1_274_126_177);
    (grey + f64::from((seed >> 16) % 7) - 3.0).round() as u8
}

/// Two upright tubes around x = 50 and x = 110 with a liquid that rests at y = 60, at the point (x, y).
fn scene(x: f64, y: f64, frame: u32) -> f64 {
    let t = f64::from(frame) / 30.0;
    let level = if x < 80.0 { 60.0 - height(t) } else { 60.0 + height(t) };
    let inside = (x - 50.0).abs() < 5.0 || (x - 110.0).abs() < 5.0;
    // The part of the pixel below the surface, blurred a little as by a lens.
    let wet = 1.0 / (1.0 + libm::exp(-(y - level) / 0.5));
    if inside { 190.0 - 90.0 * wet } else { 190.0 }
}

fn tubes(x: usize, y: usize, frame: u32) -> u8 {
    noisy(scene(x as f64 + 0.5, y as f64 + 0.5, frame), x, y, frame)
}

/// Where a ball is.
fn place(frame: u32) -> [f64; 2] {
    let t = f64::from(frame) / 30.0;
    [30.0 + 30.0 * t, 100.0 - 45.0 * t + 15.0 * t * t]
}

/// A dark ball of radius 6, which is gone from frame 60 on.
fn ball(x: usize, y: usize, frame: u32) -> u8 {
    let [u, v] = place(frame);
    let far = libm::hypot(x as f64 + 0.5 - u, y as f64 + 0.5 - v);
    let dark = if frame < 60 { 1.0 / (1.0 + libm::exp((far - 6.0) / 0.5)) } else { 0.0 };
    noisy(190.0 - 110.0 * dark, x, y, frame)
}

fn y4m(size: [usize; 2], frames: u32, grey: impl Fn(usize, usize, u32) -> u8) -> Vec<u8> {
    let [width, height] = size;
    let mut film = format!("YUV4MPEG2 W{width} H{height} F30:1 Ip A1:1 Cmono\n").into_bytes();
    for frame in 0..frames {
        film.extend(b"FRAME\n");
        film.extend((0..width * height).map(|at| grey(at % width, at / width, frame)));
    }
    film
}

/// A folder with `tubes.y4m` in it.
fn tubes_film() -> (tempfile::TempDir, PathBuf) {
    folder_with("tubes.y4m", &y4m([WIDTH, HEIGHT], FRAMES, tubes))
}

fn folder_with(name: &str, bytes: &[u8]) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join(name);
    std::fs::write(&path, bytes).expect("it can be written");
    (folder, path)
}

fn track(film: &Path, words: &[&str]) -> Done {
    meniscus(&[&["track", word(film)], words].concat())
}

fn tracked(film: &Path, words: &[&str]) -> (String, Vec<Vec<f64>>) {
    let done = track(film, words);
    assert_eq!(done.code, 0, "{words:?}: {}", done.stderr);
    (done.stdout.lines().next().unwrap_or_default().to_owned(), numbers(&done.stdout))
}

/// The root mean square of the differences from the truth about their mean, and in units of the stated errors.
fn deviation(rows: &[Vec<f64>], value: usize, sigma: usize, truth: impl Fn(f64) -> f64) -> (f64, f64) {
    let errors: Vec<f64> = rows.iter().map(|row| row[value] - truth(row[0])).collect();
    let mean = errors.iter().sum::<f64>() / errors.len() as f64;
    let rms = |values: Vec<f64>| (values.iter().map(|v| v * v).sum::<f64>() / values.len() as f64).sqrt();
    let relative = errors.iter().zip(rows).map(|(error, row)| (error - mean) / row[sigma]).collect();
    (rms(errors.iter().map(|error| error - mean).collect()), rms(relative))
}

#[test]
fn a_surface_is_found_with_its_errors() {
    let (_folder, film) = tubes_film();
    // The click is three pixels beside the surface.
    let click = format!("51,{}", 63.0 - height(0.0));
    let (head, rows) = tracked(&film, &["--surface", &click]);
    assert_eq!(head, "t [s],y [px],sigma_y [px]");
    assert_eq!(rows.len(), FRAMES as usize);
    assert!(rows.iter().enumerate().all(|(frame, row)| row[0] == frame as f64 / 30.0), "times are those of the frames");
    let (rms, relative) = deviation(&rows, 1, 2, height);
    assert!(rms < 0.05 && (0.5..2.0).contains(&relative), "{rms} {relative}");
    // Upwards from the bottom of the picture; what was clicked is followed, and not the surface itself.
    assert!((rows[0][1] - (57.0 + height(0.0))).abs() < 1.0, "{:?}", rows[0]);
}

#[test]
fn both_arms_and_lengths_are_measured() {
    let (_folder, film) = tubes_film();
    let clicks = ["--surface", "50,42", "--surface", "110,78", "--scale", "10,10,110,10=20 [cm]", "--origin", "0,60"];
    let (head, rows) = tracked(&film, &clicks);
    assert_eq!(head, "t [s],y_1 [m],sigma_y_1 [m],y_2 [m],sigma_y_2 [m]");
    for (value, sign) in [(1, 1.0), (3, -1.0)] {
        let (rms, _) = deviation(&rows, value, value + 1, |t| sign * 0.002 * height(t));
        assert!(rms < 0.05 * 0.002, "{value}: {rms}");
    }
    assert!((rows[0][1] - 0.002 * height(0.0)).abs() < 0.003 && rows[0][2] < 0.0002, "{:?}", rows[0]);
}

#[test]
fn a_fit_of_the_track_finds_period_and_decay() {
    let (folder, film) = tubes_film();
    let table = folder.path().join("tubes.csv");
    let words = ["--surface", "50,42", "--scale", "10,10,110,10=20 [cm]", "--origin", "0,60", "--output", word(&table)];
    let (written, _) = tracked(&film, &words);
    assert_eq!(written, "");
    let theory = "simulations/theories/linear.md";
    let fit = ["fit", theory, word(&table), "--observe", "y", "--error", "y=sigma_y", "--format", "json"];
    let done = meniscus(&fit);
    assert_eq!(done.code, 0, "{}", done.stderr);
    let json: serde_json::Value = serde_json::from_str(&done.stdout).expect("JSON");
    // The length of the column stands for the period.
    let (omega, gamma) = (std::f64::consts::TAU / PERIOD, 1.0 / DECAY);
    let squared = omega * omega + gamma * gamma;
    for (name, truth, most) in [("L", 2.0 * 9.8 / squared, 5e-5), ("gamma", gamma, 1e-3)] {
        let found = &json["parameters"][name];
        let [value, error] = ["value", "stderr_hac"].map(|key| found[key].as_f64().expect("a number"));
        assert!(error < most && (value - truth).abs() < 4.0 * error, "{name}: {value} ± {error}");
    }
}

#[test]
fn a_body_is_followed_until_it_is_lost() {
    let (_folder, film) = folder_with("ball.y4m", &y4m([WIDTH, HEIGHT], FRAMES, ball));
    let done = track(&film, &["--body", "30,100"]);
    assert_eq!(done.code, 0, "{}", done.stderr);
    assert!(done.stdout.starts_with("t [s],x [px],y [px],sigma_x [px],sigma_y [px]\r\n"), "{}", done.stdout);
    assert!(done.stderr.contains("lost from frame 60 on"), "{}", done.stderr);
    let rows = numbers(&done.stdout);
    assert_eq!(rows.len(), 60);
    for (value, truth) in [(1, (|t| 30.0 * t) as fn(f64) -> f64), (2, |t| 45.0 * t - 15.0 * t * t)] {
        let (rms, relative) = deviation(&rows, value, value + 2, truth);
        assert!(rms < 0.06 && (0.4..2.0).contains(&relative), "{value}: {rms} {relative}");
    }
    let (head, rows) = tracked(&film, &["--body", "30,100,8", "--body", "31,101"]);
    assert!(head.starts_with("t [s],x_1 [px],y_1 [px],sigma_x_1 [px],sigma_y_1 [px],x_2 [px]"), "{head}");
    assert!((rows[30][5] - rows[30][1]).abs() < 3.0, "{:?}", rows[30]);
}

#[test]
fn repeated_pictures_are_left_out() {
    // Every fourth picture is shown twice, as in a film of 24 frames a second that was converted to 30.
    let converted = y4m([WIDTH, HEIGHT], 100, |x, y, frame| tubes(x, y, frame * 4 / 5));
    let (_folder, film) = folder_with("converted.y4m", &converted);
    let done = track(&film, &["--surface", "50,42"]);
    assert!(done.stderr.contains("20 of 100 frames repeat the picture before and are left out"), "{}", done.stderr);
    let rows = numbers(&done.stdout);
    assert_eq!(rows.len(), 80);
    assert!(rows.iter().all(|row| (row[0] * 30.0).round() as u32 % 5 != 1), "the second of two equal ones is left out");
}

#[test]
fn resting_marks_correct_for_a_camera_that_moves() {
    let dots = [[20.0, 20.0], [140.0, 25.0], [25.0, 100.0], [135.0, 95.0]];
    let shaken = y4m([WIDTH, HEIGHT], 60, |x, y, frame| {
        // It is at rest in the first frame, to which the clicks belong.
        let phase = 0.37 * f64::from(frame);
        let (u, v) = (x as f64 + 0.5 - 2.5 * libm::sin(phase), y as f64 + 0.5 - 2.0 * libm::sin(1.7 * phase));
        let dot = |[a, b]: [f64; 2]| 1.0 / (1.0 + libm::exp((libm::hypot(u - a, v - b) - 3.0) / 0.5));
        let dark: f64 = dots.into_iter().map(dot).sum();
        noisy(scene(u, v, frame) - 110.0 * dark, x, y, frame)
    });
    let (_folder, film) = folder_with("shaken.y4m", &shaken);
    let deviation = |words: &[&str]| {
        let rows = tracked(&film, &[&["--surface", "50,42"], words].concat()).1;
        assert_eq!(rows.len(), 60);
        deviation(&rows, 1, 2, height).0
    };
    let (with, without) = (deviation(&["--marks", "20,20 140,25 25,100 135,95"]), deviation(&[]));
    assert!(with < 0.08 && without > 1.0, "{with} {without}");
}

#[test]
fn a_part_of_a_slow_film_has_the_times_of_the_motion() {
    let (_folder, film) = tubes_film();
    let click = format!("50,{}", 60.0 - height(1.0));
    let (_, rows) = tracked(&film, &["--surface", &click, "--from", "1", "--until", "2500 [ms]", "--rate", "8"]);
    assert_eq!(rows.len(), 46);
    assert!((rows[0][0] - 0.125).abs() < 1e-12 && (rows[45][0] - 0.3125).abs() < 1e-12);
    assert!(deviation(&rows, 1, 2, |t| height(8.0 * t)).0 < 0.05);
}

#[test]
fn json_holds_settings_notes_and_scores() {
    let (folder, film) = tubes_film();
    let output = folder.path().join("tubes.json");
    let done = track(&film, &["--surface", "50,42", "--scale", "10,10,110,10=20 [cm]", "--output", word(&output)]);
    assert_eq!(done.code, 0, "{}", done.stderr);
    let json: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(output).unwrap()).expect("JSON");
    let number = |value: &serde_json::Value| value.as_f64().expect("a number");
    assert_eq!((&json["unit"], &json["frames"]), (&"m".into(), &90.into()));
    assert!((number(&json["scale"]["metres_per_pixel"]) - 0.002).abs() < 1e-12);
    assert_eq!(json["settings"]["surfaces"][0][1], 42.0);
    assert!(json["notes"].to_string().contains("30.00 frames/s"), "{json}");
    let points = json["tracks"][0]["points"].as_array().expect("points");
    assert_eq!((points.len(), &points[7]["frame"], &points[7]["doubtful"]), (90, &7.into(), &false.into()));
    assert!(number(&points[7]["score"]) > 0.9 && number(&points[7]["sigma_y"]) > 0.0);
    assert!(!json["tracks"][0]["exposure"].is_null());
}

#[test]
fn several_films_get_a_table_each() {
    let (folder, film) = tubes_film();
    let second = folder.path().join("again.y4m");
    std::fs::copy(&film, &second).unwrap();
    let broken = folder.path().join("broken.y4m");
    std::fs::write(&broken, "YUV4MPEG2 W0 H0\n").unwrap();
    let tables = folder.path().join("tables");
    let words = |output: &[&'static str]| {
        let films = [word(&film), word(&broken), word(&second)].map(str::to_owned);
        let mut all: Vec<String> = vec!["track".into()];
        all.extend(films);
        all.extend(["--surface", "50,42"].map(str::to_owned));
        all.extend(output.iter().map(|word| (*word).to_owned()));
        all
    };
    let run = |words: &[String]| meniscus(&words.iter().map(String::as_str).collect::<Vec<_>>());
    // One that cannot be read keeps none of the others away.
    let beside = run(&words(&[]));
    assert_eq!((beside.code, beside.stdout.as_str()), (2, ""));
    assert!(
        beside.stderr.contains("broken.y4m: The header") && beside.stderr.contains("again.y4m: note: 30.00"),
        "{}",
        beside.stderr
    );
    let lone = tracked(&film, &["--surface", "50,42"]).1;
    for name in ["tubes.y4m.csv", "again.y4m.csv"] {
        assert_eq!(numbers(&std::fs::read_to_string(folder.path().join(name)).unwrap()), lone, "{name}");
    }
    let mut into = words(&["--output"]);
    into.push(word(&tables).to_owned());
    assert!(run(&into).stderr.contains("there is no such folder"));
    std::fs::create_dir(&tables).unwrap();
    assert_eq!(run(&into).code, 2);
    assert_eq!(crate::common::names(&tables), ["again.y4m.csv", "tubes.y4m.csv"]);
}

#[test]
fn what_cannot_be_tracked_is_refused_with_words() {
    let (folder, film) = tubes_film();
    let named = |name: &str, bytes: &[u8]| {
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        path
    };
    let gif = named("film.gif", b"GIF89a and so on");
    let text = named("film.txt", b"t\ty\n0\t1\n");
    let empty = named("film.mp4", b"");
    let no_frames = named("none.y4m", b"YUV4MPEG2 W2 H2 F30:1 Cmono\n");
    let no_rate = named("rate.y4m", b"YUV4MPEG2 W2 H2 F0:0 Cmono\nFRAME\nabcd");
    let sound = named("sound.mp4", b"\0\0\0\x14ftypM4A \0\0\0\0M4A \0\0\0\x08moov");
    let flat = named("flat.y4m", &y4m([WIDTH, HEIGHT], 5, |_, _, _| 90));
    let two = named("two.y4m", &y4m([WIDTH, HEIGHT], 2, tubes));
    let missing = folder.path().join("missing.mp4");
    let cases: [(&Path, &[&str], &str); 18] = [
        (&film, &[], "--surface X,Y"),
        (
            &film,
            &["--surface", "200,40"],
            "--surface 200,40 lies outside the picture, which is 160 pixels wide and 120 high",
        ),
        (&film, &["--body", "10,-1"], "lies outside"),
        (&film, &["--surface", "50"], "write two numbers of pixels"),
        (&film, &["--surface", "1,1", "--surface", "2,2", "--surface", "3,3"], "at most 2 surfaces"),
        (&film, &["--surface", "50,42", "--body", "50,42"], "cannot be used with"),
        (&film, &["--surface", "50,42", "--surface", "110,78", "--tube", "50,1,50,119"], "once for each --surface"),
        (&film, &["--surface", "50,42", "--scale", "1,1,2,1=1 [cm]"], "too close together"),
        (&film, &["--surface", "50,42", "--rate", "0"], "--rate 0 is not possible"),
        (&film, &["--surface", "50,42", "--from", "10"], "no frame lies between"),
        (&flat, &["--body", "20,20"], "uniform"),
        (&two, &["--surface", "50,42"], "at least 3 frames"),
        (&gif, &["--surface", "1,1"], "animated GIF"),
        (&text, &["--surface", "1,1"], "not a film"),
        (&empty, &["--surface", "1,1"], "empty"),
        (&no_rate, &["--surface", "1,1"], "no frame rate"),
        (&no_frames, &["--surface", "1,1"], "no frames"),
        (&missing, &["--surface", "1,1"], "cannot read"),
    ];
    for (film, words, expected) in cases {
        let done = track(film, words);
        assert_eq!((done.code, done.stdout.as_str()), (2, ""), "{words:?}");
        assert!(done.stderr.contains(expected), "{words:?} lacks «{expected}»:\n{}", done.stderr);
    }
    let done = track(&sound, &["--surface", "1,1"]);
    assert!(done.code == 2 && done.stdout.is_empty(), "{}", done.stderr);
    let spanish = track(&film, &["--surface", "200,40", "--language", "es"]);
    assert!(spanish.stderr.contains("está fuera de la imagen"), "{}", spanish.stderr);
}

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
#[cfg(unix)]
fn with_decoder(film: &Path, pixels: &[u8], words: &[&str]) -> Done {
    use std::os::unix::fs::PermissionsExt;
    let (folder, path) = folder_with("pixels", pixels);
    let script = folder.path().join("ffmpeg");
    std::fs::write(&script, format!("#!/bin/sh\necho a complaint >&2\nexec /bin/cat '{}'\n", word(&path))).unwrap();
    std::fs::set_permissions(&script, std::fs::Permissions::from_mode(0o755)).unwrap();
    let all = [&["track", word(film)], words].concat();
    done(program().args(all).env("PATH", folder.path()).output().expect("the program starts"))
}

/// A tube in the middle of a picture of 64 times 96 pixels that is seen upright, with a level that rises by a pixel and a half in
/// each frame; at the point (x, y) of it.
fn narrow(x: f64, y: f64, frame: u32) -> f64 {
    let wet = 1.0 / (1.0 + libm::exp(-(y - level(frame)) / 0.5));
    if (x - 32.0).abs() < 4.0 { 190.0 - 90.0 * wet } else { 190.0 }
}

fn level(frame: u32) -> f64 {
    60.0 - 1.5 * f64::from(frame)
}

#[cfg(unix)]
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

#[cfg(unix)]
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

#[cfg(unix)]
#[test]
fn another_number_of_frames_is_an_error_with_both_numbers() {
    let grey = |x: usize, y: usize, frame: u32| noisy(narrow(x as f64, y as f64, frame), x, y, frame);
    for (frames, expected) in
        [(10, ["lists 12 frames", "10 could be decoded"]), (13, ["lists 12 frames", "13 were decoded"])]
    {
        let done = with_decoder(&coded("h264.mp4"), &y4m([96, 64], frames, grey), &["--surface", "32,40"]);
        assert_eq!((done.code, done.stdout.as_str()), (2, ""));
        for part in expected.into_iter().chain(["ffmpeg reports: a complaint"]) {
            assert!(done.stderr.contains(part), "lacks «{part}»: {}", done.stderr);
        }
    }
    let part = ["--surface", "32,40", "--until", "0.29"];
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
