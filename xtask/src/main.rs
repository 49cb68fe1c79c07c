//! Builds the page and runs all checks.

mod page;

use std::path::PathBuf;
use std::process::ExitCode;

fn main() -> ExitCode {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..");
    let task = std::env::args().nth(1);
    let outcome = match task.as_deref() {
        Some("page") => page::build(&root).map(|_| ()),
        _ => Err("usage: cargo xtask page".to_owned()),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}
