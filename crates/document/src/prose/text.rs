//! Plain texts as they stand in HTML.

/// The id of a section with this title, and what a link `#title` becomes.
pub fn anchor(title: &str) -> String {
    let mut id = String::from("doc");
    for word in title.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()) {
        id.push('-');
        id.extend(word.chars().flat_map(char::to_lowercase));
    }
    id
}

/// `text` as it stands in HTML, in an element or an attribute.
pub fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            _ => escaped.push(letter),
        }
    }
    escaped
}
