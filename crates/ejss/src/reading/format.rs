//! The two formats of a simulation.

/// Format of a source.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Format {
    /// `.ejss`
    Xml,
    /// `_source.json`
    Json,
}

impl Format {
    /// Format of a file by its name; `None` for any other file.
    pub fn of(name: &str) -> Option<Self> {
        let name = name.to_ascii_lowercase();
        if name.ends_with(".ejss") { Some(Self::Xml) } else { name.ends_with("source.json").then_some(Self::Json) }
    }
}
