//! `meniscus verify`: computes hand-ins again.

use super::VERSION;
use super::arguments::{Format, Verify};
use super::read::{Handed, all, last_of_each, sender};
use super::report::{Report, State};
use crate::failure::Failure;
use crate::terminal::Terminal;
use crate::terminal::output::print;
use class::verify::{Curve, copies};

/// Verifies hand-ins and writes the result.
///
/// # Errors
/// A file cannot be read. [`Failure::Document`] if a hand-in does not hold.
pub fn verify(arguments: &Verify, terminal: Terminal) -> Result<(), Failure> {
    let handed = all(&arguments.paths)?;
    let report = report(&handed);
    let text = match arguments.format {
        Format::Text => report.text(terminal.language),
        Format::Json => report.json(terminal.language),
    };
    print(&text)?;
    if report.holds() { Ok(()) } else { Err(Failure::Document) }
}

fn report(handed: &[Handed]) -> Report<'_> {
    let last = last_of_each(handed);
    let mut states = Vec::new();
    let mut curves = Vec::new();
    for (index, one) in handed.iter().enumerate() {
        let state = match &one.content {
            Err(error) => State::Unreadable(error.words()),
            Ok(hand_in) => match last.get(&sender(hand_in)) {
                Some(&counts) if counts != index => State::Repeated(counts),
                _ => {
                    curves.extend(Curve::of(index, hand_in));
                    match class::verify::verify(hand_in, VERSION) {
                        Ok(verdict) => State::Verified(verdict),
                        Err(why) => State::Unreadable(why),
                    }
                }
            },
        };
        states.push(state);
    }
    Report { handed, states, copies: copies(&curves) }
}
