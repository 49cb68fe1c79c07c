//! Model time follows wall time at any frame rate.

use crate::support::{bits, go_on, open, set, state, utube};
use play::{Announcement, Play, SPEEDS, Status};

/// Frames with a total duration of `seconds`.
fn frames(rate: f64, seconds: f64) -> Vec<f64> {
    vec![1.0 / rate; (rate * seconds).round() as usize]
}

/// Frames of unequal duration with a total of 10 s.
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
        let mut play = utube();
        go_on(&mut play, [10.0]);
        (bits(&play), state(&play))
    };
    for frames in [frames(30.0, 10.0), frames(60.0, 10.0), frames(144.0, 10.0), irregular()] {
        let mut play = utube();
        go_on(&mut play, frames);
        assert!((play.course().time() - 10.0).abs() < 1e-9, "{}", play.course().time());
        // The rows are bit-identical. The moment shown deviates by the rounding of the sum of the frames.
        play.change_run(|line, _| line.scrub(9.99));
        let mut other = utube();
        go_on(&mut other, [10.0]);
        other.change_run(|line, _| line.scrub(9.99));
        assert_eq!(state(&play), state(&other));
        let rows = |csv: &str| csv.lines().take(200).map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(rows(&bits(&play)), rows(&expected.0));
    }
}

#[test]
fn the_drawing_moves_between_steps() {
    let mut play = utube();
    play.change_run(|line, _| line.play());
    let mut shown = Vec::new();
    for _ in 0..12 {
        play.change_run(|line, _| line.tick(1.0 / 240.0));
        shown.push(state(&play)[0]);
    }
    assert!(shown.windows(2).all(|pair| pair[1] < pair[0]), "{shown:?}");
    // y'' = -2 g y / L at the start: y(0.05) = 0.5 - 0.5 * 1.4 * 0.05 * 0.05 in the first approximation.
    assert!((shown[11] - (0.5 - 0.00175)).abs() < 2e-5, "{shown:?}");
    assert_eq!(play.values().table_length(), 1, "the row ahead of the moment shown is not there yet");
    play.change_run(|line, _| line.tick(1.0 / 240.0));
    assert_eq!(play.values().table_length(), 2);
}

#[test]
fn speeds_multiply() {
    for speed in SPEEDS {
        let mut play = utube();
        play.change_run(|line, _| line.set_speed(speed));
        assert_eq!(play.time_line().speed(), speed);
        go_on(&mut play, frames(60.0, 2.0));
        assert!((play.course().time() - 2.0 * speed).abs() < 1e-9);
    }
    let mut play = utube();
    for nonsense in [f64::NAN, f64::INFINITY] {
        play.change_run(|line, _| line.set_speed(nonsense));
        assert_eq!(play.time_line().speed(), 1.0);
    }
    play.change_run(|line, _| line.set_speed(-3.0));
    assert_eq!(play.time_line().speed(), 0.125);
    play.change_run(|line, _| line.set_speed(100.0));
    assert_eq!(play.time_line().speed(), 8.0);
}

/// Days that pass in seconds, and an end at 1 d that is not a multiple of the step.
fn days() -> Play {
    open(
        "---\nstep: 0.3 [d]\nuntil: 1 [d]\nspeed: 0.5 [d]\n---\n```model\nindependent t in [d]\nx' = 1 [1/d]\nx(0) = 0\n```\n",
        &[],
    )
}

#[test]
fn a_document_says_how_fast_it_is_watched() {
    let day = 86_400.0;
    let mut play = days();
    assert_eq!(
        (
            play.time_line().speed(),
            play.time_line().speed_text(play.basis(), 1.0),
            play.time_line().speed_text(play.basis(), 0.25)
        ),
        (1.0, "0.5 d/s".into(), "0.125 d/s".into())
    );
    go_on(&mut play, [1.0]);
    assert!((play.course().time() - 0.5 * day).abs() < 1e-6);
    play.change_run(|line, _| line.set_speed(2.0));
    go_on(&mut play, [0.25]);
    assert!((play.course().time() - 0.75 * day).abs() < 1e-6);
    assert_eq!(play.share(), "1&t=64800&x=2", "a link holds the multiple, as it always did");
    let mut spanish = days();
    spanish.set_language("es");
    assert_eq!(spanish.time_line().speed_text(spanish.basis(), 1.0), "0,5 d/s");
}

#[test]
fn a_run_pauses_at_its_end_and_can_be_continued() {
    let day = 86_400.0;
    let mut play = days();
    go_on(&mut play, [1.0, 7.0]);
    assert_eq!(
        (play.course().time(), play.time_line().status(), play.time_line().is_playing()),
        (day, Status::Ended, false)
    );
    assert!((state(&play)[0] - 1.0).abs() < 1e-12);
    assert_eq!(play.basis().horizon(play.course()), day, "the time line is full");
    let told: Vec<Announcement> = std::iter::from_fn(|| play.take_announcement()).collect();
    assert_eq!(told, [Announcement::Playing, Announcement::Ended(day)]);
    assert_eq!(told[1].text(play.basis(), play.time_line()), "The run ends at 1.00 d; press Play to continue");
    let link = play.share();
    play.change_run(|line, _| line.play());
    play.change_run(|line, _| line.tick(1.0));
    assert_eq!((play.course().time(), play.time_line().is_playing()), (1.5 * day, true));
    // After scrubbing back, the end is ahead again.
    play.change_run(|line, _| line.scrub(0.5 * day));
    assert_eq!(play.time_line().status(), Status::Paused);
    go_on(&mut play, [60.0]);
    assert_eq!((play.course().time(), play.time_line().status()), (day, Status::Ended));
    play.change_run(|line, _| line.step_forward());
    assert_eq!((play.course().time(), play.time_line().status()), (4.0 * 0.3 * day, Status::Paused));
    let mut other = days();
    other.restore(&link).unwrap();
    assert_eq!((other.course().time(), other.time_line().status()), (day, Status::Ended));
}

#[test]
fn a_step_stops_at_the_end() {
    let mut play = days();
    for _ in 0..4 {
        play.change_run(|line, _| line.step_forward());
    }
    assert_eq!((play.course().time(), play.time_line().status()), (86_400.0, Status::Ended));
}

#[test]
fn a_hidden_page_goes_on_and_a_sleeping_machine_does_not() {
    let mut play = utube();
    play.change_run(|line, _| line.play());
    assert!(play.change_run(|line, _| line.tick(30.0)));
    assert!((play.course().time() - 30.0).abs() < 1e-9);
    assert!(!play.change_run(|line, _| line.tick(3600.0)));
    assert!((play.course().time() - 30.0).abs() < 1e-9);
    assert_eq!(play.time_line().slippage(), 0.0);
    assert!(!play.change_run(|line, _| line.tick(f64::NAN)) && !play.change_run(|line, _| line.tick(-1.0)));
}

#[test]
fn what_cannot_be_computed_in_time_is_visible() {
    let mut play = utube();
    play.change_settings(|settings| settings.set_step(1e-6)).unwrap();
    play.change_run(|line, _| line.play());
    play.change_run(|line, _| line.tick(0.1));
    let computed = play.course().time();
    assert!((1e-3..0.05).contains(&computed), "{computed}");
    assert!((play.time_line().slippage() - (0.1 - computed)).abs() < 1e-12);
    // The delay is not made up for: the next tick advances by its own duration only.
    play.change_run(|line, _| line.tick(0.001));
    assert!((play.course().time() - computed - 0.001).abs() < 1e-12);
}

#[test]
fn steps_go_from_grid_time_to_grid_time() {
    let mut play = utube();
    go_on(&mut play, [0.13]);
    play.change_run(|line, _| line.step_forward());
    assert_eq!(play.course().time(), 3.0 * 0.05);
    play.change_run(|line, _| line.step_forward());
    assert_eq!(play.course().time(), 4.0 * 0.05);
    play.change_run(|line, _| line.step_back());
    play.change_run(|line, _| line.step_back());
    assert_eq!(play.course().time(), 2.0 * 0.05);
    assert!(play.course().is_scrubbed());
    for _ in 0..5 {
        play.change_run(|line, _| line.step_back());
    }
    assert_eq!(play.course().time(), 0.0);
    assert_eq!(play.course().front(), 4.0 * 0.05);
    assert_eq!(play.basis().time_text(play.course()), "0.00 s");
}

#[test]
fn short_times_are_told_in_a_unit_with_a_prefix() {
    let source = "---\ntitle: A\nstep: 0.01 [ns]\nspeed: 10 [ns]\nuntil: 40 [ns]\n---\n\n```model\nx' = -x/5 [ns]\nx(0) = 1\n```\n";
    let mut play = crate::support::open(source, &[]);
    go_on(&mut play, [0.5]);
    assert_eq!(play.basis().time_text(play.course()), "5.00 ns");
    let readout = play.readouts().remove(0);
    assert_eq!((readout.value.as_str(), readout.unit.as_str()), ("5.00", "ns"));
}

#[test]
fn a_run_that_fails_says_so_and_shows_the_last_good_moment() {
    let source = "---\ntitle: Runaway\n---\n```model\nparameter k = 1 [1/s] in 0..100\ny' = k*y^3\ny(0) = 1\n```\n";
    let mut play = open(source, &[]);
    go_on(&mut play, [10.0]);
    assert_eq!(play.time_line().status(), Status::Failed);
    let problem = play.time_line().problem(play.basis()).unwrap();
    assert_eq!(problem.code, "not-finite");
    assert!(play.course().time() < 0.7 && state(&play)[0].is_finite());
    let told: Vec<_> = std::iter::from_fn(|| play.take_announcement()).collect();
    assert!(told.contains(&Announcement::Failed), "{told:?}");
    play.set_language("es");
    assert_eq!(
        play.time_line().problem(play.basis()).unwrap().message,
        "y supera el mayor número representable después de t = 0,55 s."
    );
    // Scrub back and continue with a value that works.
    play.change_run(|line, _| line.scrub(0.2));
    assert_eq!((play.time_line().status(), play.time_line().problem(play.basis())), (Status::Paused, None));
    set(&mut play, "k", 0.0);
    go_on(&mut play, [1.0]);
    assert_eq!(play.time_line().status(), Status::Paused);
    assert!((play.course().time() - 1.2).abs() < 1e-9);
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
    let mut play = open(&source, &[]);
    play.change_run(|line, _| line.play());
    for _ in 0..100 {
        play.change_run(|line, _| line.tick(1.0));
    }
    assert_eq!(play.time_line().status(), Status::Full);
    let front = play.course().front();
    assert!((20.0..40.0).contains(&front), "{front}");
    play.change_run(|line, _| line.play());
    assert_eq!((play.time_line().status(), play.course().front()), (Status::Full, front));
    play.change_run(|line, _| line.scrub(1.0));
    assert_eq!(play.time_line().status(), Status::Paused);
    play.change_run(|line, _| line.play());
    play.change_run(|line, _| line.tick(0.5));
    assert!(play.time_line().is_playing() && play.course().front() == 1.5);
}

#[test]
fn a_closed_form_runs_too() {
    let source = "---\ntitle: Theory\n---\n```model\nparameter A = 2 [m] in 0..5\ny = A*cos(t*1 [1/s])\n```\n";
    let mut play: Play = open(source, &[]);
    go_on(&mut play, [1.0]);
    assert_eq!(play.values().table_length(), 21);
    assert!(state(&play).is_empty());
    assert_eq!(play.readouts()[1].value, "1.081");
}
