//! Random codes and tokens.

use base64::Engine as _;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use sha2::{Digest, Sha256};

/// Characters of codes that people type: no `0`, `1`, `I` and `O`. 32 characters, five bits each.
const ALPHABET: &[u8; 32] = b"23456789ABCDEFGHJKLMNPQRSTUVWXYZ";

/// Length of the code of a class.
pub const CLASS_CODE: usize = 6;
/// Length of the key of a seat, with which another device takes the same seat.
pub const SEAT_KEY: usize = 10;

/// SHA-256 of a token. The store holds no token itself.
pub type Hash = [u8; 32];

/// Random bytes. `None` if the operating system has none.
fn random<const N: usize>() -> Option<[u8; N]> {
    let mut bytes = [0; N];
    getrandom::fill(&mut bytes).ok()?;
    Some(bytes)
}

/// A code for people. `None` if the operating system has no random bytes.
pub fn code(length: usize) -> Option<String> {
    let bytes: [u8; 32] = random()?;
    Some(bytes.iter().take(length).map(|byte| char::from(ALPHABET[usize::from(byte & 31)])).collect())
}

/// A token of 256 bits. `None` if the operating system has no random bytes.
pub fn token() -> Option<String> {
    Some(URL_SAFE_NO_PAD.encode(random::<32>()?))
}

/// An identifier that follows from a random number and tells nothing of time and order.
pub fn identifier(number: &str) -> [u8; 16] {
    let mut identifier = [0; 16];
    identifier.copy_from_slice(&hash(number)[..16]);
    identifier
}

/// Hash of a token or key.
pub fn hash(token: &str) -> Hash {
    Sha256::digest(token.as_bytes()).into()
}

/// A typed code in the form in which codes are made: upper case, without blanks and hyphens, `O` and `I` for the digits that they
/// resemble are not part of any code and stay.
pub fn normal(typed: &str) -> String {
    typed.chars().filter(|c| !c.is_whitespace() && *c != '-').take(64).flat_map(char::to_uppercase).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_differ_and_can_be_typed() {
        let codes: std::collections::BTreeSet<String> = (0..1000).filter_map(|_| code(CLASS_CODE)).collect();
        assert!(codes.len() > 990);
        for code in codes {
            assert_eq!(code.len(), CLASS_CODE);
            assert_eq!(normal(&format!(" {}-{} ", &code[..3], code[3..].to_lowercase())), code);
        }
    }
}
