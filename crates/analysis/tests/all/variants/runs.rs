//! Variants of texts with several runs: words that name the run of each row, and headers that grow.

use super::{ROWS, Variant, column, heights, line, number, rows, times};
use analysis::import;

/// Columns of words that name the sensor, board or run of each row, and words that do not.
pub fn labels(found: &mut Vec<Variant>) {
    let parts = |count: usize| (0..count).map(|part| heights(0.4 * part as f64)).collect::<Vec<_>>();
    for (heading, labels, bodies) in [
        ("sensor", &["1:", "2:", "3:"][..], &["sensor 1", "sensor 2", "sensor 3"][..]),
        ("sensor", &["kitchen", "attic", "cellar"], &["kitchen", "attic", "cellar"]),
        ("board", &["A", "B"], &["A", "B"]),
        ("", &["1:", "2:", "3:"], &["Run 1", "Run 2", "Run 3"]),
        ("", &["T1", "T2", "T3", "T4"], &["T1", "T2", "T3", "T4"]),
        ("trial", &["trial one", "trial two"], &["trial one", "trial two"]),
    ] {
        for delimiter in ["\t", ",", ";"] {
            // In turn with increasing times, in turn with equal times, one after the other with times that begin again.
            for order in ["turns", "together", "blocks"] {
                if order == "turns" && labels[0] == "trial one" {
                    continue;
                }
                for last in [false, true] {
                    let count = labels.len();
                    let values = parts(count);
                    let mut columns = Vec::new();
                    let mut rows = Vec::new();
                    for (part, label) in labels.iter().enumerate() {
                        let shift = if order == "turns" { part as f64 * 0.1 / count as f64 } else { 0.0 };
                        let times: Vec<f64> = times().iter().map(|time| (1e4 * (time + shift)).round() / 1e4).collect();
                        for row in 0..ROWS {
                            let place = if order == "blocks" { part * ROWS + row } else { row * count + part };
                            let mut cells = vec![number(times[row], false), number(values[part][row], false)];
                            cells.insert(if last { 2 } else { 1 }, (*label).to_owned());
                            rows.push((place, line(&cells, delimiter)));
                        }
                        let names = if heading.is_empty() { ["", ""] } else { ["t", "y"] };
                        let unit = if heading.is_empty() { "" } else { "s" };
                        columns.push(column(Some(bodies[part]), names[0], unit, times));
                        let unit = if heading.is_empty() { "" } else { "cm" };
                        columns.push(column(Some(bodies[part]), names[1], unit, values[part].clone()));
                    }
                    rows.sort_by_key(|(place, _)| *place);
                    let mut heads = vec!["t (s)".to_owned(), "y (cm)".to_owned()];
                    heads.insert(if last { 2 } else { 1 }, heading.to_owned());
                    let head = if heading.is_empty() { String::new() } else { line(&heads, delimiter) };
                    let text = rows.into_iter().fold(head, |text, (_, line)| text + &line);
                    found.push(Variant { kind: "labels of rows", text, columns });
                }
            }
        }
    }
    for states in [["up", "down"], ["blocked", "free"], ["ok", "fail"]] {
        for delimiter in ["\t", ",", ";"] {
            for turns in [1, 3, 5] {
                let mut text = line(&["t (s)".to_owned(), "state".to_owned(), "y (cm)".to_owned()], delimiter);
                for (row, (time, value)) in times().into_iter().zip(heights(0.0)).enumerate() {
                    let state = states[row / turns % 2].to_owned();
                    text += &line(&[number(time, false), state, number(value, false)], delimiter);
                }
                let columns = vec![column(None, "t", "s", times()), column(None, "y", "cm", heights(0.0))];
                found.push(Variant { kind: "states", text, columns });
            }
        }
    }
}

#[test]
fn a_header_that_grows_says_nothing_of_missing_names() {
    for delimiter in ["\t", ",", ";"] {
        for (first, second) in [(2, 3), (2, 4), (3, 4), (3, 5)] {
            let names = ["t (s)", "y (cm)", "light (lx)", "p (Pa)", "U (V)"];
            let part = |count: usize| {
                let columns: Vec<Vec<f64>> =
                    (0..count).map(|column| if column == 0 { times() } else { heights(column as f64) }).collect();
                let columns: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
                names[..count].join(delimiter) + "\n" + &rows(&columns, delimiter)
            };
            let import = import::text((part(first) + &part(second)).as_bytes()).expect("a table");
            let texts: Vec<String> =
                import.findings.iter().map(|finding| finding.text(units::Language::English)).collect();
            assert!(texts.iter().all(|text| !text.contains("names stand")), "{texts:?}");
            assert_eq!(import.table.columns.len(), first + second, "{first} and {second} between {delimiter:?}");
        }
    }
}
