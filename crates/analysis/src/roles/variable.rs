//! Choice of an independent variable by a document or a user.

use super::assign::{self, measure_against, owners};
use super::bodies::forget_bodies;
use super::remark::{self, Remark};
use crate::origin::{Reason, Role};
use crate::table::Table;
use units::{Dimension, Language};

/// Column that matches the independent variable of a document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Suited {
    /// The present independent variable matches, or no column does.
    AsRead,
    /// This column matches.
    Column(usize),
}

impl Table {
    /// Column with the name of an independent variable of this dimension, or else the only one with a unit of it. Columns
    /// in `observed` are excluded.
    pub fn suited(&self, name: &str, dimension: Dimension, observed: &[usize]) -> Suited {
        let unit =
            |index: usize| self.columns.get(index).and_then(|column| column.unit.as_ref()).map(|unit| unit.dimension);
        let is_free = |index: &usize| {
            !observed.contains(index) && self.columns.get(*index).is_some_and(|column| column.filled() > 1)
        };
        let is_used = |index: usize| {
            (0..self.columns.len()).any(|other| {
                other != index && self.columns.get(other).is_some_and(|column| column.independent == index)
            })
        };
        let settled = |index: usize| {
            let undecided = self.distinguishes(index);
            if is_used(index) && !undecided { Suited::AsRead } else { Suited::Column(index) }
        };
        let all = || (0..self.columns.len()).filter(is_free);
        let called = |index: &usize| self.columns.get(*index).is_some_and(|column| column.name == name);
        let named = || all().filter(|index| called(index) && unit(*index).is_none_or(|unit| unit == dimension));
        if let Some(found) = named().find(|index| is_used(*index)).or_else(|| named().next()) {
            return settled(found);
        }
        let mut of_unit = all().filter(|index| unit(*index) == Some(dimension));
        let (Some(one), None) = (of_unit.next(), of_unit.next()) else { return Suited::AsRead };
        // A time as a quantity is already handled by the rules for times.
        let clocks: Vec<usize> = self.independent().filter(|index| is_used(*index)).collect();
        let fits = |index: &usize| unit(*index) == Some(dimension);
        let open = self.distinguishes(one);
        if dimension == Dimension::NONE || (clocks.iter().any(fits) && !open) || (dimension == Dimension::TIME && !open)
        {
            return Suited::AsRead;
        }
        settled(one)
    }

    /// True if this column alone is the independent variable of one open reading and does not occur in the others.
    fn distinguishes(&self, column: usize) -> bool {
        let mut with = self.readings.iter().filter(|reading| reading.contains(&column));
        with.next().is_some_and(|reading| reading[..] == [column]) && with.next().is_none()
    }

    /// Measures all columns against the one that matches the independent variable of a document. Returns a remark if that
    /// differs from the present one.
    pub fn suit(&mut self, name: &str, dimension: Dimension, observed: &[usize]) -> Option<Remark> {
        let Suited::Column(column) = self.suited(name, dimension, observed) else { return None };
        Some(self.against(&[column], Reason::Document))
    }

    /// Measures the columns against these: all against one, or each against the one of several that it belongs to.
    pub fn against(&mut self, clocks: &[usize], reason: Reason) -> Remark {
        measure_against(self, clocks, reason);
        Remark::Chosen {
            columns: self.clocks().map(|index| self.label(index)).collect(),
            by_document: reason == Reason::Document,
        }
    }

    /// Indices of the independent variables, without counters.
    pub fn clocks(&self) -> impl Iterator<Item = usize> + '_ {
        self.independent().filter(|index| {
            self.columns.get(*index).is_some_and(|column| matches!(column.origin.role, Role::Independent(_)))
        })
    }

    /// Decides the roles of all columns again, as after the import.
    pub fn read_roles(&mut self) {
        forget_bodies(self);
        assign::assign(self);
    }

    /// Reading in words, given by its independent variables.
    pub fn reading_in_words(&self, clocks: &[usize], language: Language) -> String {
        remark::reading(&clocks.iter().map(|index| self.label(*index)).collect::<Vec<_>>(), language)
    }

    /// True if the readings differ in the independent variable of a column.
    pub fn is_open(&self, column: usize) -> bool {
        let variable = |reading: &Vec<usize>| owners(&self.columns, reading).get(column).copied();
        let mut variables = self.readings.iter().map(variable);
        let first = variables.next();
        variables.any(|other| Some(other) != first)
    }
}
