//! Texts of the survey in the dashboard, in every language.

use crate::app::App;
use view::table_of_words;

table_of_words! {
    title: "Survey";
    intro: "Drop the files with answers here, too: their names end in .survey. Each counts as one person, and nothing is shown before five have answered.";
    comments: "Comments";
    comments_keys: "Keys: arrows for the next and the previous comment, + 0 - to mark it.";
    previous: "Previous comment";
    next: "Next comment";
    positive_mark: "Positive";
    neutral_mark: "Neutral";
    negative_mark: "Negative";
    release: "Release this comment";
    released: "Released comments";
    positive: "Positive among the marked ones";
    save: "Save survey";
    clear: "Remove all answers";
}

/// Texts in the chosen language.
pub fn of(app: App) -> &'static Words {
    words_in(app.language.get_untracked())
}
