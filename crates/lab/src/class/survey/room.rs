//! State of the survey in the dashboard: the answers, and the comments with the decisions of the teacher.

use class::survey::{Mark, MarkedComments, Results, results};
use desk::saved::survey::{Sheet, SheetError};
use view::views::*;

/// The answers to surveys in the page; cheap to copy.
#[derive(Clone, Copy)]
pub struct SurveyRoom {
    sheets: Signal<Vec<Sheet>>,
    results: Signal<Vec<Results>>,
    comments: Signal<Vec<Comments>>,
    /// Files that could not be read, with the reasons.
    refused: Signal<Vec<(String, SheetError)>>,
}

/// Comments on one item.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Comments {
    /// Indices of the document and of the item in the results.
    pub item: (usize, usize),
    /// Index of the comment that is shown.
    pub shown: usize,
    /// The comments.
    pub marked: MarkedComments,
}

impl SurveyRoom {
    /// No answers.
    pub fn new() -> Self {
        Self {
            sheets: create_signal(Vec::new()),
            results: create_signal(Vec::new()),
            comments: create_signal(Vec::new()),
            refused: create_signal(Vec::new()),
        }
    }

    /// Adds files. The marks of equal comments stay.
    pub fn add(self, files: Vec<(String, Result<Sheet, SheetError>)>) {
        for (name, sheet) in files {
            match sheet {
                Ok(sheet) => self.sheets.update_silent(|sheets| sheets.push(sheet)),
                Err(error) => self.refused.update_silent(|refused| refused.push((name, error))),
            }
        }
        let found = self.sheets.with_untracked(|sheets| results(sheets));
        let mut comments = Vec::new();
        for (document, survey) in found.iter().enumerate() {
            for (item, tally) in survey.tallies.iter().enumerate().filter(|(_, tally)| !tally.comments.is_empty()) {
                let mut marked = MarkedComments::new(tally.comments.iter().cloned());
                self.comments.with_untracked(|before| before.iter().for_each(|one| marked.adopt(&one.marked)));
                comments.push(Comments { item: (document, item), shown: 0, marked });
            }
        }
        self.comments.set_silent(comments);
        self.results.set(found);
    }

    /// Removes all answers.
    pub fn clear(self) {
        self.sheets.set_silent(Vec::new());
        self.refused.set_silent(Vec::new());
        self.add(Vec::new());
    }

    /// True if there are files.
    pub fn has_files(self) -> bool {
        self.results.track();
        self.sheets.with_untracked(|sheets| !sheets.is_empty())
            || self.refused.with_untracked(|refused| !refused.is_empty())
    }

    /// Reads the results; a view that does is rebuilt when they change.
    pub fn results<T>(self, read: impl FnOnce(&[Results]) -> T) -> T {
        self.results.with(|results| read(results))
    }

    /// Files that could not be read, with the reasons.
    pub fn refused(self) -> Vec<(String, SheetError)> {
        self.refused.get_clone_untracked()
    }

    /// The results with released comments only, for a page.
    pub fn released(self) -> Vec<Results> {
        let mut results = self.results.get_clone_untracked();
        self.comments.with_untracked(|all| {
            for Comments { item: (document, item), marked, .. } in all {
                if let Some(tally) = results.get_mut(*document).and_then(|survey| survey.tallies.get_mut(*item)) {
                    let released = marked.all().iter().filter(|comment| comment.released);
                    tally.comments = released.map(|comment| comment.text.clone()).collect();
                }
            }
        });
        results
    }

    /// Comments on an item; a view that reads them is rebuilt when they change.
    pub fn comments(self, item: (usize, usize)) -> Comments {
        self.comments.with(|all| all.iter().find(|one| one.item == item).cloned().unwrap_or_default())
    }

    fn change(self, item: (usize, usize), change: impl FnOnce(&mut Comments)) {
        self.comments.update(|all| {
            if let Some(comments) = all.iter_mut().find(|one| one.item == item) {
                change(comments);
            }
        });
    }

    /// Shows the comment that is `by` places further, as far as there is one.
    pub fn turn(self, item: (usize, usize), by: isize) {
        self.change(item, |comments| {
            let last = comments.marked.all().len().saturating_sub(1);
            comments.shown = comments.shown.saturating_add_signed(by).min(last);
        });
    }

    /// Marks the comment that is shown.
    pub fn mark(self, item: (usize, usize), mark: Mark) {
        self.change(item, |comments| comments.marked.mark(comments.shown, Some(mark)));
    }

    /// Releases or hides the comment that is shown.
    pub fn release(self, item: (usize, usize), released: bool) {
        self.change(item, |comments| comments.marked.release(comments.shown, released));
    }
}
