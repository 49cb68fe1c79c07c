//! Names as plain text writes them: `omega_0` as ω₀, `y''` as y″.

use units::alphabet::greek_letter;

/// A name, or every name in a short expression, with Greek letters, lowered digits and primes as characters.
pub fn symbol(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let length = if first.is_ascii_alphabetic() {
            rest.find(|character: char| !(character.is_ascii_alphanumeric() || character == '_')).unwrap_or(rest.len())
        } else if first == '\'' {
            rest.find(|character| character != '\'').unwrap_or(rest.len())
        } else {
            first.len_utf8()
        };
        let (piece, tail) = rest.split_at(length);
        rest = tail;
        match first {
            '\'' => out.push_str(&primes(length)),
            '*' => out.push('·'),
            '-' => out.push('−'),
            _ => out.push_str(&name(piece)),
        }
    }
    out
}

fn primes(count: usize) -> String {
    match count {
        1 => "′".to_owned(),
        2 => "″".to_owned(),
        3 => "‴".to_owned(),
        _ => "′".repeat(count),
    }
}

fn name(piece: &str) -> String {
    let (stem, index) = piece.split_once('_').unwrap_or((piece, ""));
    let stem = greek_letter(stem).map_or_else(|| stem.to_owned(), String::from);
    // Only the digits have lowered forms in every font.
    if !index.is_empty() && index.bytes().all(|byte| byte.is_ascii_digit()) {
        let lowered = index.bytes().filter_map(|digit| char::from_u32(0x2080 + u32::from(digit - b'0')));
        return stem + &String::from_iter(lowered);
    }
    if index.is_empty() {
        stem
    } else {
        format!("{stem}_{}", greek_letter(index).map_or_else(|| index.to_owned(), String::from))
    }
}

#[cfg(test)]
mod tests {
    use super::symbol;

    #[test]
    fn names_as_plain_text_writes_them() {
        for (text, expected) in [
            ("omega_0", "ω₀"),
            ("omega_d", "ω_d"),
            ("y''", "y″"),
            ("h_l", "h_l"),
            ("theta_1'", "θ₁′"),
            ("m*y'^2/2 - V", "m·y′^2/2 − V"),
            ("Delta_rho", "Δ_ρ"),
            ("a_", "a"),
            ("", ""),
        ] {
            assert_eq!(symbol(text), expected);
        }
    }
}
