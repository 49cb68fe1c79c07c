//! Parameters, presets, the state by hand, method and step.

use crate::support::{go_on, open, parameter, set, state, utube};
use play::{Announcement, Play, Refusal};

fn refused(play: &mut Play, name: &str, text: &str) -> String {
    let index = parameter(play, name);
    let before = play.course().parameters().to_vec();
    let refusal =
        play.change_settings(|settings| settings.set_parameter_text(index, text)).expect_err("this is to be refused");
    assert_eq!(play.course().parameters(), before);
    play.basis().refusal_text(&refusal)
}

#[test]
fn expressions_are_taken_as_presets_have_them() {
    let mut play = utube();
    let b = parameter(&play, "b");
    for (text, expected) in [
        ("2*m*omega_0", 2.0 * 350.0 * (2.0_f64 * 9.8 / 7.0).sqrt()),
        ("m*omega_0/2 in [g/s]", 0.5 * 350.0 * (2.0_f64 * 9.8 / 7.0).sqrt()),
        ("3*50", 150.0),
        ("0,1 t/s", 0.1e3),
    ] {
        play.change_settings(|settings| settings.set_parameter_text(b, text)).unwrap();
        let value = play.basis().parameter(play.course(), b).unwrap().value;
        assert!((value - expected).abs() < 1e-9 * expected, "{text}: {value} and not {expected}");
    }
    play.change_settings(|settings| settings.set_state_text(0, "-y(0)/2")).unwrap();
    assert_eq!(play.values().state(0).unwrap().value, -0.25);
    for text in ["2*m", "b*t", "y'*m", "2*", "regime", "1/0", "nothing"] {
        assert!(play.change_settings(|settings| settings.set_parameter_text(b, text)).is_err(), "{text}");
    }
}

#[test]
fn what_is_typed_is_taken_in_any_unit_or_refused_in_words() {
    let mut play = utube();
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
        let index = parameter(&play, name);
        play.change_settings(|settings| settings.set_parameter_text(index, text)).unwrap();
        assert_eq!(play.course().parameters()[index], expected, "{name} = {text}");
    }
    for (name, text, expected) in [
        ("h_l", "", "Type a number."),
        ("h_l", "much", "“much” is not a number. Write one such as 2.5 m."),
        ("h_l", "10", "Left height: at most 9 m."),
        ("h_l", "1.5", "Left height: at least 2 m."),
        ("h_l", "150 cm", "Left height: at least 2 m."),
        ("b", "-500", "Damping: at least 0 kg/s."),
        ("h_l", "3 kg", "kg measures something else; a unit such as m is needed."),
        ("h_l", "3 furlongs", "“furlongs” is not a known unit. Write a number such as 2.5 m."),
        ("h_l", "1e999", "“1e999” is not a number. Write one such as 2.5 m."),
    ] {
        assert_eq!(refused(&mut play, name, text), expected, "{name} = {text}");
    }
    play.set_language("es");
    assert_eq!(refused(&mut play, "h_l", "1,5"), "Altura izquierda: como mínimo 2 m.");
    assert_eq!(refused(&mut play, "S", "2,5"), "Sección: como máximo 2 m².");
    assert!(
        play.change_settings(|settings| settings.set_parameter(99, 1.0)).is_err()
            && play.change_settings(|settings| settings.set_parameter_text(99, "1")).is_err()
    );
    assert!(play.change_settings(|settings| settings.set_parameter(0, f64::NAN)).is_err());
    play.change_settings(|settings| settings.slide(99, 1));
    play.change_settings(|settings| settings.slide(99, 0));
}

#[test]
fn a_field_that_is_left_as_it_is_does_not_round_the_value() {
    let mut play = utube();
    let b = parameter(&play, "b");
    set(&mut play, "b", 1_979.898_987_322_333);
    let shown = play.basis().parameter(play.course(), b).unwrap();
    assert_eq!((shown.text.as_str(), shown.spoken.as_str()), ("1979.9", "1979.9 kg/s"));
    play.change_settings(|settings| settings.set_parameter_text(b, &shown.text)).unwrap();
    assert_eq!(play.course().parameters()[b], 1_979.898_987_322_333);
}

#[test]
fn controls_show_what_they_set() {
    let mut play = utube();
    play.set_language("es");
    let view = play.basis().parameter(play.course(), parameter(&play, "S")).unwrap();
    assert_eq!((view.label.as_str(), view.unit.as_str(), view.text.as_str()), ("Sección", "m²", "0,05"));
    assert_eq!(view.range, Some(("0,01".to_owned(), "2".to_owned())));
    assert_eq!(view.slider.map(|slider| (slider.position, slider.positions)), Some((4, 199)));
    assert!(view.is_default && !view.restarts);
    play.change_settings(|settings| settings.slide(view.index, 9));
    let view = play.basis().parameter(play.course(), view.index).unwrap();
    assert_eq!((view.value, view.is_default), (0.1, false));
    play.change_settings(|settings| settings.restore_defaults());
    assert!(play.basis().parameters(play.course()).iter().all(|parameter| parameter.is_default));
}

#[test]
fn the_damping_slider_is_fine_near_zero_and_reaches_critical_damping() {
    let mut play = utube();
    let b = parameter(&play, "b");
    let slider = play.basis().parameter(play.course(), b).unwrap().slider.unwrap();
    assert!((10..50).contains(&slider.position), "{slider:?}");
    play.change_settings(|settings| settings.slide(b, 1));
    assert!(play.course().parameters()[b] < 0.1);
    set(&mut play, "rho", 13600.0);
    play.change_settings(|settings| settings.slide(b, slider.positions));
    assert_eq!(crate::support::readout(&mut play, "regime"), "overdamped");
}

#[test]
fn presets_are_computed_one_after_the_other() {
    let mut play = utube();
    let groups = play.controls().presets(play.basis(), play.course());
    let names: Vec<&str> = groups.iter().map(|group| group.name.as_str()).collect();
    assert_eq!(names, ["Liquid", "Regime"]);
    let selected = |play: &mut Play| {
        let presets = play.controls().presets(play.basis(), play.course()).into_iter().flat_map(|group| group.presets);
        presets.filter(|preset| preset.selected).map(|preset| preset.name).collect::<Vec<_>>()
    };
    assert_eq!(selected(&mut play), ["Water"]);
    play.change_settings(|settings| settings.apply_preset(3)).unwrap();
    // 2 m omega_0 = 2 * 350 kg * sqrt(2 * 9.8 / 7) s^-1.
    let b = parameter(&play, "b");
    assert!((play.course().parameters()[b] - 700.0 * 2.8_f64.sqrt()).abs() < 1e-9);
    assert_eq!(selected(&mut play), ["Water", "Critical"]);
    assert_eq!(groups[1].presets[1].description, "b = 1171.32 kg/s");
    play.change_settings(|settings| settings.apply_preset(4)).unwrap();
    let mercury = 13534.0 * 0.05 * 7.0;
    assert!((play.course().parameters()[b] - 2.0 * mercury * 2.8_f64.sqrt()).abs() < 1e-6);
    assert_eq!(selected(&mut play), ["Mercury", "Critical", "Mercury, critical"]);
    // A value out of the range is refused, and nothing is set.
    let before = play.course().parameters().to_vec();
    let refusal = play.change_settings(|settings| settings.apply_preset(5)).unwrap_err();
    assert_eq!(play.basis().refusal_text(&refusal), "Damping: at most 20000 kg/s.");
    assert_eq!(play.course().parameters(), before);
    assert!(play.change_settings(|settings| settings.apply_preset(99)).is_err());
    play.set_language("es");
    assert_eq!(play.controls().presets(play.basis(), play.course())[0].presets[1].name, "Mercurio");
}

/// A value at the start in a preset is the one that the values before it give.
#[test]
fn a_preset_sees_the_start_that_it_has_set() {
    let source = "```model\nparameter a = 1 [m] in 0..9\nparameter b = 1 [m] in 0..9\nx' = 0 [m/s]\nx(0) = 2*a\n```\n\n\
                  ```presets\n\"Both\": a = 3 [m], b = x(0)\n```\n";
    let mut play = Play::open(document::open(source, &[]).document.unwrap().program);
    play.change_settings(|settings| settings.apply_preset(0)).unwrap();
    assert_eq!(play.course().parameters(), [3.0, 6.0]);
}

#[test]
fn the_state_is_set_by_hand_while_paused() {
    let mut play = utube();
    go_on(&mut play, [1.0]);
    let velocity = state(&play)[1];
    play.change_settings(|settings| settings.set_state_text(0, "80 cm")).unwrap();
    assert_eq!((play.course().time(), state(&play)), (0.0, vec![0.8, velocity]));
    assert!(play.time_line().has_ghost() && play.course().is_started_by_hand());
    play.change_run(|line, _| line.play());
    assert_eq!(play.change_settings(|settings| settings.set_state(0, 0.1)), Err(Refusal::NotPaused));
    play.change_run(|line, _| line.tick(0.5));
    play.change_run(|line, _| line.pause());
    // The restart discards the state set by hand.
    set(&mut play, "h_l", 4.0);
    assert_eq!(state(&play), [1.0, 0.0]);
    assert!(play.change_settings(|settings| settings.set_state(0, f64::INFINITY)).is_err());
    assert!(play.change_settings(|settings| settings.set_state(7, 1.0)).is_err());
    assert!(play.change_settings(|settings| settings.set_state_text(0, "1 s")).is_err());
}

#[test]
fn methods_and_steps_are_chosen() {
    let mut play = utube();
    let methods = play.basis().methods(play.course());
    assert_eq!(methods.len(), 6);
    assert!(methods.iter().all(|method| method.refused.is_empty()));
    assert_eq!(methods.iter().find(|method| method.selected).map(|method| method.name), Some("rk4"));
    for method in methods {
        play.change_settings(|settings| settings.set_method(method.name)).unwrap();
        go_on(&mut play, [1.0]);
        // y = 0.5 cos(omega t) except for a little damping and, with Euler's method, a small error.
        assert!((state(&play)[0] - 0.5 * libm::cos(2.8_f64.sqrt())).abs() < 0.06, "{}", method.name);
    }
    assert!(play.change_settings(|settings| settings.set_method("leapfrog")).is_err());
    assert_eq!(play.basis().step_text(play.course()), ("0.05".to_owned(), "s".to_owned()));
    play.change_settings(|settings| settings.set_step_text("10 ms")).unwrap();
    assert_eq!((play.course().begun().step, play.course().time()), (0.01, 0.0));
    for text in ["0", "-1", "x", "1 m", "nan"] {
        assert!(play.change_settings(|settings| settings.set_step_text(text)).is_err(), "{text}");
    }
}

#[test]
fn verlet_is_refused_for_an_equation_of_first_order() {
    let source = "---\ntitle: Decay\n---\n```model\ny' = -y/(1 [s])\ny(0) = 1\n```\n";
    let mut play = crate::support::open(source, &[]);
    let refusal = play.change_settings(|settings| settings.set_method("velocity-verlet")).unwrap_err();
    assert_eq!(play.basis().refusal_text(&refusal), "velocity Verlet is for equations of second order only.");
    assert!(
        play.basis().methods(play.course()).iter().any(|method| method.refused == play.basis().refusal_text(&refusal))
    );
    go_on(&mut play, [1.0]);
    assert!((state(&play)[0] - libm::exp(-1.0)).abs() < 1e-6);
}

#[test]
fn everything_is_announced() {
    let mut play = utube();
    play.change_run(|line, _| line.play());
    play.change_run(|line, _| line.tick(1.0));
    play.change_run(|line, _| line.pause());
    play.change_run(|line, _| line.set_speed(0.25));
    play.change_settings(|settings| settings.apply_preset(1)).unwrap();
    play.change_run(|line, _| line.step_forward());
    play.change_run(|line, basis| line.back_to_start(basis));
    let mut texts = Vec::new();
    while let Some(announcement) = play.take_announcement() {
        texts.push(announcement.text(play.basis(), play.time_line()));
    }
    assert_eq!(texts, ["Playing", "Paused at 1.00 s", "Speed 1/4 ×", "Mercury", "Step, 1.05 s", "Back at the start"]);
    play.set_language("es");
    let h_l = parameter(&play, "h_l");
    for (announcement, expected) in [
        (Announcement::Restarted(h_l), "El ensayo comienza de nuevo: cambió Altura izquierda"),
        (Announcement::ParameterSet(h_l, 2.5), "Altura izquierda: 2,5 m"),
        (Announcement::Paused(1.25), "En pausa en 1,25 s"),
        (Announcement::StateSet(0, 0.25), "Desplazamiento: 0,25 m; el ensayo parte de ahí"),
        (Announcement::ParameterSet(99, 2.5), ": "),
    ] {
        assert_eq!(announcement.text(play.basis(), play.time_line()), expected);
    }
}

#[test]
fn what_is_hidden_is_no_readout() {
    let source = "---\ntitle: A\n---\n\n```model\nhidden a = 2 [m]\nb = 3*a\nx' = -x/1 [s]\nx(0) = b\n```\n";
    let mut play = crate::support::open(source, &[]);
    let names: Vec<String> = play.readouts().into_iter().map(|readout| readout.name).collect();
    assert!(names.contains(&"b".to_owned()) && !names.contains(&"a".to_owned()), "{names:?}");
}

#[test]
fn parameters_stand_in_the_groups_of_the_document() {
    let text = "---\ntitle: Groups\n---\n```model\nparameter a = 1\nsize N = 3\ngroup \"Air\"\nswitch on_air = on\n\
                choice kind {\n\"A\": d = 1 [1/s]\n\"B\": d = 2 [1/s]\n}\ngroup \"Spring\"\nparameter k = 4 [1/s^2]\n\
                x'' = -k*x - (if on_air then d else N*d)*x'\nx(0) = a\nx'(0) = 0\n```\n";
    let translation =
        "---\ntitle: Grupos\nlanguage: es\n---\n```translations\n\"Air\" = \"Aire\"\n\"Spring\" = \"Muelle\"\n```\n";
    let mut play = open(text, &[translation]);
    play.set_language("es");
    let groups: Vec<(String, Vec<String>)> = (play.basis().parameter_groups(play.course()).into_iter())
        .map(|group| (group.name, group.parameters.into_iter().map(|parameter| parameter.name).collect()))
        .collect();
    let expected = [("", vec!["a"]), ("Aire", vec!["on_air", "kind"]), ("Muelle", vec!["k"])];
    let expected = expected.map(|(name, all)| (name.to_owned(), all.into_iter().map(str::to_owned).collect()));
    assert_eq!(groups, expected);
}

#[test]
fn the_table_shows_what_is_small_beside_the_greatest() {
    let text = "---\ntitle: Decay\nstep: 1 [s]\nuntil: 40 [s]\n---\n```model\nN' = -1 [1/s]*N\nN(0) = 1000\n```\n";
    let mut play = open(text, &[]);
    go_on(&mut play, [30.0]);
    let rows = play.values().table_rows(0..play.values().table_length());
    assert_eq!(rows[0][1], "1000.00");
    assert!(
        rows.len() > 20 && rows.iter().all(|row| row[1].contains(|digit: char| ('1'..='9').contains(&digit))),
        "{rows:?}"
    );
}

#[test]
fn what_cancels_is_shown_as_zero_and_what_is_small_is_not() {
    let mut play = open(
        "---\ntitle: Cancelling\nuntil: 10\n---\n\n```model\nindependent t in [s]\n\
         parameter L = 0.2 [m] in 0..1 \"Length\"\n\
         constant_zero = L*sin(pi) \"Cancels\"\n\
         moving_zero = (L + x) - x - L \"Cancels while it moves\"\n\
         small = 1e-12*L \"Small\"\n\
         x'' = -4 [1/s^2]*x\nx(0) = 0.1 [m] \"Place\"\nx'(0) = 0 [m/s]\n```\n",
        &[],
    );
    for _ in 0..3 {
        let shown = |label: &str, play: &mut play::Play| {
            let all = play.readouts();
            let one = all.iter().find(|readout| readout.label == label).unwrap();
            format!("{} {}", one.value, one.unit)
        };
        assert_eq!(shown("Cancels", &mut play), "0 m");
        let moving = shown("Cancels while it moves", &mut play);
        assert_eq!(moving.trim_matches(|c: char| !c.is_ascii_digit()).trim_matches(['0', '.']), "", "{moving}");
        assert_eq!(shown("Small", &mut play), "0.2 pm");
        go_on(&mut play, [0.37]);
    }
}
