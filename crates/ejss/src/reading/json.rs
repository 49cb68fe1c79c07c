//! The format `_source.json` of WebEJS. It has the names of `.ejss`, and elements of the view inside one another.

use super::limits::DEEPEST;
use crate::refusal::Refusal;
use crate::simulation::{
    CodePage, DescriptionPage, Element, Equations, Event, EvolutionPage, Simulation, Variable, VariablePage,
};
use serde_json::Value;

/// The simulation of a text.
///
/// # Errors
/// The text is no JSON, is nested too deeply, or is no simulation.
pub(super) fn read(text: &str) -> Result<Simulation, Refusal> {
    // The tree of elements takes two levels of JSON for each of its own.
    if depth(text) > 2 * DEEPEST {
        return Err(Refusal::TooComplex);
    }
    let root: Value = serde_json::from_str(text).map_err(|error| {
        if error.is_eof() || text.contains("\"model\"") { Refusal::Broken } else { Refusal::Unknown }
    })?;
    let (information, model, view) = (&root["information"], &root["model"], &root["view"]);
    if !model.is_object() {
        return Err(Refusal::Unknown);
    }
    if ["password", "Password", "ExecPassword"].iter().any(|key| !texts(&information[*key]).is_empty()) {
        return Err(Refusal::Protected);
    }
    let pages = |section: &str| model[section]["pages"].as_array().map(Vec::as_slice).unwrap_or_default();
    let timing = &model["evolution"]["information"];
    let mut elements = Vec::new();
    collect(&view["Tree"], None, &mut elements);
    Ok(Simulation {
        title: text_of(&information["Title"]),
        authors: texts(&information["Author"]),
        summary: text_of(&information["Abstract"]),
        description: list(&root["description"]["pages"]).filter(|page| is_active(page)).map(description).collect(),
        frames_per_second: text_of(&timing["FPS"]),
        steps_per_display: text_of(&timing["SPD"]),
        variables: pages("variables").iter().map(variables).collect(),
        initialization: pages("initialization").iter().map(code).collect(),
        evolution: pages("evolution").iter().map(evolution).collect(),
        fixed_relations: pages("fixed_relations").iter().map(code).collect(),
        custom: pages("custom").iter().map(code).collect(),
        model_elements: list(&model["elements"]["list"]).map(|element| text_of(&element["Classname"])).collect(),
        view: elements,
        further_views: 0,
    })
}

/// Greatest depth of brackets outside of texts.
fn depth(text: &str) -> usize {
    let (mut now, mut most, mut is_text, mut is_escaped) = (0_usize, 0, false, false);
    for byte in text.bytes() {
        match byte {
            _ if is_escaped => is_escaped = false,
            b'\\' => is_escaped = is_text,
            b'"' => is_text = !is_text,
            b'{' | b'[' if !is_text => {
                now += 1;
                most = most.max(now);
            }
            b'}' | b']' if !is_text => now = now.saturating_sub(1),
            _ => {}
        }
    }
    most
}

fn list(value: &Value) -> impl Iterator<Item = &Value> {
    value.as_array().map(Vec::as_slice).unwrap_or_default().iter()
}

/// Text of a leaf; numbers and truth values as they are written.
fn text_of(value: &Value) -> String {
    match value {
        Value::String(text) => text.replace("\r\n", "\n"),
        Value::Number(number) => number.to_string(),
        Value::Bool(truth) => truth.to_string(),
        Value::Null | Value::Array(_) | Value::Object(_) => String::new(),
    }
}

/// Texts of a list, or of a single leaf, without empty ones.
fn texts(value: &Value) -> Vec<String> {
    let all = if value.is_array() { list(value).map(text_of).collect() } else { vec![text_of(value)] };
    all.into_iter().filter(|text| !text.trim().is_empty()).collect()
}

fn trimmed(value: &Value) -> String {
    text_of(value).trim().to_owned()
}

fn is_active(page: &Value) -> bool {
    text_of(&page["Active"]) != "false"
}

fn description(page: &Value) -> DescriptionPage {
    let is_external = text_of(&page["External"]) == "true";
    DescriptionPage {
        title: text_of(&page["Title"]),
        locale: text_of(&page["Locale"]),
        html: if is_external { String::new() } else { text_of(&page["Code"]) },
        is_external,
    }
}

fn variables(page: &Value) -> VariablePage {
    let variable = |value: &Value| Variable {
        name: trimmed(&value["Name"]),
        value: trimmed(&value["Value"]),
        kind: trimmed(&value["Type"]),
        dimension: trimmed(&value["Dimension"]),
        comment: trimmed(&value["Comment"]),
    };
    VariablePage {
        name: text_of(&page["Name"]),
        is_active: is_active(page),
        variables: list(&page["Variables"]).map(variable).collect(),
    }
}

fn code(page: &Value) -> CodePage {
    let code = text_of(&page["Code"]);
    let code = code.strip_prefix('\n').unwrap_or(&code).trim_end().to_owned();
    CodePage { name: text_of(&page["Name"]), is_active: is_active(page), code }
}

fn evolution(page: &Value) -> EvolutionPage {
    if text_of(&page["Type"]) != "ODE_EDITOR" {
        return EvolutionPage::Code(code(page));
    }
    let event = |event: &Value| Event {
        name: text_of(&event["Name"]),
        is_active: is_active(event),
        kind: text_of(&event["EventType"]),
        condition: text_of(&event["ZeroCondition"]),
        action: text_of(&event["Action"]),
    };
    let rate = |rate: &Value| (trimmed(&rate["state"]), trimmed(&rate["rate"]));
    EvolutionPage::Equations(Equations {
        name: text_of(&page["Name"]),
        is_active: is_active(page),
        preliminary: text_of(&page["PreliminaryCode"]["Code"]).trim_end().to_owned(),
        independent: trimmed(&page["IndependentVariable"]),
        increment: trimmed(&page["Increment"]),
        rates: list(&page["Equations"]).map(rate).filter(|(state, _)| !state.is_empty()).collect(),
        method: trimmed(&page["Method"]),
        internal_step: trimmed(&page["InternalStep"]),
        events: list(&page["Events"]["pages"]).map(event).collect(),
        has_extras: list(&page["Discontinuities"]["pages"]).next().is_some() || !trimmed(&page["DelayList"]).is_empty(),
    })
}

/// Appends the elements of a tree, each before those inside it.
fn collect(tree: &Value, parent: Option<usize>, elements: &mut Vec<Element>) {
    for node in list(tree) {
        let index = elements.len();
        let property = |property: &Value| (text_of(&property["name"]), text_of(&property["value"]));
        elements.push(Element {
            kind: text_of(&node["Type"]).rsplit('.').next().unwrap_or_default().to_owned(),
            name: text_of(&node["Name"]),
            parent,
            properties: list(&node["Properties"]).map(property).collect(),
        });
        collect(&node["Children"], Some(index), elements);
    }
}
