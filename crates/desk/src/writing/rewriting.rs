//! What a change of the text does: it is checked, and its program takes the place of the one that runs.

use super::state::Writing;
use crate::Desk;
use document::Document;
use play::PlotId;

impl Desk {
    /// The texts in the editor.
    pub fn writing(&self) -> &Writing {
        &self.writing
    }

    /// Begins to write with the texts that run, the base document first.
    pub fn begin_writing(&mut self, texts: Vec<String>) {
        self.writing = Writing::of_running(texts);
    }

    /// Goes on with what was being written when these texts began to run.
    pub fn continue_writing(&mut self, writing: Writing) {
        self.writing = writing;
    }

    /// Takes another text for one of the files. If that gives a program, it takes the place of the present one as
    /// [`play::Play::replace_program`] says: time, parameters, plots and what is measured stay. A text with more errors than the one
    /// that runs only brings its findings; the present program runs on. Whether the program was replaced.
    pub fn write(&mut self, file: usize, text: String) -> bool {
        let document = self.writing.change(file, text);
        self.take_document(document)
    }

    /// The same for all texts at once: those of an earlier visit, for example.
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

    /// Puts another document in the place of the present one, while it runs.
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
        // What was added stands behind the plots of the document, whose number may be another.
        let own = program.plots.len();
        (self.residual_plot, self.cycle_plot) = (PlotId::at(own), PlotId::at(own + 1));
        self.document = document;
        self.recognise_records();
        self.label_residuals();
        self.label_cycles();
        self.revision.fits += 1;
    }

    /// The document with the sizes of families that a person has set, where it still has them.
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
