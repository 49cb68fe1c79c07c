//! HTML in pieces: tags and texts. Faulty HTML is read as far as it goes, as browsers do.

use super::entities::decoded;

/// Elements whose content is no text of the page.
const SKIPPED: [&str; 6] = ["script", "style", "title", "svg", "object", "template"];

/// Piece of HTML.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Piece {
    /// Name in lower case, and attributes.
    Open(String, Vec<(String, String)>),
    Close(String),
    Text(String),
}

/// Pieces of a text, without comments and what is no text of the page.
pub(super) fn pieces(html: &str) -> Vec<Piece> {
    let mut pieces = Vec::new();
    let mut rest = html;
    while let Some(at) = rest.find('<') {
        let (text, tag) = rest.split_at(at);
        push_text(text, &mut pieces);
        if let Some(comment) = tag.strip_prefix("<!--") {
            rest = comment.split_once("-->").map_or("", |(_, after)| after);
        } else if let Some(section) = tag.strip_prefix("<![CDATA[") {
            rest = section;
        } else if !tag[1..].starts_with(|first: char| first.is_ascii_alphabetic() || matches!(first, '/' | '!' | '?')) {
            // A sign "less than".
            push_text("<", &mut pieces);
            rest = &tag[1..];
        } else {
            let (inner, after) = tag[1..].split_once('>').unwrap_or((&tag[1..], ""));
            rest = after;
            let name: String = inner.trim_start_matches('/').chars().take_while(char::is_ascii_alphanumeric).collect();
            let name = name.to_ascii_lowercase();
            if inner.starts_with('/') {
                pieces.push(Piece::Close(name));
            } else if SKIPPED.contains(&name.as_str()) {
                let close = format!("</{name}");
                let end = rest.to_ascii_lowercase().find(&close);
                rest = end
                    .and_then(|end| rest.get(end..))
                    .and_then(|rest| rest.split_once('>'))
                    .map_or("", |(_, after)| after);
            } else if !name.is_empty() {
                pieces.push(Piece::Open(name, attributes(inner)));
            }
        }
    }
    push_text(rest, &mut pieces);
    pieces
}

fn push_text(text: &str, pieces: &mut Vec<Piece>) {
    if !text.is_empty() {
        let text: String =
            decoded(text).chars().filter(|letter| !letter.is_control() || letter.is_whitespace()).collect();
        pieces.push(Piece::Text(text));
    }
}

fn attributes(tag: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut rest = tag;
    while let Some((before, after)) = rest.split_once('=') {
        let name = before.rsplit(|letter: char| letter.is_whitespace() || letter == '"').next().unwrap_or_default();
        let after = after.trim_start();
        let (value, next) = match after.chars().next() {
            Some(quote @ ('"' | '\'')) => after[1..].split_once(quote).unwrap_or((&after[1..], "")),
            _ => after.split_once(char::is_whitespace).unwrap_or((after, "")),
        };
        found.push((name.to_ascii_lowercase(), decoded(value)));
        rest = next;
    }
    found
}
