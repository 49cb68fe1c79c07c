//! Display of the units and runs of a record.

use crate::support::utube;
use desk::{Desk, MOST_RECORDS, Refusal};

/// Quantity, unit, and `assumed` or `asked`, of each column of the record at this index.
fn units(desk: &Desk, record: usize) -> Vec<String> {
    let word = |assumed, asked| match (assumed, asked) {
        (true, _) => " assumed",
        (_, true) => " asked",
        _ => "",
    };
    let columns = desk.records().list().remove(record).columns;
    columns
        .iter()
        .map(|column| format!("{} {}{}", column.quantity, column.unit, word(column.unit_assumed, column.unit_asked)))
        .collect()
}

#[test]
fn assumed_units_are_marked_and_unknown_ones_asked_for() {
    let mut desk = utube();
    let id = desk.add_record("a", b"t,y [cm],v [ticks/s]\n0,1,2\n0.1,3,9\n0.2,4,1\n").unwrap();
    assert_eq!(units(&desk, 0), ["t s assumed", "y cm", "y'  asked"]);
    let origins = |desk: &Desk| -> Vec<String> {
        desk.records().list().remove(0).columns.into_iter().map(|column| column.unit_origin).collect()
    };
    assert_eq!(origins(&desk), ["assumed: the file states none", "from the header", "unknown unit: `ticks/s`"]);
    // A column without a known unit is not drawn until the user states it.
    let saved = desk.records().saved();
    desk.change_records(|records, open| records.set_unit(open, id, 2, "cm/s")).unwrap();
    desk.change_records(|records, open| records.set_unit(open, id, 0, "ms")).unwrap();
    assert_eq!(units(&desk, 0), ["t ms", "y cm", "y' cm/s"]);
    assert_eq!(origins(&desk), ["stated by you", "from the header", "stated by you"]);
    let mut other = utube();
    crate::support::bring_back_records(&mut other, &desk.records().saved());
    assert_eq!(units(&other, 0), units(&desk, 0));
    let mut before = utube();
    crate::support::bring_back_records(&mut before, &saved);
    assert_eq!(units(&before, 0), ["t s assumed", "y cm", "y'  asked"]);
    before.set_language("es");
    assert_eq!(origins(&before)[0], "supuesta: el archivo no la indica");
}

#[test]
fn a_time_in_an_unknown_unit_measures_nothing_until_it_is_stated() {
    let mut desk = utube();
    let id = desk.add_record("a", b"t [ticks],y [cm]\n0,1\n50,3\n100,4\n").unwrap();
    assert_eq!(units(&desk, 0), ["t  asked", "y cm"]);
    assert!(!desk.measured().has_points());
    desk.change_records(|records, open| records.set_unit(open, id, 0, "ms")).unwrap();
    assert!(desk.measured().has_points());
    // Constant times are not usable either.
    let mut desk = utube();
    desk.add_record("a", b"t [s],y [cm]\n5,1\n5,3\n5,4\n").unwrap();
    assert!(!desk.measured().has_points());
    let findings = desk.records().list().remove(0).findings;
    assert!(findings.iter().any(|finding| finding.contains("missing or all the same")), "{findings:?}");
}

#[test]
fn runs_become_records_with_their_own_clocks() {
    let mut desk = utube();
    let text = "\"Time (s) Run #1\",\"y (cm) Run #1\",\"Time (s) Run #2\",\"y (cm) Run #2\"\n0,1,0,2\n0.5,3,1,4\n1,5\n";
    desk.add_record("cart.csv", text.as_bytes()).unwrap();
    let records = desk.records().list();
    let found: Vec<(&str, usize)> = records.iter().map(|record| (record.name.as_str(), record.rows)).collect();
    assert_eq!(found, [("cart.csv: Run 1", 3), ("cart.csv: Run 2", 2)]);
    for record in 0..2 {
        assert_eq!(units(&desk, record), ["t s", "y cm"]);
    }
    assert_eq!(desk.records().cells(records[1].id, 0, 0..2), ["0", "1"]);
    // Records are added up to the maximum number.
    for _ in 0..3 {
        desk.add_record("cart.csv", text.as_bytes()).unwrap();
    }
    assert_eq!(desk.add_record("a", text.as_bytes()), Err(Refusal::TooManyRecords { most: MOST_RECORDS }));
    assert_eq!(desk.records().list().len(), MOST_RECORDS);
    // Bodies of a film stay together, and each has its own clock.
    let mut desk = utube();
    desk.add_record("film", b"A\t\tB\t\nt\ty\tt\ty\n0\t1\t0.1\t3\n0.2\t2\t0.3\t4\n").unwrap();
    assert_eq!(desk.records().list().len(), 1);
    assert_eq!(units(&desk, 0), ["t s assumed", "y m assumed", "t s assumed", " "]);
}
