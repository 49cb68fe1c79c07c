//! Effect of an edit: the text is checked, and its program replaces the running one.

use super::state::Writing;
use crate::Desk;
use document::Document;
use play::PlotId;

impl Desk {
    /// The texts in the editor.
    pub fn writing(&self) -> &Writing {
        &self.writing
    }

    /// Starts editing with the running texts, the base document first.
    pub fn begin_writing(&mut self, texts: Vec<String>) {
        self.writing = Writing::of_running(texts);
    }

    /// Continues an earlier edit of the texts that now run.
    pub fn continue_writing(&mut self, writing: Writing) {
        self.writing = writing;
    }

    /// Replaces the text of one file. If the texts give a program, it replaces the running one as described in
    /// [`play::Play::replace_program`]: time, parameters, plots and measured data stay. If they have more errors than
    /// the running texts, only the findings change. Returns true if the program was replaced.
    pub fn write(&mut self, file: usize, text: String) -> bool {
        let document = self.writing.change(file, text);
        self.take_document(document)
    }

    /// Replaces all texts at once, as [`Desk::write`] does for one, for example with those of an earlier visit.
    pub fn write_all(&mut self, texts: Vec<String>) -> bool {
        let document = self.writing.change_all(texts);
        self.take_document(document)
    }

    fn take_document(&mut self, document: Option<Document>) -> bool {
        let is_there = document.is_some();
        if let Some(document) = document {
            self.replace_document(document);
        }
        is_there
    }

    /// Replaces the open document while the simulation runs.
    fn replace_document(&mut self, document: Document) {
        let document = self.with_present_sizes(document);
        let before = &self.document.program;
        let was_varied = |name: &str| {
            let place = before.model.parameters.iter().position(|parameter| parameter.name == name);
            place.and_then(|place| self.fits.setup.varied.get(place).copied())
        };
        let program = &document.program;
        let parameters = program.model.parameters.iter().enumerate();
        let varied = parameters
            .map(|(index, parameter)| was_varied(&parameter.name).unwrap_or_else(|| program.vary.contains(&index)));
        self.fits.setup.varied = varied.collect();
        self.play.replace_program(program.clone());
        // The added plots follow those of the document, whose number may have changed.
        let own = program.plots.len();
        (self.residual_plot, self.cycle_plot) = (PlotId::at(own), PlotId::at(own + 1));
        self.document = document;
        self.recognise_records();
        self.label_residuals();
        self.label_cycles();
        self.revision.fits += 1;
    }

    /// The document with the sizes of families that the user has set, if it still has these families.
    fn with_present_sizes(&self, document: Document) -> Document {
        let present = self.document.program.model.sizes.iter().filter(|size| size.value != size.stated);
        let kept = present.filter(|size| document.program.model.sizes.iter().any(|other| other.name == size.name));
        let sizes: Vec<(&str, String)> = kept.map(|size| (size.name.as_str(), size.value.to_string())).collect();
        if sizes.is_empty() {
            return document;
        }
        let sizes: Vec<(&str, &str)> = sizes.iter().map(|(name, value)| (*name, value.as_str())).collect();
        document::resized(&document, &sizes).unwrap_or(document)
    }
}
