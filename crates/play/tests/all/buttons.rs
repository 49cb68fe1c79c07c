//! Buttons of the document: pressing, scrubbing back over presses, kept runs and links.

use crate::support::{bits, go_on, open, readout, set, state};
use play::{Announcement, Play, Refusal, Status};

const KICKED: &str = "---
title: Kicked
language: en
step: 0.05 [s]
until: 20 [s]
---

```model
parameter w = 2 [rad/s] in 0..9 \"Angular frequency\"
parameter A = 0.3 [m] in 0..9 \"Amplitude\"
x'' + w^2*x = 0
x(0) = A \"Displacement\"
x'(0) = 0 [m/s]
button \"Kick\" as kick { x' = x' + 1 [m/s] }
button \"Stop: now, or = never\" { stop }
n = kick.count \"Kicks\"
```

```plots
\"Displacement\": x against t
```
";
const KICKED_ES: &str = "---
language: es
translates: kicked.md
---

```translations
\"Angular frequency\" = \"Pulsación\"
\"Amplitude\" = \"Amplitud\"
\"Displacement\" = \"Desplazamiento\"
\"Kick\" = \"Patada\"
\"Stop: now, or = never\" = \"Parar\"
\"Kicks\" = \"Patadas\"
```
";

fn kicked() -> Play {
    open(KICKED, &[])
}

/// x(t) with kicks at these times.
fn x(kicks: &[f64], time: f64) -> f64 {
    let kick = |at: &f64| if time > *at { libm::sin(2.0 * (time - at)) / 2.0 } else { 0.0 };
    0.3 * libm::cos(2.0 * time) + kicks.iter().map(kick).sum::<f64>()
}

/// The run restored from its link.
fn by_link(play: &Play) -> Play {
    let mut other = kicked();
    other.restore(&play.share()).unwrap_or_else(|refusal| panic!("{}: {refusal:?}", play.share()));
    assert_eq!(other.share(), play.share());
    assert_eq!(bits(&other), bits(play));
    other
}

#[test]
fn a_press_acts_at_the_moment_shown() {
    let mut play = kicked();
    go_on(&mut play, [1.015, 0.008]);
    let before = state(&play);
    assert!(play.time_line().can_press());
    play.change_settings(|settings| settings.press(0)).unwrap();
    assert_eq!(play.course().time(), 1.023, "no time passes");
    let after = state(&play);
    assert!((after[0] - before[0]).abs() < 1e-6 && (after[1] - before[1] - 1.0).abs() < 1e-6, "{before:?} {after:?}");
    assert_eq!(readout(&mut play, "n"), "1");
    let told = std::iter::from_fn(|| play.take_announcement()).last().unwrap();
    assert_eq!(told, Announcement::Pressed(0, 1.023));
    assert_eq!(told.text(play.basis(), play.time_line()), "Kick, 1.02 s");
    go_on(&mut play, [2.0]);
    assert!((state(&play)[0] - x(&[1.023], play.course().time())).abs() < 1e-4);
    by_link(&play);
}

#[test]
fn while_it_plays_a_run_goes_on() {
    let mut play = kicked();
    play.change_run(|line, _| line.play());
    play.change_run(|line, _| line.tick(0.51));
    play.change_settings(|settings| settings.press(0)).unwrap();
    play.change_run(|line, _| line.tick(0.51));
    play.change_settings(|settings| settings.press(0)).unwrap();
    play.change_settings(|settings| settings.press(0)).unwrap();
    assert!(play.time_line().is_playing());
    play.change_run(|line, _| line.tick(0.98));
    play.change_run(|line, _| line.pause());
    assert!((state(&play)[0] - x(&[0.51, 1.02, 1.02], 2.0)).abs() < 1e-4);
    assert_eq!(play.share(), "1&b=kick:0.51:1.02:1.02&t=2");
    by_link(&play);
}

#[test]
fn a_press_before_the_first_step() {
    let mut play = kicked();
    play.change_settings(|settings| settings.press(0)).unwrap();
    assert_eq!((play.course().time(), state(&play)), (0.0, vec![0.3, 1.0]));
    by_link(&play);
    play.change_settings(|settings| settings.press(0)).unwrap();
    assert_eq!(state(&play), [0.3, 2.0]);
    go_on(&mut play, [1.0]);
    assert!((state(&play)[0] - x(&[0.0, 0.0], 1.0)).abs() < 1e-4);
    let other = by_link(&play);
    assert_eq!(state(&other), state(&play));
    play.change_run(|line, basis| line.back_to_start(basis));
    assert_eq!((play.share(), state(&play)), (String::new(), vec![0.3, 0.0]), "a fresh start has no presses");
}

#[test]
fn going_back_and_on_again_repeats_what_was_pressed() {
    for method in ["rk4", "dormand-prince", "rosenbrock"] {
        let mut play = kicked();
        play.change_settings(|settings| settings.set_method(method)).unwrap();
        go_on(&mut play, [1.23]);
        play.change_settings(|settings| settings.press(0)).unwrap();
        go_on(&mut play, [1.0]);
        play.change_settings(|settings| settings.press(0)).unwrap();
        go_on(&mut play, [3.0]);
        let (run, time) = (bits(&play), play.course().time());
        for back in [0.0, 0.7, 1.23, 2.0] {
            play.change_run(|line, _| line.scrub(back));
            go_on(&mut play, [time - back]);
            play.change_run(|line, _| line.scrub(time));
            assert_eq!(bits(&play), run, "{method} from {back}");
        }
        by_link(&play);
    }
}

#[test]
fn a_press_in_the_past_gives_up_what_followed() {
    let mut play = kicked();
    go_on(&mut play, [1.0]);
    play.change_settings(|settings| settings.press(0)).unwrap();
    go_on(&mut play, [3.0]);
    play.change_run(|line, _| line.scrub(0.52));
    assert!(!play.time_line().has_ghost());
    play.change_settings(|settings| settings.press(0)).unwrap();
    assert_eq!((play.course().time(), play.course().front()), (0.52, 0.52));
    assert!(play.time_line().has_ghost(), "the rows after it stay behind");
    go_on(&mut play, [2.0]);
    assert!((state(&play)[0] - x(&[0.52], 2.52)).abs() < 1e-4, "the later press is gone");
    // A change of a parameter also discards later presses.
    play.change_run(|line, _| line.scrub(0.2));
    set(&mut play, "w", 3.0);
    assert!(play.share().starts_with("1&c="), "{}", play.share());
    by_link(&play);
}

#[test]
fn parameters_and_presses_in_one_step() {
    let mut play = kicked();
    go_on(&mut play, [1.01]);
    set(&mut play, "w", 3.0);
    play.change_settings(|settings| settings.press(0)).unwrap();
    set(&mut play, "w", 4.0);
    go_on(&mut play, [0.02]);
    play.change_settings(|settings| settings.press(0)).unwrap();
    go_on(&mut play, [1.0]);
    play.change_run(|line, _| line.step_forward());
    play.change_settings(|settings| settings.press(0)).unwrap();
    set(&mut play, "w", 1.0);
    go_on(&mut play, [1.0]);
    let other = by_link(&play);
    assert_eq!(other.course().parameters()[0], 1.0);
    let sets: Vec<f64> = play.course().history().unwrap().parameter_sets().iter().map(|(_, set)| set[0]).collect();
    assert_eq!(sets, [2.0, 4.0, 1.0]);
}

#[test]
fn kept_runs_and_the_link_keep_theirs() {
    let mut play = kicked();
    go_on(&mut play, [1.0]);
    play.change_settings(|settings| settings.press(0)).unwrap();
    go_on(&mut play, [1.0]);
    play.change_run(|line, basis| line.keep(basis)).unwrap();
    assert_eq!(play.time_line().kept(play.basis())[0].name, "Kick 1.00 s");
    play.change_run(|line, basis| line.back_to_start(basis));
    for _ in 0..4 {
        go_on(&mut play, [0.2]);
        play.change_settings(|settings| settings.press(0)).unwrap();
    }
    play.change_run(|line, basis| line.keep(basis)).unwrap();
    assert_eq!(play.time_line().kept(play.basis())[1].name, "Kick × 4");
    set(&mut play, "A", 0.5);
    assert_eq!(play.share().matches("b=").count(), 2, "an initial value has begun another run: {}", play.share());
    let other = by_link(&play);
    assert_eq!(
        other.time_line().kept(other.basis()).iter().map(|kept| kept.name.clone()).collect::<Vec<_>>(),
        ["A = 0.3 m, Kick 1.00 s", "A = 0.3 m, Kick × 4"]
    );
}

#[test]
fn nothing_is_pressed_where_an_event_has_ended_the_run() {
    let mut play = kicked();
    go_on(&mut play, [1.0]);
    play.change_run(|line, _| line.play());
    play.change_settings(|settings| settings.press(1)).unwrap();
    assert_eq!(
        (play.time_line().status(), play.time_line().is_playing(), play.course().time()),
        (Status::Ended, false, 1.0)
    );
    assert!(!play.time_line().can_press());
    assert_eq!(play.change_settings(|settings| settings.press(0)), Err(Refusal::RunEnded));
    by_link(&play);
    play.change_run(|line, _| line.scrub(0.5));
    assert!(play.time_line().can_press(), "before its end");
    play.change_run(|line, _| line.scrub(1.0));
    play.change_run(|line, _| line.play());
    assert!(play.time_line().can_press(), "gone on beyond");
    play.change_settings(|settings| settings.press(0)).unwrap();
    play.change_run(|line, _| line.tick(0.5));
    play.change_run(|line, _| line.pause());
    assert!((state(&play)[0] - x(&[1.0], 1.5)).abs() < 1e-4);
    assert_eq!(play.share(), "1&b=Stop%3A%20now%2C%20or%20%3D%20never:1,kick:1&t=1.5");
    by_link(&play);
    assert_eq!(play.change_settings(|settings| settings.press(7)), Err(Refusal::Unknown { name: "7".into() }));
}

#[test]
fn a_run_has_room_for_so_many_presses() {
    let mut play = kicked();
    for _ in 0..300 {
        play.change_settings(|settings| settings.press(0)).unwrap();
    }
    assert_eq!(play.change_settings(|settings| settings.press(0)), Err(Refusal::TooManyPresses { most: 300 }));
    assert_eq!(state(&play)[1], 300.0);
    by_link(&play);
    let mut other = kicked();
    let many = format!("1&b=kick{}&t=1", ":0.5".repeat(301));
    assert!(matches!(other.restore(&many), Err(Refusal::PartlyRestored { .. })));
    for wrong in ["b=push:1", "b=kick:2:1", "b=kick:-1", "b=kick:x", "b=kick:1e999"] {
        let refused = Refusal::PartlyRestored { left_out: vec![wrong.to_owned()] };
        assert_eq!(kicked().restore(&format!("1&{wrong}&t=1")), Err(refused));
    }
}

#[test]
fn titles_are_translated() {
    let mut play = open(KICKED, &[KICKED_ES]);
    play.set_language("es");
    let titles: Vec<String> = play.basis().buttons().into_iter().map(|button| button.title).collect();
    assert_eq!(titles, ["Patada", "Parar"]);
    play.change_settings(|settings| settings.press(0)).unwrap();
    play.change_settings(|settings| settings.press(1)).unwrap();
    assert_eq!(
        play.time_line().problem(play.basis()).map(|problem| problem.message).as_deref(),
        Some("La simulación termina en t = 0 s: Parar.")
    );
}

#[test]
fn a_changed_document_keeps_the_presses() {
    let mut play = kicked();
    go_on(&mut play, [1.0]);
    play.change_settings(|settings| settings.press(0)).unwrap();
    go_on(&mut play, [1.0]);
    let renamed = KICKED.replace("button \"Kick\"", "button \"Push\"").replace("0.3 [m]", "0.6 [m]");
    play.replace_program(document::open(&renamed, &[]).document.unwrap().program);
    assert_eq!(play.share(), "1&b=kick:1&t=2");
    assert!((state(&play)[0] - x(&[1.0], 2.0) - 0.3 * libm::cos(4.0)).abs() < 1e-4);
    let without =
        KICKED.replace("as kick", "as push").replace("kick.count", "push.count").replace("\"Kick\"", "\"Push\"");
    play.replace_program(document::open(&without, &[]).document.unwrap().program);
    assert_eq!(play.share(), "1&t=2");
    let told = std::iter::from_fn(|| play.take_announcement()).last();
    assert_eq!(told, Some(Announcement::Replaced(vec!["Push".to_owned()])));
}
