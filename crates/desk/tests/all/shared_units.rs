//! One unit for the numbers of a record, and rows that are left out, in the page.

use desk::Desk;
use document::Document;
use std::fmt::Write;

fn theory(unit: &str) -> Document {
    let text = format!(
        "---\ntitle: In {unit}\nvary: A, w, k\n---\n\n```model\nparameter A = 0.04 [m] in -1..1\nparameter w = 9 [1/s] in 1..20\nparameter k = \
         0.4 [1/s] in 0..5\n\ny = A*exp(-k*t)*cos(w*t) in [{unit}]\n```\n\n```plots\ny against t\n```\n"
    );
    document::open(&text, &[]).document.unwrap()
}

/// Numbers of a decaying oscillation of 3.5 cm, those of metres times `size`; row 40 is wrong.
fn record(size: f64) -> String {
    let mut text = String::new();
    for row in 0..100 {
        let t = f64::from(row) * 0.03;
        let off = 2e-4 * libm::sin(f64::from(37 * row * row + 11)) + if row == 40 { 0.02 } else { 0.0 };
        let y = 0.035 * libm::exp(-0.5 * t) * libm::cos(9.4 * t) + off;
        writeln!(text, "{t:.2} {:.9}", y * size).unwrap();
    }
    text
}

fn unit(desk: &Desk) -> String {
    desk.records().list()[0].columns[1].unit.clone()
}

/// A ranking gives one unit to all theories, whichever document is open, and asks where that is not known.
#[test]
fn a_ranking_reads_a_column_in_one_unit() {
    let cases = [("cm", 1.0, "m"), ("m", 1.0, "m"), ("mm", 1.0, "m"), ("cm", 100.0, "cm")];
    for (open, size, expected) in cases {
        let mut desk = Desk::open(theory(open));
        desk.add_record("run.txt", record(size).as_bytes()).unwrap();
        assert_eq!(unit(&desk), expected, "{open} {size}");
        let theories = ["m", "cm"].map(|unit| (format!("{unit}.md"), theory(unit)));
        desk.change_fits(|fits, data| fits.begin_ranking(data, theories.to_vec())).unwrap();
        while desk.advance_fit() {}
        let fits = desk.fits().list();
        assert_eq!(fits.len(), 2);
        // Both theories have one curve, so neither is better.
        assert!(fits.iter().all(|fit| fit.difference == "0.0"), "{open} {size} {fits:?}");
        let said = desk.fits().detail(fits[0].id).unwrap().sentences.join(" ");
        assert!(said.contains(&format!("its numbers are read in {expected}.")), "{said}");
    }
    let mut desk = Desk::open(theory("m"));
    desk.add_record("run.txt", record(100.0).as_bytes()).unwrap();
    let theories = ["m", "cm"].map(|unit| (format!("{unit}.md"), theory(unit)));
    let refusal = desk.change_fits(|fits, data| fits.begin_ranking(data, theories.to_vec())).unwrap_err();
    let why = refusal.text(desk.play());
    assert!(why.starts_with("run.txt states no unit of column 2, and it can be m and cm."), "{why}");
    let id = desk.records().list()[0].id;
    desk.change_records(|records, open| records.set_unit(open, id, 1, "cm")).unwrap();
    desk.change_fits(|fits, data| fits.begin_ranking(data, theories.to_vec())).unwrap();
}

#[test]
fn a_row_that_is_left_out_counts_for_nothing_and_stays() {
    let mut desk = Desk::open(theory("m"));
    desk.add_record("run.txt", record(1.0).as_bytes()).unwrap();
    let id = desk.records().list()[0].id;
    desk.change_records(|records, _| records.exclude(id, 40, true));
    assert_eq!((desk.records().list()[0].excluded, desk.records().list()[0].rows), (1, 100));
    desk.change_fits(|fits, data| fits.begin(data, "m.md")).unwrap();
    while desk.advance_fit() {}
    let fit = &desk.fits().list()[0];
    assert_eq!(fit.counts, (99, 4));
    let said = desk.fits().detail(fit.id).unwrap().sentences.join(" ");
    assert!(said.contains("Values left out by hand: 1."), "{said}");
    // The value of a drawn column is that of its row, also in a record whose rows are not in the order of time.
    desk.leave_out(0, 40);
    assert_eq!(desk.records().list()[0].excluded, 0);
    let mut rows: Vec<String> = record(1.0).lines().map(str::to_owned).collect();
    rows.reverse();
    let id = desk.add_record("reversed.txt", rows.join("\n").as_bytes()).unwrap();
    desk.leave_out(1, 40);
    let list = desk.records().list();
    assert_eq!((list[0].excluded, list[1].excluded), (0, 1));
    let announced = std::iter::from_fn(|| desk.take_announcement()).last();
    assert_eq!(
        announced,
        Some(desk::Announcement::RowLeftOut { record: "reversed.txt".to_owned(), row: 60, counts: false })
    );
    desk.change_records(|records, _| records.include_all(id));
    assert_eq!(desk.records().list()[0].excluded, 0);
}
