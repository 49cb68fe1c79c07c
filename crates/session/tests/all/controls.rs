//! Parameters, presets, the state by hand, dragging, method and step.

use crate::support::{bits, parameter, play, set, state, utube};
use session::{Announcement, Refusal, Session};

fn refused(session: &mut Session, name: &str, text: &str) -> String {
    let index = parameter(session, name);
    let before = session.parameter_values().to_vec();
    let refusal = session.set_parameter_text(index, text).expect_err("this is to be refused");
    assert_eq!(session.parameter_values(), before);
    session.refusal_text(&refusal)
}

#[test]
fn expressions_are_taken_as_presets_have_them() {
    let mut session = utube();
    let b = parameter(&session, "b");
    for (text, expected) in [
        ("2*m*omega_0", 2.0 * 350.0 * (2.0_f64 * 9.8 / 7.0).sqrt()),
        ("m*omega_0/2 in [g/s]", 0.5 * 350.0 * (2.0_f64 * 9.8 / 7.0).sqrt()),
        ("3*50", 150.0),
        ("0,1 t/s", 0.1e3),
    ] {
        session.set_parameter_text(b, text).unwrap();
        let value = session.parameter(b).unwrap().value;
        assert!((value - expected).abs() < 1e-9 * expected, "{text}: {value} and not {expected}");
    }
    session.set_state_text(0, "-y(0)/2").unwrap();
    assert_eq!(session.state(0).unwrap().value, -0.25);
    for text in ["2*m", "b*t", "y'*m", "2*", "regime", "1/0", "nothing"] {
        assert!(session.set_parameter_text(b, text).is_err(), "{text}");
    }
}

#[test]
fn what_is_typed_is_taken_in_any_unit_or_refused_in_words() {
    let mut session = utube();
    for (name, text, expected) in [
        ("h_l", "2.7", 2.7),
        ("h_l", "400 cm", 4.0),
        ("h_l", " 4,5 ", 4.5),
        ("rho", "13,534", 13534.0),
        ("rho", "13.5 g/cm³", 13500.0),
        ("S", "500 cm^2", 0.05),
        ("b", "2e3", 2000.0),
        ("v_0", "−18 km/h", -5.0),
    ] {
        let index = parameter(&session, name);
        session.set_parameter_text(index, text).unwrap();
        assert_eq!(session.parameter_values()[index], expected, "{name} = {text}");
    }
    for (name, text, expected) in [
        ("h_l", "", "Type a number."),
        ("h_l", "much", "“much” is not a number."),
        ("h_l", "10", "Left height: at most 9 m."),
        ("h_l", "1.5", "Left height: at least 2 m."),
        ("h_l", "150 cm", "Left height: at least 2 m."),
        ("b", "-500", "Damping: at least 0 kg/s."),
        ("h_l", "3 kg", "kg measures something else; a unit such as m is needed."),
        ("h_l", "3 furlongs", "“furlongs” is not a known unit."),
        ("h_l", "1e999", "“1e999” is not a number."),
    ] {
        assert_eq!(refused(&mut session, name, text), expected, "{name} = {text}");
    }
    session.set_language("es");
    assert_eq!(refused(&mut session, "h_l", "1,5"), "Altura izquierda: como mínimo 2 m.");
    assert_eq!(refused(&mut session, "S", "2,5"), "Sección: como máximo 2 m².");
    assert!(session.set_parameter(99, 1.0).is_err() && session.set_parameter_text(99, "1").is_err());
    assert!(session.set_parameter(0, f64::NAN).is_err());
    session.slide(99, 1);
    session.restore_default(99);
}

#[test]
fn a_field_that_is_left_as_it_is_does_not_round_the_value() {
    let mut session = utube();
    let b = parameter(&session, "b");
    set(&mut session, "b", 1_979.898_987_322_333);
    let shown = session.parameter(b).unwrap();
    assert_eq!((shown.text.as_str(), shown.spoken.as_str()), ("1979.9", "1979.9 kg/s"));
    session.set_parameter_text(b, &shown.text).unwrap();
    assert_eq!(session.parameter_values()[b], 1_979.898_987_322_333);
}

#[test]
fn controls_show_what_they_set() {
    let mut session = utube();
    session.set_language("es");
    let view = session.parameter(parameter(&session, "S")).unwrap();
    assert_eq!((view.label.as_str(), view.unit.as_str(), view.text.as_str()), ("Sección", "m²", "0,05"));
    assert_eq!(view.range, Some(("0,01".to_owned(), "2".to_owned())));
    assert_eq!(view.slider.map(|slider| (slider.position, slider.positions)), Some((4, 199)));
    assert!(view.is_default && !view.restarts);
    session.slide(view.index, 9);
    let view = session.parameter(view.index).unwrap();
    assert_eq!((view.value, view.is_default), (0.1, false));
    session.restore_defaults();
    assert!(session.parameters().iter().all(|parameter| parameter.is_default));
}

#[test]
fn the_damping_slider_is_fine_near_zero_and_reaches_critical_damping() {
    let mut session = utube();
    let b = parameter(&session, "b");
    let slider = session.parameter(b).unwrap().slider.unwrap();
    assert!((10..50).contains(&slider.position), "{slider:?}");
    session.slide(b, 1);
    assert!(session.parameter_values()[b] < 0.1);
    set(&mut session, "rho", 13600.0);
    session.slide(b, slider.positions);
    assert_eq!(crate::support::readout(&mut session, "regime"), "overdamped");
}

#[test]
fn presets_are_computed_one_after_the_other() {
    let mut session = utube();
    let groups = session.presets();
    let names: Vec<&str> = groups.iter().map(|group| group.name.as_str()).collect();
    assert_eq!(names, ["Liquid", "Regime"]);
    let selected = |session: &mut Session| {
        let presets = session.presets().into_iter().flat_map(|group| group.presets);
        presets.filter(|preset| preset.selected).map(|preset| preset.name).collect::<Vec<_>>()
    };
    assert_eq!(selected(&mut session), ["Water"]);
    session.apply_preset(3).unwrap();
    // 2 m omega_0 = 2 * 350 kg * sqrt(2 * 9.8 / 7) s^-1.
    let b = parameter(&session, "b");
    assert!((session.parameter_values()[b] - 700.0 * 2.8_f64.sqrt()).abs() < 1e-9);
    assert_eq!(selected(&mut session), ["Water", "Critical"]);
    assert_eq!(groups[1].presets[1].description, "b = 1171.32 kg/s");
    session.apply_preset(4).unwrap();
    let mercury = 13534.0 * 0.05 * 7.0;
    assert!((session.parameter_values()[b] - 2.0 * mercury * 2.8_f64.sqrt()).abs() < 1e-6);
    assert_eq!(selected(&mut session), ["Mercury", "Critical", "Mercury, critical"]);
    // A value out of the range is refused, and nothing is set.
    let before = session.parameter_values().to_vec();
    let refusal = session.apply_preset(5).unwrap_err();
    assert_eq!(session.refusal_text(&refusal), "Damping: at most 20000 kg/s.");
    assert_eq!(session.parameter_values(), before);
    assert!(session.apply_preset(99).is_err());
    session.set_language("es");
    assert_eq!(session.presets()[0].presets[1].name, "Mercurio");
}

#[test]
fn the_state_is_set_by_hand_while_paused() {
    let mut session = utube();
    play(&mut session, [1.0]);
    let velocity = state(&session)[1];
    session.set_state_text(0, "80 cm").unwrap();
    assert_eq!((session.time(), state(&session)), (0.0, vec![0.8, velocity]));
    assert!(session.has_ghost() && session.is_started_by_hand());
    session.play();
    assert_eq!(session.set_state(0, 0.1), Err(Refusal::NotPaused));
    session.tick(0.5);
    session.pause();
    // Restarting drops it.
    set(&mut session, "h_l", 4.0);
    assert_eq!(state(&session), [1.0, 0.0]);
    assert!(session.set_state(0, f64::INFINITY).is_err());
    assert!(session.set_state(7, 1.0).is_err());
    assert!(session.set_state_text(0, "1 s").is_err());
}

/// The handle of the test document's scene.
fn handle(session: &Session) -> session::program::Drag {
    let scene = session.document().program.scene("en").unwrap();
    let mut drags = scene.root.children.iter().filter_map(|child| match child {
        session::program::Child::Element(element) => element.drag.clone(),
        session::program::Child::Text(_) => None,
    });
    drags.next().expect("the scene has a handle")
}

#[test]
fn the_liquid_follows_the_pointer_and_is_let_go() {
    let mut session = utube();
    let drag = handle(&session);
    session.play();
    session.tick(1.0);
    let held = state(&session)[0];
    session.drag_begin(&drag);
    assert!(!session.is_playing() && session.is_dragging());
    session.drag_move(500.0, 10.0);
    assert_eq!(session.time(), 0.0);
    assert!((state(&session)[0] - (held + 0.25)).abs() < 1e-12);
    assert_eq!(state(&session)[1], 0.0, "what is held is at rest");
    session.drag_move(0.0, -4.0);
    assert!((state(&session)[0] - (held - 0.1)).abs() < 1e-12);
    // Never further than the scene is high.
    session.drag_move(0.0, 1e9);
    assert!((state(&session)[0] - (held + 300.0 * 0.025)).abs() < 1e-9);
    session.drag_move(f64::NAN, 1.0);
    session.drag_move(0.0, 8.0);
    session.drag_end();
    assert!(session.is_playing() && !session.is_dragging());
    let from = state(&session);
    session.tick(0.5);
    assert!(state(&session)[0] < from[0]);
    assert!(session.has_ghost());
    session.drag_move(0.0, 5.0);
    session.drag_end();
}

#[test]
fn the_liquid_goes_no_further_than_the_drawing() {
    let source = crate::support::UTUBE.replace("{100 - 40*y/(1 [m])}", "{100 - 40*min(y, 2 [m])/(1 [m])}");
    let mut session = crate::support::open(&source, &[]);
    let drag = handle(&session);
    session.drag_begin(&drag);
    session.drag_move(0.0, 250.0);
    assert!((state(&session)[0] - 2.0).abs() < 1e-9, "{:?}", state(&session));
    session.drag_move(0.0, 20.0);
    assert!((state(&session)[0] - 1.0).abs() < 1e-12);
    session.drag_move(0.0, -200.0);
    assert!((state(&session)[0] + 4.5).abs() < 1e-12, "downwards nothing limits it");
    session.drag_end();
    let told = std::iter::from_fn(|| session.take_announcement()).last();
    assert_eq!(told, Some(Announcement::StateSet(0, -4.5)));
}

/// `y(0) = (h_l - h_r)/2` with room in the ranges: one column rises by as much as the other falls.
#[test]
fn a_drag_at_the_start_sets_the_parameters_that_decide_it() {
    let source = crate::support::UTUBE.replace("in 2..9", "in 0..9");
    let mut session = crate::support::open(&source, &[]);
    let drag = handle(&session);
    let heights = |session: &Session| ["h_l", "h_r"].map(|name| session.parameter_values()[parameter(session, name)]);
    // 0.025 m for a unit of the scene.
    for (up, y, h_l, h_r) in
        [(12.0, 0.8, 3.3, 1.7), (-12.0, 0.5, 3.0, 2.0), (-20.0, 0.0, 2.5, 2.5), (-24.0, -0.6, 1.9, 3.1)]
    {
        session.drag_begin(&drag);
        session.drag_move(0.0, 3.0);
        session.drag_move(0.0, up);
        session.drag_end();
        let near = |value: f64, expected: f64| (value - expected).abs() < 1e-12;
        let [left, right] = heights(&session);
        assert!(near(state(&session)[0], y) && near(left, h_l) && near(right, h_r), "{up}: {left} {right}");
        assert!(!session.is_started_by_hand());
    }
    let told = std::iter::from_fn(|| session.take_announcement()).last().unwrap();
    let text = session.announcement_text(&told);
    assert_eq!(text, "Displacement: -0.6 m; Left height: 1.9 m, Right height: 3.1 m".replace('-', "−"));
    // Played and taken back, the run starts there again; the document's values come back on request.
    play(&mut session, [1.0]);
    session.back_to_start();
    assert!((state(&session)[0] + 0.6).abs() < 1e-12);
    session.restore_defaults();
    assert_eq!((state(&session), heights(&session)), (vec![0.5, 0.0], [3.0, 2.0]));
}

#[test]
fn a_drag_at_the_start_leaves_the_other_initial_values() {
    let mut session = utube();
    set(&mut session, "v_0", 2.0);
    let drag = handle(&session);
    session.drag_begin(&drag);
    session.drag_move(0.0, -12.0);
    assert!((state(&session)[0] - 0.2).abs() < 1e-12);
    session.drag_end();
    assert_eq!(state(&session)[1], 2.0);
    // Any other moment is one of the hand, which holds still what it holds.
    play(&mut session, [0.5]);
    session.drag_begin(&drag);
    session.drag_move(0.0, -12.0);
    session.drag_end();
    assert_eq!(state(&session)[1], 0.0);
    assert!(session.is_started_by_hand());
}

/// Where a range ends, or no parameter decides, the state itself is the start: it is played from, gone back to, shared,
/// and given up with a word.
#[test]
fn what_no_parameter_can_follow_is_kept_as_the_start() {
    let literal = crate::support::UTUBE.replace("y(0)  = (h_l - h_r)/2 ", "y(0)  = 0.5 [m] ");
    for source in [crate::support::UTUBE, &literal] {
        let mut session = crate::support::open(source, &[]);
        let drag = handle(&session);
        let parameters = session.parameter_values().to_vec();
        session.drag_begin(&drag);
        session.drag_move(0.0, 12.0);
        session.drag_end();
        assert!(session.is_started_by_hand(), "the right height is at the end of its range");
        assert_eq!(session.parameter_values(), parameters);
        assert!((state(&session)[0] - 0.8).abs() < 1e-12);
        play(&mut session, [1.0]);
        session.back_to_start();
        assert!(session.is_started_by_hand() && (state(&session)[0] - 0.8).abs() < 1e-12);
        let told = std::iter::from_fn(|| session.take_announcement()).last().unwrap();
        assert_eq!(session.announcement_text(&told), "Back at the start that was set by hand");
        let mut other = crate::support::open(source, &[]);
        other.restore(&session.share()).unwrap();
        assert_eq!(state(&other), state(&session));
        session.restore_defaults();
        assert!(!session.is_started_by_hand());
        assert_eq!(state(&session), [0.5, 0.0]);
        let told = std::iter::from_fn(|| session.take_announcement()).last();
        assert_eq!(told, Some(Announcement::DefaultsRestored));
    }
    // A parameter that decides the start gives it up too, and says so although no time has passed.
    let mut session = utube();
    session.set_state(0, 0.7).unwrap();
    set(&mut session, "h_l", 4.0);
    let told: Vec<_> = std::iter::from_fn(|| session.take_announcement()).collect();
    assert!(told.contains(&Announcement::Restarted(parameter(&session, "h_l"))), "{told:?}");
}

/// A start that is no linear function of its parameters, one without a range among them.
#[test]
fn a_curved_start_is_met_exactly() {
    let source = "---\ntitle: Ball\n---\n```model\nparameter v = 3 [m/s] in 0..20\nparameter c = 2 [s^2/m]\n\
                  y' = -y/(1 [s])\ny(0) = c*v^2 in [m]\n```\n```scene\n<svg viewBox=\"0 0 100 100\">\
                  <circle cx=\"5\" cy=\"{y/(1 [m])}\" r=\"5\" drag=\"y\" drag-up=\"1 [m]\"/></svg>\n```\n";
    let mut session = crate::support::open(source, &[]);
    let drag = handle(&session);
    for up in [1.0, 7.0, -15.0, 40.0, -0.001] {
        let before = state(&session)[0];
        session.drag_begin(&drag);
        session.drag_move(0.0, up);
        session.drag_end();
        assert!(!session.is_started_by_hand(), "{up}");
        assert!((state(&session)[0] - (before + up)).abs() < 1e-7 * (before + up).abs(), "{up}: {:?}", state(&session));
        let [v, c] = session.parameter_values() else { panic!() };
        assert!((0.0..=20.0).contains(v) && c.is_finite());
    }
}

#[test]
fn a_click_on_the_liquid_changes_nothing() {
    let mut session = utube();
    let drag = handle(&session);
    play(&mut session, [1.0]);
    let before = bits(&session);
    session.drag_begin(&drag);
    session.drag_end();
    assert_eq!(bits(&session), before);
    assert!(!session.is_playing());
    session.drag_begin(&session::program::Drag { state: 9, up: None, right: Some(77) });
    session.drag_move(1.0, 1.0);
    session.drag_end();
    assert_eq!(bits(&session), before);
}

#[test]
fn methods_and_steps_are_chosen() {
    let mut session = utube();
    let methods = session.methods();
    assert_eq!(methods.len(), 6);
    assert!(methods.iter().all(|method| method.refused.is_empty()));
    assert_eq!(methods.iter().find(|method| method.selected).map(|method| method.name), Some("rk4"));
    for method in methods {
        session.set_method(method.name).unwrap();
        play(&mut session, [1.0]);
        // y = 0.5 cos(omega t) but for a little damping and, with Euler's method, a little error.
        assert!((state(&session)[0] - 0.5 * libm::cos(2.8_f64.sqrt())).abs() < 0.06, "{}", method.name);
    }
    assert!(session.set_method("leapfrog").is_err());
    assert_eq!(session.step_text(), ("0.05".to_owned(), "s".to_owned()));
    session.set_step_text("10 ms").unwrap();
    assert_eq!((session.step(), session.time()), (0.01, 0.0));
    for text in ["0", "-1", "x", "1 m", "nan"] {
        assert!(session.set_step_text(text).is_err(), "{text}");
    }
}

#[test]
fn verlet_is_refused_for_an_equation_of_first_order() {
    let source = "---\ntitle: Decay\n---\n```model\ny' = -y/(1 [s])\ny(0) = 1\n```\n";
    let mut session = crate::support::open(source, &[]);
    let refusal = session.set_method("velocity-verlet").unwrap_err();
    assert_eq!(session.refusal_text(&refusal), "velocity Verlet is for equations of second order only.");
    assert!(session.methods().iter().any(|method| method.refused == session.refusal_text(&refusal)));
    play(&mut session, [1.0]);
    assert!((state(&session)[0] - libm::exp(-1.0)).abs() < 1e-6);
}

#[test]
fn everything_is_announced() {
    let mut session = utube();
    session.play();
    session.tick(1.0);
    session.pause();
    session.set_speed(0.25);
    session.apply_preset(1).unwrap();
    session.step_forward();
    session.back_to_start();
    let mut texts = Vec::new();
    while let Some(announcement) = session.take_announcement() {
        texts.push(session.announcement_text(&announcement));
    }
    assert_eq!(texts, ["Playing", "Paused at 1.00 s", "Speed 1/4×", "Mercury", "Step, 1.05 s", "Back at the start"]);
    session.set_language("es");
    let h_l = parameter(&session, "h_l");
    for (announcement, expected) in [
        (Announcement::Restarted(h_l), "La serie comienza de nuevo: cambió Altura izquierda"),
        (Announcement::ParameterSet(h_l, 2.5), "Altura izquierda: 2,5 m"),
        (Announcement::Paused(1.25), "En pausa en 1,25 s"),
        (Announcement::StateSet(0, 0.25), "Desplazamiento: 0,25 m; la serie parte de ahí"),
        (Announcement::ParameterSet(99, 2.5), ": "),
    ] {
        assert_eq!(session.announcement_text(&announcement), expected);
    }
}

#[test]
fn answers_stay_with_their_questions() {
    let mut session = utube();
    session.check_answer(0, "123456");
    session.type_answer(1, "1");
    session.check_answer(1, "1");
    session.reveal_answer(1);
    session.check_answer(99, "1");
    let saved = session.saved_answers();
    assert_eq!(saved.len(), 2);
    session.set_language("es");
    assert_eq!(session.saved_answers(), saved, "the same in both languages");
    let answer = session.answer(0);
    assert_eq!(answer.verdict.map(|verdict| verdict.text).as_deref(), Some("Todavía no."));
    assert_eq!((answer.typed.as_str(), answer.revealed), ("123456", false));
    // Another question in front of them, and a later visit in Spanish.
    let source = crate::support::UTUBE.replacen(
        "```question\n",
        "```question\nWhat is g?\nanswer: g within 1 %\n```\n\n```question\n",
        1,
    );
    let mut later = crate::support::open(&source, &[]);
    later.set_language("es");
    for (name, text) in &saved {
        later.restore_answer(name, text);
    }
    assert_eq!((later.answer(0), later.answer(1)), (session::AnswerView::default(), session.answer(0)));
    assert_eq!(later.answer(2), session.answer(1));
    assert_eq!(later.answer(2).verdict.map(|verdict| verdict.grade), Some(session::Grade::Correct));
    assert!(later.answer(2).revealed);
    // Typing takes the verdict away; nonsense in the storage changes nothing.
    later.type_answer(2, "2\n3");
    assert_eq!((later.answer(2).typed.as_str(), later.answer(2).verdict), ("2 3", None));
    let before = later.saved_answers();
    for (name, text) in [("", ""), (saved[0].0.as_str(), "one line"), ("0000000000000000", "1\nright\n")] {
        later.restore_answer(name, text);
    }
    assert_eq!(later.saved_answers(), before);
}
