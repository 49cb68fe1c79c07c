//! Section that is open below the tools of *Write*.

use view::views::*;

/// The open section below the tools; at most one at a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unfolded {
    /// Templates for a new document.
    New,
    /// Versions to go back to.
    Versions,
}

impl Unfolded {
    /// Id of the button that opens it.
    pub fn id(self) -> &'static str {
        match self {
            Self::New => "new-document",
            Self::Versions => "versions",
        }
    }

    /// Button that opens and closes it.
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
