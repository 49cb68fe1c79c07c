//! Names of the files of a site.

/// Page of the laboratory.
pub const LABORATORY: &str = "laboratory.html";
/// Index page of the simulations.
pub const INDEX: &str = "index.html";
/// Service worker. It is at the top of the site because it only serves paths below it.
pub const WORKER: &str = "sw.js";
/// Suffix of the text version of a module, which pages opened from a disk load.
pub const FROM_DISK: &str = ".text.js";

/// Percent-encodes a path of the site.
pub fn percent_encoded(path: &str) -> String {
    let keep = |byte: u8| byte.is_ascii_alphanumeric() || b"-._~/".contains(&byte);
    path.bytes().map(|byte| if keep(byte) { char::from(byte).to_string() } else { format!("%{byte:02X}") }).collect()
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
