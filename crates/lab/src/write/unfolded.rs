//! What is unfolded below the tools of *Write*.

use view::views::*;

/// What is unfolded below the tools: one at a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unfolded {
    /// What a document can begin from.
    New,
    /// The versions to go back to.
    Versions,
}

impl Unfolded {
    /// The id of the button that unfolds it.
    pub fn id(self) -> &'static str {
        match self {
            Self::New => "new-document",
            Self::Versions => "versions",
        }
    }

    /// The button that unfolds it and folds it up again.
    pub fn button(self, unfolded: Signal<Option<Self>>, controls: &'static str, title: &'static str) -> HtmlButton {
        button()
            .class("quiet outlined")
            .id(self.id())
            .attr("aria-controls", controls)
            .attr("aria-expanded", move || (unfolded.get() == Some(self)).to_string())
            .when(events::click, move |_| unfolded.update(|now| *now = (*now != Some(self)).then_some(self)))
            .child(title)
    }
}
