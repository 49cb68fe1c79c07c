//! Files of measuring instruments in many variants, with the columns that a person reads in them.

use std::fmt::Write as _;

/// Number of rows of a file.
const ROWS: usize = 40;

/// Variant of a file with the columns that a person reads in it.
pub struct Variant {
    pub name: String,
    pub text: String,
    /// Name, unit and values of each column; the first holds the times.
    pub columns: Vec<(String, String, Vec<f64>)>,
}

/// Settings of a measurement.
#[derive(Clone, Copy, Debug)]
pub struct Measurement {
    channels: usize,
    step: f64,
    start: f64,
    /// Unit as the instrument writes it, and its symbol.
    unit: (&'static str, &'static str),
    /// Number of further lines of settings.
    more: usize,
}

const MEASUREMENTS: [Measurement; 6] = [
    Measurement { channels: 1, step: 2e-5, start: -1e-3, unit: ("V", "V"), more: 0 },
    Measurement { channels: 2, step: 0.04, start: 0.0, unit: ("V", "V"), more: 3 },
    Measurement { channels: 2, step: 5e-7, start: 2.5e-3, unit: ("A", "A"), more: 1 },
    Measurement { channels: 3, step: 1e-3, start: -0.5, unit: ("mV", "mV"), more: 7 },
    Measurement { channels: 4, step: 0.25, start: 0.0, unit: ("V", "V"), more: 20 },
    Measurement { channels: 1, step: 4e-9, start: -8e-8, unit: ("A", "A"), more: 2 },
];

impl Measurement {
    fn time(self, row: usize) -> f64 {
        self.start + row as f64 * self.step
    }

    /// Value with five digits, as written in the file.
    fn value(self, channel: usize, row: usize) -> f64 {
        let value = libm::sin(0.3 * row as f64 + channel as f64) * (1.0 + channel as f64);
        (value * 1e5).round() / 1e5
    }

    /// Columns with times from the step.
    fn columns(self, time: &str, name: impl Fn(usize) -> String) -> Vec<(String, String, Vec<f64>)> {
        let mut columns =
            vec![(time.to_owned(), "s".to_owned(), (0..ROWS).map(|row| self.time(row)).collect::<Vec<f64>>())];
        columns.extend((0..self.channels).map(|channel| {
            let values = (0..ROWS).map(|row| self.value(channel, row)).collect();
            (name(channel), self.unit.1.to_owned(), values)
        }));
        columns
    }

    /// Further settings with numbers, as `key` delimiter `value`.
    fn settings(self, delimiter: &str) -> String {
        (0..self.more).map(|line| format!("Setting {line}{delimiter}{}\n", 10 * line)).collect()
    }
}

fn channel(channel: usize) -> String {
    format!("CH{}", channel + 1)
}

/// Cells of a row of values, each with the delimiter in front.
fn values(of: Measurement, row: usize, delimiter: &str) -> String {
    (0..of.channels).map(|channel| format!("{delimiter}{:.5}", of.value(channel, row))).collect()
}

/// `count` copies of a cell, each with the delimiter in front.
fn repeated(cell: &str, count: usize, delimiter: &str) -> String {
    format!("{delimiter}{cell}").repeat(count)
}

fn rigol(of: Measurement, delimiter: &str, counted: bool) -> Variant {
    let names: String = (0..of.channels).map(|place| format!("{delimiter}{}", channel(place))).collect();
    let word = if of.unit.0 == "A" { "Ampere" } else { "Volt" };
    let unit = if of.unit.0 == "mV" { "mV" } else { word };
    let count =
        |text: &str, line: String| if counted { format!("{text}{line}") } else { line[delimiter.len()..].to_owned() };
    let mut text = count("X", format!("{names}{delimiter}Start{delimiter}Increment{delimiter}\n"));
    text += &count(
        "Sequence",
        format!("{}{delimiter}{:e}{delimiter}{:e}\n", repeated(unit, of.channels, delimiter), of.start, of.step),
    );
    for row in 0..ROWS {
        text += &count(&row.to_string(), format!("{}{delimiter}\n", values(of, row, delimiter)));
    }
    Variant { name: format!("Rigol {delimiter:?}, rows counted: {counted}"), text, columns: of.columns("t", channel) }
}

fn rigol_new(of: Measurement) -> Variant {
    let names: String = (0..of.channels).map(|place| format!("{}({}),", channel(place), of.unit.0)).collect();
    let mut text = format!("{names}t0 ={:e}, tInc = {:e},\n", of.start, of.step);
    for row in 0..ROWS {
        let _ = writeln!(text, "{},", values(of, row, ",").trim_start_matches(','));
    }
    Variant { name: "Rigol, t0 and tInc".to_owned(), text, columns: of.columns("t", channel) }
}

/// Tektronix TDS: channels of 5 cells, or of 6 with an empty one.
fn tektronix(of: Measurement, delimiter: &str, empty: bool) -> Variant {
    let mut settings: Vec<Vec<String>> = Vec::new();
    let mut add = |key: &str, value: &dyn Fn(usize) -> String| {
        let line = (0..of.channels).map(|place| format!("{key}{delimiter}{}", value(place))).collect();
        settings.push(line);
    };
    add("Record Length", &|_| format!("{:e}", ROWS as f64));
    add("Sample Interval", &|_| format!("{:e}", of.step));
    add("Trigger Point", &|_| "1.13e+03".to_owned());
    add("", &|_| String::new());
    add("Source", &channel);
    add("Vertical Units", &|_| of.unit.0.to_owned());
    add("Vertical Scale", &|_| "5.0e-02".to_owned());
    add("Horizontal Units", &|_| "s".to_owned());
    add("Probe Atten", &|_| "1.0e+00".to_owned());
    let mut text = String::new();
    for row in 0..ROWS {
        let own = settings.get(row).cloned().unwrap_or_else(|| vec![delimiter.to_owned(); of.channels]);
        for (place, settings) in own.iter().enumerate() {
            text.push_str(if empty && place > 0 { delimiter } else { "" });
            let _ = write!(
                text,
                "{settings}{delimiter}{delimiter}  {:e}{delimiter}  {:.5}{delimiter}",
                of.time(row),
                of.value(place, row)
            );
        }
        text.push('\n');
    }
    Variant { name: format!("Tektronix {delimiter:?}"), text, columns: of.columns("t", channel) }
}

fn tektronix_new(of: Measurement) -> Variant {
    let names: String = (0..of.channels).map(|place| format!(",{}", channel(place))).collect();
    let mut text = format!("Model,MSO54\nFirmware Version,1.52\n\nHorizontal Units,s\nSample Interval,{:e}\n", of.step);
    text.push_str(&of.settings(","));
    let _ = writeln!(text, "Vertical Units{}\n\nTIME{names}", repeated(of.unit.0, of.channels, ","));
    for row in 0..ROWS {
        let _ = writeln!(text, "{:e}{}", of.time(row), values(of, row, ","));
    }
    Variant { name: "Tektronix MSO".to_owned(), text, columns: of.columns("TIME", channel) }
}

/// LabVIEW: `columns` is `No`, `One` or `Multi`.
fn labview(of: Measurement, columns: &str, separator: &str, decimal: &str) -> Variant {
    let (multi, none) = (columns == "Multi", columns == "No");
    let tab = if separator == "Tab" { "\t" } else { "," };
    let per_channel = |cell: &dyn Fn(usize) -> String| -> String {
        let own = |place: usize| {
            if multi && place > 0 { format!("{tab}{tab}{}", cell(place)) } else { format!("{tab}{}", cell(place)) }
        };
        (0..of.channels).map(own).collect()
    };
    let name = |place: usize| format!("Voltage {place}");
    let mut text = format!(
        "LabVIEW Measurement{tab}\nWriter_Version{tab}2\nReader_Version{tab}2\nSeparator{tab}{separator}\nDecimal_Separator{tab}{decimal}\nMulti_Headings{tab}Yes\nX_Columns{tab}{columns}\nTime_Pref{tab}Relative\n"
    );
    text.push_str(&of.settings(tab));
    let _ = writeln!(text, "***End_of_Header***{tab}\n{tab}\nChannels{tab}{}{tab}", of.channels);
    let number = |value: f64| format!("{value:.16E}").replace('.', decimal);
    let units = if of.unit.0 == "V" { "Volts" } else { of.unit.0 };
    let _ = writeln!(text, "Samples{}", per_channel(&|_| ROWS.to_string()));
    let _ = writeln!(text, "Y_Unit_Label{}", per_channel(&|_| units.to_owned()));
    let _ = writeln!(text, "X_Dimension{}", per_channel(&|_| "Time".to_owned()));
    let _ = writeln!(text, "X0{}", per_channel(&|_| number(of.start)));
    let _ = writeln!(text, "Delta_X{}", per_channel(&|_| number(of.step)));
    let names: String = (0..of.channels)
        .map(|place| {
            if multi && place > 0 {
                format!("{tab}X_Value{tab}{}", name(place))
            } else {
                format!("{tab}{}", name(place))
            }
        })
        .collect();
    let _ = writeln!(text, "***End_of_Header***{tab}{tab}\nX_Value{names}{tab}Comment");
    for row in 0..ROWS {
        let time = if none { String::new() } else { number(of.time(row)) };
        let mut line = time.clone();
        for place in 0..of.channels {
            if multi && place > 0 {
                line.push_str(&format!("{tab}{time}"));
            }
            line.push_str(&format!("{tab}{}", format!("{:.5}", of.value(place, row)).replace('.', decimal)));
        }
        if row == 0 {
            line.push_str(&format!("{tab}start of run"));
        }
        text.push_str(&line);
        text.push('\n');
    }
    Variant { name: format!("LabVIEW {columns} {separator} {decimal:?}"), text, columns: of.columns("t", name) }
}

fn owon(of: Measurement) -> Variant {
    let names: String = (0..of.channels).map(|place| format!(",{}_Voltage({})", channel(place), of.unit.0)).collect();
    let channels: String = (0..of.channels).map(|place| format!(",{}", channel(place))).collect();
    let mut text = format!("Channel\t\t\t  :{channels}\nFrequency\t\t\t  :,F=  ?\nPeriod \t\t\t  :,T=  ?\n");
    text.push_str(&of.settings(":,"));
    let _ = writeln!(text, "Time interval\t\t  :,{}uS\n\nindex{names}", of.step * 1e6);
    for row in 0..ROWS {
        let _ = writeln!(text, "{row}{}", values(of, row, ","));
    }
    let mut columns = Measurement { start: 0.0, ..of }.columns("t", |place| format!("{}_Voltage", channel(place)));
    columns[0].1 = "us".to_owned();
    columns[0].2 = (0..ROWS).map(|row| row as f64 * of.step * 1e6).collect();
    Variant { name: "OWON".to_owned(), text, columns }
}

fn hantek(of: Measurement) -> Variant {
    let mut text = String::new();
    for place in 0..of.channels {
        let _ = writeln!(
            text,
            "#CHANNEL:{}\n#CLOCK={}uS\n#SIZE={ROWS}\n#UNITS:{}\n",
            channel(place),
            of.step * 1e6,
            of.unit.0
        );
        for row in 0..ROWS {
            let _ = writeln!(text, "{:.5}", of.value(place, row));
        }
        text.push_str("\n\n");
    }
    let mut columns = Measurement { start: 0.0, ..of }.columns("t", channel);
    columns[0].1 = "us".to_owned();
    columns[0].2 = (0..ROWS).map(|row| row as f64 * of.step * 1e6).collect();
    Variant { name: "Hantek".to_owned(), text, columns }
}

fn instek(of: Measurement, mode: &str) -> Variant {
    let detail = mode == "Detail";
    let line = |key: &str, value: &dyn Fn(usize) -> String| -> String {
        (0..of.channels).map(|place| format!("{key},{},", value(place))).collect::<String>() + "\n"
    };
    let mut text = line("Format", &|_| "1.0B".to_owned()) + &line("Memory Length", &|_| ROWS.to_string());
    text += &line("Source", &channel);
    text += &line("Vertical Units", &|_| of.unit.0.to_owned());
    text += &line("Vertical Scale", &|_| "2.0E+0".to_owned());
    text += &line("Horizontal Units", &|_| "S".to_owned());
    for place in 0..of.more {
        text += &line(&format!("Setting {place}"), &|_| "7".to_owned());
    }
    text += &line("Sampling Period", &|_| format!("{:E}", of.step));
    text += &line("Mode", &|_| mode.to_owned());
    text += &line("Waveform Data", &|_| String::new());
    let counts = |place: usize, row: usize| (of.value(place, row) * 12.5).round();
    for row in 0..ROWS {
        for place in 0..of.channels {
            let _ = if detail {
                write!(text, "{:E},{:E},", row as f64 * of.step, of.value(place, row))
            } else {
                write!(text, "{},,", counts(place, row))
            };
        }
        text.push('\n');
    }
    let mut columns = Measurement { start: 0.0, ..of }.columns("t", channel);
    if !detail {
        for (place, column) in columns.iter_mut().skip(1).enumerate() {
            column.2 = (0..ROWS).map(|row| counts(place, row) * 2.0 / 25.0).collect();
        }
    }
    Variant { name: format!("GW Instek {mode}"), text, columns }
}

fn yokogawa(of: Measurement, quote: &str, empty: &str) -> Variant {
    let names: String = (0..of.channels).map(|place| format!(",{quote}{}{quote}", channel(place))).collect();
    let mut text = format!("{quote}Header Size{quote},16\n{quote}Model Name{quote},{quote}DLM3054{quote}\n");
    text.push_str(&of.settings(","));
    let key = |text: &str| format!("{quote}{text}{quote}");
    let _ = writeln!(text, "{}{names}", key("TraceName"));
    let _ = writeln!(text, "{}{}", key("BlockSize"), repeated(&ROWS.to_string(), of.channels, ","));
    let _ = writeln!(text, "{}{}", key("VUnit"), repeated(&key(of.unit.0), of.channels, ","));
    let _ = writeln!(text, "{}{}", key("HResolution"), repeated(&format!("{:E}", of.step), of.channels, ","));
    let _ = writeln!(text, "{}{}", key("HOffset"), repeated(&format!("{:E}", of.start), of.channels, ","));
    let _ = writeln!(text, "{}{}\n", key("HUnit"), repeated(&key("s"), of.channels, ","));
    for row in 0..ROWS {
        let _ = writeln!(text, "{empty}{}", values(of, row, ",").trim_start_matches(','));
    }
    Variant { name: format!("Yokogawa {quote:?} {empty:?}"), text, columns: of.columns("t", channel) }
}

fn keysight(of: Measurement, with_times: bool) -> Variant {
    let of = Measurement { channels: 1, ..of };
    let unit = if of.unit.0 == "V" { "Volt" } else { of.unit.0 };
    let mut text = format!("Revision:,0\nType:,raw\nStart:,0\nPoints:,{ROWS}\n");
    text.push_str(&of.settings(":,"));
    let _ = writeln!(
        text,
        "XInc:,{:e}\nXOrg:,{:e}\nYInc:,0.001\nXUnits:,second\nYUnits:,{unit}\nData:,",
        of.step, of.start
    );
    for row in 0..ROWS {
        let time = if with_times { format!("{:+E},", of.time(row)) } else { String::new() };
        let _ = writeln!(text, "{time}{:+.5E}", of.value(0, row));
    }
    Variant { name: format!("Keysight, times {with_times}"), text, columns: of.columns("t", |_| String::new()) }
}

fn siglent(of: Measurement) -> Variant {
    let names: String = (0..of.channels).map(|place| format!(",{}", channel(place))).collect();
    let unit = if of.unit.0 == "V" { "Volt" } else { of.unit.0 };
    let mut text = format!("Record Length,Analog:{ROWS}\nSample Interval,Analog:{:e}\n", of.step);
    text.push_str(&of.settings(","));
    let _ = writeln!(text, "Source{names}\nSecond{}", repeated(unit, of.channels, ","));
    for row in 0..ROWS {
        let _ = writeln!(text, "{:e}{}", of.time(row), values(of, row, ","));
    }
    Variant { name: "Siglent".to_owned(), text, columns: of.columns("t", channel) }
}

fn vernier(of: Measurement, decimal: &str) -> Variant {
    let name = |place: usize| format!("Potential {place}");
    let names: String = (0..of.channels).map(|place| format!("\t{}", name(place))).collect();
    let mut text = format!("Vernier Format 2\nUntitled.txt 8/5/2024 10:10:01 .\nRun 1\nTime{names}\n");
    let _ = writeln!(text, "t{}\ns{}\n", repeated("U", of.channels, "\t"), repeated(of.unit.0, of.channels, "\t"));
    for row in 0..ROWS {
        let line = format!("{:.9}{}", of.time(row), values(of, row, "\t"));
        let _ = writeln!(text, "{}", line.replace('.', decimal));
    }
    Variant { name: format!("Vernier {decimal:?}"), text, columns: of.columns("Time", name) }
}

fn matlab(of: Measurement, exponent: i32) -> Variant {
    let scale = libm::pow(10.0, f64::from(exponent));
    let mut text = format!("\nA =\n\n   1.0e{exponent:+03} *\n\n");
    let shown = |value: f64| format!("{:.9}", value / scale);
    for row in 0..ROWS {
        let _ = write!(text, "    {}", shown(of.time(row)));
        for place in 0..of.channels {
            let _ = write!(text, "   {}", shown(of.value(place, row)));
        }
        text.push('\n');
    }
    let rounded = |value: f64| (value / scale * 1e9).round() / 1e9 * scale;
    let mut columns = of.columns("", |_| String::new());
    columns.iter_mut().for_each(|(_, unit, values)| {
        unit.clear();
        values.iter_mut().for_each(|value| *value = rounded(*value));
    });
    Variant { name: format!("MATLAB 10^{exponent}"), text, columns }
}

/// All variants.
pub fn variants() -> Vec<Variant> {
    let mut all = Vec::new();
    for of in MEASUREMENTS {
        all.extend([
            rigol(of, ",", true),
            rigol(of, ";", true),
            rigol(of, ",", false),
            rigol(of, "\t", false),
            rigol_new(of),
        ]);
        all.extend([tektronix(of, ",", true), tektronix(of, ",", false), tektronix(of, "\t", true), tektronix_new(of)]);
        for columns in ["No", "One", "Multi"] {
            all.extend([
                labview(of, columns, "Tab", ","),
                labview(of, columns, "Tab", "."),
                labview(of, columns, "Comma", "."),
            ]);
        }
        all.extend([owon(of), hantek(of), instek(of, "Detail"), instek(of, "Fast")]);
        all.extend([yokogawa(of, "\"", ""), yokogawa(of, "", ""), yokogawa(of, "", ",")]);
        all.extend([keysight(of, true), keysight(of, false), siglent(of)]);
        all.extend([vernier(of, "."), vernier(of, ",")]);
        all.extend([matlab(Measurement { step: 0.25, ..of }, 3), matlab(Measurement { step: 0.25, ..of }, -2)]);
    }
    all
}
