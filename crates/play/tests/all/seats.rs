//! Seats of a class: assigned values, and parameters that readers do not see.

use crate::support::{go_on, open, parameter, set};
use play::{Announcement, Play, Refusal, SeatView};

const TUBE: &str = include_str!("support/assigned.md");

fn tube() -> Play {
    open(TUBE, &[])
}

fn value(play: &Play, name: &str) -> f64 {
    play.course().parameters()[parameter(play, name)]
}

/// Right answer to the question.
fn right(play: &Play) -> String {
    play.answers().right_text(play.basis(), play.course(), 0)
}

#[test]
fn a_seat_sets_the_assigned_values_and_only_those() {
    let mut play = tube();
    assert_eq!(play.basis().seat(), Some(SeatView { assignment: "tube-2026".to_owned(), number: None }));
    assert_eq!((value(&play, "b"), value(&play, "zeta_q")), (0.02, 0.3137));
    set(&mut play, "c", 3.0);
    play.set_seat(" 7 ").unwrap();
    assert_eq!(play.take_announcement(), Some(Announcement::ParameterSet(parameter(&play, "c"), 3.0)));
    assert_eq!(play.take_announcement(), Some(Announcement::Seated(Some(7))));
    assert_eq!(play.basis().seat().unwrap().number, Some(7));
    let own = (value(&play, "b"), value(&play, "zeta_q"));
    assert!(own.0 != 0.02 && own.1 != 0.3137, "{own:?}");
    assert_eq!(value(&play, "c"), 3.0);
    // They are the defaults now, and a change of the text leaves them.
    set(&mut play, "b", 0.03);
    play.change_settings(|settings| settings.restore_defaults());
    assert_eq!(value(&play, "b"), own.0);
    let corrected = document::open(&TUBE.replace("A tube", "The tube").replace("Find", "Measure"), &[]);
    play.replace_program(corrected.document.unwrap().program);
    assert_eq!((value(&play, "b"), value(&play, "zeta_q")), own);
    play.set_seat("").unwrap();
    assert_eq!((value(&play, "b"), value(&play, "zeta_q")), (0.02, 0.3137));
    for text in ["0", "-7", "7.5", "seven", "99999999999"] {
        assert_eq!(play.set_seat(text), Err(Refusal::NoSeat), "{text}");
    }
    assert_eq!(
        (crate::support::utube().basis().seat(), crate::support::utube().set_seat("7")),
        (None, Err(Refusal::NoSeat))
    );
}

#[test]
fn a_link_has_the_seat_and_answers_follow() {
    let mut play = tube();
    for fragment in ["seat=7", "#seat=7", "1&seat=7"] {
        let mut seated = tube();
        seated.restore(fragment).unwrap();
        assert_eq!(seated.share(), "1&seat=7", "{fragment}");
        assert_eq!(seated.take_announcement(), None, "{fragment}: no state is back");
    }
    play.restore("1&seat=7").unwrap();
    let own = value(&play, "zeta_q");
    assert_eq!(play.share(), "1&seat=7");
    set(&mut play, "b", 0.05);
    go_on(&mut play, [1.0]);
    let link = play.share();
    assert!(link.starts_with("1&seat=7&p=b:0.05"), "{link}");
    let mut other = tube();
    other.restore(&link).unwrap();
    assert_eq!(other.take_announcement(), Some(Announcement::Restored));
    assert_eq!((other.values().csv(), value(&other, "zeta_q")), (play.values().csv(), own));
    assert_eq!(right(&other), format!("{} 1/s", play::number::plain(own, 4, other.basis().style())));
    assert_eq!(right(&tube()), "0.3137 1/s");
    // The document of another teacher assigns nothing; hostile seats are named.
    let mut utube = crate::support::utube();
    assert_eq!(utube.restore("1&seat=7"), Err(Refusal::PartlyRestored { left_out: vec!["seat=7".to_owned()] }));
    for seat in ["0", "x", "", "4294967296"] {
        let left_out = vec![format!("seat={seat}")];
        assert_eq!(tube().restore(&format!("1&seat={seat}")), Err(Refusal::PartlyRestored { left_out }));
    }
}

#[test]
fn a_hidden_parameter_is_in_nothing_that_readers_get() {
    let mut play = tube();
    play.set_seat("7").unwrap();
    go_on(&mut play, [1.0; 5]);
    play.change_run(|line, basis| line.keep(basis)).unwrap();
    set(&mut play, "c", 2.0);
    go_on(&mut play, [1.0]);
    play.change_run(|line, basis| line.keep(basis)).unwrap();
    let hidden = value(&play, "zeta_q");
    let index = parameter(&play, "zeta_q");
    let settings = figure::Settings::default();
    let mut all = format!(
        "{:?} {:?} {:?} {:?} {:?} {:?} {} {}",
        play.basis().parameters(play.course()),
        play.basis().parameter_groups(play.course()),
        play.readouts(),
        play.values().states(),
        play.controls().presets(play.basis(), play.course()),
        play.time_line().kept(play.basis()),
        play.share(),
        play.values().csv(),
    );
    for plot in play.plots().list() {
        all += &play.plots_to_front().svg(plot.id, &settings, &figure::Palette::LIGHT);
        all += &format!("{plot:?}");
    }
    let shown = format!("{hidden:.3}");
    for secret in ["zeta_q", "ζ", "Unknown", &shown, "tau_q"] {
        assert!(!all.contains(secret), "{secret} in {all}");
    }
    assert!(all.contains("Stiffness"), "the list is of what readers get");
    // Neither a link nor a typed text sets or reads it.
    assert_eq!(play.basis().parameter(play.course(), index), None);
    let link = "1&seat=7&p=zeta_q:1,c:2";
    assert_eq!(play.restore(link), Err(Refusal::PartlyRestored { left_out: vec!["zeta_q:1".to_owned()] }));
    assert_eq!(value(&play, "zeta_q"), hidden);
    assert!(play.change_settings(|settings| settings.set_parameter(index, 1.0)).is_err());
    let c = parameter(&play, "c");
    for text in ["zeta_q/(1 [1/s])", "1 [s]*ζ_q", "2*tau_q/(1 [s])"] {
        assert!(play.change_settings(|settings| settings.set_parameter_text(c, text)).is_err(), "{text}");
    }
    play.change_settings(|settings| settings.set_parameter_text(c, "c + b/(0.1 [kg/s])")).unwrap();
    // The model runs with it.
    let before = play.values().csv();
    play.set_seat("8").unwrap();
    go_on(&mut play, [1.0]);
    assert_ne!(before, play.values().csv());
}

#[test]
fn seats_are_said_in_both_languages() {
    let mut play = tube();
    let said = |play: &Play| {
        [Announcement::Seated(Some(7)), Announcement::Seated(None)].map(|one| one.text(play.basis(), play.time_line()))
    };
    let refused = |play: &Play| play.basis().refusal_text(&Refusal::NoSeat);
    assert_eq!(said(&play), ["Seat 7: your own values are set", "No seat: the values of the document are set"]);
    assert_eq!(refused(&play), "A seat is a whole number from 1, as your teacher has given it to you.");
    play.set_language("es");
    assert_eq!(
        said(&play),
        ["Puesto 7: tus propios valores están puestos", "Sin puesto: están los valores del documento"]
    );
    assert_eq!(refused(&play), "Un puesto es un número entero desde 1, el que te dio tu docente.");
}
