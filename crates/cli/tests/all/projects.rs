//! Projects of Tracker as measured data, and in place of a film.

use crate::common::{meniscus, numbers};
use analysis::spreadsheet::Archive;
use std::path::Path;

const PROJECT: &str = include_str!("../../../analysis/tests/tracker/moving.trk");

fn written(path: &Path, bytes: &[u8]) -> String {
    std::fs::write(path, bytes).expect("it can be written");
    path.to_str().expect("UTF-8").to_owned()
}

#[test]
fn a_project_is_read_like_any_table() {
    let directory = tempfile::tempdir().expect("a directory");
    let mut archive = Archive::default();
    archive.add("a.trk", PROJECT.as_bytes());
    let plain = written(&directory.path().join("a.trk"), PROJECT.as_bytes());
    let packed = written(&directory.path().join("a.trz"), &archive.finish());
    for file in [plain, packed] {
        let done = meniscus(&["derivatives", &file, "--observe", "y"]);
        assert_eq!(done.code, 0, "{}", done.stderr);
        let times: Vec<f64> = numbers(&done.stdout).iter().map(|row| row[0]).collect();
        assert_eq!(times, [0.0, 0.0667, 0.1167, 0.15]);
        assert!(done.stderr.contains("metres are assumed"), "{}", done.stderr);
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
