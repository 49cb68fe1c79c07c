//! Links and saved states.

use crate::support::{bits, play, set, utube};
use figure::{Direction, Palette, Point, Settings};
use session::{Refusal, Session};

/// Opens the document anew and restores what `session` shares.
fn reopened(session: &Session) -> Session {
    let fragment = session.share();
    let allowed = |character: char| character.is_ascii_alphanumeric() || "-._~!$&'()*+,;=:@/?".contains(character);
    assert!(fragment.chars().all(allowed), "{fragment}");
    let mut other = utube();
    other.restore(&fragment).unwrap_or_else(|refusal| panic!("{fragment}: {refusal:?}"));
    assert_eq!(other.share(), fragment);
    other
}

#[test]
fn nothing_is_shared_of_a_fresh_document() {
    let mut session = utube();
    assert_eq!(session.share(), "");
    session.restore("").unwrap();
    session.restore("#").unwrap();
    assert_eq!(session.share(), "");
}

#[test]
fn a_link_is_short_and_says_what_differs() {
    let mut session = utube();
    set(&mut session, "b", 200.0);
    set(&mut session, "h_l", 3.5);
    session.set_speed(2.0);
    session.show_plot(2, false);
    play(&mut session, [5.0]);
    assert_eq!(session.share(), "1&p=b:200,h_l:3.5&t=10&x=2&v=2");
    let other = reopened(&session);
    assert_eq!(bits(&other), bits(&session));
    assert_eq!((other.speed(), other.plots()[2].shown), (2.0, false));
    assert!(!other.is_playing());
}

#[test]
fn what_plots_are_zoomed_to_comes_back() {
    let mut session = utube();
    play(&mut session, [5.0]);
    let settings = Settings::default();
    for plot in 0..3 {
        session.layout_plot(plot, &settings);
    }
    let drawn = |session: &mut Session, plot| session.plot_svg(plot, &settings, &Palette::LIGHT);
    let everything = drawn(&mut session, 1);
    session.zoom_plot(0, None, 2.0, Direction::Horizontal);
    session.zoom_plot(1, Some(Point { x: 200.0, y: 90.0 }), 3.0, Direction::Both);
    session.pan_plot(2, 0.0, 17.0);
    let mut other = reopened(&session);
    for plot in 0..3 {
        assert!(!other.plots()[plot].automatic);
        assert_eq!(drawn(&mut other, plot), drawn(&mut session, plot));
    }
    assert_ne!(drawn(&mut other, 1), everything);
    other.restore("1&t=5").unwrap();
    assert!(other.plots().iter().all(|plot| plot.automatic));
    assert_eq!(drawn(&mut other, 1), everything);
}

#[test]
fn everything_comes_back_with_the_same_bits() {
    let mut session = utube();
    session.set_state(0, 0.123_456_789).unwrap();
    session.set_method("dormand-prince").unwrap();
    session.set_step(0.03).unwrap();
    play(&mut session, [1.0 / 3.0]);
    set(&mut session, "b", 1e-7);
    play(&mut session, [1.0]);
    set(&mut session, "rho", 2000.0);
    set(&mut session, "g", 1.62);
    play(&mut session, [1.0]);
    session.keep().unwrap();
    set(&mut session, "h_l", 5.0);
    play(&mut session, [2.0]);
    set(&mut session, "b", 0.0);
    play(&mut session, [2.0]);
    session.scrub(1.0 / 7.0);
    let other = reopened(&session);
    assert_eq!(bits(&other), bits(&session));
    assert_eq!((other.time(), other.end()), (session.time(), session.end()));
    assert_eq!(crate::support::state(&other), crate::support::state(&session));
    assert_eq!(other.parameter_values(), session.parameter_values());
    assert_eq!(other.kept(), session.kept());
}

/// What an adaptive method does next depends on the steps behind it, also where the run went on from an earlier moment.
#[test]
fn a_run_that_goes_on_from_an_earlier_moment_comes_back_with_the_same_bits() {
    for method in ["rk4", "dormand-prince", "rosenbrock"] {
        for back in [0.0, 0.32, 0.5] {
            let mut session = utube();
            session.set_method(method).unwrap();
            play(&mut session, [0.7]);
            session.scrub(back);
            session.step_forward();
            set(&mut session, "b", 80.0);
            session.step_forward();
            session.step_forward();
            session.scrub(back);
            play(&mut session, [0.4]);
            assert_eq!(bits(&reopened(&session)), bits(&session), "{method} from {back}");
        }
    }
}

#[test]
fn a_change_that_has_not_acted_yet_is_shared() {
    let mut session = utube();
    play(&mut session, [1.0]);
    set(&mut session, "b", 300.0);
    let mut other = reopened(&session);
    assert_eq!(other.parameter_values(), session.parameter_values());
    play(&mut session, [1.0]);
    play(&mut other, [1.0]);
    assert_eq!(bits(&other), bits(&session));
}

#[test]
fn more_changes_than_a_link_holds_leave_the_state() {
    let mut session = utube();
    session.play();
    for change in 0..1000 {
        set(&mut session, "b", f64::from(change));
        session.tick(0.05);
    }
    session.pause();
    let fragment = session.share();
    assert!(fragment.len() < 200, "{fragment}");
    let mut other = utube();
    other.restore(&fragment).unwrap();
    assert_eq!(crate::support::state(&other), crate::support::state(&session));
    assert_eq!(other.parameter_values(), session.parameter_values());
}

#[test]
fn what_does_not_fit_is_left_out_and_named() {
    for (fragment, left_out) in [
        ("1&p=b:200,q:3", "q:3"),
        ("1&p=b:1e9&t=1", "b:1e9"),
        ("1&p=b:nan", "b:nan"),
        ("1&p", "p"),
        ("1&y=1", "y=1"),
        ("1&y=1,inf", "y=1,inf"),
        ("1&m=leapfrog", "m=leapfrog"),
        ("1&h=0", "h=0"),
        ("1&h=-1&t=3", "h=-1"),
        ("1&t=-1", "t=-1"),
        ("1&t=1e300", "t=1e300"),
        ("1&c=0,b:3", "c=0,b:3"),
        ("1&c=10,b:3&c=5,b:3&t=3", "c=5,b:3"),
        ("1&c=99999999,b:3", "c"),
        ("1&v=7", "v=7"),
        ("1&z=7,0:1", "z=7,0:1"),
        ("1&z=0", "z=0"),
        ("1&z=0,1:1", "z=0,1:1"),
        ("1&z=0,2:1", "z=0,2:1"),
        ("1&z=1,0:1,2:3,4:5", "z=1,0:1,2:3,4:5"),
        ("1&z=1,0:NaN", "z=1,0:NaN"),
        ("1&zzz=1", "zzz=1"),
        ("1&&", ""),
        ("1&k&k&k&k&k&k&k", "k"),
    ] {
        let mut session = utube();
        let refusal = session.restore(fragment).expect_err(fragment);
        let Refusal::PartlyRestored { left_out: parts } = &refusal else { panic!("{fragment}: {refusal:?}") };
        assert!(parts.iter().any(|part| part.starts_with(left_out)), "{fragment}: {parts:?}");
        session.play();
        session.tick(0.1);
    }
    for fragment in ["2&p=b:1", "hello", "%31", "p=b:200", "1;p=b:200", "é"] {
        let mut session = utube();
        assert_eq!(session.restore(fragment), Err(Refusal::UnreadableState), "{fragment}");
        assert_eq!(session.share(), "");
    }
}

#[test]
fn restoring_replaces_what_was_there() {
    let mut session = utube();
    play(&mut session, [3.0]);
    session.keep().unwrap();
    session.show_plot(0, false);
    session.play();
    session.restore("1&p=b:7&t=2").unwrap();
    assert!(!session.is_playing() && session.kept().is_empty() && !session.has_ghost());
    assert_eq!(session.share(), "1&p=b:7&t=2");
}
