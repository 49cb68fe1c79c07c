//! The `meniscus` command line: a thin layer over the other crates that adds files, the terminal and a server.
//!
//! Each command is a module of its name: `run`, `check` (with `claims.rs` for `check --run`), `fitting`, `sweep`, `cycles`,
//! `derivatives`, `track`, `authoring` (`new`, `import`, `format`), `export`, `site` (`build`), `serve`, `class`, `handing`,
//! `lsp`, `guide`, `mcp`. `build.rs` embeds the pages if they have been built.
//!
//! - **Invariant:** no half-written files. Output goes to a temporary file, which then replaces the target.
//! - **Invariant:** no computation of its own: what computes is in crates that Python or the page use, too.

mod arguments;
mod authoring;
mod check;
mod class;
mod command;
mod cycles;
mod data;
mod derivatives;
mod export;
mod failure;
mod fitting;
mod guide;
mod handing;
mod load;
mod lsp;
mod mcp;
mod page;
mod run;
mod serve;
mod site;
mod sweep;
mod terminal;
mod track;

use arguments::{Arguments, Command};
use clap::Parser;
use failure::Failure;
use std::process::ExitCode;
use terminal::Terminal;

fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            // Help and version are errors of clap too. If they cannot be written, that cannot be reported either.
            let _ = error.print();
            return ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2));
        }
    };
    let terminal = Terminal::new(arguments.color, terminal::language::chosen(arguments.language));
    catalogues::install();
    let result = match &arguments.command {
        Command::Serve(serve) => serve::serve(serve, terminal),
        Command::Run(run) => run::run(run, terminal),
        Command::Sweep(sweep) => sweep::run(sweep, terminal),
        Command::Check(check) => check::check(check, terminal),
        Command::Cycles(cycles) => cycles::run(cycles, terminal),
        Command::Derivatives(derivatives) => derivatives::run(derivatives, terminal),
        Command::Fit(fit) => fitting::fit(fit, terminal),
        Command::Rank(rank) => fitting::rank(rank, terminal),
        Command::Track(track) => track::run(track, terminal),
        Command::HandIn(arguments) => handing::hand_in(arguments, terminal),
        Command::Verify(verify) => handing::verify(verify, terminal),
        Command::Export(export) => export::export(export, terminal),
        Command::Class(class) => class::run(class, terminal),
        Command::New(new) => authoring::new(new, terminal),
        Command::Import(import) => authoring::import(import, terminal),
        Command::Format(format) => authoring::format(format, terminal),
        Command::Lsp => lsp::serve(terminal.language),
        Command::Mcp(mcp) => mcp::serve(mcp, terminal.language),
        Command::Guide => guide::guide(),
        Command::Build(build) => site::build(build, terminal),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            let language = terminal.language;
            match &failure {
                Failure::Request { message, hint } => {
                    terminal.error(&message.text(language), hint.as_ref().map(|hint| hint.text(language)).as_deref());
                }
                Failure::Expression { source, found } => {
                    found.iter().for_each(|diagnostic| terminal.report_one(source, diagnostic));
                }
                Failure::Document | Failure::Argument | Failure::OutputClosed => {}
            }
            ExitCode::from(failure.exit_code())
        }
    }
}
