//! The format `.ejss`. Many files are no well-formed XML, so elements are found by their names; entities are not expanded.

use crate::refusal::Refusal;
use crate::simulation::{
    CodePage, DescriptionPage, Element, Equations, Event, EvolutionPage, Simulation, Variable, VariablePage,
};
use std::collections::BTreeMap;

/// The simulation of a text.
///
/// # Errors
/// The text is no simulation, or ends early.
pub(super) fn read(text: &str) -> Result<Simulation, Refusal> {
    let Some(start) = text.find("<Osejs") else {
        let lower: String = text.chars().take(4000).collect::<String>().to_ascii_lowercase();
        return Err(if lower.contains("<html") || lower.contains("<!doctype") {
            Refusal::ExportedPage
        } else {
            Refusal::Unknown
        });
    };
    let text = text.get(start..).unwrap_or_default();
    let head = text.split('>').next().unwrap_or_default();
    let is_protected = |text: &str| !text.trim().is_empty();
    if attribute(head, "password").is_some_and(is_protected) || is_protected(&first(text, "ExecPassword")) {
        return Err(Refusal::Protected);
    }
    if !text.contains("</Osejs>") {
        return Err(Refusal::Broken);
    }
    let model = inside(text, "Osejs.Model").unwrap_or_default();
    let information = inside(text, "Osejs.Information").unwrap_or_default();
    let equations = |page: &str| match first(page, "Type").as_str() {
        "ODE_EDITOR" => EvolutionPage::Equations(equations(page)),
        _ => EvolutionPage::Code(code(page)),
    };
    let views: Vec<&str> = each(text, "Osejs.HtmlView.Page").filter(|page| is_active(page)).collect();
    let codes = |section: &str| {
        let page = format!("{section}.Page");
        inside(model, section).map(|pages| each(pages, &page).map(code).collect()).unwrap_or_default()
    };
    Ok(Simulation {
        title: first(information, "Title"),
        authors: Some(first(information, "Author")).filter(|author| !author.trim().is_empty()).into_iter().collect(),
        summary: first(information, "Abstract"),
        description: description(text),
        frames_per_second: first(model, "Osejs.Model.FramesPerSecond"),
        steps_per_display: first(model, "Osejs.Model.StepsPerDisplay"),
        variables: each(model, "Osejs.Model.Variables.Page").map(variables).collect(),
        initialization: codes("Osejs.Model.Initialization"),
        evolution: each(model, "Osejs.Model.Evolution.Page").map(equations).collect(),
        fixed_relations: codes("Osejs.Model.Constraints"),
        custom: codes("Osejs.Model.Library"),
        model_elements: inside(model, "Osejs.Model.Elements")
            .map(|elements| each(elements, "Classname").map(|class| content(class).to_owned()).collect())
            .unwrap_or_default(),
        view: views.first().map(|view| elements(view)).unwrap_or_default(),
        further_views: views.len().saturating_sub(1),
    })
}

fn is_active(page: &str) -> bool {
    first(page, "Active") != "false"
}

fn variables(page: &str) -> VariablePage {
    let variable = |text: &str| Variable {
        name: first(text, "Name"),
        value: first(text, "Value"),
        kind: first(text, "Type"),
        dimension: first(text, "Dimension"),
        comment: first(text, "Comment"),
    };
    VariablePage {
        name: first(page, "Name"),
        is_active: is_active(page),
        variables: each(page, "Variable").map(variable).collect(),
    }
}

fn code(page: &str) -> CodePage {
    CodePage { name: first(page, "Name"), is_active: is_active(page), code: raw(page, "Code") }
}

fn equations(page: &str) -> Equations {
    let event = |text: &str| Event {
        name: first(text, "Name"),
        is_active: is_active(text),
        kind: first(text, "EventType"),
        condition: raw(text, "ZeroCondition"),
        action: raw(text, "Action"),
    };
    let filled = |tag: &str| inside(page, tag).is_some_and(|inner| !inner.trim().is_empty());
    // The names of events stand before the rest of the page; the page's own name comes first.
    let events = inside(page, "Events").unwrap_or_default();
    let behind = page.find("</Events>").and_then(|at| page.get(at..)).unwrap_or(page);
    Equations {
        name: first(page, "Name"),
        is_active: is_active(page),
        preliminary: inside(page, "PreliminaryCode").map(|inner| raw(inner, "Code")).unwrap_or_default(),
        independent: first(behind, "IndependentVariable"),
        increment: first(behind, "Increment"),
        rates: rates(behind),
        method: first(behind, "Method"),
        internal_step: first(behind, "InternalStep"),
        events: each(events, "Event.Page").map(event).collect(),
        has_extras: filled("Discontinuities") || filled("DelayList"),
    }
}

fn rates(page: &str) -> Vec<(String, String)> {
    page.split("<Rate ")
        .skip(1)
        .filter_map(|rate| {
            let (head, rest) = rate.split_once('>')?;
            let state = attribute(head, "state")?;
            let end = end_of(rest, "Rate")?;
            Some((state.trim().to_owned(), plain(rest.get(..end)?).trim().to_owned()))
        })
        .filter(|(state, _)| !state.is_empty())
        .collect()
}

fn description(text: &str) -> Vec<DescriptionPage> {
    let mut pages = Vec::new();
    for page in each(text, "Osejs.Description.Page").filter(|page| is_active(page)) {
        for sheet in each(page, "OneHTMLPage") {
            let is_external = first(sheet, "External") == "true";
            let body =
                sheet.find("</External>").map_or(sheet, |at| sheet.get(at + "</External>".len()..).unwrap_or_default());
            pages.push(DescriptionPage {
                title: first(sheet, "Title"),
                locale: first(sheet, "Locale"),
                html: if is_external { String::new() } else { content(body).to_owned() },
                is_external,
            });
        }
    }
    pages
}

fn elements(view: &str) -> Vec<Element> {
    let mut elements: Vec<Element> = Vec::new();
    let mut names = BTreeMap::new();
    let mut parents = Vec::new();
    for text in each(view, "HtmlView.Element") {
        let kind = first(text, "Type");
        let name = first(text, "Name");
        names.entry(name.clone()).or_insert(elements.len());
        parents.push(first(text, "Parent"));
        elements.push(Element {
            kind: kind.rsplit('.').next().unwrap_or_default().to_owned(),
            name,
            parent: None,
            properties: properties(text),
        });
    }
    for (element, parent) in elements.iter_mut().zip(parents) {
        element.parent = names.get(&parent).copied().filter(|_| !parent.is_empty());
    }
    elements
}

fn properties(element: &str) -> Vec<(String, String)> {
    element
        .split("<Property ")
        .skip(1)
        .filter_map(|property| {
            let (head, rest) = property.split_once('>')?;
            let end = end_of(rest, "Property")?;
            Some((attribute(head, "name")?.to_owned(), plain(rest.get(..end)?).to_owned()))
        })
        .collect()
}

/// Value of an attribute in the head of an element.
fn attribute<'a>(head: &'a str, name: &str) -> Option<&'a str> {
    let (_, rest) = head.split_once(&format!("{name}=\""))?;
    rest.split('"').next()
}

/// Contents of all elements of this name, in their order.
fn each<'a>(text: &'a str, tag: &'a str) -> impl Iterator<Item = &'a str> {
    let mut rest = text;
    std::iter::from_fn(move || {
        let (inner, after) = next(rest, tag)?;
        rest = after;
        Some(inner)
    })
}

/// Content of the next element of this name, and the text after it.
fn next<'a>(text: &'a str, tag: &str) -> Option<(&'a str, &'a str)> {
    let open = format!("<{tag}");
    let mut from = 0;
    loop {
        let at = from + text.get(from..)?.find(&open)? + open.len();
        from = at;
        let rest = text.get(at..)?;
        if !rest.starts_with(['>', ' ', '\n', '\r', '\t', '/']) {
            continue;
        }
        let (head, inner) = rest.split_once('>')?;
        if head.ends_with('/') {
            return Some(("", inner));
        }
        let end = end_of(inner, tag)?;
        let after = inner.get(end..)?.split_once('>').map_or("", |(_, after)| after);
        return Some((inner.get(..end)?, after));
    }
}

/// Where an element ends whose content begins `text`. A content that begins with CDATA ends at `]]>` before the closing tag:
/// `]]>` alone may stand inside.
fn end_of(text: &str, tag: &str) -> Option<usize> {
    let close = format!("</{tag}>");
    if text.trim_start().starts_with("<![CDATA[") {
        let mut from = 0;
        while let Some(at) = text.get(from..)?.find(&close).map(|at| from + at) {
            if text.get(..at)?.trim_end().ends_with("]]>") {
                return Some(at);
            }
            from = at + close.len();
        }
        return None;
    }
    text.find(&close)
}

fn inside<'a>(text: &'a str, tag: &str) -> Option<&'a str> {
    next(text, tag).map(|(inner, _)| inner)
}

/// Content of the first element of this name, without its CDATA and blanks around it; empty if there is none.
fn first(text: &str, tag: &str) -> String {
    inside(text, tag).map(|inner| plain(inner).trim().to_owned()).unwrap_or_default()
}

/// Content of the first element of this name with its line ends, but for the one that EJS writes behind the start of CDATA.
fn raw(text: &str, tag: &str) -> String {
    let code = inside(text, tag).map(plain).unwrap_or_default().replace("\r\n", "\n").replace('\r', "\n");
    code.strip_prefix('\n').unwrap_or(&code).trim_end().to_owned()
}

/// Text without its CDATA.
fn plain(text: &str) -> &str {
    if text.trim_start().starts_with("<![CDATA[") { content(text) } else { text }
}

/// Text between the first `<![CDATA[` and the last `]]>`; the whole text without them.
fn content(text: &str) -> &str {
    let start = text.find("<![CDATA[").map_or(0, |at| at + "<![CDATA[".len());
    let rest = text.get(start..).unwrap_or_default();
    rest.get(..rest.rfind("]]>").unwrap_or(rest.len())).unwrap_or_default()
}
