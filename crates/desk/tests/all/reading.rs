//! Displays of the simulation: readouts, scene, table, plots, questions, pitch.

use crate::support::followed;
use crate::support::{open, play, readout, set, utube};
use desk::Desk;
use engine::csv::Dialect;
use engine::table::Table;
use engine::{Run, Setup};
use figure::{Direction, Item, Palette, Point, Settings};
use play::Grade;
use play::PlotId;

#[test]
fn readouts_have_values_units_and_words() {
    let mut desk = utube();
    let all = desk.play_mut().readouts();
    let names: Vec<&str> = all.iter().map(|readout| readout.name.as_str()).collect();
    assert_eq!(names, ["t", "y", "y'", "L", "m", "omega_0", "gamma", "omega_d", "regime", "T", "V", "E"]);
    let (l, e) = (&all[3], &all[11]);
    assert_eq!(
        (l.label.as_str(), l.value.as_str(), l.unit.as_str(), l.varies),
        ("Length of the column", "7", "m", false)
    );
    // E = m g y^2 / L = 350 * 9.8 * 0.25 / 7 = 122.5 J.
    assert_eq!((e.value.as_str(), e.unit.as_str(), e.varies), ("122.5", "J", true));
    assert_eq!(readout(&mut desk, "regime"), "underdamped");
    desk.set_language("es");
    assert_eq!(readout(&mut desk, "regime"), "subamortiguado");
    assert_eq!(readout(&mut desk, "y"), "0,5000");
    // omega_d has no value when the motion is overdamped, and nothing stops because of it.
    set(&mut desk, "b", 5000.0);
    assert_eq!(readout(&mut desk, "omega_d"), "–");
    assert_eq!(readout(&mut desk, "regime"), "sobreamortiguado");
    play(&mut desk, [1.0]);
    assert!((desk.play().course().time() - 1.0).abs() < 1e-9);
}

#[test]
fn a_paused_change_of_parameters_is_read_at_once() {
    let mut desk = utube();
    play(&mut desk, [1.0]);
    let y = readout(&mut desk, "y");
    set(&mut desk, "rho", 2000.0);
    assert_eq!(readout(&mut desk, "m"), "700");
    assert_eq!(readout(&mut desk, "y"), y);
}

#[test]
fn the_scene_has_numbers_for_attributes_and_words_for_texts() {
    let mut desk = utube();
    let values = desk.play_mut().scene().values().to_vec();
    assert!(values.contains(&0.5) && values.contains(&80.0), "{values:?}");
    let y = values.iter().position(|value| *value == 0.5).unwrap();
    assert_eq!(desk.play_mut().scene().text(y, None), "0.5000 m");
    assert_eq!(desk.play_mut().scene().text(y, Some(1)), "0.5 m");
    desk.play_mut().change_run(|line, _| line.play());
    desk.play_mut().change_run(|line, _| line.tick(0.5));
    assert!(desk.play_mut().scene().values()[y] < 0.5);
    desk.set_language("es");
    let texts: Vec<String> = (0..values.len()).map(|index| desk.play_mut().scene().text(index, None)).collect();
    assert!(texts.contains(&"subamortiguado".to_owned()), "{texts:?}");
    assert_eq!(desk.play_mut().scene().text(99, None), "");
}

#[test]
fn the_table_has_every_row_and_its_file_reads_back() {
    let mut desk = utube();
    play(&mut desk, [2.0]);
    assert_eq!(desk.play().values().table_length(), 41);
    assert_eq!(desk.play().values().table_header()[..3], ["t [s]", "y [m]", "y′ [m/s]"]);
    let rows = desk.play().values().table_rows(38..1000);
    assert_eq!(rows.len(), 3);
    assert_eq!(rows[2][0], "2.00", "times have the decimals of the step");
    assert_eq!(desk.play().values().table_row_now(), 40);
    assert!(desk.play().values().table_rows(100..200).is_empty());
    let csv = desk.play().values().csv();
    let mut lines = csv.lines();
    assert!(lines.next().unwrap().starts_with("t [s],y [m],y' [m/s],"));
    let last: Vec<f64> = lines.last().unwrap().split(',').take(3).map(|cell| cell.parse().unwrap()).collect();
    assert_eq!(last, [2.0, crate::support::state(&desk)[0], crate::support::state(&desk)[1]]);
    assert_eq!(csv.lines().count(), 42);
    desk.set_language("es");
    assert_eq!(desk.play().values().table_rows(1..2)[0][0], "0,05");
    // The same numbers for a spreadsheet with decimal commas.
    let spanish = desk.play().values().csv();
    assert!(spanish.starts_with("\u{feff}t [s];y [m];y' [m/s];"), "{spanish}");
    let read = |text: &str| analysis::import::text(text.as_bytes()).unwrap().table;
    let bits = |text: &str| -> Vec<Vec<u64>> {
        read(text).columns.iter().map(|column| column.values.iter().map(|value| value.to_bits()).collect()).collect()
    };
    assert_eq!(bits(&spanish), bits(&csv));
}

#[test]
fn the_file_is_that_of_a_run_without_a_session() {
    let mut desk = utube();
    set(&mut desk, "b", 200.0);
    play(&mut desk, [0.3, 0.017, 1.0, 0.7]);
    desk.play_mut().change_run(|line, _| line.scrub(0.42));
    play(&mut desk, [1.58]);
    desk.play_mut().change_run(|line, _| line.scrub(2.0));

    let model = desk.play().model();
    let mut setup = Setup::defaults(model);
    setup.parameters.clone_from_slice(desk.play().course().parameters());
    let mut run = Run::start(model, setup).unwrap();
    for _ in 0..40 {
        run.advance().unwrap();
    }
    let mut table = Table::new(model);
    let mut expected = String::new();
    table.write_head(Dialect::Lines, &mut expected).unwrap();
    for row in 0..=40 {
        table.write_row(Dialect::Lines, run.history(), row, &mut expected).unwrap();
    }
    assert_eq!(desk.play().values().csv(), expected);
}

/// The points of all lines of a figure.
fn points(desk: &mut Desk, index: usize) -> usize {
    let figure = followed(desk).layout_plot(PlotId::at(index), &Settings::default()).unwrap();
    figure.items().map(|item| if let Item::Polyline(points, _) = item { points.len() / 2 } else { 0 }).sum()
}

#[test]
fn plots_grow_with_the_run_and_end_at_the_moment_shown() {
    let mut desk = utube();
    let titles: Vec<String> =
        desk.play().plots().list().into_iter().filter(|plot| plot.offered).map(|plot| plot.title).collect();
    assert_eq!(titles, ["Motion", "Phase portrait", "Energies"]);
    let empty = points(&mut desk, 0);
    desk.play_mut().change_run(|line, _| line.play());
    let mut before = empty;
    for _ in 0..5 {
        desk.play_mut().change_run(|line, _| line.tick(1.0));
        let now = points(&mut desk, 0);
        assert!(now > before, "{now} after {before}");
        before = now;
    }
    // The last point is the moment shown, between two rows.
    desk.play_mut().change_run(|line, _| line.tick(0.02));
    followed(&mut desk).layout_plot(PlotId::at(0), &Settings::default());
    let readout = followed(&mut desk).change_plots(|plots, run| plots.move_cursor(run, PlotId::at(0), 1)).unwrap();
    assert!(readout.heading.contains("5.02"), "{}", readout.heading);
    assert!(followed(&mut desk).layout_plot(PlotId::at(9), &Settings::default()).is_none());
}

/// Number of pieces of the lines of a figure.
fn pieces(desk: &mut Desk, index: usize) -> usize {
    let figure = followed(desk).layout_plot(PlotId::at(index), &Settings::default()).unwrap();
    figure.items().filter(|item| matches!(item, Item::Polyline(..))).count()
}

#[test]
fn what_jumps_with_a_parameter_is_drawn_interrupted() {
    let mut desk = utube();
    play(&mut desk, [1.0]);
    let (motion, energies) = (pieces(&mut desk, 0), pieces(&mut desk, 2));
    set(&mut desk, "rho", 2000.0);
    assert_eq!((pieces(&mut desk, 0), pieces(&mut desk, 2)), (motion, energies), "a point is no piece");
    play(&mut desk, [1.0]);
    // E, T and V double with the mass; the state goes on.
    assert_eq!((pieces(&mut desk, 0), pieces(&mut desk, 2)), (motion, energies + 3));
    set(&mut desk, "b", 100.0);
    play(&mut desk, [1.0]);
    assert_eq!((pieces(&mut desk, 0), pieces(&mut desk, 2)), (motion, energies + 3));
}

#[test]
fn plots_are_read_by_pointer_and_by_keyboard() {
    let mut desk = utube();
    play(&mut desk, [5.0]);
    let panel = followed(&mut desk).layout_plot(PlotId::at(0), &Settings::default()).unwrap().panel;
    let middle = Point { x: panel.x + panel.width / 4.0, y: panel.y + panel.height / 2.0 };
    let hovered = followed(&mut desk).change_plots(|plots, run| plots.hover(run, PlotId::at(0), middle)).unwrap();
    assert_eq!(hovered.samples.len(), 2);
    assert!(hovered.samples[0].text.starts_with("y = "), "{hovered:?}");
    let row = hovered.samples[0].row;
    let next = followed(&mut desk).change_plots(|plots, run| plots.move_cursor(run, PlotId::at(0), 1)).unwrap();
    assert_eq!(next.samples[0].row, row + 1);
    let apart = desk.play().plots().difference(PlotId::at(0), &hovered, &next);
    assert!(apart[0].starts_with("Δt = 0.0") && apart[1].starts_with("Δy = ") && apart.len() == 3, "{apart:?}");
    assert!(
        followed(&mut desk)
            .change_plots(|plots, run| plots.hover(run, PlotId::at(0), Point { x: -1.0, y: 0.0 }))
            .is_none()
    );
    assert!(
        followed(&mut desk).change_plots(|plots, run| plots.hover(run, PlotId::at(9), middle)).is_none()
            && followed(&mut desk).change_plots(|plots, run| plots.move_cursor(run, PlotId::at(9), 1)).is_none()
    );
}

#[test]
fn kept_runs_are_read_by_their_names_and_ghosts_not_at_all() {
    let mut desk = utube();
    play(&mut desk, [5.0]);
    desk.play_mut().change_run(|line, basis| line.keep(basis)).unwrap();
    set(&mut desk, "h_l", 4.0);
    assert!(desk.play().time_line().has_ghost());
    play(&mut desk, [5.0]);
    for plot in [0, 1] {
        followed(&mut desk).layout_plot(PlotId::at(plot), &Settings::default());
        followed(&mut desk).change_plots(|plots, run| plots.move_cursor(run, PlotId::at(plot), -1000));
        let texts =
            followed(&mut desk).change_plots(|plots, run| plots.move_cursor(run, PlotId::at(plot), 0)).unwrap().samples;
        let texts: Vec<String> = texts.into_iter().map(|sample| sample.text.replace('\u{a0}', " ")).collect();
        let expected: &[&str] = match plot {
            0 => &["y (h_l = 3 m) = 0.5", "y′ (h_l = 3 m) = 0", "y = 1", "y′ = 0"],
            _ => &["y′ = 0"],
        };
        assert_eq!(texts.len(), expected.len(), "{texts:?}");
        assert!(texts.iter().zip(expected).all(|(text, begin)| text.starts_with(begin)), "{texts:?}");
    }
}

#[test]
fn zoom_and_pan_hold_until_reset() {
    let mut desk = utube();
    play(&mut desk, [5.0]);
    followed(&mut desk).layout_plot(PlotId::at(1), &Settings::default());
    assert!(desk.play().plots().list()[1].automatic);
    desk.play_mut().change_plots(|plots, _| plots.zoom(PlotId::at(1), None, 2.0, Direction::Both));
    followed(&mut desk).layout_plot(PlotId::at(1), &Settings::default());
    desk.play_mut().change_plots(|plots, _| plots.pan(PlotId::at(1), 10.0, 0.0));
    assert!(!desk.play().plots().list()[1].automatic && desk.play().plots().list()[0].automatic);
    let before = desk.play().plots().figure(PlotId::at(1)).unwrap().x_scale().copied();
    play(&mut desk, [1.0]);
    followed(&mut desk).layout_plot(PlotId::at(1), &Settings::default());
    desk.play_mut().change_plots(|plots, _| plots.reset(PlotId::at(1)));
    followed(&mut desk).layout_plot(PlotId::at(1), &Settings::default());
    assert!(desk.play().plots().list()[1].automatic);
    assert_ne!(desk.play().plots().figure(PlotId::at(1)).unwrap().x_scale().copied(), before);
    desk.play_mut().change_plots(|plots, _| plots.zoom(PlotId::at(1), None, f64::NAN, Direction::Both));
    desk.play_mut().change_plots(|plots, _| plots.zoom(PlotId::at(9), None, 2.0, Direction::Both));
    assert!(desk.play().plots().list()[1].automatic);
}

#[test]
fn figures_are_files_too() {
    let mut desk = utube();
    play(&mut desk, [5.0]);
    desk.set_language("es");
    let svg = followed(&mut desk).plots_to_front().svg(PlotId::at(1), &Settings::default(), &Palette::LIGHT);
    assert!(svg.starts_with("<svg") && svg.contains("Retrato de fase"), "{}", &svg[..200.min(svg.len())]);
    assert_eq!(followed(&mut desk).plots_to_front().svg(PlotId::at(9), &Settings::default(), &Palette::LIGHT), "");
}

#[test]
fn answers_are_judged() {
    let mut desk = utube();
    // 2 pi / sqrt(2.8 - (50/700)^2) = 3.7584 s.
    for (text, grade) in [
        ("3.75", Grade::Correct),
        ("3,76 s", Grade::Correct),
        ("3758 ms", Grade::Correct),
        ("3.6", Grade::Close),
        ("-3.76", Grade::WrongSign),
        ("3758", Grade::WrongScale),
        ("2", Grade::Wrong),
        ("0", Grade::Wrong),
        ("", Grade::Unreadable),
        ("long", Grade::Unreadable),
        ("3.76 m", Grade::Unreadable),
    ] {
        assert_eq!(desk.play_mut().change_answers(|answers, run| answers.check(run, 0, text)).grade, grade, "{text}");
    }
    assert_eq!(
        desk.play_mut().change_answers(|answers, run| answers.check(run, 0, "3.76 m")).text,
        "m measures something else; a unit such as s is needed."
    );
    assert_eq!(
        (
            desk.play_mut().change_answers(|answers, run| answers.reveal(run, 0)).as_str(),
            desk.play().basis().question_unit(0).as_str()
        ),
        ("3.758 s", "s")
    );
    set(&mut desk, "b", 5000.0);
    assert_eq!(desk.play_mut().change_answers(|answers, run| answers.check(run, 0, "3.76")).grade, Grade::Unanswerable);
    assert_eq!(desk.play_mut().change_answers(|answers, run| answers.reveal(run, 0)), "–");
    assert_eq!(desk.play_mut().change_answers(|answers, run| answers.check(run, 9, "1")).grade, Grade::Unanswerable);
}

#[test]
fn a_question_may_suppose_other_parameters() {
    let mut desk = utube();
    assert_eq!(desk.play().answers().setup(desk.play().basis(), desk.play().course(), 0), None);
    let supposed = [("b", "0 kg/s"), ("h_l", "4 m")].map(|(name, value)| (name.to_owned(), value.to_owned())).to_vec();
    assert_eq!(desk.play().answers().setup(desk.play().basis(), desk.play().course(), 1), Some((supposed, false)));
    assert_eq!(desk.play_mut().change_answers(|answers, run| answers.check(run, 1, "1")).grade, Grade::Correct);
    assert_eq!(desk.play_mut().change_answers(|answers, run| answers.reveal(run, 1)), "1 m");
    desk.play_mut().apply_question_setup(1).unwrap();
    assert_eq!(crate::support::state(&desk), [1.0, 0.0]);
    assert_eq!(
        desk.play().answers().setup(desk.play().basis(), desk.play().course(), 1).map(|(_, set)| set),
        Some(true)
    );
    assert!(desk.play_mut().apply_question_setup(9).is_err());
}

#[test]
fn the_displacement_is_heard_while_it_moves() {
    let mut desk = utube();
    assert_eq!(desk.play().controls().pitch(desk.play().time_line()), None);
    set(&mut desk, "b", 0.0);
    desk.play_mut().change_run(|line, _| line.play());
    assert_eq!(desk.play().controls().pitch(desk.play().time_line()), Some(880.0));
    // Quarters of the period 2 pi / sqrt(2.8) s.
    for expected in [440.0, 220.0, 440.0, 880.0] {
        desk.play_mut().change_run(|line, _| line.tick(3.754_93 / 4.0));
        let pitch = desk.play().controls().pitch(desk.play().time_line()).unwrap();
        assert!((pitch - expected).abs() < 0.1, "{pitch}");
    }
    desk.play_mut().change_run(|line, _| line.pause());
    assert_eq!(desk.play().controls().pitch(desk.play().time_line()), None);
}

#[test]
fn units_other_than_si_are_shown_everywhere() {
    let source = "---\ntitle: Spring\n---\n```model\nparameter k = 4 [N/cm] in 1..100 \"Stiffness\"\nparameter m = 250 [g] in 100..500 step 10\nm*x'' = -k*x\nx(0) = 5 [cm] in [cm]\nx'(0) = 0 in [cm/s]\n```\n```plots\n\"Motion\": x against t\n```\n";
    let mut desk = open(source, &[]);
    assert_eq!(readout(&mut desk, "x"), "5.000");
    assert_eq!(desk.play().values().table_header(), ["t [s]", "x [cm]", "x′ [cm/s]"]);
    assert_eq!(desk.play().basis().parameter(desk.play().course(), 1).unwrap().text, "250");
    assert_eq!(
        desk.play().basis().parameter(desk.play().course(), 1).unwrap().slider.map(|slider| slider.position),
        Some(15)
    );
    desk.play_mut().change_settings(|settings| settings.slide(1, 16));
    assert_eq!(
        (
            desk.play().basis().parameter(desk.play().course(), 1).unwrap().text.as_str(),
            desk.play().course().parameters()[1]
        ),
        ("260", 0.26)
    );
    followed(&mut desk).layout_plot(PlotId::at(0), &Settings::default());
    let readout = followed(&mut desk).change_plots(|plots, run| plots.move_cursor(run, PlotId::at(0), 0)).unwrap();
    assert_eq!(readout.samples[0].y, 5.0);
}
