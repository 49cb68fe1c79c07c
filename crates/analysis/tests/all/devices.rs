//! Files of instruments and programs that differ from plain tables: sections, settings, JSON, counters, NUL bytes.

use crate::import::{read, shown};
use crate::support::packed::{self, Pack};
use analysis::import;
use analysis::reading;
use units::Language;

/// Name, text of the file, and its reading.
type Case = (&'static str, &'static str, &'static str);

const CASES: &[Case] = &[
    (
        "LabVIEW: each header begins a run, and a remark is no row",
        "LabVIEW Measurement\t\nSeparator\tTab\nX_Columns\tOne\n***End_of_Header***\t\n\t\nChannels\t1\t\nSamples\t3\t\nY_Unit_Label\tVolts\t\nX0\t0.0\t\nDelta_X\t0.1\t\n***End_of_Header***\t\t\nX_Value\tU\tComment\n0.0\t1.5\tstart\n0.1\t1.25\n0.2\t1.0\n\t\nChannels\t1\t\nY_Unit_Label\tVolts\t\n***End_of_Header***\t\t\nX_Value\tU\tComment\n0.0\t2.5\n0.1\t2.25\n",
        "tabs, decimal point, 12 header lines
*Run 1.t [s]=0 0.1 0.2
1:Run 1.U [V]=1.5 1.25 1
*Run 2.t [s]=0 0.1 ·
3:Run 2.U [V]=2.5 2.25 ·
! the file was read as a file of LabVIEW, with the settings of its header
! column Comment holds words and was left out
! there are 2 runs, each with its own clock: Run 1, Run 2; a column is named with its run, `Run 2.y`",
    ),
    (
        "LabVIEW: a header in the middle of a record does not divide it",
        "LabVIEW Measurement\t\nX_Columns\tOne\n***End_of_Header***\t\nChannels\t1\t\n***End_of_Header***\t\nX_Value\tU\n0.0\t1.5\n0.5\t1.25\nChannels\t1\t\n***End_of_Header***\t\nX_Value\tU\n1.0\t1.0\n1.5\t0.75\n",
        "tabs, decimal point, 6 header lines
*t [s]=0 0.5 1 1.5
1:U=1.5 1.25 1 0.75
! the file was read as a file of LabVIEW, with the settings of its header",
    ),
    (
        "LabVIEW: channels with different steps have times of their own",
        "LabVIEW Measurement\t\nX_Columns\tNo\nDecimal_Separator\t,\n***End_of_Header***\t\nChannels\t2\t\nY_Unit_Label\tN\tm/s^2\t\nX0\t0,0\t0,0\t\nDelta_X\t0,5\t1,0\t\n***End_of_Header***\t\nX_Value\tF\ta\n\t1,5\t3,25\n\t1,25\t3,5\n",
        "tabs, decimal comma, 10 header lines
*1.t [s]=0 0.5
1:1.F [N]=1.5 1.25
*2.t [s]=0 1
3:2.a [m/s^2]=3.25 3.5
! the file was read as a file of LabVIEW, with the settings of its header
! the times are from the header's increment of 0.5 s, from 0 s on
! the times are from the header's increment of 1 s, from 0 s on
! there are 2 independent variables, each with its own columns: 1.t for F; 2.t for a",
    ),
    (
        "Hantek: channels one after the other",
        "#CHANNEL:CH1\n#CLOCK=20.0uS\n#SIZE=2\n#UNITS:V\n\n-1.5\n0.9\n\n#CHANNEL:CH2\n#CLOCK=20.0uS\n#SIZE=2\n#UNITS:mV\n\n2.5\n2.6\n",
        "blanks, decimal point, 5 header lines
*t [us]=0 20
1:CH1 [V]=-1.5 0.9
1:CH2 [mV]=2.5 2.6
! the file was read as a file of Hantek, with the settings of its header
! the times are from the header's increment of 20 us, from 0 us on",
    ),
    (
        "OWON without a step: an index is no time",
        "Unit:(mV)\n,CH1\nFrequency,866.567 Hz\nPeriod,1.154 ms\n1,10480.00\n2,10470.00\n3,10460.00\n",
        "commas, decimal point, 4 header lines
*index []=1 2 3
1:CH1 [mV]=10480 10470 10460
! the file was read as a file of OWON, with the settings of its header
! the header states no time between two rows: the rows are counted by `index`, which is no time; export the file again with times",
    ),
    (
        "NI ELVIS: times of day that are rounded to microseconds",
        "waveform,V_S,V_C\nt0,5/7/2021  12:20:53.830937,5/7/2021  12:20:53.830938\ndelta t,1.5E-6,1.5E-6\n\ntime,V_S,V_C\n5/7/2021  12:20:53.830937,0.0E+0,2.0E+0\n5/7/2021  12:20:53.830938,1.0E-1,1.5E+0\n",
        "commas, decimal point, 5 header lines
*t [s]=0 0.0000015
1:V_S=0 0.1
1:V_C=2 1.5
! the file was read as a file of NI ELVIS, with the settings of its header
! the times are from the header's increment of 1.5×10⁻⁶ s, from 0 s on; the first column only counts the rows",
    ),
    (
        "CASSY Lab: limits above the names are no rows",
        "MIN=0\t-1\nMAX=10\t1\nSCALE=10\t0,5\nDEC=1\t3\nDEF=\"Zeit\" t / s\t\"Weg\" s_A1 / m\n0,0\t0,1\n0,1\t0,2\n",
        "tabs, decimal comma, 5 header lines
*t [s]=0 0.1
1:s_A1 [m]=0.1 0.2
! the file was read as a file of CASSY Lab, with the settings of its header",
    ),
    (
        "Vernier: two runs with names, symbols and units",
        "Vernier Format 2\nUntitled.txt 8/5/2024 10:10:01 .\nRun 1\nTime\tPotential\nt\tU\ns\tmV\n\n0.0\t3.5\n0.5\t2.5\n\nRun 2\nTime\tPotential\nt\tU\ns\tmV\n\n0.0\t4.5\n0.5\t3.5\n",
        "tabs, decimal point, 7 header lines
*Run 1.Time [s]=0 0.5
1:Run 1.Potential [mV]=3.5 2.5
*Run 2.Time [s]=0 0.5
3:Run 2.Potential [mV]=4.5 3.5
! the file was read as a file of Vernier, with the settings of its header
! there are 2 runs, each with its own clock: Run 1, Run 2; a column is named with its run, `Run 2.y`",
    ),
    (
        "Vernier: no symbols between names and units",
        "Vernier Format 2\nUntitled.txt 8/5/2024 10:10:01 .\nRun 1\nTime\tPotential\n\t\ns\tmV\n\n0,0\t3,5\n0,5\t2,5\n",
        "tabs, decimal comma, 7 header lines
*Time [s]=0 0.5
1:Potential [mV]=3.5 2.5
! the file was read as a file of Vernier, with the settings of its header",
    ),
    (
        "MATLAB: the factor holds for all columns of a matrix",
        "A =\n\n   1.0e+03 *\n\n  Columns 1 through 2\n\n    0.0010    0.0020\n    0.0030    0.0041\n\n  Columns 3 through 4\n\n    0.0050    0.0060\n    0.0070    0.0083\n",
        "blanks, decimal point, 6 header lines
*=1 3
1:=2 4.1
1:=5 7
1:=6 8.3
! the file was read as a file of MATLAB, with the settings of its header
! all numbers were multiplied by 1.0e+03, as the line above them states",
    ),
    (
        "MakeCode: times of arrival are in seconds",
        "sep=\t\ntime (source1)\tx\ttime (source1)\ty\n0.002\t0\t0.004\t500\n0.052\t199\t0.054\t490\n",
        "tabs, decimal point, 2 header lines
*1.time [s]=0.002 0.052
1:1.x=0 199
*2.time [s]=0.004 0.054
3:2.y=500 490
! the file was read as a file of MakeCode, with the settings of its header
! there are 2 independent variables, each with its own columns: 1.time for x; 2.time for y",
    ),
    (
        "JSON: records, with a time as text",
        "[{\"time\": \"2024-05-01T10:00:00\", \"T\": {\"water (°C)\": 20.5}},\n {\"time\": \"2024-05-01T10:00:01\", \"T\": {\"water (°C)\": null}},\n {\"time\": \"2024-05-01T10:00:02.5\", \"T\": {\"water (°C)\": 21.5}}]",
        "tabs, decimal point, 1 header line
*time [s]=0 1 2.5
1:T.water [K]=293.65 · 294.65
! the table was read from JSON
! T.water: `°C` is a temperature in °C: 273.15 was added, the column is in K
! time holds clock times; they are read as seconds from the first row",
    ),
    (
        "JSON: a record on each line",
        "{\"t [ms]\": 0, \"x\": 1.295}\n{\"t [ms]\": 20, \"x\": 926}\n",
        "tabs, decimal point, 1 header line
*t [ms]=0 20
1:x=1.295 926
! the table was read from JSON",
    ),
    (
        "JSON: lists by name, of which one has another length",
        "{\"buffer\": {\"acc_time\": {\"buffer\": [0, 0.5, 1]}, \"accX\": {\"buffer\": [3, 4, 5]}, \"spectrum\": {\"buffer\": [1, 2]}}}",
        "tabs, decimal point, 1 header line
*acc_time=0 0.5 1
1:accX=3 4 5
! the table was read from JSON; these lists have another length and were left out: spectrum",
    ),
    (
        "InfluxDB: each series is a column",
        "#group,false,false,false,false,true\n#datatype,string,long,dateTime:RFC3339,double,string\n#default,mean,,,,\n,result,table,_time,_value,_field\n,,0,2020-01-01T00:00:00Z,20.5,temp\n,,0,2020-01-01T00:00:10Z,21.5,temp\n,,1,2020-01-01T00:00:00Z,50,hum\n,,1,2020-01-01T00:00:10Z,51.5,hum\n",
        "tabs, decimal point, 1 header line
*time [s]=0 10
1:temp=20.5 21.5
1:hum=50 51.5
! the file was read as a file of InfluxDB, with the settings of its header
! time holds clock times; they are read as seconds from the first row",
    ),
    (
        "a counter of 32 bits",
        "micros,y\n4294967095,1\n4294967145,2\n4294967195,3\n4294967245,4\n4294967295,5\n49,6\n99,7\n",
        "commas, decimal point, 1 header line
*micros [µs]=4294967095 4294967145 4294967195 4294967245 4294967295 4294967345 4294967395
1:y=1 2 3 4 5 6 7
! the clock of micros overflowed once: where it fell, 2^32 was added to all later times",
    ),
    (
        "NUL bytes",
        "t\ty\r\n\u{0}\u{0}0\t1.5\r\n1\t2.5\r\n\u{0}",
        "tabs, decimal point, 1 header line
*t=0 1
1:y=1.5 2.5
! 3 NUL bytes were left out; a logger writes them on a reset or a loss of power, so rows may be missing there",
    ),
];

#[test]
fn files_of_instruments_are_read_with_their_settings() {
    for (name, text, expected) in CASES {
        assert_eq!(shown(&read(text.as_bytes())).trim_end(), *expected, "{name}");
    }
}

#[test]
fn a_text_is_returned_as_it_was() {
    for (name, text, _) in CASES.iter().filter(|(name, ..)| *name != "NUL bytes") {
        let contents = reading::read(text.as_bytes().to_vec(), 1 << 20).expect(name);
        assert_eq!(contents.text, *text, "{name}");
        let again = reading::read(contents.text.into_bytes(), 1 << 20).expect(name);
        assert_eq!(format!("{:?}", again.import), format!("{:?}", contents.import), "{name}");
    }
}

#[test]
fn files_of_programs_are_refused_with_their_export() {
    for (start, name, export) in [
        ("<?xml version=\"1.0\"?><Document><DataSet><DataColumn>", "Logger Pro", "Export As"),
        ("<?xml version=\"1.0\"?><!-- CASSY Lab 2 --><project>", "CASSY Lab", "*.txt"),
    ] {
        let error = import::text(start.as_bytes()).expect_err(start);
        assert!(error.message(Language::English).contains(name), "{}", error.message(Language::English));
        assert!(error.hint(Language::English).contains(export), "{}", error.hint(Language::English));
    }
    let error = import::text(b"{\"a\": [1, 2], \"b\": \"c\"}").expect_err("JSON without a table");
    assert!(error.message(Language::English).contains("JSON"), "{error}");
    let error = import::text(b"<?xml version=\"1.0\"?><svg/>").expect_err("XML");
    assert!(error.message(Language::English).contains("XML"), "{error}");
}

#[test]
fn utf_16_without_a_mark_is_text() {
    let text = "t\ty\n0\t1.5\n1\t2.5\n";
    for swap in [false, true] {
        let bytes: Vec<u8> =
            text.encode_utf16().flat_map(|word| if swap { word.to_be_bytes() } else { word.to_le_bytes() }).collect();
        assert_eq!(read(&bytes).table.columns[1].values, [1.5, 2.5]);
    }
    assert!(import::text(&[b'a', 0, 0, 0, 0, 0, b'b']).is_err(), "mostly NUL bytes");
}

#[test]
fn number_formats_state_units_and_moments() {
    let row = |row: u32, first: &str, second: &str| {
        format!("<row r=\"{row}\"><c r=\"A{row}\" {first}</c><c r=\"B{row}\" {second}</c></row>")
    };
    let text = |text: &str| format!("t=\"inlineStr\"><is><t>{text}</t></is>");
    let of = |style: u32, value: &str| format!("s=\"{style}\"><v>{value}</v>");
    let sheet = |first: [String; 2], second: [String; 2]| {
        let [a, b] = first;
        let [c, d] = second;
        packed::xlsx(&[("S", &(row(1, &text("t"), &text("y [cm]")) + &row(2, &a, &b) + &row(3, &c, &d)))])
    };
    // A unit in the format, and a time of day that holds a date: 45413.5 is noon on 1 May 2024.
    for (values, unit, times) in [
        ([of(5, "40"), of(5, "80")], "ms", [40.0, 80.0]),
        ([of(4, "45413.5"), of(4, "45413.500011574076")], "s", [0.0, 1.0]),
    ] {
        let [first, second] = values;
        let bytes = sheet([first, of(0, "1.5")], [second, of(0, "2.5")]);
        let table = reading::read(bytes, 1 << 20).expect("a table").import.table;
        assert_eq!(table.columns[0].unit.as_ref().map(|unit| unit.text.as_str()), Some(unit));
        let close = table.columns[0].values.iter().zip(times).all(|(own, time)| (own - time).abs() < 1e-4);
        assert!(close, "{:?}", table.columns[0].values);
        assert_eq!(table.columns[1].values, [1.5, 2.5]);
    }
}

#[test]
fn an_archive_of_capstone_is_refused_with_its_export() {
    let files = [("main.xml".to_owned(), "<x/>".to_owned()), ("data/1.tmp".to_owned(), "abc".to_owned())];
    let error = reading::read(packed::archive(&files, Pack::Deflated), 1 << 20).expect_err("no table");
    assert!(error.message(Language::English).contains("Capstone"), "{}", error.message(Language::English));
    assert!(error.hint(Language::English).contains("Export Data"), "{}", error.hint(Language::English));
}

/// Checks what holds for every table, and that every refusal has a message and a hint.
fn is_sound(bytes: &[u8]) {
    match import::text(bytes) {
        Ok(import) => {
            let rows = import.table.rows();
            for (index, column) in import.table.columns.iter().enumerate() {
                assert_eq!(column.values.len(), rows);
                assert_eq!(import.table.column(&import.table.typed(index)).ok(), Some(index));
            }
            assert!(import.findings.iter().all(|finding| !finding.text(Language::Spanish).is_empty()));
        }
        Err(error) => {
            assert!(!error.message(Language::Spanish).is_empty() && !error.hint(Language::Spanish).is_empty());
        }
    }
}

#[test]
fn any_change_of_a_file_of_an_instrument_is_read_or_refused() {
    const CHANGES: usize = 400;
    const PIECES: [&str; 14] =
        ["\n", "\t", ",", "0", "-1e308", "nan", "#", "***End_of_Header***\n", "\"", "[", "{", "}", "\\u", "X_Value"];
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut below = |count: usize| {
        // Xorshift (Marsaglia, J. Stat. Softw. 8, 2003).
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state % count.max(1) as u64) as usize
    };
    for (_, text, _) in CASES {
        for _ in 0..CHANGES {
            let mut bytes = text.as_bytes().to_vec();
            for _ in 0..=below(4) {
                let (at, piece) = (below(bytes.len() + 1), PIECES[below(PIECES.len())]);
                match below(4) {
                    0 => bytes.truncate(at),
                    1 => drop(bytes.splice(at..at, piece.bytes())),
                    2 => {
                        let end = (at + below(30)).min(bytes.len());
                        bytes.drain(at..end);
                    }
                    _ => {
                        let end = (at + below(60)).min(bytes.len());
                        let copied = bytes[at..end].to_vec();
                        let to = below(bytes.len() + 1);
                        drop(bytes.splice(to..to, copied));
                    }
                }
            }
            is_sound(&bytes);
        }
    }
}
