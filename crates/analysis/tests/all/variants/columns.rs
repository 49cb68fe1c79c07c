//! Variants of columns as loggers write them: check sums, lists of columns in comments, a clock behind the values.

use super::{Variant, column, heights, line, number, rows, times};

/// Check sums in hexadecimal digits, of which some look like numbers or numbers with a unit.
pub fn codes(found: &mut Vec<Variant>) {
    const SUMS: [[&str; 12]; 2] = [
        ["8F97", "3D44", "CFB1", "B3FE", "30BB", "E87C", "0134", "5E69", "90BD", "8A2C", "C67D", "0861"],
        ["97e4", "3d44", "1e05", "b3fe", "30bb", "e87c", "fa28", "5e69", "9c12", "00d4", "1a2b", "86c1"],
    ];
    for sums in SUMS {
        for delimiter in ["\t", ",", ";"] {
            for place in 0..3 {
                let mut heads = vec!["t (s)".to_owned(), "y (cm)".to_owned()];
                heads.insert(place, "CRC16".to_owned());
                let mut text = line(&heads, delimiter);
                for (row, sum) in sums.iter().enumerate() {
                    let mut cells = vec![number(times()[row], false), number(heights(0.0)[row], false)];
                    cells.insert(place, (*sum).to_owned());
                    text += &line(&cells, delimiter);
                }
                let columns = vec![
                    column(None, "t", "s", times()),
                    column(None, "y", "cm", heights(0.0)),
                    column(None, "CRC16", "", Vec::new()),
                ];
                found.push(Variant { kind: "check sums", text, columns });
            }
        }
    }
}

/// Numbered lists of the columns in comments, below settings of the program.
pub fn lists(found: &mut Vec<Variant>) {
    for sign in ["#", "# ", "% "] {
        for settings in ["", "F peak model =\n", "Selected output parameters:\n", "rate = 10, gain = 2\n"] {
            for form in ["N NAME, UNIT", "N: NAME [UNIT]", "N. NAME (UNIT)", "Column N: NAME (UNIT)", "N = NAME [UNIT]"]
            {
                for delimiter in ["\t", " ", ",", ";"] {
                    let entry = |number: usize, name: &str, unit: &str| {
                        let entry = form.replace("NAME", name).replace("UNIT", unit);
                        format!("{sign}{}\n", entry.replacen('N', &number.to_string(), 1))
                    };
                    let head = if settings.is_empty() { String::new() } else { format!("{sign}{settings}") };
                    let text = head
                        + &entry(1, "Height", "km")
                        + &entry(2, "Mass density", "g/cm^3")
                        + &entry(3, "Temperature", "K")
                        + &rows(&[&times(), &heights(0.0), &heights(1.0)], delimiter);
                    let columns = vec![
                        column(None, "Height", "km", times()),
                        column(None, "Mass density", "g/cm^3", heights(0.0)),
                        column(None, "Temperature", "K", heights(1.0)),
                    ];
                    found.push(Variant { kind: "lists of columns", text, columns });
                }
            }
        }
    }
}

/// Columns without names: pairs of a label and a value, with the time at the end.
pub fn clocks(found: &mut Vec<Variant>) {
    for delimiter in ["\t", ",", ";"] {
        for count in [2, 3, 8] {
            let text = times().iter().enumerate().fold(String::new(), |text, (row, time)| {
                let pairs =
                    (0..count).flat_map(|place| [format!("a{place}"), number(heights(place as f64)[row], false)]);
                text + &line(&pairs.chain([number(1000.0 + time, false)]).collect::<Vec<_>>(), delimiter)
            });
            let mut columns: Vec<_> = (0..count).map(|place| column(None, "", "", heights(place as f64))).collect();
            columns.push(column(None, "", "", times().iter().map(|time| 1000.0 + time).collect()));
            found.push(Variant { kind: "a clock at the end", text, columns });
        }
    }
}
