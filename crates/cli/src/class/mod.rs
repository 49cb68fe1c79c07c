//! `meniscus class`: what a teacher does with a document for a class.

pub mod arguments;
mod assign;
mod gradebook;
mod report;
mod server;
mod server_arguments;
mod stored;
mod survey;

use crate::failure::Failure;
use crate::terminal::Terminal;
use ::server::write_private_files;
use arguments::Class;

/// Runs one of the commands.
pub fn run(class: &Class, terminal: Terminal) -> Result<(), Failure> {
    // Results, answers and hidden values are for the teacher alone.
    write_private_files();
    match class {
        Class::Assign(arguments) => assign::assign(arguments, terminal),
        Class::Report(arguments) => report::report(arguments, terminal),
        Class::Survey(arguments) => survey::survey(arguments, terminal),
        Class::Server(command) => server::run(command, terminal),
    }
}
