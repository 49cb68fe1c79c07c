//! The texts of a plot.

/// The texts of a plot in the chosen language.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Labels {
    /// Title.
    pub title: String,
    /// Description of the content, for screen readers.
    pub description: String,
    /// Symbol and unit of the horizontal axis.
    pub x: (String, String),
    /// Symbol and unit of each vertical axis.
    pub axes: Vec<(String, String)>,
    /// Words before the symbol of the horizontal axis and of each vertical one: the label of its only quantity. Empty if there
    /// is none, or if the label stands in the place of the symbol.
    pub names: (String, Vec<String>),
    /// Name of each curve.
    pub curves: Vec<String>,
    /// Legend text of each curve: its label, or its name if it has none.
    pub legend: Vec<String>,
    /// For each curve, the name of its abscissa if the plot has curves with different abscissas; otherwise empty.
    pub across: Vec<String>,
}
