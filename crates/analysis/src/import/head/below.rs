//! Properties of the rows that are needed to read the header above them.

/// Properties of the rows below a header.
#[derive(Debug)]
pub(in crate::import) struct Below<'a> {
    /// One per column: true if it holds numbers or times; false for columns of words.
    pub numeric: Vec<bool>,
    /// Numbers of the first two columns.
    pub first: &'a [f64],
    pub second: &'a [f64],
}

impl Below<'_> {
    pub fn wide(&self) -> usize {
        self.numeric.len()
    }

    pub fn numeric(&self) -> usize {
        self.numeric.iter().filter(|numeric| **numeric).count()
    }

    pub fn is_numeric(&self, column: usize) -> bool {
        self.numeric.get(column).copied().unwrap_or(false)
    }

    /// True if the first column, where it has no name, numbers or names the rows.
    pub fn names_rows(&self) -> bool {
        let words = !self.is_numeric(0) && self.wide() >= 3;
        let steps = || self.first.iter().zip(self.first.iter().skip(1));
        let counts = self.first.len() >= 2
            && self.first.iter().all(|number| number.fract() == 0.0)
            && steps().all(|(before, after)| after > before);
        let from_one = self.first.first().is_some_and(|first| *first == 0.0 || *first == 1.0);
        words || (counts && (from_one || self.second_increases()))
    }

    fn second_increases(&self) -> bool {
        self.second.iter().zip(self.second.iter().skip(1)).all(|(before, after)| after > before)
    }
}
