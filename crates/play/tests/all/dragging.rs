//! Dragging parts of the scene.

use crate::support::{bits, go_on, parameter, set, state, utube};
use play::{Announcement, Play};

/// The handle of the test document's scene.
fn handle(play: &Play) -> play::program::Drag {
    let scene = play.program().scene("en").unwrap();
    let mut drags = scene.root.children.iter().filter_map(|child| match child {
        play::program::Child::Element(element) => element.drag.clone(),
        play::program::Child::Text(_) => None,
    });
    drags.next().expect("the scene has a handle")
}

#[test]
fn the_liquid_follows_the_pointer_and_is_let_go() {
    let mut play = utube();
    let drag = handle(&play);
    play.change_run(|line, _| line.play());
    play.change_run(|line, _| line.tick(1.0));
    let held = state(&play)[0];
    play.change_settings(|settings| settings.drag_begin(&drag));
    assert!(!play.time_line().is_playing() && play.controls().is_dragging());
    play.change_settings(|settings| settings.drag_move(500.0, 10.0));
    assert_eq!(play.course().time(), 0.0);
    assert!((state(&play)[0] - (held + 0.25)).abs() < 1e-12);
    assert_eq!(state(&play)[1], 0.0, "what is held is at rest");
    play.change_settings(|settings| settings.drag_move(0.0, -4.0));
    assert!((state(&play)[0] - (held - 0.1)).abs() < 1e-12);
    // Limited to the height of the scene.
    play.change_settings(|settings| settings.drag_move(0.0, 1e9));
    assert!((state(&play)[0] - (held + 300.0 * 0.025)).abs() < 1e-9);
    play.change_settings(|settings| settings.drag_move(f64::NAN, 1.0));
    play.change_settings(|settings| settings.drag_move(0.0, 8.0));
    play.change_settings(|settings| settings.drag_end());
    assert!(play.time_line().is_playing() && !play.controls().is_dragging());
    let from = state(&play);
    play.change_run(|line, _| line.tick(0.5));
    assert!(state(&play)[0] < from[0]);
    assert!(play.time_line().has_ghost());
    play.change_settings(|settings| settings.drag_move(0.0, 5.0));
    play.change_settings(|settings| settings.drag_end());
}

#[test]
fn the_liquid_goes_no_further_than_the_drawing() {
    let source = crate::support::UTUBE.replace("{100 - 40*y/(1 [m])}", "{100 - 40*min(y, 2 [m])/(1 [m])}");
    let mut play = crate::support::open(&source, &[]);
    let drag = handle(&play);
    play.change_settings(|settings| settings.drag_begin(&drag));
    play.change_settings(|settings| settings.drag_move(0.0, 250.0));
    assert!((state(&play)[0] - 2.0).abs() < 1e-9, "{:?}", state(&play));
    play.change_settings(|settings| settings.drag_move(0.0, 20.0));
    assert!((state(&play)[0] - 1.0).abs() < 1e-12);
    play.change_settings(|settings| settings.drag_move(0.0, -200.0));
    assert!((state(&play)[0] + 4.5).abs() < 1e-12, "downwards nothing limits it");
    play.change_settings(|settings| settings.drag_end());
    let told = std::iter::from_fn(|| play.take_announcement()).last();
    assert_eq!(told, Some(Announcement::StateSet(0, -4.5)));
}

/// `y(0) = (h_l - h_r)/2` with room in the ranges: one height rises by as much as the other falls.
#[test]
fn a_drag_at_the_start_sets_the_parameters_that_decide_it() {
    let source = crate::support::UTUBE.replace("in 2..9", "in 0..9");
    let mut play = crate::support::open(&source, &[]);
    let drag = handle(&play);
    let heights = |play: &Play| ["h_l", "h_r"].map(|name| play.course().parameters()[parameter(play, name)]);
    // One scene unit is 0.025 m.
    for (up, y, h_l, h_r) in
        [(12.0, 0.8, 3.3, 1.7), (-12.0, 0.5, 3.0, 2.0), (-20.0, 0.0, 2.5, 2.5), (-24.0, -0.6, 1.9, 3.1)]
    {
        play.change_settings(|settings| settings.drag_begin(&drag));
        play.change_settings(|settings| settings.drag_move(0.0, 3.0));
        play.change_settings(|settings| settings.drag_move(0.0, up));
        play.change_settings(|settings| settings.drag_end());
        let near = |value: f64, expected: f64| (value - expected).abs() < 1e-12;
        let [left, right] = heights(&play);
        assert!(near(state(&play)[0], y) && near(left, h_l) && near(right, h_r), "{up}: {left} {right}");
        assert!(!play.course().is_started_by_hand());
    }
    let told = std::iter::from_fn(|| play.take_announcement()).last().unwrap();
    let text = told.text(play.basis(), play.time_line());
    assert_eq!(text, "Displacement: -0.6 m; Left height: 1.9 m, Right height: 3.1 m".replace('-', "−"));
    // After playing and going back, the run starts there again. The document's values return on request.
    go_on(&mut play, [1.0]);
    play.change_run(|line, basis| line.back_to_start(basis));
    assert!((state(&play)[0] + 0.6).abs() < 1e-12);
    play.change_settings(|settings| settings.restore_defaults());
    assert_eq!((state(&play), heights(&play)), (vec![0.5, 0.0], [3.0, 2.0]));
}

#[test]
fn a_drag_at_the_start_leaves_the_other_initial_values() {
    let mut play = utube();
    set(&mut play, "v_0", 2.0);
    let drag = handle(&play);
    play.change_settings(|settings| settings.drag_begin(&drag));
    play.change_settings(|settings| settings.drag_move(0.0, -12.0));
    assert!((state(&play)[0] - 0.2).abs() < 1e-12);
    play.change_settings(|settings| settings.drag_end());
    assert_eq!(state(&play)[1], 2.0);
    // At any later moment the drag sets a start by hand, with the dragged variable at rest.
    go_on(&mut play, [0.5]);
    play.change_settings(|settings| settings.drag_begin(&drag));
    play.change_settings(|settings| settings.drag_move(0.0, -12.0));
    play.change_settings(|settings| settings.drag_end());
    assert_eq!(state(&play)[1], 0.0);
    assert!(play.course().is_started_by_hand());
}

/// If a range ends or no parameter determines the value, the state itself becomes the start: it is played from,
/// restored by going back, shared, and discarded with an announcement.
#[test]
fn what_no_parameter_can_follow_is_kept_as_the_start() {
    let literal = crate::support::UTUBE.replace("y(0)  = (h_l - h_r)/2 ", "y(0)  = 0.5 [m] ");
    for source in [crate::support::UTUBE, &literal] {
        let mut play = crate::support::open(source, &[]);
        let drag = handle(&play);
        let parameters = play.course().parameters().to_vec();
        play.change_settings(|settings| settings.drag_begin(&drag));
        play.change_settings(|settings| settings.drag_move(0.0, 12.0));
        play.change_settings(|settings| settings.drag_end());
        assert!(play.course().is_started_by_hand(), "the right height is at the end of its range");
        assert_eq!(play.course().parameters(), parameters);
        assert!((state(&play)[0] - 0.8).abs() < 1e-12);
        go_on(&mut play, [1.0]);
        play.change_run(|line, basis| line.back_to_start(basis));
        assert!(play.course().is_started_by_hand() && (state(&play)[0] - 0.8).abs() < 1e-12);
        let told = std::iter::from_fn(|| play.take_announcement()).last().unwrap();
        assert_eq!(told.text(play.basis(), play.time_line()), "Back at the start that was set by hand");
        let mut other = crate::support::open(source, &[]);
        other.restore(&play.share()).unwrap();
        assert_eq!(state(&other), state(&play));
        play.change_settings(|settings| settings.restore_defaults());
        assert!(!play.course().is_started_by_hand());
        assert_eq!(state(&play), [0.5, 0.0]);
        let told = std::iter::from_fn(|| play.take_announcement()).last();
        assert_eq!(told, Some(Announcement::DefaultsRestored));
    }
    // A parameter that determines the start discards it, too, and announces this even at time 0.
    let mut play = utube();
    play.change_settings(|settings| settings.set_state(0, 0.7)).unwrap();
    set(&mut play, "h_l", 4.0);
    let told: Vec<_> = std::iter::from_fn(|| play.take_announcement()).collect();
    assert!(told.contains(&Announcement::Restarted(parameter(&play, "h_l"))), "{told:?}");
}

/// A start that is a nonlinear function of its parameters, one of which has no range.
#[test]
fn a_curved_start_is_met_exactly() {
    let source = "---\ntitle: Ball\n---\n```model\nparameter v = 3 [m/s] in 0..20\nparameter c = 2 [s^2/m]\n\
                  y' = -y/(1 [s])\ny(0) = c*v^2 in [m]\n```\n```scene\n<svg viewBox=\"0 0 100 100\">\
                  <circle cx=\"5\" cy=\"{y/(1 [m])}\" r=\"5\" drag=\"y\" drag-up=\"1 [m]\"/></svg>\n```\n";
    let mut play = crate::support::open(source, &[]);
    let drag = handle(&play);
    for up in [1.0, 7.0, -15.0, 40.0, -0.001] {
        let before = state(&play)[0];
        play.change_settings(|settings| settings.drag_begin(&drag));
        play.change_settings(|settings| settings.drag_move(0.0, up));
        play.change_settings(|settings| settings.drag_end());
        assert!(!play.course().is_started_by_hand(), "{up}");
        assert!((state(&play)[0] - (before + up)).abs() < 1e-7 * (before + up).abs(), "{up}: {:?}", state(&play));
        let [v, c] = play.course().parameters() else { panic!() };
        assert!((0.0..=20.0).contains(v) && c.is_finite());
    }
}

#[test]
fn a_click_on_the_liquid_changes_nothing() {
    let mut play = utube();
    let drag = handle(&play);
    go_on(&mut play, [1.0]);
    let before = bits(&play);
    play.change_settings(|settings| settings.drag_begin(&drag));
    play.change_settings(|settings| settings.drag_end());
    assert_eq!(bits(&play), before);
    assert!(!play.time_line().is_playing());
    play.change_settings(|settings| {
        settings.drag_begin(&play::program::Drag {
            target: play::program::Dragged::State(9),
            up: None,
            right: Some(77),
            zero: Some(78),
        })
    });
    play.change_settings(|settings| settings.drag_move(1.0, 1.0));
    play.change_settings(|settings| settings.drag_end());
    assert_eq!(bits(&play), before);
}

#[test]
fn a_parameter_is_dragged_within_its_range_while_the_run_goes_on() {
    let source = "```model\nparameter s = 1 [m] in 0..2\nx' = (s - x)/(1 [s])\nx(0) = 0 [m]\n```\n\n```scene\n<svg \
                  viewBox='0 0 100 100'><circle cx='{10*s/(1 [m])}' cy='9' r='3' drag='s' drag-right='0.1 [m]'/></svg>\n```\n";
    let mut play = crate::support::open(source, &[]);
    let drag = handle(&play);
    assert_eq!(play.grips().range(&drag), Some((0.0, 2.0)));
    play.change_run(|line, _| line.play());
    play.change_settings(|settings| settings.drag_begin(&drag));
    play.change_settings(|settings| settings.drag_move(5.0, 7.0));
    assert!(play.time_line().is_playing() && play.controls().is_dragging());
    assert_eq!(play.basis().parameters(play.course())[0].value, 1.5);
    play.change_run(|line, _| line.tick(0.5));
    assert!(state(&play)[0] > 0.5, "it follows the new value: {:?}", state(&play));
    play.change_settings(|settings| settings.drag_move(1e9, 0.0));
    assert_eq!(play.basis().parameters(play.course())[0].value, 2.0);
    play.change_settings(|settings| settings.drag_move(f64::INFINITY, 0.0));
    play.change_settings(|settings| settings.drag_end());
    assert_eq!(play.basis().parameters(play.course())[0].value, 2.0);
    assert!(play.time_line().is_playing());
    let told = std::iter::from_fn(|| play.take_announcement()).last();
    assert_eq!(told, Some(Announcement::ParameterSet(0, 2.0)));
}

#[test]
fn a_scene_is_a_scale_of_what_moves_up_and_down_in_it() {
    assert_eq!(utube().grips().level(), None);
    let source = crate::support::UTUBE.replace("drag-up=\"0.025 [m]\"", "drag-up=\"0.025 [m]\" drag-zero=\"100\"");
    let mut play = crate::support::open(&source.replace("y, y' against t", "y against t"), &[]);
    let level = play.grips().level().expect("the scene has a scale");
    let y = state(&play)[0];
    assert_eq!((level.handle, level.zero), (0, 100.0));
    assert!((level.present - (100.0 - 40.0 * y)).abs() < 1e-9, "{level:?}");
    let ids: Vec<_> = play.plots().list().iter().map(|plot| plot.id).collect();
    let levels: Vec<_> = ids.into_iter().map(|id| play.grips().level_of(id).map(|level| level.unit)).collect();
    // The plot that begins with y against t.
    assert_eq!(levels.iter().flatten().count(), 1, "{levels:?}");
    let unit = levels[0].expect("the first plot");
    assert!((unit - 40.0).abs() < 1e-9, "40 units of the drawing are a metre: {unit}");
    // The scale of the scene is that of the figure, as long as the swing fits.
    let level = Some(play::figure::Level { zero: 200.0, unit });
    let settings = play::figure::Settings { width: 400.0, height: 400.0, level, ..play::figure::Settings::default() };
    let figure = play.layout_plot(play::PlotId::at(0), &settings).expect("the plot");
    assert!((figure.y_scales()[0].pixel(0.0) - 200.0).abs() < 1e-9);
    assert!((f64::from(figure.level_point().expect("the present moment").y) - (200.0 - 40.0 * y)).abs() < 1e-3);

    // Records drawn alone up to a time: the pen is at the last of their points, and no line is drawn.
    let lines = |figure: &play::figure::Figure| {
        figure.items().filter(|item| matches!(item, play::figure::Item::Polyline(..))).count()
    };
    assert!(play.change_run(|line, _| line.compute_on(2.0)) || play.course().front() >= 2.0);
    play.change_plots(|plots, _| {
        let points =
            play::Points { x: vec![0.0, 1.0, 2.0], y: vec![0.1, -0.1, 0.05], version: 1, ..Default::default() };
        plots.set_points(0, vec![points])
    });
    let whole = play.layout_plot(play::PlotId::at(0), &settings).map(lines);
    assert!(whole > Some(0), "{whole:?}");
    for (until, last) in [(1.5, Some(-0.1)), (2.0, Some(0.05)), (f64::NEG_INFINITY, None)] {
        play.change_plots(|plots, _| plots.draw_records_until(Some(until)));
        let figure = play.layout_plot(play::PlotId::at(0), &settings).expect("the plot");
        let pen = figure.level_point().map(|point| (200.0 - f64::from(point.y)) / 40.0);
        assert_eq!(pen.map(|pen| (100.0 * pen).round() / 100.0), last);
        assert_eq!(lines(figure), 0);
    }
    play.change_plots(|plots, _| plots.draw_records_until(None));
    assert_eq!(play.layout_plot(play::PlotId::at(0), &settings).map(lines), whole);
}
