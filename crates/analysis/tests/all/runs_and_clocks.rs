//! Files with several runs and with clock times: their reading, with the expected one.

use crate::understood::{Case, check};
use analysis::import;
use analysis::inspection::doubtful_times;
use units::Language;

/// Runs of loggers.
const RUNS: &[Case] = &[
    (
        "Capstone",
        "\"Time (s) Run #1\",\"Angle (deg) Run #1\",\"Time (s) Run #2\",\"Angle (deg) Run #2\"\n0,30,0,20\n0.5,28,1,15\n1,23\n",
        "*Run 1.Time [s] header: 0 0.5 1
1:Run 1.Angle [deg] header: 30 28 23
*Run 2.Time [s] header: 0 1 ·
3:Run 2.Angle [deg] header: 20 15 ·
! there are 2 runs, each with its own clock: Run 1, Run 2; a column is named with its run, `Run 2.y`",
    ),
    (
        "Logger Pro, times first",
        "Run 1: Time (s),Run 2: Time (s),Run 1: Angle (deg),Run 2: Angle (deg)\n0,0,30,20\n0.5,1,28,15\n",
        "*Run 1.Time [s] header: 0 0.5
*Run 2.Time [s] header: 0 1
1:Run 1.Angle [deg] header: 30 28
2:Run 2.Angle [deg] header: 20 15
! there are 2 runs, each with its own clock: Run 1, Run 2; a column is named with its run, `Run 2.y`",
    ),
    (
        "Vernier",
        "Data Set 1:Time(s),Data Set 1:Angle(deg),Data Set 2:Time(s),Data Set 2:Angle(deg)\n0,30,0,20\n0.5,28,1,15\n",
        "*Data Set 1.Time [s] header: 0 0.5
1:Data Set 1.Angle [deg] header: 30 28
*Data Set 2.Time [s] header: 0 1
3:Data Set 2.Angle [deg] header: 20 15
! there are 2 runs, each with its own clock: Data Set 1, Data Set 2; a column is named with its run, `Data Set 2.y`",
    ),
    (
        "one clock for all runs",
        "Time (s),Angle Run 1,Angle Run 2\n0,30,20\n0.5,28,15\n",
        "*Time [s] header: 0 0.5
1:Run 1.Angle [] not stated: 30 28
1:Run 2.Angle [] not stated: 20 15",
    ),
    (
        "bodies before a colon",
        "ball: t,ball: y,cart: t,cart: y\n0,30,0,20\n0.5,28,1,15\n",
        "*ball.t [] not stated: 0 0.5
1:ball.y [] not stated: 30 28
*cart.t [] not stated: 0 1
3:cart.y [] not stated: 20 15",
    ),
    (
        "runs below each other",
        "t,y\n0,30\n0.5,28\n1,23\nt,y\n0,20\n1,15\n",
        "*Run 1.t [] not stated: 0 0.5 1
1:Run 1.y [] not stated: 30 28 23
*Run 2.t [] not stated: 0 1 ·
3:Run 2.y [] not stated: 20 15 ·
! line 5 has no number and was passed over
! there are 2 runs, each with its own clock: Run 1, Run 2; a column is named with its run, `Run 2.y`",
    ),
    (
        "runs below each other without a header between them",
        "t [s],y\n0,30\n0.5,28\n1,23\n0,20\n0.5,15\n1,12\n1.5,10\n",
        "*Run 1.t [s] header: 0 0.5 1 ·
1:Run 1.y [] not stated: 30 28 23 ·
*Run 2.t [s] header: 0 0.5 1 1.5
3:Run 2.y [] not stated: 20 15 12 10
! there are 2 runs, each with its own clock: Run 1, Run 2; a column is named with its run, `Run 2.y`",
    ),
    (
        "a row in the wrong place begins no run",
        "t [s],y\n0,30\n0.5,28\n1,23\n0,20\n1.5,15\n",
        "*t [s] header: 0 0.5 1 0 1.5
1:y [] not stated: 30 28 23 20 15",
    ),
    (
        "values that repeat are no clock",
        "angle [deg],y\n0,30\n1,28\n2,23\n0,20\n1,15\n2,12\n",
        "*angle [deg] header: 0 1 2 0 1 2
1:y [] not stated: 30 28 23 20 15 12",
    ),
];

/// Clocks.
const CLOCKS: &[Case] = &[
    (
        "times of day over midnight",
        "t,y\n23:59:59.900,1\n23:59:59.950,2\n00:00:00.000,3\n",
        "*t [s] clock: 0 0.05 0.1
1:y [] not stated: 1 2 3
! t holds clock times; they are read as seconds from the first row, and the clock began again at zero 1×",
    ),
    (
        "dates with times, decimal commas",
        "Datum;y\n2026-02-28T23:59:59,5;1,5\n2026-03-01T00:00:00,5;2,5\n",
        "*Datum [s] clock: 0 1
1:y [] not stated: 1.5 2.5
! Datum holds clock times; they are read as seconds from the first row",
    ),
    (
        "a date and a time",
        "Date,Time,y\n2026-01-02,10:00:00,1.5\n2026-01-02,10:00:02,2.5\n",
        "*Time [s] clock: 0 2
1:y [] not stated: 1.5 2.5
! column Date holds words and was left out
! Time holds clock times; they are read as seconds from the first row",
    ),
    (
        "a stopwatch",
        "t;y\n58.5;1\n59.5;2\n1:00.5;3\n1:01.5;4\n1:02.5;4\n",
        "*t [s] clock: 0 1 2 3 4
1:y [] not stated: 1 2 3 4 4
! t holds clock times; they are read as seconds from the first row",
    ),
    (
        "hours and minutes, or minutes and seconds",
        "t,y\n12:30,1\n12:31,2\n",
        "*t [s] clock: 0 1
1:y [] not stated: 1 2
! t holds clock times; they are read as seconds from the first row; `12:30` is taken for 12 minutes and 30 seconds: if these \
         are hours and minutes, say so in the header, `t [hh:mm]`",
    ),
    (
        "hours and minutes as the header says",
        "t [hh:mm],y\n12:30,1\n12:31,2\n",
        "*t [s] clock: 0 60
1:y [] not stated: 1 2
! t holds clock times; they are read as seconds from the first row",
    ),
    (
        "days",
        "day,spots\n2026-01-01,10\n2026-01-03,12\n",
        "*day [s] clock: 0 172800
1:spots [] not stated: 10 12
! day holds dates; they are read as seconds from the first row",
    ),
    (
        "a serial monitor's stamps before the device's own time",
        "12:00:00.003 -> millis,angle\n12:00:00.010 -> 1000,3.5\n12:00:00.061 -> 1050,2.5\n12:00:00.112 -> 1100,1.5\n12:00:02.010 -> 3000,1\n",
        "*millis [ms] name: 1000 1050 1100 3000
1:angle [] not stated: 3.5 2.5 1.5 1
! each line has a time stamp; the column behind it shows the same times in ms and is used instead, as it was not delayed on the way",
    ),
    (
        "a serial monitor's stamps alone",
        "12:00:00.010 -> 3.5\n12:00:00.060 -> 2.5\n12:00:00.110 -> 1.5\n",
        "* [s] clock: 0 0.05 0.1
1: [] not stated: 3.5 2.5 1.5
! column 1 holds clock times; they are read as seconds from the first row",
    ),
    (
        "times that cannot be read",
        "t,y,v\nsoon,1,2\nlater,2,3\nlast,3,4\n",
        "refused: line 2: the times in column t cannot be read; the first is `soon`",
    ),
];

#[test]
fn runs_have_clocks_of_their_own() {
    check(RUNS);
}

#[test]
fn clocks_are_read_as_seconds() {
    check(CLOCKS);
}

#[test]
fn columns_of_runs_are_found_by_run_name_and_heading() {
    let table = import::text(RUNS[0].1.as_bytes()).expect("a table").table;
    for (which, expected) in [
        ("Run 2.Angle", 3),
        ("Run #2.Angle", 3),
        ("run 2.angle", 3),
        ("Angle (deg) Run #2", 3),
        ("Angle", 1),
        ("Run 2.Time", 2),
    ] {
        assert_eq!(table.column(which), Ok(expected), "{which}");
    }
    let runs = table.runs();
    assert_eq!(runs, [("Run 1".to_owned(), vec![0, 1]), ("Run 2".to_owned(), vec![2, 3])]);
    // The bodies of a film belong together.
    let film = import::text(b"ball: t,ball: y,cart: t,cart: y\n0,30,0,20\n0.5,28,1,15\n").expect("a table").table;
    assert!(film.runs().is_empty());
    let both = import::text(b"t,T\n0,90\n60,80\n").expect("a table").table;
    assert_eq!((both.column("t"), both.column("T")), (Ok(0), Ok(1)));
}

#[test]
fn times_of_no_use_are_said() {
    let findings = |text: &str| -> Vec<String> {
        let table = import::text(text.as_bytes()).expect("a table").table;
        doubtful_times(&table).iter().map(|finding| finding.text(Language::English)).collect()
    };
    let same = findings("t [s],y\n5,1\n5,2\n5,3\n");
    assert_eq!(same, ["the times in t are missing or all the same: nothing can be measured against them"]);
    let unstated = findings("t,y\n0,1\n1,2\n2,3\n");
    assert!(unstated.len() == 1 && unstated[0].contains("they are taken for seconds"), "{unstated:?}");
    assert!(findings("t [s],y\n0,1\n1,2\n2,3\n").is_empty());
}

#[test]
fn rows_out_of_order_are_not_described_as_gaps() {
    let found = |text: &str, language: Language| -> Vec<String> {
        let table = import::text(text.as_bytes()).expect("a table").table;
        analysis::inspection::inspect(&table).findings.iter().map(|finding| finding.text(language)).collect()
    };
    let shuffled = "t [s],y\n0.3,1\n0.1,2\n0.5,3\n0.2,5\n0.4,3\n0,2\n";
    assert_eq!(
        found(shuffled, Language::English),
        [
            "the rows are not in the order of time: 3 are earlier than the row before, the first at 0.1 s; fits and cycles sort them by time"
        ]
    );
    let exchanged = "t [s],y\n0,1\n0.1,2\n0.3,5\n0.2,3\n0.4,2\n0.5,1\n";
    assert_eq!(
        found(exchanged, Language::English),
        [
            "the rows are not in the order of time: the row at 0.2 s is earlier than the row before; fits and cycles sort the rows by time, so \
          divide the file there if the clock began again"
        ]
    );
    assert!(found(exchanged, catalogues::with(Language::Spanish))[0].contains("ordenan las filas por tiempo"));
}
