//! `meniscus track` on films that are formulas. They are Y4M films, so that no test needs `ffmpeg`.

// A shell script stands for `ffmpeg` there.
#[cfg(unix)]
mod decoders;
mod keys;
mod reports;
mod scenes;

use crate::common::{Done, meniscus, numbers};
use crate::fit::word;
use scenes::{DECAY, FRAMES, HEIGHT, PERIOD, WIDTH, ball, height, noisy, scene, tubes, y4m};
use std::path::{Path, PathBuf};

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
    let head = done.stdout.lines().find(|line| !line.starts_with('#'));
    (head.unwrap_or_default().to_owned(), numbers(&done.stdout))
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
    let fit = ["fit", theory, word(&table), "--observe", "y", "--format", "json"];
    let done = meniscus(&fit);
    assert_eq!(done.code, 0, "{}", done.stderr);
    assert!(done.stderr.contains("the standard errors of y are those of its column sigma_y"), "{}", done.stderr);
    // The same as when they are named.
    let named = meniscus(&[&fit[..], &["--error", "y=sigma_y"]].concat());
    assert_eq!(named.stdout, done.stdout);
    let json: serde_json::Value = serde_json::from_str(&done.stdout).expect("JSON");
    // The scale is known to 0.7 pixels of 100; the start, a length, has at least that error, and the period has none of it.
    let [scale, start] = [&json["film_scales"][0], &json["parameters"]["y_0"]];
    let number = |of: &serde_json::Value, key: &str| of[key].as_f64().expect("a number");
    assert!((number(scale, "prior_stderr") - 0.5 * 2.0_f64.sqrt() / 100.0).abs() < 1e-9, "{scale}");
    assert!((number(scale, "value") - 1.0).abs() < 0.01, "{scale}");
    let relative = number(start, "stderr_hac") / number(start, "value").abs();
    assert!((0.007..0.02).contains(&relative), "{start}");
    let text = meniscus(&fit[..fit.len() - 2]).stdout;
    assert!(text.contains("Scale of the film 1.00"), "{text}");
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
    assert!(done.stderr.contains("lost from frame 61 on (counted from 1; 2.000 s of the film)"), "{}", done.stderr);
    assert!(done.stderr.contains("later frames have no row"), "{}", done.stderr);
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
fn fixed_marks_correct_for_a_camera_that_moves() {
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
    // Without marks the background shows the motion, less exactly, and that is said.
    for (words, most, says) in [(&["--marks", "20,20 140,25 25,100 135,95"][..], 0.08, false), (&[], 0.4, true)] {
        let done = track(&film, &[&["--surface", "50,42"], words].concat());
        let rows = numbers(&done.stdout);
        assert_eq!(rows.len(), 60);
        let rms = deviation(&rows, 1, 2, height).0;
        assert!(rms < most, "{words:?}: {rms}");
        assert_eq!(done.stderr.contains("the picture moved by up to "), says, "{}", done.stderr);
    }
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
    assert_eq!(json["settings"]["surfaces"][0]["position"][1], 42.0);
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
    let cases: [(&Path, &[&str], &str); 25] = [
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
        (
            &film,
            &["--surface", "50,42", "--surface", "110,78", "--tube", "50,1,50,119"],
            "--tube and --surface differ in number: 1 and 2",
        ),
        (&film, &["--surface", "50,42", "--scale", "1,1,2,1=1 [cm]"], "too close together"),
        (&film, &["--surface", "50,42", "--rate", "0"], "--rate 0 is not possible"),
        (&film, &["--surface", "50,42", "--from", "10"], "no frame lies between"),
        (&flat, &["--body", "20,20"], "uniform"),
        (&flat, &["--surface", "50,42", "--marks", "20,20 100,90"], "uniform at mark 1"),
        (&film, &["--surface", "80,60"], "The clicked place in frame 1 does not stand out of the noise"),
        (&film, &["--surface", "50,42", "--surface", "50,42"], "--surface: 50,42 is given twice"),
        (&film, &["--surface", "50,42", "--marks", "9,9 70,9 9,9"], "--marks: 9,9 is given twice"),
        (&film, &["--surface", "50,42", "--tube", "110,1,110,119"], "is 60 pixels from the axis of its tube"),
        (&film, &["--body", "50,42,61"], "radius 61 does not fit into the picture, which is 160 pixels wide"),
        (
            &film,
            &["--surface", "50,42", "--output", "tubes.docx"],
            "--output tubes.docx: the ending is none of a table",
        ),
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

#[test]
fn quantities_that_make_no_sense_are_refused() {
    let (_folder, film) = tubes_film();
    let cases: [(&[&str], &[&str]); 26] = [
        (&["--from", "1 [kg]"], &["--from 1 [kg]: kg is not a unit of time", "such as --from 1.5"]),
        (&["--until", "1 [m/s]"], &["--until 1 [m/s]: m/s is not a unit of time"]),
        (&["--from", "-1"], &["--from -1 lies before the first frame", "a film begins at 0 s", "leave --from out"]),
        (&["--until", "-500 [ms]"], &["--until -500 [ms] lies before the first frame"]),
        (&["--until", "inf"], &["--until inf is not a finite number", "leave --until out"]),
        (&["--from", "NaN"], &["--from NaN is not a finite number"]),
        (&["--from", "1", "--until", "1"], &["--until 1 is not after --from 1: nothing lies between them"]),
        (&["--from", "2 [s]", "--until", "1900 [ms]"], &["--until 1900 [ms] is not after --from 2 [s]"]),
        (&["--exposure", "1 [kg]"], &["--exposure", "kg is not a unit of time: write auto, or a time"]),
        (&["--exposure", "-0.01"], &["no exposure is negative: write auto"]),
        (&["--exposure", "inf"], &["inf is not a finite number"]),
        (&["--readout", "NaN"], &["NaN is not a finite number"]),
        (&["--readout", "20 [mm]"], &["mm is not a unit of time"]),
        (&["--exposure", "0.04"], &["--exposure is 40.0 ms, and a frame lasts 33.3 ms", "such as '16.7 [ms]'"]),
        (&["--readout", "-0.04"], &["--readout is −40.0 ms"]),
        (&["--exposure", "0.03", "--rate", "8"], &["a frame lasts 4.2 ms"]),
        (&["--readout", "60"], &["no camera takes 10 s or more for a frame"]),
        (&["--rate", "-8"], &["--rate -8 is not possible: the factor is greater than zero and finite", "such as 8"]),
        (&["--rate", "inf"], &["--rate inf is not possible"]),
        (&["--rate", "8 [s]"], &["write a number without a unit, such as 8"]),
        (&["--scale", "10,10,110,10=20"], &["the distance 20 has no unit: write two marks and their distance"]),
        (&["--scale", "10,10,110,10=20,5 [cm]"], &["`20,5` has a comma; write 20.5"]),
        (&["--scale", "10,10,110,10=20 [s]"], &["s is not a unit of length"]),
        (&["--scale", "10,10,110,10=-20 [cm]"], &["greater than zero, not -20 cm"]),
        (&["--scale", "10,10,110,10=inf"], &["inf is not a finite number"]),
        (&["--scale", "10,10,110=20 [cm]"], &["10,10,110 is not two points"]),
    ];
    for (words, expected) in cases {
        let done = track(&film, &[&["--surface", "50,42"], words].concat());
        assert_eq!((done.code, done.stdout.as_str()), (2, ""), "{words:?}");
        for part in expected {
            assert!(done.stderr.contains(part), "{words:?} lacks «{part}»:\n{}", done.stderr);
        }
    }
    let spanish = track(&film, &["--surface", "50,42", "--from", "-1", "--language", "es"]);
    assert!(spanish.stderr.contains("un vídeo empieza en 0 s"), "{}", spanish.stderr);
}

#[test]
fn a_table_in_pixels_is_no_table_of_lengths() {
    let (folder, film) = tubes_film();
    let table = folder.path().join("tubes.csv");
    tracked(&film, &["--surface", "50,42", "--output", word(&table)]);
    let fit = ["fit", "simulations/theories/linear.md", word(&table), "--observe", "y"];
    let done = meniscus(&fit);
    assert_ne!(done.code, 0);
    assert!(done.stderr.contains("column y is in px, and what is observed is in m"), "{}", done.stderr);
    assert!(done.stderr.contains("give the film a scale: two points of its ruler"), "{}", done.stderr);
    // Stated as if a pixel were a millimetre.
    let done = meniscus(&[&fit[..], &["--unit", "y=mm", "--unit", "sigma_y=mm"]].concat());
    assert_eq!(done.code, 0, "{}", done.stderr);
    // A period needs no scale.
    let done = meniscus(&["cycles", word(&table)]);
    assert!(done.code == 0 && done.stdout.contains("px"), "{} {}", done.stdout, done.stderr);
}

#[test]
fn a_workbook_holds_the_table_and_is_fitted() {
    let (folder, film) = tubes_film();
    let workbook = folder.path().join("tubes.xlsx");
    let words =
        ["--surface", "50,42", "--scale", "10,10,110,10=20 [cm]", "--origin", "0,60", "--output", word(&workbook)];
    assert_eq!(track(&film, &words).code, 0);
    let fit = ["fit", "simulations/theories/linear.md", word(&workbook), "--observe", "y"];
    let done = meniscus(&fit);
    assert_eq!(done.code, 0, "{}", done.stderr);
    assert!(
        done.stdout.contains("Scale of the film 1.00") && done.stderr.contains("column sigma_y"),
        "{}",
        done.stdout
    );
}
