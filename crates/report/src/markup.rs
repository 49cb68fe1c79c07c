//! Elements of HTML.

use std::fmt::Display;

pub use units::markup::escaped;

/// Name of the model, or a name derived from it (`y'_offset`), as mathematical markup.
pub fn symbol(name: &str) -> String {
    let base = name.trim_end_matches('\'');
    let simple = base.starts_with(|c: char| c.is_ascii_alphabetic())
        && base.chars().all(|character| character.is_ascii_alphanumeric() || character == '_');
    if simple {
        units::mathml::typeset_name(name)
    } else {
        ["<i>", &escaped(&name.replace('\'', "′")), "</i>"].concat()
    }
}

/// Name as plain text for the axes of a figure: `ω0`, `y′`.
pub fn plain_symbol(name: &str) -> String {
    without_tags(&symbol(name)).replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&amp;", "&")
}

/// Text of markup without its tags; entities stay escaped.
fn without_tags(markup: &str) -> String {
    let mut out = String::new();
    let mut inside = false;
    for character in markup.chars() {
        match character {
            '<' => inside = true,
            '>' => inside = false,
            other if !inside => out.push(other),
            _ => {}
        }
    }
    out
}

/// Content of a page under construction.
#[derive(Default)]
pub struct Page {
    /// The markup so far.
    pub out: String,
}

impl Page {
    /// Appends markup unchanged.
    pub fn raw(&mut self, markup: &str) {
        self.out.push_str(markup);
    }

    /// Appends an element with text, which is escaped. `element` may have attributes: `p class="note"`.
    pub fn element(&mut self, element: &str, text: &str) {
        self.wrapped(element, &escaped(text));
    }

    /// Appends an element with markup.
    pub fn wrapped(&mut self, element: &str, markup: &str) {
        let name = element.split(' ').next().unwrap_or(element);
        for piece in ["<", element, ">", markup, "</", name, ">\n"] {
            self.out.push_str(piece);
        }
    }

    /// Appends the header of a row or column with attributes. Some screen readers do not read mathematics, so a header
    /// with mathematics also has a plain text for them.
    pub fn header(&mut self, attributes: &str, markup: &str) {
        let element = ["th ", attributes].concat();
        if !markup.contains("<math") {
            return self.wrapped(&element, markup);
        }
        let heard = ["<span class=\"heard\">", &without_tags(markup), "</span>"].concat();
        self.wrapped(&element, &[&heard, "<span aria-hidden=\"true\">", markup, "</span>"].concat());
    }

    /// Appends the heading of a section.
    pub fn heading(&mut self, text: &str) {
        self.element("h2", text);
    }

    /// Appends the head of a table. A leading `#` marks the headings of numeric columns.
    pub fn table(&mut self, class: &str, headings: &[&str]) {
        for piece in ["<div class=\"scroll\"><table class=\"", class, "\"><thead><tr>"] {
            self.out.push_str(piece);
        }
        for heading in headings {
            match heading.strip_prefix('#') {
                Some(heading) => self.element("th scope=\"col\" class=\"n\"", heading),
                None => self.element("th scope=\"col\"", heading),
            }
        }
        self.raw("</tr></thead><tbody>\n");
    }

    /// Appends a row of cells with markup. A leading `#` marks cells with numbers. The first cell is the header of the
    /// row.
    pub fn row(&mut self, cells: &[&str]) {
        self.row_of("", cells);
    }

    /// Appends a row with a class.
    pub fn row_of(&mut self, class: &str, cells: &[&str]) {
        match class {
            "" => self.raw("<tr>"),
            class => self.out.extend(["<tr class=\"", class, "\">"]),
        }
        for (place, cell) in cells.iter().enumerate() {
            match (place, cell.strip_prefix('#')) {
                // A header must not be empty, as for a record without a name.
                (0, None) if cell.is_empty() => self.raw("<td></td>"),
                (0, None) => self.header("scope=\"row\"", cell),
                (0, Some(cell)) => self.header("scope=\"row\" class=\"n\"", cell),
                (_, Some(cell)) => self.wrapped("td class=\"n\"", cell),
                (_, None) => self.wrapped("td", cell),
            }
        }
        self.raw("</tr>\n");
    }

    /// Appends the end of a table.
    pub fn end_table(&mut self) {
        self.raw("</tbody></table></div>\n");
    }

    /// Appends a term and its value.
    pub fn pair(&mut self, term: &str, value: &dyn Display) {
        self.element("dt", term);
        self.element("dd", &value.to_string());
    }
}

/// Markup of a numeric cell.
pub fn cell(number: &str) -> String {
    ["#", &escaped(number)].concat()
}

/// Embeds a font for the equations in a page of this crate: WOFF2 in base64, of characters `A-Z a-z 0-9 + / =`. Many
/// systems have no mathematical font, and without one browsers draw roots that do not fit their content.
pub fn with_math_font(page: &str, font: &str) -> String {
    let face = [
        "<style>\n@font-face { font-family: \"Meniscus Math\"; src: url(\"data:font/woff2;base64,",
        font,
        "\") format(\"woff2\") }\nmath { font-family: \"Meniscus Math\", math; font-size: 1.08em }\n</style>\n</head>",
    ];
    page.replacen("</head>", &face.concat(), 1)
}

/// Complete HTML page with this body.
pub fn document(title: &str, language: &str, version: &str, body: &str) -> String {
    let title = escaped(title);
    let pieces = [
        "<!doctype html>\n<html lang=\"",
        language,
        "\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n",
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; font-src data:; img-src data:\">\n",
        "<meta name=\"generator\" content=\"Meniscus ",
        &escaped(version),
        "\">\n<meta name=\"color-scheme\" content=\"light\">\n<title>",
        &title,
        "</title>\n<style>\n",
        include_str!("style.css"),
        "</style>\n</head>\n<body>\n<main>\n",
        body,
        "</main>\n</body>\n</html>\n",
    ];
    pieces.concat()
}
