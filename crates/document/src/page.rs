//! Documents inside a page: an exported page carries its source.

/// A file of a document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// Its file name, such as `utube.es.md`.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// What of the page is adapted to its documents.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The content of `<title>`.
    pub title: Option<String>,
    /// The `lang` of `<html>`.
    pub language: Option<String>,
    /// The simulation of a page that plays one: its bundle, gzipped, in base64.
    pub bundle: Option<String>,
}

/// The page's content security policy: it makes no request, and what is not in the file does not exist for it.
pub const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval'; style-src 'unsafe-inline'; \
                          img-src data: blob:; font-src data:; base-uri 'none'; form-action 'none'";

/// The place in a page where the documents go.
pub const MARKER: &str = "<!--documents-->";

const OPENING: &str = "<script type=\"application/json\" id=\"documents\">";
const CLOSING: &str = "</script>";
const BUNDLE: &str = "<script type=\"application/octet-stream\" id=\"bundle\">";

/// Puts `documents` into `template`, in the place of [`MARKER`] or of the documents it has already. None where the
/// template has no such place.
pub fn embed(template: &str, documents: &[Source], options: &Options) -> Option<String> {
    let (before, after) = match template.split_once(MARKER) {
        Some(around) => around,
        None => {
            let (start, end) = embedded(template)?;
            (&template[..start - OPENING.len()], &template[end + CLOSING.len()..])
        }
    };
    let mut head = before.to_owned();
    if let Some(title) = &options.title {
        replace_between(&mut head, "<title>", "</title>", &crate::prose::escape(title));
    }
    if let Some(language) = options.language.as_ref().filter(|language| crate::settings::is_language(language)) {
        replace_between(&mut head, "<html lang=\"", "\"", language);
    }
    let bundle = options.bundle.as_ref().filter(|bundle| bundle.bytes().all(is_base64));
    let bundle = bundle.map_or_else(String::new, |bundle| format!("{BUNDLE}{bundle}{CLOSING}"));
    Some(format!("{head}{bundle}{OPENING}{}{CLOSING}{after}", write_list(documents)))
}

fn is_base64(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || b"+/=".contains(&byte)
}

/// Documents as a list in JSON that can stand in a `script` element.
pub fn write_list(documents: &[Source]) -> String {
    let list: Vec<String> = documents
        .iter()
        .map(|source| format!("{{\"name\":{},\"text\":{}}}", encode(&source.name), encode(&source.text)))
        .collect();
    format!("[{}]", list.join(",\n"))
}

/// The documents in a page that [`embed`] made. None where it holds none.
pub fn read(page: &str) -> Option<Vec<Source>> {
    let (start, end) = embedded(page)?;
    read_list(&page[start..end])
}

/// The documents of a list that [`write_list`] made. None where it is none, or empty.
pub fn read_list(list: &str) -> Option<Vec<Source>> {
    let mut reader = Reader { rest: list };
    let mut documents = Vec::new();
    reader.expect('[')?;
    while reader.expect('{').is_some() {
        let mut source = Source { name: String::new(), text: String::new() };
        loop {
            let key = reader.string()?;
            reader.expect(':')?;
            let value = reader.string()?;
            match key.as_str() {
                "name" => source.name = value,
                "text" => source.text = value,
                _ => return None,
            }
            if reader.expect(',').is_none() {
                break;
            }
        }
        reader.expect('}')?;
        documents.push(source);
        if reader.expect(',').is_none() {
            break;
        }
    }
    reader.expect(']')?;
    (!documents.is_empty()).then_some(documents)
}

/// Where the embedded JSON stands. It is the last such element: no document can contain its opening tag, encoded as
/// they are, but what stands before may.
fn embedded(page: &str) -> Option<(usize, usize)> {
    let start = page.rfind(OPENING)? + OPENING.len();
    let end = start + page[start..].find(CLOSING)?;
    Some((start, end))
}

fn replace_between(text: &mut String, before: &str, after: &str, new: &str) {
    let Some(start) = text.find(before).map(|at| at + before.len()) else {
        return;
    };
    if let Some(length) = text[start..].find(after) {
        text.replace_range(start..start + length, new);
    }
}

/// A JSON string that can stand in a `script` element: nothing in it can end the element or begin a comment.
fn encode(text: &str) -> String {
    let mut encoded = String::with_capacity(text.len() + 2);
    encoded.push('"');
    for letter in text.chars() {
        match letter {
            '"' => encoded.push_str("\\\""),
            '\\' => encoded.push_str("\\\\"),
            '\n' => encoded.push_str("\\n"),
            '<' | '>' | '&' | '\u{2028}' | '\u{2029}' | '\0'..='\u{1f}' | '\u{7f}' => {
                encoded.push_str(&format!("\\u{:04x}", u32::from(letter)));
            }
            _ => encoded.push(letter),
        }
    }
    encoded.push('"');
    encoded
}

struct Reader<'a> {
    rest: &'a str,
}

impl Reader<'_> {
    fn expect(&mut self, letter: char) -> Option<()> {
        self.rest = self.rest.trim_start().strip_prefix(letter)?;
        Some(())
    }

    fn string(&mut self) -> Option<String> {
        self.expect('"')?;
        let mut text = String::new();
        loop {
            let end = self.rest.bytes().position(|byte| matches!(byte, b'"' | b'\\'))?;
            text.push_str(&self.rest[..end]);
            let escaped = self.rest[end..].starts_with('\\');
            self.rest = &self.rest[end + 1..];
            if !escaped {
                return Some(text);
            }
            text.push(self.escape()?);
        }
    }

    fn escape(&mut self) -> Option<char> {
        let letter = self.rest.chars().next()?;
        self.rest = &self.rest[letter.len_utf8()..];
        match letter {
            '"' | '\\' | '/' => Some(letter),
            'n' => Some('\n'),
            'r' => Some('\r'),
            't' => Some('\t'),
            'b' => Some('\u{8}'),
            'f' => Some('\u{c}'),
            'u' => self.code_point(),
            _ => None,
        }
    }

    /// `2028`, or two of them for a character beyond 16 bits.
    fn code_point(&mut self) -> Option<char> {
        let first = self.hexadecimal()?;
        if !(0xd800..0xdc00).contains(&first) {
            return char::from_u32(first);
        }
        self.rest = self.rest.strip_prefix("\\u")?;
        let second = self.hexadecimal()?.checked_sub(0xdc00).filter(|low| *low < 0x400)?;
        char::from_u32(0x10000 + ((first - 0xd800) << 10) + second)
    }

    fn hexadecimal(&mut self) -> Option<u32> {
        let digits = self.rest.get(..4).filter(|digits| digits.bytes().all(|b| b.is_ascii_hexdigit()))?;
        self.rest = &self.rest[4..];
        u32::from_str_radix(digits, 16).ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEMPLATE: &str = "<!doctype html><html lang=\"en\"><title>M</title><body><!--documents--></body></html>";

    fn source(text: &str) -> Source {
        Source { name: "a \"b\".md".to_owned(), text: text.to_owned() }
    }

    #[test]
    fn what_goes_in_comes_out() {
        let hard = "</script><script>alert(1)</script> <!-- & \u{2028} \u{0} \u{7f} \\ \" \r\n\t é 😀 <!--documents-->";
        let sources = [source(hard), source("")];
        let page = embed(TEMPLATE, &sources, &Options::default()).unwrap();
        assert_eq!(read(&page).unwrap(), sources);
        assert_eq!(page.matches("<script").count(), 1);
        assert_eq!(page.matches("</script").count(), 1);
        assert!(!page.contains("<!--"));
    }

    #[test]
    fn an_exported_page_can_be_given_other_documents() {
        let options = Options { title: Some("A < B".into()), language: Some("es".into()), bundle: None };
        let page = embed(TEMPLATE, &[source("1")], &options).unwrap();
        let again = embed(&page, &[source("2")], &Options::default()).unwrap();
        assert_eq!(read(&again).unwrap(), [source("2")]);
        assert!(again.starts_with("<!doctype html><html lang=\"es\"><title>A &lt; B</title><body><script"));
        assert!(again.ends_with("</script></body></html>"));
    }

    #[test]
    fn other_pages_hold_no_documents() {
        assert_eq!(embed("<html></html>", &[], &Options::default()), None);
        for page in [
            "",
            "<html></html>",
            OPENING,
            &format!("{OPENING}[{{\"name\":1}}]{CLOSING}"),
            &format!("{OPENING}[]{CLOSING}"),
        ] {
            assert_eq!(read(page), None, "{page}");
        }
    }

    #[test]
    fn json_of_other_writers_is_read() {
        let page = format!("{OPENING}\n[ {{ \"text\" : \"\\u00e9\\ud83d\\ude00\\/\", \"name\" : \"x\" }} ]\n{CLOSING}");
        assert_eq!(read(&page).unwrap(), [Source { name: "x".into(), text: "é😀/".into() }]);
    }
}
