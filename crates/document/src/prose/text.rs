//! Plain texts in HTML.

/// Id of a section with this title, also the target of a link `#title`.
pub fn anchor(title: &str) -> String {
    let mut id = String::from("doc");
    for word in title.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()) {
        id.push('-');
        id.extend(word.chars().flat_map(char::to_lowercase));
    }
    id
}
