//! Variants of dates whose numbers do not show the order of day and month: refused, and read in the stated order.

use super::heights;
use analysis::import::{self, DateOrder, Refusal};

/// Days and months, both below 13, that fall in either order.
const DATES: [(usize, usize); 6] = [(1, 2), (3, 1), (2, 4), (5, 3), (4, 6), (7, 5)];

#[test]
fn undecidable_dates_are_refused_and_read_in_the_stated_order() {
    let days_of_year = |month: usize, day: usize| {
        const DAYS: [usize; 12] = [31, 29, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];
        DAYS[..month - 1].iter().sum::<usize>() + day
    };
    let mut count = 0;
    for separator in ["/", "-"] {
        for year in ["2024", "24"] {
            for (delimiter, comma) in [("\t", false), (";", true), (",", false), (";", false)] {
                for clock in ["", " 10:00:00", " 10:00", "T10:00:00", ", 10:00:00 AM"] {
                    for (name, padded) in [("date", true), ("Fecha", false), ("", true)] {
                        if delimiter == "," && clock.starts_with(',') {
                            continue;
                        }
                        let part = |number: usize| if padded { format!("{number:02}") } else { number.to_string() };
                        let mut text =
                            if name.is_empty() { String::new() } else { format!("{name}{delimiter}y (cm)\n") };
                        for ((first, second), value) in DATES.iter().zip(heights(0.0)) {
                            let value = format!("{value:.3}");
                            let value = if comma { value.replace('.', ",") } else { value };
                            text += &format!(
                                "{}{separator}{}{separator}{year}{clock}{delimiter}{value}\n",
                                part(*first),
                                part(*second)
                            );
                        }
                        let error = import::text(text.as_bytes()).expect_err(&text);
                        assert!(matches!(error.reason, Refusal::Dates { .. }), "{error}\n{text}");
                        assert!(error.hint(units::Language::English).contains("--dates day-first"));
                        for order in DateOrder::ALL {
                            assert_eq!(DateOrder::from_code(order.code()), Some(order));
                            let day = |(first, second): (usize, usize)| match order {
                                DateOrder::DayFirst => days_of_year(second, first),
                                DateOrder::MonthFirst => days_of_year(first, second),
                            };
                            let stated = import::state_dates(&text, order).expect("one order");
                            let import =
                                import::text(stated.as_bytes()).unwrap_or_else(|error| panic!("{error}\n{text}"));
                            let expected: Vec<f64> = DATES
                                .iter()
                                .map(|date| (day(*date) as f64 - day(DATES[0]) as f64) * 86_400.0)
                                .collect();
                            assert_eq!(import.table.columns[0].values, expected, "{order:?}\n{text}");
                            count += 1;
                        }
                    }
                }
            }
        }
    }
    assert!(count >= 400, "{count}");
}

#[test]
fn only_dates_in_numbers_are_written_in_order() {
    let order = |text: &str, order| import::state_dates(text, order).unwrap_or_else(|error| error.to_string());
    for (text, day_first, month_first) in [
        ("02/03/2024;1\n", "2024-03-02;1\n", "2024-02-03;1\n"),
        ("é 2-3-24 10:00:05.5\t1\n", "é 2024-03-02 10:00:05.5\t1\n", "é 2024-02-03 10:00:05.5\t1\n"),
        // The first date has the day first.
        (
            "t;y\n20/02/2024;1\n02/03/2024;2\n",
            "t;y\n2024-02-20;1\n2024-03-02;2\n",
            "line 2: `20/02/2024` has the day first, and the stated order is the month first",
        ),
        (
            "02/20/2024;1\n",
            "line 1: `02/20/2024` has the month first, and the stated order is the day first",
            "2024-02-20;1\n",
        ),
        ("2024-03-02;1\n", "2024-03-02;1\n", "2024-03-02;1\n"),
        ("02.03.2024;1\n", "02.03.2024;1\n", "02.03.2024;1\n"),
        ("v1/2/2024 1/2/2024/5 1.5 -2/3/2024 32/33/2024", "v1/2/2024 1/2/2024/5 1.5 -2/3/2024 32/33/2024", ""),
    ] {
        let month_first = if month_first.is_empty() { day_first } else { month_first };
        assert_eq!(order(text, DateOrder::DayFirst), day_first);
        assert_eq!(order(text, DateOrder::MonthFirst), month_first);
    }
}
