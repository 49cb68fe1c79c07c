//! The documents supplied with the laboratory, in typical use.

use crate::support::{bits, go_on, open, state};
use play::figure::Settings;
use play::program::{Child, Drag, Element};
use play::{Grade, Play, PlotId};

const UTUBE: &str = include_str!("../../../../simulations/utube.md");
const UTUBE_ES: &str = include_str!("../../../../simulations/utube.es.md");

fn utube() -> Play {
    crate::support::open(UTUBE, &[UTUBE_ES])
}

/// The first handle among the descendants of an element.
fn handle(element: &Element) -> Option<&Drag> {
    element.drag.as_ref().or_else(|| {
        element.children.iter().find_map(|child| match child {
            Child::Element(child) => handle(child),
            Child::Text(_) => None,
        })
    })
}

#[test]
fn every_document_runs_and_is_drawn() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../simulations");
    let mut documents = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if !name.ends_with(".md") || name.matches('.').count() > 1 {
            continue;
        }
        documents += 1;
        let opened = document::open(&std::fs::read_to_string(&path).unwrap(), &[]);
        let mut play =
            Play::open(opened.document.unwrap_or_else(|| panic!("{name}: {:?}", opened.diagnostics)).program);
        go_on(&mut play, [1.0; 5]);
        let expected = 5.0 * play.program().pace().per_second;
        let ended = play.time_line().problem(play.basis()).is_some_and(|problem| problem.code == "ended")
            && play.course().time() < expected;
        assert!(
            ended || (play.course().time() - expected).abs() < 1e-9,
            "{name}: {:?}",
            play.time_line().problem(play.basis())
        );
        assert!(play.scene().values().iter().all(|value| value.is_finite()), "{name}");
        for plot in 0..play.plots().list().len() {
            let figure = play.layout_plot(PlotId::at(plot), &Settings::default()).unwrap();
            assert!(figure.items().count() > 10, "{name}");
        }
        let mut other = Play::open(play.program().clone());
        other.restore(&play.share()).unwrap();
        assert_eq!(bits(&other), bits(&play), "{name}");
    }
    assert!(documents > 0);
}

#[test]
fn bounces_are_counted_in_whole_numbers() {
    let mut play = crate::support::open(include_str!("../../../../simulations/bouncing-ball.md"), &[]);
    go_on(&mut play, [1.0; 2]);
    // After sqrt(2 h/g) = 0.639 s, and again 2*0.8 times as long after that.
    assert_eq!(crate::support::readout(&mut play, "bounces"), "2");
    let bounces = play.values().states().into_iter().find(|state| state.name == "bounces").unwrap();
    assert_eq!((bounces.text.as_str(), bounces.spoken.as_str()), ("2", "2"));
}

#[test]
fn every_preset_can_be_chosen_and_shows_itself_as_chosen() {
    let mut play = utube();
    let presets: Vec<_> =
        play.controls().presets(play.basis(), play.course()).into_iter().flat_map(|group| group.presets).collect();
    assert!(presets.len() > 10);
    for preset in presets {
        play.change_settings(|settings| settings.restore_defaults());
        play.change_settings(|settings| settings.apply_preset(preset.index))
            .unwrap_or_else(|refusal| panic!("{}: {refusal:?}", preset.name));
        let selected = play.controls().presets(play.basis(), play.course()).into_iter().flat_map(|group| group.presets);
        let selected: Vec<_> = selected.filter(|preset| preset.selected).map(|preset| preset.index).collect();
        assert!(selected.contains(&preset.index), "{}", preset.name);
    }
}

#[test]
fn every_question_has_an_answer_that_is_taken_in_both_languages() {
    for language in ["en", "es"] {
        let mut play = utube();
        play.set_language(language);
        let questions = play.program().questions.len();
        assert!(questions >= 7);
        for question in 0..questions {
            let before = play.change_answers(|answers, run| answers.reveal(run, question));
            if play.answers().setup(play.basis(), play.course(), question).is_some() {
                play.apply_question_setup(question).unwrap();
            }
            assert_eq!(
                play.change_answers(|answers, run| answers.reveal(run, question)),
                before,
                "the answer supposes what the question sets"
            );
            assert_eq!(
                play.change_answers(|answers, run| answers.check(run, question, &before)).grade,
                Grade::Correct,
                "{question}: {before}"
            );
            play.change_settings(|settings| settings.restore_defaults());
        }
    }
}

#[test]
fn the_liquid_is_dragged_as_far_as_there_is_liquid() {
    let mut play = utube();
    let drag = handle(&play.program().scene("en").unwrap().root).unwrap().clone();
    play.change_settings(|settings| settings.drag_begin(&drag));
    play.change_settings(|settings| settings.drag_move(0.0, 53.0));
    assert!((state(&play)[0] - 1.5).abs() < 1e-9, "a metre is 53 units: {:?}", state(&play));
    play.change_settings(|settings| settings.drag_move(0.0, 500.0));
    // The columns are 3 m and 2 m high: at 2.5 m the right one is empty.
    assert!((state(&play)[0] - 2.5).abs() < 1e-6, "{:?}", state(&play));
    play.change_settings(|settings| settings.drag_move(0.0, -500.0));
    assert!((state(&play)[0] + 2.5).abs() < 1e-6, "{:?}", state(&play));
    play.change_settings(|settings| settings.drag_end());
    go_on(&mut play, [1.0]);
    assert!(state(&play)[0] > -2.5);
}

#[test]
fn everything_is_said_in_spanish() {
    let mut play = utube();
    play.set_language("es");
    let labels: Vec<String> =
        play.basis().parameters(play.course()).into_iter().map(|parameter| parameter.label).collect();
    let model = play.model().clone();
    for (parameter, label) in model.parameters.iter().zip(&labels) {
        assert_ne!(parameter.label.as_ref(), Some(label));
    }
    for (plot, view) in play.program().plots.clone().iter().zip(play.plots().list()) {
        assert_ne!(plot.title, view.title);
    }
    for readout in play.readouts() {
        let english = model.quantities.iter().find(|quantity| quantity.name == readout.name);
        if let Some(Some(label)) = english.map(|quantity| &quantity.label) {
            assert_ne!(label, &readout.label);
        }
    }
    let regime = play.readouts().into_iter().find(|readout| readout.name == "regime").unwrap();
    assert_eq!((regime.label.as_str(), regime.value.as_str()), ("Régimen", "subamortiguado"));
    assert!(regime.symbol.is_empty(), "an English word is no symbol");
}

#[test]
fn only_symbols_stand_beside_labels() {
    let source = "```model\nparameter k = 1\npower = k*2 \"Power\"\nRe = k*3 \"Reynolds number\"\n\
                  bare = k*4\nmode = if k > 0 then \"up\" else \"down\" \"Direction\"\nis_big = k > 1 \"Large\"\n\
                  sign_of = if k > 0 then \"+\" else \"-\"\n```\n";
    let shown: Vec<String> =
        open(source, &[]).readouts().into_iter().filter(|one| !one.symbol.is_empty()).map(|one| one.name).collect();
    assert_eq!(shown, ["t", "Re", "bare", "sign_of"]);
}
