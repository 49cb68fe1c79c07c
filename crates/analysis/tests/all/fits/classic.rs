//! Classic test problems of least squares that can be written as the fit of a formula (Moré, Garbow & Hillstrom, ACM Trans.
//! Math. Software 7 (1981) 17), from the standard start and, as there, from ten and a hundred times it. Osborne's first,
//! Kowalik & Osborne's and Meyer's are among those of NIST.

use crate::support::fitting::{model, observation, record, task};
use analysis::fit::Fit;

struct Problem {
    name: &'static str,
    formula: &'static str,
    start: &'static [f64],
    /// The least sum of squares, to the digits published.
    least: f64,
    /// Factors of the start from which it must be reached.
    factors: &'static [f64],
    data: Vec<(f64, f64)>,
}

fn rows(first: f64, step: f64, values: &[f64]) -> Vec<(f64, f64)> {
    values.iter().enumerate().map(|(row, value)| (first + step * row as f64, *value)).collect()
}

fn problems() -> Vec<Problem> {
    vec![
        Problem {
            name: "Rosenbrock",
            formula: "if x < 0.5 then 10*(b2 - b1^2) else 1 - b1",
            start: &[-1.2, 1.0],
            least: 0.0,
            factors: &[1.0, 10.0, 100.0],
            data: rows(0.0, 1.0, &[0.0; 2]),
        },
        Problem {
            name: "Powell's singular",
            formula: "if x < 0.5 then b1 + 10*b2 else if x < 1.5 then sqrt(5)*(b3 - b4) \
                      else if x < 2.5 then (b2 - 2*b3)^2 else sqrt(10)*(b1 - b4)^2",
            start: &[3.0, -1.0, 0.0, 1.0],
            least: 0.0,
            factors: &[1.0, 10.0, 100.0],
            data: rows(0.0, 1.0, &[0.0; 4]),
        },
        Problem {
            name: "Beale",
            formula: "b1*(1 - b2^x)",
            start: &[1.0, 1.0],
            least: 0.0,
            factors: &[1.0, 10.0],
            data: rows(1.0, 1.0, &[1.5, 2.25, 2.625]),
        },
        Problem {
            name: "Jennrich & Sampson",
            formula: "exp(x*b1) + exp(x*b2)",
            start: &[0.3, 0.4],
            least: 124.362,
            factors: &[1.0, 10.0],
            data: (1..=10).map(|i| (f64::from(i), 2.0 + 2.0 * f64::from(i))).collect(),
        },
        Problem {
            name: "Box",
            formula: "exp(-b1*x) - exp(-b2*x) - b3*(exp(-x) - exp(-10*x))",
            start: &[0.0, 10.0, 20.0],
            least: 0.0,
            factors: &[1.0, 10.0, 100.0],
            data: rows(0.1, 0.1, &[0.0; 10]),
        },
        Problem {
            name: "Bard",
            formula: "b1 + x/((16 - x)*b2 + (if x < 8 then x else 16 - x)*b3)",
            start: &[1.0, 1.0, 1.0],
            least: 8.214_87e-3,
            factors: &[1.0, 10.0, 100.0],
            data: rows(
                1.0,
                1.0,
                &[0.14, 0.18, 0.22, 0.25, 0.29, 0.32, 0.35, 0.39, 0.37, 0.58, 0.73, 0.96, 1.34, 2.10, 4.39],
            ),
        },
        Problem {
            name: "Brown & Dennis",
            formula: "(b1 + x*b2 - exp(x))^2 + (b3 + b4*sin(x) - cos(x))^2",
            start: &[25.0, 5.0, -5.0, -1.0],
            least: 85_822.2,
            factors: &[1.0, 10.0, 100.0],
            data: rows(0.2, 0.2, &[0.0; 20]),
        },
        Problem {
            name: "Osborne's second",
            formula: "b1*exp(-x*b5) + b2*exp(-(x - b9)^2*b6) + b3*exp(-(x - b10)^2*b7) + b4*exp(-(x - b11)^2*b8)",
            start: &[1.3, 0.65, 0.65, 0.7, 0.6, 3.0, 5.0, 7.0, 2.0, 4.5, 5.5],
            least: 4.013_77e-2,
            factors: &[1.0],
            data: rows(
                0.0,
                0.1,
                &[
                    1.366, 1.191, 1.112, 1.013, 0.991, 0.885, 0.831, 0.847, 0.786, 0.725, 0.746, 0.679, 0.608, 0.655,
                    0.616, 0.606, 0.602, 0.626, 0.651, 0.724, 0.649, 0.649, 0.694, 0.644, 0.624, 0.661, 0.612, 0.558,
                    0.533, 0.495, 0.500, 0.423, 0.395, 0.375, 0.372, 0.391, 0.396, 0.405, 0.428, 0.429, 0.523, 0.562,
                    0.607, 0.653, 0.672, 0.708, 0.633, 0.668, 0.645, 0.632, 0.591, 0.559, 0.597, 0.625, 0.739, 0.710,
                    0.729, 0.720, 0.636, 0.581, 0.428, 0.292, 0.162, 0.098, 0.054,
                ],
            ),
        },
    ]
}

#[test]
fn the_least_sums_are_reached_from_near_and_far() {
    for problem in problems() {
        let names: Vec<String> = (1..=problem.start.len()).map(|number| format!("b{number}")).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let parameters: String = names.iter().map(|name| format!("parameter {name} = 1\n")).collect();
        let model = model(&format!("independent x\n{parameters}y = {}\n", problem.formula));
        let (times, values): (Vec<f64>, Vec<f64>) = problem.data.iter().copied().unzip();
        for factor in problem.factors {
            let mut task = task(&model, record(vec![observation(&model, "y", 0, &times, &values)]), &names);
            for (varied, start) in task.varied.iter_mut().zip(problem.start) {
                varied.start = Some(factor * start);
            }
            let mut fit = Fit::new(&model, task).unwrap();
            fit.complete();
            let outcome = fit.outcome().unwrap();
            let sum = outcome.residuals(0).iter().fold(0.0, |sum, residual| sum + residual * residual);
            let what = format!("{} from {factor} times the start: {sum:e} after {} trials", problem.name, fit.trials());
            assert!(sum <= problem.least * (1.0 + 1e-5) + 1e-12, "{what}");
        }
    }
}
