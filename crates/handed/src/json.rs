//! JSON as a text.

use std::fmt::Write;

/// A text as a JSON string.
pub fn text(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 2);
    out.push('"');
    for letter in text.chars() {
        match letter {
            '"' | '\\' => out.extend(['\\', letter]),
            '\n' => out.push_str("\\n"),
            control if control < ' ' => {
                // Writing to a string cannot fail.
                let _ = write!(out, "\\u{:04x}", u32::from(control));
            }
            other => out.push(other),
        }
    }
    out.push('"');
    out
}

/// A number with all its bits. JSON has no infinities and NaN: they are texts.
pub fn number(value: f64) -> String {
    if value.is_finite() { format!("{value:?}") } else { text(&value.to_string()) }
}

/// A list of texts in JSON.
pub fn list<T: AsRef<str>>(elements: impl IntoIterator<Item = T>) -> String {
    let mut out = String::from("[");
    for element in elements {
        if out.len() > 1 {
            out.push(',');
        }
        out.push_str(element.as_ref());
    }
    out.push(']');
    out
}

/// An object whose members are added one after the other.
#[derive(Debug, Default)]
pub struct Object(String);

impl Object {
    /// With a member: a name without characters that need an escape, and a text in JSON.
    #[must_use]
    pub fn with(mut self, name: &str, json: impl AsRef<str>) -> Self {
        let separator = if self.0.is_empty() { "{\"" } else { ",\"" };
        [separator, name, "\":", json.as_ref()].into_iter().for_each(|part| self.0.push_str(part));
        self
    }

    /// With a member if there is a value.
    #[must_use]
    pub fn with_some(self, name: &str, json: Option<String>) -> Self {
        match json {
            Some(json) => self.with(name, json),
            None => self,
        }
    }

    /// The object as a text.
    pub fn end(mut self) -> String {
        if self.0.is_empty() {
            self.0.push('{');
        }
        self.0.push('}');
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_library_reads_what_is_written() {
        let all: String = (0..0x300).chain([0x2028, 0xfeff, 0x1f389]).filter_map(char::from_u32).collect();
        assert_eq!(serde_json::from_str::<String>(&text(&all)).unwrap(), all);
        for value in [0.0, -0.0, 0.1 + 0.2, 5e-324, f64::MAX, 1e21, -3.0] {
            assert_eq!(serde_json::from_str::<f64>(&number(value)).unwrap().to_bits(), value.to_bits());
        }
        assert_eq!([f64::NAN, f64::INFINITY].map(number), ["\"NaN\"", "\"inf\""]);
        let object = Object::default().with("a", "1").with_some("b", None).with_some("c", Some(list(["2", "{}"])));
        let read: serde_json::Value = serde_json::from_str(&object.end()).unwrap();
        assert_eq!(read, serde_json::json!({ "a": 1, "c": [2, {}] }));
        assert_eq!([Object::default().end(), list([""; 0])], ["{}", "[]"]);
    }
}
