//! Hidden values are in nothing that the laboratory writes.

use crate::course::unzipped;
use class::verify::hand_in;
use desk::{Desk, ExportKind, Imprint, MeasurementForm};
use document::page::Source;
use saved::hand_in::Sender;
use saved::project::Project;

const TUBE: &str = include_str!("../../../play/tests/all/support/assigned.md");

/// Texts in the files of a workbook, or the bytes of another file.
fn text(bytes: Vec<u8>) -> String {
    if !bytes.starts_with(b"PK") {
        return String::from_utf8(bytes).unwrap();
    }
    unzipped(&bytes).into_iter().map(|(_, content)| content).collect()
}

#[test]
fn a_hidden_value_is_in_no_file_of_the_laboratory() {
    let mut desk = Desk::open(document::open(TUBE, &[]).sound().unwrap());
    desk.play_mut().set_seat("7").unwrap();
    let parameters = &desk.play().model().parameters;
    let index = parameters.iter().position(|parameter| parameter.name == "zeta_q").unwrap();
    let hidden = desk.play().course().parameters()[index];
    // A run, measurements by the two instruments, and a fit of what is not hidden.
    desk.play_mut().change_run(|line, _| line.play());
    desk.play_mut().change_run(|line, _| line.tick(1.0));
    desk.play_mut().change_run(|line, _| line.pause());
    desk.play_mut().change_run(|line, basis| line.keep(basis)).unwrap();
    let form = MeasurementForm::suited(desk.play());
    let record = desk.change_records(|records, open| records.measure(open, "camera", &form)).unwrap();
    let c = desk.fits().choices().iter().position(|choice| choice.name == "c").unwrap();
    let varied = desk.fits().choices()[c].index;
    desk.change_fits(|fits, data| fits.vary(data.play(), varied, true));
    desk.change_fits(|fits, data| fits.begin(data, "tube.md")).unwrap();
    while desk.advance_fit() {}
    desk.play_mut().change_answers(|answers, run| answers.check(run, 0, "0.1"));
    let fit = desk.fits().list()[0].id;

    let mut files = vec![
        ("list of what a fit can vary", format!("{:?}", desk.fits().choices())),
        ("records", format!("{:?}", desk.records().list())),
        ("fits", format!("{:?}", desk.fits().list())),
        ("detail of a fit", format!("{:?}", desk.fits().detail(fit))),
        ("link", desk.play().share()),
        ("workbook", text(desk::workbook(&desk))),
        ("facts", format!("{:?}", desk::facts(&desk))),
        ("items of a project", format!("{:?}", desk::project_items(&desk, 5))),
    ];
    for kind in [ExportKind::Csv, ExportKind::Workbook] {
        files.push(("record", text(desk::export_record(&desk, record, kind).unwrap().bytes)));
    }
    for kind in [ExportKind::Csv, ExportKind::Workbook, ExportKind::Report] {
        files.push(("fit", text(desk.fits().export(fit, kind, Imprint::default()).unwrap().bytes)));
    }
    let documents = vec![Source { name: "tube.md".to_owned(), text: TUBE.to_owned() }];
    let work = Project { documents, state: desk.play().share(), items: desk::project_items(&desk, 5) };
    let sender = Sender { name: "a".to_owned(), seat: Some(7), assignment: "tube-2026".to_owned() };
    files.push(("hand-in", hand_in(work, sender, 6).unwrap().write()));

    // Digits of the value and of the time that follows from it, as far as three figures after the point tell them from others.
    let digits = |value: f64| format!("{value:.4}").trim_start_matches('0').trim_end_matches('0').to_owned();
    for secret in [digits(hidden), digits(1.0 / hidden)] {
        assert!(secret.len() > 3, "{secret} is found by accident");
        for (name, content) in &files {
            assert!(content.len() > 10, "{name} is empty");
            assert!(!content.contains(&secret), "{secret} in {name}: {content}");
        }
    }
    // The search would find the value that the seat gives to a parameter that is shown.
    let shown = desk.play().course().parameters()[0];
    let finds = files.iter().filter(|(_, content)| content.contains(&digits(shown))).count();
    assert!(finds >= 5, "{} in {finds} files", digits(shown));
}
