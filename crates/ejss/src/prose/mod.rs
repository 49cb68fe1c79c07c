//! HTML of descriptions and labels as Markdown and plain text. Of the HTML only what has a counterpart remains: no script, no
//! style, no attribute but the addresses of links and pictures.

mod entities;
mod language;
mod lines;
mod tags;

pub(crate) use language::language_of;
pub(crate) use lines::{code, cut, escaped, visible, wrapped};

use tags::{Piece, pieces};

/// Longest address of a link, in characters.
const LONGEST_ADDRESS: usize = 120;

/// HTML or text without markup, on one line.
pub(crate) fn plain_text(html: &str) -> String {
    let mut text = String::new();
    for piece in pieces(html) {
        match piece {
            Piece::Text(part) => text.push_str(&part),
            Piece::Open(..) | Piece::Close(_) => {
                if let Piece::Open(name, _) = &piece
                    && matches!(name.as_str(), "br" | "p" | "div" | "li" | "td")
                {
                    text.push(' ');
                }
            }
        }
    }
    visible(&text).split_whitespace().collect::<Vec<_>>().join(" ")
}

/// HTML as Markdown. `picture`: address of an image for the one in the page; `None` leaves it out. `title`: a heading with this
/// text is left out. Returns the number of pictures that were left out.
pub(crate) fn markdown(html: &str, title: &str, picture: &dyn Fn(&str) -> Option<String>) -> (String, usize) {
    let mut writer = Writer { title: title.to_owned(), ..Writer::default() };
    for piece in pieces(html) {
        match piece {
            Piece::Text(text) => writer.text(&text),
            Piece::Open(name, attributes) => writer.open(&name, &attributes, picture),
            Piece::Close(name) => writer.close(&name),
        }
    }
    writer.end_block();
    (writer.blocks.join("\n\n"), writer.lost)
}

#[derive(Default)]
struct Writer {
    blocks: Vec<String>,
    /// Inline Markdown of the block that is being written.
    line: String,
    title: String,
    heading: usize,
    /// Open lists: the number of the next item, or 0 for one without numbers.
    lists: Vec<usize>,
    is_item: bool,
    is_code: bool,
    links: Vec<Option<String>>,
    /// Open emphases.
    marks: Vec<&'static str>,
    row: Vec<String>,
    rows: Vec<Vec<String>>,
    tables: usize,
    lost: usize,
}

impl Writer {
    fn text(&mut self, text: &str) {
        if self.is_code {
            self.line.push_str(text);
            return;
        }
        let starts = text.starts_with(char::is_whitespace);
        if starts && !self.line.is_empty() && !self.line.ends_with([' ', '\n']) {
            self.line.push(' ');
        }
        let words: Vec<&str> = text.split_whitespace().collect();
        self.line.push_str(&escaped(&words.join(" ")));
        if text.ends_with(char::is_whitespace) && !words.is_empty() {
            self.line.push(' ');
        }
    }

    fn open(&mut self, name: &str, attributes: &[(String, String)], picture: &dyn Fn(&str) -> Option<String>) {
        let attribute = |name: &str| attributes.iter().find(|(own, _)| own == name).map(|(_, value)| value.as_str());
        match name {
            "h1" | "h2" | "h3" | "h4" | "h5" | "h6" => {
                self.end_block();
                self.heading = name[1..].parse::<usize>().unwrap_or(2).max(2);
            }
            "p" | "div" | "section" | "article" | "center" | "blockquote" | "hr" | "body" | "form" | "header"
            | "footer" => {
                self.end_paragraph();
            }
            "br" if self.tables == 0 => self.end_paragraph(),
            "br" => self.line.push(' '),
            "ul" | "ol" => {
                self.end_block();
                self.lists.push(usize::from(name == "ol"));
            }
            "li" => {
                self.end_block();
                self.is_item = true;
            }
            "pre" => {
                self.end_block();
                self.is_code = true;
            }
            "i" | "em" | "var" => self.mark("*"),
            "b" | "strong" => self.mark("**"),
            "sub" if !self.is_code => self.line.push('_'),
            "sup" if !self.is_code => self.line.push('^'),
            "a" => {
                let address = attribute("href").map(str::trim).filter(|address| is_harmless(address));
                if address.is_some() {
                    self.line.push('[');
                }
                self.links.push(address.map(str::to_owned));
            }
            "img" => {
                let source = attribute("src").unwrap_or_default();
                match picture(source) {
                    Some(address) => {
                        let alternative = escaped(&plain_text(attribute("alt").unwrap_or_default()));
                        self.end_paragraph();
                        self.blocks.push(format!("![{alternative}]({address})"));
                    }
                    None => self.lost += 1,
                }
            }
            "table" => {
                self.end_block();
                self.tables += 1;
            }
            _ => {}
        }
    }

    fn close(&mut self, name: &str) {
        match name {
            "h1" | "h2" | "h3" | "h4" | "h5" | "h6" | "li" | "pre" => self.end_block(),
            "p" | "div" | "section" | "article" | "center" | "blockquote" => self.end_paragraph(),
            "ul" | "ol" => {
                self.end_block();
                self.lists.pop();
            }
            "i" | "em" | "var" => self.unmark("*"),
            "b" | "strong" => self.unmark("**"),
            "a" => {
                if let Some(Some(address)) = self.links.pop() {
                    if self.line.ends_with('[') {
                        self.line.pop();
                    } else {
                        self.line.push_str(&format!("]({address})"));
                    }
                }
            }
            "td" | "th" if self.tables > 0 => {
                let cell = std::mem::take(&mut self.line).trim().replace('|', "\\|");
                self.marks.clear();
                self.row.push(cell);
            }
            "tr" if self.tables > 0 => {
                let row = std::mem::take(&mut self.row);
                if row.iter().any(|cell| !cell.is_empty()) {
                    self.rows.push(row);
                }
            }
            "table" if self.tables > 0 => {
                self.tables -= 1;
                if self.tables == 0 {
                    self.end_table();
                }
            }
            _ => {}
        }
    }

    fn mark(&mut self, mark: &'static str) {
        if !self.is_code && !self.marks.contains(&mark) {
            self.marks.push(mark);
            self.line.push_str(mark);
        }
    }

    fn unmark(&mut self, mark: &'static str) {
        let Some(at) = self.marks.iter().rposition(|own| *own == mark) else { return };
        self.marks.remove(at);
        // Emphasis does not end behind a blank, and around nothing it is none.
        let blank = if self.line.ends_with(' ') { " " } else { "" };
        self.line.truncate(self.line.trim_end().len());
        if self.line.ends_with(mark) {
            self.line.truncate(self.line.len() - mark.len());
        } else {
            self.line.push_str(mark);
        }
        self.line.push_str(blank);
    }

    /// A paragraph ends; inside an item or a cell the text goes on.
    fn end_paragraph(&mut self) {
        if self.tables > 0 || self.is_item || self.is_code || self.heading > 0 {
            if !self.line.is_empty() && !self.line.ends_with(' ') {
                self.line.push(if self.is_code { '\n' } else { ' ' });
            }
        } else {
            self.end_block();
        }
    }

    fn end_block(&mut self) {
        if self.tables > 0 {
            return;
        }
        for mark in std::mem::take(&mut self.marks).into_iter().rev() {
            self.marks.push(mark);
            self.unmark(mark);
        }
        for link in std::mem::take(&mut self.links).into_iter().flatten() {
            self.line.push_str(&format!("]({link})"));
        }
        let line = std::mem::take(&mut self.line);
        let text = line.trim();
        let (heading, is_item, is_code) =
            (std::mem::take(&mut self.heading), std::mem::take(&mut self.is_item), std::mem::take(&mut self.is_code));
        if text.is_empty() {
            return;
        }
        if is_code {
            self.blocks.push(lines::code("text", line.trim_matches('\n')));
        } else if heading > 0 {
            let text = text.replace('*', "");
            if !plain_text(&text).replace('\\', "").eq_ignore_ascii_case(&self.title) {
                self.blocks.push(format!("{} {}", "#".repeat(heading), lines::shortened(&text)));
            }
        } else if is_item && !self.lists.is_empty() {
            let indent = "  ".repeat(self.lists.len() - 1);
            let mark = match self.lists.last_mut() {
                Some(number) if *number > 0 => {
                    *number += 1;
                    format!("{}.", *number - 1)
                }
                _ => "-".to_owned(),
            };
            let text = wrapped(text).replace('\n', &format!("\n{indent}   "));
            let item = format!("{indent}{mark} {text}");
            match self.blocks.last_mut() {
                Some(last) if is_list(last) => {
                    last.push('\n');
                    last.push_str(&item);
                }
                _ => self.blocks.push(item),
            }
        } else {
            self.blocks.push(wrapped(text));
        }
    }

    fn end_table(&mut self) {
        let rows = std::mem::take(&mut self.rows);
        self.row.clear();
        let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
        let longest =
            rows.iter().map(|row| row.iter().map(|cell| cell.chars().count() + 3).sum::<usize>()).max().unwrap_or(0);
        // Tables that only place things, or with long lines, are read cell by cell.
        if columns < 2 || rows.len() < 2 || longest > 180 {
            for cell in rows.into_iter().flatten().filter(|cell| !cell.is_empty()) {
                self.blocks.push(wrapped(&cell));
            }
            return;
        }
        let mut lines = Vec::new();
        for (index, mut row) in rows.into_iter().enumerate() {
            row.resize(columns, String::new());
            lines.push(format!("| {} |", row.join(" | ")));
            if index == 0 {
                lines.push(format!("|{}", "---|".repeat(columns)));
            }
        }
        self.blocks.push(lines.join("\n"));
    }
}

/// True for an address that a document may lead to and that fits into a line.
fn is_harmless(address: &str) -> bool {
    let lower = address.to_ascii_lowercase();
    ["http://", "https://", "mailto:"].iter().any(|scheme| lower.starts_with(scheme))
        && address.chars().count() <= LONGEST_ADDRESS
        && address.chars().all(|letter| {
            letter.is_ascii_graphic() && !matches!(letter, '(' | ')' | '<' | '>' | '`' | '[' | ']' | '\\')
        })
}

fn is_list(block: &str) -> bool {
    let first = block.trim_start();
    first.starts_with("- ")
        || first
            .split_once(". ")
            .is_some_and(|(number, _)| !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit()))
}
