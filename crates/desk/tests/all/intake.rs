//! Files that become records in slices, and records of very many rows.

use crate::support::followed;
use crate::support::utube;
use analysis::spreadsheet::{Sheet, Workbook};
use desk::{Announcement, DateOrder, Desk, LONGEST_RECORD, Refusal};
use play::PlotId;

const TABLE: &str = "t [s]\ty [m]\n0\t0.4\n0.5\t0.33\n1\t0.2\n1.5\tword\n2\t-0.1\n";

/// Reads a file to its end. Returns the id of the record and the last progress before the end.
fn read(desk: &mut Desk, name: &str, bytes: &[u8], budget: usize) -> Result<(u32, f64), Refusal> {
    read_dated(desk, name, bytes, budget, None)
}

/// As [`read`], with the order of day and month that a person states.
fn read_dated(
    desk: &mut Desk,
    name: &str,
    bytes: &[u8],
    budget: usize,
    dates: Option<DateOrder>,
) -> Result<(u32, f64), Refusal> {
    desk.change_records(|records, open| records.begin(open, name, bytes.to_vec(), dates))?;
    let mut part = 0.0;
    loop {
        if let Some(progress) = desk.records().progress() {
            assert_eq!(progress.name, name);
            assert!(progress.part >= part, "{} after {part}", progress.part);
            part = progress.part;
        }
        let is_read = desk.records().is_read();
        let added = desk.advance_record(budget)?;
        assert_eq!(added.is_some(), is_read, "a read record is added by one call, and no other");
        if let Some(id) = added {
            assert_eq!(desk.records().progress(), None);
            return Ok((id, part));
        }
    }
}

#[test]
fn a_record_is_the_same_in_slices_as_at_once() {
    let sheet = Sheet::of_columns("Film", &["t [s]", "y [cm]"], &[&[0.0, 0.5, 1.0, 1.5], &[40.0, 33.0, 20.0, 1.0]]);
    let workbook = Workbook { sheets: vec![sheet] }.xlsx();
    for bytes in [TABLE.as_bytes(), &workbook] {
        let (mut slices, mut whole) = (utube(), utube());
        let (id, part) = read(&mut slices, "film", bytes, 7).unwrap();
        assert!(part > 0.5, "{part}");
        assert_eq!(whole.add_record("film", bytes).unwrap(), id);
        assert_eq!(slices.records().list(), whole.records().list());
        assert_eq!(slices.records().saved(), whole.records().saved());
        // A workbook is restored from its text.
        let mut later = utube();
        crate::support::bring_back_records(&mut later, &slices.records().saved());
        assert_eq!(later.records().list()[0].columns, slices.records().list()[0].columns);
    }
}

#[test]
fn a_file_that_is_given_up_leaves_nothing() {
    let mut desk = utube();
    desk.change_records(|records, open| records.begin(open, "film", TABLE.as_bytes().to_vec(), None)).unwrap();
    desk.advance_record(1).unwrap();
    desk.change_records(|records, _| records.cancel("film"));
    assert_eq!((desk.records().progress(), desk.records().list().len()), (None, 0));
    assert_eq!(desk.take_announcement(), Some(Announcement::RecordCancelled("film".to_owned())));
    assert_eq!(desk.advance_record(1), Ok(None));
    // A file that is not a table leaves no trace, and the next file is read.
    let refusal = read(&mut desk, "words", b"no numbers\nat all\n", 4).unwrap_err();
    assert!(matches!(refusal, Refusal::UnreadableRecord { .. }), "{refusal:?}");
    assert_eq!(desk.records().progress(), None);
    read(&mut desk, "film", TABLE.as_bytes(), 1 << 20).unwrap();
    // Neither does a file that is too large.
    let refusal = desk
        .change_records(|records, open| records.begin(open, "huge", vec![b'1'; LONGEST_RECORD + 1], None))
        .unwrap_err();
    assert_eq!(refusal, Refusal::RecordTooLong { most: LONGEST_RECORD >> 20 });
}

#[test]
fn a_file_whose_dates_are_open_is_read_when_their_order_is_chosen() {
    const DATED: &str = "date;y (m)\n02/03/2024;0.4\n03/03/2024;0.3\n05/03/2024;0.1\n";
    let mut desk = utube();
    let refusal = read(&mut desk, "dated", DATED.as_bytes(), 9).unwrap_err();
    assert!(refusal.asks_dates());
    let Refusal::UnreadableRecord { why, .. } = refusal else { panic!("{refusal:?}") };
    assert!(why.ends_with("Choose the order of day and month, or write the dates as 2026-01-02."), "{why}");
    let (id, _) = read_dated(&mut desk, "dated", DATED.as_bytes(), 9, Some(DateOrder::MonthFirst)).unwrap();
    let span = |desk: &Desk| desk.records().list().last().map(|record| format!("{:?}", record.columns[0]));
    // Stored and brought back, the record has the chosen order.
    let mut later = utube();
    crate::support::bring_back_records(&mut later, &desk.records().saved());
    assert_eq!(span(&later), span(&desk));
    // A file that is pasted raises the question again; one that is refused for another reason does not.
    assert!(desk.add_record("pasted", DATED.as_bytes()).unwrap_err().asks_dates());
    assert!(!read(&mut desk, "words", b"no numbers\nat all\n", 4).unwrap_err().asks_dates());
    assert_ne!(read(&mut desk, "film", TABLE.as_bytes(), 1 << 20).unwrap().0, id);
}

#[test]
fn residuals_of_a_long_record_follow_in_slices() {
    let rows: String = (0..30_000).map(|row| format!("{}\t0.1\n", f64::from(row) * 1e-4)).collect();
    let mut desk = utube();
    desk.add_record("long", format!("t [s]\ty [m]\n{rows}").as_bytes()).unwrap();
    desk.play_mut().change_run(|line, _| line.play());
    for _ in 0..40 {
        desk.play_mut().change_run(|line, _| line.tick(0.1));
    }
    desk.play_mut().change_run(|line, _| line.pause());
    let settings = figure::Settings::default();
    let plots = desk.play().plots().list().len();
    let mut frames = 0;
    while desk.measured().lags(desk.play()) {
        let before = desk.revision();
        for index in 0..plots {
            followed(&mut desk).layout_plot(PlotId::at(index), &settings);
        }
        assert_ne!(desk.revision(), before, "what lags must be drawn again");
        frames += 1;
        assert!(frames < 100);
    }
    assert!(frames > 1, "{frames}");
}
