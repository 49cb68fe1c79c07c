//! `meniscus mcp`: tools for assistants, by the Model Context Protocol over standard input and output.
//!
//! | file | contents |
//! |---|---|
//! | `tools.rs` | the list of tools: name, description, arguments, function |
//! | `workplace.rs` | the folder, below which files are read and written, and documents from it |
//! | `answer.rs` | answers and refusals as JSON |
//! | `documents.rs` | `check`, `propose_claims`, `format`, `examples`, `guide` |
//! | `runs.rs`, `summary.rs` | `run`: table, statistics, events |
//! | `pictures.rs` | `picture`: scene and plots as PNG |
//! | `fits.rs` | `fit`, `rank` |
//! | `given.rs` | arguments that several tools have |
//!
//! - **Invariant:** the tools compute nothing of their own: they call what the commands call.
//! - **Invariant:** no file above the folder is read or written, and none is written that the call does not name. No network.
//! - **Invariant:** a call takes a bounded time (`--seconds`) and a bounded memory. Calls run one after the other.
//! - **Invariant:** the text of a document is data. Nothing in it chooses a file, a tool or an argument.

mod answer;
pub mod arguments;
mod documents;
mod fits;
mod given;
mod pictures;
mod runs;
mod summary;
mod tools;
mod workplace;

use crate::failure::Failure;
use arguments::Mcp;
use rmcp::model::{
    CallToolRequestParams, CallToolResponse, Implementation, ListToolsResult, PaginatedRequestParams,
    ServerCapabilities, ServerConfig,
};
use rmcp::service::{RequestContext, RoleServer};
use rmcp::{ErrorData, ServerHandler, ServiceExt};
use serde_json::Value;
use std::sync::{Arc, Mutex};
use tools::TOOLS;
use units::Language;
use workplace::Workplace;

/// Instructions for the use of the server, which a client passes to its model.
const INSTRUCTIONS: &str = "Meniscus runs simulations that are one Markdown document each: equations with units, a drawing, plots, \
    questions, and claims that are tested. Read `guide` before you write one. Then `check` with `run: true`, mend what the findings \
    say, and repeat until there are none. Then look at `propose_claims`. A claim is a statement of physics that you know to be true of the motion: write several \
    (energy, a limit, a period), since only they show that the equations are right. `examples` has documents to begin from.";

/// Serves a client until it closes the standard input.
///
/// # Errors
/// The folder cannot be opened, or the client does not begin as the protocol says.
pub fn serve(arguments: &Mcp, language: Language) -> Result<(), Failure> {
    let workplace = Workplace::open(&arguments.folder, arguments.seconds, language)?;
    let failed =
        |error: &dyn std::fmt::Display| Failure::request(format!("the connection to the client is broken: {error}"));
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().map_err(|error| failed(&error))?;
    let server = Server { workplace: Arc::new(workplace), turn: Arc::default() };
    let served = runtime.block_on(async {
        let running = server.serve(rmcp::transport::stdio()).await.map_err(|error| failed(&error))?;
        running.waiting().await.map_err(|error| failed(&error))
    });
    // A call may still be computing, and nobody waits for it.
    runtime.shutdown_background();
    served.map(drop)
}

/// The server of one client.
#[derive(Clone)]
struct Server {
    workplace: Arc<Workplace>,
    /// Held during a call.
    turn: Arc<Mutex<()>>,
}

impl ServerHandler for Server {
    fn get_info(&self) -> ServerConfig {
        let mut info = ServerConfig::new(ServerCapabilities::builder().enable_tools().build());
        info.server_info = Implementation::new("meniscus", env!("CARGO_PKG_VERSION"));
        info.instructions = Some(INSTRUCTIONS.to_owned());
        info
    }

    async fn list_tools(
        &self,
        _: Option<PaginatedRequestParams>,
        _: RequestContext<RoleServer>,
    ) -> Result<ListToolsResult, ErrorData> {
        Ok(ListToolsResult::with_all_items(TOOLS.iter().map(tools::ToolKind::described).collect()))
    }

    async fn call_tool(
        &self,
        request: CallToolRequestParams,
        _: RequestContext<RoleServer>,
    ) -> Result<CallToolResponse, ErrorData> {
        let Some(tool) = TOOLS.iter().find(|tool| tool.name == request.name) else {
            let names: Vec<&str> = TOOLS.iter().map(|tool| tool.name).collect();
            let message = format!("there is no tool `{}`; there are {}", request.name, names.join(", "));
            return Err(ErrorData::invalid_params(message, None));
        };
        let Self { workplace, turn } = self.clone();
        let arguments = Value::Object(request.arguments.unwrap_or_default());
        let called = tokio::task::spawn_blocking(move || {
            let _turn = turn.lock();
            answer::result((tool.call)(&workplace.now(), arguments))
        });
        let result = called.await.map_err(|error| ErrorData::internal_error(error.to_string(), None))?;
        Ok(result.into())
    }
}
