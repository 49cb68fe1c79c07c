//! The typed command, for reports that state how to repeat them.

/// The command line as typed, quoted for a shell.
pub fn typed() -> String {
    let mut words = vec!["meniscus".to_owned()];
    for word in std::env::args().skip(1) {
        let plain = |c: char| c.is_alphanumeric() || "-_=.,/+:@%".contains(c);
        words.push(if word.chars().all(plain) && !word.is_empty() {
            word
        } else {
            format!("'{}'", word.replace('\'', "'\\''"))
        });
    }
    words.join(" ")
}
