//! Sizes of families: rebuilding the model with other sizes, and restoring states that need them.

use crate::{Desk, Refusal};

impl Desk {
    /// Rebuilds the model with other sizes of families, given by name. Parameters, plots, the time and measured data
    /// stay as described in [`play::Play::replace_program`]. The text of the document does not change.
    ///
    /// # Errors
    /// A size is outside its range, or the model has errors with it, for example because it is too large.
    pub fn resize(&mut self, sizes: &[(&str, u32)]) -> Result<(), Refusal> {
        let texts: Vec<(&str, String)> = sizes.iter().map(|(name, value)| (*name, value.to_string())).collect();
        let texts: Vec<(&str, &str)> = texts.iter().map(|(name, value)| (*name, value.as_str())).collect();
        let document = document::resized(&self.document, &texts)
            .map_err(|why| Refusal::Size { why: why.text(self.play.language()).into_owned() })?;
        self.play.resize(document.program.clone());
        self.document = document;
        // Members of families now have other indices among states and quantities.
        self.recognise_records();
        Ok(())
    }

    /// Restores a state written by [`play::Play::share`], with the sizes that it needs. The first result is true if the
    /// sizes changed.
    ///
    /// # Errors
    /// As [`play::Play::restore`]; a size that is not possible is listed with the other parts that do not fit.
    pub fn restore(&mut self, fragment: &str) -> (bool, Result<(), play::Refusal>) {
        let wanted = self.play.basis().sizes_for(fragment);
        let wanted: Vec<(&str, u32)> = wanted.iter().map(|(name, value)| (name.as_str(), *value)).collect();
        let resized = !wanted.is_empty() && self.resize(&wanted).is_ok();
        (resized, self.play.restore(fragment))
    }
}
