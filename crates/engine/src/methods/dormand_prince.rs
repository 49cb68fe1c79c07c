//! Method of Dormand and Prince of order 5, with an embedded method of order 4 for the error estimate and a continuous
//! extension of order 4 (Dormand & Prince, J. Comp. Appl. Math. 6 (1980) 19; Hairer, Norsett & Wanner, Solving Ordinary
//! Differential Equations I, table II.5.2 and section II.6; last coefficients of the dense output as in their code DOPRI5).

use super::equations::Equations;
use super::tableau::{DENSE_WEIGHTS, ERROR_WEIGHTS, NODES, STAGE_WEIGHTS, STAGES};

/// Working storage of the method.
#[derive(Clone, Debug)]
pub(crate) struct DormandPrince {
    rates: [Vec<f64>; STAGES],
    /// Room for the state of a stage.
    stage: Vec<f64>,
    /// True if the first stage is known from the previous step.
    first_known: bool,
}

impl DormandPrince {
    pub fn new(states: usize) -> Self {
        Self { rates: std::array::from_fn(|_| vec![0.0; states]), stage: vec![0.0; states], first_known: false }
    }

    /// Discards the first stage, after a jump of the state or the parameters.
    pub fn reset(&mut self) {
        self.first_known = false;
    }

    /// Evaluates the rates at the start of the next step, `time` and `state` (SI), if they are not known, without counting.
    /// True if they were not known.
    pub fn find_first(&mut self, equations: &mut Equations, time: f64, state: &[f64]) -> bool {
        if !self.first_known {
            equations.rates(time, state, &mut self.rates[0]);
            equations.evaluations -= 1;
        }
        !self.first_known
    }

    /// Rates at the start of the next step.
    pub fn first(&self) -> &[f64] {
        &self.rates[0]
    }

    /// Sets the rates at the start of the next step.
    pub fn set_first(&mut self, rates: &[f64]) {
        self.rates[0].copy_from_slice(rates);
        self.first_known = true;
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
        if !self.first_known {
            equations.rates(time, from, &mut self.rates[0]);
            self.first_known = true;
        }
        let [first, .., last] = &mut self.rates;
        if equations.attempt_compiled(time, size, from, to, error, [first, last]) {
            return;
        }
        self.stage::<1>(equations, (time, size), from);
        self.stage::<2>(equations, (time, size), from);
        self.stage::<3>(equations, (time, size), from);
        self.stage::<4>(equations, (time, size), from);
        self.stage::<5>(equations, (time, size), from);
        // The state of the last stage is the result.
        let [known @ .., last] = &mut self.rates;
        if let Some(weights) = STAGE_WEIGHTS[STAGES - 1].first_chunk() {
            weighted(to, weights, known, from, |from, sum| from + size * sum);
        }
        equations.rates(time + NODES[STAGES - 1] * size, to, last);
        weighted(error, &ERROR_WEIGHTS, &self.rates, from, |_, sum| sum * size);
    }

    /// Computes the rates of stage `NUMBER` of a step of `size` from the state `from` at `time`, SI units.
    #[inline]
    fn stage<const NUMBER: usize>(&mut self, equations: &mut Equations, (time, size): (f64, f64), from: &[f64]) {
        let (known, rest) = self.rates.split_at_mut(NUMBER);
        let Some((weights, (known, rates))) =
            STAGE_WEIGHTS[NUMBER].first_chunk::<NUMBER>().zip(known.first_chunk().zip(rest.first_mut()))
        else {
            return;
        };
        // Written where it is read, without a copy.
        let state = equations.state_mut().unwrap_or(&mut self.stage);
        weighted(state, weights, known, from, |from, sum| from + size * sum);
        equations.rates_at_written(time + NODES[NUMBER] * size, &self.stage, rates);
    }

    /// Coefficients of the dense output of the last step of `size` (SI), from the state `from` to `to`: five lists of one per state.
    pub fn dense(&self, size: f64, from: &[f64], to: &[f64], coefficients: &mut [Vec<f64>; 5]) {
        let [c_0, c_1, c_2, c_3, c_4] = coefficients.each_mut().map(|list| &mut list[..from.len()]);
        let [first, .., last] = self.rates.each_ref().map(|rates| &rates[..from.len()]);
        let to = &to[..from.len()];
        for k in 0..from.len() {
            let change = to[k] - from[k];
            let bend = size * first[k] - change;
            c_0[k] = from[k];
            c_1[k] = change;
            c_2[k] = bend;
            c_3[k] = change - size * last[k] - bend;
        }
        weighted(c_4, &DENSE_WEIGHTS, &self.rates, from, |_, sum| sum * size);
    }

    /// Stores the last stage of an accepted step as the first stage of the next one.
    pub fn accept(&mut self) {
        self.rates.swap(0, STAGES - 1);
    }
}

/// Evaluates the dense output at `part` of the step, 0 to 1; one value per state.
pub(crate) fn dense_value(coefficients: &[Vec<f64>; 5], part: f64, out: &mut [f64]) {
    let rest = 1.0 - part;
    let [c_0, c_1, c_2, c_3, c_4] = coefficients.each_ref().map(|list| &list[..out.len()]);
    for (k, value) in out.iter_mut().enumerate() {
        *value = c_0[k] + part * (c_1[k] + rest * (c_2[k] + part * (c_3[k] + rest * c_4[k])));
    }
}

/// to = result(from, weights . rates) for each state, summed from the left. With the number of stages as a constant, all of them
/// are summed in registers, for as many states at once as the processor has room for.
// Not inlined: the compiler then knows that `to` overlaps with nothing that is read.
#[inline(never)]
fn weighted<const COUNT: usize>(
    to: &mut [f64],
    weights: &[f64; COUNT],
    rates: &[Vec<f64>; COUNT],
    from: &[f64],
    result: impl Fn(f64, f64) -> f64,
) {
    // With all lengths known to be equal, the loop has no rest that is computed state by state.
    let rates = rates.each_ref().map(|rates| &rates[..to.len()]);
    let from = &from[..to.len()];
    for (k, (to, from)) in to.iter_mut().zip(from).enumerate() {
        let mut sum = 0.0;
        for (weight, rates) in weights.iter().zip(&rates) {
            sum += weight * rates[k];
        }
        *to = result(*from, sum);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::methods::order_conditions;
    use crate::methods::order_conditions::Method;

    fn method(weights: Vec<f64>) -> Method {
        let mut matrix = vec![vec![0.0; STAGES]; STAGES];
        for (row, weights) in matrix.iter_mut().zip(STAGE_WEIGHTS) {
            row[..weights.len()].copy_from_slice(weights);
        }
        Method { single: matrix.clone(), several: matrix, weights }
    }

    fn weights() -> Vec<f64> {
        let mut weights = STAGE_WEIGHTS[STAGES - 1].to_vec();
        weights.push(0.0);
        weights
    }

    #[test]
    fn the_coefficients_fulfil_the_conditions_of_their_orders() {
        let embedded: Vec<f64> = weights().iter().zip(ERROR_WEIGHTS).map(|(weight, error)| weight - error).collect();
        for order in 1..=5 {
            assert!(method(weights()).residual(order, 1.0) < 1e-15, "order {order}");
        }
        for order in 1..=4 {
            assert!(method(embedded.clone()).residual(order, 1.0) < 1e-15, "embedded, order {order}");
        }
        assert!(method(weights()).residual(6, 1.0) > 1e-4);
        assert!(method(embedded).residual(5, 1.0) > 1e-4);
        for (node, weights) in NODES.iter().zip(STAGE_WEIGHTS) {
            assert!((node - weights.iter().sum::<f64>()).abs() < 1e-15);
        }
    }

    #[test]
    fn the_error_falls_with_the_fifth_power_of_a_constant_step() {
        let mut pair = DormandPrince::new(2);
        let order = order_conditions::measured(|equations, time, size, from, to| {
            pair.reset();
            pair.step(equations, time, size, from, to, &mut [0.0; 2]);
        });
        assert!((order - 5.0).abs() < 0.15, "{order}");
    }

    #[test]
    fn the_dense_output_has_order_4_everywhere() {
        for part in [0.0, 0.2, 0.5, 0.9, 1.0] {
            // Weights of the stages at this part of the step: the output with only one stage not zero.
            let weights_there: Vec<f64> = (0..STAGES)
                .map(|stage| {
                    let mut pair = DormandPrince::new(1);
                    pair.rates[stage][0] = 1.0;
                    let mut coefficients = std::array::from_fn(|_| vec![0.0]);
                    pair.dense(1.0, &[0.0], &[weights()[stage]], &mut coefficients);
                    let mut value = [0.0];
                    dense_value(&coefficients, part, &mut value);
                    value[0]
                })
                .collect();
            for order in 1..=4 {
                assert!(method(weights_there.clone()).residual(order, part) < 1e-14, "order {order} at {part}");
            }
        }
    }
}
