//! What a change of the text does: it is checked, and its program takes the place of the one that runs.

use super::state::Writing;
use crate::Desk;
use document::{Document, Opened};
use model::Severity;
use play::PlotId;

impl Desk {
    /// The texts in the editor.
    pub fn writing(&self) -> &Writing {
        &self.writing
    }

    /// Begins to write with the texts that run, the base document first.
    pub fn begin_writing(&mut self, texts: Vec<String>) {
        let opened = open(&texts);
        self.writing = Writing { tolerated: errors(&opened), findings: opened.diagnostics, texts, runs: true };
    }

    /// Takes another text for one of the files, or a further one. If that gives a program, it takes the place of the present one as
    /// [`play::Play::replace_program`] says: time, parameters, plots and what is measured stay. A text with more errors than the one
    /// that runs only brings its findings; the present program runs on. Whether the program was replaced.
    pub fn write(&mut self, file: usize, text: String) -> bool {
        match self.writing.texts.get_mut(file) {
            Some(before) if *before == text => return false,
            Some(before) => *before = text,
            None => return false,
        }
        self.check_writing()
    }

    /// The same for all texts at once: those of an earlier visit, for example.
    pub fn write_all(&mut self, texts: Vec<String>) -> bool {
        self.writing.texts = texts;
        self.check_writing()
    }

    fn check_writing(&mut self) -> bool {
        let opened = open(&self.writing.texts);
        let found = errors(&opened);
        let document = opened.document.filter(|_| found <= self.writing.tolerated);
        self.writing.findings = opened.diagnostics;
        self.writing.runs = document.is_some();
        if let Some(document) = document {
            self.writing.tolerated = found;
            self.replace_document(document);
        }
        self.writing.runs
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

fn open(texts: &[String]) -> Opened {
    let mut texts = texts.iter().map(String::as_str);
    let source = texts.next().unwrap_or_default();
    let translations: Vec<&str> = texts.collect();
    document::open(source, &translations)
}

fn errors(opened: &Opened) -> usize {
    opened.diagnostics.iter().filter(|(_, found)| found.severity == Severity::Error).count()
}
