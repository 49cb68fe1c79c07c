//! Editing of a document while it runs.

use crate::support::{UTUBE, UTUBE_ES, open, parameter, play, set, state, utube};
use desk::document::TEMPLATES;
use desk::{Desk, Writing, propose};
use proptest::prelude::*;
use units::Language;

/// A desk with editing started.
fn writing() -> Desk {
    let mut desk = utube();
    desk.set_writing(Writing::of_running(vec![UTUBE.to_owned(), UTUBE_ES.to_owned()]));
    desk
}

#[test]
fn every_template_is_without_faults_and_the_same_model_in_both_languages() {
    for template in TEMPLATES {
        let programs = [Language::English, catalogues::with(Language::Spanish)].map(|language| {
            let opened = desk::document::open(template.text(language), &[]);
            assert!(opened.diagnostics.is_empty(), "{} {language:?}: {:#?}", template.name, opened.diagnostics);
            let program = opened.document.unwrap().program;
            assert_eq!(program.language, language.tag(), "{}", template.name);
            assert_eq!(program.title, template.title(language));
            program
        });
        let [english, spanish] = &programs;
        assert!(english.model.moves_like(&spanish.model), "{}", template.name);
        assert_eq!(english.plots.len(), spanish.plots.len());
        assert_ne!(english.title, spanish.title);
        // It runs for a second without a problem.
        let mut desk = open(template.text(Language::English), &[]);
        play(&mut desk, [0.01; 100]);
        assert_eq!(desk.play().time_line().problem(desk.play().basis()), None, "{}", template.name);
    }
}

#[test]
fn another_default_replaces_the_program_and_the_time_stays() {
    let mut desk = writing();
    play(&mut desk, [0.05; 20]);
    let (time, before) = (desk.play().course().time(), state(&desk));
    let density = UTUBE.replace("parameter b   = 50 ", "parameter b   = 500");
    assert_ne!(density, UTUBE);
    assert!(desk.write(0, density.clone()));
    assert!(desk.writing().runs() && desk.writing().findings().is_empty());
    assert_eq!(desk.play().course().time(), time);
    assert_ne!(state(&desk), before);
    let damping = parameter(&desk, "b");
    assert_eq!(desk.play().basis().parameters(desk.play().course())[damping].value, 500.0);
    assert_eq!(desk.document().source, density);
    // The same text again changes nothing.
    let revision = desk.revision();
    assert!(!desk.write(0, density));
    assert_eq!(desk.revision(), revision);
}

#[test]
fn a_faulty_text_leaves_the_last_good_one_running_and_is_marked() {
    let mut desk = writing();
    play(&mut desk, [0.05; 20]);
    let before = state(&desk);
    let faulty = UTUBE.replace("2*rho*S*g*y = 0", "2*rho*S*gg*y = 0");
    assert_ne!(faulty, UTUBE);
    assert!(!desk.write(0, faulty.clone()));
    assert!(!desk.writing().runs());
    assert_eq!((desk.writing().errors(), state(&desk)), (1, before.clone()));
    assert_eq!(desk.document().source, UTUBE);
    let [mark] = &desk.writing().marks(0)[..] else { panic!("one mark") };
    let units: Vec<u16> = faulty.encode_utf16().collect();
    assert_eq!(String::from_utf16(&units[mark.from..mark.to]).unwrap(), "gg");
    assert!(!mark.remedies.is_empty());
    assert!(desk.writing().marks(1).is_empty());
    // After the correction it runs.
    assert!(desk.write(0, UTUBE.to_owned()));
    assert_eq!(state(&desk), before);
}

#[test]
fn marks_are_counted_as_browsers_do() {
    let text = "---\ntitle: 😀 Ωé\n---\n\n```model\ny' = 😀q\ny(0) = 1 [m]\n```\n";
    let mut desk = writing();
    assert!(!desk.write_all(vec![text.to_owned()]));
    let units: Vec<u16> = text.encode_utf16().collect();
    let marks = desk.writing().marks(0);
    let marked: Vec<String> =
        marks.iter().map(|mark| String::from_utf16(&units[mark.from..mark.to]).unwrap()).collect();
    assert!(marked.contains(&"😀".to_owned()), "{marked:?}");
}

#[test]
fn parameters_that_were_set_stay_by_name_also_where_others_come_before_them() {
    let mut desk = writing();
    set(&mut desk, "b", 400.0);
    let text = UTUBE.replace("parameter g ", "parameter extra = 1 [kg] in 0..2 \"Further\"\nparameter g ");
    let translation = UTUBE_ES.replace("```translations\n", "```translations\n\"Further\" = \"Otro\"\n");
    assert!(desk.write_all(vec![text, translation]), "{:#?}", desk.writing().findings());
    let damping = parameter(&desk, "b");
    assert_eq!(desk.play().basis().parameters(desk.play().course())[damping].value, 400.0);
    assert_eq!(parameter(&desk, "extra"), 0);
}

#[test]
fn another_plot_leaves_residuals_and_cycles_behind_those_of_the_document() {
    let mut desk = writing();
    let own = desk.document().program.plots.len();
    let text = UTUBE.replace("```plots\n", "```plots\n\"Further\": y against t\n");
    let translation = UTUBE_ES.replace("```translations\n", "```translations\n\"Further\" = \"Otra\"\n");
    assert!(desk.write_all(vec![text, translation]), "{:#?}", desk.writing().findings());
    assert_eq!(desk.document().program.plots.len(), own + 1);
    assert_eq!((desk.measured().residual_plot().place(), desk.cycles().plot().place()), (own + 1, own + 2));
    let plots = desk.play().plots().list();
    assert_eq!(plots.len(), own + 3);
    assert!(plots[own + 2].apart);
}

#[test]
fn a_text_that_came_with_an_error_can_be_written_on() {
    let faulty = UTUBE.replace("```plots\n", "```plots\n\"Nothing\": nought against t\n");
    let opened = desk::document::open(&faulty, &[]);
    let mut desk = Desk::open(opened.document.expect("only a plot is missing"));
    desk.set_writing(Writing::of_running(vec![faulty.clone()]));
    assert_eq!(desk.writing().errors(), 1);
    assert!(desk.write(0, faulty.replace("parameter b   = 50 ", "parameter b   = 60 ")));
    assert!(!desk.write(0, faulty.replace("parameter b   = 50 ", "parameter b   = 60 [")));
    assert!(desk.write(0, UTUBE.to_owned()));
    // The number of tolerated errors has decreased, so this error is now one too many.
    assert!(!desk.write(0, faulty));
}

#[test]
fn sizes_that_were_set_stay() {
    let text = "```model\nsize N = 3 in 2..9\nx[i]' = 1 [m/s] for i in 1..N\nx[i](0) = 0 [m] for i in 1..N\n```\n";
    let opened = desk::document::open(text, &[]);
    let mut desk = Desk::open(opened.document.unwrap());
    desk.set_writing(Writing::of_running(vec![text.to_owned()]));
    desk.resize(&[("N", 5)]).unwrap();
    assert!(desk.write(0, text.replace("1 [m/s]", "2 [m/s]")));
    assert_eq!(state(&desk).len(), 5);
    assert!(desk.write(0, text.replace("size N", "size M").replace("1..N", "1..M")));
    assert_eq!(state(&desk).len(), 3);
}

#[test]
fn proposals_count_places_as_browsers_do() {
    let desk = writing();
    let text = "\u{1f600}\n```model\nparameter k = 1\nz = k + om\n```\n";
    let place = text.find("om").unwrap() + 2 - "\u{1f600}".len() + 2;
    let found = propose(text, desk.play().program(), place);
    assert_eq!(found.from, place - 2);
    // Names of the running model are not suggested if this text does not define them.
    assert_eq!(found.suggestions, []);
    let found = propose(text, desk.play().program(), place - 2);
    assert_eq!(found.suggestions.iter().take(2).map(|one| one.text.as_str()).collect::<Vec<_>>(), ["k", "z"]);
}

#[test]
fn remedies_are_changes_as_browsers_count_them() {
    let text = "\u{1f600}\n```model\nparameter mass = 1\nz = 2*mas\n```\n";
    let mut desk = writing();
    desk.write_all(vec![text.to_owned()]);
    let (_, found) = &desk.writing().findings()[0];
    let changes = desk.writing().changes(0, &found.fixes[0]);
    let from = text.find("mas\n").unwrap() - "\u{1f600}".len() + 2;
    assert_eq!(changes, [desk::TextChange { from, to: from + 3, text: "mass".to_owned() }]);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    /// After any edits, restoring the text restores the document and the run.
    #[test]
    fn any_typing_can_be_taken_back(
        typing in prop::collection::vec((0.0..1.0_f64, 0_usize..40, "[ -~\\n]{0,12}|```\n|\\]|'|2[.]5|\u{1f600}"), 1..5),
    ) {
        let mut desk = writing();
        play(&mut desk, [0.05; 4]);
        let before = (state(&desk), desk.play().course().time());
        let mut letters: Vec<char> = UTUBE.chars().collect();
        for (place, removed, typed) in typing {
            let from = (place * letters.len() as f64) as usize;
            let to = (from + removed).min(letters.len());
            letters.splice(from..to, typed.chars());
            let text: String = letters.iter().collect();
            let runs = desk.write(0, text.clone());
            prop_assert!(!runs || desk.document().source == text);
            let length = text.encode_utf16().count();
            prop_assert!(desk.writing().marks(0).iter().all(|mark| mark.from <= mark.to && mark.to <= length));
            desk.follow();
        }
        desk.write_all(vec![UTUBE.to_owned(), UTUBE_ES.to_owned()]);
        prop_assert!(desk.writing().runs() && desk.writing().findings().is_empty());
        prop_assert_eq!(&desk.document().source, UTUBE);
        if desk.play().course().time() == before.1 {
            prop_assert_eq!(state(&desk), before.0);
        }
    }
}

#[test]
fn a_text_with_nothing_to_run_becomes_a_document_with_its_first_version_that_gives_one() {
    let faulty = UTUBE.replace("rho*S*L*y''", "rho*S*LL*y''");
    let opened = desk::document::open(&faulty, &[UTUBE_ES]);
    assert!(opened.document.is_none());
    let texts = vec![faulty.clone(), UTUBE_ES.to_owned()];
    let mut writing = desk::Writing::of_faulty(texts, opened.diagnostics);
    assert!(!writing.runs() && writing.errors() > 0 && !writing.marks(0).is_empty());
    // The unchanged text, and a text that is no better.
    assert!(writing.change(0, faulty.clone()).is_none());
    assert!(writing.change(0, faulty + "\n").is_none());
    assert!(writing.change(7, UTUBE.to_owned()).is_none());
    // An error outside the model is reported, and the document still runs.
    let beside = UTUBE.replace("\"Phase portrait\": y'", "\"Phase portrait\": w'");
    assert_ne!(beside, UTUBE);
    let document = writing.change(0, beside).expect("a document");
    assert!(writing.runs() && writing.errors() > 0);
    let mut desk = Desk::open(document);
    desk.set_writing(writing);
    // From here on the number of errors must not increase.
    assert!(!desk.write(0, UTUBE.replace("rho*S*L*y''", "rho*S*LL*y''")));
    assert!(desk.write(0, UTUBE.to_owned()));
    assert_eq!(desk.writing().errors(), 0);
}

#[test]
fn the_elements_of_the_drawing_are_found_while_the_text_runs() {
    let template = TEMPLATES.iter().find(|template| template.name == "oscillator").unwrap();
    let text = template.text(Language::English);
    let mut desk = open(text, &[]);
    desk.set_writing(Writing::of_running(vec![text.to_owned()]));
    // One centimetre is 5 units of the drawing; the spring ends 4 cm above the displacement.
    let end = |desk: &mut Desk| desk.drawing_places().unwrap().elements[2].as_ref().unwrap().grips[2].1[1];
    let at = |y: f64| 150.0 - 500.0 * (y + 0.04);
    assert!((end(&mut desk) - at(0.1)).abs() < 1e-9);
    play(&mut desk, [0.01; 30]);
    let y = desk.play().course().state()[0];
    assert!((end(&mut desk) - at(y)).abs() < 1e-9);
    // A text that does not run has no positions; a corrected one has its own.
    assert!(!desk.write(0, text.replace("m*y''", "m*(y''")));
    assert_eq!(desk.drawing_places(), None);
    assert!(desk.write(0, text.replace("y + 4 [cm])\" width", "y + 5 [cm])\" width")));
    assert!((end(&mut desk) - at(y + 0.01)).abs() < 1e-9);
}
