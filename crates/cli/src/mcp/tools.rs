//! The tools.

use super::answer::{Answer, Refused};
use super::workplace::Call;
use super::{documents, fits, pictures, runs};
use rmcp::handler::server::common::schema_for_type;
use rmcp::model::{JsonObject, Tool, ToolAnnotations};
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::sync::Arc;

/// A tool.
pub struct ToolKind {
    /// Name by which it is called.
    pub name: &'static str,
    /// Description for the model of the client.
    description: &'static str,
    /// JSON schema of its arguments.
    schema: fn() -> Arc<JsonObject>,
    /// True if a call can name a file that is written.
    writes: bool,
    /// Carries out a call.
    pub call: fn(&Call, Value) -> Result<Answer, Refused>,
}

/// All tools, in the order in which an author needs them.
pub const TOOLS: [ToolKind; 9] = [
    ToolKind {
        name: "guide",
        description: "The language of documents in short, with examples that run. Read it before writing a document.",
        schema: schema_for_type::<documents::Guide>,
        writes: false,
        call: |call, value| documents::guide(*call, read(value)?),
    },
    ToolKind {
        name: "examples",
        description: "Searches the documents that the program carries; with `name` returns the text of one.",
        schema: schema_for_type::<documents::Examples>,
        writes: false,
        call: |call, value| documents::examples(*call, read(value)?),
    },
    ToolKind {
        name: "check",
        description: "Checks a document: syntax, names, units, drawing. Each finding has code, line, column, message, both dimensions \
                      of a mismatch, and remedies as edits. With `run` its claims are tested, too.",
        schema: schema_for_type::<documents::Check>,
        writes: false,
        call: |call, value| documents::check(*call, read(value)?),
    },
    ToolKind {
        name: "propose_claims",
        description: "Claims that follow from the equations and labels of a document, each run before it is returned: energy, periods, \
                      signs, rests. One that does not hold is a suspicion of an error, with its meaning.",
        schema: schema_for_type::<documents::Propose>,
        writes: false,
        call: |call, value| documents::propose_claims(*call, read(value)?),
    },
    ToolKind {
        name: "run",
        description: "Runs a document and returns rows of chosen columns, statistics over all rows, and the events that changed states.",
        schema: schema_for_type::<runs::Asked>,
        writes: true,
        call: |call, value| runs::run(*call, read(value)?),
    },
    ToolKind {
        name: "picture",
        description: "Draws the scene at a time, and plots, as PNG.",
        schema: schema_for_type::<pictures::Asked>,
        writes: false,
        call: |call, value| pictures::picture(*call, read(value)?),
    },
    ToolKind {
        name: "fit",
        description: "Fits a document to files of measured data: values with standard errors, residuals, verdict, warnings.",
        schema: schema_for_type::<fits::Fit>,
        writes: false,
        call: |call, value| fits::fit(*call, read(value)?),
    },
    ToolKind {
        name: "rank",
        description: "Fits several documents as theories of the same data, and returns them best first, by AICc.",
        schema: schema_for_type::<fits::Rank>,
        writes: false,
        call: |call, value| fits::rank(*call, read(value)?),
    },
    ToolKind {
        name: "format",
        description: "Gives a document the standard layout. Returns the text, or writes it to `output`.",
        schema: schema_for_type::<documents::Format>,
        writes: true,
        call: |call, value| documents::format(*call, read(value)?),
    },
];

impl ToolKind {
    /// The tool as clients list it.
    pub fn described(&self) -> Tool {
        let annotations = ToolAnnotations::new().read_only(!self.writes).destructive(self.writes).open_world(false);
        Tool::new(self.name, self.description, (self.schema)()).with_annotations(annotations)
    }
}

/// The arguments of a call.
fn read<T: DeserializeOwned>(arguments: Value) -> Result<T, Refused> {
    serde_json::from_value(arguments).map_err(|error| Refused::because(format!("wrong arguments: {error}")))
}
