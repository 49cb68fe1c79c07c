//! Arguments of `meniscus mcp`.

use clap::Args;
use std::path::PathBuf;

/// Shown after the help of `meniscus mcp`.
pub const MCP_EXAMPLES: &str = "\
Clients start it by themselves. Most take an entry such as this one:
  { \"mcpServers\": { \"meniscus\": { \"command\": \"meniscus\", \"args\": [\"mcp\", \"--folder\", \"/home/me/physics\"] } } }

Tools: check, run, picture, fit, rank, format, examples, guide. Files are read and written below the folder only; links that lead
out of it are refused. docs/assistants.md says how common clients are told.";

/// `meniscus mcp`
#[derive(Debug, Args)]
pub struct Mcp {
    /// The folder below which files are read, and written where a call names one [default: the current folder]
    #[arg(long, value_name = "DIR", default_value = ".", hide_default_value = true)]
    pub folder: PathBuf,

    /// Longest time of a call, in seconds
    #[arg(long, value_name = "N", default_value_t = 30)]
    pub seconds: u32,
}
