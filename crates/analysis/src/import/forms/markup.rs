//! Tables in HTML and LaTeX, as text with tabs.

/// Language of the text in which a table stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Markup {
    /// HTML and XHTML.
    Html,
    /// LaTeX.
    Latex,
}

impl Markup {
    /// Name for messages.
    pub fn name(self) -> &'static str {
        match self {
            Self::Html => "HTML",
            Self::Latex => "LaTeX",
        }
    }
}

/// Table of a text in a markup language.
#[derive(Debug)]
pub(super) struct MarkedTable {
    pub markup: Markup,
    /// Cells with tabs between them, of the table with the most cells; empty without a table.
    pub cells: String,
    /// Number of the other tables.
    pub others: usize,
}

/// Greatest number of columns that one cell can span.
const SPAN: usize = 100;

/// True if a text begins as HTML.
pub(in crate::import) fn is_html(text: &str) -> bool {
    let start = text.get(..text.floor_char_boundary(1000)).unwrap_or(text).trim_start().to_ascii_lowercase();
    start.starts_with("<!doctype html")
        || start.starts_with("<html")
        || start.starts_with("<table")
        || start.starts_with("<?xml") && start.contains("<html")
}

/// Reads the tables of a text in HTML or LaTeX; `None` for any other text.
pub(super) fn read(text: &str) -> Option<MarkedTable> {
    let (markup, tables) = if is_html(text) {
        (Markup::Html, html(text))
    } else if text.contains("\\begin{tabular") || text.contains("\\begin{longtable") || is_bare_latex(text) {
        (Markup::Latex, latex(text))
    } else {
        return None;
    };
    let others = tables.len().saturating_sub(1);
    let cells = tables.into_iter().max_by_key(|cells| cells.matches(['\t', '\n']).count()).unwrap_or_default();
    Some(MarkedTable { markup, cells, others })
}

/// Adds a cell to a row; its blanks become single ones.
fn push_cell(row: &mut String, cell: &str, first: bool) {
    if !first {
        row.push('\t');
    }
    row.push_str(&cell.split_whitespace().collect::<Vec<_>>().join(" "));
}

/// Tables of HTML. Nested tables end the row in which they stand.
fn html(text: &str) -> Vec<String> {
    let (mut tables, mut cells, mut cell): (Vec<String>, Vec<String>, Option<String>) = Default::default();
    let mut span = 1;
    let mut rest = text;
    let mut skipped: Option<&str> = None;
    while let Some(open) = rest.find('<') {
        if let Some(cell) = cell.as_mut().filter(|_| skipped.is_none()) {
            cell.push_str(&entities(&rest[..open]));
        }
        rest = &rest[open..];
        if let Some(comment) = rest.strip_prefix("<!--") {
            rest = comment.split_once("-->").map_or("", |(_, after)| after);
            continue;
        }
        let (tag, after) = rest.split_once('>').unwrap_or((rest, ""));
        rest = after;
        let name: String = tag[1..].chars().take_while(|letter| letter.is_alphanumeric() || *letter == '/').collect();
        let name = name.to_ascii_lowercase();
        if let Some(end) = skipped {
            skipped = Some(end).filter(|end| name != *end);
            continue;
        }
        skipped = match name.as_str() {
            "script" => Some("/script"),
            "style" => Some("/style"),
            _ => None,
        };
        if matches!(name.as_str(), "td" | "th" | "tr" | "/td" | "/th" | "/tr" | "table" | "/table")
            && let Some(cell) = cell.take()
        {
            cells.push(cell);
            cells.extend(std::iter::repeat_n(String::new(), span - 1));
        }
        match name.as_str() {
            "td" | "th" => {
                cell = Some(String::new());
                let stated = tag.to_ascii_lowercase();
                let stated =
                    stated.split_once("colspan=").map(|(_, span)| span.trim_start_matches(['"', '\'']).to_owned());
                let digits = stated.map(|span| span.chars().take_while(char::is_ascii_digit).collect::<String>());
                span = digits.and_then(|span| span.parse().ok()).unwrap_or(1).clamp(1, SPAN);
            }
            "table" => tables.push(String::new()),
            "br" | "br/" | "p" | "div" => cell.iter_mut().for_each(|cell| cell.push(' ')),
            _ => {}
        }
        if matches!(name.as_str(), "tr" | "/tr" | "/table") && !cells.is_empty() {
            let mut row = String::new();
            cells.drain(..).enumerate().for_each(|(place, cell)| push_cell(&mut row, &cell, place == 0));
            if let Some(table) = tables.last_mut() {
                table.push_str(&row);
                table.push('\n');
            }
        }
    }
    tables.retain(|table| !table.is_empty());
    tables
}

/// Text with the common named entities and all numeric ones replaced.
fn entities(text: &str) -> String {
    const NAMED: [(&str, &str); 12] = [
        ("nbsp", " "),
        ("lt", "<"),
        ("gt", ">"),
        ("quot", "\""),
        ("apos", "'"),
        ("minus", "-"),
        ("deg", "°"),
        ("micro", "µ"),
        ("Omega", "Ω"),
        ("plusmn", "±"),
        ("times", "×"),
        ("amp", "&"),
    ];
    let mut parts = text.split('&');
    let mut read = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let entity = part.split_once(';').filter(|(name, _)| name.len() <= 8);
        let meant = entity.and_then(|(name, _)| {
            let number = name.strip_prefix('#').and_then(|digits| match digits.strip_prefix(['x', 'X']) {
                Some(digits) => u32::from_str_radix(digits, 16).ok(),
                None => digits.parse().ok(),
            });
            let named = NAMED.iter().find(|(own, _)| *own == name).map(|(_, text)| (*text).to_owned());
            number.and_then(char::from_u32).map(String::from).or(named)
        });
        match (meant, entity) {
            (Some(meant), Some((_, after))) => read.extend([meant.as_str(), after]),
            _ => read.extend(["&", part]),
        }
    }
    read
}

/// True for rows of LaTeX without their environment: most lines have `&` and `\\`.
fn is_bare_latex(text: &str) -> bool {
    let mut lines = 0;
    let is_row = |line: &str| line.contains('&') && line.contains("\\\\");
    let rows = text.lines().take(100).filter(|line| !line.trim().is_empty()).inspect(|_| lines += 1);
    let rows = rows.filter(|line| is_row(line)).count();
    rows >= 2 && 2 * rows > lines
}

/// Tables of LaTeX; the whole text if it has no environment of a table.
fn latex(text: &str) -> Vec<String> {
    let begins = |part: &&str| part.starts_with("tabular") || part.starts_with("longtable");
    let bodies: Vec<&str> = text
        .split("\\begin{")
        .skip(1)
        .filter(begins)
        .map(|part| part.split("\\end{tabular").next().unwrap_or(part))
        .map(|part| part.split("\\end{longtable").next().unwrap_or(part))
        // The format of the columns stands in the last braces of the first line.
        .map(|part| part.split_once('\n').map_or("", |(_, body)| body))
        .collect();
    let bodies = if bodies.is_empty() { vec![text] } else { bodies };
    bodies.into_iter().map(latex_rows).filter(|cells| !cells.is_empty()).collect()
}

fn latex_rows(body: &str) -> String {
    let mut cells = String::new();
    let uncommented: String = body.lines().map(|line| without_comment(line).to_owned() + "\n").collect();
    for row in uncommented.split("\\\\") {
        // The space after a row, `\\[2pt]`.
        let row = match row.strip_prefix('[') {
            Some(space) => space.split_once(']').map_or(row, |(_, row)| row),
            None => row,
        };
        let texts: Vec<String> = row.replace("\\&", "\u{1}").split('&').map(latex_text).collect();
        if texts.iter().any(|text| !text.trim().is_empty()) {
            texts.iter().enumerate().for_each(|(place, text)| push_cell(&mut cells, text, place == 0));
            cells.push('\n');
        }
    }
    cells
}

/// Line without the comment behind a percent sign that no backslash precedes.
fn without_comment(line: &str) -> &str {
    let begins = |place: &usize| *place == 0 || line.as_bytes().get(place - 1) != Some(&b'\\');
    let place = line.match_indices('%').map(|(place, _)| place).find(begins);
    place.map_or(line, |place| line.get(..place).unwrap_or(line))
}

/// Text of a cell without commands, dollar signs and braces; symbols become characters.
fn latex_text(cell: &str) -> String {
    const SYMBOLS: [(&str, &str); 10] = [
        ("pm", "±"),
        ("times", "×"),
        ("cdot", "·"),
        ("mu", "µ"),
        ("Omega", "Ω"),
        ("degree", "°"),
        ("celsius", "°C"),
        ("circ", "°"),
        ("omega", "ω"),
        ("theta", "θ"),
    ];
    let mut text = String::new();
    let mut rest = cell;
    while let Some(place) = rest.find(['\\', '$', '{', '}', '~', '\u{1}']) {
        text.push_str(&rest[..place]);
        let sign = rest[place..].chars().next().unwrap_or_default();
        rest = &rest[place + sign.len_utf8()..];
        match sign {
            '~' => text.push(' '),
            '\u{1}' => text.push('&'),
            '\\' => {
                let end = rest.find(|letter: char| !letter.is_ascii_alphabetic()).unwrap_or(rest.len());
                let (name, after) = rest.split_at(end);
                match SYMBOLS.iter().find(|(own, _)| *own == name) {
                    Some((_, symbol)) => text.push_str(symbol),
                    // `\%` is a percent sign, `\,` a blank.
                    None if name.is_empty() => {
                        let sign = after.chars().next().unwrap_or_default();
                        text.push(if matches!(sign, '%' | '_' | '#' | '$') { sign } else { ' ' });
                        rest = &after[sign.len_utf8().min(after.len())..];
                        continue;
                    }
                    None => {}
                }
                rest = after;
            }
            _ => {}
        }
    }
    text + rest
}
