//! An import in steps, between which a page can answer.

use crate::imported::Imported;
use crate::page::Page;
use crate::reading::{self, Files};
use crate::refusal::Refusal;
use crate::report::Report;
use crate::simulation::Simulation;
use crate::translation::{Blocker, Solved};

/// Forms of a translation in the order in which they are tried: with units, with the drawing.
const FORMS: [[bool; 2]; 4] = [[true, true], [false, true], [true, false], [false, false]];

/// Import of a simulation. It proposes a translation; where that is refused, one without units, then one without its drawing, and at
/// last a listing.
#[derive(Debug)]
pub struct Importing {
    simulation: Simulation,
    files: Files,
    page: Page,
    /// The model with what it leaves out, or the reason for a listing; `None` until it is needed.
    model: Option<Result<(Solved, Report), Blocker>>,
    /// Forms that have not been refused.
    forms: Vec<[bool; 2]>,
}

impl Importing {
    /// Reads a file.
    ///
    /// # Errors
    /// The reason why it gives no document.
    pub fn begin(bytes: &[u8]) -> Result<Self, Refusal> {
        let (simulation, files) = reading::read(bytes)?;
        let page = Page::new(&simulation, &files);
        Ok(Self { simulation, files, page, model: None, forms: Vec::new() })
    }

    /// Translates the model, unless that is done.
    pub fn translate(&mut self) {
        if self.model.is_some() {
            return;
        }
        let mut report = self.page.report.clone();
        let model = Solved::new(&self.simulation, &self.files, &mut report).map(|solved| (solved, report));
        if let Ok((solved, _)) = &model {
            let is_possible = |form: &[bool; 2]| (!form[0] || solved.has_units()) && (!form[1] || solved.has_picture());
            self.forms = FORMS.into_iter().filter(is_possible).collect();
        }
        self.model = Some(model);
    }

    /// The document that is proposed now. A listing ([`Imported::listed_because`]) is the last one.
    pub fn candidate(&mut self) -> Imported {
        self.translate();
        match (&self.model, self.forms.first()) {
            (Some(Ok((solved, report))), Some(&form)) => {
                let mut report = report.clone();
                let blocks = solved.document(&self.page.title, form, &mut report);
                self.page.translated(&self.simulation, solved, &blocks, form[0], report)
            }
            (Some(Err(blocker)), _) => self.page.listed(&self.simulation, blocker),
            _ => self.page.listed(&self.simulation, &Blocker::NoEquations),
        }
    }

    /// The proposed translation is refused, with this error.
    pub fn refuse(&mut self, error: String) {
        self.forms.drain(..self.forms.len().min(1));
        if self.forms.is_empty() {
            self.model = Some(Err(Blocker::Checker(error)));
        }
    }
}
