//! Conversion between answers and their stored form.

use crate::questions::given::{Answer, Attempt, Conditions};
use crate::questions::grade::Grade;
use handed::Number;
use handed::answer;

impl Answer {
    /// The answer to be stored.
    pub fn stored(&self) -> answer::Answer {
        let Self { typed, grade, shown, attempts } = self;
        let attempt = |Attempt { typed, grade, conditions }: &Attempt| answer::Attempt {
            typed: typed.clone(),
            grade: grade.code().into_owned(),
            language: conditions.as_ref().map(|own| own.language.clone()),
            values: conditions
                .iter()
                .flat_map(|own| &own.values)
                .map(|(name, value)| (name.clone(), Number(*value)))
                .collect(),
        };
        answer::Answer {
            typed: typed.clone(),
            grade: grade.map(|grade| grade.code().into_owned()),
            shown: *shown,
            revealed: shown.is_some(),
            found: false,
            attempts: attempts.iter().map(attempt).collect(),
        }
    }

    /// A stored answer. An attempt without a known grade is left out.
    pub fn of_stored(stored: &answer::Answer) -> Self {
        let attempt = |one: &answer::Attempt| {
            let values = || one.values.iter().map(|(name, Number(value))| (name.clone(), *value)).collect();
            let conditions = one.language.clone().map(|language| Conditions { language, values: values() });
            Some(Attempt { typed: one.typed.clone(), grade: Grade::from_code(&one.grade)?, conditions })
        };
        let attempts: Vec<Attempt> = stored.attempts.iter().filter_map(attempt).collect();
        Self {
            typed: stored.typed.clone(),
            grade: stored.grade.as_deref().and_then(Grade::from_code),
            shown: stored.shown.or_else(|| Self::shown_of_0_2(stored.revealed, stored.found, attempts.len())),
            attempts,
        }
    }
}
