//! The forms in which a document is written.

/// In which form the document is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Panel {
    /// Its text.
    #[default]
    Text,
    /// Forms of its model.
    Model,
    /// Forms of what its readers see: drawing, plots, values and controls.
    View,
    /// Its questions with their answers.
    Questions,
    /// Its texts beside those of a translation.
    Translation,
}

impl Panel {
    /// All of them in the order of the tabs.
    pub const ALL: [Self; 5] = [Self::Text, Self::Model, Self::View, Self::Questions, Self::Translation];

    /// The name in ids.
    pub fn id(self) -> &'static str {
        match self {
            Self::Text => "text",
            Self::Model => "model",
            Self::View => "view",
            Self::Questions => "questions",
            Self::Translation => "translation",
        }
    }
}
