//! Variants of lines in which each number stands behind its name, as programs of microcontrollers print them.

use super::heights;
use analysis::finding::Finding;
use analysis::import;

#[test]
fn numbers_behind_their_names_are_columns() {
    let mut count = 0;
    for sign in [": ", ":", "=", " = "] {
        for between in [", ", ",", "; ", " | ", "\t", " "] {
            for clock in ["", "10:00:SS -> ", "10:00:SS ", "[2026-01-02 10:00:SS] "] {
                for unit in ["", " cm", "cm"] {
                    for names in [["y", "z"], ["Height", "Depth 2"], ["sensor A", "sensor B"]] {
                        let line = |(row, value): (usize, f64)| {
                            let clock = clock.replace("SS", &format!("{:02}", 10 + row));
                            let [first, second] = names;
                            format!("{clock}{first}{sign}{value:.3}{unit}{between}{second}{sign}{:.3}{unit}\n", -value)
                        };
                        let text: String = heights(0.0).into_iter().enumerate().map(line).collect();
                        let import = import::text(text.as_bytes()).unwrap_or_else(|error| panic!("{error}\n{text}"));
                        assert_eq!(import.findings[0], Finding::Labelled { left_out: 0 }, "{text}");
                        let columns: Vec<_> =
                            import.table.columns.iter().skip(usize::from(!clock.is_empty())).collect();
                        let read: Vec<_> = columns.iter().map(|column| column.name.as_str()).collect();
                        assert_eq!(read, names, "{text}");
                        for column in columns {
                            let own = column.unit.as_ref().map_or("", |unit| unit.text.as_str());
                            assert_eq!(own, unit.trim(), "{text}");
                            assert_eq!(column.values.len(), 12, "{text}");
                        }
                        count += 1;
                    }
                }
            }
        }
    }
    assert!(count > 850, "{count}");
}
