//! Files with headings of many kinds, generated with known truth: names, units, signs, powers of ten, errors. Each must be
//! read right, or the difference reported, or the file refused.

use crate::support::variants::{Truth, Variant, body, check, column, line, over, rows, truth};
use analysis::import;
use units::Language;

/// Names, units and comments in every order, in many forms, with columns of words and without.
fn blocks() -> Vec<Variant> {
    let orders = ["NU", "UN", "NUC", "NCU", "CNU", "CUN", "UNC", "UCN", "NUCC"];
    let names: [[&str; 3]; 4] =
        [["t", "y", "v"], ["Time", "Voltage", "Current"], ["Zeit", "Weg", "Kraft"], ["tiempo", "x", "F"]];
    let units: [[&str; 3]; 3] = [["s", "mm", "mA"], ["ms", "cm", "V"], ["min", "kg", "m/s"]];
    let comments: [[&str; 3]; 4] = [
        ["run1", "run1", "run1"],
        ["raw", "raw", "smoothed"],
        ["device", "left", "right"],
        ["", "measured", "computed"],
    ];
    let forms: [fn(&str) -> String; 7] = [
        |unit| unit.to_owned(),
        |unit| format!("[{unit}]"),
        |unit| format!("({unit})"),
        |unit| format!("in {unit}"),
        |unit| format!("/ {unit}"),
        |unit| format!("<{unit}>"),
        |unit| format!("[in {unit}]"),
    ];
    let delimiters =
        [(",", false), ("\t", false), (";", true), (";", false), (" ", false), ("   ", false), ("|", true)];
    let mut variants = Vec::new();
    for (index, order) in orders.iter().enumerate() {
        for (form, write) in forms.iter().enumerate() {
            let number = index * forms.len() + form;
            let names = names[number % names.len()];
            let units = units[number % units.len()];
            let comments = comments[number % comments.len()];
            let (delimiter, comma) = delimiters[number % delimiters.len()];
            let blank = delimiter.trim().is_empty() && delimiter != "\t";
            // With blanks as delimiters there are no empty cells, so that the position of a column of words is not known.
            let words = if blank { None } else { [None, Some(3), Some(1), Some(0)][(number / 2) % 4] };
            let mut text = String::new();
            for part in order.chars() {
                let (cells, word): (Vec<String>, &str) = match part {
                    'N' => (names.iter().map(|name| (*name).to_owned()).collect(), "Remark"),
                    'U' => (units.iter().map(|unit| write(unit)).collect(), ""),
                    _ => {
                        let filled = |cell: &&str| {
                            if blank && cell.is_empty() { "clock".to_owned() } else { (*cell).to_owned() }
                        };
                        (comments.iter().map(filled).collect(), "")
                    }
                };
                text.push_str(&line(&cells, delimiter, words, word));
            }
            text.push_str(&body(delimiter, words, comma));
            let truth = (0..3).map(|place| truth(names[place], units[place], place)).collect();
            variants.push(Variant {
                kind: format!("block {order} {form} {delimiter:?}"),
                bytes: text.into_bytes(),
                truth,
                clear: true,
            });
        }
    }
    variants
}

/// Tables with one name less than columns, as written by R and pandas.
fn few_names() -> Vec<Variant> {
    let mut variants = Vec::new();
    let index: [fn(usize) -> String; 5] = [
        |row| row.to_string(),
        |row| (row + 1).to_string(),
        |row| format!("row{row}"),
        |row| (2 * row + 7).to_string(),
        |row| format!("\"{}\"", row + 1),
    ];
    for (kind, name) in index.iter().enumerate() {
        for (delimiter, quoted) in [(" ", true), ("\t", true), ("\t", false), ("   ", false), (",", true)] {
            let head = ["time", "y", "v"].map(|name| if quoted { format!("\"{name}\"") } else { name.to_owned() });
            let mut text = format!("{}{}\n", if delimiter == "   " { "    " } else { "" }, head.join(delimiter));
            for (row, values) in rows().iter().enumerate() {
                let cells = values.map(|value| format!("{value:.2}"));
                text.push_str(&format!("{}{delimiter}{}\n", name(row), cells.join(delimiter)));
            }
            let plain = |name, index| Truth { name, unit: None, si: column(index, 1.0) };
            let truth = vec![plain("time", 0), plain("y", 1), plain("v", 2)];
            variants.push(Variant {
                kind: format!("few names {kind} {delimiter:?}"),
                bytes: text.into_bytes(),
                truth,
                clear: true,
            });
        }
    }
    variants
}

/// Powers of ten in headings: heading, factor from the number to the SI value, and true if it is clear.
fn powers() -> Vec<Variant> {
    let mut variants = Vec::new();
    for (shape, sign) in [
        ("10^P v (m/s)", -1),
        ("10^P·v (m/s)", -1),
        ("10^P*v [m/s]", -1),
        ("10^P v / (m/s)", -1),
        ("1eP v (m/s)", -1),
        ("v (10^P m/s)", 1),
        ("v [10^P m/s]", 1),
        ("v (x10^P m/s)", 1),
        ("v (×10^P m/s)", 1),
        ("v (1EP m/s)", 1),
        ("v (10**P m/s)", 1),
        ("v (10^{P} m/s)", 1),
        ("v / 10^P m/s", 1),
        ("v /10^P m/s", 1),
        ("v/(10^P m/s)", 1),
        ("v / (10^P m/s)", 1),
        ("v in 10^P m/s", 1),
        ("v ×10^P m/s", 1),
        ("v x10^P (m/s)", 1),
        ("v x 10^P (m/s)", 1),
        ("v × 10^P [m/s]", 1),
        ("v (m/s) x10^P", 1),
        ("v (m/s x10^P)", 1),
        ("v*10^P (m/s)", 0),
        ("v 10^P (m/s)", 0),
        ("v (10EP m/s)", 0),
    ] {
        for power in [3_i32, -3, -6] {
            let raised = |text: &str| {
                let digits = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶'];
                let size = digits[power.unsigned_abs() as usize];
                text.replace("10^P", &format!("10{}{size}", if power < 0 { "⁻" } else { "" }))
            };
            let heading = if shape.contains("10^P") && power == -6 {
                raised(shape)
            } else {
                shape.replace('P', &power.to_string())
            };
            let delimiter = if power > 0 { "," } else { "\t" };
            let factor = libm::exp10(f64::from(power * sign));
            let truth = vec![Truth { name: "v", unit: Some("m/s"), si: column(1, factor) }];
            variants.push(Variant { kind: heading.clone(), bytes: over(&heading, delimiter), truth, clear: sign != 0 });
        }
    }
    for (heading, factor, clear) in [
        ("1000*v (m/s)", 1e-3, true),
        ("1000·v (m/s)", 1e-3, true),
        ("v/1000 (m/s)", 1e3, true),
        ("v (x1000 m/s)", 1e3, true),
        ("v*1000 (m/s)", 1e-3, false),
        ("v x1000 (m/s)", 1e3, false),
        ("v (1000 m/s)", 1e3, false),
        ("1000 v (m/s)", 1e-3, false),
    ] {
        let truth = vec![Truth { name: "v", unit: Some("m/s"), si: column(1, factor) }];
        variants.push(Variant { kind: heading.to_owned(), bytes: over(heading, ","), truth, clear });
    }
    variants
}

/// Units that depend on the name, temperatures, units that are not known.
fn units() -> Vec<Variant> {
    let mut variants = Vec::new();
    let celsius: Vec<f64> = column(1, 1.0).iter().map(|value| value + 273.15).collect();
    let fahrenheit: Vec<f64> = column(1, 1.0).iter().map(|value| (value + 459.67) * 5.0 / 9.0).collect();
    let mut push = |heading: &str, name: &'static str, unit: Option<&'static str>, si: Vec<f64>| {
        let truth = vec![Truth { name, unit, si }];
        variants.push(Variant { kind: heading.to_owned(), bytes: over(heading, ";"), truth, clear: true });
    };
    for heading in
        ["T (°C)", "T [°C]", "T (ºC)", "T (C)", "T / °C", "T in °C", "T (degC)", "T (deg C)", "T (Celsius)", "T (℃)"]
    {
        push(heading, "T", Some("K"), celsius.clone());
    }
    push("Temperature (°C)", "Temperature", Some("K"), celsius.clone());
    push("Temp (C)", "Temp", Some("K"), celsius.clone());
    push("Temperatura (°C)", "Temperatura", Some("K"), celsius.clone());
    push("T_room (C)", "T_room", Some("K"), celsius);
    push("T (°F)", "T", Some("K"), fahrenheit);
    push("ΔT (°C)", "ΔT", Some("K"), column(1, 1.0));
    push("Temperature difference (°C)", "Temperature difference", Some("K"), column(1, 1.0));
    push("rate (°C/min)", "rate", Some("K/min"), column(1, 1.0 / 60.0));
    for (heading, name) in [("a (g)", "a"), ("ax (g)", "ax"), ("Acceleration (g)", "Acceleration"), ("a_y (G)", "a_y")]
    {
        push(heading, name, Some("m/s^2"), column(1, 9.80665));
    }
    push("m (g)", "m", Some("g"), column(1, 1e-3));
    push("B (G)", "B", Some("T"), column(1, 1e-4));
    push("Q (C)", "Q", Some("C"), column(1, 1.0));
    push("T (S)", "T", Some("s"), column(1, 1.0));
    push("Period (S)", "Period", Some("s"), column(1, 1.0));
    push("G (S)", "G", Some("S"), column(1, 1.0));
    push("h (in)", "h", Some("m"), column(1, 0.0254));
    push("h (ft)", "h", Some("m"), column(1, 0.3048));
    push("h [inches]", "h", Some("m"), column(1, 0.0254));
    push("E (lx)", "E", Some("lx"), column(1, 1.0));
    push("p (%)", "p", Some("%"), column(1, 0.01));
    // An unknown unit leaves the name.
    for heading in ["L (dB)", "L [dB]", "L (a.u.)", "L (blips)", "L (counts)"] {
        push(heading, "L", None, column(1, 1.0));
    }
    push("acidity (pH)", "acidity", None, column(1, 1.0));
    push("V_in", "V_in", None, column(1, 1.0));
    push("x10 (cm)", "x10", Some("cm"), column(1, 0.01));
    // An ambiguous power leaves no unit, and this is reported.
    for heading in ["x (C)", "x (S)", "T (deg)"] {
        let name = if heading.starts_with('x') { "x" } else { "T" };
        push(heading, name, None, column(1, 1.0));
    }
    variants
}

/// Signs in numbers, with each delimiter.
fn signs() -> Vec<Variant> {
    let mut variants = Vec::new();
    let large: Vec<f64> = (0..12).map(|row| (1010.0 + 300.0 * libm::cos(0.5 * f64::from(row))).round()).collect();
    let grouped = |value: f64, sign: &str| {
        let whole = value as u32;
        if whole < 1000 { whole.to_string() } else { format!("{}{sign}{:03}", whole / 1000, whole % 1000) }
    };
    for (delimiter, sign, quote) in [
        (";", ",", ""),
        ("\t", ",", ""),
        (";", ".", ""),
        ("\t", ".", ""),
        (",", ",", "\""),
        (",", ".", "\""),
        ("|", ",", ""),
        (";", ",", "\""),
    ] {
        for decimals in ["", "40"] {
            let point = if sign == "," { "." } else { "," };
            let mut text = format!("t [s]{delimiter}y [mm]\n");
            for (row, value) in large.iter().enumerate() {
                let fraction = if decimals.is_empty() { String::new() } else { format!("{point}{decimals}") };
                text.push_str(&format!("{row}{delimiter}{quote}{}{fraction}{quote}\n", grouped(*value, sign)));
            }
            let added = if decimals.is_empty() { 0.0 } else { 0.4 };
            let si = large.iter().map(|value| (value + added) / 1000.0).collect();
            let truth = vec![Truth { name: "y", unit: Some("mm"), si }];
            variants.push(Variant {
                kind: format!("thousands {delimiter:?} {sign} {quote} {decimals}"),
                bytes: text.into_bytes(),
                truth,
                clear: true,
            });
        }
    }
    variants
}

#[test]
fn names_units_and_comments_may_stand_in_any_order() {
    check("header lines", blocks(), 60);
}

#[test]
fn a_first_column_without_a_name_is_known() {
    check("one name less", few_names(), 25);
}

#[test]
fn powers_of_ten_are_applied_or_said() {
    check("powers of ten", powers(), 80);
}

#[test]
fn units_are_those_that_the_name_allows() {
    check("units", units(), 44);
}

#[test]
fn thousands_are_read_as_their_column_shows() {
    check("thousands", signs(), 16);
}

#[test]
fn errors_are_recognised_or_said_not_to_be() {
    let file = |name: &str, cells: &str| {
        let mut text = format!("t [s],y [mm],{name}\n");
        for row in rows() {
            text.push_str(&format!("{:.2},{:.2},{cells}\n", row[0], row[1]));
        }
        import::text(text.as_bytes()).expect("a table")
    };
    for name in [
        "sigma_y",
        "σ_y [mm]",
        "u(y) [mm]",
        "err_y",
        "y_err",
        "y error (mm)",
        "yerr",
        "dy (mm)",
        "Δy [mm]",
        "±",
        "Error",
        "incertidumbre de y",
    ] {
        let import = file(name, "0.05");
        assert_eq!(import.table.errors_of(1), Some(2), "{name}");
    }
    for (name, cells) in
        [("dy", "-0.3"), ("Δy [mm]", "400"), ("sigma_y [kg]", "0.1"), ("sigma_x", "0.1"), ("sigma_t", "0.01")]
    {
        let import = file(name, cells);
        assert_eq!(import.table.errors_of(1), None, "{name}");
        let column = import.table.label(2);
        let said = import.findings.iter().any(|finding| finding.text(Language::English).starts_with(&column));
        assert!(said, "{name}: {:?}", import.findings);
    }
}

#[test]
fn cells_with_units_count_in_theirs() {
    let read = |text: &str| import::text(text.as_bytes()).expect("a table");
    let import = read("t (s),p (%)\n0,5 %\n1,6\n2,7 %\n3,8\n4,9\n");
    assert_eq!(import.table.columns[1].si(None), [0.05, 0.06, 0.07, 0.08, 0.09]);
    assert_eq!(import.findings, []);
    let import = read("t (s),y (mm)\n0,5 cm\n1,6 cm\n2,7 cm\n");
    assert_eq!(import.table.columns[1].si(None), [0.05, 0.06, 0.07]);
    assert!(import.findings[0].text(Language::English).contains("the header says mm, the cells say cm"));
    let import = read("t (s),T\n0,21.5 °C\n1,22.5 °C\n");
    assert_eq!(import.table.columns[1].si(None), [294.65, 295.65]);
    let import = read("t (s),p\n0,5 %\n1,0.06\n2,7 %\n");
    assert!(import.findings[0].text(Language::English).contains("1 cells have no unit"));
}

#[test]
fn days_that_do_not_exist_are_no_dates() {
    let read = |day: &str| import::text(format!("date,y\n2026-02-27,1\n{day},2\n2026-03-01,3\n").as_bytes());
    assert!(read("2026-02-28").is_ok_and(|import| import.table.columns[0].filled() == 3));
    for day in ["2026-02-29", "2026-02-31", "2026-04-31"] {
        let import = read(day).expect("a table");
        assert_eq!(import.table.columns[0].filled(), 2, "{day}");
        assert!(import.findings.iter().any(|finding| finding.text(Language::English).contains(day)), "{day}");
    }
}

#[test]
fn conversions_can_be_undone() {
    for (heading, places) in
        [("T (°C)", 12), ("T (°F)", 12), ("a (g)", 12), ("a (mg)", 12), ("10^3 v (m/s)", 15), ("v (10^-6 m/s)", 15)]
    {
        let import = import::text(&over(heading, ";")).expect("a table");
        let found = &import.table.columns[1];
        let conversion = found.origin.conversion.expect("a conversion");
        let back: Vec<f64> = found.values.iter().map(|value| conversion.number(*value)).collect();
        let close = |(one, other): (&f64, &f64)| (one - other).abs() <= libm::exp10(-f64::from(places)) * 1e3;
        assert!(back.iter().zip(&column(1, 1.0)).all(close), "{heading}: {back:?}");
    }
}

#[test]
fn bytes_are_those_of_windows() {
    let text: Vec<u8> = [b"t (s);y\x80\x96\x99 (\xb5m)\n".as_slice(), b"0;1\n1;2\n"].concat();
    let import = import::text(&text).expect("a table");
    assert_eq!(import.table.columns[1].name, "y€–™");
    assert_eq!(import.table.columns[1].unit.as_ref().map(|unit| unit.factor), Some(1e-6));
}

#[test]
fn a_refusal_names_the_cell() {
    let text = "t (s),y (mm)\n0.00,8_152.40\n0.04,7_687.90\n";
    let error = import::text(text.as_bytes()).expect_err("no numbers");
    assert_eq!(
        error.message(Language::English),
        "line 2: column 2: `8_152.40` is not a number, and no line has two numbers"
    );
}
