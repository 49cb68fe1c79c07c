//! Names in plain text: `omega_0` as ω₀, `y''` as y″, `e[j]` as e_j.

use units::alphabet::greek_letter;
use units::mathml::is_word;

/// Formats a name, or all names in a short expression, with Greek letters, subscript digits and primes.
pub fn symbol(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    // Name that a following index or component belongs to.
    let mut bearer = None;
    while let Some(first) = rest.chars().next() {
        let length = if first.is_ascii_alphabetic() {
            rest.find(|character: char| !(character.is_ascii_alphanumeric() || character == '_')).unwrap_or(rest.len())
        } else if first == '\'' {
            rest.find(|character| character != '\'').unwrap_or(rest.len())
        } else if first == '[' {
            member(rest).or_else(|| named_member(rest).filter(|_| bearer.is_some())).unwrap_or(1)
        } else if first == '.' && is_component(rest) && bearer.is_some_and(|name| !is_word(name)) {
            2
        } else {
            first.len_utf8()
        };
        let (piece, tail) = rest.split_at(length);
        rest = tail;
        bearer = if first.is_ascii_alphabetic() { Some(piece) } else { bearer.filter(|_| first == '[' && length > 1) };
        match first {
            '\'' => out.push_str(&primes(length)),
            '[' if length > 1 && member(piece).is_none() => {
                out.push('_');
                out.push_str(&name(&piece[1..length - 1]));
            }
            '[' if length > 1 => out.extend(piece.chars().filter_map(lowered)),
            '.' if length > 1 => {
                out.push('_');
                out.push_str(&piece[1..]);
            }
            '*' => out.push('·'),
            '-' => out.push('−'),
            _ => out.push_str(&name(piece)),
        }
    }
    out
}

/// Length in bytes of the numeric index of a family member, with brackets: `[3]`, `[1,2]`; `None` if there is none.
fn member(text: &str) -> Option<usize> {
    let (numbers, _) = text.strip_prefix('[')?.split_once(']')?;
    let is_number = |number: &str| {
        let digits = number.strip_prefix('-').unwrap_or(number);
        !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit())
    };
    numbers.split(',').all(is_number).then_some(numbers.len() + 2)
}

/// Length in bytes of the index of a family member, with brackets, if the index is a name: `[j]`.
fn named_member(text: &str) -> Option<usize> {
    let (index, _) = text.strip_prefix('[')?.split_once(']')?;
    let is_name = index.starts_with(|letter: char| letter.is_ascii_alphabetic());
    (is_name && index.bytes().all(|byte| byte.is_ascii_alphanumeric())).then_some(index.len() + 2)
}

/// True if a text begins with a component of a vector: `.x`.
fn is_component(text: &str) -> bool {
    let mut letters = text.chars().skip(1);
    let is_axis = letters.next().is_some_and(|axis| ('x'..='z').contains(&axis));
    is_axis && !letters.next().is_some_and(|next| next.is_alphanumeric() || next == '_')
}

/// Subscript form of a digit; `None` for brackets.
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
    // Only digits have subscript forms in every font.
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
            ("e[j]", "e_j"),
            ("x[i]' - x[i+1]", "x_i′ − x[i+1]"),
            ("r.x", "r_x"),
            ("r[1].x", "r₁_x"),
            ("v_1.y'", "v₁_y′"),
            ("landing.x + 2.5", "landing.x + 2.5"),
            ("1 [m]", "1 [m]"),
            ("a_", "a"),
            ("", ""),
        ] {
            assert_eq!(symbol(text), expected);
        }
    }
}
