//! Derivatives of a column made by the user, and measured points under the pointer.

use crate::support::followed;
use crate::support::{play, utube};
use desk::{Desk, Differentiation, Refusal};
use figure::{Point, Settings};
use play::PlotId;

/// Rows of `y = 5 sin 2t` in centimetres, with one frame missing.
fn film() -> String {
    let mut text = "t [ms]\ty [cm]\n".to_owned();
    for frame in (0..100).filter(|frame| *frame != 50) {
        let t = f64::from(frame) / 20.0;
        text += &format!("{:.0}\t{:.6}\n", t * 1e3, 5.0 * libm::sin(2.0 * t));
    }
    text
}

fn columns(desk: &Desk) -> Vec<(String, String, String)> {
    let columns = desk.records().list().remove(0).columns;
    columns.into_iter().map(|column| (column.head, column.quantity, column.made)).collect()
}

#[test]
fn derivatives_are_columns_that_are_no_witnesses() {
    let mut desk = utube();
    let id = desk.add_record("film", film().as_bytes()).unwrap();
    desk.change_records(|records, open| records.make_derivatives(open, id, 1, Differentiation::Central)).unwrap();
    assert_eq!(
        columns(&desk)[2..],
        [
            ("y' [cm/ms]".to_owned(), "y'".to_owned(), "central differences".to_owned()),
            ("y'' [cm/ms²]".to_owned(), "y''".to_owned(), "central differences".to_owned()),
        ]
    );
    let number = |cell: &str| cell.replace('−', "-").parse::<f64>().unwrap();
    let cells = desk.records().cells(id, 2, 0..99);
    // The ends and both sides of the gap have no neighbours.
    let gaps: Vec<usize> = (0..99).filter(|row| cells[*row].is_empty()).collect();
    assert_eq!(gaps, [0, 49, 50, 98]);
    // (y[i+1] - y[i-1])/(2 dt), at 1 s.
    let exact = (5.0 * libm::sin(2.1) - 5.0 * libm::sin(1.9)) / 100.0;
    assert!((number(&cells[20]) - exact).abs() < 1e-6, "{} is not {exact}", cells[20]);
    // A derivative is not independent information, and fits do not use it by default.
    let fitted: Vec<bool> = desk.records().list()[0].columns.iter().map(|column| column.fitted).collect();
    assert_eq!(fitted, [false, true, false, false]);

    // The derivatives are made again with polynomials, which leave no gap beside a missing frame.
    desk.change_records(|records, open| {
        records.make_derivatives(open, id, 1, Differentiation::Smooth { window: 5, degree: 3 })
    })
    .unwrap();
    assert_eq!(columns(&desk).len(), 4);
    let cells = desk.records().cells(id, 2, 0..99);
    assert!(cells.iter().all(|cell| !cell.is_empty()));
    assert!((number(&cells[20]) - 0.01 * libm::cos(2.0)).abs() < 1e-5, "{}", cells[20]);

    assert_eq!(
        desk.change_records(|records, open| records.make_derivatives(
            open,
            id,
            1,
            Differentiation::Smooth { window: 4, degree: 3 }
        )),
        Err(Refusal::NoSuchPolynomial)
    );
    desk.change_records(|records, _| records.forget_derivatives(id));
    assert_eq!(columns(&desk).len(), 2);
}

#[test]
fn what_was_made_follows_its_source_and_comes_back() {
    let mut desk = utube();
    let rows = film().replace("t [ms]\ty [cm]\n", "").replace('\t', " ");
    let id = desk.add_record("film", rows.as_bytes()).unwrap();
    desk.change_records(|records, open| records.set_unit(open, id, 0, "ms")).unwrap();
    desk.change_records(|records, open| records.make_derivatives(open, id, 1, Differentiation::Forward)).unwrap();
    desk.change_records(|records, open| records.set_unit(open, id, 1, "cm")).unwrap();
    let made = |desk: &Desk| columns(desk)[2].clone();
    assert_eq!(made(&desk), ("y' [cm/ms]".into(), "y'".into(), "forward differences".into()));
    let saved = desk.records().saved();
    let mut later = utube();
    crate::support::bring_back_records(&mut later, &saved);
    assert_eq!(columns(&later), columns(&desk));
    assert_eq!(later.records().cells(0, 3, 0..99), desk.records().cells(id, 3, 0..99));
    // If the source measures nothing, its derivative measures nothing.
    desk.change_records(|records, open| records.set_quantity(open, id, 1, ""));
    assert_eq!(made(&desk).1, "");
}

#[test]
fn measured_points_are_read_beside_the_curve() {
    let mut desk = utube();
    desk.add_record("film.txt", "t [s] y [cm]\n0 40\n0.5 33\n1 20\n2 -12\n".as_bytes()).unwrap();
    let read = |desk: &mut Desk, time: f64| {
        let figure = followed(desk).layout_plot(PlotId::at(0), &Settings::default()).unwrap();
        let at = Point { x: figure.x_scale().unwrap().pixel(time) as f32, y: figure.panel.y + 10.0 };
        let readout = followed(desk).change_plots(|plots, run| plots.hover(run, PlotId::at(0), at));
        readout.map(|readout| readout.samples.into_iter().map(|sample| sample.text).collect::<Vec<_>>())
    };
    // Before the run starts only measured points are read.
    let early = read(&mut desk, 1.0).unwrap();
    assert_eq!(early.len(), 1, "{early:?}");
    assert!(early[0].starts_with("film.txt: t = 1.0") && early[0].contains("y = 0.20"), "{early:?}");
    play(&mut desk, [0.1; 30]);
    let both = read(&mut desk, 0.51).unwrap();
    assert_eq!(both.len(), 3, "y, y' and the point: {both:?}");
    assert!(both[2].starts_with("film.txt: t = 0.5") && both[2].contains("y = 0.33"), "{both:?}");
    // Between two distant points neither is read.
    let figure =
        followed(&mut desk).layout_plot(PlotId::at(0), &Settings { width: 2000.0, ..Settings::default() }).unwrap();
    let at = Point { x: figure.x_scale().unwrap().pixel(1.5) as f32, y: figure.panel.y + 10.0 };
    assert_eq!(
        followed(&mut desk).change_plots(|plots, run| plots.hover(run, PlotId::at(0), at)).unwrap().samples.len(),
        2
    );
    // The keyboard cursor continues from the pointer's position and also reads measured points.
    read(&mut desk, 0.55);
    let readout = followed(&mut desk)
        .change_plots(|plots, run| plots.move_cursor(run, PlotId::at(0), -1))
        .expect("the cursor is on the run");
    assert!(readout.samples.iter().any(|sample| sample.text.starts_with("film.txt: ")), "{readout:?}");
}
