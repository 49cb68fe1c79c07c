//! Comments that a teacher releases and marks.

use crate::share::Share;

/// Mark of a comment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// The comment is favourable: `+`.
    Positive,
    /// Neither: `0`.
    Neutral,
    /// The comment is unfavourable: `-`.
    Negative,
}

impl Mark {
    /// The mark that a key sets.
    pub fn of_key(key: &str) -> Option<Self> {
        match key {
            "+" => Some(Self::Positive),
            "0" => Some(Self::Neutral),
            "-" => Some(Self::Negative),
            _ => None,
        }
    }
}

/// A comment with the decisions of the teacher.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Comment {
    /// The text.
    pub text: String,
    /// Its mark.
    pub mark: Option<Mark>,
    /// True if the class can see it.
    pub released: bool,
}

/// Comments on one item, initially hidden and without marks.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct MarkedComments(Vec<Comment>);

impl MarkedComments {
    /// Hidden comments without marks.
    pub fn new(texts: impl IntoIterator<Item = String>) -> Self {
        Self(texts.into_iter().map(|text| Comment { text, mark: None, released: false }).collect())
    }

    /// Takes over marks and releases of equal texts from other comments.
    pub fn adopt(&mut self, others: &Self) {
        for comment in &mut self.0 {
            if let Some(other) = others.0.iter().find(|other| other.text == comment.text) {
                comment.clone_from(other);
            }
        }
    }

    /// The comments.
    pub fn all(&self) -> &[Comment] {
        &self.0
    }

    /// Sets or removes the mark of a comment.
    pub fn mark(&mut self, index: usize, mark: Option<Mark>) {
        if let Some(comment) = self.0.get_mut(index) {
            comment.mark = mark;
        }
    }

    /// Releases or hides a comment.
    pub fn release(&mut self, index: usize, released: bool) {
        if let Some(comment) = self.0.get_mut(index) {
            comment.released = released;
        }
    }

    /// Share of positive comments among those that are marked; `None` if none is.
    pub fn positive(&self) -> Option<Share> {
        let count = |wanted: fn(Mark) -> bool| self.0.iter().filter(|comment| comment.mark.is_some_and(wanted)).count();
        let marked = count(|_| true);
        (marked > 0).then(|| Share { count: count(|mark| mark == Mark::Positive), of: marked })
    }
}
