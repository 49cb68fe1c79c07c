//! Reading of JSON (RFC 8259) token by token, without a tree of its values.

use std::borrow::Cow;

/// Greatest depth of nested values.
pub(super) const DEEPEST: usize = 64;

/// Position in a text of JSON. Every function returns `None` for a text that is not JSON.
#[derive(Debug)]
pub(super) struct Scanner<'a> {
    text: &'a str,
    at: usize,
}

/// Value without parts.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Scalar<'a> {
    Number(f64),
    Text(Cow<'a, str>),
    /// `null`, `true` or `false`.
    Nothing,
}

impl<'a> Scanner<'a> {
    pub fn new(text: &'a str) -> Self {
        Self { text, at: 0 }
    }

    /// Text that has not been read.
    pub fn rest(&self) -> &'a str {
        self.text.get(self.at..).unwrap_or_default()
    }

    /// Next character after white space, without taking it.
    pub fn peek(&mut self) -> Option<u8> {
        let rest = &self.text.as_bytes()[self.at..];
        self.at += rest.iter().take_while(|byte| matches!(byte, b' ' | b'\t' | b'\n' | b'\r')).count();
        self.text.as_bytes().get(self.at).copied()
    }

    /// Takes a character if it is the next.
    pub fn take(&mut self, sign: u8) -> bool {
        let found = self.peek() == Some(sign);
        self.at += usize::from(found);
        found
    }

    /// Key of a member, with its colon.
    pub fn key(&mut self) -> Option<Cow<'a, str>> {
        let key = self.string()?;
        self.take(b':').then_some(key)
    }

    /// Value that is neither an object nor an array.
    pub fn scalar(&mut self) -> Option<Scalar<'a>> {
        match self.peek()? {
            b'"' => self.string().map(Scalar::Text),
            b'-' | b'0'..=b'9' => self.number().map(Scalar::Number),
            // NaN and Infinity are no JSON, but Python writes them.
            _ => ["null", "true", "false", "NaN", "Infinity"].into_iter().find_map(|word| {
                self.text.get(self.at..)?.starts_with(word).then(|| {
                    self.at += word.len();
                    Scalar::Nothing
                })
            }),
        }
    }

    fn number(&mut self) -> Option<f64> {
        let rest = self.text.get(self.at..)?;
        if rest.starts_with("-Infinity") {
            self.at += "-Infinity".len();
            return Some(f64::NAN);
        }
        let length = rest
            .bytes()
            .take_while(|byte| byte.is_ascii_digit() || matches!(byte, b'-' | b'+' | b'.' | b'e' | b'E'))
            .count();
        self.at += length;
        rest.get(..length)?.parse().ok()
    }

    fn string(&mut self) -> Option<Cow<'a, str>> {
        if !self.take(b'"') {
            return None;
        }
        let text: &'a str = self.text;
        let rest = text.get(self.at..)?;
        let end = rest.find(['"', '\\'])?;
        let plain = rest.get(..end)?;
        self.at += end;
        if self.take(b'"') {
            return Some(Cow::Borrowed(plain));
        }
        let mut own = plain.to_owned();
        let mut characters = rest.get(end..)?.char_indices();
        while let Some((place, character)) = characters.next() {
            match character {
                '"' => {
                    self.at += place + 1;
                    return Some(Cow::Owned(own));
                }
                '\\' => own.push(match characters.next()?.1 {
                    'n' | 'r' | 't' | 'b' | 'f' => ' ',
                    'u' => {
                        let digits: String = (0..4).filter_map(|_| characters.next()).map(|(_, digit)| digit).collect();
                        char::from_u32(u32::from_str_radix(&digits, 16).ok()?).unwrap_or(char::REPLACEMENT_CHARACTER)
                    }
                    other => other,
                }),
                other => own.push(other),
            }
        }
        None
    }

    /// Passes over a value of any kind.
    pub fn skip(&mut self, depth: usize) -> Option<()> {
        if depth > DEEPEST {
            return None;
        }
        if self.take(b'{') {
            if self.take(b'}') {
                return Some(());
            }
            loop {
                self.key()?;
                self.skip(depth + 1)?;
                if self.take(b'}') {
                    return Some(());
                }
                self.take(b',').then_some(())?;
            }
        }
        if self.take(b'[') {
            if self.take(b']') {
                return Some(());
            }
            loop {
                self.skip(depth + 1)?;
                if self.take(b']') {
                    return Some(());
                }
                self.take(b',').then_some(())?;
            }
        }
        self.scalar().map(|_| ())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_read_and_passed_over() {
        let mut scanner = Scanner::new(" \"a\\u00b5\\n\\\"b\" ");
        assert_eq!(scanner.scalar(), Some(Scalar::Text("aµ \"b".into())));
        let mut scanner = Scanner::new("-1.5e3,null");
        assert_eq!(scanner.scalar(), Some(Scalar::Number(-1500.0)));
        assert!(scanner.take(b','));
        assert_eq!(scanner.scalar(), Some(Scalar::Nothing));
        for (text, valid) in [
            ("{\"a\":[1,{\"b\":null}],\"c\":\"\"}", true),
            ("[]", true),
            ("{}", true),
            ("[1,]", false),
            ("{\"a\"}", false),
            ("[1", false),
            ("\"a", false),
            ("\"\\u00", false),
            ("1e", false),
        ] {
            assert_eq!(Scanner::new(text).skip(0).is_some(), valid, "{text}");
        }
        assert_eq!(Scanner::new(&"[".repeat(100_000)).skip(0), None);
    }
}
