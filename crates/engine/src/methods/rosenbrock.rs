//! RODAS: a Rosenbrock method of order 4 with an embedded method of order 3 for the error estimate, L-stable and stiffly
//! accurate, with a continuous extension of order 3 (Hairer & Wanner, Solving Ordinary Differential Equations II, 2nd ed.,
//! section IV.7, and the coefficients of their code RODAS, first set). A step solves six linear systems with the same
//! matrix and needs no iteration, so its work is fixed.
//!
//! In the transformed variables u: (1/(h gamma) - J) u_i = f(t + alpha_i h, y + sum a_ij u_j) + sum c_ij u_j / h
//! + gamma_i h df/dt.

use super::equations::Equations;
use super::jacobian::Jacobian;

const STAGES: usize = 6;
const GAMMA: f64 = 0.25;

/// Nodes alpha_i.
const NODES: [f64; STAGES] = [0.0, 0.386, 0.21, 0.63, 1.0, 1.0];

/// Weights gamma_i of the derivative with respect to the independent variable.
const TIME_WEIGHTS: [f64; STAGES] = [0.25, -0.1043, 0.1035, -0.0362, 0.0, 0.0];

/// Weights a_ij of earlier stages in the argument of f. The last row gives the embedded result. The result of order 4 is
/// that plus the last stage.
const STAGE_WEIGHTS: [&[f64]; STAGES] = [
    &[],
    &[1.544],
    &[0.946_678_528_081_582_6, 0.255_701_169_898_328_4],
    &[3.314_825_187_068_521, 2.896_124_015_972_201, 0.998_641_913_997_781_7],
    &[1.221_224_509_226_641, 6.019_134_481_288_629, 12.537_083_329_320_87, -0.687_886_036_105_895],
    &[1.221_224_509_226_641, 6.019_134_481_288_629, 12.537_083_329_320_87, -0.687_886_036_105_895, 1.0],
];

/// Weights c_ij of earlier stages in the right-hand side.
const SOLVED_WEIGHTS: [&[f64]; STAGES] = [
    &[],
    &[-5.6688],
    &[-2.430_093_356_833_875, -0.206_359_915_709_191_5],
    &[-0.107_352_905_815_137_5, -9.594_562_251_023_355, -20.470_286_148_096_16],
    &[7.496_443_313_967_647, -10.246_804_314_643_52, -33.999_903_528_199_05, 11.708_908_932_061_6],
    &[
        8.083_246_795_921_522,
        -7.981_132_988_064_893,
        -31.521_594_328_743_71,
        16.319_305_431_231_36,
        -6.058_818_238_834_054,
    ],
];

/// Weights of the two inner terms of the dense output.
const DENSE_WEIGHTS: [[f64; 5]; 2] = [
    [
        10.126_235_083_445_86,
        -7.487_995_877_610_167,
        -34.800_918_615_557_47,
        -7.992_771_707_568_823,
        1.025_137_723_295_662,
    ],
    [
        -0.676_280_339_280_689_8,
        6.087_714_651_680_015,
        16.430_843_208_924_78,
        24.767_225_114_183_86,
        -6.594_389_125_716_872,
    ],
];

/// Working storage of the method.
#[derive(Clone, Debug)]
pub(crate) struct Rosenbrock {
    /// The transformed stages u.
    solved: [Vec<f64>; STAGES],
    stage: Vec<f64>,
    rates: Vec<f64>,
    /// Jacobian entries in the order of the pattern, then the derivatives with respect to the independent variable.
    slopes: Vec<f64>,
    /// The matrix 1/(h gamma) - J.
    matrix: Jacobian,
    /// True if `slopes` belong to the start of the step.
    slopes_known: bool,
}

impl Rosenbrock {
    /// Prepares the method for `states` states; `pattern` has the indices of rate and state of all Jacobian entries that
    /// are not identically 0.
    pub fn new(states: usize, pattern: &[(usize, usize)]) -> Self {
        Self {
            solved: std::array::from_fn(|_| vec![0.0; states]),
            stage: vec![0.0; states],
            rates: vec![0.0; states],
            slopes: vec![0.0; pattern.len() + states],
            matrix: Jacobian::new(states, pattern),
            slopes_known: false,
        }
    }

    /// True if linear systems of this size and pattern are small enough to be solved.
    pub fn can_solve(states: usize, pattern: &[(usize, usize)]) -> bool {
        Jacobian::fits(states, pattern)
    }

    /// Discards the derivatives at the start of the step, after a step or a jump.
    pub fn reset(&mut self) {
        self.slopes_known = false;
    }

    /// Approximate number of operations per stage for its linear system, including its share of the factorization.
    pub fn work_of_stage(&self) -> u64 {
        self.matrix.work() / STAGES as u64
    }

    /// Makes one step of `size` from `from` at `time`; `to` becomes the result, `error` its estimated error. One value per
    /// state, SI units.
    pub fn step(
        &mut self,
        equations: &mut Equations,
        time: f64,
        size: f64,
        from: &[f64],
        to: &mut [f64],
        error: &mut [f64],
    ) {
        if !self.slopes_known {
            equations.slopes(time, from, &mut self.slopes);
            // The derivative of a root is infinite at its zero, and its product with 0 undefined. With any other matrix the
            // stages are still consistent, and the error estimate shortens the step.
            self.slopes.iter_mut().filter(|slope| !slope.is_finite()).for_each(|slope| *slope = 0.0);
            self.slopes_known = true;
        }
        let (by_states, by_time) = self.slopes.split_at(self.slopes.len() - from.len());
        self.matrix.factorize(1.0 / (size * GAMMA), by_states);
        for stage in 0..STAGES {
            let (known, rest) = self.solved.split_at_mut(stage);
            let Some(solved) = rest.first_mut() else {
                continue;
            };
            for (k, (value, from)) in self.stage.iter_mut().zip(from).enumerate() {
                *value = from + weighted(STAGE_WEIGHTS[stage], known, k);
            }
            equations.rates(time + NODES[stage] * size, &self.stage, &mut self.rates);
            for (k, right) in solved.iter_mut().enumerate() {
                let by_time = size * TIME_WEIGHTS[stage] * by_time[k];
                *right = self.rates[k] + weighted(SOLVED_WEIGHTS[stage], known, k) / size + by_time;
            }
            self.matrix.solve(solved);
        }
        let last = &self.solved[STAGES - 1];
        error.copy_from_slice(last);
        for ((to, stage), last) in to.iter_mut().zip(&self.stage).zip(last) {
            *to = stage + last;
        }
    }

    /// Coefficients of the dense output of the last step, one per state, in the form of [`super::dormand_prince::dense_value`].
    pub fn dense(&self, from: &[f64], to: &[f64], coefficients: &mut [Vec<f64>; 5]) {
        let [c_0, c_1, c_2, c_3, c_4] = coefficients;
        for k in 0..from.len() {
            c_0[k] = from[k];
            c_1[k] = to[k] - from[k];
            c_2[k] = weighted(&DENSE_WEIGHTS[0], &self.solved, k);
            c_3[k] = weighted(&DENSE_WEIGHTS[1], &self.solved, k);
            c_4[k] = 0.0;
        }
    }
}

fn weighted(weights: &[f64], solved: &[Vec<f64>], k: usize) -> f64 {
    weights.iter().zip(solved).fold(0.0, |sum, (weight, solved)| sum + weight * solved[k])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::methods::linear::Factors;
    use crate::methods::order_conditions;
    use crate::methods::order_conditions::Method;

    fn lower(rows: [&[f64]; STAGES]) -> Vec<Vec<f64>> {
        rows.iter().map(|row| (0..STAGES).map(|k| row.get(k).copied().unwrap_or_default()).collect()).collect()
    }

    /// Gamma = (I/gamma - C)^-1, column by column.
    fn gammas() -> Vec<Vec<f64>> {
        let solved = lower(SOLVED_WEIGHTS);
        let mut factors = Factors::new(STAGES);
        for (row, solved) in solved.iter().enumerate() {
            for (column, value) in solved.iter().enumerate() {
                let diagonal = if row == column { 1.0 / GAMMA } else { 0.0 };
                factors.values[row * STAGES + column] = diagonal - value;
            }
        }
        factors.factorize();
        let unit = |column: usize| (0..STAGES).map(move |row| if row == column { 1.0 } else { 0.0 });
        let columns: Vec<Vec<f64>> = (0..STAGES)
            .map(|column| {
                let mut right: Vec<f64> = unit(column).collect();
                factors.solve(&mut right);
                right
            })
            .collect();
        (0..STAGES).map(|row| columns.iter().map(|column| column[row]).collect()).collect()
    }

    /// Weights of the original stages from those of the transformed ones.
    fn original(weights: &[f64]) -> Vec<f64> {
        let gammas = gammas();
        (0..STAGES).map(|k| (0..STAGES).map(|j| weights[j] * gammas[j][k]).sum()).collect()
    }

    fn method(weights: &[f64]) -> Method {
        let several: Vec<Vec<f64>> = lower(STAGE_WEIGHTS).iter().map(|row| original(row)).collect();
        let single = several
            .iter()
            .zip(gammas())
            .map(|(alphas, gammas)| alphas.iter().zip(gammas).map(|(alpha, gamma)| alpha + gamma).collect())
            .collect();
        Method { single, several, weights: original(weights) }
    }

    const RESULT: [f64; STAGES] =
        [STAGE_WEIGHTS[5][0], STAGE_WEIGHTS[5][1], STAGE_WEIGHTS[5][2], STAGE_WEIGHTS[5][3], 1.0, 1.0];

    #[test]
    fn the_coefficients_fulfil_the_conditions_of_their_orders() {
        let result = method(&RESULT);
        let embedded = method(&[RESULT[0], RESULT[1], RESULT[2], RESULT[3], 1.0, 0.0]);
        for order in 1..=4 {
            let residual = result.residual(order, 1.0);
            assert!(residual < 1e-13, "order {order}: {residual:e}");
        }
        for order in 1..=3 {
            let residual = embedded.residual(order, 1.0);
            assert!(residual < 1e-13, "embedded, order {order}: {residual:e}");
        }
        assert!(embedded.residual(4, 1.0) > 1e-4);
        assert!(result.residual(5, 1.0) > 1e-5);
    }

    #[test]
    fn the_weights_of_time_are_the_sums_of_their_rows() {
        let method = method(&RESULT);
        for stage in 0..STAGES {
            assert!((method.several[stage].iter().sum::<f64>() - NODES[stage]).abs() < 1e-13);
            assert!((gammas()[stage].iter().sum::<f64>() - TIME_WEIGHTS[stage]).abs() < 1e-13);
        }
    }

    #[test]
    fn it_is_stiffly_accurate_and_damps_infinitely_stiff_parts_at_once() {
        // The result is the last stage's argument, b_j = alpha_6j + gamma_6j: then R(infinity) = 0, and with all
        // diagonal elements gamma = 1/4 the method is L-stable (Hairer & Wanner II, table IV.6.4).
        let method = method(&RESULT);
        for stage in 0..STAGES {
            assert!((method.weights[stage] - method.single[STAGES - 1][stage]).abs() < 1e-13);
        }
    }

    #[test]
    fn the_error_falls_with_the_fourth_power_of_a_constant_step() {
        let order = order_conditions::measured(|equations, time, size, from, to| {
            let mut pair = Rosenbrock::new(2, equations.pattern());
            pair.step(equations, time, size, from, to, &mut [0.0; 2]);
        });
        assert!((order - 4.0).abs() < 0.15, "{order}");
    }

    #[test]
    fn the_dense_output_has_order_3_everywhere() {
        for part in [0.0, 0.3, 0.5, 0.8, 1.0] {
            let weights: Vec<f64> = (0..STAGES)
                .map(|stage| {
                    let mut step = Rosenbrock::new(1, &[]);
                    step.solved[stage][0] = 1.0;
                    let mut coefficients = std::array::from_fn(|_| vec![0.0]);
                    step.dense(&[0.0], &[RESULT[stage]], &mut coefficients);
                    let mut value = [0.0];
                    crate::methods::dormand_prince::dense_value(&coefficients, part, &mut value);
                    value[0]
                })
                .collect();
            for order in 1..=3 {
                let residual = method(&weights).residual(order, part);
                assert!(residual < 1e-13, "order {order} at {part}: {residual:e}");
            }
        }
    }
}
