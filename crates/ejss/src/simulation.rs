//! A simulation of EJS as it is stored: one structure for both formats. All values are texts, as in the files.

/// Simulation.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Simulation {
    pub title: String,
    pub authors: Vec<String>,
    /// HTML or text.
    pub summary: String,
    pub description: Vec<DescriptionPage>,
    pub frames_per_second: String,
    pub steps_per_display: String,
    pub variables: Vec<VariablePage>,
    pub initialization: Vec<CodePage>,
    pub evolution: Vec<EvolutionPage>,
    pub fixed_relations: Vec<CodePage>,
    pub custom: Vec<CodePage>,
    /// Classes of the elements of the model, such as sounds or sockets.
    pub model_elements: Vec<String>,
    pub view: Vec<Element>,
    /// Number of views beyond the first active one.
    pub further_views: usize,
}

/// Page of the description.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct DescriptionPage {
    pub title: String,
    /// `_default_`, or the tag of a language.
    pub locale: String,
    pub html: String,
    /// True if the content is a file beside the simulation; `html` is then empty.
    pub is_external: bool,
}

/// Table of variables.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct VariablePage {
    pub name: String,
    pub is_active: bool,
    pub variables: Vec<Variable>,
}

/// Variable of the model.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Variable {
    pub name: String,
    /// JavaScript; may be empty.
    pub value: String,
    /// `double`, `int`, `boolean`, `String` or `Object`.
    pub kind: String,
    /// `[n]` for an array; empty for a single value.
    pub dimension: String,
    pub comment: String,
}

/// Page of code.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct CodePage {
    pub name: String,
    pub is_active: bool,
    pub code: String,
}

/// Page of the evolution.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum EvolutionPage {
    Code(CodePage),
    Equations(Equations),
}

/// Ordinary differential equations with their solver.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Equations {
    pub name: String,
    pub is_active: bool,
    pub preliminary: String,
    pub independent: String,
    pub increment: String,
    /// State and rate of change.
    pub rates: Vec<(String, String)>,
    pub method: String,
    pub internal_step: String,
    pub events: Vec<Event>,
    /// True if there are delays or discontinuities.
    pub has_extras: bool,
}

/// Event of the equations.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Event {
    pub name: String,
    pub is_active: bool,
    pub kind: String,
    pub condition: String,
    pub action: String,
}

/// Element of the view.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Element {
    /// Without the prefix `Elements.`: `Slider`, `DrawingPanel`.
    pub kind: String,
    pub name: String,
    /// Index of the element that contains it, in the same list.
    pub parent: Option<usize>,
    /// Names and JavaScript values.
    pub properties: Vec<(String, String)>,
}

impl Element {
    /// Value of a property, without blanks around it; `None` if it is not set or empty.
    pub fn property(&self, name: &str) -> Option<&str> {
        let value = self.properties.iter().find(|(own, _)| own == name)?.1.trim();
        (!value.is_empty()).then_some(value)
    }
}
