//! Scrubbing, going on, changing parameters on the way, and what stays behind.

use crate::support::{bits, open, parameter, play, set, state, utube};
use session::{Announcement, MOST_KEPT, Refusal};

fn told(session: &mut session::Session) -> Vec<Announcement> {
    std::iter::from_fn(|| session.take_announcement()).collect()
}

#[test]
fn scrubbing_and_going_on_gives_the_same_bits() {
    let mut straight = utube();
    play(&mut straight, [10.0]);
    let mut scrubbed = utube();
    play(&mut scrubbed, [8.0]);
    for moment in [0.0, 3.999, 2.5, 4.0 * 0.05, 0.013] {
        scrubbed.scrub(moment);
        assert_eq!(scrubbed.time(), moment);
        assert_eq!(scrubbed.end(), if moment == 0.0 { 8.0 } else { 10.0 });
        play(&mut scrubbed, [10.0 - moment]);
        assert!(scrubbed.has_ghost());
        scrubbed.scrub(10.0);
        assert_eq!(bits(&scrubbed), bits(&straight), "after going on from {moment}");
    }
}

#[test]
fn a_scrub_alone_changes_nothing() {
    let mut session = utube();
    play(&mut session, [3.0]);
    let before = bits(&session);
    session.scrub(1.0);
    assert_eq!(bits(&session), before);
    session.scrub(f64::NAN);
    assert!(!session.is_scrubbed());
    session.scrub(-5.0);
    assert_eq!(session.time(), 0.0);
    session.scrub(1e300);
    assert_eq!((session.time(), session.is_scrubbed()), (3.0, false));
    assert_eq!(bits(&session), before);
}

#[test]
fn a_change_of_damping_takes_effect_at_once_without_a_jump() {
    let mut session = utube();
    play(&mut session, [1.025]);
    let before = state(&session);
    set(&mut session, "b", 5000.0);
    assert_eq!(state(&session), before);
    assert!(!session.has_ghost(), "the run goes on");
    let length = session.table_length();
    // Nothing of the past has changed, and the next steps are those of a strongly damped liquid.
    let mut other = utube();
    play(&mut other, [1.025]);
    assert_eq!(bits(&session), bits(&other));
    play(&mut session, [0.3]);
    play(&mut other, [0.3]);
    let (damped, free) = (state(&session)[1], state(&other)[1]);
    assert!(damped.abs() < 0.6 * free.abs(), "{damped} {free}");
    assert_eq!(session.table_length(), length + 6);
}

#[test]
fn parameters_then_in_force_come_back() {
    let mut session = utube();
    let b = parameter(&session, "b");
    play(&mut session, [1.0]);
    set(&mut session, "b", 300.0);
    play(&mut session, [1.0]);
    set(&mut session, "b", 700.0);
    play(&mut session, [1.0]);
    let straight = bits(&session);
    let at = |session: &mut session::Session, time: f64| {
        session.scrub(time);
        session.parameter_values()[b]
    };
    assert_eq!(at(&mut session, 0.5), 50.0);
    assert_eq!(at(&mut session, 1.5), 300.0);
    assert_eq!(at(&mut session, 2.5), 700.0);
    assert_eq!(at(&mut session, 3.0), 700.0);
    assert_eq!(bits(&session), straight);
    // Going on from 1.5 goes on with 300.
    session.scrub(1.5);
    play(&mut session, [1.5]);
    assert_eq!(session.parameter_values()[b], 300.0);
    let mut other = utube();
    play(&mut other, [1.0]);
    set(&mut other, "b", 300.0);
    play(&mut other, [2.0]);
    assert_eq!(bits(&session), bits(&other));
}

#[test]
fn a_change_before_the_first_step_is_as_if_it_had_always_been_so() {
    let mut session = utube();
    set(&mut session, "b", 300.0);
    play(&mut session, [2.0]);
    let source = crate::support::UTUBE.replace("parameter b   = 50 ", "parameter b   = 300");
    let mut other = open(&source, &[]);
    play(&mut other, [2.0]);
    assert_eq!(bits(&session), bits(&other));
}

#[test]
fn a_parameter_that_decides_an_initial_value_restarts_the_run() {
    let mut session = utube();
    let h_l = parameter(&session, "h_l");
    assert!(session.parameter(h_l).unwrap().restarts);
    play(&mut session, [2.0]);
    told(&mut session);
    set(&mut session, "h_l", 4.0);
    assert_eq!((session.time(), session.end()), (0.0, 0.0));
    assert_eq!(state(&session), [1.0, 0.0]);
    assert!(session.has_ghost());
    let expected = [Announcement::Restarted(h_l), Announcement::ParameterSet(h_l, 4.0)];
    assert_eq!(told(&mut session), expected);
    // While it is playing it goes on playing.
    session.play();
    session.tick(1.0);
    set(&mut session, "v_0", 2.0);
    assert!(session.is_playing() && session.time() == 0.0);
    assert_eq!(state(&session), [1.0, 2.0]);
}

#[test]
fn moving_a_slider_leaves_the_ghost_of_the_real_run() {
    let mut session = utube();
    play(&mut session, [10.0]);
    let h_l = parameter(&session, "h_l");
    session.play();
    for position in 3..12 {
        session.slide(h_l, position);
        session.tick(0.016);
    }
    let settings = Default::default();
    let svg = session.plot_svg(0, &settings, &session::figure::Palette::LIGHT);
    assert!(session.has_ghost());
    assert!(svg.contains("10"), "the axis still has room for the ghost's 10 s");
    session.back_to_start();
    assert!(!session.has_ghost());
}

#[test]
fn back_to_start_keeps_parameters_and_start_and_restoring_defaults_neither() {
    let mut session = utube();
    let b = parameter(&session, "b");
    set(&mut session, "b", 0.0);
    play(&mut session, [1.0]);
    session.back_to_start();
    assert_eq!((session.time(), state(&session), session.parameter_values()[b]), (0.0, vec![0.5, 0.0], 0.0));
    session.set_state(0, 0.75).unwrap();
    play(&mut session, [1.0]);
    session.back_to_start();
    assert!(session.is_started_by_hand() && !session.is_playing());
    assert_eq!((session.time(), state(&session), session.parameter_values()[b]), (0.0, vec![0.75, 0.0], 0.0));
    play(&mut session, [1.0]);
    session.restore_defaults();
    assert!(!session.is_started_by_hand());
    assert_eq!((session.time(), state(&session), session.parameter_values()[b]), (0.0, vec![0.5, 0.0], 50.0));
    // Without a start set by hand, a run in progress goes on.
    set(&mut session, "b", 0.0);
    play(&mut session, [1.0]);
    session.restore_defaults();
    assert_eq!((session.time(), session.parameter_values()[b]), (1.0, 50.0));
}

#[test]
fn runs_are_kept_by_what_differs() {
    let mut session = utube();
    play(&mut session, [1.0]);
    session.keep().unwrap();
    set(&mut session, "b", 200.0);
    play(&mut session, [1.0]);
    session.keep().unwrap();
    session.back_to_start();
    set(&mut session, "rho", 13534.0);
    session.set_state(0, 0.3).unwrap();
    session.set_method("euler").unwrap();
    session.keep().unwrap();
    session.keep().unwrap();
    let names = |session: &session::Session| session.kept().into_iter().map(|kept| kept.name).collect::<Vec<_>>();
    assert_eq!(
        names(&session),
        [
            "initial settings",
            "b = 50 kg/s → 200 kg/s",
            "ρ = 13534 kg/m³, b = 200 kg/s, y(0) = 0.3 m, y′(0) = 0 m/s, Euler",
            "ρ = 13534 kg/m³, b = 200 kg/s, y(0) = 0.3 m, y′(0) = 0 m/s, Euler (2)",
        ]
    );
    session.set_language("es");
    assert_eq!(names(&session)[0], "ajustes iniciales");
    assert!(names(&session)[2].contains("0,3 m"));
    let patterns: Vec<u8> = session.kept().iter().map(|kept| kept.pattern).collect();
    assert_eq!(patterns, [0, 1, 2, 3]);
    let second = session.kept()[1].id;
    session.remove_kept(second);
    session.show_kept(session.kept()[0].id, false);
    assert!(!session.kept()[0].shown);
    session.keep().unwrap();
    assert_eq!(session.kept().last().unwrap().pattern, 1, "the free pattern is used again");
    while session.kept().len() < MOST_KEPT {
        session.keep().unwrap();
    }
    assert_eq!(session.keep(), Err(Refusal::TooManyRuns { most: MOST_KEPT }));
    session.remove_kept(999);
    session.show_kept(999, true);
}

#[test]
fn events_are_part_of_the_run_and_break_its_line() {
    let source = "---\ntitle: Ball\n---\n```model\nparameter e = 0.9 in 0..1\ny'' = -9.81 [m/s^2]\ny(0) = 1 [m]\ny'(0) = 0 [m/s]\nwhen y < 0 [m] { y' = -e*y' }\n```\n```plots\n\"Velocity\": y' against t\n```\n";
    let mut straight = open(source, &[]);
    play(&mut straight, [3.0]);
    let mut scrubbed = open(source, &[]);
    play(&mut scrubbed, [2.0]);
    // Just before the first bounce at sqrt(2/9.81) = 0.45152 s, at it, and just after.
    for moment in [0.44, 0.451, 0.4515236, 0.452, 0.5, 1.2] {
        scrubbed.scrub(moment);
        play(&mut scrubbed, [3.0 - moment]);
        scrubbed.scrub(3.0);
        assert_eq!(bits(&scrubbed), bits(&straight), "after going on from {moment}");
    }
}
