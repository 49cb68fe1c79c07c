//! Characters that stand for something in ASCII: Greek letters, primes, lowered digits.

/// Greek letters in the order of Unicode, small ones from α; ς is not used in formulas.
const SMALL: [&str; 25] = [
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa", "lambda", "mu", "nu", "xi",
    "omicron", "pi", "rho", "", "sigma", "tau", "upsilon", "phi", "chi", "psi", "omega",
];

/// Capital Greek letters from Α; the empty one is not assigned.
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
        // The micro sign, the increment and the ohm sign look like letters.
        '\u{B5}' => "mu",
        '\u{2206}' => "Delta",
        '\u{2126}' => "Omega",
        _ => return None,
    };
    (!name.is_empty()).then_some(name)
}

/// The Greek letter that an ASCII name spells; capitals that look Latin (`Alpha`) are Greek too.
pub fn greek_letter(name: &str) -> Option<char> {
    // Most names are a letter, and none of a Greek one is so short.
    if name.len() < 2 {
        return None;
    }
    let at = |letters: &[&str], first: char| {
        let offset = letters.iter().position(|candidate| *candidate == name)?;
        char::from_u32(first as u32 + offset as u32)
    };
    // In formulas φ is written as ϕ by some and ε as ϵ; the plain letters are in every font.
    at(&SMALL, 'α').or_else(|| at(&CAPITAL, 'Α'))
}

/// The capital of a small letter of Latin-1, as in English and Spanish, or of Greek; every other character as it is. The tables
/// of Unicode, behind [`char::to_uppercase`], would be a fortieth of each exported page.
pub fn capital(letter: char) -> char {
    match letter {
        'a'..='z' | 'à'..='ö' | 'ø'..='þ' | 'α'..='ρ' | 'σ'..='ω' => {
            char::from_u32(letter as u32 - 0x20).unwrap_or(letter)
        }
        _ => letter,
    }
}

/// How many primes a character stands for.
pub fn primes(character: char) -> Option<u32> {
    match character {
        '\'' | '’' | '‘' | '′' | '´' | 'ʹ' | 'ʼ' => Some(1),
        '″' | 'ʺ' | '”' => Some(2),
        '‴' => Some(3),
        '⁗' => Some(4),
        _ => None,
    }
}

/// The character that a lowered one stands for: `0` for ₀.
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
    fn capitals_are_those_of_unicode() {
        for letter in ('\0'..'\u{ff}').chain('α'..='ω').filter(|letter| !matches!(letter, 'ß' | 'µ' | 'ς')) {
            assert_eq!(capital(letter).to_string(), letter.to_uppercase().to_string());
        }
        assert_eq!(['ß', 'ς', '÷', '²'].map(capital), ['ß', 'ς', '÷', '²']);
    }
}
