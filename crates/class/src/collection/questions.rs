//! Answers of a class, question by question.

use super::Collection;
use crate::grading::GivenAnswer;
use crate::share::Share;
use desk::play::Grade;
use std::borrow::Cow;
use std::collections::BTreeMap;
use units::order::sort_by_key;

/// Number of examples of an error that are kept.
const MOST_EXAMPLES: usize = 20;

/// Answers of all groups to a question.
#[derive(Clone, Debug, PartialEq)]
pub struct QuestionTally {
    /// Title of the document.
    pub document: String,
    /// Index of the question.
    pub question: usize,
    /// Text of the question.
    pub prompt: String,
    /// Groups whose first attempt is right, of those with an attempt.
    pub first: Share,
    /// Groups that gave a right answer before it was shown, of those with an attempt.
    pub found: Share,
    /// Number of groups to whom the right answer was shown before they gave it.
    pub revealed: usize,
    /// Number of groups that have not tried.
    pub without: usize,
    /// Kinds of errors in all attempts, the most frequent first.
    pub errors: Vec<ErrorKind>,
}

/// A kind of error.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorKind {
    /// The grade that these attempts got.
    pub grade: Grade,
    /// Number of groups that made it.
    pub groups: usize,
    /// Attempts with this error: typed text, right answer for its values, and number of groups; the most frequent first, at most
    /// 20.
    pub examples: Vec<(String, String, usize)>,
}

impl QuestionTally {
    /// True if an answer belongs to the question.
    pub fn is_of(&self, answer: &GivenAnswer) -> bool {
        let GivenAnswer { document, question, prompt, .. } = answer;
        (&self.document, self.question, &self.prompt) == (document, *question, prompt)
    }
}

impl Collection {
    /// The answers by document and question.
    pub fn questions(&self) -> Vec<QuestionTally> {
        let mut asked: BTreeMap<(&str, usize, &str), Vec<&GivenAnswer>> = BTreeMap::new();
        for answer in self.works().flat_map(|(_, work)| &work.answers) {
            asked.entry((&answer.document, answer.question, &answer.prompt)).or_default().push(answer);
        }
        asked.into_values().filter_map(|answers| tally(&answers)).collect()
    }
}

/// `None` without answers.
fn tally(answers: &[&GivenAnswer]) -> Option<QuestionTally> {
    let any = answers.first()?;
    let tried = || answers.iter().filter(|answer| !answer.attempts.is_empty());
    let of = tried().count();
    Some(QuestionTally {
        document: any.document.clone(),
        question: any.question,
        prompt: any.prompt.clone(),
        first: Share { count: tried().filter(|answer| answer.is_first_right()).count(), of },
        found: Share { count: tried().filter(|answer| answer.found).count(), of },
        revealed: answers.iter().filter(|answer| answer.shown.is_some() && !answer.found).count(),
        without: answers.len() - of,
        errors: errors(answers),
    })
}

/// Attempts with the same grade.
struct Found<'a> {
    grade: Grade,
    groups: usize,
    /// Number of groups by typed text and right answer.
    examples: BTreeMap<(&'a str, &'a str), usize>,
}

fn errors(answers: &[&GivenAnswer]) -> Vec<ErrorKind> {
    let mut kinds: BTreeMap<Cow<'static, str>, Found<'_>> = BTreeMap::new();
    for answer in answers {
        let mut seen: Vec<(Cow<'static, str>, &str)> = Vec::new();
        for attempt in answer.attempts.iter().filter(|attempt| attempt.grade() != Grade::Correct) {
            let code = attempt.grade().code();
            let new = || Found { grade: attempt.grade(), groups: 0, examples: BTreeMap::new() };
            let kind = kinds.entry(code.clone()).or_insert_with(new);
            kind.groups += usize::from(!seen.iter().any(|(own, _)| *own == code));
            if !seen.contains(&(code.clone(), attempt.typed.as_str())) {
                *kind.examples.entry((attempt.typed.as_str(), attempt.right.as_str())).or_default() += 1;
                seen.push((code, attempt.typed.as_str()));
            }
        }
    }
    let kind = |Found { grade, groups, examples }: Found<'_>| {
        let example = |((typed, right), count): ((&str, &str), usize)| (typed.to_owned(), right.to_owned(), count);
        let mut examples: Vec<(String, String, usize)> = examples.into_iter().map(example).collect();
        sort_by_key(&mut examples, |(_, _, count)| std::cmp::Reverse(*count));
        examples.truncate(MOST_EXAMPLES);
        ErrorKind { grade, groups, examples }
    };
    let mut kinds: Vec<ErrorKind> = kinds.into_values().map(kind).collect();
    sort_by_key(&mut kinds, |kind| std::cmp::Reverse(kind.groups));
    kinds
}
