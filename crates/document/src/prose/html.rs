//! Markdown to HTML. Only elements written here can occur in the result.

mod links;

use super::math::Formulas;
use math_core::MathDisplay;
use model::{Diagnostic, Span};
use pulldown_cmark::{Alignment, CodeBlockKind, Event, Options, Parser, Tag, TagEnd};
use std::ops::Range;
use units::markup::escaped;
use units::words;

/// Maximum nesting depth of lists and quotations; deeper ones are flattened.
const DEPTH: usize = 24;

/// A part of the rendered HTML.
pub enum Piece {
    /// HTML elements below a heading.
    Html(String),
    /// A heading that is not inside a list or quotation.
    Heading {
        /// Level, 1 to 6.
        level: u8,
        /// Title as plain text.
        title: String,
        /// Content of the heading.
        html: String,
    },
}

/// Extensions of CommonMark that documents use.
pub fn options() -> Options {
    Options::ENABLE_TABLES | Options::ENABLE_MATH | Options::ENABLE_STRIKETHROUGH
}

/// Renders the Markdown in `range` of `source`.
pub fn render(source: &str, range: Range<usize>, formulas: &Formulas, diagnostics: &mut Vec<Diagnostic>) -> Vec<Piece> {
    let parser = Parser::new_ext(&source[range.clone()], options()).into_offset_iter();
    let mut writer = Writer::new(formulas, diagnostics);
    let mut pieces = Vec::new();
    for (event, place) in parser {
        let span = Span::new(place.start + range.start, place.end + range.start);
        match event {
            Event::Start(Tag::Heading { .. }) if writer.open.is_empty() => {
                writer.flush(&mut pieces);
                writer.plain = Some(String::new());
            }
            Event::End(TagEnd::Heading(level)) if writer.open.is_empty() => {
                let title = writer.plain.take().unwrap_or_default().trim().to_owned();
                let html = std::mem::take(&mut writer.out);
                pieces.push(Piece::Heading { level: level as u8, title, html });
            }
            event => writer.event(event, span),
        }
    }
    writer.flush(&mut pieces);
    pieces
}

/// HTML writer.
struct Writer<'a> {
    formulas: &'a Formulas,
    diagnostics: &'a mut Vec<Diagnostic>,
    out: String,
    /// Closing tags of the open elements.
    open: Vec<&'static str>,
    /// Plain text, while a heading or a table head is read.
    plain: Option<String>,
    image: Option<Image>,
    table: Table,
    /// True if HTML in this paragraph has been reported.
    told_of_html: bool,
}

/// State of the current table.
#[derive(Default)]
struct Table {
    alignments: Vec<Alignment>,
    /// Number of cells read in the current row.
    column: usize,
    in_head: bool,
    /// Byte in the output at which the label of the table is inserted.
    name_at: usize,
}

/// State of the current image. Markdown allows markup and further images in the alternative text; only its plain text is
/// used.
struct Image {
    /// HTML before and after the alternative text.
    around: (String, &'static str),
    alternative: String,
    nested: usize,
}

impl<'a> Writer<'a> {
    fn new(formulas: &'a Formulas, diagnostics: &'a mut Vec<Diagnostic>) -> Self {
        let (out, open) = (String::new(), Vec::new());
        Self {
            formulas,
            diagnostics,
            out,
            open,
            plain: None,
            image: None,
            table: Table::default(),
            told_of_html: false,
        }
    }

    fn flush(&mut self, pieces: &mut Vec<Piece>) {
        if !self.out.is_empty() {
            pieces.push(Piece::Html(std::mem::take(&mut self.out)));
        }
    }

    fn event(&mut self, event: Event, span: Span) {
        let Some(event) = self.inside_image(event) else {
            return;
        };
        match event {
            Event::Start(Tag::Image { dest_url, .. }) => self.image(&dest_url, span),
            Event::Start(tag) => self.start(tag, span),
            Event::End(end) => self.end(end),
            Event::Text(text) => self.text(&text),
            Event::Code(text) => self.around("<code>", &text, "</code>"),
            Event::InlineMath(latex) => self.math(&latex, MathDisplay::Inline, span),
            Event::DisplayMath(latex) => self.math(&latex, MathDisplay::Block, span),
            Event::Html(text) | Event::InlineHtml(text) => self.raw_html(&text, span),
            Event::SoftBreak => self.text("\n"),
            Event::HardBreak => self.out.push_str("<br>"),
            Event::Rule => self.out.push_str("<hr>\n"),
            // Not enabled in the options.
            Event::FootnoteReference(_) | Event::TaskListMarker(_) => {}
        }
    }

    fn text(&mut self, text: &str) {
        if let Some(plain) = &mut self.plain {
            plain.push_str(text);
        }
        self.out.push_str(&escaped(text));
    }

    fn around(&mut self, before: &str, text: &str, after: &str) {
        self.out.push_str(before);
        self.text(text);
        self.out.push_str(after);
    }

    fn math(&mut self, latex: &str, display: MathDisplay, span: Span) {
        if let Some(plain) = &mut self.plain {
            plain.push_str(latex);
        }
        let html = self.formulas.html(latex, display, span, self.diagnostics);
        match display {
            MathDisplay::Inline => self.out.push_str(&html),
            MathDisplay::Block => self.out.push_str(&format!("<span class=\"formula\">{html}</span>")),
        }
    }

    /// Writes HTML as text; reported once per paragraph.
    fn raw_html(&mut self, text: &str, span: Span) {
        if !self.told_of_html {
            self.told_of_html = true;
            self.diagnostics.push(
                Diagnostic::warning("raw-html", words("HTML in prose is shown as text"), span)
                    .with_hint(words("use Markdown; the page allows no other markup")),
            );
        }
        self.text(text);
    }

    /// Opens an element; beyond the maximum depth only its content is written.
    fn open(&mut self, html: &str, closing: &'static str) {
        if self.open.len() < DEPTH {
            self.out.push_str(html);
            self.open.push(closing);
        } else {
            self.open.push("");
        }
    }

    fn start(&mut self, tag: Tag, span: Span) {
        if matches!(tag, Tag::Paragraph | Tag::HtmlBlock | Tag::Item | Tag::TableCell) {
            self.told_of_html = false;
        }
        match tag {
            Tag::Paragraph | Tag::HtmlBlock => self.open("<p>", "</p>\n"),
            Tag::Heading { .. } => self.open("<p><strong>", "</strong></p>\n"),
            Tag::BlockQuote(_) => self.open("<blockquote>\n", "</blockquote>\n"),
            Tag::CodeBlock(CodeBlockKind::Fenced(_) | CodeBlockKind::Indented) => {
                self.open("<pre tabindex=\"0\"><code>", "</code></pre>\n");
            }
            Tag::List(None) => self.open("<ul>\n", "</ul>\n"),
            Tag::List(Some(1)) => self.open("<ol>\n", "</ol>\n"),
            Tag::List(Some(start)) => self.open(&format!("<ol start=\"{start}\">\n"), "</ol>\n"),
            Tag::Item => self.open("<li>", "</li>\n"),
            Tag::Emphasis => self.open("<em>", "</em>"),
            Tag::Strong => self.open("<strong>", "</strong>"),
            Tag::Strikethrough => self.open("<del>", "</del>"),
            Tag::Link { dest_url, .. } => self.link(&dest_url, span),
            Tag::Image { dest_url, .. } => self.image(&dest_url, span),
            Tag::Table(alignments) => self.start_table(alignments),
            Tag::TableHead => {
                self.table.in_head = true;
                self.table.column = 0;
                self.plain.get_or_insert_default();
                self.open("<thead><tr>", "</tr></thead><tbody>\n");
            }
            Tag::TableRow => {
                self.table.column = 0;
                self.open("<tr>", "</tr>\n");
            }
            Tag::TableCell => self.start_cell(),
            // Not enabled in the options.
            _ => self.open("", ""),
        }
    }

    fn end(&mut self, end: TagEnd) {
        let closing = self.open.pop().unwrap_or_default();
        match end {
            TagEnd::TableHead => {
                self.out.push_str(closing);
                self.end_table_head();
            }
            TagEnd::TableCell => {
                self.out.push_str(closing);
                if let Some(plain) = self.plain.as_mut().filter(|_| self.table.in_head) {
                    plain.push_str(", ");
                }
            }
            _ => self.out.push_str(closing),
        }
    }

    /// Opens a table. Its head is the label for screen readers. The wrapper scrolls on narrow screens, also by keyboard.
    fn start_table(&mut self, alignments: Vec<Alignment>) {
        self.open("<div class=\"wide\" role=\"region\" tabindex=\"0\"><table>\n", "</tbody></table></div>\n");
        self.table = Table { alignments, name_at: self.out.rfind(" tabindex").unwrap_or(0), ..Table::default() };
    }

    fn end_table_head(&mut self) {
        self.table.in_head = false;
        let name = self.plain.take().unwrap_or_default();
        let name = escaped(name.trim_end_matches(", "));
        if self.open.len() < DEPTH {
            self.out.insert_str(self.table.name_at, &format!(" aria-label=\"{name}\""));
        }
    }

    fn start_cell(&mut self) {
        let alignment = self.table.alignments.get(self.table.column).copied().unwrap_or(Alignment::None);
        self.table.column += 1;
        let class = match alignment {
            Alignment::None | Alignment::Left => "",
            Alignment::Center => " class=\"center\"",
            Alignment::Right => " class=\"right\"",
        };
        if self.table.in_head {
            self.open(&format!("<th scope=\"col\"{class}>"), "</th>");
        } else {
            self.open(&format!("<td{class}>"), "</td>");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(markdown: &str, expected: &str, messages: &[&str]) {
        let mut diagnostics = Vec::new();
        let pieces = render(markdown, 0..markdown.len(), &Formulas::new(), &mut diagnostics);
        let html: String = pieces
            .into_iter()
            .map(|piece| match piece {
                Piece::Html(html) => html,
                Piece::Heading { level, title, html } => format!("[{level} {title}: {html}]"),
            })
            .collect();
        assert_eq!(html, expected);
        assert_eq!(diagnostics.iter().map(|d| d.message.english()).collect::<Vec<_>>(), messages);
    }

    #[test]
    fn ordinary_markdown() {
        check("# A *b* $c$\nText", "[1 A b c: A <em>b</em> <math><mi>c</mi></math>]<p>Text</p>\n", &[]);
        check("3. a\n4. **b**", "<ol start=\"3\">\n<li>a</li>\n<li><strong>b</strong></li>\n</ol>\n", &[]);
        check("> # a", "<blockquote>\n<p><strong>a</strong></p>\n</blockquote>\n", &[]);
        check("$$a$$", "<p><span class=\"formula\"><math display=\"block\"><mi>a</mi></math></span></p>\n", &[]);
    }

    #[test]
    fn raw_html_is_text() {
        check(
            "<script>alert(1)</script>\n\nA <b onclick=\"x\">b</b> &amp; `<i>`",
            "<p>&lt;script&gt;alert(1)&lt;/script&gt;\n</p>\n<p>A &lt;b onclick=&quot;x&quot;&gt;b&lt;/b&gt; &amp; \
             <code>&lt;i&gt;</code></p>\n",
            &["HTML in prose is shown as text"; 2],
        );
    }

    #[test]
    fn links_lead_only_where_they_may() {
        check("[a](#the-end)", "<p><a href=\"#doc-the-end\">a</a></p>\n", &[]);
        check("[a](MAILTO:a@b.c)", "<p><a href=\"MAILTO:a@b.c\">a</a></p>\n", &[]);
        check(
            "[a](https://b.c/?d&e \"f\")",
            "<p><a href=\"https://b.c/?d&amp;e\" target=\"_blank\" rel=\"noopener noreferrer\">a</a></p>\n",
            &[],
        );
        for address in
            ["javascript:alert(1)", "JaVaScRiPt:x", "data:text/html,x", "//evil.example", "file.md", "vbscript:x"]
        {
            check(&format!("[a]({address})"), "<p>a</p>\n", &[&format!("a link cannot lead to `{address}`")]);
        }
        check("[a](java&#10;script:x)", "<p>a</p>\n", &["a link cannot lead to `java\nscript:x`"]);
    }

    #[test]
    fn images_are_data() {
        check(
            "![a *b* ![c](d)](data:image/png;base64,AA \"t\")",
            "<p><img src=\"data:image/png;base64,AA\" alt=\"a b c\"></p>\n",
            &[],
        );
        check(
            "![a](https://b/c.png)",
            "<p><span class=\"problem\">a</span></p>\n",
            &["an image cannot come from `https://b/c.png`"],
        );
        check(
            "![a](data:image/svg+xml,x)",
            "<p><span class=\"problem\">a</span></p>\n",
            &["an image cannot come from `data:image/svg+xml,x`"],
        );
    }

    #[test]
    fn tables_have_names_and_scroll() {
        check(
            "| a | $b$ |\n|---|--:|\n| 1 | 2 |",
            "<div class=\"wide\" role=\"region\" aria-label=\"a, b\" tabindex=\"0\"><table>\n<thead><tr>\
             <th scope=\"col\">a</th><th scope=\"col\" class=\"right\"><math><mi>b</mi></math></th></tr></thead>\
             <tbody>\n<tr><td>1</td><td class=\"right\">2</td></tr>\n</tbody></table></div>\n",
            &[],
        );
    }

    #[test]
    fn depth_is_bounded() {
        let mut diagnostics = Vec::new();
        let source = "> ".repeat(500) + "a";
        let pieces = render(&source, 0..source.len(), &Formulas::new(), &mut diagnostics);
        let [Piece::Html(html)] = &pieces[..] else { panic!() };
        assert_eq!(html.matches("<blockquote>").count(), DEPTH);
        assert_eq!(html.matches("</blockquote>").count(), DEPTH);
        assert!(html.contains('a'));
    }
}
