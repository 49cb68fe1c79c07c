//! The run when the program is replaced: its time, its parameters, its bits.

use super::{dropped, edited, fresh, swinging};
use crate::support::{bits, go_on, open, parameter, set, state, utube};
use play::figure::{Palette, Settings};
use play::{Play, PlotId};

#[test]
fn a_run_of_the_same_model_stays_as_it_is() {
    for (what, from, to) in [
        ("prose", "A column of liquid swings.", "A column of mercury swings."),
        ("one more plot", "\"Phase portrait\"", "\"Velocity\": y' against t\n\"Phase portrait\""),
        ("another curve", "E, T, V against t", "E, T, V, L*y' against t"),
        ("the scene", "height=\"100\"", "height=\"{100 + y/(1 [m])}\""),
        ("a label and a range", "0..20000            \"Damping\"", "0..10000            \"Friction\""),
        ("a quantity", "E = T + V ", "E = T + V + V "),
    ] {
        for method in ["rk4", "dormand-prince"] {
            let mut play = utube();
            play.change_settings(|settings| settings.set_method(method)).unwrap();
            go_on(&mut play, [5.0]);
            set(&mut play, "b", 200.0);
            go_on(&mut play, [1.0]);
            play.change_run(|line, _| line.scrub(3.3));
            // A row has the same value at the same address, because nothing has been recomputed.
            let row = |play: &Play| play.course().history().unwrap().times().as_ptr();
            let (before, table, place) = (state(&play), play.values().table_cells(), row(&play));
            play.replace_program(edited(&[(from, to)]));
            assert_eq!(dropped(&mut play), [""; 0], "{what}");
            assert_eq!((play.course().time(), play.course().front(), state(&play)), (3.3, 6.0, before), "{what}");
            assert_eq!(row(&play), place, "{what}");
            if what != "a quantity" {
                assert_eq!(play.values().table_cells(), table, "{what}");
            }
            // Plots and later bits equal those of a run that used this program from the beginning.
            let mut other = fresh(&[(from, to)]);
            other.change_settings(|settings| settings.set_method(method)).unwrap();
            go_on(&mut other, [5.0]);
            set(&mut other, "b", 200.0);
            go_on(&mut other, [1.0]);
            other.change_run(|line, _| line.scrub(3.3));
            let drawn = |play: &mut Play, index| {
                play.change_run(|line, _| line.clear_ghost());
                play.plots_to_front().svg(PlotId::at(index), &Settings::default(), &Palette::LIGHT)
            };
            for index in 0..other.plots().list().len() {
                assert_eq!(drawn(&mut play, index), drawn(&mut other, index), "{what}, plot {index}");
            }
            for play in [&mut play, &mut other] {
                play.change_run(|line, _| line.scrub(6.0));
                go_on(play, [4.0]);
            }
            assert_eq!(bits(&play), bits(&other), "{what}");
        }
    }
}

#[test]
fn a_new_default_counts_where_nobody_has_set_the_parameter() {
    let rho = ("parameter rho = 1000", "parameter rho = 13534");
    let b = ("parameter b   = 50 ", "parameter b   = 70 ");
    let mut play = swinging();
    play.replace_program(edited(&[rho, b]));
    assert_eq!(dropped(&mut play), [""; 0]);
    // Until 5 s the damping was the default, which has changed; then it was set.
    let mut other = fresh(&[rho, b]);
    go_on(&mut other, [5.0]);
    set(&mut other, "b", 200.0);
    go_on(&mut other, [5.0]);
    other.change_run(|line, _| line.scrub(3.3));
    assert_eq!((play.course().time(), play.course().front()), (3.3, 10.0));
    assert_eq!((state(&play), bits(&play)), (state(&other), bits(&other)));
    assert_eq!(play.course().parameters()[parameter(&play, "b")], 70.0);
    play.change_run(|line, _| line.scrub(10.0));
    assert_eq!(play.course().parameters()[parameter(&play, "b")], 200.0);
    assert_eq!(play.course().parameters()[parameter(&play, "rho")], 13534.0);
    assert_eq!(play.share(), other.share().replace("&e=10&t=3.3", "&t=10"));
}

#[test]
fn what_does_not_fit_any_more_is_dropped_and_named() {
    let renamed = [
        ("parameter b ", "parameter beta "),
        ("b*y'", "beta*y'"),
        ("gamma = b/", "gamma = beta/"),
        ("b = ", "beta = "),
    ];
    let removed = [("parameter b   = 50   [kg/s]   in 0..20000            \"Damping\"\n", "b = 50 [kg/s]\n")];
    let other_unit = [
        ("b   = 50   [kg/s]   in", "b   = 50   [kg]   in"),
        ("b*y'", "b*y'/(1 [s])"),
        ("gamma = b/", "gamma = b/(1 [s])/"),
    ];
    let narrower = [("in 0..20000", "in 0..100")];
    let presets = "\"No damping\": b = 0 [kg/s]\n\"Critical\": b = 2*m*omega_0\n\"Mercury, critical\": rho = 13534 [kg/m^3], b = 2*m*omega_0\n\"Too much\": b = 100*m*omega_0\n";
    let question = "set: b = 0 [kg/s], h_l = 4 [m]";
    let bare = |changes: &[(&'static str, &'static str)]| {
        let mut all = vec![(presets, "\"Mercury again\": rho = 13534 [kg/m^3]\n"), (question, "set: h_l = 4 [m]")];
        all.extend(changes.iter().filter(|(from, _)| *from != "b = "));
        all
    };
    for (what, changes) in [
        ("renamed", bare(&renamed)),
        ("removed", bare(&removed)),
        ("another dimension", bare(&other_unit)),
        ("out of range", narrower.to_vec()),
    ] {
        let mut play = swinging();
        play.change_run(|line, _| line.scrub(7.0));
        set(&mut play, "g", 1.62);
        go_on(&mut play, [3.0]);
        play.replace_program(edited(&changes));
        assert_eq!(dropped(&mut play), ["b = 200 kg/s"], "{what}");
        let mut other = fresh(&changes);
        go_on(&mut other, [7.0]);
        set(&mut other, "g", 1.62);
        go_on(&mut other, [3.0]);
        assert_eq!((play.course().time(), state(&play)), (other.course().time(), state(&other)), "{what}");
        assert_eq!(bits(&play), bits(&other), "{what}");
    }
}

#[test]
fn with_another_equation_the_run_is_the_new_one_at_the_same_time_and_goes_on() {
    let quadratic = ("b*y'", "b*y'*abs(y')/(1 [m/s])");
    for method in ["rk4", "dormand-prince", "rosenbrock"] {
        let (mut play, mut other) = (utube(), fresh(&[quadratic]));
        for play in [&mut play, &mut other] {
            play.change_settings(|settings| settings.set_method(method)).unwrap();
            play.change_settings(|settings| settings.set_step(0.04)).unwrap();
            play.change_run(|line, _| line.set_speed(2.0));
            go_on(play, [1.017]);
            set(play, "b", 3000.0);
            play.change_run(|line, _| line.play());
            play.change_run(|line, _| line.tick(1.0));
        }
        assert_ne!(state(&play), state(&other));
        let old = play.plots_to_front().csv(PlotId::at(0));
        play.replace_program(edited(&[quadratic]));
        assert!(play.time_line().is_playing() && dropped(&mut play).is_empty());
        assert_eq!((play.course().time(), play.time_line().speed(), play.course().begun().step), (4.034, 2.0, 0.04));
        assert_eq!((state(&play), bits(&play)), (state(&other), bits(&other)), "{method}");
        // The run of the former equation becomes the previous run.
        assert!(play.time_line().has_ghost());
        let column = |csv: &str, number: usize| -> Vec<String> {
            csv.lines().skip(1).filter_map(|line| line.split(',').nth(number)).map(str::to_owned).collect()
        };
        let all = play.plots_to_front().csv(PlotId::at(0));
        assert!(column(&all, 1).starts_with(&column(&old, 1)), "the ghost is the former run");
        for play in [&mut play, &mut other] {
            play.change_run(|line, _| line.tick(0.5));
        }
        assert_eq!((play.course().time(), bits(&play)), (5.034, bits(&other)), "{method}");
    }
}

/// Rows are counted through events; nevertheless the change of a parameter keeps its time.
#[test]
fn a_change_keeps_its_time_where_events_leave_other_rows() {
    let ball = |height: f64| {
        format!(
            "---\ntitle: Ball\n---\n```model\nparameter e = 0.9 in 0..1\nparameter g = 9.81 [m/s^2]\ny'' = -g\n\
             y(0) = {height} [m]\ny'(0) = 0 [m/s]\nwhen y < 0 [m] {{ y' = -e*y' }}\n```\n"
        )
    };
    let run = |play: &mut Play| {
        go_on(play, [2.0]);
        set(play, "e", 0.8);
        go_on(play, [1.0]);
    };
    // A fall of 1 m takes 0.45 s, one of 2 m 0.64 s: the number of bounces until 2 s differs.
    let (mut play, mut other) = (open(&ball(1.0), &[]), open(&ball(2.0), &[]));
    run(&mut play);
    run(&mut other);
    assert_ne!(play.values().table_length(), other.values().table_length());
    play.change_run(|line, basis| line.keep(basis)).unwrap();
    play.replace_program(other.program().clone());
    assert_eq!((play.course().time(), bits(&play)), (other.course().time(), bits(&other)));
    assert_eq!(
        (play.share(), play.time_line().kept(play.basis()).len()),
        ([&other.share(), "&k", &other.share()[1..]].concat(), 1)
    );
}

#[test]
fn a_parameter_that_decides_an_initial_value_now_holds_from_the_start() {
    let start = ("y'(0) = v_0", "y'(0) = v_0 + b/(1000 [kg/m])");
    let mut play = swinging();
    play.change_run(|line, _| line.scrub(10.0));
    play.replace_program(edited(&[start]));
    let mut other = fresh(&[start]);
    set(&mut other, "b", 200.0);
    go_on(&mut other, [10.0]);
    assert_eq!((play.course().time(), bits(&play), play.share()), (10.0, bits(&other), other.share()));
}

#[test]
fn a_start_set_by_hand_stays_while_the_states_are_the_same() {
    let equation = ("b*y'", "2*b*y'");
    let mut play = utube();
    play.change_settings(|settings| settings.set_state(0, 0.3)).unwrap();
    go_on(&mut play, [2.0]);
    play.replace_program(edited(&[equation]));
    let mut other = fresh(&[equation]);
    other.change_settings(|settings| settings.set_state(0, 0.3)).unwrap();
    go_on(&mut other, [2.0]);
    assert!(play.course().is_started_by_hand() && dropped(&mut play).is_empty());
    assert_eq!(bits(&play), bits(&other));
    // Without inertia there is no initial velocity.
    let source = "---\ntitle: Decay\n---\n```model\nparameter b = 2 [1/s]\ny' = -b*y\ny(0) = 1 [m]\n```\n";
    play.change_settings(|settings| settings.set_state(1, 0.2)).unwrap();
    let from = state(&play)[0];
    go_on(&mut play, [1.0]);
    play.replace_program(open(source, &[]).program().clone());
    assert!(dropped(&mut play).is_empty(), "the position is there still");
    assert!((state(&play)[0] / from - 0.135_335_283_236_612_7).abs() < 1e-6, "it has decayed for 1 s");
    let mut again = utube();
    again.change_settings(|settings| settings.set_state(1, 0.2)).unwrap();
    again.replace_program(open(&source.replace('y', "z"), &[]).program().clone());
    assert_eq!(dropped(&mut again), ["y(0) = 0.5 m", "y′(0) = 0.2 m/s"]);
    assert!(!again.course().is_started_by_hand());
}

#[test]
fn no_document_costs_more_than_a_link() {
    let mut play = utube();
    go_on(&mut play, std::iter::repeat_n(50.0, 20));
    assert_eq!(play.course().time(), 1000.0);
    play.change_run(|line, _| line.play());
    // Ten thousand steps per second of model time, each with many operations.
    let long = ["b*y'", &"*cos(sin(y/(1 [m])))".repeat(20)].concat();
    play.replace_program(edited(&[("step: 0.05 [s]", "step: 0.0001 [s]"), ("b*y'", &long)]));
    assert!(
        play.time_line().is_playing() && play.course().time() > 0.0 && play.course().time() < 1000.0,
        "{}",
        play.course().time()
    );
    assert_eq!(dropped(&mut play), ["the time 1000.00 s"]);
    let reached = play.course().time();
    play.change_run(|line, _| line.tick(0.001));
    assert!(
        play.course().time() > reached,
        "{reached} {:?} {:?}",
        play.time_line().status(),
        play.time_line().problem(play.basis())
    );
}

#[test]
fn a_run_that_fails_stops_and_one_that_can_start_now_does() {
    let root = ("b*y'", "b*y'*sqrt(y/(1 [m]) + 0.2)");
    let mut play = utube();
    play.change_run(|line, _| line.play());
    play.change_run(|line, _| line.tick(4.0));
    play.replace_program(edited(&[root]));
    assert!(
        !play.time_line().is_playing()
            && play.time_line().problem(play.basis()).is_some()
            && play.course().time() < 4.0
    );
    let stopped = play.course().time();
    play.replace_program(edited(&[]));
    assert!(play.time_line().problem(play.basis()).is_none() && !play.time_line().is_playing());
    assert_eq!(play.course().time(), stopped);
}
