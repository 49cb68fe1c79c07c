//! Speed of the steps of systems of many equal parts in the engine's virtual machine and in hand-written loops.

use engine::Stepper;
use std::hint::black_box;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::golden::setup;

/// Name and document of each system.
const DOCUMENTS: [(&str, &str); 3] = [
    ("chain", include_str!("../systems/chain.md")),
    ("string", include_str!("../systems/string.md")),
    ("gas", include_str!("../systems/gas.md")),
];

/// A system of many equal parts, ready for steps of the classical Runge-Kutta method without recording.
#[wasm_bindgen]
pub struct System {
    stepper: Stepper,
    forces: Forces,
    step: f64,
    /// Indices of the positions among the states of the model. Each velocity follows its position.
    positions: Vec<usize>,
}

/// Law of the accelerations of a system, SI.
#[derive(Clone, Copy)]
enum Forces {
    /// Chain of elements with fixed ends: `stiffness` is the coupling of neighbours divided by the mass, in 1/s^2.
    Line { stiffness: f64 },
    /// Discs of mass `m` and diameter `d` in a square box of side `l`, with the repulsive energy `epsilon*(d/r)^6`.
    Discs { m: f64, epsilon: f64, d: f64, l: f64 },
}

#[wasm_bindgen]
impl System {
    /// Opens the document of a system and compiles its model: `chain` has 200 masses, `string` 1,000 points, `gas` 100
    /// discs.
    ///
    /// # Errors
    /// There is no such system, or its document has errors.
    #[wasm_bindgen(constructor)]
    pub fn new(name: &str) -> Result<System, String> {
        let document = DOCUMENTS.iter().find(|(own, _)| *own == name);
        let (_, text) = document.ok_or_else(|| format!("no system {name}"))?;
        let (document, setup) = setup(text)?;
        let model = &document.program.model;
        let value = |name: &str| {
            let place = model.parameters.iter().position(|parameter| parameter.name == name);
            place.map(|place| setup.parameters[place]).ok_or_else(|| format!("no parameter {name}"))
        };
        let positions: Vec<usize> = (0..model.states.len()).filter(|&state| model.states[state].order == 0).collect();
        let forces = match name {
            "chain" => Forces::Line { stiffness: value("k")? / value("m")? },
            "string" => {
                let distance = value("L")? / (positions.len() + 1) as f64;
                Forces::Line { stiffness: value("F")? / (value("mu")? * distance * distance) }
            }
            _ => Forces::Discs { m: value("m")?, epsilon: value("epsilon")?, d: value("d")?, l: value("L")? },
        };
        let stepper = Stepper::new(model, &setup).map_err(|error| error.to_string())?;
        Ok(Self { stepper, forces, step: setup.step, positions })
    }

    /// Makes the steps of [`System::machine`] in emitted code from now on; in WebAssembly only.
    ///
    /// # Errors
    /// The reason why they are interpreted.
    pub fn emit(&mut self) -> Result<(), String> {
        let code = host::compile(self.stepper.listing()).map_err(|reason| format!("{reason:?}"))?;
        self.stepper.use_compiled(code);
        Ok(())
    }

    /// Computes `steps` steps from the start in the virtual machine, or in emitted code. Returns all positions, SI.
    ///
    /// # Errors
    /// A state is not finite.
    pub fn machine(&self, steps: u32) -> Result<Vec<f64>, String> {
        let mut stepper = self.stepper.clone();
        for _ in 0..steps {
            stepper.advance(|_, _, _| ()).map_err(|error| error.to_string())?;
        }
        Ok(self.positions.iter().map(|&position| stepper.state()[position]).collect())
    }

    /// Computes `steps` steps from the start in hand-written loops whose parameters are known only at run time. Returns
    /// all positions, SI.
    pub fn by_hand(&self, steps: u32) -> Vec<f64> {
        let start = self.stepper.initial();
        let velocities = self.positions.iter().map(|&position| start[position + 1]);
        let mut state: Vec<f64> = self.positions.iter().map(|&position| start[position]).chain(velocities).collect();
        match black_box(self.forces) {
            Forces::Line { stiffness } => {
                runge_kutta(&mut state, self.step, steps, |x, a| line(stiffness, x, a));
            }
            Forces::Discs { m, epsilon, d, l } => {
                runge_kutta(&mut state, self.step, steps, |r, a| discs(m, epsilon, d, l, r, a));
            }
        }
        state.truncate(self.positions.len());
        state
    }
}

/// Classical Runge-Kutta method. `state`: all positions, followed by all velocities. `accelerations` writes the
/// acceleration of each position.
fn runge_kutta(state: &mut [f64], step: f64, steps: u32, accelerations: impl Fn(&[f64], &mut [f64])) {
    let size = state.len();
    let mut rates = [vec![0.0; size], vec![0.0; size], vec![0.0; size], vec![0.0; size]];
    let mut stage = vec![0.0; size];
    let evaluate = |state: &[f64], rates: &mut [f64]| {
        let ((x, v), (x_rates, v_rates)) = (state.split_at(size / 2), rates.split_at_mut(size / 2));
        x_rates.copy_from_slice(v);
        accelerations(x, v_rates);
    };
    for _ in 0..steps {
        evaluate(state, &mut rates[0]);
        for (number, part) in [(0, 0.5 * step), (1, 0.5 * step), (2, step)] {
            for ((stage, from), rate) in stage.iter_mut().zip(&*state).zip(&rates[number]) {
                *stage = from + part * rate;
            }
            evaluate(&stage, &mut rates[number + 1]);
        }
        let [first, second, third, fourth] = &rates;
        for ((((to, k_1), k_2), k_3), k_4) in state.iter_mut().zip(first).zip(second).zip(third).zip(fourth) {
            *to += step / 6.0 * (k_1 + 2.0 * k_2 + 2.0 * k_3 + k_4);
        }
    }
}

/// Accelerations of a chain with couplings between neighbours.
fn line(stiffness: f64, x: &[f64], accelerations: &mut [f64]) {
    let last = x.len() - 1;
    accelerations[0] = stiffness * (x[1] - 2.0 * x[0]);
    for (acceleration, x) in accelerations[1..last].iter_mut().zip(x.windows(3)) {
        *acceleration = stiffness * (x[0] - 2.0 * x[1] + x[2]);
    }
    accelerations[last] = stiffness * (x[last - 1] - 2.0 * x[last]);
}

/// Accelerations of discs by the walls and by all other discs. `r`: x of all discs, followed by y of all.
fn discs(m: f64, epsilon: f64, d: f64, l: f64, r: &[f64], accelerations: &mut [f64]) {
    let seventh = |q: f64| q * q * q * (q * q * q) * q;
    for (acceleration, place) in accelerations.iter_mut().zip(r) {
        *acceleration = 6.0 * epsilon / (m * d) * (seventh(d / place) - seventh(d / (l - place)));
    }
    let strength = 6.0 * epsilon / (m * d * d);
    let count = r.len() / 2;
    let ((x, y), (x_accelerations, y_accelerations)) = (r.split_at(count), accelerations.split_at_mut(count));
    for i in 0..count {
        for j in i + 1..count {
            let (dx, dy) = (x[i] - x[j], y[i] - y[j]);
            let near = d * d / (dx * dx + dy * dy);
            let force = strength * (near * near * (near * near));
            x_accelerations[i] += force * dx;
            y_accelerations[i] += force * dy;
            x_accelerations[j] -= force * dx;
            y_accelerations[j] -= force * dy;
        }
    }
}
