//! Enumerated variants of texts: names, units, delimiters, decimal signs, dates, headers between rows, notations. None is
//! read wrongly in silence, and few are refused.

mod columns;
mod dates;
mod labelled;
mod markup;
mod runs;

use analysis::import;
use std::collections::BTreeMap;
use units::Unit;

/// Column that a person reads in a variant.
struct Expected {
    body: Option<&'static str>,
    name: String,
    /// Symbol of the unit; empty for none.
    unit: &'static str,
    /// Numbers in the unit.
    values: Vec<f64>,
}

/// Text, and the columns that a person reads in it.
struct Variant {
    kind: &'static str,
    text: String,
    columns: Vec<Expected>,
}

const ROWS: usize = 12;

fn times() -> Vec<f64> {
    (0..ROWS).map(|row| row as f64 / 10.0).collect()
}

fn heights(shift: f64) -> Vec<f64> {
    (0..ROWS).map(|row| (libm::cos(0.7 * row as f64 + shift) * 5000.0).round() / 1000.0).collect()
}

fn column(body: Option<&'static str>, name: &str, unit: &'static str, values: Vec<f64>) -> Expected {
    Expected { body, name: name.to_owned(), unit, values }
}

/// Line of cells; a decimal comma replaces the points if `comma`.
fn line(cells: &[String], delimiter: &str) -> String {
    cells.join(delimiter) + "\n"
}

fn number(value: f64, comma: bool) -> String {
    let text = format!("{value:.4}");
    if comma { text.replace('.', ",") } else { text }
}

fn rows(columns: &[&[f64]], delimiter: &str) -> String {
    let cells = |row: usize| columns.iter().map(|values| number(values[row], false)).collect::<Vec<_>>();
    (0..columns[0].len()).map(|row| line(&cells(row), delimiter)).collect()
}

/// Names that end like units, over a line of stated units.
fn names(found: &mut Vec<Variant>) {
    for name in ["Temp A0", "Temp A1", "Pos m2", "Pressure C1", "Sensor V3", "Temp A", "Kanal A", "Channel s2"] {
        for unit in ["mV", "cm", "kPa", "N"] {
            for delimiter in ["\t", ";", ","] {
                let text = format!("Time{delimiter}{name}\n[s]{delimiter}[{unit}]\n");
                let text = text + &rows(&[&times(), &heights(0.0)], delimiter);
                let columns = vec![column(None, "Time", "s", times()), column(None, name, unit, heights(0.0))];
                found.push(Variant { kind: "names", text, columns });
            }
        }
    }
}

/// Second headers with other units, names, orders and columns.
fn headers(found: &mut Vec<Variant>) {
    let milli = |values: &[f64]| values.iter().map(|value| value * 1000.0).collect::<Vec<f64>>();
    for delimiter in ["\t", ",", ";", " "] {
        for before in ["", "\n", "\n\n"] {
            for change in ["unit", "time", "name", "order", "more"] {
                let (t, y, next) = (times(), heights(0.0), heights(1.0));
                let join = |cells: &[&str]| cells.join(delimiter) + "\n";
                let (header, body, mut columns) = match change {
                    "unit" => (join(&["t[s]", "y[m]"]), vec![t.clone(), next.clone()], vec![("y", "m", next.clone())]),
                    "time" => {
                        (join(&["t[ms]", "y[cm]"]), vec![milli(&t), next.clone()], vec![("y", "cm", next.clone())])
                    }
                    "name" => {
                        (join(&["t[s]", "v[cm/s]"]), vec![t.clone(), next.clone()], vec![("v", "cm/s", next.clone())])
                    }
                    "order" => {
                        (join(&["y[cm]", "t[s]"]), vec![next.clone(), t.clone()], vec![("y", "cm", next.clone())])
                    }
                    _ => (
                        join(&["t[s]", "y[cm]", "U[V]"]),
                        vec![t.clone(), next.clone(), y.clone()],
                        vec![("y", "cm", next.clone()), ("U", "V", y.clone())],
                    ),
                };
                columns.push(("t", "s", t.clone()));
                let parts: Vec<&[f64]> = body.iter().map(Vec::as_slice).collect();
                let first = join(&["t[s]", "y[cm]"]) + &rows(&[&t, &y], delimiter);
                let text = first + before + &header + &rows(&parts, delimiter);
                let mut expected = vec![column(Some("Run 1"), "t", "s", t), column(Some("Run 1"), "y", "cm", y)];
                expected
                    .extend(columns.into_iter().map(|(name, unit, values)| column(Some("Run 2"), name, unit, values)));
                found.push(Variant { kind: "second header", text, columns: expected });
            }
        }
    }
}

/// Titles between the runs, with and without the header again, over runs of other lengths.
fn titles(found: &mut Vec<Variant>) {
    for delimiter in ["\t", ",", ";", " "] {
        for (title, run) in [("Run 2", "Run 2"), ("Run #2", "Run 2"), ("next pendulum", "Run 2"), ("# second", "Run 2")]
        {
            for again in [false, true] {
                for start in [0, 3] {
                    let (t, y, next) = (times(), heights(0.0), heights(1.0));
                    let header =
                        format!("t (s){delimiter}y (cm)\n").replace(" (s) ", "(s) ").replace("y (cm)", "y(cm)");
                    let text = header.clone() + &rows(&[&t, &y], delimiter) + title + "\n";
                    let text =
                        text + if again { &header } else { "" } + &rows(&[&t[start..], &next[start..]], delimiter);
                    let columns = vec![
                        column(Some("Run 1"), "t", "s", t.clone()),
                        column(Some("Run 1"), "y", "cm", y),
                        column(Some(run), "t", "s", t[start..].to_vec()),
                        column(Some(run), "y", "cm", next[start..].to_vec()),
                    ];
                    found.push(Variant { kind: "title between runs", text, columns });
                }
            }
        }
    }
}

/// Dates in nine notations, a day or a second apart, from 20 February 2024.
fn dates(found: &mut Vec<Variant>) {
    const NAMES: [&str; 2] = ["Feb", "Mar"];
    for form in 0..9 {
        for daily in [false, true] {
            for delimiter in ["\t", ";"] {
                for comma in [false, true] {
                    let mut text = format!("date{delimiter}y (cm)\n");
                    for (row, value) in heights(0.0).iter().enumerate() {
                        let day = if daily { 20 + row } else { 20 };
                        let (month, day) = if day > 29 { (3, day - 29) } else { (2, day) };
                        let name = NAMES[month - 2];
                        let date = match form {
                            0 => format!("{day:02}/{month:02}/2024"),
                            1 => format!("{month}/{day}/2024"),
                            2 => format!("{day:02}-{month:02}-2024"),
                            3 => format!("{day:02}.{month:02}.2024"),
                            4 => format!("2024-{month:02}-{day:02}"),
                            5 => format!("2024/{month:02}/{day:02}"),
                            6 => format!("{name} {day}, 2024"),
                            7 => format!("{day} {name} 2024"),
                            _ => format!("{day}-{name}-24"),
                        };
                        let clock = if daily { String::new() } else { format!(" 10:00:{row:02}") };
                        text += &line(&[date + &clock, number(*value, comma)], delimiter);
                    }
                    let step = if daily { 86_400.0 } else { 1.0 };
                    let seconds = (0..ROWS).map(|row| step * row as f64).collect();
                    let columns = vec![column(None, "date", "s", seconds), column(None, "y", "cm", heights(0.0))];
                    found.push(Variant { kind: "dates", text, columns });
                }
            }
        }
    }
}

/// Negative numbers and numbers with errors, powers and prefixes.
fn notations(found: &mut Vec<Variant>) {
    for form in 0..12 {
        for delimiter in ["\t", ";"] {
            for comma in [false, true] {
                let mut text = format!("t (s){delimiter}y (cm)\n");
                for (time, value) in times().iter().zip(heights(0.0)) {
                    let size = number(value.abs(), comma);
                    let plain = number(value, comma);
                    let cell = match (form, value < 0.0) {
                        (0, true) => format!("\u{2212}{size}"),
                        (1, true) => format!("\u{2010}{size}"),
                        (2, true) => format!("\u{2011}{size}"),
                        (3, true) => format!("–{size}"),
                        (4, true) => format!("- {size}"),
                        (5, true) => format!("({size})"),
                        (6, true) => format!("{size}-"),
                        (7, _) => format!("{plain}(4)"),
                        (8, _) => format!("{plain}±{}", number(0.04, comma)),
                        (9, _) => format!("{}×10⁻¹", number(10.0 * value, comma)),
                        (10, _) => format!("=\"{plain}\""),
                        (11, _) => format!("{}k", number(value / 1000.0, comma)),
                        _ => plain,
                    };
                    text += &line(&[number(*time, comma), cell], delimiter);
                }
                let rounded = |value: f64| number(value / 1000.0, false).parse::<f64>().expect("a number") * 1000.0;
                let values = heights(0.0).into_iter().map(|value| if form == 11 { rounded(value) } else { value });
                let columns = vec![column(None, "t", "s", times()), column(None, "y", "cm", values.collect())];
                found.push(Variant { kind: "notations", text, columns });
            }
        }
    }
}

/// Units of instruments in four places.
fn units_of_instruments(found: &mut Vec<Variant>) {
    let known =
        [("Nm", "N m"), ("kWh", "kW h"), ("Torr", "mmHg"), ("mps", "m/s"), ("dps", "deg/s"), ("cm.s^-1", "cm/s")];
    let cyrillic = [("см", "cm"), ("кг", "kg"), ("В", "V"), ("м/с", "m/s"), ("°/s", "deg/s")];
    for (written, unit) in known.into_iter().chain(cyrillic) {
        for form in 0..4 {
            let heading = match form {
                0 => format!("t (s);quantity ({written})\n"),
                1 => format!("t [s];quantity [{written}]\n"),
                2 => format!("t in s;quantity in {written}\n"),
                _ => format!("t;quantity\ns;{written}\n"),
            };
            let text = heading + &rows(&[&times(), &heights(0.0)], ";");
            let columns = vec![column(None, "t", "s", times()), column(None, "quantity", unit, heights(0.0))];
            found.push(Variant { kind: "units", text, columns });
        }
    }
}

/// Sentences behind a comment sign.
fn prose(found: &mut Vec<Variant>) {
    for remark in
        ["my first run, long pendulum", "Length 50 cm", "measured by hand", "Selected parameters:", "the cart"]
    {
        for (sign, delimiter) in [("# ", " "), ("% ", " "), ("# ", "\t"), ("// ", "\t"), ("# ", ";")] {
            let (t, y) = (times(), heights(0.0));
            let text = format!("{sign}{remark}\n") + &rows(&[&t, &y], delimiter);
            let columns = vec![column(None, "", "", t), column(None, "", "", y)];
            found.push(Variant { kind: "remarks", text, columns });
        }
    }
}

/// Serial days, counters that overflow, units in cells, decimal commas between commas.
fn counts(found: &mut Vec<Variant>) {
    for name in ["Date", "Date/Time", "Timestamp", "Fecha", "Datum"] {
        for (delimiter, comma) in [("\t", false), (";", true), (",", false)] {
            let mut text = format!("{name}{delimiter}y (cm)\n");
            for (row, value) in heights(0.0).iter().enumerate() {
                let day = format!("{:.9}", 45_581.5 + row as f64 * 60.0 / 86_400.0);
                let day = if comma { day.replace('.', ",") } else { day };
                text += &line(&[day, number(*value, comma)], delimiter);
            }
            let seconds = (0..ROWS).map(|row| 60.0 * row as f64).collect();
            found.push(Variant { kind: "serial days", text, columns: vec![column(None, name, "s", seconds)] });
        }
    }
    for (name, unit, bits) in
        [("micros", "µs", 32), ("millis", "ms", 16), ("time_us", "µs", 16), ("Time (ms)", "ms", 32)]
    {
        for delimiter in ["\t", ",", ";"] {
            let turn = 1_u64 << bits;
            let counter: Vec<u64> = (0..ROWS as u64).map(|row| turn - 251 + 50 * row).collect();
            let mut text = format!("{name}{delimiter}y (cm)\n");
            for (count, value) in counter.iter().zip(heights(0.0)) {
                text += &line(&[(count % turn).to_string(), number(value, false)], delimiter);
            }
            let values = counter.into_iter().map(|count| count as f64).collect();
            let name = if name.starts_with("time_") { "time" } else { name.split(" (").next().unwrap_or(name) };
            found.push(Variant { kind: "counters", text, columns: vec![column(None, name, unit, values)] });
        }
    }
    for (small, large) in [("ms", "s"), ("mm", "cm"), ("mA", "A"), ("mV", "V")] {
        for delimiter in ["\t", ",", ";"] {
            let mut text = format!("row{delimiter}quantity\n");
            let factor = if small == "mm" { 10.0 } else { 1000.0 };
            for row in 1..=ROWS {
                let value = 100.0 * row as f64;
                let cell = if row > 5 { format!("{} {large}", value / factor) } else { format!("{value} {small}") };
                text += &line(&[row.to_string(), cell], delimiter);
            }
            let values = (1..=ROWS).map(|row| 100.0 * row as f64).collect();
            found.push(Variant {
                kind: "units in cells",
                text,
                columns: vec![column(None, "quantity", small, values)],
            });
        }
    }
    for clock in [false, true] {
        for thousands in [false, true] {
            let mut text = "time,power\n".to_owned();
            for row in 0..ROWS {
                let time = if clock { format!("10:00:{row:02}") } else { format!("{row}.5") };
                let large = if row % 2 == 0 { format!("1,{:03}.25", 100 + row) } else { format!("{}.25", 900 + row) };
                text += &format!("{time},{}\n", if thousands { large } else { format!("{},{:03}", row, 100 + row) });
            }
            found.push(Variant {
                kind: "commas in numbers",
                text,
                columns: vec![column(None, "power", "W", Vec::new())],
            });
        }
    }
}

/// Reason why a variant was read wrongly; `None` if all its columns are right.
fn wrong(import: &import::Import, variant: &Variant) -> Option<String> {
    let unit_of = |text: &str| (!text.is_empty()).then(|| Unit::parse(text).expect("a unit"));
    for (index, expected) in variant.columns.iter().enumerate() {
        let named =
            |column: &&analysis::table::Column| column.name == expected.name && column.body.as_deref() == expected.body;
        let place = if expected.name.is_empty() { import.table.columns.get(index) } else { None };
        let Some(column) = place.or_else(|| import.table.columns.iter().find(named)) else {
            // A column of words is left out.
            if expected.values.is_empty() {
                continue;
            }
            return Some(format!("no {:?}.{}", expected.body, expected.name));
        };
        let si = |unit: &Option<Unit>, value: f64| unit.as_ref().map_or(value, |unit| unit.to_si(value));
        let wanted = unit_of(expected.unit);
        let dimension = |unit: &Option<Unit>| unit.as_ref().map(|unit| unit.dimension);
        if dimension(&column.unit) != dimension(&wanted) || (expected.name.is_empty() && !column.name.is_empty()) {
            return Some(format!("{}: unit {:?}, name {}", expected.name, column.unit, column.name));
        }
        let values: Vec<f64> = column.values.iter().copied().filter(|value| value.is_finite()).collect();
        let near = |(value, truth): (&f64, &f64)| {
            let (value, truth) = (si(&column.unit, *value), si(&wanted, *truth));
            (value - truth).abs() <= 1e-9 + 1e-6 * truth.abs().max(si(&wanted, 0.01).abs())
        };
        if values.len() != expected.values.len() || !values.iter().zip(&expected.values).all(near) {
            return Some(format!("{}: {values:?} for {:?}", expected.name, expected.values));
        }
    }
    None
}

#[test]
fn variants_are_read_as_a_person_reads_them_or_refused() {
    let mut variants = Vec::new();
    for add in [
        names,
        headers,
        titles,
        dates,
        notations,
        units_of_instruments,
        prose,
        counts,
        runs::labels,
        columns::codes,
        columns::lists,
        columns::clocks,
        markup::tables,
    ] {
        add(&mut variants);
    }
    let mut counts: BTreeMap<&str, [usize; 2]> = BTreeMap::new();
    let mut report = String::new();
    for variant in &variants {
        let count = counts.entry(variant.kind).or_default();
        count[0] += 1;
        match import::text(variant.text.as_bytes()) {
            Err(error) => {
                count[1] += 1;
                if variant.kind != "commas in numbers" {
                    report += &format!("refused: {}\n{error}\n{}\n", variant.kind, variant.text);
                }
            }
            Ok(import) => {
                if let Some(reason) = wrong(&import, variant) {
                    report += &format!("wrong: {}: {reason}\n{}\n", variant.kind, variant.text);
                }
            }
        }
    }
    let refused: usize = counts.values().map(|count| count[1]).sum();
    assert!(report.is_empty(), "{report}");
    assert!(variants.len() >= 400 && 10 * refused <= variants.len(), "{} variants: {counts:?}", variants.len());
}
