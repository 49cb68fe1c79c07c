//! The texts of a plot.

/// The texts of a plot in the chosen language.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Labels {
    /// The title.
    pub title: String,
    /// What it shows, for who does not see it.
    pub description: String,
    /// Name and unit of the horizontal axis.
    pub x: (String, String),
    /// Name and unit of each axis.
    pub axes: Vec<(String, String)>,
    /// The name of each curve.
    pub curves: Vec<String>,
    /// What each curve is called in a legend, where that is not its name.
    pub legend: Vec<String>,
    /// Of each curve the name of what it is drawn against, where that is not the whole horizontal axis; else empty.
    pub across: Vec<String>,
}
