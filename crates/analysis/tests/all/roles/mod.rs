//! Roles of columns in generated tables with known truth: each must be read right, or several readings offered.

mod lookup;

use analysis::import::{self, Import};
use analysis::origin::{Reason, Role};
use analysis::table::Table;
use units::{Dimension, Language, Unit};

/// Values of a generated column in a row.
fn number(kind: char, row: usize, rows: usize) -> Option<f64> {
    let at = row as f64;
    let swing = |rate: f64, phase: f64| (libm::sin(rate * at + phase) * 1e4).round() / 1e3;
    let half = row < rows / 2 + 1;
    match kind {
        // Clocks of three rates; one that begins later, one that ends earlier, one of uneven steps.
        't' => Some((at * 40.0).round() / 1e3),
        'u' => Some((at * 100.0).round() / 1e3),
        'w' => Some((at * 25.0 + 7.0).round() / 1e3),
        's' => half.then_some(at * 0.125),
        'e' => Some(0.5 + at * 0.03 + 0.01 * libm::sin(at * 0.7)),
        'm' => Some(at * 40.0),
        'U' => Some((at * 100.0 + 5000.0).round() / 1e3),
        // Values; one of half the rows, one that increases, one that decreases, a constant.
        'y' => Some(swing(0.9, 0.3)),
        'z' => Some(swing(0.63, 1.1)),
        'h' => half.then_some(swing(0.8, 0.2)),
        'd' => Some((4.905 * (0.1 * at) * (0.1 * at) * 1e4 + at).round() / 1e4),
        'q' => Some(((20.0 - 0.3 * at) * 1e3).round() / 1e3),
        // Numbers of rows from 0 and from 1; periods.
        'n' => Some(at),
        'N' => Some(at + 1.0),
        // A constant, and the number of starts of a logger.
        'c' => Some(5.0),
        'b' => Some((at * 3.0 / rows as f64).floor() + 7.0),
        'p' => Some(1.4 + 0.01 * swing(1.7, 0.4)),
        _ => None,
    }
}

/// A table: headings with the kinds of their numbers.
fn written(columns: &[(&str, char)], delimiter: &str, rows: usize) -> String {
    let mut text = String::new();
    if columns.iter().any(|(heading, _)| !heading.is_empty()) {
        text = columns.iter().map(|(heading, _)| *heading).collect::<Vec<_>>().join(delimiter) + "\n";
    }
    for row in 0..rows {
        let cell =
            |(_, kind): &(&str, char)| number(*kind, row, rows).map(|value| value.to_string()).unwrap_or_default();
        text += &(columns.iter().map(cell).collect::<Vec<_>>().join(delimiter) + "\n");
    }
    text
}

/// Independent variable of each column, from 0; or the readings, if there are several.
enum Truth {
    Read(&'static [usize]),
    Asked(&'static [&'static [usize]]),
}
use Truth::{Asked, Read};

/// Name, headings with the kinds of their numbers, and true roles.
type Layout = (&'static str, &'static [(&'static str, char)], Truth);

const LAYOUTS: &[Layout] = &[
    ("one clock", &[("t [s]", 't'), ("y [cm]", 'y')], Read(&[0, 0])),
    ("a clock behind", &[("y [cm]", 'y'), ("t [s]", 't'), ("z [cm]", 'z')], Read(&[1, 1, 1])),
    ("letters", &[("tA", 't'), ("yA", 'y'), ("tB", 'u'), ("yB", 'z')], Read(&[0, 0, 2, 2])),
    ("letters, units", &[("tA (s)", 't'), ("yA (cm)", 'y'), ("tB (s)", 'u'), ("yB (cm)", 'z')], Read(&[0, 0, 2, 2])),
    ("clocks first", &[("tA", 't'), ("tB", 'u'), ("yA", 'y'), ("yB", 'z')], Read(&[0, 1, 0, 1])),
    ("clocks first, crossed", &[("tA", 't'), ("tB", 'u'), ("yB", 'y'), ("yA", 'z')], Read(&[0, 1, 1, 0])),
    ("clocks last", &[("yA", 'y'), ("yB", 'z'), ("tA", 't'), ("tB", 'u')], Read(&[2, 3, 2, 3])),
    ("numbers", &[("t1 [s]", 't'), ("y1", 'y'), ("t2 [s]", 'u'), ("y2", 'z')], Read(&[0, 0, 2, 2])),
    (
        "numbers, clocks first",
        &[("t_1", 't'), ("t_2", 'u'), ("x_1", 'y'), ("y_1", 'z'), ("x_2", 'z'), ("y_2", 'y')],
        Read(&[0, 1, 0, 0, 1, 1]),
    ),
    ("pandas", &[("time", 't'), ("y", 'y'), ("time.1", 'u'), ("y.1", 'z')], Read(&[0, 0, 2, 2])),
    (
        "pandas, three",
        &[("t", 't'), ("y", 'y'), ("t.1", 'u'), ("y.1", 'z'), ("t.2", 'w'), ("y.2", 'y')],
        Read(&[0, 0, 2, 2, 4, 4]),
    ),
    (
        "words",
        &[("Time heavy (s)", 't'), ("y heavy (cm)", 'y'), ("Time light (s)", 'u'), ("y light (cm)", 'z')],
        Read(&[0, 0, 2, 2]),
    ),
    (
        "words, clocks first",
        &[("Time heavy", 't'), ("Time light", 'u'), ("y heavy", 'y'), ("y light", 'z')],
        Read(&[0, 1, 0, 1]),
    ),
    ("words before", &[("ball time", 't'), ("ball y", 'y'), ("cart time", 'u'), ("cart y", 'z')], Read(&[0, 0, 2, 2])),
    (
        "Spanish",
        &[("Tiempo A (s)", 't'), ("Altura A (m)", 'y'), ("Tiempo B (s)", 'u'), ("Altura B (m)", 'z')],
        Read(&[0, 0, 2, 2]),
    ),
    (
        "Spanish runs",
        &[
            ("Tiempo (s) Ejecución n.º 1", 't'),
            ("Ángulo (°) Ejecución n.º 1", 'y'),
            ("Tiempo (s) Ejecución n.º 2", 'u'),
            ("Ángulo (°) Ejecución n.º 2", 'z'),
        ],
        Read(&[0, 0, 2, 2]),
    ),
    (
        "runs by No.",
        &[("Time (s) Run No. 1", 't'), ("y Run No. 1", 'y'), ("Time (s) Run No. 2", 'u'), ("y Run No. 2", 'z')],
        Read(&[0, 0, 2, 2]),
    ),
    ("brackets", &[("t (left)", 't'), ("y (left)", 'y'), ("t (right)", 'u'), ("y (right)", 'z')], Read(&[0, 0, 2, 2])),
    ("one of two names", &[("t", 't'), ("y1", 'y'), ("y2", 'z'), ("t2", 'u'), ("z", 'z')], Read(&[0, 0, 0, 3, 3])),
    ("other lengths", &[("t", 't'), ("y", 'y'), ("t2", 's'), ("z", 'h')], Read(&[0, 0, 2, 2])),
    (
        "other lengths, by unit",
        &[("t (s)", 's'), ("y", 'h'), ("sensor clock (s)", 'u'), ("z", 'z')],
        Read(&[0, 0, 2, 2]),
    ),
    ("equal clocks", &[("t", 't'), ("y", 'y'), ("t2", 't'), ("z", 'z')], Read(&[0, 0, 2, 2])),
    (
        "the same clock in another unit",
        &[("t [s]", 't'), ("t_ms [ms]", 'm'), ("y", 'y'), ("z", 'z')],
        Read(&[0, 0, 0, 0]),
    ),
    (
        "the same clock from another zero",
        &[("Time (s)", 'u'), ("Absolute time (s)", 'U'), ("y", 'y'), ("z", 'z')],
        Read(&[0, 0, 0, 0]),
    ),
    ("a clock that begins later", &[("Time", 't'), ("y", 'y'), ("t", 'w'), ("z", 'z')], Read(&[0, 0, 2, 2])),
    ("uneven steps", &[("tA", 'e'), ("yA", 'y'), ("tB", 'w'), ("yB", 'z')], Read(&[0, 0, 2, 2])),
    ("a constant t", &[("t", 'c'), ("uptime_ms", 'm'), ("y", 'y')], Read(&[1, 1, 1])),
    ("a constant t before a unit", &[("t [s]", 'c'), ("elapsed [ms]", 'm'), ("y", 'y')], Read(&[1, 1, 1])),
    ("a constant temperature t", &[("t", 'c'), ("s [m]", 'd'), ("F [N]", 'y')], Read(&[1, 1, 1])),
    ("a constant t alone", &[("t", 'c'), ("y", 'y')], Read(&[0, 0])),
    ("a device", &[("device", 'c'), ("time", 't'), ("y", 'y')], Read(&[1, 1, 1])),
    ("a device, no time by name", &[("device", 'c'), ("load", 'd'), ("y", 'y')], Read(&[1, 1, 1])),
    ("a device without names", &[("", 'c'), ("", 't'), ("", 'y')], Read(&[1, 1, 1])),
    ("boots", &[("boot_id", 'b'), ("millis", 'm'), ("y", 'y')], Read(&[1, 1, 1])),
    ("boots, no time by name", &[("boot_id", 'b'), ("uptime", 't'), ("y", 'y')], Read(&[1, 1, 1])),
    ("boots and a fall", &[("boot", 'b'), ("load", 'q'), ("y", 'y')], Read(&[1, 1, 1])),
    ("boots and a device", &[("id", 'c'), ("boots", 'b'), ("uptime", 't'), ("y", 'y')], Read(&[2, 2, 2, 2])),
    ("no names, a clock behind", &[("", 'y'), ("", 'z'), ("", 't')], Read(&[2, 2, 2])),
    ("rows, boots", &[("Nr", 'N'), ("boot", 'b'), ("uptime [s]", 't'), ("y", 'y')], Read(&[0, 2, 2, 2])),
    ("a constant behind the time", &[("time [s]", 't'), ("gain", 'c'), ("y", 'y')], Read(&[0, 0, 0])),
    ("a constant second time", &[("t [s]", 't'), ("t0 [s]", 'c'), ("y", 'y')], Read(&[0, 0, 0])),
    ("the same name twice", &[("t", 't'), ("y", 'y'), ("t", 'u'), ("y", 'z')], Read(&[0, 0, 2, 2])),
    ("no clock: a distance", &[("t [s]", 't'), ("s [m]", 'd'), ("v [m/s]", 'y')], Read(&[0, 0, 0])),
    ("no clock: a distance without a unit", &[("t", 't'), ("s", 'd'), ("v", 'y')], Read(&[0, 0, 0])),
    ("no clock: a charge", &[("t [s]", 't'), ("Q [C]", 'u'), ("I [A]", 'y')], Read(&[0, 0, 0])),
    ("no clock: a temperature that falls", &[("t [min]", 't'), ("T", 'q'), ("U", 'y')], Read(&[0, 0, 0])),
    ("no clock: periods", &[("t [s]", 't'), ("period [s]", 'p'), ("A [cm]", 'q')], Read(&[0, 0, 0])),
    ("no clock: nothing behind it", &[("t [s]", 't'), ("y [cm]", 'y'), ("delay [ms]", 'u')], Read(&[0, 0, 0])),
    ("no clock: its error", &[("t [s]", 't'), ("sigma_t [s]", 'u'), ("y [cm]", 'y')], Read(&[0, 0, 0])),
    (
        "a delay or a clock",
        &[("t [s]", 't'), ("y [cm]", 'y'), ("delay [ms]", 'u'), ("z [cm]", 'z')],
        Asked(&[&[0], &[0, 2]]),
    ),
    ("two clocks, one column", &[("tA", 't'), ("tB", 'u'), ("y", 'y')], Asked(&[&[0], &[1]])),
    (
        "two clocks, three columns",
        &[("t1", 't'), ("t2", 'u'), ("a", 'y'), ("b", 'z'), ("c", 'q')],
        Asked(&[&[0], &[1]]),
    ),
    ("lengths and periods", &[("L [m]", 'q'), ("t1 [s]", 'u'), ("t2 [s]", 't')], Asked(&[&[0], &[1]])),
    ("heights and times", &[("h (cm)", 'd'), ("t1", 'u'), ("t2", 'w'), ("t3", 't')], Asked(&[&[0], &[1]])),
    ("lengths and a period", &[("L [m]", 'q'), ("period [s]", 'p')], Read(&[0, 0])),
    ("the time by its unit", &[("y [cm]", 'y'), ("Zeitpunkt [s]", 't')], Read(&[1, 1])),
    ("rows and a frequency", &[("Nr", 'n'), ("f [Hz]", 'd'), ("A [mm]", 'y')], Read(&[0, 1, 1])),
    ("rows and a voltage that falls", &[("#", 'N'), ("U [V]", 'q'), ("I [A]", 'y')], Read(&[0, 1, 1])),
    ("rows and a time", &[("index", 'n'), ("Zeitpunkt [s]", 't'), ("y [cm]", 'y')], Read(&[0, 1, 1])),
    ("rows and a named time", &[("i", 'N'), ("t", 't'), ("y", 'y')], Read(&[0, 1, 1])),
    ("pandas' index", &[("", 'n'), ("f [Hz]", 'd'), ("A [mm]", 'y')], Read(&[0, 1, 1])),
    ("pandas' index and a time", &[("", 'n'), ("t", 't'), ("y", 'y')], Read(&[0, 1, 1])),
    ("rows and places", &[("n", 'n'), ("x [m]", 'd'), ("y [m]", 'y')], Asked(&[&[0], &[1]])),
    ("rows and no units", &[("Nr.", 'N'), ("U", 'd'), ("I", 'y')], Asked(&[&[0], &[1]])),
    (
        "rows and two that increase",
        &[("Nr", 'N'), ("U [V]", 'd'), ("T [K]", 'q'), ("I [A]", 'y')],
        Asked(&[&[0], &[1], &[2]]),
    ),
    ("rows and nothing that increases", &[("n", 'n'), ("x", 'y'), ("y", 'z')], Read(&[0, 0, 0])),
    ("rows and one column", &[("n", 'N'), ("A [cm]", 'q')], Read(&[0, 0])),
    ("rows and their times", &[("n", 'N'), ("t_n [s]", 'e')], Read(&[0, 0])),
    ("frames", &[("frame", 'n'), ("x [m]", 'd'), ("y [m]", 'y')], Read(&[0, 0, 0])),
    ("no names", &[("", 't'), ("", 'y'), ("", 'z')], Read(&[0, 0, 0])),
    ("no names, one that increases", &[("", 't'), ("", 'd'), ("", 'z')], Read(&[0, 0, 0])),
    ("no names, two clocks", &[("", 't'), ("", 'y'), ("", 'u'), ("", 'z')], Asked(&[&[0], &[0, 2]])),
    ("no names, the same clock twice", &[("", 't'), ("", 'y'), ("", 't'), ("", 'z')], Read(&[0, 0, 2, 2])),
    ("no names, rows and times", &[("", 'n'), ("", 't'), ("", 'y')], Asked(&[&[0], &[1]])),
    ("no names, other lengths", &[("", 's'), ("", 'h'), ("", 'u'), ("", 'z')], Read(&[0, 0, 2, 2])),
];

fn import(text: &str) -> Import {
    import::text(text.as_bytes()).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn owners(table: &Table) -> Vec<usize> {
    table.columns.iter().map(|column| column.independent).collect()
}

#[test]
fn the_roles_of_generated_tables_are_read_or_asked() {
    let (mut wrong, mut read, mut asked) = (String::new(), 0, 0);
    for (name, columns, truth) in LAYOUTS {
        for (delimiter, rows) in [("\t", 9), (";", 40), (",", 24)] {
            let text = written(columns, delimiter, rows);
            let table = import(&text).table;
            let right = match truth {
                Read(expected) => {
                    read += 1;
                    owners(&table) == *expected && table.readings.is_empty()
                }
                Asked(expected) => {
                    asked += 1;
                    table.readings.iter().map(Vec::as_slice).collect::<Vec<_>>() == *expected
                }
            };
            if !right {
                wrong += &format!("{name}: {:?}, readings {:?}\n{text}\n", owners(&table), table.readings);
            }
        }
    }
    println!("{read} variants are read, {asked} are asked about");
    assert!(read + asked >= 160);
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn each_reading_can_be_chosen_and_each_question_names_its_columns() {
    for (name, columns, truth) in LAYOUTS {
        let Asked(readings) = truth else { continue };
        for reading in *readings {
            let mut table = import(&written(columns, ";", 24)).table;
            let words = table.reading_in_words(reading, catalogues::with(Language::Spanish));
            assert!(words.contains("columnas"), "{name}: {words}");
            assert!((0..table.columns.len()).any(|column| table.is_open(column)), "{name}");
            table.against(reading, Reason::Person);
            assert_eq!(
                table
                    .independent()
                    .filter(|index| matches!(table.columns[*index].origin.role, Role::Independent(_)))
                    .collect::<Vec<_>>(),
                *reading,
                "{name}"
            );
            assert!(
                table.readings.is_empty() && (0..table.columns.len()).all(|column| !table.is_open(column)),
                "{name}"
            );
        }
    }
}

#[test]
fn the_document_s_independent_variable_is_found_by_its_name_and_its_unit() {
    let hertz = Unit::parse("Hz").unwrap().dimension;
    type Case<'a> = (&'a [(&'a str, char)], &'a str, Dimension, usize);
    let cases: &[Case] = &[
        (&[("Nr", 'n'), ("f [Hz]", 'd'), ("A [mm]", 'y')], "f", hertz, 1),
        (&[("Nr", 'n'), ("f", 'd'), ("A", 'y')], "f", hertz, 1),
        (&[("Nr", 'n'), ("nu [kHz]", 'y'), ("A [mm]", 'd')], "f", hertz, 1),
        (&[("A [mm]", 'y'), ("f [Hz]", 'd')], "f", hertz, 1),
        (&[("t [s]", 't'), ("f [Hz]", 'y'), ("A [mm]", 'z')], "f", hertz, 1),
        (&[("", 'n'), ("U", 'd'), ("f", 'y')], "f", hertz, 2),
        (&[("t [s]", 't'), ("x [m]", 'd'), ("y [m]", 'y')], "t", Dimension::TIME, 0),
        (&[("n", 'n'), ("x [m]", 'd'), ("y [m]", 'y')], "x", Dimension::LENGTH, 1),
        (&[("n", 'n'), ("x [m]", 'd'), ("y [m]", 'y')], "n", Dimension::NONE, 0),
    ];
    for (columns, name, dimension, expected) in cases {
        for delimiter in ["\t", ";"] {
            let mut table = import(&written(columns, delimiter, 30)).table;
            let observed = columns.len() - 1 - usize::from(*expected == columns.len() - 1);
            table.suit(name, *dimension, &[observed]);
            assert_eq!(table.columns[observed].independent, *expected, "{name} of {columns:?}");
            assert!(table.readings.is_empty(), "{name} of {columns:?}");
        }
    }
}
