//! Projects of Tracker with their film in the archive: the film opens with what the project says of it.

use super::scene::{HEIGHT, RATE, container, identity};
use super::{columns, laboratory};
use desk::{Desk, FilmOpening, FilmedBody, LengthsForm, Refusal, Subject};
use packed::checksum;

/// An archive of files as they are (APPNOTE.TXT 6.3.3).
fn archive(files: &[(&str, &[u8])]) -> Vec<u8> {
    let (mut bytes, mut directory) = (Vec::new(), Vec::new());
    for (name, content) in files {
        let header = bytes.len() as u32;
        let mut common = vec![20, 0, 0, 0, 0, 0, 0, 0, 0, 0];
        common.extend(checksum(content).to_le_bytes());
        for size in [content.len() as u32; 2] {
            common.extend(size.to_le_bytes());
        }
        common.extend((name.len() as u16).to_le_bytes());
        common.extend([0, 0]);
        bytes.extend([b"PK\x03\x04".as_slice(), &common, name.as_bytes(), content].concat());
        directory.extend(
            [b"PK\x01\x02\x14\0".as_slice(), &common, &[0; 10], &header.to_le_bytes(), name.as_bytes()].concat(),
        );
    }
    let start = bytes.len() as u32;
    bytes.extend(&directory);
    bytes.extend(b"PK\x05\x06\0\0\0\0");
    bytes.extend([files.len() as u16; 2].map(u16::to_le_bytes).concat());
    bytes.extend([directory.len() as u32, start].map(u32::to_le_bytes).concat());
    bytes.extend([0, 0]);
    bytes
}

/// A project of Tracker: frames of 33 ms, 1000 px/m, the origin at (20; 200), and masses with positions in frames 1 to 20.
fn project(masses: usize, edit: impl Fn(String) -> String) -> Vec<u8> {
    let property =
        |name: &str, kind: &str, value: &str| format!("<property name=\"{name}\" type=\"{kind}\">{value}</property>");
    let object =
        |class: &str, inside: String| format!("<object class=\"org.opensourcephysics.{class}\">{inside}</object>");
    let mark = |frame: usize, x: f64, y: f64| {
        let place = property("x", "double", &x.to_string()) + &property("y", "double", &y.to_string());
        property(&format!("[{frame}]"), "object", &object("cabrillo.tracker.PointMass$FrameData", place))
    };
    let mass = |number: usize| {
        let marks: String = (1..=20)
            .map(|frame| mark(frame, 20.0 + frame as f64, 200.0 - 5.0 * number as f64 * frame as f64 / 4.0))
            .collect();
        let keys = property("keyFrames", "array", &property("array", "string", "{1,8}"));
        let own =
            property("name", "string", &format!("mass {number}")) + &keys + &property("framedata", "array", &marks);
        property("item", "object", &object("cabrillo.tracker.PointMass", own))
    };
    let video = object("media.xuggle.XuggleVideo", property("path", "string", "videos/swing.mp4"));
    let clip = property("video", "object", &video)
        + &[("startframe", 1), ("stepsize", 1), ("stepcount", 20)]
            .map(|(name, value)| property(name, "int", &value.to_string()))
            .concat();
    let axes = [("xorigin", 20.0), ("yorigin", 200.0), ("angle", 0.0), ("xscale", 1000.0), ("yscale", 1000.0)];
    let axes = axes.map(|(name, value)| property(name, "double", &format!("{value:?}"))).concat();
    let coordinates =
        ["fixedorigin", "fixedangle", "fixedscale"].map(|name| property(name, "boolean", "true")).concat()
            + &property(
                "framedata",
                "array",
                &property("[0]", "object", &object("media.core.ImageCoordSystem$FrameData", axes)),
            );
    let text = object(
        "cabrillo.tracker.TrackerPanel",
        [
            property("videoclip", "object", &object("media.core.VideoClip", clip)),
            property(
                "clipcontrol",
                "object",
                &object("media.core.StepperClipControl", property("delta_t", "double", "33.0")),
            ),
            property("coords", "object", &object("media.core.ImageCoordSystem", coordinates)),
            property("length_unit", "string", "m"),
            property("tracks", "collection", &(1..=masses).map(mass).collect::<String>()),
        ]
        .concat(),
    );
    edit(text).into_bytes()
}

fn packed(masses: usize, edit: impl Fn(String) -> String) -> Vec<u8> {
    archive(&[("swing.trk", &project(masses, edit)), ("videos/swing.mp4", b"the bytes of a film")])
}

/// A laboratory with the record of a project, and what opening its film gives.
fn opened(masses: usize, edit: impl Fn(String) -> String) -> (Desk, Result<FilmOpening, Refusal>) {
    let mut desk = laboratory();
    let bytes = packed(masses, edit);
    desk.add_record("swing.trz", &bytes).unwrap();
    let film = desk.change_films(|films, _| films.take_project_film()).expect("its film is in the archive");
    assert_eq!(desk.change_films(|films, _| films.take_project_film()), None, "it is given once");
    assert_eq!((film.name(), film.is_deflated(), film.size()), ("swing.mp4", false, 19));
    let range = film.range().start as usize..film.range().end as usize;
    assert_eq!(&bytes[range], b"the bytes of a film");
    let opening = desk.open_project_film(&film, identity("swing.mp4"), container(40));
    (desk, opening)
}

#[test]
fn the_film_has_positions_scale_and_part_of_the_project_and_its_own_times() {
    let (desk, opening) = opened(1, |text| text);
    assert_eq!(opening, Ok(FilmOpening::New));
    assert_eq!(desk.records().list().len(), 1, "it is the record of the project");
    assert_eq!(desk.records().list()[0].name, "swing.trz");
    let columns = columns(&desk);
    assert_eq!(columns[0].len(), 20);
    for (row, frame) in (1..=20).enumerate() {
        let frame = f64::from(frame);
        // 30 frames a second, as the film has them, and not 33 ms; metres from the origin of the project.
        for (column, truth) in [(0, frame / RATE), (1, 1e-3 * frame), (2, 1.25e-3 * frame)] {
            assert!(
                (columns[column][row] - truth).abs() < 1e-5 + 1e-3 * truth,
                "{row} {column}: {}",
                columns[column][row]
            );
        }
    }
    let film = desk.films().current().expect("it is open");
    let Subject::Points { clicks, .. } = film.subject() else { panic!("{:?}", film.subject()) };
    assert_eq!((clicks.len(), clicks[0].frame, clicks[19].position), (20, 1, [40.0, 175.0]));
    assert_eq!((film.ends(), film.factor()), ([1, 20], 1.0));
    // The scale is shown as a round length that fits into the picture. Its error is that of two marks.
    let LengthsForm::Ruler { marks: [[left, y], [right, _]], length, .. } = &film.calibration_form().lengths else {
        panic!("{:?}", film.calibration_form())
    };
    assert_eq!((length.as_str(), right - left), ("0.1 m", 100.0));
    assert!(*left > 0.0 && *y < HEIGHT as f64);
    let said = "Times are those of the frames of its film, and not the constant step of 33 ms of the project.";
    assert!(desk.films().notes().iter().any(|note| note == said), "{:?}", desk.films().notes());
    let findings = &desk.records().list()[0].findings;
    assert!(findings.iter().any(|finding| finding == said), "{findings:?}");
    assert!(findings.iter().any(|finding| finding.contains("2 of 20 positions are key frames")), "{findings:?}");
    assert!(!findings.iter().any(|finding| finding.contains("meniscus track")), "{findings:?}");
}

#[test]
fn a_project_without_a_duration_gets_the_times_of_its_film() {
    let untimed = |text: String| text.replace("delta_t", "other_t");
    let mut desk = laboratory();
    desk.add_record("swing.trz", &packed(1, untimed)).unwrap();
    let assumed = |desk: &Desk| {
        desk.records().list()[0].findings.iter().any(|finding| finding.contains("no duration is assumed"))
    };
    assert!(assumed(&desk), "{:?}", desk.records().list()[0].findings);
    let film = desk.change_films(|films, _| films.take_project_film()).expect("its film is in the archive");
    assert_eq!(desk.open_project_film(&film, identity("swing.mp4"), container(40)), Ok(FilmOpening::New));
    assert!(
        (columns(&desk)[0][0] - 1.0 / RATE).abs() < 1e-5 && !assumed(&desk),
        "{:?}",
        desk.records().list()[0].findings
    );
    assert_eq!(desk.films().current().expect("it is open").factor(), 1.0);
    let said = "Times are those of the frames of its film.";
    assert!(
        desk.records().list()[0].findings.iter().any(|finding| finding == said),
        "{:?}",
        desk.records().list()[0].findings
    );
}

#[test]
fn several_masses_are_bodies_with_key_frames() {
    let (desk, opening) = opened(2, |text| text);
    assert_eq!(opening, Ok(FilmOpening::New));
    let film = desk.films().current().expect("it is open");
    let Subject::Bodies(bodies) = film.subject() else { panic!("{:?}", film.subject()) };
    let frames = |body: &FilmedBody| body.keys.iter().map(|key| key.frame).collect::<Vec<_>>();
    assert_eq!(bodies.iter().map(frames).collect::<Vec<_>>(), [[1, 8], [1, 8]]);
    // The tracks of Tracker are available before any tracking here.
    assert_eq!(film.tracks().iter().map(|track| track.points.len()).collect::<Vec<_>>(), [20, 20]);
    let columns = columns(&desk);
    assert!((columns[0][3] - 4.0 / RATE).abs() < 1e-4 && columns.len() == 9, "{}", columns.len());
}

#[test]
fn a_stated_slow_motion_is_taken_and_known_work_is_kept() {
    // Played at 30 frames/s, taken at 240.
    let slow = |text: String| text.replace("33.0", "4.1666667");
    let (mut desk, opening) = opened(1, slow);
    assert_eq!(opening, Ok(FilmOpening::New));
    assert!((desk.films().current().expect("it is open").factor() - 8.0).abs() < 1e-6);
    assert!((columns(&desk)[0][0] - 1.0 / 240.0).abs() < 1e-5);
    // A film that comes with another project keeps the work done on it.
    desk.add_record("again.trz", &packed(1, |text| text)).unwrap();
    let film = desk.change_films(|films, _| films.take_project_film()).expect("its film is in the archive");
    assert_eq!(desk.open_project_film(&film, identity("swing.mp4"), container(40)), Ok(FilmOpening::TakenUp));
    assert!((desk.films().current().expect("it is open").factor() - 8.0).abs() < 1e-6);
    assert_eq!(desk.records().list().len(), 2);
}

#[test]
fn what_a_film_cannot_have_leaves_the_record_as_it_is() {
    type Edit = fn(String) -> String;
    let cases: [(Edit, &str); 5] = [
        (|text| text.replace("\"yscale\" type=\"double\">1000", "\"yscale\" type=\"double\">900"), "along the columns"),
        (
            |text| text.replace("\"xorigin\" type=\"double\">20", "\"xorigin\" type=\"double\">-20"),
            "origin lies outside",
        ),
        (
            |text| {
                text.replace(
                    "<property name=\"length_unit\" type=\"string\">m",
                    "<property name=\"length_unit\" type=\"string\">kg",
                )
            },
            "kg",
        ),
        (|text| text.replace("type=\"double\">40<", "type=\"double\">400<"), "outside the picture"),
        (
            |text| {
                text.replace("</object></property><property name=\"startframe\"", "<property name=\"filters\" type=\"collection\"><property name=\"item\" type=\"object\"><object class=\"org.opensourcephysics.media.core.RotateFilter\"></object></property></property></object></property><property name=\"startframe\"")
            },
            "RotateFilter",
        ),
    ];
    for (edit, expected) in cases {
        let (desk, opening) = opened(1, edit);
        let why = opening.expect_err(expected).text(desk.play());
        assert!(why.contains(expected), "{why} lacks {expected}");
        assert!(desk.films().current().is_none(), "{expected}");
        assert_eq!(columns(&desk)[0][1], 0.033, "{expected}: the step of the project");
    }
    let (desk, opening) = opened(5, |text| text);
    assert!(opening.expect_err("five").text(desk.play()).contains("5 masses"));
    // A project by itself has no film.
    let mut desk = laboratory();
    desk.add_record("swing.trk", &project(1, |text| text)).unwrap();
    assert_eq!(desk.change_films(|films, _| films.take_project_film()), None);
}
