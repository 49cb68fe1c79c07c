//! Characters with an ASCII equivalent: Greek letters, primes, subscripts.

/// Names of the small Greek letters from α on, in the order of Unicode; ς is empty because it is not used in formulas.
const SMALL: [&str; 25] = [
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa", "lambda", "mu", "nu", "xi",
    "omicron", "pi", "rho", "", "sigma", "tau", "upsilon", "phi", "chi", "psi", "omega",
];

/// Names of the capital Greek letters from Α on; the empty one is not assigned in Unicode.
const CAPITAL: [&str; 25] = [
    "Alpha", "Beta", "Gamma", "Delta", "Epsilon", "Zeta", "Eta", "Theta", "Iota", "Kappa", "Lambda", "Mu", "Nu", "Xi",
    "Omicron", "Pi", "Rho", "", "Sigma", "Tau", "Upsilon", "Phi", "Chi", "Psi", "Omega",
];

/// The ASCII name of a Greek letter in any of its usual forms.
pub fn greek_name(letter: char) -> Option<&'static str> {
    let name = match letter {
        'α'..='ω' => SMALL.get(letter as usize - 'α' as usize).copied()?,
        'Α'..='Ω' => CAPITAL.get(letter as usize - 'Α' as usize).copied()?,
        'ϑ' => "theta",
        'ϕ' => "phi",
        'ϵ' => "epsilon",
        'ϱ' => "rho",
        'ϖ' => "pi",
        'ϰ' => "kappa",
        // Micro sign, increment and ohm sign look like Greek letters.
        '\u{B5}' => "mu",
        '\u{2206}' => "Delta",
        '\u{2126}' => "Omega",
        _ => return None,
    };
    (!name.is_empty()).then_some(name)
}

/// The Greek letter with this ASCII name; includes capitals that look Latin (`Alpha`).
pub fn greek_letter(name: &str) -> Option<char> {
    // Most names are a single letter; the shortest Greek name has two.
    if name.len() < 2 {
        return None;
    }
    let at = |letters: &[&str], first: char| {
        let offset = letters.iter().position(|candidate| *candidate == name)?;
        char::from_u32(first as u32 + offset as u32)
    };
    // Variants such as ϕ and ϵ are not used: the plain letters φ and ε are in every font.
    at(&SMALL, 'α').or_else(|| at(&CAPITAL, 'Α'))
}

/// Capital of a small letter of English, Spanish (Latin-1) or Greek; every other character unchanged.
/// [`char::to_uppercase`] would add the tables of Unicode, 1/40 of the size of an exported page.
pub fn capital(letter: char) -> char {
    match letter {
        'a'..='z' | 'à'..='ö' | 'ø'..='þ' | 'α'..='ρ' | 'σ'..='ω' => {
            char::from_u32(letter as u32 - 0x20).unwrap_or(letter)
        }
        _ => letter,
    }
}

/// Text with a capital first letter, by the tables of Unicode: `period` becomes `Period`. Pages of a single simulation use
/// [`capital`] instead.
pub fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// Removes the accent of a letter of Latin-1, as in Spanish, Portuguese and French; every other character unchanged.
pub fn without_accent(letter: char) -> char {
    match letter {
        'à'..='å' => 'a',
        'ç' => 'c',
        'è'..='ë' => 'e',
        'ì'..='ï' => 'i',
        'ñ' => 'n',
        'ò'..='ö' | 'ø' => 'o',
        'ù'..='ü' => 'u',
        'ý' | 'ÿ' => 'y',
        'À'..='Ö' | 'Ø'..='Ý' => {
            without_accent(char::from_u32(letter as u32 + 0x20).unwrap_or(letter)).to_ascii_uppercase()
        }
        _ => letter,
    }
}

/// Text for comparison: in lower case, without accents.
pub fn plain(text: &str) -> String {
    let is_combining = |letter: &char| ('\u{300}'..='\u{36f}').contains(letter);
    text.to_lowercase().chars().filter(|letter| !is_combining(letter)).map(without_accent).collect()
}

/// Number of primes that a character means, `None` if it is no prime.
pub fn primes(character: char) -> Option<u32> {
    match character {
        '\'' | '’' | '‘' | '′' | '´' | 'ʹ' | 'ʼ' => Some(1),
        '″' | 'ʺ' | '”' => Some(2),
        '‴' => Some(3),
        '⁗' => Some(4),
        _ => None,
    }
}

/// The character of a subscript: `0` for ₀; `None` if it is no subscript.
pub fn lowered(character: char) -> Option<char> {
    Some(match character {
        '₀' => '0',
        '₁' => '1',
        '₂' => '2',
        '₃' => '3',
        '₄' => '4',
        '₅' => '5',
        '₆' => '6',
        '₇' => '7',
        '₈' => '8',
        '₉' => '9',
        'ₐ' => 'a',
        'ₑ' => 'e',
        'ₕ' => 'h',
        'ᵢ' => 'i',
        'ⱼ' => 'j',
        'ₖ' => 'k',
        'ₗ' => 'l',
        'ₘ' => 'm',
        'ₙ' => 'n',
        'ₒ' => 'o',
        'ₚ' => 'p',
        'ᵣ' => 'r',
        'ₛ' => 's',
        'ₜ' => 't',
        'ᵤ' => 'u',
        'ᵥ' => 'v',
        'ₓ' => 'x',
        _ => return None,
    })
}

/// Splits a text at its indices: `h_l` means h with the index l. Each piece comes with true if it is an index. An index
/// consists of letters and digits and follows a letter, a digit or a prime.
pub fn with_indices(text: &str) -> impl Iterator<Item = (&str, bool)> {
    let mut rest = text;
    let mut index = 0;
    std::iter::from_fn(move || {
        if rest.is_empty() {
            return None;
        }
        let is_index = index > 0;
        let length = if is_index { index } else { before_index(rest) };
        let (piece, after) = rest.split_at(length);
        rest = if is_index || after.is_empty() { after } else { &after[1..] };
        index = if is_index { 0 } else { index_length(rest) };
        Some((piece, is_index))
    })
}

/// Length in bytes of a text up to the underscore of its first index, or to its end.
fn before_index(text: &str) -> usize {
    let is_mark = |(at, _): &(usize, &str)| {
        let before = text[..*at].chars().next_back();
        let bears = before.is_some_and(|letter| letter.is_alphanumeric() || primes(letter).is_some());
        bears && index_length(&text[at + 1..]) > 0
    };
    text.match_indices('_').find(is_mark).map_or(text.len(), |(at, _)| at)
}

fn index_length(text: &str) -> usize {
    text.find(|letter: char| !letter.is_alphanumeric()).unwrap_or(text.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn greek_letters_have_names_and_back() {
        for (letter, name) in
            [('α', "alpha"), ('γ', "gamma"), ('π', "pi"), ('ρ', "rho"), ('ω', "omega"), ('Ω', "Omega")]
        {
            assert_eq!(greek_name(letter), Some(name));
            assert_eq!(greek_letter(name), Some(letter));
        }
        for (letter, name) in [('ϕ', "phi"), ('µ', "mu"), ('∆', "Delta")] {
            assert_eq!(greek_name(letter), Some(name));
        }
        assert_eq!(greek_name('ς'), None);
        assert_eq!(greek_name('a'), None);
        assert_eq!(greek_letter(""), None);
        assert_eq!(greek_letter("b"), None);
    }

    #[test]
    fn indices_are_told_from_the_rest() {
        let cases: [(&str, &[(&str, bool)]); 7] = [
            ("", &[]),
            ("y [cm]", &[("y [cm]", false)]),
            ("h_l", &[("h", false), ("l", true)]),
            ("h_r − h_l [m]", &[("h", false), ("r", true), (" − h", false), ("l", true), (" [m]", false)]),
            ("Δ_ρ", &[("Δ", false), ("ρ", true)]),
            ("_a b_ c__d", &[("_a b_ c__d", false)]),
            ("x_max′", &[("x", false), ("max", true), ("′", false)]),
        ];
        for (text, expected) in cases {
            assert_eq!(with_indices(text).collect::<Vec<_>>(), expected, "{text}");
        }
    }

    #[test]
    fn capitals_are_those_of_unicode() {
        for letter in ('\0'..'\u{ff}').chain('α'..='ω').filter(|letter| !matches!(letter, 'ß' | 'µ' | 'ς')) {
            assert_eq!(capital(letter).to_string(), letter.to_uppercase().to_string());
        }
        assert_eq!(['ß', 'ς', '÷', '²'].map(capital), ['ß', 'ς', '÷', '²']);
        for (text, expected) in [("", ""), ("período", "Período"), ("ánodo", "Ánodo"), ("ßa", "SSa"), ("1 a", "1 a")]
        {
            assert_eq!(capitalised(text), expected);
        }
    }
}
