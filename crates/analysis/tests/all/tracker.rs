//! Projects of Tracker: times, coordinates and masses, and limits for hostile files.

use crate::support::packed::{Pack, archive};
use analysis::import;
use analysis::reading::{self, Contents, Reading, ReadingError};
use analysis::tracker::{self, TrackerError};
use proptest::prelude::*;
use units::Language::{self, English, Spanish};

const MOST: usize = 1 << 20;
pub const FIXED: &str = include_str!("../tracker/fixed.trk");
pub const MOVING: &str = include_str!("../tracker/moving.trk");
pub const PIXELS: &str = include_str!("../tracker/pixels.trk");

pub fn zip(files: &[(&str, &str)]) -> Vec<u8> {
    let files: Vec<(String, String)> = files.iter().map(|(name, text)| ((*name).into(), (*text).into())).collect();
    archive(&files, Pack::Deflated)
}

/// Columns as `label [unit]: values`, with five decimals, and the findings.
pub fn shown(contents: &Contents, language: Language) -> String {
    let table = &contents.import.table;
    let mut out = String::new();
    for (index, column) in table.columns.iter().enumerate() {
        let unit = column.unit.as_ref().map_or("", |unit| &unit.text);
        out += &format!("{} [{unit}]:", table.label(index));
        for value in &column.values {
            out += &if value.is_nan() { " ·".to_owned() } else { format!(" {:.5}", value + 0.0) };
        }
        out.push('\n');
    }
    for finding in &contents.import.findings {
        out += &format!("- {}\n", finding.text(language));
    }
    out
}

pub fn read(bytes: Vec<u8>) -> Contents {
    reading::read(bytes, MOST).expect("a project")
}

pub fn refused(text: &str) -> TrackerError {
    match reading::read(text.as_bytes().to_vec(), MOST).expect_err("no project") {
        ReadingError::Project(error) => error,
        other => panic!("{other:?}"),
    }
}

#[test]
fn positions_are_in_the_coordinates_of_the_project() {
    // Origin (320; 240), 200 px/cm, x axis at 30°; frames 2, 4, 6 and 8 of 40 ms, from 0.5 s. Frame 4 of masa A is 100 px to
    // the right and 100 px above the origin: cos 30°/2 + sin 30°/2 = 0.68301.
    let expected = "\
t [s]: 0.50000 0.58000 0.66000
masa A.x [cm]: 0.43301 0.68301 0.50000
masa A.y [cm]: -0.25000 0.18301 0.86603
2.x [cm]: · 0.00000 ·
2.y [cm]: · 0.00000 ·
- times are the frame number times a constant step of 40 ms, as the project states; the film, `videos/fall & rise.mp4`, has a time for each frame, which is better: track it, in the tab Measure of the page or with `meniscus track`
- the scale of the project is 200 px/cm; the origin is at the pixel (320.0; 240.0), the x axis at 30.00°; the project states no error of the scale, and errors of lengths in fits do not include it
- Tracker shows positions relative to 2; those here are relative to the axes
- masa A: 2 of 5 positions are key frames, marked by hand or confirmed; the autotracker found the others, or they were interpolated (autofill)
- positions outside the clip that the project selects were left out: 2
- models were not read: model A, model <B>
- RGB regions were not read: light
- the project filters its film (PerspectiveFilter); positions belong to the filtered pictures
";
    assert_eq!(shown(&read(FIXED.into()), English), expected);
}

#[test]
fn axes_that_move_and_times_that_are_listed_are_followed() {
    // From frame 3 on the origin is 10 px to the right and the scale 50 px/m along the rows; frame 2 is not marked.
    let expected = "\
t [s]: 0.00000 0.06670 0.11670 0.15000
x [m]: 0.10000 0.40000 0.60000 0.80000
y [m]: 0.20000 0.60000 0.80000 1.00000
- los tiempos son los que el proyecto enumera para los fotogramas de su vídeo
- la escala del proyecto es 100 px/m; el origen está en el píxel (100,0; 200,0) y el eje x a 0,00° en el primer fotograma; cambian de un fotograma a otro, lo que se tiene en cuenta; el proyecto no indica el error de la escala, y los errores de las longitudes en los ajustes no lo incluyen
- el proyecto no indica la unidad de longitud: se suponen metros, como hace Tracker
- se dejaron fuera las posiciones ajenas al corte que elige el proyecto: 1
";
    assert_eq!(shown(&read(MOVING.into()), Spanish), expected);
    // The project states 300 frames/s for a film whose file says 26.7.
    let slow = MOVING.replace("\"double\">37.5<", "\"double\">3.75<");
    let slow = shown(&read(slow.into()), English);
    assert!(
        slow.starts_with("t [s]: 0.00000 0.00667 0.01167 0.01500\n") && slow.contains("multiplied by 0.1,"),
        "{slow}"
    );
    // Decreasing times are not used.
    let still = shown(&read(MOVING.replace("66.7,100.0,150.0,183.3", "0.0,0.0,0.0,0.0").into()), English);
    assert!(still.starts_with("t [s]: 0.00000 0.07500 0.11250 0.15000\n") && still.contains("37.5 ms"), "{still}");
}

#[test]
fn without_a_scale_positions_are_in_pixels() {
    let expected = "\
t [s]: 0.00000 0.03333 0.06667
x [px]: 1.00000 2.00000 3.00000
y [px]: 10.00000 20.00000 25.00000
- times are the frame number times a constant step of 33.333333 ms, as the project states
- the project has no scale: positions are in pixels, y upwards; the origin is at the pixel (10.0; 100.0), the x axis at 0.00°
";
    assert_eq!(shown(&read(PIXELS.into()), English), expected);
}

#[test]
fn a_text_of_a_project_is_read_again_as_the_same_table() {
    for project in [FIXED, MOVING, PIXELS] {
        let contents = read(project.into());
        let again = import::text(contents.text.as_bytes()).expect("a table");
        assert_eq!(format!("{:?}", again.table), format!("{:?}", contents.import.table));
    }
}

#[test]
fn names_that_look_like_numbers_units_or_comments_name_their_masses() {
    for (name, label) in
        [("12.5", "12.5"), ("#1", "1"), ("multi:", "multi"), ("12:00:01", "12 00 01"), ("t [ms]", "t ms")]
    {
        let project = FIXED.replace(">masa A<", &format!(">{name}<"));
        let table = read(project.into()).import.table;
        assert_eq!((table.columns.len(), table.label(1)), (5, format!("{label}.x")), "{name}");
    }
}

#[test]
fn an_archive_is_read_with_its_film() {
    let film = "not really a film".repeat(10);
    let files = [
        ("__MACOSX/._a.trk", "\0\u{5}\u{16}\u{7}"),
        ("talk/a.trk", FIXED),
        ("talk/videos/other.mp4", ""),
        ("talk/videos/Fall & rise.mp4", film.as_str()),
        ("talk/html/a_info.html", "<html></html>"),
    ];
    let bytes = zip(&files);
    let opened = tracker::read(bytes.clone()).expect("a project");
    let packed = opened.project.film.and_then(|film| film.packed).expect("a film");
    assert_eq!((packed.name.as_str(), packed.deflated, packed.size), (files[3].0, true, film.len() as u64));
    let range = packed.range.start as usize..packed.range.end as usize;
    let content = miniz_oxide::inflate::decompress_to_vec(&bytes[range]).expect("the film");
    assert_eq!(content, film.as_bytes());
    let contents = read(bytes);
    assert!(shown(&contents, Spanish).contains("; el vídeo del archivo, «videos/fall & rise.mp4», tiene"));
    assert_eq!(contents.text, read(FIXED.into()).text);
    // Of several projects the first with a mass is read.
    let unmarked = FIXED.replace("tracker.PointMass\"", "tracker.Vector\"");
    let several = read(zip(&[("a.trk", &unmarked), ("b.TRK", PIXELS)]));
    assert!(shown(&several, English).contains("the first with a marked mass was read: `b.TRK`"));
    let none = reading::read(zip(&[("a.trk", &unmarked), ("b.trk", &unmarked)]), MOST);
    assert_eq!(none, Err(ReadingError::Project(TrackerError::NoMass { film: true })));
}

/// Archive as gathered from the needed bytes, and their number.
fn gathered(bytes: &[u8]) -> (Option<Contents>, usize) {
    let mut gathering = tracker::gathering(bytes.len() as u64);
    let mut taken = 0;
    while let Some(range) = gathering.wanted() {
        assert!(range.start <= range.end && range.end <= bytes.len() as u64, "{range:?}");
        let part = &bytes[range.start as usize..range.end as usize];
        taken += part.len();
        gathering.supply(part.to_vec());
    }
    let contents = Reading::of_gathered(gathering, MOST).and_then(|mut reading| {
        while !reading.advance(1000).ok()? {}
        reading.finish()
    });
    (contents, taken)
}

#[test]
fn a_large_archive_is_not_read_whole() {
    // Incompressible bytes.
    let mut noise = crate::support::Noise::new(5);
    let film: String = (0..1_000_000).map(|_| char::from(32 + (95.0 * noise.uniform()) as u8)).collect();
    for names in [["talk/a.trk", "talk/videos/Fall & rise.mp4"], ["talk/videos/Fall & rise.mp4", "talk/a.trk"]] {
        let content = |name: &str| if name.ends_with("trk") { FIXED } else { film.as_str() };
        let bytes = zip(&names.map(|name| (name, content(name))));
        let (contents, taken) = gathered(&bytes);
        let whole = read(bytes.clone());
        assert_eq!(contents.as_ref().map(|contents| format!("{contents:?}")), Some(format!("{whole:?}")));
        let packed = whole.project.and_then(|project| project.film).and_then(|film| film.packed).expect("a film");
        assert!(packed.range.end - packed.range.start > 500_000 && taken < 90_000, "{taken} of {}", bytes.len());
    }
    // Files that are not archives, or contain no project.
    for bytes in [Vec::new(), b"PK".to_vec(), FIXED.into(), zip(&[("a.txt", "t\ty\n0\t1\n1\t2\n")])] {
        assert_eq!(gathered(&bytes).0, None);
    }
}

#[test]
fn pixels_and_calibration_of_a_project_are_there_for_a_film() {
    let project = tracker::read(MOVING.into()).expect("a project").project;
    let (mass, clip) = (&project.masses[0], &project.clip);
    assert_eq!((mass.name.as_str(), mass.marks[2].frame, mass.marks[2].pixel), ("bola", 3, [130.0, 140.0]));
    assert_eq!((clip.first, clip.step, clip.count, clip.times.len()), (1, 1, 5, 6));
    assert_eq!(project.coordinates.at(2).scale, [100.0, 100.0]);
    assert_eq!(project.coordinates.at(7).origin, [110.0, 200.0]);
    assert_eq!(project.film.map(|film| (film.path, film.pictures)), Some(("videos/fall & rise.mp4".into(), false)));
}

#[test]
fn old_texts_in_latin_1_and_byte_order_marks_are_read() {
    let latin: Vec<u8> =
        PIXELS.replace("mass A", "#").bytes().map(|byte| if byte == b'#' { 0xf1 } else { byte }).collect();
    assert_eq!(tracker::read(latin).expect("a project").project.masses[0].name, "ñ");
    let marked = [b"\xef\xbb\xbf".as_slice(), PIXELS.as_bytes()].concat();
    assert_eq!(read(marked).text, read(PIXELS.into()).text);
}

#[test]
fn what_is_no_project_is_refused_with_its_reason() {
    let doctype = |text: &str| PIXELS.replace("?>\n<object", &format!("?>\n{text}\n<object"));
    // Document type that the library writes on request.
    assert_eq!(read(doctype("<!DOCTYPE object SYSTEM \"osp10.dtd\">").into()).text, read(PIXELS.into()).text);
    let bomb = doctype("<!DOCTYPE object [<!ENTITY a \"&b;&b;\">]>");
    let deep = "<property name=\"a\">".repeat(300);
    let cases = [
        (bomb, TrackerError::Entities),
        (PIXELS.replace(">mass A<", ">&name;<"), TrackerError::Entities),
        (
            PIXELS.replace("tracker.TrackerPanel", "tracker.TFrame"),
            TrackerError::NotAProject { class: "TFrame".into() },
        ),
        (PIXELS.replace("tracker.PointMass\"", "tracker.Vector\""), TrackerError::NoMass { film: false }),
        (
            PIXELS.replace("name=\"stepcount\" type=\"int\">3", "name=\"stepcount\" type=\"int\">1"),
            TrackerError::OneFrame { film: false },
        ),
        (
            PIXELS.replace("\"startframe\" type=\"int\">0", "\"startframe\" type=\"int\">9"),
            TrackerError::NoMass { film: false },
        ),
        (PIXELS.replace(">11.0<", ">1l.0<"), TrackerError::Damaged),
        (PIXELS.replace("\"[1]\"", "\"[one]\""), TrackerError::Damaged),
        (PIXELS.replace("<property name=\"red\"", "<script name=\"red\""), TrackerError::Damaged),
        (PIXELS.replace("</object>\n</object>", "</object>"), TrackerError::Damaged),
        (PIXELS.replace("<property name=\"red\"", &format!("{deep}<property name=\"red\"")), TrackerError::Damaged),
    ];
    for (text, expected) in cases {
        let text =
            if expected == TrackerError::Damaged && text == PIXELS { PIXELS[..PIXELS.len() - 12].into() } else { text };
        let error = refused(&text);
        assert_eq!(error, expected);
        assert!(!error.hint(English).is_empty() && !error.hint(Spanish).is_empty());
    }
    // The table of masses that are never marked in the same frame grows with the square of their number.
    let item = &PIXELS[PIXELS.find("        <property name=\"item\"").unwrap()
        ..PIXELS.find("    </property>\n    <property name=\"dividers\"").unwrap()];
    assert_eq!(refused(&PIXELS.replace(item, &item.repeat(300))), TrackerError::TooLarge);
    assert!(matches!(reading::read(FIXED.into(), 100), Err(ReadingError::Project(TrackerError::TooLarge))));
}

#[test]
fn archives_that_deceive_are_refused() {
    let project = |pack| archive(&[("sheets/a.trk".to_owned(), FIXED.to_owned())], pack);
    let kind = |pack| reading::read(project(pack), MOST).expect_err("refused");
    assert_eq!(kind(Pack::Understated), ReadingError::Project(TrackerError::Damaged));
    assert_eq!(kind(Pack::WrongChecksum), ReadingError::Project(TrackerError::Damaged));
    assert_eq!(kind(Pack::Encrypted), ReadingError::Project(TrackerError::Protected));
    let blanks = " ".repeat(4 << 20);
    let bomb = archive(&[("a.trk".to_owned(), blanks)], Pack::Deflated);
    assert!(matches!(reading::read(bomb, MOST), Err(ReadingError::Project(TrackerError::Expands { .. }))));
}

fn in_slices(bytes: Vec<u8>, budget: usize) -> Result<Contents, ReadingError> {
    let mut reading = Reading::new(bytes, MOST)?;
    while !reading.advance(budget)? {}
    Ok(reading.finish().expect("it came to the end"))
}

proptest! {
    #[test]
    fn slices_give_the_same_table(budget in 1_usize..5000) {
        for bytes in [FIXED.into(), zip(&[("a.trk", MOVING)])] {
            prop_assert_eq!(format!("{:?}", in_slices(bytes.clone(), budget)), format!("{:?}", reading::read(bytes, MOST)));
        }
    }

    #[test]
    fn what_is_cut_off_is_never_read_as_a_table(at in any::<prop::sample::Index>()) {
        let end = FIXED.trim_end().len();
        let bytes = FIXED.as_bytes()[..at.index(end)].to_vec();
        prop_assert!(reading::read(bytes, MOST).is_err());
        let packed = zip(&[("a.trk", FIXED)]);
        prop_assert!(reading::read(packed[..at.index(packed.len())].to_vec(), MOST).is_err());
    }

    #[test]
    fn any_change_is_read_or_refused(at in any::<prop::sample::Index>(), byte in any::<u8>()) {
        for mut bytes in [FIXED.as_bytes().to_vec(), MOVING.as_bytes().to_vec(), zip(&[("a.trk", FIXED), ("b.mp4", "")])] {
            let at = at.index(bytes.len());
            bytes[at] = byte;
            gathered(&bytes);
            if let Err(error) = reading::read(bytes, MOST) {
                prop_assert!(!error.message(Spanish).is_empty() && !error.hint(Spanish).is_empty());
            }
        }
    }

    #[test]
    fn elements_in_any_order_are_read_or_refused(parts in prop::collection::vec(prop::sample::select(vec![
        "<object class=\"org.opensourcephysics.cabrillo.tracker.TrackerPanel\">", "</object>", "</property>",
        "<property name=\"tracks\">", "<property name=\"item\">", "<object class=\"PointMass\">", "<property name=\"framedata\">",
        "<property name=\"[4294967295]\">", "<property name=\"x\">", "-1e308", "<property name=\"coords\">", "<![CDATA[{1,2}]]>",
        "<property name=\"xscale\">", "1e-308", "<property name=\"clipcontrol\">", "<property name=\"delta_t\">", "NaN",
        "<property name=\"stepcount\">", "-2147483648", "&#1;", "&amp;", "<!--", "-->",
    ]), 0..60)) {
        let text = format!("<object class=\"org.opensourcephysics.cabrillo.tracker.TrackerPanel\">{}", parts.concat());
        let _ = reading::read(text.into_bytes(), MOST);
    }

    #[test]
    fn a_text_of_any_numbers_is_read_again(
        marks in prop::collection::btree_map(0_u32..50, (any::<f64>(), any::<f64>()), 2..20),
        (scale, angle) in (1.0_f64..1e4, -180.0_f64..180.0),
    ) {
        let frames: String = marks.iter().map(|(frame, (x, y))| format!(
            "<property name=\"[{frame}]\"><object class=\"F\"><property name=\"x\">{x:?}</property><property name=\"y\">{y:?}</property></object></property>"
        )).collect();
        let item = &PIXELS[PIXELS.find("                <property name=\"[0]\" type=\"object\">\n                <object class=\"org.opensourcephysics.cabrillo").unwrap()
            ..PIXELS.find("            </property>\n        </object>\n        </property>\n    </property>").unwrap()];
        let text = PIXELS.replace(item, &frames)
            .replace("\"int\">3<", "\"int\">50<")
            .replace("xscale\" type=\"double\">1.0", &format!("xscale\" type=\"double\">{scale:?}"))
            .replace("angle\" type=\"double\">0.0", &format!("angle\" type=\"double\">{angle:?}"));
        let contents = read(text.into_bytes());
        prop_assert_eq!(contents.import.table.rows(), marks.len());
    }
}
