//! Counters of a clock that overflow: `micros()` of an Arduino falls by 2³² after 71.6 minutes, a timer of 16 bits by 2¹⁶.

use crate::roles;
use crate::table::Column;
use units::Dimension;

/// Widths of counters in bits, the smaller first.
const WIDTHS: [i32; 2] = [16, 32];
/// Least number of steps without a fall, which show how far a step can be.
const LEAST_STEPS: usize = 3;
/// Greatest ratio of the step at a fall to the greatest other step.
const LONGEST_STEP: f64 = 2.0;
/// Names of counters, besides those of times.
const COUNTERS: [&str; 7] = ["micros", "millis", "ticks", "tick", "counter", "clock", "systick"];

/// Overflow of a counter that was undone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::import) struct Overflow {
    /// Index of the column.
    pub column: usize,
    /// Width of the counter in bits.
    pub bits: i32,
    /// Number of overflows.
    pub count: usize,
}

/// Undoes the overflows of clocks: after each fall the width is added, exactly. A fall is an overflow only if the step
/// across it is then as long as the others; a clock that restarts is left alone.
pub(in crate::import) fn undo(columns: &mut [Column]) -> Vec<Overflow> {
    let mut undone = Vec::new();
    for (index, column) in columns.iter_mut().enumerate() {
        let name = column.name.to_lowercase();
        let of_time = column.unit.as_ref().is_some_and(|unit| unit.dimension == Dimension::TIME);
        let clock = index == 0
            || of_time
            || roles::is_time(&column.name)
            || COUNTERS.iter().any(|counter| name.starts_with(counter));
        if !clock {
            continue;
        }
        let Some(bits) = WIDTHS.into_iter().find(|bits| overflows(&column.values, modulus(*bits))) else { continue };
        let (mut added, mut before, mut count) = (0.0, f64::NEG_INFINITY, 0);
        for value in &mut column.values {
            if *value < before {
                added += modulus(bits);
                count += 1;
            }
            before = *value;
            *value += added;
        }
        undone.push(Overflow { column: index, bits, count });
    }
    undone
}

fn modulus(bits: i32) -> f64 {
    libm::ldexp(1.0, bits)
}

/// True if the values are those of a counter of this modulus that only falls by overflowing.
fn overflows(values: &[f64], modulus: f64) -> bool {
    let within = |low: f64| values.iter().all(|value| (low..low + modulus).contains(value));
    if !(within(0.0) || within(-0.5 * modulus)) || values.iter().any(|value| value.fract() != 0.0) {
        return false;
    }
    let steps = || values.windows(2).map(|pair| pair[1] - pair[0]);
    let longest = steps().filter(|step| *step >= 0.0).fold(0.0, f64::max);
    let rises = steps().filter(|step| *step > 0.0).count();
    let mut falls = steps().filter(|step| *step < 0.0).peekable();
    falls.peek().is_some()
        && rises >= LEAST_STEPS
        && longest < 0.25 * modulus
        && falls.all(|fall| fall + modulus > 0.0 && fall + modulus <= LONGEST_STEP * longest)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn undone(values: &[f64]) -> (Vec<f64>, Vec<Overflow>) {
        let mut columns = vec![Column { values: values.to_vec(), ..Column::default() }];
        let found = undo(&mut columns);
        (columns.remove(0).values, found)
    }

    #[test]
    fn a_counter_goes_on_after_an_overflow() {
        let (values, found) = undone(&[65400.0, 65450.0, 65500.0, 65530.0, 14.0, 60.0]);
        assert_eq!(values, [65400.0, 65450.0, 65500.0, 65530.0, 65550.0, 65596.0]);
        assert_eq!(found, [Overflow { column: 0, bits: 16, count: 1 }]);
        let (values, _) = undone(&[4294967000.0, 4294967100.0, 4294967200.0, 4294967290.0, 94.0]);
        assert_eq!(values[4], 4294967390.0);
        let (values, found) = undone(&[32000.0, 32400.0, 32700.0, 32767.0, -32500.0, -32100.0]);
        assert_eq!((values[4], found[0].bits), (33036.0, 16));
        let values: Vec<f64> = (0..40).map(|row| f64::from(row * 5000 % 65536)).collect();
        assert_eq!(undone(&values).0, (0..40).map(|row| f64::from(row * 5000)).collect::<Vec<_>>());
    }

    #[test]
    fn a_clock_that_restarts_is_left_alone() {
        for values in [
            &[0.0, 50.0, 100.0, 150.0, 0.0, 50.0][..],
            &[0.0, 0.5, 65535.0, 0.0, 0.5],
            &[65530.0, 65531.0, 1.0],
            &[60000.0, 60100.0, 60200.0, 60300.0, 0.0, 100.0],
            &[5.0, 4.0, 3.0, 2.0],
            &[0.0, 30000.0, 60000.0, 24464.0, 54464.0],
            &[f64::NAN, 1.0, 2.0, 3.0, 0.0],
        ] {
            assert_eq!(undone(values).1, [], "{values:?}");
        }
    }
}
