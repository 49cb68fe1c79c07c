//! Measured data beside the model: columns are recognised, points and residuals have the right positions, no record is
//! lost.

use crate::support::followed;
use crate::support::utube;
use desk::document;
use desk::{Desk, MOST_RECORDS, MeasurementForm, Refusal, SAMPLES};
use figure::{Item, Settings};
use play::Follows;
use play::PlotId;
use std::path::Path;
use units::number::typed::NotRead;

const THREE: &str = "0.1 0.40 -0.6\n0.2 0.33 -0.8\n0.3 0.24 -1.0\n0.4 0.13 -1.1\n";

fn meanings(desk: &Desk, record: usize) -> Vec<(String, String, bool)> {
    let columns = desk.records().list().remove(record).columns;
    columns.into_iter().map(|column| (column.quantity, column.unit, column.fitted)).collect()
}

fn owned(expected: &[(&str, &str, bool)]) -> Vec<(String, String, bool)> {
    expected.iter().map(|(name, unit, fitted)| ((*name).to_owned(), (*unit).to_owned(), *fitted)).collect()
}

fn theory(name: &str) -> document::Document {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../simulations/theories");
    let read = |name: String| std::fs::read_to_string(directory.join(name)).unwrap();
    document::open(&read(format!("{name}.md")), &[&read(format!("{name}.es.md"))]).document.unwrap()
}

/// Each record has the same colour in every plot, different from that of any curve.
#[test]
fn records_in_one_plot_have_colours_of_their_own() {
    let mut desk = utube();
    for (name, row) in [("a_1.txt", "0.1 0.4\n"), ("b.txt", "0.1 0.3\n")] {
        desk.add_record(name, [row, "0.2 0.33\n0.3 0.24\n"].concat().as_bytes()).unwrap();
    }
    let colours = |desk: &Desk, plot: PlotId, label: &str| {
        let legend = desk.play().plots().legend(plot);
        let own: Vec<u8> = legend.iter().filter(|one| one.label.starts_with(label)).map(|one| one.colour).collect();
        own
    };
    assert_eq!(colours(&desk, PlotId::at(0), "y ("), [3, 4]);
    assert_eq!(colours(&desk, desk.measured().residual_plot(), ""), [3, 4]);
}

#[test]
fn columns_are_taken_for_what_they_measure() {
    let mut desk = utube();
    for (text, expected) in [
        (THREE, vec![("t", "s", false), ("y", "m", true), ("y'", "m/s", false)]),
        (
            "t [ms]\ty [cm]\tfoo\n0\t1\t2\n33\t3\t9\n66\t4\t1\n",
            vec![("t", "ms", false), ("y", "cm", true), ("", "", false)],
        ),
        ("t;v_{y};x\n0;1,5;3\n1;2,5;9\n2;3;1\n", vec![("t", "s", false), ("y'", "m/s", true), ("y", "m", false)]),
        ("time,Displacement\n0,1\n1,2\n2,5\n", vec![("t", "s", false), ("y", "m", true)]),
        ("tiempo,desplazamiento\n0,1\n1,2\n2,5\n", vec![("t", "s", false), ("y", "m", true)]),
        ("t,mass [kg]\n0,1\n1,2\n2,5\n", vec![("t", "s", false), ("", "kg", false)]),
    ] {
        let id = desk.add_record("a", text.as_bytes()).unwrap();
        assert_eq!(meanings(&desk, 0), owned(&expected), "{text}");
        desk.change_records(|records, _| records.remove(id));
    }
    // The theories measure a level that is not an unknown.
    let mut other = Desk::open(theory("linear"));
    other.add_record("a", "t\ty\tv\n0\t1\t2\n1\t3\t9\n2\t4\t1\n".as_bytes()).unwrap();
    assert_eq!(meanings(&other, 0), owned(&[("t", "s", false), ("y", "m", true), ("x'", "m/s", false)]));
}

#[test]
fn columns_are_taken_for_what_a_person_says() {
    let mut desk = utube();
    let id = desk.add_record("a", THREE.as_bytes()).unwrap();
    desk.change_records(|records, open| records.set_unit(open, id, 1, "cm")).unwrap();
    assert_eq!(
        desk.change_records(|records, open| records.set_unit(open, id, 1, "kg")).unwrap_err(),
        Refusal::Play(NotRead::WrongUnit { typed: "kg".into(), expected: "m".into() }.into())
    );
    assert!(matches!(
        desk.change_records(|records, open| records.set_unit(open, id, 1, "wibble")),
        Err(Refusal::Play(play::Refusal::NotRead(NotRead::NotAUnit { .. })))
    ));
    desk.change_records(|records, open| records.set_quantity(open, id, 2, ""));
    desk.change_records(|records, _| records.set_fitted(id, 1, false));
    assert_eq!(meanings(&desk, 0), owned(&[("t", "s", false), ("y", "cm", false), ("", "m/s", false)]));
    // A chosen quantity stays where the next document has it too; all others are recognised again.
    let mut linear = Desk::open(theory("linear"));
    linear.adopt(&mut desk);
    assert_eq!(meanings(&linear, 0), owned(&[("t", "s", false), ("y", "cm", false), ("", "m/s", false)]));
    assert_eq!(desk.records().list().len(), 0);
}

#[test]
fn what_cannot_be_read_says_why_and_loses_nothing() {
    let mut desk = utube();
    desk.set_language("es");
    desk.add_record("a", THREE.as_bytes()).unwrap();
    let refusal = desk.add_record("foto.png", b"\x89PNG\r\n\x1a\n\0\0").unwrap_err();
    let text = refusal.text(desk.play());
    assert!(text.starts_with("No se pudo leer foto.png. No es texto"), "{text}");
    assert_eq!(desk.records().list().len(), 1);
    for _ in 1..MOST_RECORDS {
        desk.add_record("b", THREE.as_bytes()).unwrap();
    }
    assert_eq!(desk.add_record("c", THREE.as_bytes()), Err(Refusal::TooManyRecords { most: MOST_RECORDS }));
}

/// The centres of the dots of a figure, as values of its first axes.
fn dots(desk: &mut Desk, plot: usize) -> Vec<(f64, f64)> {
    let figure = followed(desk).layout_plot(PlotId::at(plot), &Settings::default()).unwrap();
    let (x, y) = (*figure.x_scale().unwrap(), figure.y_scales()[0]);
    let centres = figure.items().filter_map(|item| match item {
        Item::Dots { centres, ringed: false, .. } => Some(centres.to_vec()),
        _ => None,
    });
    let centres: Vec<f32> = centres.flatten().collect();
    // Dots of the legend are above the panel.
    let inside = centres.chunks(2).filter(|at| at[1] >= figure.panel.y);
    inside.map(|at| (x.value(at[0].into()), y.value(at[1].into()))).collect()
}

#[test]
fn points_lie_where_they_were_measured() {
    let mut desk = utube();
    let id = desk.add_record("a", "t [ms];y [cm]\n1100;40\n1200;33\n1500;12\n".as_bytes()).unwrap();
    let near = |found: Vec<(f64, f64)>, expected: &[(f64, f64)]| {
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for (one, other) in found.iter().zip(expected) {
            assert!((one.0 - other.0).abs() < 0.02 && (one.1 - other.1).abs() < 0.01, "{found:?}");
        }
    };
    // The model begins with the record, regardless of the clock's first reading.
    near(dots(&mut desk, 0), &[(0.0, 0.4), (0.1, 0.33), (0.4, 0.12)]);
    // The record has no points in the phase portrait.
    assert_eq!(dots(&mut desk, 1), []);
    desk.change_records(|records, _| records.show(id, false));
    assert_eq!(dots(&mut desk, 0), []);
    desk.change_records(|records, _| records.show(id, true));
    desk.change_records(|records, _| records.remove(id));
    // Position and velocity together are a point of the phase portrait.
    desk.add_record("b", THREE.as_bytes()).unwrap();
    near(dots(&mut desk, 1), &[(0.40, -0.6), (0.33, -0.8), (0.24, -1.0), (0.13, -1.1)]);
}

#[test]
fn a_measurement_without_errors_leaves_nothing_over() {
    let mut desk = utube();
    let mut form = MeasurementForm::suited(desk.play());
    assert_eq!(form.quantity, "y");
    for field in [2, 3, 4, 5] {
        form.fields[field] = "0".to_owned();
    }
    form.fields[1] = "4".to_owned();
    desk.change_records(|records, open| records.measure(open, "exact", &form)).unwrap();
    let record = desk.records().list().remove(0);
    assert!(record.synthetic);
    assert_eq!(record.rows, 121);
    // The velocities were computed by the tracking program, which is detected.
    assert!(
        record.findings.iter().any(|finding| finding.contains("no independent information")),
        "{:?}",
        record.findings
    );
    let residuals = desk.document().program.plots.len();
    assert!(desk.play().plots().list()[residuals].offered);
    desk.play_mut().change_run(|line, _| line.play());
    (0..40).for_each(|_| assert!(desk.play_mut().change_run(|line, _| line.tick(0.05))));
    desk.play_mut().change_run(|line, _| line.pause());
    let plot = dots(&mut desk, residuals);
    // Residuals exist up to the front of the run. The position is exact to the step of the run.
    let (zero, finite): (Vec<_>, Vec<_>) = plot.iter().partition(|(_, left)| left.abs() < 1e-4);
    assert!(zero.len() > 50 && zero.iter().all(|(time, _)| *time <= desk.play().course().time() + 1e-6), "{plot:?}");
    assert!(finite.iter().all(|(_, left)| left.abs() < 0.01), "{finite:?}");
    desk.play_mut().change_run(|line, basis| line.back_to_start(basis));
    assert!(dots(&mut desk, residuals).len() <= 2);
}

#[test]
fn each_error_of_a_measurement_is_checked() {
    let mut desk = utube();
    let good = MeasurementForm::suited(desk.play());
    for (field, typed) in [(0, "0"), (0, "much"), (1, "-3"), (2, "-1"), (3, "2 kg"), (6, "-1")] {
        let mut form = good.clone();
        form.fields[field] = typed.to_owned();
        let (found, _) = desk.change_records(|records, open| records.measure(open, "a", &form)).unwrap_err();
        assert_eq!(found, field, "{typed}");
    }
    assert_eq!(desk.records().list().len(), 0);
    desk.change_records(|records, open| records.measure(open, "a", &good)).unwrap();
    desk.change_records(|records, open| records.measure(open, "b", &good)).unwrap();
    let cells = |id| desk.records().cells(id, 1, 0..400);
    assert_eq!(cells(0), cells(1), "the same seed, the same errors");
}

#[test]
fn the_ghost_shows_the_measured_level() {
    for (mut desk, names) in [(utube(), 2), (Desk::open(theory("linear")), 1), (Desk::open(theory("cosine")), 1)] {
        assert!(followed(&mut desk).values().outline().is_none_or(|outline| outline.values.is_none()));
        // A state that the model never has, so that no computed value equals it.
        desk.add_record("a", "t y\n0 0.01\n0.1 0.03\n0.2 0.02\n0.3 0.01\n1.2 0\n1.3 0.01\n".as_bytes()).unwrap();
        let follows = followed(&mut desk).values().outline().map_or_else(Vec::new, |outline| outline.follows.clone());
        assert!(follows.iter().filter(|follows| **follows == Follows::Measured).count() >= names);
        let moved: Vec<usize> = (0..follows.len()).filter(|&index| follows[index] == Follows::Measured).collect();
        let ghost = |desk: &mut Desk| {
            followed(desk)
                .values()
                .outline()
                .and_then(|outline| outline.values.clone())
                .map(|values| moved.iter().map(|&index| values[index]).collect::<Vec<_>>())
        };
        let first = ghost(&mut desk).expect("measured at 0");
        desk.play_mut().change_run(|line, _| line.play());
        desk.play_mut().change_run(|line, _| line.tick(0.15));
        assert_ne!(ghost(&mut desk).expect("between two rows"), first);
        desk.play_mut().change_run(|line, _| line.tick(0.5));
        assert_eq!(ghost(&mut desk), None, "in a gap nothing was measured");
        // Other parameters do not change the outline.
        desk.play_mut().change_run(|line, _| line.scrub(0.0));
        assert_eq!(ghost(&mut desk), Some(first));
    }
}

#[test]
fn records_come_back() {
    let mut desk = utube();
    let id = desk.add_record("línea\n1", THREE.as_bytes()).unwrap();
    desk.change_records(|records, open| records.set_unit(open, id, 1, "cm")).unwrap();
    desk.change_records(|records, _| records.show(id, false));
    let form = MeasurementForm::suited(desk.play());
    desk.change_records(|records, open| records.measure(open, "virtual", &form)).unwrap();
    let saved = desk.records().saved();
    assert_eq!(saved.len(), 2);
    let mut later = utube();
    crate::support::bring_back_records(&mut later, &saved);
    let (before, after) = (desk.records().list(), later.records().list());
    assert_eq!(after.len(), 2);
    assert_eq!(after[0].name, "línea 1");
    assert_eq!(after[0].columns, before[0].columns);
    assert_eq!((after[0].shown, after[1].shown, after[1].synthetic), (false, true, true));
    assert_eq!(later.records().saved(), saved, "names and texts are the same at every visit");
    // Two equal records have different names.
    later.add_record("línea 1", THREE.as_bytes()).unwrap();
    let names: Vec<String> = later.records().saved().into_iter().map(|(name, _)| name).collect();
    assert!(names.len() == 3 && names[0] != names[2] && names[1] != names[2], "{names:?}");
    // A record that is too large for the browser's storage is left out.
    let rows: String = (0..200_000).map(|row| format!("{row} {row}\n")).collect();
    desk.add_record("long", rows.as_bytes()).unwrap();
    assert_eq!(desk.records().saved(), saved);
    assert_eq!(desk.records().list().iter().map(|record| record.lasting).collect::<Vec<_>>(), [true, true, false]);
}

#[test]
fn samples_are_made_and_fitted() {
    let mut desk = Desk::open(theory("linear"));
    for (index, sample) in SAMPLES.iter().enumerate() {
        let name = sample.file.trim_start_matches("theories/").trim_end_matches(".md");
        desk.change_records(|records, open| records.add_sample(open, index, theory(name))).unwrap();
    }
    let records = desk.records().list();
    assert!(records.iter().all(|record| record.synthetic && record.rows == 241));
    desk.choose_record(records[1].id);
    desk.change_fits(|fits, data| fits.begin(data, "theories/linear.md")).unwrap();
    while desk.advance_fit() {}
    let fit = desk.fits().list().remove(0);
    let detail = desk.fits().detail(fit.id).unwrap();
    let length = detail.estimates.iter().find(|one| one.name == "L").unwrap();
    assert!(length.value.starts_with("0.24") || length.value.starts_with("0.23"), "{length:?}");
    assert!(length.remark.starts_with("true value: 0.24 m; deviation "), "{length:?}");
    // The fit is applied to the sliders, and the run covers the whole record.
    assert!((desk.play().course().parameters()[0] - 0.24).abs() < 0.001);
    assert!((desk.play().course().front() - 8.0).abs() < 0.05, "{}", desk.play().course().front());
    assert_eq!(desk.play().course().time(), 0.0);
}

#[test]
fn theories_are_ranked() {
    let mut desk = utube();
    desk.change_records(|records, open| records.add_sample(open, 0, theory("linear"))).unwrap();
    let names = ["quadratic", "linear", "cosine"];
    let theories = names.map(|name| (format!("theories/{name}.md"), theory(name)));
    desk.change_fits(|fits, data| fits.begin_ranking(data, theories.to_vec())).unwrap();
    assert_eq!(desk.fits().progress().unwrap().finished, (0, 3));
    while desk.advance_fit() {}
    let fits = desk.fits().list();
    assert_eq!(fits.len(), 3);
    assert_eq!(fits[0].theory, theory("linear").program.title);
    assert_eq!(desk.fits().texts(fits[0].id)[0].0, "theories/linear.md");
    assert_eq!(fits[0].difference, "0.0");
    assert!(fits.iter().all(|fit| !fit.applicable), "another document is open");
    // In a desk with its document open, the fit can be applied.
    let mut opened = Desk::open(theory("linear"));
    opened.adopt(&mut desk);
    assert!(opened.fits().list()[0].applicable);
    opened.apply_fit(fits[0].id);
    assert!((opened.play().course().parameters()[0] - 0.18).abs() < 0.003);
    // A fit can be cancelled.
    opened.change_fits(|fits, data| fits.begin(data, "theories/linear.md")).unwrap();
    opened.change_fits(|fits, _| fits.cancel());
    assert!(!opened.advance_fit());
    assert_eq!(opened.fits().progress(), None);
}

#[test]
fn what_cannot_be_fitted_is_said() {
    let mut desk = utube();
    desk.add_record("a", THREE.as_bytes()).unwrap();
    let said = |desk: &mut Desk| {
        let refusal = desk.change_fits(|fits, data| fits.begin(data, "utube.md")).unwrap_err();
        refusal.text(desk.play())
    };
    assert_eq!(said(&mut desk), "Tick what is to be varied.");
    (0..5).for_each(|parameter| desk.change_fits(|fits, data| fits.vary(data.play(), parameter, true)));
    assert_eq!(said(&mut desk), "4 values cannot determine 5 numbers.");
    desk.change_fits(|fits, data| fits.set_window(data.play(), 0, "7 s")).unwrap();
    assert!(said(&mut desk).starts_with("No column is ticked"));
    assert_eq!(desk.fits().window(), ["7".to_owned(), String::new()]);
    assert!(desk.change_fits(|fits, data| fits.set_window(data.play(), 1, "3 kg")).is_err());
}

#[test]
fn columns_without_names_measure_what_the_document_draws_first() {
    let source = "---\ntitle: T\n---\n\n```model\nparameter c = 1 [m]\nf' = -f\nx'' = -x + f\nf(0) = 0 [m/s^2]\nx(0) = 1 [m]\n\
        x'(0) = 0\ny = x + c\n```\n\n```plots\n\"Level\": y against t\n\"Force\": f against t\n```\n";
    let source = source.replace("-x + f", "-x/(1 [s^2]) + f").replace("f' = -f", "f' = -f/(1 [s])");
    let opened = document::open(&source, &[]);
    let document = opened.document.unwrap_or_else(|| panic!("{:#?}", opened.diagnostics));
    let mut desk = Desk::open(document);
    desk.add_record("run.txt", b"0 1.5 0.2\n0.1 1.4 0.3\n0.2 1.2 0.1\n0.3 1.0 0.4\n").unwrap();
    let records = desk.records().list();
    let taken: Vec<&str> = records[0].columns.iter().map(|column| column.quantity.as_str()).collect();
    // The third column is ambiguous.
    assert_eq!(taken, ["t", "y", ""]);
}
