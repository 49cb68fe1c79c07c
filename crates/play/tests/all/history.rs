//! Scrubbing, continuing, changing parameters during the run, and the ghost.

use crate::support::{bits, go_on, open, parameter, set, state, utube};
use play::{Announcement, MOST_KEPT, PlotId, Refusal};

fn told(play: &mut play::Play) -> Vec<Announcement> {
    std::iter::from_fn(|| play.take_announcement()).collect()
}

#[test]
fn scrubbing_and_going_on_gives_the_same_bits() {
    let mut straight = utube();
    go_on(&mut straight, [10.0]);
    let mut scrubbed = utube();
    go_on(&mut scrubbed, [8.0]);
    for moment in [0.0, 3.999, 2.5, 4.0 * 0.05, 0.013] {
        scrubbed.change_run(|line, _| line.scrub(moment));
        assert_eq!(scrubbed.course().time(), moment);
        assert_eq!(scrubbed.course().front(), if moment == 0.0 { 8.0 } else { 10.0 });
        go_on(&mut scrubbed, [10.0 - moment]);
        assert!(scrubbed.time_line().has_ghost());
        scrubbed.change_run(|line, _| line.scrub(10.0));
        assert_eq!(bits(&scrubbed), bits(&straight), "after going on from {moment}");
    }
}

#[test]
fn a_scrub_alone_changes_nothing() {
    let mut play = utube();
    go_on(&mut play, [3.0]);
    let before = bits(&play);
    play.change_run(|line, _| line.scrub(1.0));
    assert_eq!(bits(&play), before);
    play.change_run(|line, _| line.scrub(f64::NAN));
    assert!(!play.course().is_scrubbed());
    play.change_run(|line, _| line.scrub(-5.0));
    assert_eq!(play.course().time(), 0.0);
    play.change_run(|line, _| line.scrub(1e300));
    assert_eq!((play.course().time(), play.course().is_scrubbed()), (3.0, false));
    assert_eq!(bits(&play), before);
}

#[test]
fn a_change_of_damping_takes_effect_at_once_without_a_jump() {
    let mut play = utube();
    go_on(&mut play, [1.025]);
    let before = state(&play);
    set(&mut play, "b", 5000.0);
    assert_eq!(state(&play), before);
    assert!(!play.time_line().has_ghost(), "the run goes on");
    let length = play.values().table_length();
    // The past is unchanged, and the next steps are those of a strongly damped liquid.
    let mut other = utube();
    go_on(&mut other, [1.025]);
    assert_eq!(bits(&play), bits(&other));
    go_on(&mut play, [0.3]);
    go_on(&mut other, [0.3]);
    let (damped, free) = (state(&play)[1], state(&other)[1]);
    assert!(damped.abs() < 0.6 * free.abs(), "{damped} {free}");
    assert_eq!(play.values().table_length(), length + 6);
}

#[test]
fn parameters_then_in_force_come_back() {
    let mut play = utube();
    let b = parameter(&play, "b");
    go_on(&mut play, [1.0]);
    set(&mut play, "b", 300.0);
    go_on(&mut play, [1.0]);
    set(&mut play, "b", 700.0);
    go_on(&mut play, [1.0]);
    let straight = bits(&play);
    let at = |play: &mut play::Play, time: f64| {
        play.change_run(|line, _| line.scrub(time));
        play.course().parameters()[b]
    };
    assert_eq!(at(&mut play, 0.5), 50.0);
    assert_eq!(at(&mut play, 1.5), 300.0);
    assert_eq!(at(&mut play, 2.5), 700.0);
    assert_eq!(at(&mut play, 3.0), 700.0);
    assert_eq!(bits(&play), straight);
    // Continuing from 1.5 s uses b = 300 kg/s.
    play.change_run(|line, _| line.scrub(1.5));
    go_on(&mut play, [1.5]);
    assert_eq!(play.course().parameters()[b], 300.0);
    let mut other = utube();
    go_on(&mut other, [1.0]);
    set(&mut other, "b", 300.0);
    go_on(&mut other, [2.0]);
    assert_eq!(bits(&play), bits(&other));
}

#[test]
fn a_change_before_the_first_step_is_as_if_it_had_always_been_so() {
    let mut play = utube();
    set(&mut play, "b", 300.0);
    go_on(&mut play, [2.0]);
    let source = crate::support::UTUBE.replace("parameter b   = 50 ", "parameter b   = 300");
    let mut other = open(&source, &[]);
    go_on(&mut other, [2.0]);
    assert_eq!(bits(&play), bits(&other));
}

#[test]
fn a_parameter_that_decides_an_initial_value_restarts_the_run() {
    let mut play = utube();
    let h_l = parameter(&play, "h_l");
    assert!(play.basis().parameter(play.course(), h_l).unwrap().restarts);
    go_on(&mut play, [2.0]);
    told(&mut play);
    set(&mut play, "h_l", 4.0);
    assert_eq!((play.course().time(), play.course().front()), (0.0, 0.0));
    assert_eq!(state(&play), [1.0, 0.0]);
    assert!(play.time_line().has_ghost());
    let expected = [Announcement::Restarted(h_l), Announcement::ParameterSet(h_l, 4.0)];
    assert_eq!(told(&mut play), expected);
    // A playing run continues to play after the restart.
    play.change_run(|line, _| line.play());
    play.change_run(|line, _| line.tick(1.0));
    set(&mut play, "v_0", 2.0);
    assert!(play.time_line().is_playing() && play.course().time() == 0.0);
    assert_eq!(state(&play), [1.0, 2.0]);
}

#[test]
fn moving_a_slider_leaves_the_ghost_of_the_real_run() {
    let mut play = utube();
    go_on(&mut play, [10.0]);
    let h_l = parameter(&play, "h_l");
    play.change_run(|line, _| line.play());
    for position in 3..12 {
        play.change_settings(|settings| settings.slide(h_l, position));
        play.change_run(|line, _| line.tick(0.016));
    }
    let settings = Default::default();
    let svg = play.plots_to_front().svg(PlotId::at(0), &settings, &play::figure::Palette::LIGHT);
    assert!(play.time_line().has_ghost());
    assert!(svg.contains("10"), "the axis still has room for the ghost's 10 s");
    play.change_run(|line, basis| line.back_to_start(basis));
    assert!(!play.time_line().has_ghost());
}

#[test]
fn back_to_start_keeps_parameters_and_start_and_restoring_defaults_neither() {
    let mut play = utube();
    let b = parameter(&play, "b");
    set(&mut play, "b", 0.0);
    go_on(&mut play, [1.0]);
    play.change_run(|line, basis| line.back_to_start(basis));
    assert_eq!((play.course().time(), state(&play), play.course().parameters()[b]), (0.0, vec![0.5, 0.0], 0.0));
    play.change_settings(|settings| settings.set_state(0, 0.75)).unwrap();
    go_on(&mut play, [1.0]);
    play.change_run(|line, basis| line.back_to_start(basis));
    assert!(play.course().is_started_by_hand() && !play.time_line().is_playing());
    assert_eq!((play.course().time(), state(&play), play.course().parameters()[b]), (0.0, vec![0.75, 0.0], 0.0));
    go_on(&mut play, [1.0]);
    play.change_settings(|settings| settings.restore_defaults());
    assert!(!play.course().is_started_by_hand());
    assert_eq!((play.course().time(), state(&play), play.course().parameters()[b]), (0.0, vec![0.5, 0.0], 50.0));
    // Without a start set by hand, a run in progress continues.
    set(&mut play, "b", 0.0);
    go_on(&mut play, [1.0]);
    play.change_settings(|settings| settings.restore_defaults());
    assert_eq!((play.course().time(), play.course().parameters()[b]), (1.0, 50.0));
}

#[test]
fn runs_are_kept_by_what_differs() {
    let mut play = utube();
    go_on(&mut play, [1.0]);
    play.change_run(|line, basis| line.keep(basis)).unwrap();
    set(&mut play, "b", 200.0);
    go_on(&mut play, [1.0]);
    play.change_run(|line, basis| line.keep(basis)).unwrap();
    play.change_run(|line, basis| line.back_to_start(basis));
    set(&mut play, "rho", 13534.0);
    play.change_settings(|settings| settings.set_state(0, 0.3)).unwrap();
    play.change_settings(|settings| settings.set_method("euler")).unwrap();
    play.change_run(|line, basis| line.keep(basis)).unwrap();
    play.change_run(|line, basis| line.keep(basis)).unwrap();
    let names =
        |play: &play::Play| play.time_line().kept(play.basis()).into_iter().map(|kept| kept.name).collect::<Vec<_>>();
    assert_eq!(
        names(&play),
        [
            "ρ = 1000 kg/m³, b = 50 kg/s",
            "ρ = 1000 kg/m³, b = 50 kg/s → 200 kg/s",
            "ρ = 13534 kg/m³, b = 200 kg/s, y(0) = 0.3 m, y′(0) = 0 m/s, Euler",
            "ρ = 13534 kg/m³, b = 200 kg/s, y(0) = 0.3 m, y′(0) = 0 m/s, Euler (2)",
        ]
    );
    // A name stands at the end of its curve, shortened where it is long.
    let figure = play.layout_plot(PlotId::at(0), &figure::Settings::default()).unwrap();
    let texts = figure.items().filter_map(|item| match item {
        figure::Item::Text { text, ink: figure::Ink::Faded(_), .. } => Some(text),
        _ => None,
    });
    let texts: Vec<&str> = texts.collect();
    assert_eq!(texts.len(), 4, "{texts:?}");
    assert!(texts.iter().all(|text| text.starts_with("ρ = ")), "{texts:?}");
    play.change_settings(|settings| settings.restore_defaults());
    assert_eq!(names(&play)[0], "initial settings", "it has the present values");
    play.set_language("es");
    assert_eq!(names(&play)[0], "ajustes iniciales");
    assert!(names(&play)[2].contains("0,3 m"));
    let patterns: Vec<u8> = play.time_line().kept(play.basis()).iter().map(|kept| kept.pattern).collect();
    assert_eq!(patterns, [0, 1, 2, 3]);
    let second = play.time_line().kept(play.basis())[1].id;
    play.change_run(|line, basis| line.remove_kept(basis, second));
    play.change_run(|line, basis| line.show_kept(line.kept(basis)[0].id, false));
    assert!(!play.time_line().kept(play.basis())[0].shown);
    play.change_run(|line, basis| line.keep(basis)).unwrap();
    assert_eq!(play.time_line().kept(play.basis()).last().unwrap().pattern, 1, "the free pattern is used again");
    while play.time_line().kept(play.basis()).len() < MOST_KEPT {
        play.change_run(|line, basis| line.keep(basis)).unwrap();
    }
    assert_eq!(play.change_run(|line, basis| line.keep(basis)), Err(Refusal::TooManyRuns { most: MOST_KEPT }));
    play.change_run(|line, basis| line.remove_kept(basis, 999));
    play.change_run(|line, _| line.show_kept(999, true));
}

#[test]
fn events_are_part_of_the_run_and_break_its_line() {
    let source = "---\ntitle: Ball\n---\n```model\nparameter e = 0.9 in 0..1\ny'' = -9.81 [m/s^2]\ny(0) = 1 [m]\ny'(0) = 0 [m/s]\nwhen y < 0 [m] { y' = -e*y' }\n```\n```plots\n\"Velocity\": y' against t\n```\n";
    let mut straight = open(source, &[]);
    go_on(&mut straight, [3.0]);
    let mut scrubbed = open(source, &[]);
    go_on(&mut scrubbed, [2.0]);
    // Just before the first bounce at sqrt(2/9.81) = 0.45152 s, at it, and just after.
    for moment in [0.44, 0.451, 0.4515236, 0.452, 0.5, 1.2] {
        scrubbed.change_run(|line, _| line.scrub(moment));
        go_on(&mut scrubbed, [3.0 - moment]);
        scrubbed.change_run(|line, _| line.scrub(3.0));
        assert_eq!(bits(&scrubbed), bits(&straight), "after going on from {moment}");
    }
}
