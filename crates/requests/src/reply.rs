//! Replies to requests.

use serde::Serialize;

/// Reply to a request.
#[derive(Clone, Debug, PartialEq)]
pub struct Reply {
    /// The answer, or an error, as JSON.
    pub json: String,
    /// Values of the columns of numbers and of truths, in the order of the tables in the answer.
    pub buffers: Vec<Buffer>,
}

/// Values of a column.
#[derive(Clone, Debug, PartialEq)]
pub enum Buffer {
    /// Numbers in the unit of the column; NaN where there is no value.
    Numbers(Vec<f64>),
    /// Truths, 0 or 1.
    Truths(Vec<u8>),
}

impl Reply {
    /// A reply without arrays.
    pub(crate) fn new(answer: &impl Serialize) -> serde_json::Result<Self> {
        Self::with_buffers(answer, Vec::new())
    }

    pub(crate) fn with_buffers(answer: &impl Serialize, buffers: Vec<Buffer>) -> serde_json::Result<Self> {
        Ok(Self { json: serde_json::to_string(answer)?, buffers })
    }
}
