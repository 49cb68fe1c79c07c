//! Percent-encoding of names in addresses.

use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, percent_encode};

/// Escaped characters: all but the unreserved ones (RFC 3986, section 2.3) and the slash.
const ESCAPED: &AsciiSet = &NON_ALPHANUMERIC.remove(b'-').remove(b'.').remove(b'_').remove(b'~').remove(b'/');

/// Percent-encodes a path or a name for an address or its fragment: every byte of UTF-8 becomes `%XX` except letters and
/// digits of ASCII and `-._~/`.
pub fn percent_encoded(text: impl AsRef<[u8]>) -> String {
    percent_encode(text.as_ref(), ESCAPED).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_hold_nothing_that_means_something() {
        assert_eq!(percent_encoded("a/b-1_2.html"), "a/b-1_2.html");
        assert_eq!(percent_encoded("mi péndulo & #1?.html"), "mi%20p%C3%A9ndulo%20%26%20%231%3F.html");
        assert_eq!(percent_encoded("\"><script>"), "%22%3E%3Cscript%3E");
    }
}
