//! Report of an import, for its views.

use ejss::{Entry, Imported, Original};
use units::Words;

/// Report of the last import.
#[derive(Debug)]
pub struct Report {
    /// Name of the file of the document.
    name: String,
    imported: Imported,
}

impl Report {
    /// Report of an import into a document of this name.
    pub fn new(name: String, imported: Imported) -> Self {
        Self { name, imported }
    }

    /// Name of the file of the document.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Entries in the order of the report.
    pub fn entries(&self) -> &[Entry] {
        self.imported.report.entries()
    }

    /// Reason why the model is listed and not translated.
    pub fn listed_because(&self) -> Option<&Words> {
        self.imported.listed_because.as_ref()
    }

    /// Lines of the original that determine a quantity of the document.
    pub fn originals(&self, name: &str) -> impl Iterator<Item = &Original> {
        self.imported.originals.iter().filter(move |original| original.name == name)
    }
}
