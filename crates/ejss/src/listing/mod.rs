//! A simulation as text, without a translation: variables in tables, equations typeset, code shown as code.

mod latex;
mod view;

pub(crate) use view::report_view;

use crate::prose::{code, cut, escaped, plain_text, visible};
use crate::script::parse_expression;
use crate::simulation::{CodePage, Equations, EvolutionPage, Simulation, VariablePage};
use units::{Language, say};

/// Longest text of a cell, in characters.
const LONGEST_CELL: usize = 40;

/// Sections of Markdown for everything of the model.
pub(crate) fn listing(simulation: &Simulation, language: Language) -> Vec<String> {
    let mut blocks = Vec::new();
    let tables: Vec<String> = simulation
        .variables
        .iter()
        .filter(|page| page.is_active)
        .filter_map(|page| table(page, simulation, language))
        .collect();
    if !tables.is_empty() {
        blocks.push(format!("## {}", say!(language, "Variables")));
        blocks.extend(tables);
    }
    codes(&say!(language, "Initialization"), &simulation.initialization, &mut blocks);
    let evolution: Vec<&EvolutionPage> = simulation.evolution.iter().filter(|page| is_active(page)).collect();
    if !evolution.is_empty() {
        blocks.push(format!("## {}", say!(language, "Evolution")));
        for page in evolution {
            match page {
                EvolutionPage::Code(page) => blocks.extend(page_of_code(page)),
                EvolutionPage::Equations(equations) => self::equations(equations, language, &mut blocks),
            }
        }
    }
    codes(&say!(language, "Fixed relations"), &simulation.fixed_relations, &mut blocks);
    codes(&say!(language, "Custom"), &simulation.custom, &mut blocks);
    blocks
}

fn is_active(page: &EvolutionPage) -> bool {
    match page {
        EvolutionPage::Code(page) => page.is_active && !page.code.trim().is_empty(),
        EvolutionPage::Equations(equations) => equations.is_active,
    }
}

fn codes(title: &str, pages: &[CodePage], blocks: &mut Vec<String>) {
    let active: Vec<Vec<String>> =
        pages.iter().filter(|page| page.is_active).map(page_of_code).filter(|page| !page.is_empty()).collect();
    if !active.is_empty() {
        blocks.push(format!("## {title}"));
        blocks.extend(active.into_iter().flatten());
    }
}

fn page_of_code(page: &CodePage) -> Vec<String> {
    if page.code.trim().is_empty() {
        return Vec::new();
    }
    vec![heading(&page.name), code("js", &page.code)]
}

fn heading(name: &str) -> String {
    let name = plain_text(name);
    format!("### {}", escaped(&cut(if name.is_empty() { "…" } else { &name }, 80)))
}

fn table(page: &VariablePage, simulation: &Simulation, language: Language) -> Option<String> {
    if page.variables.is_empty() {
        return None;
    }
    let [name, value, kind, comment, control] = language.say_all(["Name", "Value", "Type", "Comment", "Control"]);
    let mut lines = vec![
        heading(&page.name),
        String::new(),
        format!("| {name} | {value} | {kind} | {comment} | {control} |"),
        "|---|---|---|---|---|".to_owned(),
    ];
    for variable in page.variables.iter().filter(|variable| !variable.name.is_empty()) {
        let kind = format!("{}{}", variable.kind, variable.dimension);
        let of_view = simulation.view.iter().find(|element| {
            ["Value", "Variable", "Checked", "Selected"]
                .iter()
                .any(|property| element.property(property) == Some(&variable.name))
        });
        let control = of_view.map_or_else(String::new, |element| {
            match (element.property("Minimum"), element.property("Maximum")) {
                (Some(low), Some(high)) => format!("{} {low} .. {high}", element.kind),
                _ => element.kind.clone(),
            }
        });
        let cells = [&variable.name, &variable.value, &kind, &variable.comment, &control].map(|text| cell(text));
        lines.push(format!("| {} |", cells.join(" | ")));
    }
    Some(lines.join("\n"))
}

fn cell(text: &str) -> String {
    escaped(&cut(visible(text).trim(), LONGEST_CELL)).replace('|', "\\|")
}

fn equations(equations: &Equations, language: Language, blocks: &mut Vec<String>) {
    blocks.push(heading(&equations.name));
    if !equations.preliminary.trim().is_empty() {
        blocks.push(code("js", &equations.preliminary));
    }
    for (state, rate) in &equations.rates {
        let typeset = parse_expression(state).ok().zip(parse_expression(rate).ok());
        let formula = typeset.and_then(|(state, rate)| {
            let formula = format!(
                "$$\\frac{{\\mathrm{{d}}{}}}{{\\mathrm{{d}}{}}} = {}$$",
                latex::formula(&state)?,
                latex::name(&equations.independent),
                latex::formula(&rate)?
            );
            (formula.len() < 190).then_some(formula)
        });
        blocks.push(formula.unwrap_or_else(|| code("js", &format!("d({state})/d{} = {rate}", equations.independent))));
    }
    let (method, increment) = (escaped(&cut(&equations.method, 40)), escaped(&cut(&equations.increment, 40)));
    blocks.push(say!(language, "Method: {method}. Step: {increment}."));
    for event in equations.events.iter().filter(|event| event.is_active) {
        let (name, kind) = (escaped(&cut(&plain_text(&event.name), 60)), escaped(&cut(&event.kind, 40)));
        blocks.push(say!(language, "Event {name} ({kind}): condition and action"));
        blocks.push(code("js", &event.condition));
        blocks.push(code("js", &event.action));
    }
}
