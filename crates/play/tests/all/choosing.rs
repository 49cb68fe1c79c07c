//! Switches and choices: their controls, links, undo, and replacement of the document.

use crate::support::{open, parameter, readout, set};

const MODEL: &str = "switch drag = on \"Drag\"\nchoice place \"Place\" {\n\"Earth\": g = 9.81 [m/s^2]\n\"On a moon, far away\": g = 1.62 [m/s^2]\n}\n\
    parameter k = 0.5 [1/s]\nv' = g - (if drag then k*v else 0)\nv(0) = 0 [m/s]\n";

fn document(model: &str) -> String {
    format!("```model\n{model}```\n\n```presets\n\"Moon\": place = \"On a moon, far away\", drag = off\n```\n")
}

#[test]
fn controls_show_words() {
    let translation = "---\nlanguage: es\ntranslates: a.md\n---\n```translations\n\"Earth\" = \"Tierra\"\n\
        \"On a moon, far away\" = \"En una luna lejana\"\n\"Drag\" = \"Rozamiento\"\n\"Place\" = \"Lugar\"\n\"Moon\" = \"Luna\"\n```\n";
    let mut play = open(&document(MODEL), &[translation]);
    let texts = |play: &play::Play, name: &str| {
        let view = play.basis().parameter(play.course(), parameter(play, name)).unwrap();
        let choices: Vec<String> = view.choices.iter().map(|choice| choice.text.clone()).collect();
        (view.spoken, choices, view.is_switch, view.slider.is_some())
    };
    assert_eq!(
        texts(&play, "place"),
        ("Earth".into(), vec!["Earth".into(), "On a moon, far away".into()], false, false)
    );
    let (spoken, choices, is_switch, _) = texts(&play, "drag");
    assert_eq!((choices.len(), is_switch, &spoken), (2, true, &choices[1]));
    assert!(texts(&play, "k").1.is_empty());
    play.set_language("es");
    assert_eq!(texts(&play, "place").1, ["Tierra", "En una luna lejana"]);
}

#[test]
fn only_values_that_can_be_chosen_are_taken() {
    let mut play = open(&document(MODEL), &[]);
    for (name, value) in
        [("drag", 0.5), ("drag", 2.0), ("place", 2.0), ("place", 0.5), ("place", -1.0), ("place", f64::NAN)]
    {
        let index = parameter(&play, name);
        assert!(play.change_settings(|settings| settings.set_parameter(index, value)).is_err(), "{name} {value}");
    }
}

#[test]
fn a_link_has_the_words_and_brings_them_back() {
    let mut play = open(&document(MODEL), &[]);
    play.change_settings(|settings| settings.apply_preset(0)).unwrap();
    let link = play.share();
    assert!(link.contains("drag:off") && link.contains("place:On%20a%20moon%2C%20far%20away"), "{link}");
    let mut other = open(&document(MODEL), &[]);
    other.restore(&link).unwrap();
    assert_eq!(other.share(), link);
    assert_eq!(
        (readout(&mut other, "g"), other.course().parameters()),
        (readout(&mut play, "g"), play.course().parameters())
    );
    let wrong = link.replace("drag:off", "drag:2").replace("place:On", "place:In");
    assert!(open(&document(MODEL), &[]).restore(&wrong).is_err());
}

#[test]
fn a_text_stays_chosen_where_the_document_changes() {
    let mut play = open(&document(MODEL), &[]);
    set(&mut play, "place", 1.0);
    let changed = MODEL.replace("{\n\"Earth\"", "{\n\"Mars\": g = 3.7 [m/s^2]\n\"Earth\"");
    let opened = document::open(&document(&changed), &[]);
    play.replace_program(opened.document.unwrap().program);
    let view = play.basis().parameter(play.course(), parameter(&play, "place")).unwrap();
    assert_eq!((view.value, view.spoken.as_str()), (2.0, "On a moon, far away"));
}
