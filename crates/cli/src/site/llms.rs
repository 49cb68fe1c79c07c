//! `llms.txt` of a site (llmstxt.org): what the site holds, for language models. It names the pages and the guide of the language.

use super::collect::Simulation;
use super::names::GUIDE;
use std::fmt::Write as _;
use units::percent_encoded;

/// The text for these simulations.
pub fn text(simulations: &[Simulation]) -> String {
    let mut text = format!(
        "# Simulations made with Meniscus\n\n\
         > Each simulation is one text document with equations, units, a drawing, plots, questions and claims that are tested.\n\n\
         ## Language\n\n\
         - [Guide]({GUIDE}): how such a document is written, with examples that run\n\n\
         ## Simulations\n\n"
    );
    for simulation in simulations {
        let title = one_line(&simulation.document.program.title);
        let topics = document::card(&simulation.document.source).topics.join(", ");
        let about = if topics.is_empty() { topics } else { format!(": {}", one_line(&topics)) };
        // Writing to a string cannot fail.
        let _ = writeln!(text, "- [{title}]({}){about}", percent_encoded(simulation.page()));
    }
    text
}

/// The text without line breaks and brackets, so that it ends neither its line nor its link.
fn one_line(text: &str) -> String {
    text.replace(['\n', '\r'], " ").replace(['[', ']'], "")
}
