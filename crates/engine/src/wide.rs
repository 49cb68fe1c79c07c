//! Loops over many numbers with the widest registers of the processor. The bits do not depend on them.

/// Work with such loops. [`Wide::run`] and all functions in it with loops must be `#[inline(always)]`: closures and function items
/// that are called are compiled without these registers.
pub trait Wide {
    /// Does the work.
    fn run(self);
}

#[cfg(not(target_arch = "wasm32"))]
struct Work<W>(W);

#[cfg(not(target_arch = "wasm32"))]
impl<W: Wide> pulp::WithSimd for Work<W> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _simd: S) {
        self.0.run();
    }
}

/// Does the work with the best registers that the processor has, at most those of AVX-512.
#[cfg(not(target_arch = "wasm32"))]
pub fn run_wide(work: impl Wide) {
    pulp::Arch::new().dispatch(Work(work));
}

/// Does the work. Modules of pages are compiled without such registers.
#[cfg(target_arch = "wasm32")]
pub fn run_wide(work: impl Wide) {
    work.run();
}

/// Inner product, in four partial sums: additions to a single sum would have to wait for each other.
// In pages the functions here are compiled once, for speed, though their callers are optimized for size.
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    let length = a.len().min(b.len());
    let (a_fours, a_rest) = a[..length].as_chunks::<4>();
    let (b_fours, b_rest) = b[..length].as_chunks::<4>();
    let rest = a_rest.iter().zip(b_rest).fold(0.0, |sum, (a, b)| sum + a * b);
    let mut sums = [0.0; 4];
    for (a, b) in a_fours.iter().zip(b_fours) {
        for (sum, (a, b)) in sums.iter_mut().zip(a.iter().zip(b)) {
            *sum += a * b;
        }
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest
}

/// Subtracts from each of `values` the entry of `other` at its place times `factor`.
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
pub fn subtract_multiple(values: &mut [f64], factor: f64, other: &[f64]) {
    for (value, other) in values.iter_mut().zip(other) {
        *value -= factor * other;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whole numbers, whose sums are exact in any order; lengths around a multiple of four.
    #[test]
    fn products_and_differences_of_any_length() {
        for length in 0..11_i32 {
            let one: Vec<f64> = (1..=length).map(f64::from).collect();
            let squares = f64::from(length * (length + 1) * (2 * length + 1) / 6);
            assert_eq!(dot(&one, &one), squares);
            let mut left = one.clone();
            subtract_multiple(&mut left, 3.0, &one);
            assert!(left.iter().zip(&one).all(|(left, one)| *left == -2.0 * one));
        }
    }
}
