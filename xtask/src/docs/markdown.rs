//! A page of the documentation as HTML, with what search, list and links need of it.

use super::examples::Example;
use anyhow::{Context, Result};
use pulldown_cmark::{CodeBlockKind, CowStr, Event, HeadingLevel, Options, Parser, Tag, TagEnd, html};
use units::markup::escaped;

/// A part of a page, from a heading to the next.
#[derive(Debug)]
pub struct Section {
    pub level: u8,
    /// Id of the heading.
    pub id: String,
    pub heading: String,
    /// Its text, without code blocks of other languages.
    pub words: String,
}

/// A page.
#[derive(Debug)]
pub struct Page {
    /// Name of its file without ending.
    pub name: String,
    pub title: String,
    pub html: String,
    pub sections: Vec<Section>,
    /// Addresses of links and pictures as they stand in the HTML.
    pub links: Vec<String>,
    pub examples: Vec<Example>,
}

impl Page {
    /// Reads a page.
    ///
    /// # Errors
    /// It has no title, or an example that does not run.
    pub fn of(name: &str, text: &str) -> Result<Self> {
        let events: Vec<Event<'_>> = Parser::new_ext(text, Options::ENABLE_TABLES).collect();
        let mut page = Self {
            name: name.to_owned(),
            title: String::new(),
            html: String::new(),
            sections: Vec::new(),
            links: Vec::new(),
            examples: Vec::new(),
        };
        let model = first_model(&events);
        let mut written = Vec::new();
        let mut at = 0;
        while let Some(event) = events.get(at) {
            at += 1;
            match event {
                Event::Start(Tag::Heading { level, .. }) => {
                    let section = page.begin(*level, &plain(&events[at..]));
                    written.push(Event::Html(format!("<{level} id=\"{section}\">").into()));
                }
                Event::Start(Tag::CodeBlock(kind)) => {
                    let code = plain(&events[at..]);
                    let end = events[at..].iter().position(|event| matches!(event, Event::End(TagEnd::CodeBlock)));
                    at += end.map_or(0, |end| end + 1);
                    let kind = if let CodeBlockKind::Fenced(kind) = kind { kind } else { "" };
                    let is_wrong = matches!(events.get(at), Some(Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(kind)))) if kind.as_ref() == "text");
                    written.push(Event::Html(page.block(kind, &code, &model, is_wrong)?.into()));
                }
                // Marks of the guide are no part of the page.
                Event::Html(html) | Event::InlineHtml(html) if html.trim_start().starts_with("<!--") => {}
                Event::Start(Tag::Link { link_type, dest_url, title, id }) => {
                    let dest_url = page.link(dest_url);
                    let (link_type, title, id) = (*link_type, title.clone(), id.clone());
                    written.push(Event::Start(Tag::Link { link_type, dest_url, title, id }));
                }
                Event::Start(Tag::Image { dest_url, .. }) => {
                    page.links.push(dest_url.to_string());
                    written.push(event.clone());
                }
                Event::Text(words) | Event::Code(words) => {
                    page.say(words);
                    written.push(event.clone());
                }
                _ => written.push(event.clone()),
            }
        }
        html::push_html(&mut page.html, written.into_iter());
        if !model.is_empty() {
            page.html +=
                &format!("<script type=\"text/plain\" id=\"model\">{}</script>\n", model.replace("</", "<\\/"));
        }
        page.title = page.sections.first().map(|section| section.heading.clone()).context("a page without a title")?;
        Ok(page)
    }

    /// Begins a section and returns the id of its heading.
    fn begin(&mut self, level: HeadingLevel, heading: &str) -> String {
        let mut id = slug(heading);
        let same = self.sections.iter().filter(|section| slug(&section.heading) == id).count();
        if same > 0 {
            id = format!("{id}-{same}");
        }
        let (heading, words) = (heading.to_owned(), String::new());
        self.sections.push(Section { level: level as u8, id: id.clone(), heading, words });
        id
    }

    /// A code block: an example, or code.
    fn block(&mut self, kind: &str, code: &str, model: &str, is_wrong: bool) -> Result<String> {
        self.say(code);
        let name = format!("{}-{}", self.name, self.examples.len() + 1);
        // The parts of a tutorial's document belong to the document that the page arrives at.
        if let Some(example) = Example::of(name, kind, code, model, is_wrong)? {
            let html = example.html();
            self.examples.push(example);
            return Ok(html);
        }
        Ok(format!("<pre tabindex=\"0\"><code>{}</code></pre>\n", escaped(code)))
    }

    /// Address in the site of a link between pages.
    fn link<'a>(&mut self, to: &CowStr<'_>) -> CowStr<'a> {
        let (file, id) = to.split_once('#').map_or((to.as_ref(), None), |(file, id)| (file, Some(id)));
        let is_own = !file.contains("://");
        let file = file.strip_suffix(".md").filter(|_| is_own).map_or(file.to_owned(), |name| format!("{name}.html"));
        let link = id.map_or(file.clone(), |id| format!("{file}#{id}"));
        self.links.push(link.clone());
        link.into()
    }

    /// Adds words to the present section.
    fn say(&mut self, words: &str) {
        if let Some(section) = self.sections.last_mut() {
            section.words.push_str(words);
            section.words.push(' ');
        }
    }
}

/// The first model of a page, or else that of its last document.
fn first_model(events: &[Event<'_>]) -> String {
    let mut document = String::new();
    for (at, event) in events.iter().enumerate() {
        if let Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(kind))) = event {
            let code = || plain(&events[at + 1..]);
            match kind.as_ref() {
                "model" => return code(),
                "markdown" => document = code(),
                _ => {}
            }
        }
    }
    document.split("```").find_map(|part| part.strip_prefix("model\n")).unwrap_or_default().to_owned()
}

/// Text up to the end of the block that these events are in.
fn plain(events: &[Event<'_>]) -> String {
    let inside = events.iter().take_while(|event| !matches!(event, Event::End(TagEnd::Heading(_) | TagEnd::CodeBlock)));
    let words = inside.map(|event| match event {
        Event::Text(text) | Event::Code(text) => text.as_ref(),
        Event::SoftBreak => " ",
        _ => "",
    });
    words.collect()
}

/// Id of a heading, as GitHub makes it.
fn slug(heading: &str) -> String {
    let kept = heading.to_lowercase();
    let kept = kept.chars().filter(|letter| letter.is_alphanumeric() || matches!(letter, ' ' | '-' | '_'));
    kept.map(|letter| if letter == ' ' { '-' } else { letter }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_has_ids_addresses_and_examples() {
        let text = "# What *it* does, `x`\n\n<!-- guide -->\n[b](b.md#c) [d](https://x.org/a.md)\n\n```model\nx' = 1 [1/s]\nx(0) = 0\n```\n\n\
                    ```model\nx' = y\n```\n\n```text\nerror\n```\n\n```sh\nls <a>\n```\n";
        let page = Page::of("a", text).unwrap();
        assert!(
            page.html.starts_with("<h1 id=\"what-it-does-x\">What <em>it</em> does, <code>x</code></h1>"),
            "{}",
            page.html
        );
        assert_eq!(page.links, ["b.html#c", "https://x.org/a.md"]);
        assert_eq!(page.examples.len(), 2);
        assert_eq!(page.html.matches("<meniscus-simulation").count(), 1);
        assert!(page.html.contains("ls &lt;a&gt;") && !page.html.contains("guide"), "{}", page.html);
        assert!(Page::of("a", "# A\n\n```model\nx' = y\n```\n").is_err());
    }
}
