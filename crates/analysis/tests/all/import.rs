//! Reading of text, with the expected result.

use analysis::import::{self, Import};
use units::Language;

pub fn read(bytes: &[u8]) -> Import {
    import::text(bytes).unwrap_or_else(|error| panic!("{error}\n{}", String::from_utf8_lossy(bytes)))
}

/// A table in one line for each column: `*` before an independent variable, the body, name and unit, then the values.
pub fn shown(import: &Import) -> String {
    let mut text = format!("{}\n", import.format.text(Language::English));
    for (index, column) in import.table.columns.iter().enumerate() {
        let own = column.independent == index;
        let body = column.body.as_ref().map(|body| format!("{body}.")).unwrap_or_default();
        let unit = column.unit.as_ref().map(|unit| format!(" [{}]", unit.text)).unwrap_or_default();
        let values: Vec<String> =
            column.values.iter().map(|value| if value.is_nan() { "·".to_owned() } else { value.to_string() }).collect();
        let times = if own { "*".to_owned() } else { format!("{}:", column.independent + 1) };
        text.push_str(&format!("{times}{body}{}{unit}={}\n", column.name, values.join(" ")));
    }
    for finding in &import.findings {
        text.push_str(&format!("! {}\n", finding.text(Language::English)));
    }
    text
}

/// Name, text of the file, and its reading.
type Case = (&'static str, &'static str, &'static str);

const CASES: &[Case] = &[
    (
        "no header, one blank",
        "0.1 1.5\n0.2 -2.5E-1\n",
        "blanks, decimal point, no header
*=0.1 0.2
1:=1.5 -0.25",
    ),
    (
        "Tracker's export of two tracks",
        "#multi:\n\tmass_A\t\tmass_B\t\t\nt\tx\ty\tx\ty\t\n0.0E0\t1.0E0\t2.0E0\t3.0E0\t\t\n1.0E-1\t\t2.5E0\t3.5E0\t4.0E0\t\n",
        "tabs, decimal point, 3 header lines
*t=0 0.1
1:mass_A.x=1 ·
1:mass_A.y=2 2.5
1:mass_B.x=3 3.5
1:mass_B.y=· 4",
    ),
    (
        "a copied table",
        "mass_A\nt\tx\tv_{x}\n0\t1\t\n1\t2\t0.5\n2\t3\t\n",
        "tabs, decimal point, 2 header lines
*mass_A.t=0 1 2
1:mass_A.x=1 2 3
1:mass_A.v_x=· 0.5 ·",
    ),
    (
        "decimal comma with exponent, semicolons",
        "t;y;v\n0,0E0;-1,686115217E2;\n3,3E-2;1,5;2,25\n",
        "semicolons, decimal comma, 1 header line
*t=0 0.033
1:y=-168.6115217 1.5
1:v=· 2.25",
    ),
    (
        "decimal comma between blanks",
        "1,5 2,5\n2 3,5\n",
        "blanks, decimal comma, no header
*=1.5 2
1:=2.5 3.5",
    ),
    (
        "commas alone are delimiters",
        "1,5,2,5\n2,6,3,6\n",
        "commas, decimal point, no header
*=1 2
1:=5 6
1:=2 3
1:=5 6",
    ),
    (
        "decimal commas, comma and blank between",
        "t, y\n0,5, 1,25\n1, 2,5\n",
        "commas with a blank, decimal comma, 1 header line
*t=0.5 1
1:y=1.25 2.5",
    ),
    (
        "comma and blank with points",
        "t, y\n0.5, 1.25\n1, 2.5\n",
        "commas, decimal point, 1 header line
*t=0.5 1
1:y=1.25 2.5",
    ),
    (
        "quotation marks around decimal commas",
        "\"t [s]\",\"y, measured [cm]\"\n\"0,5\",\"1,25\"\n1,\"2,5\"\n",
        "commas, decimal comma, 1 header line
*t [s]=0.5 1
1:y, measured [cm]=1.25 2.5",
    ),
    (
        "two blanks and a tab, CRLF, byte-order mark",
        "\u{feff}t  \ty\r\n0.1  \t-1.5\r\n0.2  \t2.5  \r\n",
        "tabs, decimal point, 1 header line
*t=0.1 0.2
1:y=-1.5 2.5",
    ),
    (
        "blanks and tabs mixed",
        "  0.1  1.5\t7\n  0.2 -2.5\t8\n",
        "blanks, decimal point, no header
*=0.1 0.2
1:=1.5 -2.5
1:=7 8",
    ),
    (
        "one blank, with empty cells",
        "t x y \n0 1 2 \n1  3 \n2 4  \n",
        "blanks, decimal point, 1 header line
*t=0 1 2
1:x=1 · 4
1:y=2 3 ·",
    ),
    (
        "units in brackets and parentheses",
        "Time (s)\ty [cm]\tv (m/s²)\tω(t)\tp(Pa)\ty (left)\n0\t1\t2\t3\t4\t5\n1\t1\t2\t3\t4\t5\n",
        "tabs, decimal point, 1 header line
*Time [s]=0 1
1:y [cm]=1 1
1:v [m/s^2]=2 2
1:ω(t)=3 3
1:p [Pa]=4 4
1:y (left)=5 5
! `left`, the unit of y (left), is not known; until one is stated, its numbers have none",
    ),
    (
        "units between blanks",
        "t (s)  y [cm]  v / (cm/s)\n0 1 2\n1 2 3\n",
        "blanks, decimal point, 1 header line
*t [s]=0 1
1:y [cm]=1 2
1:v [cm/s]=2 3",
    ),
    (
        "units in the manner of ISO 80000 and as people write them",
        "t/ms;y / mm;a [m/s2];F (N)\n0;1;2;3\n1;2;3;4\n",
        "semicolons, decimal point, 1 header line
*t [ms]=0 1
1:y [mm]=1 2
1:a [m/s^2]=2 3
1:F [N]=3 4",
    ),
    (
        "a line of units",
        "t\ty\ns\tcm\n0\t1\n1\t2\n",
        "tabs, decimal point, 2 header lines
*t [s]=0 1
1:y [cm]=1 2",
    ),
    (
        "a unit nobody knows",
        "t [s],y [blips]\n0,1\n1,2\n",
        "commas, decimal point, 1 header line
*t [s]=0 1
1:y=1 2
! `blips`, the unit of y, is not known; until one is stated, its numbers have none",
    ),
    (
        "three bodies side by side, each with its own time",
        "A\t\tB\t\tC\nt\ty\tt\ty\tt\ty\n0\t1\t0.1\t4\t0\t7\n0.1\t2\t0.2\t5\t\t\n0.2\t3\n",
        "tabs, decimal point, 2 header lines
*A.t=0 0.1 0.2
1:A.y=1 2 3
*B.t=0.1 0.2 ·
3:B.y=4 5 ·
*C.t=0 · ·
5:C.y=7 · ·",
    ),
    (
        "two bodies without names",
        "t,y,t,y\n0,1,0,3\n1,2,1,4\n",
        "commas, decimal point, 1 header line
*1.t=0 1
1:1.y=1 2
*2.t=0 1
3:2.y=3 4
! there are 2 independent variables, each with its own columns: 1.t for 1.y; 2.t for 2.y",
    ),
    (
        "bodies whose times have their names",
        "t_A;y_A;t_B;y_B\n0;1;0;3\n1;2;1;4\n",
        "semicolons, decimal point, 1 header line
*1.t_A=0 1
1:1.y_A=1 2
*2.t_B=0 1
3:2.y_B=3 4
! there are 2 independent variables, each with its own columns: t_A for y_A; t_B for y_B",
    ),
    (
        "a quantity that is a time",
        "t;t_half;time_of_flight\n0;1;2\n1;2;3\n",
        "semicolons, decimal point, 1 header line
*t=0 1
1:t_half=1 2
1:time_of_flight=2 3
! t_half is taken for a measured quantity against t, not for the clock of other columns
! time_of_flight is taken for a measured quantity against t, not for the clock of other columns",
    ),
    (
        "a counter of frames",
        "n\tx\n0\t1.5\n1\t2.5\n",
        "tabs, decimal point, 1 header line
*n=0 1
1:x=1.5 2.5",
    ),
    (
        "an index and a time that is not first",
        ",t,y\n0,0.5,1\n1,0.6,2\n",
        "commas, decimal point, 1 header line
*=0 1
*t=0.5 0.6
2:y=1 2",
    ),
    (
        "comments, and a header in one",
        "# made by a logger\n# t y\n0 1\n# pause\n1 2\n",
        "blanks, decimal point, 2 header lines
*t=0 1
1:y=1 2",
    ),
    (
        "last cells missing in the first row",
        "0;1\n1;2;3\n2;3;4;5\n",
        "semicolons, decimal point, no header
*=0 1 2
1:=1 2 3
1:=· 3 4
1:=· · 5",
    ),
    (
        "words for nothing, signs of typesetters",
        "t;y\n0;NaN\n1;−2,5\n2;-\n3;n/a\n4;1e-3\n",
        "semicolons, decimal comma, 1 header line
*t=0 1 2 3 4
1:y=· -2.5 · · 0.001",
    ),
    (
        "words among the numbers",
        "t\ty\n0\t1\n1\toops\n2\t3\nt\ty\n3\t4 m\n4\t5\n",
        "tabs, decimal point, 1 header line
*t=0 1 2 3 4
1:y=1 · 3 · 5
! line 5 has no number and was passed over
! line 3, column y: `oops` is not a number and became a gap
! line 6, column y: `4 m` is not a number and became a gap",
    ),
    (
        "a column of words",
        "t,y,note\n0,1,a\n1,2,b\n2,3,c\n",
        "commas, decimal point, 1 header line
*t=0 1 2
1:y=1 2 3
! column note holds words and was left out",
    ),
    (
        "a delimiter of one's own",
        "t|y\n0,5|1,5\n1,5|2,5\n",
        "|, decimal comma, 1 header line
*t=0.5 1.5
1:y=1.5 2.5",
    ),
    (
        "an empty column with a name",
        "t\ty\tv\n0\t1\t\n1\t2\t\n",
        "tabs, decimal point, 1 header line
*t=0 1
1:y=1 2
1:v=· ·
! column v is empty",
    ),
    (
        "lines that end as on an old Macintosh",
        "t\ty\r0\t1\r1\t2",
        "tabs, decimal point, 1 header line
*t=0 1
1:y=1 2",
    ),
    (
        "a title over the names",
        "Run 3 of 12 May 2024\n\nt [s];y [mm]\n0;1\n1;2\n\n",
        "semicolons, decimal point, 3 header lines
*t [s]=0 1
1:y [mm]=1 2",
    ),
    (
        "times are known by their unit",
        "y [cm];Zeitpunkt [s]\n1;0\n2;1\n",
        "semicolons, decimal point, 1 header line
2:y [cm]=1 2
*Zeitpunkt [s]=0 1",
    ),
];

#[test]
fn texts_are_read_as_expected() {
    let mut wrong = String::new();
    for (name, text, expected) in CASES {
        let found = shown(&read(text.as_bytes()));
        if found.trim_end() != *expected {
            wrong.push_str(&format!("{name}:\n{found}instead of\n{expected}\n\n"));
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn a_column_with_the_standard_errors_of_another_is_found_by_its_name() {
    let table = read(b"t [s],x [m],sigma_y [m],y [m],sigma_x [m]\n0,1,2,3,4\n1,2,3,4,5\n").table;
    let called = |name: &str| table.column(name).unwrap();
    assert_eq!(table.errors_of(called("y")), Some(called("sigma_y")));
    assert_eq!(table.errors_of(called("x")), Some(called("sigma_x")));
    assert_eq!(table.errors_of(called("sigma_x")), None);
    // Each body has its own column of errors.
    let table = read(b"t,A.y,A.sigma_y,B.y\n0,1,2,3\n1,2,3,4\n").table;
    assert_eq!(table.errors_of(3), None);
}
