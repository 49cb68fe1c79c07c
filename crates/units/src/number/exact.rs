//! Numbers as text that reads back exactly, for files and links.

/// Fewest digits that read back as the same number; plain from 1e-5 to 1e16, otherwise with an exponent. Empty if the
/// number is not finite.
pub fn shortest(value: f64) -> String {
    let magnitude = value.abs();
    if !value.is_finite() {
        String::new()
    } else if magnitude == 0.0 || (1e-5..1e16).contains(&magnitude) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

/// Fewest characters that read back as the same number, for links: `1e5`, not `100000`.
pub fn compact(value: f64) -> String {
    let (plain, scientific) = (format!("{value}"), format!("{value:e}"));
    if plain.len() <= scientific.len() { plain } else { scientific }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn readable_and_exact() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "-0"),
            (0.1, "0.1"),
            (0.1 + 0.2, "0.30000000000000004"),
            (1000.0, "1000"),
            (0.00001, "0.00001"),
            (0.0000099, "9.9e-6"),
            (1e-7, "1e-7"),
            (-2.5e300, "-2.5e300"),
            (9_007_199_254_740_993.0, "9007199254740992"),
            (1e16, "1e16"),
            (f64::NAN, ""),
            (f64::NEG_INFINITY, ""),
        ] {
            assert_eq!(shortest(value), text);
            if value.is_finite() {
                for text in [text.to_owned(), compact(value)] {
                    assert_eq!(text.parse::<f64>().map(f64::to_bits), Ok(value.to_bits()), "{text}");
                }
            }
        }
        assert_eq!([compact(100_000.0), compact(0.5), compact(1e-7)], ["1e5", "0.5", "1e-7"]);
    }
}
