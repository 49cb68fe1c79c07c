//! The survey of the document: the person's answers, which stay apart from all other work.

mod file;

use crate::{Basis, Changes, name_of};
use program::{Program, SurveyItem, SurveyKind, SurveyText};

/// Maximum length of a free text, in characters.
const LONGEST: usize = 2000;

/// The person's answers to the survey. They are part of no link, project or hand-in, and no storage has them.
#[derive(Debug, Default)]
pub struct Survey {
    /// One per item.
    given: Vec<Given>,
}

/// Answer to an item.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Given {
    /// Index of the alternative or step.
    chosen: Option<usize>,
    /// Free text.
    typed: String,
}

/// An item with its answer, in the chosen language.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SurveyView {
    /// Kind and number of answers.
    pub item: SurveyItem,
    /// Its texts.
    pub text: SurveyText,
    /// Index of the chosen alternative or step.
    pub chosen: Option<usize>,
    /// Free text.
    pub typed: String,
}

impl Survey {
    /// No answers.
    pub(crate) fn new(program: &Program) -> Self {
        Self { given: vec![Given::default(); program.survey.len()] }
    }

    /// All items with their answers.
    pub fn items(&self, basis: &Basis) -> Vec<SurveyView> {
        let language = basis.language().tag();
        let items = basis.program().survey.iter().zip(&self.given).enumerate();
        let view = |(index, (item, given)): (usize, (&SurveyItem, &Given))| SurveyView {
            item: *item,
            text: basis.program().survey_text(language, index).clone(),
            chosen: given.chosen,
            typed: given.typed.clone(),
        };
        items.map(view).collect()
    }

    /// True if nothing has been answered.
    pub fn is_empty(&self) -> bool {
        self.given.iter().all(|given| *given == Given::default())
    }

    /// Chooses an alternative or step by its index; `None` removes the answer.
    pub fn choose(&mut self, basis: &Basis, item: usize, answer: Option<usize>) -> Changes {
        let Some(asked) = basis.program().survey.get(item) else { return Changes::NONE };
        if answer.is_some_and(|answer| answer >= asked.answers) {
            return Changes::NONE;
        }
        match self.given.get_mut(item) {
            Some(given) => Changes::SURVEY.only_if(std::mem::replace(&mut given.chosen, answer) != answer),
            None => Changes::NONE,
        }
    }

    /// Sets the free text of an item; blanks alone are no answer.
    pub fn type_text(&mut self, basis: &Basis, item: usize, text: &str) -> Changes {
        let is_text = basis.program().survey.get(item).is_some_and(|asked| asked.kind == SurveyKind::Text);
        let Some(given) = self.given.get_mut(item).filter(|_| is_text) else { return Changes::NONE };
        given.typed = text.trim().chars().take(LONGEST).collect();
        Changes::SURVEY
    }

    /// Takes over the answers to items that are the same in another program.
    pub(crate) fn adopt(&mut self, basis: &Basis, (before, former): (&mut Self, &Basis)) {
        let own = names(basis.program());
        for (name, given) in names(former.program()).iter().zip(std::mem::take(&mut before.given)) {
            if let Some(place) = own.iter().position(|own| own == name).and_then(|place| self.given.get_mut(place)) {
                *place = given;
            }
        }
    }
}

/// Names of the items, derived from their kinds and their texts in the document's own language.
fn names(program: &Program) -> Vec<String> {
    let name = |(index, item): (usize, &SurveyItem)| {
        let text = program.survey_text(&program.language, index);
        let answers = item.answers.to_string();
        let mut parts = vec![item.kind.word(), answers.as_str(), text.asked.as_str()];
        parts.extend(text.words.iter().map(String::as_str));
        name_of(&parts)
    };
    program.survey.iter().enumerate().map(name).collect()
}
