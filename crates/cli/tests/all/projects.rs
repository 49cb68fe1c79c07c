//! Projects of Tracker as measured data, and in place of a film.

use crate::common::{meniscus, numbers};
use analysis::spreadsheet::Archive;
use std::path::Path;

/// Three frames at a constant step.
const STEADY: &str = include_str!("../../../analysis/tests/tracker/pixels.trk");
const PROJECT: &str = include_str!("../../../analysis/tests/tracker/moving.trk");

fn written(path: &Path, bytes: &[u8]) -> String {
    std::fs::write(path, bytes).expect("it can be written");
    path.to_str().expect("UTF-8").to_owned()
}

#[test]
fn a_project_is_read_like_any_table() {
    let directory = tempfile::tempdir().expect("a directory");
    let project = STEADY.replace("scale\" type=\"double\">1.0", "scale\" type=\"double\">10.0");
    let mut archive = Archive::default();
    archive.add("a.trk", project.as_bytes());
    let plain = written(&directory.path().join("a.trk"), project.as_bytes());
    let packed = written(&directory.path().join("a.trz"), &archive.finish());
    for file in [plain, packed] {
        let done = meniscus(&["derivatives", &file, "--observe", "y"]);
        assert_eq!(done.code, 0, "{}", done.stderr);
        // 10 px, 20 px and 25 px above the origin, in metres, at 33.3 ms.
        let positions: Vec<f64> = numbers(&done.stdout).iter().map(|row| row[1]).collect();
        assert_eq!(positions, [1.0, 2.0, 2.5]);
        assert!(done.stderr.contains("constant step of 33.333333 ms"), "{}", done.stderr);
    }
}

#[test]
fn a_project_in_place_of_a_film_names_its_film() {
    let directory = tempfile::tempdir().expect("a directory");
    let track = |file: &str| {
        let done = meniscus(&["track", file, "--body", "10,10"]);
        assert_ne!(done.code, 0);
        done.stderr
    };
    let plain = written(&directory.path().join("a.trk"), PROJECT.as_bytes());
    assert!(track(&plain).contains("its film is `videos/fall & rise.mp4`"), "{}", track(&plain));
    std::fs::create_dir(directory.path().join("videos")).expect("a folder");
    written(&directory.path().join("videos/fall & rise.mp4"), b"");
    assert!(track(&plain).contains("its film is beside it"), "{}", track(&plain));
    let mut archive = Archive::default();
    archive.add("a.trk", PROJECT.as_bytes());
    archive.add("videos/fall & rise.mp4", b"film");
    let packed = written(&directory.path().join("a.trz"), &archive.finish());
    assert!(track(&packed).contains("extract it"), "{}", track(&packed));
}

#[test]
fn a_project_without_a_film_or_with_pictures_is_not_sent_to_a_film() {
    let directory = tempfile::tempdir().expect("a directory");
    let track = |name: &str, text: &str| {
        let file = written(&directory.path().join(name), text.as_bytes());
        let done = meniscus(&["track", &file, "--body", "10,10"]);
        assert_eq!((done.code, done.stdout.as_str()), (2, ""));
        done.stderr
    };
    let pictures = track("pictures.trk", STEADY);
    assert!(
        pictures.contains("it names pictures, `videos/a00.jpg`, and no film that can be tracked here"),
        "{pictures}"
    );
    assert!(pictures.contains("read its positions"), "{pictures}");
    let begin = STEADY.find("        <property name=\"video\"").expect("a film");
    let end = STEADY.find("        <property name=\"startframe\"").expect("a clip");
    let none = track("none.trk", &format!("{}{}", &STEADY[..begin], &STEADY[end..]));
    assert!(none.contains("it names no film"), "{none}");
    let tabs = "<object class=\"org.opensourcephysics.cabrillo.tracker.TFrame\"><property name=\"tabs\"><property name=\"[0]\">\
                <property name=\"[0]\">/lab/a.trk</property><property name=\"[1]\">a.trk</property></property></property></object>";
    let tabs = track("tabs.trk", tabs);
    assert!(tabs.contains("a set of tabs of Tracker, and not a project; it names a.trk"), "{tabs}");
    assert!(tabs.contains("open them one by one"), "{tabs}");
}

#[test]
fn numbers_of_frames_are_not_taken_for_seconds() {
    let directory = tempfile::tempdir().expect("a directory");
    let project = STEADY.replace("name=\"delta_t\"", "name=\"other\"");
    let file = written(&directory.path().join("a.trk"), project.as_bytes());
    let done = meniscus(&["cycles", &file, "--observe", "y"]);
    assert_eq!(done.code, 2);
    assert!(done.stderr.contains("`frames`, the unit of frame, is not a known unit"), "{}", done.stderr);
}
