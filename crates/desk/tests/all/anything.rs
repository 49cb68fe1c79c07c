//! No sequence of actions breaks the desk.

use crate::support::followed;
use desk::{Desk, number};
use figure::{Direction, Point, Settings};
use play::PlotId;
use proptest::prelude::*;

/// An action of the user.
#[derive(Clone, Debug)]
enum Action {
    Tick(f64),
    Toggle,
    StepForward,
    StepBack,
    Reset,
    Scrub(f64),
    Speed(f64),
    Slide(usize, u32),
    Set(usize, f64),
    Type(usize, String),
    State(usize, f64),
    Drag(f64, f64),
    Preset(usize),
    Keep,
    Remove(u32),
    Method(usize),
    Step(f64),
    Zoom(f64, f64),
    Answer(String),
    Reopen,
}

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![4 => -10.0..10.0_f64, 1 => -1e6..1e6_f64, 1 => any::<f64>()]
}

fn action() -> impl Strategy<Value = Action> {
    prop_oneof![
        6 => (0.0..0.5_f64).prop_map(Action::Tick),
        1 => number().prop_map(Action::Tick),
        4 => Just(Action::Toggle),
        2 => Just(Action::StepForward),
        2 => Just(Action::StepBack),
        1 => Just(Action::Reset),
        2 => number().prop_map(Action::Scrub),
        1 => number().prop_map(Action::Speed),
        2 => (0..9_usize, any::<u32>()).prop_map(|(index, position)| Action::Slide(index, position % 400)),
        2 => (0..9_usize, number()).prop_map(|(index, value)| Action::Set(index, value)),
        1 => (0..9_usize, ".{0,12}").prop_map(|(index, text)| Action::Type(index, text)),
        1 => (0..4_usize, number()).prop_map(|(index, value)| Action::State(index, value)),
        1 => (number(), number()).prop_map(|(right, up)| Action::Drag(right, up)),
        1 => (0..8_usize).prop_map(Action::Preset),
        1 => Just(Action::Keep),
        1 => (0..8_u32).prop_map(Action::Remove),
        1 => (0..6_usize).prop_map(Action::Method),
        1 => (1e-3..1.0_f64).prop_map(Action::Step),
        1 => (number(), number()).prop_map(|(at, factor)| Action::Zoom(at, factor)),
        1 => ".{0,12}".prop_map(Action::Answer),
        1 => Just(Action::Reopen),
    ]
}

fn perform(desk: &mut Desk, action: Action) {
    match action {
        Action::Tick(seconds) => {
            desk.play_mut().change_run(|line, _| line.tick(seconds));
        }
        Action::Toggle => desk.play_mut().change_run(|line, _| line.toggle()),
        Action::StepForward => desk.play_mut().change_run(|line, _| line.step_forward()),
        Action::StepBack => desk.play_mut().change_run(|line, _| line.step_back()),
        Action::Reset => desk.play_mut().change_run(|line, basis| line.back_to_start(basis)),
        Action::Scrub(time) => desk.play_mut().change_run(|line, _| line.scrub(time)),
        Action::Speed(speed) => desk.play_mut().change_run(|line, _| line.set_speed(speed)),
        Action::Slide(index, position) => desk.play_mut().change_settings(|settings| settings.slide(index, position)),
        Action::Set(index, value) => {
            drop(desk.play_mut().change_settings(|settings| settings.set_parameter(index, value)))
        }
        Action::Type(index, text) => {
            drop(desk.play_mut().change_settings(|settings| settings.set_parameter_text(index, &text)))
        }
        Action::State(index, value) => {
            drop(desk.play_mut().change_settings(|settings| settings.set_state(index, value)))
        }
        Action::Drag(right, up) => {
            desk.play_mut().change_settings(|settings| {
                settings.drag_begin(&program::Drag {
                    target: program::Dragged::State(0),
                    up: Some(0),
                    right: Some(1),
                    zero: None,
                })
            });
            desk.play_mut().change_settings(|settings| settings.drag_move(right, up));
            desk.play_mut().change_settings(|settings| settings.drag_end());
        }
        Action::Preset(index) => drop(desk.play_mut().change_settings(|settings| settings.apply_preset(index))),
        Action::Keep => drop(desk.play_mut().change_run(|line, basis| line.keep(basis))),
        Action::Remove(id) => desk.play_mut().change_run(|line, basis| line.remove_kept(basis, id)),
        Action::Method(index) => {
            let name = desk.play().basis().methods(desk.play().course())[index].name;
            drop(desk.play_mut().change_settings(|settings| settings.set_method(name)));
        }
        Action::Step(step) => drop(desk.play_mut().change_settings(|settings| settings.set_step(step))),
        Action::Zoom(at, factor) => {
            desk.play_mut().change_plots(|plots, _| {
                plots.zoom(PlotId::at(0), Some(Point { x: at as f32, y: at as f32 }), factor, Direction::Both)
            });
            desk.play_mut().change_plots(|plots, _| plots.pan(PlotId::at(1), at, factor));
        }
        Action::Answer(text) => drop(desk.play_mut().change_answers(|answers, run| answers.check(run, 0, &text))),
        Action::Reopen => {
            let fragment = desk.play().share();
            let before =
                (desk.play().values().csv(), desk.play().course().time(), desk.play().course().parameters().to_vec());
            let changes = fragment.matches("&c=").count();
            desk.play_mut().restore(&fragment).unwrap_or_else(|refusal| panic!("{fragment}: {refusal:?}"));
            assert!(changes < 300);
            assert_eq!(
                (desk.play().values().csv(), desk.play().course().time(), desk.play().course().parameters().to_vec()),
                before,
                "{fragment}"
            );
        }
    }
}

fn look(desk: &mut Desk) {
    assert!(desk.play().course().time() >= 0.0 && desk.play().course().time() <= desk.play().course().front());
    assert_eq!(desk.play().values().table_length(), desk.play().values().csv().lines().count() - 1);
    assert!(desk.play().values().table_row_now() < desk.play().values().table_length());
    desk.play_mut().readouts();
    desk.play_mut().scene().values();
    desk.play().controls().presets(desk.play().basis(), desk.play().course());
    assert!(desk.play().time_line().kept(desk.play().basis()).len() <= play::MOST_KEPT);
    for plot in 0..3 {
        followed(desk).layout_plot(PlotId::at(plot), &Settings::default());
        followed(desk).change_plots(|plots, run| plots.move_cursor(run, PlotId::at(plot), 3));
        followed(desk).change_plots(|plots, run| plots.hover(run, PlotId::at(plot), Point { x: 300.0, y: 100.0 }));
    }
    while let Some(announcement) = desk.take_announcement() {
        announcement.text(desk.play());
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    #[test]
    fn any_deeds_in_any_order(actions in prop::collection::vec(action(), 1..40)) {
        let mut desk = crate::support::utube();
        for action in actions {
            perform(&mut desk, action);
            look(&mut desk);
        }
    }

    #[test]
    fn any_saved_state(fields in "1(&[pymhcetxvk]=?[a-z0-9:.,e-]{0,10}){0,6}", other in ".{0,30}") {
        let mut desk = crate::support::utube();
        let _ = desk.play_mut().restore(&fields);
        let _ = desk.play_mut().restore(&other);
        look(&mut desk);
    }

    #[test]
    fn any_typed_number(text in ".{0,16}", digits in "[0-9.,e× ^−-]{0,12}") {
        for style in [number::Style { decimal_comma: false }, number::Style { decimal_comma: true }] {
            for text in [&text, &digits] {
                if let Some((value, _)) = number::parse(text, style) {
                    prop_assert!(value.is_finite());
                }
            }
        }
    }

    #[test]
    fn any_number_written_reads_back(value in any::<f64>().prop_filter("finite", |value| value.is_finite())) {
        for style in [number::Style { decimal_comma: false }, number::Style { decimal_comma: true }] {
            let text = number::plain(value, 17, style);
            let read = number::parse(&text, style);
            prop_assert_eq!(read.map(|(read, rest)| (read, rest.len())), Some((value, 0)), "{}", text);
        }
    }
}
