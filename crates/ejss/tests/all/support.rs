//! Simulations for the tests: a short text for each, from which the formats of EJS and WebEJS are made.
//!
//! A text has lines `title ..`, `author ..`, then pages that begin with a line `page KIND NAME`; `page!` is not active. Cells are
//! divided by `¦`, a line end in a property is `⏎`.

use ejss::{Imported, Refusal};
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::path::PathBuf;

/// Simulation as its text says.
#[derive(Clone, Debug, Default)]
pub struct Simulation {
    pub title: String,
    pub author: String,
    pub summary: String,
    pub frames: String,
    pub steps: String,
    pub pages: Vec<Page>,
}

/// Page of a simulation.
#[derive(Clone, Debug, Default)]
pub struct Page {
    pub kind: String,
    pub name: String,
    pub is_active: bool,
    pub lines: Vec<String>,
}

/// All simulations of the folder, by the names of their files.
pub fn simulations() -> Vec<(String, Simulation)> {
    let folder = folder("simulations");
    let entries = std::fs::read_dir(&folder).expect("the folder").map(|entry| entry.expect("a file").path());
    let mut texts: Vec<PathBuf> =
        entries.filter(|path| path.extension().is_some_and(|ending| ending == "txt")).collect();
    texts.sort();
    let read = |path: &PathBuf| {
        let name = path.file_stem().and_then(|stem| stem.to_str()).expect("a name").to_owned();
        (name, Simulation::read(&std::fs::read_to_string(path).expect("a text")))
    };
    texts.iter().map(read).collect()
}

/// File or folder beside the tests.
pub fn folder(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests").join(name)
}

/// Imports a file, checked by the document's own rules.
pub fn import(bytes: &[u8]) -> Result<Imported, Refusal> {
    ejss::import(bytes, &mut |text| {
        document::open(text, &[]).first_error().map_or(Ok(()), |error| Err(error.message.english()))
    })
}

impl Simulation {
    pub fn read(text: &str) -> Self {
        let mut simulation = Self::default();
        for line in text.lines() {
            let (word, rest) = line.split_once(' ').unwrap_or((line, ""));
            match (word, simulation.pages.last_mut()) {
                ("page" | "page!", _) => {
                    let (kind, name) = rest.split_once(' ').unwrap_or((rest, ""));
                    let page = Page {
                        kind: kind.to_owned(),
                        name: name.to_owned(),
                        is_active: word == "page",
                        lines: Vec::new(),
                    };
                    simulation.pages.push(page);
                }
                (_, Some(page)) => page.lines.push(line.to_owned()),
                ("title", None) => rest.clone_into(&mut simulation.title),
                ("author", None) => rest.clone_into(&mut simulation.author),
                ("abstract", None) => rest.clone_into(&mut simulation.summary),
                ("fps", None) => rest.clone_into(&mut simulation.frames),
                ("spd", None) => rest.clone_into(&mut simulation.steps),
                ("#", None) => {}
                (_, None) => panic!("{line}"),
            }
        }
        simulation
    }

    fn of(&self, kind: &str) -> impl Iterator<Item = &Page> {
        self.pages.iter().filter(move |page| page.kind == kind)
    }

    /// Time and values that the document must reach.
    pub fn expected(&self) -> Option<(f64, Vec<(String, f64)>)> {
        let page = self.of("expected").next()?;
        let values = page.lines.iter().filter_map(|line| line.split_once(" = "));
        let values = values.map(|(name, value)| (name.to_owned(), value.parse().expect("a number")));
        Some((page.name.parse().expect("a time"), values.collect()))
    }

    /// The format `.ejss`.
    pub fn ejss(&self) -> String {
        let mut text = format!(
            "<?xml version=\"1.0\" encoding=\"UTF-16\"?>\n<Osejs version=\"6.0\" password=\"\">\n<Osejs.Information>\n<Title>{}</Title>\n<Abstract>{}</Abstract>\n<Author>{}</Author>\n</Osejs.Information>\n<Osejs.Description>\n",
            data(&self.title),
            data(&self.summary),
            data(&self.author)
        );
        for page in self.of("description") {
            let (is_external, html) = page.html();
            let _ = write!(
                text,
                "<Osejs.Description.Page>\n<Active>{}</Active>\n<OneHTMLPage>\n<Locale>_default_</Locale>\n<Title>{}</Title>\n<External>{is_external}</External>\n<![CDATA[\n{html}\n]]>\n</OneHTMLPage>\n</Osejs.Description.Page>\n",
                page.is_active, page.name
            );
        }
        let _ = write!(
            text,
            "</Osejs.Description>\n<Osejs.Model>\n<Osejs.Model.FramesPerSecond>{}</Osejs.Model.FramesPerSecond>\n<Osejs.Model.StepsPerDisplay>{}</Osejs.Model.StepsPerDisplay>\n<Osejs.Model.Variables>\n",
            self.frames, self.steps
        );
        for page in self.of("variables") {
            let _ = write!(
                text,
                "<Osejs.Model.Variables.Page>\n<Name>{}</Name>\n<Active>{}</Active>\n",
                page.name, page.is_active
            );
            for cells in page.cells() {
                let [name, value, kind, dimension, comment] = cells.map(|cell| data(&cell));
                let _ = write!(
                    text,
                    "<Variable>\n<Name>{name}</Name>\n<Value>{value}</Value>\n<Type>{kind}</Type>\n<Dimension>{dimension}</Dimension>\n<Comment>{comment}</Comment>\n</Variable>\n"
                );
            }
            text.push_str("</Osejs.Model.Variables.Page>\n");
        }
        text.push_str("</Osejs.Model.Variables>\n");
        self.codes(&mut text, "initialization", "Osejs.Model.Initialization");
        text.push_str("<Osejs.Model.Evolution>\n");
        let mut pages = self.pages.iter().peekable();
        while let Some(page) = pages.next() {
            match page.kind.as_str() {
                "code" => code(&mut text, page, "Osejs.Model.Evolution"),
                "ode" => {
                    let mut inside = Vec::new();
                    while let Some(next) = pages.next_if(|next| next.kind == "preliminary" || next.kind == "event") {
                        inside.push(next);
                    }
                    equations(&mut text, page, &inside);
                }
                _ => {}
            }
        }
        text.push_str("</Osejs.Model.Evolution>\n");
        self.codes(&mut text, "fixed", "Osejs.Model.Constraints");
        self.codes(&mut text, "custom", "Osejs.Model.Library");
        text.push_str("</Osejs.Model>\n<Osejs.HtmlView>\n<Osejs.HtmlView.Page>\n<Active>true</Active>\n<Tree>\n");
        for element in self.elements() {
            let _ = write!(
                text,
                "<HtmlView.Element>\n<Type>Elements.{}</Type>\n<Name>{}</Name>\n",
                element.kind,
                data(&element.name)
            );
            if let Some(parent) = &element.parent {
                let _ = writeln!(text, "<Parent>{}</Parent>", data(parent));
            }
            for (name, value) in &element.properties {
                let _ = writeln!(text, "<Property name=\"{name}\">{}</Property>", data(value));
            }
            text.push_str("</HtmlView.Element>\n");
        }
        text.push_str("</Tree>\n</Osejs.HtmlView.Page>\n</Osejs.HtmlView>\n</Osejs>\n");
        text
    }

    fn codes(&self, text: &mut String, kind: &str, section: &str) {
        let _ = writeln!(text, "<{section}>");
        self.of(kind).for_each(|page| code(text, page, section));
        let _ = writeln!(text, "</{section}>");
    }

    /// The format `_source.json`.
    pub fn json(&self) -> String {
        let codes = |kind: &str| self.of(kind).map(Page::json).collect::<Vec<Value>>();
        let mut evolution = Vec::new();
        let mut pages = self.pages.iter().peekable();
        while let Some(page) = pages.next() {
            match page.kind.as_str() {
                "code" => evolution.push(page.json()),
                "ode" => {
                    let mut inside = Vec::new();
                    while let Some(next) = pages.next_if(|next| next.kind == "preliminary" || next.kind == "event") {
                        inside.push(next);
                    }
                    evolution.push(page.equations_json(&inside));
                }
                _ => {}
            }
        }
        let variables = self.of("variables").map(|page| {
            let rows = page.cells().map(|[name, value, kind, dimension, comment]| {
                json!({"Name": name, "Value": value, "Type": kind, "Dimension": dimension, "Comment": comment, "Domain": "public"})
            });
            json!({"Name": page.name, "Active": page.is_active.to_string(), "Variables": rows.collect::<Vec<Value>>()})
        });
        let description = self.of("description").map(|page| {
            let (is_external, html) = page.html();
            json!({"Name": page.name, "Title": page.name, "Active": page.is_active.to_string(), "Locale": "_default_",
                "External": is_external.to_string(), "Code": html})
        });
        let elements = self.elements();
        let whole = json!({
            "information": {"Title": self.title, "Author": [self.author], "Abstract": self.summary},
            "description": {"pages": description.collect::<Vec<Value>>()},
            "model": {
                "variables": {"pages": variables.collect::<Vec<Value>>()},
                "initialization": {"pages": codes("initialization")},
                "evolution": {"information": {"FPS": self.frames, "SPD": self.steps}, "pages": evolution},
                "fixed_relations": {"pages": codes("fixed")},
                "custom": {"pages": codes("custom")},
                "elements": {"list": []},
            },
            "view": {"RootProperties": [], "Tree": tree(&elements, None)},
        });
        format!("{whole:#}")
    }

    fn elements(&self) -> Vec<Element> {
        let mut elements: Vec<Element> = Vec::new();
        for line in self.of("view").flat_map(|page| &page.lines) {
            match (line.strip_prefix("  "), elements.last_mut()) {
                (Some(property), Some(element)) => {
                    let (name, value) = property.split_once(" = ").unwrap_or((property.trim_end_matches(" ="), ""));
                    element.properties.push((name.to_owned(), value.replace('⏎', "\n")));
                }
                _ => {
                    let (own, parent) =
                        line.split_once(" < ").map_or((line.as_str(), None), |(own, parent)| (own, Some(parent)));
                    let (kind, name) = own.split_once(' ').unwrap_or((own, ""));
                    let parent = parent.map(str::to_owned);
                    elements.push(Element {
                        kind: kind.to_owned(),
                        name: name.to_owned(),
                        parent,
                        properties: Vec::new(),
                    });
                }
            }
        }
        elements
    }
}

/// Element of the view.
struct Element {
    kind: String,
    name: String,
    parent: Option<String>,
    properties: Vec<(String, String)>,
}

fn tree(elements: &[Element], parent: Option<&str>) -> Vec<Value> {
    let inside = elements.iter().filter(|element| element.parent.as_deref() == parent);
    let node = |element: &Element| {
        let properties: Vec<Value> =
            element.properties.iter().map(|(name, value)| json!({"name": name, "value": value})).collect();
        json!({"Type": element.kind, "Name": element.name, "Properties": properties, "Children": tree(elements, Some(&element.name))})
    };
    inside.map(node).collect()
}

impl Page {
    fn code(&self) -> String {
        self.lines.join("\n")
    }

    fn html(&self) -> (bool, String) {
        let html = self.code();
        if html == "(external)" { (true, String::new()) } else { (false, html) }
    }

    fn cells(&self) -> impl Iterator<Item = [String; 5]> {
        self.lines.iter().filter(|line| line.contains('¦')).map(|line| {
            let cells: Vec<String> = line.split('¦').map(|cell| cell.trim().to_owned()).collect();
            cells.try_into().expect("five cells")
        })
    }

    fn json(&self) -> Value {
        json!({"Name": self.name, "Active": self.is_active.to_string(), "Type": "CODE_EDITOR", "Code": self.code()})
    }

    fn entry(&self, word: &str) -> String {
        let line = self.lines.iter().find_map(|line| line.strip_prefix(word)?.strip_prefix(' '));
        line.unwrap_or_default().to_owned()
    }

    fn rates(&self) -> impl Iterator<Item = (&str, &str)> {
        self.lines.iter().filter_map(|line| line.strip_prefix("rate ")?.split_once(" ¦ "))
    }

    /// Name, type, condition and action of an event.
    fn event(&self) -> [String; 4] {
        let (name, kind) = self.name.rsplit_once(" (").expect("a type");
        let code = format!("{}\n", self.code());
        let (condition, action) = code.split_once("%%\n").expect("a condition and an action");
        [name, kind.trim_end_matches(')'), condition.trim_end(), action.trim_end()].map(str::to_owned)
    }

    fn equations_json(&self, inside: &[&Self]) -> Value {
        let preliminary =
            inside.iter().find(|page| page.kind == "preliminary").map(|page| page.code()).unwrap_or_default();
        let events = inside.iter().filter(|page| page.kind == "event").map(|page| {
            let [name, kind, condition, action] = page.event();
            json!({"Name": name, "Active": page.is_active.to_string(), "EventType": kind, "ZeroCondition": condition, "Action": action})
        });
        let rates = self.rates().map(|(state, rate)| json!({"state": state, "rate": rate}));
        json!({
            "Type": "ODE_EDITOR", "Name": self.name, "Active": self.is_active.to_string(),
            "IndependentVariable": self.entry("independent"), "Increment": self.entry("increment"), "Method": self.entry("method"),
            "InternalStep": self.entry("internal-step"), "Equations": rates.collect::<Vec<Value>>(),
            "PreliminaryCode": {"Code": preliminary, "Comment": ""}, "Events": {"pages": events.collect::<Vec<Value>>()},
        })
    }
}

fn code(text: &mut String, page: &Page, section: &str) {
    let _ = write!(
        text,
        "<{section}.Page>\n<Type>CODE_EDITOR</Type>\n<Name>{}</Name>\n<Active>{}</Active>\n<Code><![CDATA[\n{}\n]]></Code>\n</{section}.Page>\n",
        page.name,
        page.is_active,
        page.code()
    );
}

fn equations(text: &mut String, page: &Page, inside: &[&Page]) {
    let preliminary = inside.iter().find(|page| page.kind == "preliminary").map(|page| page.code()).unwrap_or_default();
    let _ = write!(
        text,
        "<Osejs.Model.Evolution.Page>\n<Type>ODE_EDITOR</Type>\n<Name>{}</Name>\n<Active>{}</Active>\n<PreliminaryCode>\n<Code><![CDATA[\n{preliminary}\n]]></Code>\n</PreliminaryCode>\n<Events>\n",
        page.name, page.is_active
    );
    for event in inside.iter().filter(|page| page.kind == "event") {
        let [name, kind, condition, action] = event.event();
        let _ = write!(
            text,
            "<Event.Page>\n<Name>{name}</Name>\n<Active>{}</Active>\n<EventType>{kind}</EventType>\n<ZeroCondition><![CDATA[\n{condition}\n]]></ZeroCondition>\n<Action><![CDATA[\n{action}\n]]></Action>\n</Event.Page>\n",
            event.is_active
        );
    }
    let _ = write!(
        text,
        "</Events>\n<IndependentVariable>{}</IndependentVariable>\n<Increment>{}</Increment>\n",
        page.entry("independent"),
        page.entry("increment")
    );
    for (state, rate) in page.rates() {
        let _ = writeln!(text, "<Rate state=\"{state}\">{}</Rate>", data(rate));
    }
    let _ = write!(
        text,
        "<Rate state=\"\"></Rate>\n<Method>{}</Method>\n<InternalStep>{}</InternalStep>\n</Osejs.Model.Evolution.Page>\n",
        page.entry("method"),
        page.entry("internal-step")
    );
}

fn data(text: &str) -> String {
    format!("<![CDATA[{text}]]>")
}

/// UTF-16 with its mark, as EJS writes it.
pub fn utf16(text: &str, is_big_endian: bool) -> Vec<u8> {
    let units = std::iter::once(0xfeff).chain(text.encode_utf16());
    units.flat_map(|unit: u16| if is_big_endian { unit.to_be_bytes() } else { unit.to_le_bytes() }).collect()
}
