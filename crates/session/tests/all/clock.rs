//! Model time is wall time, whatever the frame rate.

use crate::support::{bits, open, play, set, state, utube};
use session::{Announcement, SPEEDS, Session, Status};

/// Frames that last `seconds` in all.
fn frames(rate: f64, seconds: f64) -> Vec<f64> {
    vec![1.0 / rate; (rate * seconds).round() as usize]
}

/// Frames of uneven length that last 10 s in all.
fn irregular() -> Vec<f64> {
    let mut frames = Vec::new();
    let mut left = 10.0;
    for length in [0.004, 0.016, 0.033, 0.1, 0.25, 0.0007, 1.1].into_iter().cycle() {
        if length >= left {
            frames.push(left);
            return frames;
        }
        frames.push(length);
        left -= length;
    }
    frames
}

#[test]
fn model_time_is_wall_time_at_any_frame_rate() {
    let expected = {
        let mut session = utube();
        play(&mut session, [10.0]);
        (bits(&session), state(&session))
    };
    for frames in [frames(30.0, 10.0), frames(60.0, 10.0), frames(144.0, 10.0), irregular()] {
        let mut session = utube();
        play(&mut session, frames);
        assert!((session.time() - 10.0).abs() < 1e-9, "{}", session.time());
        // The rows are the same bits; the moment shown lies within the rounding of the sum of the frames.
        session.scrub(9.99);
        let mut other = utube();
        play(&mut other, [10.0]);
        other.scrub(9.99);
        assert_eq!(state(&session), state(&other));
        let rows = |csv: &str| csv.lines().take(200).map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(rows(&bits(&session)), rows(&expected.0));
    }
}

#[test]
fn the_drawing_moves_between_steps() {
    let mut session = utube();
    session.play();
    let mut shown = Vec::new();
    for _ in 0..12 {
        session.tick(1.0 / 240.0);
        shown.push(state(&session)[0]);
    }
    assert!(shown.windows(2).all(|pair| pair[1] < pair[0]), "{shown:?}");
    // y'' = -2 g y / L at the start: y(0.05) = 0.5 - 0.5 * 1.4 * 0.05 * 0.05 in the first approximation.
    assert!((shown[11] - (0.5 - 0.00175)).abs() < 2e-5, "{shown:?}");
    assert_eq!(session.table_length(), 1, "the row ahead of the moment shown is not there yet");
    session.tick(1.0 / 240.0);
    assert_eq!(session.table_length(), 2);
}

#[test]
fn speeds_multiply() {
    for speed in SPEEDS {
        let mut session = utube();
        session.set_speed(speed);
        assert_eq!(session.speed(), speed);
        play(&mut session, frames(60.0, 2.0));
        assert!((session.time() - 2.0 * speed).abs() < 1e-9);
    }
    let mut session = utube();
    for nonsense in [f64::NAN, f64::INFINITY] {
        session.set_speed(nonsense);
        assert_eq!(session.speed(), 1.0);
    }
    session.set_speed(-3.0);
    assert_eq!(session.speed(), 0.125);
    session.set_speed(100.0);
    assert_eq!(session.speed(), 8.0);
}

#[test]
fn a_hidden_page_goes_on_and_a_sleeping_machine_does_not() {
    let mut session = utube();
    session.play();
    assert!(session.tick(30.0));
    assert!((session.time() - 30.0).abs() < 1e-9);
    assert!(!session.tick(3600.0));
    assert!((session.time() - 30.0).abs() < 1e-9);
    assert_eq!(session.slippage(), 0.0);
    assert!(!session.tick(f64::NAN) && !session.tick(-1.0));
}

#[test]
fn what_cannot_be_computed_in_time_is_visible() {
    let mut session = utube();
    session.set_step(1e-6).unwrap();
    session.play();
    session.tick(0.1);
    let computed = session.time();
    assert!((1e-3..0.05).contains(&computed), "{computed}");
    assert!((session.slippage() - (0.1 - computed)).abs() < 1e-12);
    // What is missed is not made up for: the next tick is as short as the first.
    session.tick(0.001);
    assert!((session.time() - computed - 0.001).abs() < 1e-12);
}

#[test]
fn steps_go_from_grid_time_to_grid_time() {
    let mut session = utube();
    play(&mut session, [0.13]);
    session.step_forward();
    assert_eq!(session.time(), 3.0 * 0.05);
    session.step_forward();
    assert_eq!(session.time(), 4.0 * 0.05);
    session.step_back();
    session.step_back();
    assert_eq!(session.time(), 2.0 * 0.05);
    assert!(session.is_scrubbed());
    for _ in 0..5 {
        session.step_back();
    }
    assert_eq!(session.time(), 0.0);
    assert_eq!(session.end(), 4.0 * 0.05);
    assert_eq!(session.time_text(), "0.00 s");
}

#[test]
fn a_run_that_fails_says_so_and_shows_the_last_good_moment() {
    let source = "---\ntitle: Runaway\n---\n```model\nparameter k = 1 [1/s] in 0..100\ny' = k*y^3\ny(0) = 1\n```\n";
    let mut session = open(source, &[]);
    play(&mut session, [10.0]);
    assert_eq!(session.status(), Status::Failed);
    let problem = session.problem().unwrap();
    assert_eq!(problem.code, "not-finite");
    assert!(session.time() < 0.7 && state(&session)[0].is_finite());
    let told: Vec<_> = std::iter::from_fn(|| session.take_announcement()).collect();
    assert!(told.contains(&Announcement::Failed), "{told:?}");
    session.set_language("es");
    assert_eq!(session.problem().unwrap().message, "y deja de ser un número finito después de t = 0,55 s.");
    // Back, and on with a value that holds.
    session.scrub(0.2);
    assert_eq!((session.status(), session.problem()), (Status::Paused, None));
    set(&mut session, "k", 0.0);
    play(&mut session, [1.0]);
    assert_eq!(session.status(), Status::Paused);
    assert!((session.time() - 1.2).abs() < 1e-9);
}

#[test]
fn a_full_history_pauses_the_run() {
    // Many plots, so that a row takes much memory and few rows fill it.
    let mut source =
        "---\ntitle: Long\nstep: 1e-3 [s]\n---\n```model\ny' = -y/(1 [s])\ny(0) = 1\n```\n```plots\n".to_owned();
    for plot in 0..24 {
        let curves: Vec<String> = (0..12).map(|curve| format!("{}*y", 12 * plot + curve + 2)).collect();
        source += &format!("\"{plot}\": {} against t\n", curves.join(", "));
    }
    source += "```\n";
    let mut session = open(&source, &[]);
    session.play();
    for _ in 0..100 {
        session.tick(1.0);
    }
    assert_eq!(session.status(), Status::Full);
    let front = session.end();
    assert!((20.0..40.0).contains(&front), "{front}");
    session.play();
    assert_eq!((session.status(), session.end()), (Status::Full, front));
    session.scrub(1.0);
    assert_eq!(session.status(), Status::Paused);
    session.play();
    session.tick(0.5);
    assert!(session.is_playing() && session.end() == 1.5);
}

#[test]
fn a_closed_form_runs_too() {
    let source = "---\ntitle: Theory\n---\n```model\nparameter A = 2 [m] in 0..5\ny = A*cos(t*1 [1/s])\n```\n";
    let mut session: Session = open(source, &[]);
    play(&mut session, [1.0]);
    assert_eq!(session.table_length(), 21);
    assert!(state(&session).is_empty());
    assert_eq!(session.readouts()[1].value, "1.081");
}
