//! The unchanged source of each quantity, for those who compare.

use crate::place::Section;
use crate::simulation::{EvolutionPage, Simulation};

/// Greatest number of lines for one quantity.
const MOST_LINES: usize = 12;

/// Line of the simulation that determines a quantity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Original {
    /// Name in the document.
    pub name: String,
    /// Part of the simulation.
    pub section: Section,
    /// Name of the page.
    pub page: String,
    /// Line of the page, from 1.
    pub line: usize,
    /// The line as it is written.
    pub source: String,
}

/// Lines that determine the quantities of a document. `names`: names in the simulation and in the document.
pub(crate) fn originals(simulation: &Simulation, names: &[(String, String)]) -> Vec<Original> {
    let mut lines: Vec<(Section, &str, usize, String)> = Vec::new();
    for page in simulation.variables.iter().filter(|page| page.is_active) {
        for (row, variable) in page.variables.iter().enumerate() {
            let comment = if variable.comment.is_empty() { String::new() } else { format!(" // {}", variable.comment) };
            lines.push((
                Section::Variables,
                &page.name,
                row + 1,
                format!("{} = {}{comment}", variable.name, variable.value),
            ));
        }
    }
    for (section, pages) in
        [(Section::Initialization, &simulation.initialization), (Section::FixedRelations, &simulation.fixed_relations)]
    {
        for page in pages.iter().filter(|page| page.is_active) {
            add_code(section, &page.name, &page.code, &mut lines);
        }
    }
    for page in &simulation.evolution {
        let EvolutionPage::Equations(page) = page else { continue };
        if !page.is_active {
            continue;
        }
        add_code(Section::Evolution, &page.name, &page.preliminary, &mut lines);
        for (row, (state, rate)) in page.rates.iter().enumerate() {
            lines.push((Section::Evolution, &page.name, row + 1, format!("{state}' = {rate}")));
        }
        for event in page.events.iter().filter(|event| event.is_active) {
            add_code(Section::Evolution, &event.name, &event.action, &mut lines);
        }
    }
    let mut found = Vec::new();
    for (original, name) in names {
        let own = lines.iter().filter(|(.., source)| writes(source, original)).take(MOST_LINES);
        found.extend(own.map(|(section, page, line, source)| Original {
            name: name.clone(),
            section: *section,
            page: (*page).to_owned(),
            line: *line,
            source: source.trim().to_owned(),
        }));
    }
    found
}

fn add_code<'a>(section: Section, page: &'a str, code: &str, lines: &mut Vec<(Section, &'a str, usize, String)>) {
    lines.extend(code.lines().enumerate().map(|(index, line)| (section, page, index + 1, line.to_owned())));
}

/// True if a line writes a name: `name =`, `name +=`, `name++`, `name' =`.
fn writes(line: &str, name: &str) -> bool {
    let is_part = |letter: char| letter.is_alphanumeric() || matches!(letter, '_' | '$' | '.');
    let mut from = 0;
    while let Some(at) = line.get(from..).and_then(|rest| rest.find(name)).map(|at| from + at) {
        from = at + name.len();
        let before = line.get(..at).unwrap_or_default();
        let after = line.get(from..).unwrap_or_default();
        if before.ends_with(is_part)
            || after.starts_with(|letter: char| letter.is_alphanumeric() || matches!(letter, '_' | '$'))
        {
            continue;
        }
        let sign = after.trim_start_matches('\'').trim_start();
        let is_compound = ["+=", "-=", "*=", "/=", "%=", "++", "--"].iter().any(|own| sign.starts_with(own));
        if is_compound || sign.starts_with('=') && !sign.starts_with("==") {
            return true;
        }
    }
    false
}
