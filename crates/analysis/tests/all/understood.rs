//! Files as written by loggers, spreadsheets and people: the reading of each column, with the expected one.

use analysis::import::{self, Import};
use units::Language;

/// One line per column, with `*` before an independent variable: body, name, unit, source of the unit, values, and number
/// of words; then the findings about the file.
fn shown(import: &Import) -> String {
    let mut text = String::new();
    for (index, column) in import.table.columns.iter().enumerate() {
        let own = if column.independent == index { "*".to_owned() } else { format!("{}:", column.independent + 1) };
        let body = column.body.as_ref().map(|body| format!("{body}.")).unwrap_or_default();
        let unit = column.unit.as_ref().map(|unit| unit.text.clone()).unwrap_or_default();
        let value = |value: &f64| if value.is_nan() { "·".to_owned() } else { value.to_string() };
        let values: Vec<String> = column.values.iter().map(value).collect();
        let origin = column.origin.unit.code();
        text.push_str(&format!("{own}{body}{} [{unit}] {origin}: {}", column.name, values.join(" ")));
        if column.origin.words > 0 {
            let (line, word) = column.origin.first_word.clone().expect("a word has a place");
            text.push_str(&format!(" ({} words, `{word}` in line {line})", column.origin.words));
        }
        text.push('\n');
    }
    for finding in &import.findings {
        assert!(!finding.text(catalogues::with(Language::Spanish)).is_empty());
        text.push_str(&format!("! {}\n", finding.text(Language::English)));
    }
    text
}

/// Name, text of the file, and its reading; `refused: ` and the message if it is refused.
pub type Case = (&'static str, &'static str, &'static str);

/// Odd cells in the first rows.
const HEADERS: &[Case] = &[
    (
        "a number beyond the largest one",
        "t [s];y\n0,0;1,5\n0,1;-1e400\n0,2;2,0\n",
        "*t [s] header: 0 0.1 0.2
1:y [] not stated: 1.5 · 2 (1 words, `-1e400` in line 3)
! line 3, column y: `-1e400` is beyond the range of numbers here, ±1.8e308, and became a gap",
    ),
    (
        "Excel's line for the delimiter",
        "sep=;\nt [s];y [cm]\n0,0;1,5\n0,1;2,5\n",
        "*t [s] header: 0 0.1
1:y [cm] header: 1.5 2.5",
    ),
    (
        "the same in quotation marks, with a rare delimiter and without names",
        "\"sep=^\"\n0^1.5\n1^2.5\n",
        "* [] not stated: 0 1
1: [] not stated: 1.5 2.5",
    ),
    (
        "the same with a tab as programs write it",
        "SEP=\\t\nt [s]\ty\n0\t1,5\n1\t2,5\n",
        "*t [s] header: 0 1
1:y [] not stated: 1.5 2.5",
    ),
    (
        "a failed formula in the first row",
        "t [s],y [cm],v [cm/s]\n0.0,1.5,#DIV/0!\n0.1,2.5,10\n0.2,2.0,-5\n",
        "*t [s] header: 0 0.1 0.2
1:y [cm] header: 1.5 2.5 2
1:v [cm/s] header: · 10 -5 (1 words, `#DIV/0!` in line 2)
! line 2, column v: `#DIV/0!` is not a number and became a gap",
    ),
    (
        "failed formulas wherever a number could be, one like a unit",
        "t;y;v\n0,0;#N/A;#WERT!\n0,1;2,5;1,5\n0,2;2,0;0,5\n",
        "*t [] not stated: 0 0.1 0.2
1:y [] not stated: · 2.5 2 (1 words, `#N/A` in line 2)
1:v [] not stated: · 1.5 0.5 (1 words, `#WERT!` in line 2)
! line 2, column y: `#N/A` is not a number and became a gap
! line 2, column v: `#WERT!` is not a number and became a gap",
    ),
    (
        "a failed formula at the beginning of a line is no comment",
        "t,y\n#N/A,1\n1,2\n2,3\n",
        "*t [] not stated: · 1 2 (1 words, `#N/A` in line 2)
1:y [] not stated: 1 2 3
! line 2, column t: `#N/A` is not a number and became a gap",
    ),
    (
        "remarks beside the numbers",
        "Zeit [s];Weg [cm];Bemerkung\n0,0;1,5;Start\n0,1;2,5;\n0,2;2,0;zu schnell\n",
        "*Zeit [s] header: 0 0.1 0.2
1:Weg [cm] header: 1.5 2.5 2
! column Bemerkung holds words and was left out",
    ),
    (
        "a word in the first row",
        "t\ty\n0\toops\n1\t2\n2\t3\n",
        "*t [] not stated: 0 1 2
1:y [] not stated: · 2 3 (1 words, `oops` in line 2)
! line 2, column y: `oops` is not a number and became a gap",
    ),
    (
        "columns that are called by numbers",
        "trial;1;2\n0;1,5;2,5\n1;3,5;4,5\n",
        "*trial [] not stated: 0 1
1:1 [] not stated: 1.5 3.5
1:2 [] not stated: 2.5 4.5",
    ),
    (
        "what a device says before its table",
        "Booting...\nMPU6050 ready\ntime_ms,angle\n0,3.45\n50,2.81\n",
        "*time [ms] end of the name: 0 50
1:angle [] not stated: 3.45 2.81",
    ),
    (
        "a title with numbers, blanks between",
        "12 May 2024\nt y v\n0 1 2\n1 2 3\n",
        "*12 May 2024.t [] not stated: 0 1
1:12 May 2024.y [] not stated: 1 2
1:12 May 2024.v [] not stated: 2 3",
    ),
    (
        "Logger Pro's text: names, symbols and units",
        "Vernier Format 2\nfile.cmbl 1/2/2024\nRun 1\nTime\tPosition\nT\tX\ns\tm\n\n0\t1.5\n0.1\t2.5\n",
        "*Time [s] line of units: 0 0.1
1:Position [m] line of units: 1.5 2.5
! the file was read as a file of Vernier, with the settings of its header",
    ),
    (
        "a unit among the units that is not known",
        "t\tx\ty\nms\tcells\tcells\n0\t1\t2\n1\t2\t3\n",
        "*t [ms] line of units: 0 1
1:x [] unknown: 1 2
1:y [] unknown: 2 3
! `cells`, the unit of x, is not known; until one is stated, its numbers have none
! `cells`, the unit of y, is not known; until one is stated, its numbers have none",
    ),
    (
        "lines that end in several ways, quotation marks with a line end inside",
        "t\ty\r0\t1.5\n1\t\"2.5\"\r\n2\t3.5\r\"a\nremark\"\t7\n",
        "*t [] not stated: 0 1 2 · (1 words, `a remark` in line 5)
1:y [] not stated: 1.5 2.5 3.5 7
! line 5, column t: `a remark` is not a number and became a gap",
    ),
    (
        "a footer",
        "t;y\n0;1\n1;2\nmean;1.5\nend of file\n",
        "*t [] not stated: 0 1 · (1 words, `mean` in line 4)
1:y [] not stated: 1 2 1.5
! line 5 has no number and was passed over
! line 4, column t: `mean` is not a number and became a gap",
    ),
    (
        "infinity is no measurement",
        "t,y\n0,inf\n1,2\n2,-Infinity\n3,NaN\n",
        "*t [] not stated: 0 1 2 3
1:y [] not stated: · 2 · · (2 words, `inf` in line 2)
! line 2, column y: `inf` is not a number and became a gap
! line 4, column y: `-Infinity` is not a number and became a gap",
    ),
    (
        "times and temperatures",
        "t,T\n0,90.5\n60,80.5\n",
        "*t [] not stated: 0 60
1:T [] not stated: 90.5 80.5",
    ),
    (
        "a period against a length",
        "L [m];T [s]\n0,5;1,42\n1,0;2,01\n",
        "*L [m] header: 0.5 1
1:T [s] header: 1.42 2.01",
    ),
    (
        "a time that is not first, and a current",
        "I (A),U (V),t (min)\n0.5,1.5,0\n0.6,2.5,1\n",
        "3:I [A] header: 0.5 0.6
3:U [V] header: 1.5 2.5
*t [min] header: 0 1",
    ),
];

/// Signs inside numbers.
const SEPARATORS: &[Case] = &[
    (
        "an ordinary decimal comma with some whole numbers",
        "t\ty\n0,5\t1\n1\t1,5\n1,5\t2\n",
        "*t [] not stated: 0.5 1 1.5
1:y [] not stated: 1 1.5 2",
    ),
    (
        "groups of three digits, which a column passes",
        "t\ty\n0\t1,250\n1\t1,128\n2\t1,004\n3\t880\n4\t755\n5\t830\n6\t955\n7\t1,080\n",
        "*t [] not stated: 0 1 2 3 4 5 6 7
1:y [] not stated: 1250 1128 1004 880 755 830 955 1080
! line 2: `1,250` is read as 1250 and not as 1.250, as `880` stands in the same column",
    ),
    (
        "the same with points",
        "t;y\n0;1.251\n1;1.128\n2;1.004\n3;881\n4;755\n5;832\n6;957\n7;1.081\n",
        "*t [] not stated: 0 1 2 3 4 5 6 7
1:y [] not stated: 1251 1128 1004 881 755 832 957 1081
! line 2: `1.251` is read as 1251 and not as 1.251, as `881` stands in the same column",
    ),
    (
        "nobody can know",
        "t\ty\n0\t1,295\n1\t926\n",
        "refused: line 2: column 2: `1,295` can be 1.295 or 1295, as `926` stands in the same column",
    ),
    (
        "three decimals everywhere",
        "n\ty\n0\t1,295\n1\t1,926\n",
        "*n [] not stated: 0 1
1:y [] not stated: 1.295 1.926
! line 2: the comma of `1,295` is taken for a decimal sign: 1.295, not 1295",
    ),
    (
        "points in the thousands and a decimal comma",
        "t;y\n0,00;8.454,31\n0,05;12.806,47\n0,10;880,58\n",
        "*t [] not stated: 0 0.05 0.1
1:y [] not stated: 8454.31 12806.47 880.58",
    ),
    (
        "commas in the thousands and decimal points, between tabs and in quotation marks",
        "t\ty\n0.00\t1,454\n0.05\t\"1,234,567.5\"\n0.10\t880\n",
        "*t [] not stated: 0 0.05 0.1
1:y [] not stated: 1454 1234567.5 880",
    ),
    (
        "a column with decimal points among columns with decimal commas",
        "t [s];y [cm];v\n0.960;5,000;-1,5\n0.980;4,885;0\n1.000;-0,556;2,5\n1.020;4,5;1.234,5\n",
        "*t [s] header: 0.96 0.98 1 1.02
1:y [cm] header: 5 4.885 -0.556 4.5
1:v [] not stated: -1.5 0 2.5 1234.5
! t has a decimal point, other columns have a decimal comma; each is read with its own sign",
    ),
    (
        "a column with decimal commas among columns with decimal points, and one without either",
        "t\ty\tn\n0.5\t0,960\t1\n0.6\t1,040\t2\n0.75\t1,060\t3\n",
        "*t [] not stated: 0.5 0.6 0.75
1:y [] not stated: 0.96 1.04 1.06
1:n [] not stated: 1 2 3
! y has a decimal comma, other columns have a decimal point; each is read with its own sign",
    ),
    (
        "a column with both decimal signs, and a number that may have either",
        "t;y\n0,5;0.960\n0,6;1.040\n0,7;1.060\n0,75;1.080\n0,9;1.100\n1,0;1,5\n",
        "refused: line 3: column 2: `1.040` can be 1.040 or 1040, as `0.960` stands in the same column",
    ),
    (
        "one decimal point among decimal commas",
        "t;y\n0,5;0.960\n0,6;0,5\n0,75;0,5\n",
        "*t [] not stated: 0.5 0.6 0.75
1:y [] not stated: · 0.5 0.5 (1 words, `0.960` in line 2)
! line 2, column y: `0.960` is not a number and became a gap",
    ),
    (
        "points that nothing shows to be those of thousands",
        "t;y\n1.040;4,8\n1.060;4,5\n",
        "*t [] not stated: 1040 1060
1:y [] not stated: 4.8 4.5
! line 2: `1.040` is read as 1040 and not as 1.040, as other numbers of the file have the other sign for their decimals",
    ),
    (
        "semicolons and decimal points",
        "t;y\n0.5;1.25\n1;2.5\n",
        "*t [] not stated: 0.5 1
1:y [] not stated: 1.25 2.5",
    ),
];

/// Units.
const UNITS: &[Case] = &[
    (
        "units in words and in other brackets",
        "Time (msec),Winkel [Grad],v <cm/sec>,x {mm}\n0,1,2,3\n50,2,3,4\n",
        "*Time [ms] header: 0 50
1:Winkel [deg] header: 1 2
1:v [cm/s] header: 2 3
1:x [mm] header: 3 4",
    ),
    (
        "units behind a word, a colon, the name",
        "t in ms,y in cm,Kraft: N,angle_deg,Länge mm\n0,1,2,3,4\n50,2,3,4,5\n",
        "*t [ms] header: 0 50
1:y [cm] header: 1 2
1:Kraft [N] header: 2 3
1:angle [deg] end of the name: 3 4
1:Länge [mm] header: 4 5",
    ),
    (
        "Spanish",
        "Tiempo (segundos);Ángulo (grados);Posición en metros\n0;1;2\n1;2;3\n",
        "*Tiempo [s] header: 0 1
1:Ángulo [deg] header: 1 2
1:Posición [m] header: 2 3",
    ),
    (
        "blanks between",
        "t in ms  y in cm\n0 1.5\n50 2.5\n",
        "*t [ms] header: 0 50
1:y [cm] header: 1.5 2.5",
    ),
    (
        "a time in a unit that nobody knows",
        "t (ticks),y\n0,1\n50,2\n",
        "*t [] unknown: 0 50
1:y [] not stated: 1 2
! `ticks`, the unit of t, is not known; until one is stated, its numbers have none",
    ),
    (
        "two cameras",
        "t [ms] (camera),y [cm] (left),y [cm] (right)\n0,1,2\n50,2,3\n",
        "*t [ms] header: 0 50
1:y (left) [cm] header: 1 2
1:y (right) [cm] header: 2 3",
    ),
    (
        "units in the cells",
        "t;y;p\n0,0 s;1,5 cm;5 %\n0,5 s;2,5 cm;6 %\n1,0 s;;7 %\n",
        "*t [s] cells: 0 0.5 1
1:y [cm] cells: 1.5 2.5 ·
1:p [%] cells: 5 6 7",
    ),
    (
        "degrees in the cells",
        "t,phi\n0,30.5°\n1,-20.5°\n",
        "*t [] not stated: 0 1
1:phi [°] cells: 30.5 -20.5",
    ),
];

pub fn check(cases: &[Case]) {
    let mut wrong = String::new();
    for (name, text, expected) in cases {
        let found = match import::text(text.as_bytes()) {
            Ok(import) => shown(&import),
            Err(error) => format!("refused: {}", error.message(Language::English)),
        };
        if found.trim_end() != *expected {
            wrong.push_str(&format!("{name}:\n{found}\ninstead of\n{expected}\n\n"));
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn odd_cells_do_not_hide_names_units_or_rows() {
    check(HEADERS);
}

#[test]
fn signs_in_numbers_are_read_in_the_only_way_they_can_be() {
    check(SEPARATORS);
}

#[test]
fn units_are_understood_or_said_to_be_unknown() {
    check(UNITS);
}
