//! Names of the files of a site.

use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, utf8_percent_encode};

/// Page of the laboratory.
pub const LABORATORY: &str = "laboratory.html";
/// Index page of the simulations.
pub const INDEX: &str = "index.html";
/// Service worker. It is at the top of the site because it only serves paths below it.
pub const WORKER: &str = "sw.js";
/// Suffix of the text version of a module, which pages opened from a disk load.
pub const FROM_DISK: &str = ".text.js";

/// Characters that are escaped in a path: all but the unreserved ones (RFC 3986, section 2.3) and the slash.
const ESCAPED: &AsciiSet = &NON_ALPHANUMERIC.remove(b'-').remove(b'.').remove(b'_').remove(b'~').remove(b'/');

/// Percent-encodes a path of the site.
pub fn percent_encoded(path: &str) -> String {
    utf8_percent_encode(path, ESCAPED).to_string()
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
