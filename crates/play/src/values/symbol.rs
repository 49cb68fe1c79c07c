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
        } else if first == '[' {
            member(rest).unwrap_or(1)
        } else {
            first.len_utf8()
        };
        let (piece, tail) = rest.split_at(length);
        rest = tail;
        match first {
            '\'' => out.push_str(&primes(length)),
            '[' if length > 1 => out.extend(piece.chars().filter_map(lowered)),
            '*' => out.push('·'),
            '-' => out.push('−'),
            _ => out.push_str(&name(piece)),
        }
    }
    out
}

/// How long the numbers of a member of a family are, with their brackets: `[3]`, `[1,2]`.
fn member(text: &str) -> Option<usize> {
    let (numbers, _) = text.strip_prefix('[')?.split_once(']')?;
    let is_number = |number: &str| {
        let digits = number.strip_prefix('-').unwrap_or(number);
        !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit())
    };
    numbers.split(',').all(is_number).then_some(numbers.len() + 2)
}

/// The lowered form of a digit; of brackets none.
fn lowered(character: char) -> Option<char> {
    match character {
        '-' => Some('₋'),
        ',' => Some(','),
        digit => char::from_u32(0x2080 + digit.to_digit(10)?),
    }
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
        return stem + &index.chars().filter_map(lowered).collect::<String>();
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
            ("x[12]''", "x₁₂″"),
            ("u[0,-1]", "u₀,₋₁"),
            ("1 [m]", "1 [m]"),
            ("a_", "a"),
            ("", ""),
        ] {
            assert_eq!(symbol(text), expected);
        }
    }
}
