//! Records of films beside others: their reports, their files, their errors.

use super::{columns, laboratory, ruler, surface, tracked};
use crate::support::followed;
use desk::{CalibrationForm, Desk, ExportKind, FilmedBody, Imprint, Lacking, Subject};
use figure::{Ink, Item, Settings};
use play::PlotId;

#[test]
fn the_report_of_a_fit_shows_the_film() {
    let mut desk = tracked();
    (0..4).chain([5]).for_each(|choice| desk.change_fits(|fits, data| fits.vary(data.play(), choice, true)));
    desk.change_fits(|fits, data| fits.begin(data, "column.md")).unwrap();
    while desk.advance_fit() {}
    let fit = desk.fits().list()[0].id;
    let report = |desk: &Desk| {
        let export = desk.fits().export(fit, ExportKind::Report, Imprint::default()).unwrap();
        String::from_utf8(export.bytes).unwrap()
    };
    let page = report(&desk);
    for text in [
        "<h2>The film swing.mp4</h2>",
        "<dt>Picture</dt>\n<dd>160 × 240 px</dd>",
        "<dd>75, 30 /s, 2.467 s</dd>",
        "<dt>Calibrated by</dt>\n<dd>10 cm</dd>",
        "with a standard error of 0.71 %",
        "Frame 1. Yellow: what was tracked. Red: the fitted curve. Blue: the calibration and its zero.",
        "The strip along the tube from every frame",
    ] {
        assert!(page.contains(text), "{text}");
    }
    assert_eq!(page.matches("href=\"data:image/png;base64,").count(), 2);
    let film = &page[page.find("<h2>The film").unwrap()..];
    let film = &film[..film.find("<h2>To repeat").unwrap()];
    assert!(film.len() < 200_000, "{}", film.len());
    // Over the space-time picture the fitted curve lies on the tracked one.
    let strip = &film[film.rfind("<svg").unwrap()..];
    let curve = |nth: usize| -> Vec<[f64; 2]> {
        let points = strip.split("points=\"").nth(nth).unwrap().split('"').next().unwrap();
        let number = |text: &str| text.parse::<f64>().unwrap();
        points.split(' ').map(|pair| pair.split_once(',').map(|(x, y)| [number(x), number(y)]).unwrap()).collect()
    };
    let (tracked, fitted) = (curve(1), curve(2));
    assert_eq!((tracked.len(), fitted.len()), (75, 75));
    assert!(tracked.iter().zip(&fitted).all(|(one, other)| one[0] == other[0] && (one[1] - other[1]).abs() < 1.5));
    // After the film is closed, the text about it remains.
    desk.change_films(|films, _| films.close());
    let page = report(&desk);
    assert!(page.contains("The film swing.mp4") && !page.contains("data:image/png"));
}

#[test]
fn a_record_of_a_film_is_saved_with_its_errors_and_scale() {
    let desk = tracked();
    let id = desk.records().list()[0].id;
    let csv = desk::export_record(&desk, id, ExportKind::Csv).unwrap();
    assert_eq!(csv.name, "swing.csv");
    let text = String::from_utf8(csv.bytes).unwrap();
    let mut lines = text.lines();
    assert!(lines.next().unwrap().starts_with("# relative standard error of the scale: 0.00707"), "{text}");
    assert_eq!(lines.next().unwrap(), "t [s],y [m],sigma_y [m]");
    assert_eq!(lines.count(), 75);
    let workbook = desk::export_record(&desk, id, ExportKind::Workbook).unwrap();
    // Both files are read back as the same record, including the error of the scale.
    for (name, bytes) in [("again.csv", text.into_bytes()), (workbook.name.as_str(), workbook.bytes)] {
        let mut again = laboratory();
        again.add_record(name, &bytes).unwrap();
        assert_eq!(columns(&again), columns(&desk), "{name}");
        let findings = again.records().list()[0].findings.clone();
        assert!(findings.iter().any(|one| one.contains("the film's scale, 0.71 %")), "{name}: {findings:?}");
    }
    assert_eq!(desk::export_record(&desk, 99, ExportKind::Csv), None);
}

#[test]
fn errors_are_drawn_and_a_fit_says_where_some_are_missing() {
    let mut desk = laboratory();
    let rows = (0..60).map(|row| {
        let t = f64::from(row) / 20.0;
        let sigma = if row % 20 == 7 { "" } else { "0.3" };
        format!("{t},{},{sigma}\n", 3.0 * libm::cos(7.5 * t))
    });
    let text = format!("t [s],y [cm],sigma_y [cm]\n{}", rows.collect::<String>());
    desk.add_record("swing.csv", text.as_bytes()).unwrap();
    let figure = followed(&mut desk).layout_plot(PlotId::at(0), &Settings::default()).unwrap();
    let bars =
        figure.items().filter(|item| matches!(item, Item::Line(_, _, stroke) if matches!(stroke.ink, Ink::Ghost(_))));
    // A line and two caps for each value that has an error.
    assert_eq!(bars.count(), 3 * 57);
    desk.change_fits(|fits, data| fits.vary(data.play(), 0, true));
    desk.change_fits(|fits, data| fits.begin(data, "column.md")).unwrap();
    while desk.advance_fit() {}
    let sentences = desk.fits().detail(desk.fits().list()[0].id).unwrap().sentences;
    let said = "swing.csv: 3 of 60 values of y have no standard error beside them";
    assert!(sentences.iter().any(|one| one.starts_with(said)), "{sentences:?}");
}

#[test]
fn a_column_needs_its_zero_and_a_body_does_not() {
    let body = Subject::Bodies(vec![FilmedBody { keys: Vec::new(), radius: None }]);
    let complete = ruler();
    let unset = CalibrationForm { origin: None, ..complete.clone() };
    let cases = [
        (&complete, surface(), None),
        (&unset, surface(), Some(Lacking::Origin)),
        (&unset, body.clone(), None),
        (&CalibrationForm::default(), surface(), Some(Lacking::Lengths)),
        (&CalibrationForm::default(), body, Some(Lacking::Lengths)),
    ];
    for (form, subject, expected) in cases {
        assert_eq!(form.lacking(&subject), expected, "{form:?} {subject:?}");
    }
}
