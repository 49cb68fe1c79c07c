//! Reports of films without a fit.

use super::scenes::{HEIGHT, WIDTH, ball, y4m};
use super::{folder_with, track, tubes_film};
use crate::common::names;
use crate::fit::word;

/// The points of the lines of a colour, in units of the drawing, for each drawing of a page.
fn lines(page: &str, colour: &str) -> Vec<Vec<Vec<[f64; 2]>>> {
    let drawing = |svg: &str| {
        let group = svg.split("<g ").find(|group| group.contains(&format!("stroke=\"{colour}\""))).unwrap_or_default();
        let line = |points: &str| {
            let points = points.split('"').next().unwrap_or_default().split(' ').filter(|point| !point.is_empty());
            let number = |text: &str| text.parse::<f64>().expect("a number");
            points.filter_map(|point| point.split_once(',')).map(|(x, y)| [number(x), number(y)]).collect()
        };
        group.split("<polyline points=\"").skip(1).map(line).collect()
    };
    page.split("<svg ").skip(1).map(drawing).collect()
}

#[test]
fn a_report_shows_the_frame_with_its_marks_and_the_space_time_picture() {
    let (folder, film) = tubes_film();
    let [page, table] = ["report.html", "table.csv"].map(|name| folder.path().join(name));
    let words = [
        "--surface",
        "50,42",
        "--surface",
        "110,78",
        "--scale",
        "10,10,110,10=20 [cm]",
        "--origin",
        "0,60",
        "--output",
        word(&table),
        "--report",
        word(&page),
    ];
    let done = track(&film, &words);
    assert_eq!(done.code, 0, "{}", done.stderr);
    assert!(table.is_file());
    let html = std::fs::read_to_string(&page).expect("a report");
    // The tracked points are in the page, and its table is computed from them again.
    let verified = crate::common::meniscus(&["verify", word(&page)]);
    assert!(verified.code == 0 && verified.stdout.contains("all equal"), "{}{}", verified.stdout, verified.stderr);
    let moved = html.replacen("<h1>", "<h1>1", 1);
    std::fs::write(&page, moved).expect("a changed report");
    let verified = crate::common::meniscus(&["verify", word(&page)]);
    assert!(verified.code == 1 && verified.stdout.contains("report \""), "{}", verified.stdout);
    for part in [
        "<h1>tubes.y4m</h1>",
        "160 × 120 px",
        "90, 30 /s, 2.967 s",
        "20 cm",
        "Frame 1.",
        "Scale: a pixel is 2 mm",
        "30.00 frames/s",
        "The strip along the tube from every frame",
        "meniscus track ",
        "data:image/png;base64,",
    ] {
        assert!(html.contains(part), "lacks «{part}»");
    }
    assert!(!html.contains("<script") && !html.contains("Red:"), "no script, no fit");
    // The frame, then the strip of each tube. In the frame, 640 wide for 160 pixels: both tracks, the ruler, the origin.
    let (tracked, marks) = (lines(&html, "#ffb000"), lines(&html, "#648fff"));
    assert_eq!(tracked.iter().map(Vec::len).collect::<Vec<_>>(), [2, 1, 1]);
    assert!(tracked.iter().flatten().all(|line| line.len() == 90), "a point for each frame");
    let near = |one: [f64; 2], other: [f64; 2]| libm::hypot(one[0] - other[0], one[1] - other[1]) < 8.0;
    assert!(near(tracked[0][0][0], [200.0, 168.0]) && near(tracked[0][1][0], [440.0, 312.0]), "{:?}", tracked[0][0][0]);
    assert_eq!(marks[0], [vec![[40.0, 40.0], [440.0, 40.0]], vec![[0.0, 240.0]]]);
    // Time to the right, and the second arm is down where the first is up.
    let ends = |line: &Vec<[f64; 2]>| [line[0][0], line[89][0]];
    assert_eq!(ends(&tracked[1][0]), [4.0, 716.0]);
    assert!(tracked[1][0][0][1] < tracked[2][0][0][1], "{:?} {:?}", tracked[1][0][0], tracked[2][0][0]);
    let spanish = track(&film, &[&words[..], &["--language", "es"]].concat());
    assert_eq!(spanish.code, 0, "{}", spanish.stderr);
    let html = std::fs::read_to_string(&page).expect("a report");
    assert!(html.contains("lang=\"es\"") && html.contains("90, 30 /s, 2,967 s") && html.contains("Para repetirlo"));
}

#[test]
fn several_films_get_a_report_each() {
    let (folder, film) = folder_with("ball.y4m", &y4m([WIDTH, HEIGHT], 40, ball));
    let second = folder.path().join("again.y4m");
    std::fs::copy(&film, &second).expect("a copy");
    let reports = folder.path().join("reports");
    let words = [word(&second), "--body", "30,100", "--report", word(&reports)];
    let done = track(&film, &words);
    assert!(
        done.code == 2 && done.stderr.contains("--report") && done.stderr.contains("no such folder"),
        "{}",
        done.stderr
    );
    std::fs::create_dir(&reports).expect("a folder");
    assert_eq!(track(&film, &words).code, 0);
    assert_eq!(names(&reports), ["again.y4m.html", "ball.y4m.html"]);
    // A body has no tube; its path is in the frame.
    let html = std::fs::read_to_string(reports.join("ball.y4m.html")).expect("a report");
    assert_eq!(lines(&html, "#ffb000").iter().map(Vec::len).collect::<Vec<_>>(), [1]);
}

#[test]
fn a_report_that_would_replace_something_else_is_refused() {
    let (folder, film) = tubes_film();
    let page = folder.path().join("report.html");
    let cases: [(&[&str], &str); 2] = [
        (&["--report", "report.pdf"], "a report is an HTML page"),
        (&["--report", word(&page), "--output", word(&page), "--format", "csv"], "name one file"),
    ];
    for (words, expected) in cases {
        let done = track(&film, &[&["--surface", "50,42"], words].concat());
        assert!(done.code == 2 && done.stderr.contains(expected), "{words:?}: {}", done.stderr);
    }
    assert_eq!(names(folder.path()), ["tubes.y4m"]);
}
