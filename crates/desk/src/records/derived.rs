//! Velocities and accelerations computed from a column at the user's request. They become columns of the record, marked
//! as derived from their source.

use crate::records::Records;
use crate::records::recognise::{Meaning, observed};
use crate::records::record::{Made, Record, Use};
use crate::{Announcement, Changes, OpenDocument, Refusal};
use analysis::derivative::{self, Differentiation};
use analysis::table::Column;
use document::Document;
use units::{Language, Unit, say};

impl Records {
    /// Appends velocity and acceleration of a column to the record. Replaces earlier derivatives of the same column.
    /// `how`: method of differentiation.
    ///
    /// # Errors
    /// The smoothing polynomial does not exist, or the column cannot be differentiated.
    pub fn make_derivatives(
        &mut self,
        open: OpenDocument<'_>,
        id: u32,
        column: usize,
        how: Differentiation,
    ) -> Result<Changes, Refusal> {
        if !how.is_possible() {
            return Err(Refusal::NoSuchPolynomial);
        }
        let Some(record) = self.get_mut(id) else { return Ok(Changes::NONE) };
        if record.table.columns.get(column).is_none() || column >= record.read_columns() {
            return Ok(Changes::NONE);
        }
        let Some(made) = record.differentiate(column, how) else { return Err(Refusal::NoDerivative) };
        let earlier: Vec<Made> =
            record.made.iter().copied().filter(|made| made.of != column && made.order == 1).collect();
        record.forget_made();
        for other in earlier {
            if let Some(columns) = record.differentiate(other.of, other.how) {
                record.take_made(columns, other.of, other.how);
            }
        }
        record.take_made(made, column, how);
        record.settle_made(open.document);
        let name = record.name.clone();
        Ok(Changes::RECORDS.announcing(Announcement::DerivativesMade(name)))
    }

    /// Removes all derivatives from a record.
    pub fn forget_derivatives(&mut self, id: u32) -> Changes {
        let Some(record) = self.get_mut(id) else { return Changes::NONE };
        record.forget_made();
        Changes::RECORDS
    }
}

impl Record {
    /// Number of columns of the file. Derivatives follow them.
    pub fn read_columns(&self) -> usize {
        self.table.columns.len() - self.made.len()
    }

    /// Origin of a derivative; `None` for a column of the file.
    pub fn how_made(&self, column: usize) -> Option<Made> {
        column.checked_sub(self.read_columns()).and_then(|place| self.made.get(place)).copied()
    }

    /// Velocity and acceleration of a column; `None` if no row has the neighbours that they need.
    fn differentiate(&self, column: usize, how: Differentiation) -> Option<[Vec<f64>; 2]> {
        let values = &self.table.columns.get(column)?.values;
        let [_, first, second] = how.derivatives(self.table.times_of(column), values);
        first.iter().any(|value| value.is_finite()).then_some([first, second])
    }

    fn take_made(&mut self, columns: [Vec<f64>; 2], of: usize, how: Differentiation) {
        for (order, values) in (1..).zip(columns) {
            let Some(source) = self.table.columns.get(of) else { return };
            let column = Column { unit: None, values, ..source.clone() };
            self.computed.push((self.table.columns.len(), of));
            self.table.columns.push(column);
            self.uses.push(Use {
                meaning: Meaning::nothing(),
                fitted: false,
                offset: 0.0,
                chosen: false,
                stated: false,
            });
            self.made.push(Made { of, order, how });
        }
    }

    pub(crate) fn forget_made(&mut self) {
        let read = self.read_columns();
        self.table.columns.truncate(read);
        self.uses.truncate(read);
        self.computed.retain(|(column, _)| *column < read);
        self.made.clear();
    }

    /// The differentiated columns and their methods.
    pub fn differentiated(&self) -> impl Iterator<Item = (usize, Differentiation)> {
        self.made.iter().filter(|made| made.order == 1).map(|made| (made.of, made.how))
    }

    /// Computes the derivatives of these columns again. Skips repeated columns and those that the file does not have.
    pub fn restore_made(&mut self, columns: impl Iterator<Item = (usize, Differentiation)>, document: &Document) {
        for (of, how) in columns {
            let once = of < self.read_columns() && self.made.iter().all(|made| made.of != of);
            if let Some(columns) = self.differentiate(of, how).filter(|_| once) {
                self.take_made(columns, of, how);
            }
        }
        self.settle_made(document);
    }

    /// Names the derivatives and sets their units. Each is taken for the derivative of its source's quantity if the
    /// model has it, unless the user has chosen otherwise.
    pub fn settle_made(&mut self, document: &Document) {
        let read = self.read_columns();
        for (place, Made { of, order, .. }) in self.made.clone().into_iter().enumerate() {
            let (Some(source), Some(own)) = (self.uses.get(of).cloned(), self.table.columns.get(of)) else { continue };
            let Some(clock) = self.uses.get(own.independent) else { continue };
            let unit = derivative::unit(&source.meaning.unit.text, &clock.meaning.unit.text, order);
            let unit = Unit::parse(&unit).ok();
            let name = format!("{}{}", source.meaning.quantity, "'".repeat(order));
            let same = |unit: &Unit| {
                observed(&document.program.model, &name).is_some_and(|observed| observed.dimension() == unit.dimension)
            };
            let known = !source.meaning.quantity.is_empty() && unit.as_ref().is_some_and(same);
            // A column without a name in the file is called by its quantity, or else by its number.
            let stem = match (own.name.is_empty(), source.meaning.quantity.is_empty()) {
                (false, _) => own.name.clone(),
                (true, false) => source.meaning.quantity.clone(),
                (true, true) => (of + 1).to_string(),
            };
            if let Some(column) = self.table.columns.get_mut(read + place) {
                column.name = stem + &"'".repeat(order);
                column.unit.clone_from(&unit);
            }
            if let Some(used) = self.uses.get_mut(read + place).filter(|used| !used.chosen) {
                let quantity = if known { name } else { String::new() };
                used.meaning = Meaning { quantity, unit: unit.unwrap_or_else(Unit::dimensionless) };
            }
        }
    }
}

/// Short name of a method of differentiation.
pub(crate) fn differentiation(language: Language, how: Differentiation) -> String {
    match how {
        Differentiation::Central => language.say("central differences").to_owned(),
        Differentiation::Forward => language.say("forward differences").to_owned(),
        Differentiation::Backward => language.say("backward differences").to_owned(),
        Differentiation::Smooth { window, degree } => {
            say!(language, "polynomials of degree {degree} over {window} rows")
        }
    }
}
