//! The number of a decimal text, correctly rounded.
//!
//! The standard library's parser has 12 kB of tables that hardly compress, a fiftieth of what a page sends before its first
//! picture. This one needs none: few digits are exact in binary, and others are divided as long integers.

use std::cmp::Ordering;

/// Powers of ten that a double holds exactly.
const POWERS: [f64; 23] = {
    let mut powers = [1.0; 23];
    let mut index = 1;
    while index < powers.len() {
        powers[index] = powers[index - 1] * 10.0;
        index += 1;
    }
    powers
};

/// Number of digits that a double of that many digits is sure to hold exactly.
const EXACT: usize = 15;

/// Number of digits after which only matters whether any other is not zero: the middle between two doubles has at most 768.
const DIGITS: usize = 800;

/// Number of bits of the mantissa of a normal double.
const BITS: i64 = 53;

/// Reads a number as [`str::parse`] does, with the same bits: `-1.5e-3`, `.5`, `inf`, `NaN`. `None` for any other text.
pub fn decimal(text: &str) -> Option<f64> {
    let unsigned = text.strip_prefix(['-', '+']).unwrap_or(text);
    let size = match unsigned {
        _ if unsigned.eq_ignore_ascii_case("inf") || unsigned.eq_ignore_ascii_case("infinity") => f64::INFINITY,
        _ if unsigned.eq_ignore_ascii_case("nan") => f64::NAN,
        _ => size(unsigned)?,
    };
    Some(if text.starts_with('-') { -size } else { size })
}

/// Number of a text without sign.
fn size(text: &str) -> Option<f64> {
    let (digits, exponent) = match text.split_once(['e', 'E']) {
        Some((digits, exponent)) => (digits, self::exponent(exponent)?),
        None => (text, 0),
    };
    let (whole, part) = digits.split_once('.').unwrap_or((digits, ""));
    let all = || whole.bytes().chain(part.bytes());
    if whole.len() + part.len() == 0 || !all().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let mut digits: Vec<u8> = all().map(|byte| byte - b'0').skip_while(|digit| *digit == 0).collect();
    let mut tens = exponent - part.len() as i64;
    if digits.len() > DIGITS {
        let rest = digits.split_off(DIGITS);
        tens += rest.len() as i64 - 1;
        digits.push(u8::from(rest.iter().any(|digit| *digit > 0)));
    }
    Some(nearest(&digits, tens))
}

/// Exponent of ten, limited to what tells infinity and zero from the rest.
fn exponent(text: &str) -> Option<i64> {
    let digits = text.strip_prefix(['-', '+']).unwrap_or(text);
    if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let size = digits.bytes().fold(0, |size: i64, byte| (10 * size + i64::from(byte - b'0')).min(1 << 40));
    Some(if text.starts_with('-') { -size } else { size })
}

/// The double nearest to the integer of these digits, of which the first is not 0, times a power of ten; of two the even one.
fn nearest(digits: &[u8], tens: i64) -> f64 {
    let places = digits.len() as i64 + tens;
    if digits.is_empty() || places < -324 {
        return 0.0;
    }
    if places > 310 {
        return f64::INFINITY;
    }
    let power = usize::try_from(tens.unsigned_abs()).unwrap_or(usize::MAX);
    if let (true, Some(power)) = (digits.len() <= EXACT, POWERS.get(power)) {
        let integer = digits.iter().fold(0.0, |integer, digit| 10.0 * integer + f64::from(*digit));
        return if tens < 0 { integer / power } else { integer * power };
    }
    let (mut above, mut below) = (Long::of(digits), Long::of(&[1]));
    for _ in 0..power {
        if tens < 0 { below.times_and(10, 0) } else { above.times_and(10, 0) }
    }
    // From here on the number is `above / below` times a power of two, and the quotient is at least 1 and less than 2.
    let mut twos = above.bits() - below.bits();
    if twos > 0 {
        below.double(twos)
    } else {
        above.double(-twos)
    }
    if above.compare(&below) == Ordering::Less {
        above.double(1);
        twos -= 1;
    }
    let kept = BITS + (twos + 1022).min(0);
    if kept < 0 {
        return 0.0;
    }
    let mut mantissa = 0_u64;
    for _ in 0..kept {
        mantissa *= 2;
        if above.compare(&below) != Ordering::Less {
            above.subtract(&below);
            mantissa += 1;
        }
        above.double(1);
    }
    mantissa += match above.compare(&below) {
        Ordering::Less => 0,
        Ordering::Equal => mantissa % 2,
        Ordering::Greater => 1,
    };
    // The leading bit of a normal mantissa adds 1 to the exponent, as does a carry.
    let exponent = if kept == BITS { (twos + 1022) as u64 } else { 0 };
    let bits = (exponent << (BITS - 1)) + mantissa;
    f64::from_bits(bits.min(f64::INFINITY.to_bits()))
}

/// A natural number of any length: digits to the base 2^32, the lowest first, the highest not 0.
struct Long(Vec<u32>);

impl Long {
    fn of(digits: &[u8]) -> Self {
        let mut long = Self(Vec::new());
        digits.iter().for_each(|digit| long.times_and(10, u32::from(*digit)));
        long
    }

    /// Multiplies by a factor and adds a summand.
    fn times_and(&mut self, factor: u32, summand: u32) {
        let mut carry = u64::from(summand);
        for digit in &mut self.0 {
            carry += u64::from(*digit) * u64::from(factor);
            *digit = carry as u32;
            carry >>= 32;
        }
        if carry > 0 {
            self.0.push(carry as u32);
        }
    }

    /// Number of bits.
    fn bits(&self) -> i64 {
        let highest = self.0.last().map_or(0, |digit| digit.leading_zeros());
        32 * self.0.len() as i64 - i64::from(highest)
    }

    /// Multiplies by 2 this many times.
    fn double(&mut self, times: i64) {
        if self.0.is_empty() {
            return;
        }
        if times % 32 > 0 {
            self.times_and(1 << (times % 32), 0);
        }
        if times >= 32 {
            self.0.splice(0..0, std::iter::repeat_n(0, (times / 32) as usize));
        }
    }

    fn compare(&self, other: &Self) -> Ordering {
        self.0.len().cmp(&other.0.len()).then_with(|| self.0.iter().rev().cmp(other.0.iter().rev()))
    }

    /// Subtracts a number that is not greater.
    fn subtract(&mut self, other: &Self) {
        let mut borrowed = false;
        for (place, digit) in self.0.iter_mut().enumerate() {
            let (less, below) = digit.overflowing_sub(other.0.get(place).copied().unwrap_or(0));
            let (less, again) = less.overflowing_sub(u32::from(borrowed));
            (*digit, borrowed) = (less, below || again);
        }
        while self.0.last() == Some(&0) {
            self.0.pop();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::decimal;
    use proptest::prelude::*;

    /// The text is read as the standard library reads it.
    fn is_same(text: &str) {
        let expected = text.parse::<f64>().ok().map(f64::to_bits);
        assert_eq!(decimal(text).map(f64::to_bits), expected, "{text}");
    }

    #[test]
    fn limits_and_middles_are_rounded_as_by_the_standard_library() {
        for text in [
            "0",
            "-0",
            "1",
            "+1",
            "-1.5",
            ".5",
            "5.",
            "1e3",
            "1E-3",
            "1e+3",
            "",
            ".",
            "-",
            "+-1",
            "e5",
            "1e",
            "1e+",
            "1 ",
            "0x1",
            "1_0",
            "inf",
            "-inf",
            "Infinity",
            "nan",
            "NaN",
            "infinit",
            "1.2.3",
            "1e1.5",
            "١",
            "1.7976931348623157e308",
            "1.7976931348623158e308",
            "1.7976931348623159e308",
            "1e309",
            "1e99999999999999999999",
            "2.2250738585072014e-308",
            "2.2250738585072011e-308",
            "4.9e-324",
            "2.4703282292062328e-324",
            "2.4703282292062327e-324",
            "2.5e-324",
            "1e-324",
            "1e-99999999999999999999",
            "0e99999999999999999999",
            "9007199254740993",
            "9007199254740992.99999",
            "9007199254740993.00001",
            "123456789012345678901234567890",
            "8.988465674311579e307",
            "1e22",
            "1e23",
            "8.41e21",
            "6.9294956446009195e15",
            "0.1",
            "0.3",
            "3.3e-5",
            "179769313486231580793728971405303415079934132710037826936173778980444968292764750946649017977587207096330286416692887910946555547851940402630657488671505820681908902000708383676273854845817711531764475730270069855571366959622842914819860834936475292719074168444365510704342711559699508093042880",
        ] {
            is_same(text);
        }
        // The middle between two doubles, exactly and with a digit far behind.
        let middle = format!("{:.200}", 1.0 + f64::EPSILON).trim_end_matches('0').to_owned();
        for end in ["", "0001", "5"] {
            is_same(&format!("{middle}{end}"));
            is_same(&format!("1.00000000000000011102230246251565404236316680908203125{}{end}", "0".repeat(900)));
        }
    }

    proptest! {
        #[test]
        fn every_double_is_read_back(bits in any::<u64>()) {
            let value = f64::from_bits(bits);
            is_same(&format!("{value}"));
            is_same(&format!("{value:e}"));
            is_same(&format!("{value:.40e}"));
        }

        #[test]
        fn any_digits_are_rounded(digits in "[0-9]{0,30}\\.?[0-9]{0,30}", exponent in -345..330) {
            is_same(&format!("{digits}e{exponent}"));
            is_same(&digits);
        }

        #[test]
        fn other_texts_are_refused(text in "[-+.0-9eEinfaINFA ]{0,8}") {
            is_same(&text);
        }
    }
}
