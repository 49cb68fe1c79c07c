//! Prefixes of units chosen for readable numbers: `mm` for small lengths.

use crate::Unit;

/// Prefixes in common use with most units, ascending.
const USUAL: [(&str, i32); 7] = [("p", -12), ("n", -9), ("µ", -6), ("m", -3), ("k", 3), ("M", 6), ("G", 9)];

/// Numbers from this one up to [`LARGE`] are readable without another prefix.
const SMALL: f64 = 1e-3;
const LARGE: f64 = 1e6;

/// Lower bound for residuals and errors, whose unit was not chosen by the author.
const SMALL_RESIDUAL: f64 = 1e-2;

impl Unit {
    /// This unit times 10^`power`, by a prefix: `mm` for a metre and -3, `mm^2` for a square metre and -6. `None` if the
    /// unit takes no prefix or only an unusual one (`ks`, `Mm`).
    pub fn with_power(&self, power: i32) -> Option<Self> {
        if self.text.is_empty() {
            return None;
        }
        let symbol = self.text.find(|c: char| !c.is_alphabetic()).map_or(self.text.as_str(), |end| &self.text[..end]);
        let greatest = match symbol {
            "s" | "rad" | "K" => 0,
            "m" => 3,
            _ => i32::MAX,
        };
        let wanted = crate::number::decimal(&format!("1e{power}"))?;
        USUAL.iter().filter(|(_, tens)| *tens <= greatest).find_map(|(prefix, _)| {
            let unit = Self::parse(&[prefix, self.text.as_str()].concat()).ok()?;
            let ratio = unit.factor / self.factor / wanted;
            (unit.dimension == self.dimension && (ratio - 1.0).abs() < 1e-9).then_some(unit)
        })
    }

    /// The best unit for numbers up to `size` (in this unit): this one from 0.001 to 10⁶, otherwise one with a prefix if
    /// that helps.
    pub fn for_size(&self, size: f64) -> Self {
        self.with_prefix(size, SMALL)
    }

    /// [`Unit::for_size`] for residuals and errors: a finer unit below 0.01.
    pub fn for_residuals(&self, size: f64) -> Self {
        self.with_prefix(size, SMALL_RESIDUAL)
    }

    fn with_prefix(&self, size: f64, small: f64) -> Self {
        if size == 0.0 || !size.is_finite() || (small..LARGE).contains(&size) {
            return self.clone();
        }
        let fits = |power: i32| {
            let unit = self.with_power(power)?;
            let own = size * (self.factor / unit.factor);
            (0.1..LARGE).contains(&own).then_some(unit)
        };
        let found = if size < small {
            [-3, -6, -9, -12].into_iter().find_map(fits)
        } else {
            [9, 6, 3].into_iter().find_map(|power| fits(power).filter(|unit| size * (self.factor / unit.factor) >= 1.0))
        };
        found.unwrap_or_else(|| self.clone())
    }
}

#[cfg(test)]
mod tests {
    use crate::Unit;

    #[test]
    fn units_follow_the_size_of_their_numbers() {
        for (text, size, expected) in [
            ("m", 0.2, "m"),
            ("m", 0.001_41, "m"),
            ("m", 0.000_7, "mm"),
            ("m", 9e-5, "µm"),
            ("m", 2e-6, "µm"),
            ("m", 2e-9, "nm"),
            ("m", 2e-20, "m"),
            ("m", 2e6, "km"),
            ("m", 2e12, "m"),
            ("m/s", 0.000_3, "mm/s"),
            ("m^2", 5e-4, "mm^2"),
            ("mm", 2e-6, "mm"),
            ("kg", 1e-4, "kg"),
            ("1/s", 0.000_3, "1/s"),
            ("", 1e-4, ""),
            ("deg", 1e-4, "deg"),
            ("rad", 0.000_3, "mrad"),
            ("s", 2e6, "s"),
            ("J", 2e6, "MJ"),
            ("Pa s", 3e-4, "mPa s"),
            ("N/m", 3e7, "MN/m"),
            ("m", f64::NAN, "m"),
            ("m", 0.0, "m"),
        ] {
            assert_eq!(Unit::parse(text).unwrap().for_size(size).text, expected, "{text} {size}");
        }
        for (text, size, expected) in [("m", 0.02, "m"), ("m", 0.005, "mm"), ("rad", 0.003, "mrad"), ("kg", 1e-3, "kg")]
        {
            assert_eq!(Unit::parse(text).unwrap().for_residuals(size).text, expected, "{text} {size}");
        }
    }

    #[test]
    fn prefixed_units_are_exact() {
        let metre = Unit::parse("m").unwrap();
        assert_eq!(metre.with_power(-3).unwrap().from_si(0.000_593), 0.593);
        assert_eq!(metre.with_power(6), None);
        assert_eq!(metre.with_power(-4), None);
    }
}
