//! Tallies, intervals, words and comments of a survey, against values computed by hand.

use class::survey::{LEAST, Mark, MarkedComments, Word, frequent_words, results};
use proptest::prelude::*;
use saved::survey::{ItemKind, Sheet};
use units::Language;

fn sheet(role: usize, step: usize, comment: &str) -> Sheet {
    let comment = serde_json::to_string(comment).unwrap();
    Sheet::read(&format!(
        r#"{{"meniscus survey":1,"document":"U-tube","items":[
        {{"name":"r","kind":"role","asked":"You are a","words":["student","teacher"],"of":2,"chosen":{role}}},
        {{"name":"c","kind":"scale","asked":"Clear","words":["no","yes"],"of":3,"chosen":{step}}},
        {{"name":"t","kind":"text","asked":"Why?","typed":{comment}}}]}}"#
    ))
    .unwrap()
}

fn listed(words: &[Word]) -> Vec<(&str, usize)> {
    words.iter().map(|word| (word.text.as_str(), word.persons)).collect()
}

fn frequent(comments: &[&str]) -> Vec<(String, usize)> {
    let comments: Vec<String> = comments.iter().map(|&comment| comment.to_owned()).collect();
    frequent_words(&comments).into_iter().map(|word| (word.text, word.persons)).collect()
}

#[test]
fn answers_are_counted_in_no_order() {
    let mut sheets = vec![
        sheet(1, 3, "b"),
        sheet(1, 3, "a"),
        sheet(2, 1, "c"),
        sheet(1, 2, " "),
        sheet(1, 3, "d"),
        sheet(1, 3, "e"),
    ];
    let found = results(&sheets);
    let [survey] = found.as_slice() else { panic!("{found:?}") };
    assert_eq!((survey.document.as_str(), survey.sheets, survey.held_back), ("U-tube", 6, 0));
    let kinds: Vec<ItemKind> = survey.tallies.iter().map(|tally| tally.item.kind).collect();
    assert_eq!(kinds, [ItemKind::Role, ItemKind::Scale, ItemKind::Text]);
    let counts =
        |index: usize| survey.tallies[index].shares.iter().map(|share| (share.count, share.of)).collect::<Vec<_>>();
    assert_eq!((counts(0), counts(1)), (vec![(5, 6), (1, 6)], vec![(1, 6), (1, 6), (4, 6)]));
    assert_eq!((survey.tallies[2].count, survey.tallies[2].comments.join("")), (5, "abcde".to_owned()));
    sheets.reverse();
    assert_eq!(results(&sheets), found);
}

#[test]
fn fewer_than_five_answers_are_shown_as_nothing() {
    let mut sheets = vec![sheet(1, 3, "a secret"); LEAST - 1];
    let held = results(&sheets);
    assert_eq!((held[0].tallies.len(), held[0].held_back, held[0].sheets), (0, 3, 4));
    assert!(!format!("{held:?}").contains("secret"));
    // The fifth person leaves the comment out.
    sheets.push(sheet(1, 3, ""));
    let shown = results(&sheets);
    assert_eq!((shown[0].tallies.len(), shown[0].held_back), (2, 1));
    assert!(!format!("{shown:?}").contains("secret"));
    // An item with other texts is another one, whatever its name.
    sheets[4].items[0].0.asked = "Something else".to_owned();
    assert_eq!(results(&sheets)[0].held_back, 3);
}

#[test]
fn words_count_persons_and_keep_accents_and_negations() {
    assert_eq!(
        frequent(&[
            "Fricción, fricción, fricción",
            "La fricción era clara",
            "La simulación no era clara",
            "¡Clara! No."
        ]),
        [("clara", 2), ("fricción", 2)].map(|(word, persons)| (word.to_owned(), persons))
    );
    assert_eq!(
        frequent(&["No me gusta", "no gusta nada", "Me gusta mucho", "gusta"]),
        [("gusta", 2), ("no gusta", 2)].map(|(word, persons)| (word.to_owned(), persons))
    );
    // In Portuguese "no" is no negation.
    assert_eq!(
        frequent(&["O líquido no tubo é bonito", "Vi os líquidos no tubo", "Não vi o tubo", "Eu não vi o tubo"]),
        [("tubo", 4), ("líquido", 2), ("não vi", 2)].map(|(word, persons)| (word.to_owned(), persons))
    );
    assert_eq!(
        frequent(&["It doesn’t work", "It did not work", "It works", "working! NOT: clear", "clear"]),
        [("clear", 2), ("not work", 2), ("working", 2)].map(|(word, persons)| (word.to_owned(), persons))
    );
}

#[test]
fn forms_are_joined_under_the_commonest() {
    assert_eq!(
        frequent(&["las gráficas", "la grafica", "las gráficas", "the plot", "my plots", "the plots", "wave"]),
        [("gráficas", 3), ("plots", 3)].map(|(word, persons)| (word.to_owned(), persons))
    );
    // One person alone, and stop words of both languages.
    assert_eq!(frequent(&["waves waves waves", "the de la and", "the de la and"]), []);
}

#[test]
fn comments_are_released_and_marked_one_by_one() {
    let mut comments = MarkedComments::new((0..11).map(|number| number.to_string()));
    assert_eq!(comments.positive(), None);
    assert!(comments.all().iter().all(|comment| !comment.released));
    for index in 0..10 {
        comments.mark(index, Mark::of_key(if index < 9 { "+" } else { "-" }));
    }
    let share = comments.positive().unwrap();
    assert_eq!(share.text(Language::English), "90 % (60 to 98 %, n = 10)");
    comments.mark(0, Mark::of_key("0"));
    comments.mark(1, Mark::of_key("x"));
    comments.mark(99, Some(Mark::Positive));
    assert_eq!(comments.positive().map(|share| (share.count, share.of)), Some((7, 9)));
    comments.release(3, true);
    assert_eq!(comments.all().iter().filter(|comment| comment.released).count(), 1);
}

proptest! {
    /// Stemming must not fail, whatever persons write.
    #[test]
    fn any_text_has_words(text in "\\PC{0,60}", spanish in "[a-záéíóúüñ' ]{0,60}") {
        let words = frequent_words(&[text.clone(), text, spanish.clone(), spanish]);
        prop_assert!(listed(&words).iter().all(|(word, persons)| !word.is_empty() && (2..=4).contains(persons)));
    }
}

/// The page writes the file, and `saved` reads it; no other work has the answers.
#[test]
fn what_a_page_writes_is_read_and_stands_nowhere_else() {
    let document = include_str!("../../../../tests/page/surveyed.md");
    let opened = document::open(document, &[]).document.unwrap();
    let mut desk = desk::Desk::open(opened);
    desk.play_mut().change_survey(|survey, basis| survey.choose(basis, 0, Some(1)));
    desk.play_mut().change_survey(|survey, basis| survey.choose(basis, 1, Some(0)));
    desk.play_mut()
        .change_survey(|survey, basis| survey.type_text(basis, 3, "a secret\n\"quoted\" \\ \u{7} ñ\u{2028}🎉"));
    let play = desk.play();
    let sheet = Sheet::read(&play.survey().file(play.basis())).unwrap();
    let answers: Vec<_> = sheet.items.iter().map(|(_, answer)| answer.clone()).collect();
    use saved::survey::SurveyAnswer::{Chosen, Typed};
    let typed = Typed("a secret\n\"quoted\" \\  ñ\u{2028}🎉".to_owned());
    assert_eq!(answers, [Some(Chosen(1)), Some(Chosen(0)), None, Some(typed)]);
    let kept =
        [play.share(), format!("{:?}", desk::project_items(&desk, 0)), format!("{:?}", desk::facts(&desk))].concat();
    assert!(!kept.contains("secret"), "{kept}");
}
