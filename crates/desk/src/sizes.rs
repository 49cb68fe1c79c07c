//! Other sizes of families, and states that need them.

use crate::{Desk, Refusal};

impl Desk {
    /// Builds the model with other sizes of families, by their names. Parameters, plots, the time and what is measured stay, as
    /// [`play::Play::replace_program`] says; the text from which the document was opened does not change.
    ///
    /// # Errors
    /// A size outside its range, or one with which the model has errors: one that is too large.
    pub fn resize(&mut self, sizes: &[(&str, u32)]) -> Result<(), Refusal> {
        let texts: Vec<(&str, String)> = sizes.iter().map(|(name, value)| (*name, value.to_string())).collect();
        let texts: Vec<(&str, &str)> = texts.iter().map(|(name, value)| (*name, value.as_str())).collect();
        let document = document::resized(&self.document, &texts)
            .map_err(|why| Refusal::Size { why: why.text(self.play.language()).to_owned() })?;
        self.play.resize(document.program.clone());
        self.document = document;
        // Members of families stand at other places among states and quantities.
        self.recognise_records();
        Ok(())
    }

    /// Brings back a state that [`play::Play::share`] has written, with the sizes that it needs. Whether these are others than before.
    ///
    /// # Errors
    /// As [`play::Play::restore`]; a size that cannot be had is named like anything else that does not fit.
    pub fn restore(&mut self, fragment: &str) -> (bool, Result<(), play::Refusal>) {
        let wanted = self.play.sizes_for(fragment);
        let wanted: Vec<(&str, u32)> = wanted.iter().map(|(name, value)| (name.as_str(), *value)).collect();
        let resized = !wanted.is_empty() && self.resize(&wanted).is_ok();
        (resized, self.play.restore(fragment))
    }
}
