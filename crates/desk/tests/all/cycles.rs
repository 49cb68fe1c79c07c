//! Cycles of records as shown on the page: in the record's units, beside the run, in both languages.

use crate::support::followed;
use crate::support::{set, utube};
use desk::{Desk, ExportKind};
use figure::{Point, Settings};

const OMEGA: f64 = 9.6;
const DAMPING: f64 = 0.39;

/// A film of 5 s in centimetres. With dry friction the oscillation ends earlier than an exponential decay.
fn film(friction: f64) -> String {
    let mut text = "t [s]\ty [cm]\n".to_owned();
    for frame in 0..150 {
        let t = f64::from(frame) / 30.0;
        // Deterministic noise that no sinusoid follows.
        let noise = 0.01 * libm::sin(1.7 * f64::from(frame * frame));
        let envelope = (6.0 * libm::exp(-DAMPING * t) - friction * t).max(0.0);
        text += &format!("{t:.6}\t{:.6}\n", 1.0 + envelope * libm::cos(OMEGA * t + 0.7) + noise);
    }
    text
}

fn value(cell: &str) -> (f64, f64) {
    let (value, error) = cell.split_once(" ± ").expect("a value and its error");
    (value.replace(',', ".").parse().unwrap(), error.replace(',', ".").parse().unwrap())
}

#[test]
fn a_damped_sinusoid_has_the_same_period_and_damping_in_every_cycle() {
    let mut desk = utube();
    desk.add_record("film.txt", film(0.0).as_bytes()).unwrap();
    assert_eq!(desk.cycles().table(), None, "nobody has looked yet");
    desk.change_cycles(|cycles| cycles.open(true));
    let view = desk.cycles().table().expect("the record's cycles");
    assert_eq!(view.heads, ["t [s]", "A [cm]", "T [s]", "decrement", "ω [rad/s]", "γ [1/s]"]);
    assert!(view.rows.len() >= 12, "{}", view.rows.len());
    for (number, (kind, cells)) in view.rows.iter().enumerate() {
        assert_eq!(*kind == view.rows[0].0, number % 2 == 0, "maxima and minima take turns");
        let near = |cell: &str, truth: f64| {
            let (value, error) = value(cell);
            (value - truth).abs() < 5.0 * error
        };
        let amplitude = 6.0 * libm::exp(-DAMPING * value(&cells[0]).0);
        assert!(near(&cells[1], amplitude), "{cells:?}");
        assert!(near(&cells[4], OMEGA) && near(&cells[5], DAMPING), "{cells:?}");
        assert!(near(&cells[2], std::f64::consts::TAU / OMEGA), "{cells:?}");
    }
    assert!(view.sentences[0].starts_with("The angular frequency is the same in all cycles"), "{:?}", view.sentences);
    assert!(view.sentences[1].starts_with("The damping is the same in all cycles"), "{:?}", view.sentences);
}

#[test]
fn another_friction_is_seen_at_once() {
    let mut desk = utube();
    desk.set_language("es");
    desk.add_record("film.txt", film(0.6).as_bytes()).unwrap();
    desk.change_cycles(|cycles| cycles.open(true));
    let view = desk.cycles().table().unwrap();
    assert!(view.sentences[1].starts_with("El amortiguamiento cambia más"), "{:?}", view.sentences);
    assert!(view.rows[0].1[1].contains(','), "decimal commas: {:?}", view.rows[0]);
    let damping: Vec<f64> = view.rows.iter().map(|(_, cells)| value(&cells[5]).0).collect();
    assert!(damping[damping.len() - 3] > damping[0] + 0.1, "it grows: {damping:?}");
}

#[test]
fn another_column_is_looked_at_and_a_flat_one_says_why_not() {
    let mut desk = utube();
    let film = film(0.0);
    let rows: String = film.lines().map(|line| format!("{line}\t1\n")).collect();
    let id = desk.add_record("film.txt", rows.replacen("\t1\n", "\tflat\n", 1).as_bytes()).unwrap();
    desk.change_cycles(|cycles| cycles.open(true));
    let columns = desk.cycles().columns();
    assert_eq!(
        columns.iter().map(|one| (one.label.as_str(), one.selected)).collect::<Vec<_>>(),
        [("film.txt: y [cm]", true), ("film.txt: flat", false)]
    );
    desk.change_cycles(|cycles| cycles.choose(id, 2));
    let view = desk.cycles().table().unwrap();
    assert!(view.rows.is_empty() && view.sentences[0].contains("does not oscillate"), "{view:?}");
    assert!(!desk.play().plots().list()[desk.cycles().plot().place()].offered);
    // Without the record there are no cycles; then another record replaces it.
    desk.change_records(|records, _| records.remove(id));
    assert_eq!(desk.cycles().table(), None);
    desk.add_record("again.txt", film.as_bytes()).unwrap();
    assert!(!desk.cycles().table().unwrap().rows.is_empty());
}

/// Readout of the plot of the cycles at the abscissa `x`.
fn read(desk: &mut Desk, x: f64) -> Vec<String> {
    let index = desk.cycles().plot();
    let figure = followed(desk).layout_plot(index, &Settings::default()).unwrap();
    let (across, panel) = (figure.x_scale().unwrap().pixel(x), figure.panel);
    let at = Point { x: across as f32, y: panel.y + panel.height / 2.0 };
    let readout =
        followed(desk).change_plots(|plots, run| plots.hover(run, index, at)).expect("there is something at this time");
    readout.samples.into_iter().map(|sample| sample.text).collect()
}

#[test]
fn the_plot_reads_values_with_errors_and_the_run_beside_them() {
    let mut desk = utube();
    // Five times slower, like the column of the document.
    let slow: Vec<String> = film(0.0)
        .lines()
        .map(|line| match line.split_once('\t') {
            Some((time, level)) if !level.starts_with('y') => {
                format!("{:.6}\t{level}", 5.0 * time.parse::<f64>().unwrap())
            }
            _ => line.to_owned(),
        })
        .collect();
    desk.add_record("film.txt", slow.join("\n").as_bytes()).unwrap();
    desk.change_cycles(|cycles| cycles.open(true));
    let index = desk.cycles().plot();
    assert_eq!(desk.play().plots().list()[index.place()].title, "Period against time");
    let (names, _) = desk.cycles().quantities();
    let frequency = names.iter().position(|name| name == "Angular frequency").unwrap();
    desk.change_cycles(|cycles| cycles.show(frequency, false));
    assert_eq!(desk.play().plots().list()[index.place()].title, "Angular frequency against time");
    let measured = read(&mut desk, 10.0);
    assert!(measured.iter().any(|text| text.starts_with("ω = (1.9") && text.contains(" ± ")), "{measured:?}");
    assert!(!measured.iter().any(|text| text.starts_with("simulation")), "{measured:?}");
    // The cycles of a run with another frequency appear once it is paused.
    set(&mut desk, "b", 0.0);
    desk.play_mut().change_run(|line, _| line.play());
    (0..500).for_each(|_| assert!(desk.play_mut().change_run(|line, _| line.tick(0.05))));
    desk.play_mut().change_run(|line, _| line.pause());
    let beside = read(&mut desk, 10.0);
    let omega = (2.0_f64 * 9.8 / 7.0).sqrt();
    let run = beside.iter().find_map(|text| text.strip_prefix("simulation = ")).expect("the run has cycles");
    let run: f64 = run.split('\u{a0}').next().unwrap().parse().unwrap();
    assert!((run - omega).abs() < 0.05, "{run} is not {omega}");
    // The keyboard's cursor goes from one turning point to the next.
    for against_amplitude in [true, false] {
        desk.change_cycles(|cycles| cycles.show(frequency, against_amplitude));
        followed(&mut desk).layout_plot(index, &Settings::default());
        let at = |desk: &mut Desk| {
            let readout = followed(desk)
                .change_plots(|plots, run| plots.move_cursor(run, index, 1))
                .expect("there is a next one");
            assert!(readout.samples.iter().any(|sample| sample.text.contains(" ± ")), "{readout:?}");
            readout.heading
        };
        assert_ne!(at(&mut desk), at(&mut desk));
    }
    // Against the amplitude the points are not ordered in time.
    desk.change_cycles(|cycles| cycles.show(frequency, true));
    assert_eq!(desk.play().plots().list()[index.place()].title, "Angular frequency against amplitude");
    assert!(followed(&mut desk).layout_plot(index, &Settings::default()).is_some());
}

#[test]
fn the_cycles_are_saved_with_the_numbers_of_the_reader() {
    let mut desk = utube();
    desk.add_record("Film 1.txt", film(0.0).as_bytes()).unwrap();
    desk.change_cycles(|cycles| cycles.open(true));
    let file = desk.cycles().export(ExportKind::Csv).unwrap();
    assert_eq!(file.name, "film-1-cycles.csv");
    let text = String::from_utf8(file.bytes).unwrap();
    assert!(text.starts_with("t [s],t_stderr [s],amplitude [cm],amplitude_stderr [cm],period [s],"), "{text}");
    assert_eq!(text.lines().count(), desk.cycles().table().unwrap().rows.len() + 1);
    desk.set_language("es");
    let text = String::from_utf8(desk.cycles().export(ExportKind::Csv).unwrap().bytes).unwrap();
    assert!(text.starts_with("\u{feff}t [s];t_stderr [s];") && text.lines().nth(1).unwrap().contains(','), "{text}");
    assert!(desk.cycles().export(ExportKind::Workbook).unwrap().bytes.starts_with(b"PK"));
}
