//! Fits when another document is opened, or the program of the open one is replaced.

use crate::Changes;
use crate::fits::Fits;
use crate::fits::fit::Waiting;
use program::Program;

impl Fits {
    /// Takes the fits, and the settings that do not depend on the document, from a desk with another document.
    pub(crate) fn adopt(&mut self, other: &mut Self) {
        self.finished = std::mem::take(&mut other.finished);
        self.waiting = std::mem::take(&mut other.waiting);
        self.issued = other.issued;
        self.waiting.extend(other.running.drain(..).filter_map(|running| Waiting::of(running.job)));
        let (setup, before) = (&mut self.setup, &mut other.setup);
        setup.window = before.window;
        setup.loss = before.loss;
        setup.chosen = before.chosen;
        setup.others = std::mem::take(&mut before.others);
        setup.same = std::mem::take(&mut before.same);
    }
    /// Varies the numbers that an opened document asks for.
    pub(crate) fn vary_as_stated(&mut self, program: &Program) {
        self.setup.varied = (0..program.model.parameters.len()).map(|index| program.vary.contains(&index)).collect();
    }

    /// Replaces the program: parameters of the same name stay varied or fixed, others as the document asks.
    pub(crate) fn replace_program(&mut self, before: &Program, program: &Program) -> Changes {
        let was_varied = |name: &str| {
            let place = before.model.parameters.iter().position(|parameter| parameter.name == name);
            place.and_then(|place| self.setup.varied.get(place).copied())
        };
        let parameters = program.model.parameters.iter().enumerate();
        let varied = parameters
            .map(|(index, parameter)| was_varied(&parameter.name).unwrap_or_else(|| program.vary.contains(&index)));
        self.setup.varied = varied.collect();
        Changes::FITS
    }
}
