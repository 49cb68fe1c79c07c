//! Answers to a survey: choosing, typing, the file, and where they must not be.

use crate::support::open;
use play::Play;

const DOCUMENT: &str = include_str!("../../../../tests/page/surveyed.md");
const SPANISH: &str = include_str!("../../../../tests/page/surveyed.es.md");

fn file(play: &Play) -> String {
    play.survey().file(play.basis())
}

fn given(play: &Play) -> Vec<(Option<usize>, String)> {
    play.survey().items(play.basis()).into_iter().map(|item| (item.chosen, item.typed)).collect()
}

#[test]
fn answers_are_chosen_changed_and_removed() {
    let mut play = open(DOCUMENT, &[]);
    assert!(play.survey().is_empty());
    let before = play.revision();
    play.change_survey(|survey, basis| survey.choose(basis, 1, Some(4)));
    assert_eq!(play.revision().survey, before.survey + 1);
    play.change_survey(|survey, basis| survey.choose(basis, 1, Some(4)));
    assert_eq!(play.revision().survey, before.survey + 1, "nothing has changed");
    // Items and answers that do not exist change nothing.
    for (item, answer) in [(1, 5), (0, 2), (3, 0), (4, 0)] {
        play.change_survey(|survey, basis| survey.choose(basis, item, Some(answer)));
    }
    play.change_survey(|survey, basis| survey.type_text(basis, 0, "x"));
    play.change_survey(|survey, basis| survey.type_text(basis, 9, "x"));
    assert_eq!(given(&play).iter().filter(|one| **one != (None, String::new())).count(), 1);
    play.change_survey(|survey, basis| survey.type_text(basis, 3, &" é".repeat(3000)));
    assert_eq!(given(&play)[3].1.chars().count(), 2000);
    play.change_survey(|survey, basis| survey.type_text(basis, 3, "  \n "));
    play.change_survey(|survey, basis| survey.choose(basis, 1, None));
    assert!(play.survey().is_empty());
}

#[test]
fn the_file_is_the_same_in_every_language_and_has_nothing_else() {
    let mut play = open(DOCUMENT, &[SPANISH]);
    let answer = |play: &mut Play| {
        play.change_survey(|survey, basis| survey.choose(basis, 0, Some(1)));
        play.change_survey(|survey, basis| survey.choose(basis, 1, Some(3)));
        play.change_survey(|survey, basis| survey.type_text(basis, 3, "a \"b\"\n\\ñ\u{1}"));
    };
    answer(&mut play);
    let english = file(&play);
    assert_eq!(
        english.lines().map(|line| line.find("\",\"kind").map_or(line, |end| &line[end..])).collect::<Vec<_>>(),
        [
            r#"{"meniscus survey":1,"document":"Pendulum","items":["#,
            r#"","kind":"role","asked":"You are a","words":["student","teacher"],"of":2,"chosen":2},"#,
            r#"","kind":"scale","asked":"It was clear","words":["disagree","agree"],"of":5,"chosen":4},"#,
            r#"","kind":"choice","asked":"What helped most?","words":["drawing","plots"],"of":2},"#,
            r#"","kind":"text","asked":"What would you change?","typed":"a \"b\"\n\\ñ\u0001"}"#,
            "]}",
        ]
    );
    play.set_language("es");
    assert_eq!(play.survey().items(play.basis())[1].text.asked, "Fue claro");
    assert_eq!(file(&play), english);
    let mut other = open(DOCUMENT, &[SPANISH]);
    other.set_language("es");
    answer(&mut other);
    assert_eq!(file(&other), english);
}

#[test]
fn a_link_has_no_answers() {
    let mut play = open(DOCUMENT, &[]);
    let link = play.share();
    play.change_survey(|survey, basis| survey.choose(basis, 1, Some(3)));
    play.change_survey(|survey, basis| survey.type_text(basis, 3, "secret"));
    assert_eq!(play.share(), link);
    assert!(play.answers().saved(play.basis()).is_empty());
}

#[test]
fn answers_stay_with_equal_items_while_the_document_is_written() {
    let mut play = open(DOCUMENT, &[]);
    play.change_survey(|survey, basis| survey.choose(basis, 0, Some(1)));
    play.change_survey(|survey, basis| survey.choose(basis, 1, Some(3)));
    play.change_survey(|survey, basis| survey.type_text(basis, 3, "x"));
    let changed =
        DOCUMENT.replace("role \"You are a\"", "text \"First\"\nrole \"You are a\"").replace("5 steps", "7 steps");
    let changed = changed.replace("text \"First\"", "scale \"First\": 3 steps from \"a\" to \"b\"");
    play.replace_program(open(&changed, &[]).program().clone());
    let none = (None, String::new());
    assert_eq!(given(&play), [none.clone(), (Some(1), String::new()), none.clone(), none, (None, "x".to_owned())]);
}
