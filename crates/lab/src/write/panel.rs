//! Forms for editing a document.

/// Form for editing a document.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Panel {
    /// Text.
    #[default]
    Text,
    /// Forms of the model.
    Model,
    /// Forms of the views: drawing, plots, values and controls.
    View,
    /// Questions with their answers.
    Questions,
    /// Texts beside those of a translation.
    Translation,
}

impl Panel {
    /// All panels in the order of the tabs.
    pub const ALL: [Self; 5] = [Self::Text, Self::Model, Self::View, Self::Questions, Self::Translation];

    /// Name in ids.
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
