//! Archives of data sets as written by phyphox, with known true values.

use crate::support::Noise;
use crate::support::old_workbook::{Cell, OldWorkbook};
use crate::support::packed::{Pack, archive};
use analysis::data_sets::Remark;
use analysis::finding::Finding;
use analysis::reading::{self, Contents, Reading, ReadingError};
use analysis::workbook::WorkbookError;
use units::Language;

const MOST: usize = 1 << 22;
/// Separator and decimal sign.
const DIALECTS: [(&str, &str); 5] = [(",", "."), ("\t", "."), (";", "."), ("\t", ","), (";", ",")];
/// Names in the languages of phones, and the names of their columns.
const SETS: [(&str, &[&str]); 4] = [
    ("Accelerometer", &["Time (s)", "Acceleration x (m/s^2)", "Absolute (m/s^2)"]),
    ("Gyroskop", &["Zeit (s)", "'-x (rad/s)", "'+y (rad/s)"]),
    ("Magnetómetro", &["Tiempo (s)", "X (µT)", "Absoluto (µT)"]),
    ("Druck", &["Zeit (s)", "'=p (hPa)"]),
];

fn number(value: f64, sign: &str) -> String {
    if value.is_nan() { "NaN".to_owned() } else { format!("{value:.9E}").replace('.', sign) }
}

fn line<S: AsRef<str>>(cells: &[S], separator: &str) -> String {
    cells.iter().map(AsRef::as_ref).collect::<Vec<_>>().join(separator) + "\n"
}

/// Rows of a set: times with jitter, and shorter columns.
fn rows(count: usize, columns: usize, noise: &mut Noise) -> Vec<Vec<f64>> {
    let mut time = 0.01 * noise.uniform();
    let mut row = |index: usize| {
        time += 0.01 * (1.0 + 0.05 * noise.normal());
        let gap = |column: usize| column == columns - 1 && columns > 2 && index + 3 >= count;
        let value = |column: usize| if gap(column) { f64::NAN } else { noise.normal() };
        std::iter::once(time).chain((1..columns).map(value)).collect()
    };
    (0..count).map(&mut row).collect()
}

fn csv(heads: &[&str], rows: &[Vec<f64>], (separator, sign): (&str, &str)) -> String {
    let heads: Vec<String> = heads.iter().map(|head| format!("\"{head}\"")).collect();
    let rows =
        rows.iter().map(|row| line(&row.iter().map(|value| number(*value, sign)).collect::<Vec<_>>(), separator));
    line(&heads, separator) + &rows.collect::<String>()
}

/// Events with experiment time and system time.
fn events(events: &[(&str, f64, f64)], (separator, sign): (&str, &str)) -> String {
    let head = ["event", "experiment time", "system time", "system time text"].map(|head| format!("\"{head}\""));
    let event = |(name, time, system): &(&str, f64, f64)| {
        let system = format!("{system:.3}").replace('.', sign);
        line(&[format!("\"{name}\""), number(*time, sign), system, "\"2026-11-24 10:00:00\"".to_owned()], separator)
    };
    line(&head, separator) + &events.iter().map(event).collect::<String>()
}

fn device(separator: &str) -> String {
    let pairs = [
        ("property", "value"),
        ("version", "1.2.0"),
        ("deviceModel", "Pixel 9"),
        ("deviceManufacturer", "Google"),
        ("accelerometer Name", "LSM6DSV"),
        ("accelerometer Range", "78.45"),
        ("accelerometer Resolution", "0.0024"),
        ("gyroscope Name", "LSM6DSV gyro"),
        ("pressure Name", "null"),
    ];
    pairs.iter().map(|(name, value)| line(&[format!("\"{name}\""), format!("\"{value}\"")], separator)).collect()
}

fn zip(files: &[(String, String)]) -> Vec<u8> {
    archive(files, Pack::Deflated)
}

fn read(bytes: Vec<u8>) -> Contents {
    reading::read(bytes, MOST).expect("data sets")
}

fn remarks(contents: &Contents) -> Vec<Remark> {
    let own = |finding: &Finding| if let Finding::DataSets(remark) = finding { Some(remark.clone()) } else { None };
    contents.import.findings.iter().filter_map(own).collect()
}

#[test]
fn every_set_is_read_in_every_dialect() {
    for (index, dialect) in DIALECTS.into_iter().enumerate() {
        for count in 1..=SETS.len() {
            let mut noise = Noise::new((10 * index + count) as u64);
            let mut files = Vec::new();
            let mut truth = Vec::new();
            for (place, (name, heads)) in SETS.iter().take(count).enumerate() {
                let rows = rows(40 + 17 * place, heads.len(), &mut noise);
                files.push((format!("{name}.csv"), csv(heads, &rows, dialect)));
                truth.push(rows);
            }
            files.push(("meta/device.csv".to_owned(), device(dialect.0)));
            files.push((
                "meta/time.csv".to_owned(),
                events(&[("START", 0.0, 1.79e9), ("PAUSE", 9.0, 1.79e9 + 9.0)], dialect),
            ));
            let contents = read(zip(&files));
            let table = &contents.import.table;
            let mut at = 0;
            for ((name, heads), rows) in SETS.iter().zip(&truth) {
                for (column, head) in heads.iter().enumerate() {
                    let found = &table.columns[at + column];
                    let (plain, unit) = head.trim_start_matches('\'').split_once(" (").expect("a unit");
                    assert_eq!(found.name, plain);
                    let parsed =
                        units::Unit::parse(unit.trim_end_matches(')').replace('µ', "u").as_str()).expect("a unit");
                    assert_eq!(
                        found.unit.as_ref().map(|unit| (unit.dimension, unit.factor)),
                        Some((parsed.dimension, parsed.factor))
                    );
                    assert_eq!(found.body.as_deref(), (count > 1).then_some(*name));
                    assert_eq!(found.independent, at);
                    for (row, values) in rows.iter().enumerate() {
                        let (found, expected) = (found.values[row], values[column]);
                        let expected: f64 = number(expected, ".").parse().expect("a number");
                        assert!(
                            found == expected || found.is_nan() && expected.is_nan(),
                            "{name} {head} {row} {found} {expected}"
                        );
                    }
                    assert!(found.values[rows.len()..].iter().all(|value| value.is_nan()));
                }
                at += heads.len();
            }
            assert_eq!(table.columns.len(), at);
            assert_eq!(table.runs().len(), if count > 1 { count } else { 0 });
            let remarks = remarks(&contents);
            let phone = Remark::Device { version: "1.2.0".to_owned(), phone: "Google Pixel 9".to_owned() };
            assert!(remarks.contains(&phone), "{remarks:?}");
            let sensor =
                remarks.iter().find(|remark| matches!(remark, Remark::Sensor { set, .. } if set == "Accelerometer"));
            let text = sensor.expect("a sensor").text(Language::English);
            assert_eq!(text, "Accelerometer: sensor LSM6DSV, range 78.45 m/s^2, resolution 0.0024 m/s^2");
            for finding in &contents.import.findings {
                assert!(
                    !finding.text(Language::English).is_empty()
                        && !finding.text(catalogues::with(Language::Spanish)).is_empty()
                );
            }
        }
    }
}

/// The clock of an experiment stops in a pause, or continues; the record has a gap in both cases.
#[test]
fn pauses_are_gaps() {
    for dialect in DIALECTS {
        for (pause, goes_on) in [(0.5, false), (4.0, false), (4.0, true), (0.0, false)] {
            // Experiment times, and system times.
            let wall: Vec<f64> =
                (0..300).map(|row| 0.01 + 0.01 * f64::from(row) + if row < 150 { 0.0 } else { pause }).collect();
            let shown = |time: f64| if time > 1.505 && !goes_on { time - pause } else { time };
            let rows: Vec<Vec<f64>> = wall.iter().map(|time| vec![shown(*time), libm::sin(*time)]).collect();
            let starts = if goes_on { 1.505 + pause } else { 1.505 };
            let times = [
                ("START", 0.0, 1.79e9),
                ("PAUSE", 1.505, 1.79e9 + 1.505),
                ("START", starts, 1.79e9 + 1.505 + pause),
                ("PAUSE", starts + 1.5, 1.79e9 + 3.005 + pause),
            ];
            let heads = ["Time (s)", "x (m/s^2)"];
            let delays: Vec<Vec<f64>> = (0..20).map(|row| vec![0.05 * f64::from(row), 1.0]).collect();
            let contents = read(zip(&[
                ("Raw Data.csv".to_owned(), csv(&heads, &rows, dialect)),
                ("Autocorrelation.csv".to_owned(), csv(&["Delay (s)", "c (1)"], &delays, dialect)),
                ("meta/time.csv".to_owned(), events(&times, dialect)),
            ]));
            let columns = &contents.import.table.columns;
            for (found, expected) in columns[0].values.iter().zip(&wall) {
                assert!((found - expected).abs() < 1e-6, "{pause} {goes_on}: {found} {expected}");
            }
            assert_eq!(columns[2].values[19], 0.95);
            let moved = pause > 0.0 && !goes_on;
            let said = remarks(&contents).into_iter().find(|remark| matches!(remark, Remark::Pauses { .. }));
            assert!(matches!(said, Some(Remark::Pauses { count: 1, moved: found, .. }) if found == moved), "{said:?}");
        }
    }
}

#[test]
fn a_workbook_of_phyphox_has_the_same_sets() {
    let set = |name: &'static str, heads: [&'static str; 2], factor: f64| {
        let mut cells = vec![(0, 0, Cell::Label(heads[0])), (0, 1, Cell::Label(heads[1]))];
        for row in 1..30 {
            cells.push((row, 0, Cell::Number(0.01 * f64::from(row))));
            cells.push((row, 1, Cell::Number(factor * f64::from(row))));
        }
        (name, cells)
    };
    let book = OldWorkbook {
        sheets: vec![
            set("Accelerometer", ["Time (s)", "X (m/s^2)"], 1.0),
            set("Gyroscope", ["Time (s)", "X (rad/s)"], 2.0),
            (
                "Metadata Device",
                vec![
                    (0, 0, Cell::Label("property")),
                    (0, 1, Cell::Label("value")),
                    (1, 0, Cell::Label("version")),
                    (1, 1, Cell::Label("1.2")),
                ],
            ),
            ("Metadata Time", vec![(0, 0, Cell::Label("event")), (0, 1, Cell::Label("experiment time"))]),
        ],
        ..OldWorkbook::default()
    };
    let contents = Reading::new(book.bytes(), MOST).and_then(Reading::complete).expect("data sets");
    let names: Vec<String> = contents.import.table.runs().into_iter().map(|(name, _)| name).collect();
    assert_eq!(names, ["Accelerometer", "Gyroscope"]);
    assert!(remarks(&contents).contains(&Remark::Device { version: "1.2".to_owned(), phone: String::new() }));
    assert_eq!(contents.import.table.column("Gyroscope.X"), Ok(3));
}

#[test]
fn other_archives_are_read_or_refused_with_what_is_in_them() {
    let table = "t [s],y [cm]\n0,1\n0.1,2\n0.2,3\n".to_owned();
    let one = read(zip(&[("folder/run.txt".to_owned(), table.clone()), ("readme.pdf".to_owned(), String::new())]));
    assert_eq!((one.import.findings.len(), one.import.table.columns.len(), one.text), (0, 2, table.clone()));
    let two = read(zip(&[
        ("a.csv".to_owned(), table.clone()),
        ("b/a.csv".to_owned(), table.clone()),
        ("notes.txt".to_owned(), "What I did in May".to_owned()),
        ("__MACOSX/._a.csv".to_owned(), table.clone()),
    ]));
    let sets = Remark::Several(vec!["a".to_owned(), "b/a".to_owned()]);
    assert_eq!(remarks(&two), [sets, Remark::NoTable("notes".to_owned())]);
    let refused = |files: &[(String, String)]| reading::read(zip(files), MOST).expect_err("refused");
    let names = ["a.png", "b.pdf", "c.md"].map(|name| (name.to_owned(), "x".to_owned()));
    let ReadingError::Workbook(error) = refused(&names) else { panic!("no workbook") };
    assert_eq!(
        error,
        WorkbookError::NoSheets { found: vec!["a.png".to_owned(), "b.pdf".to_owned(), "c.md".to_owned()] }
    );
    assert!(
        error.message(Language::English).contains("`b.pdf`")
            && error.message(catalogues::with(Language::Spanish)).contains("«b.pdf»")
    );
    assert!(matches!(refused(&[("a.csv".to_owned(), "no table".to_owned())]), ReadingError::File { .. }));
    // Few bytes that expand to many.
    let large = "0.1,0.2\n".repeat(500_000);
    let error = refused(&[("a.csv".to_owned(), large.clone()), ("b.csv".to_owned(), large)]);
    assert!(matches!(error, ReadingError::Workbook(WorkbookError::Expands { .. })), "{error:?}");
}

#[test]
fn any_change_of_an_archive_is_read_or_refused() {
    let mut noise = Noise::new(11);
    let files: Vec<(String, String)> = SETS
        .iter()
        .map(|(name, heads)| (format!("{name}.csv"), csv(heads, &rows(30, heads.len(), &mut noise), DIALECTS[0])))
        .chain([
            ("meta/device.csv".to_owned(), device(",")),
            (
                "meta/time.csv".to_owned(),
                events(&[("PAUSE", f64::NAN, f64::INFINITY), ("START", -1.0, 0.0)], DIALECTS[0]),
            ),
        ])
        .collect();
    let whole = zip(&files);
    for _ in 0..400 {
        let mut bytes = whole.clone();
        let at = (noise.uniform() * bytes.len() as f64) as usize;
        bytes[at] = (noise.uniform() * 256.0) as u8;
        if noise.uniform() < 0.2 {
            bytes.truncate(at);
        }
        let _ = reading::read(bytes, MOST);
        // A changed text.
        let (file, with) = ((noise.uniform() * files.len() as f64) as usize, (noise.uniform() * 128.0) as u8);
        let mut changed = files.clone();
        let mut text = changed[file].1.clone().into_bytes();
        let at = (noise.uniform() * text.len() as f64) as usize;
        text[at] = with;
        changed[file].1 = String::from_utf8_lossy(&text).into_owned();
        if noise.uniform() < 0.1 {
            let _ = reading::read(zip(&changed), MOST);
        }
    }
}
