//! Solutions at given times beside those of the engine's stepper.

use engine::{Method, Routine, Setup, Stepper};
use ensemble::{Features, NoLanes, Solutions, Sought};
use program::{Model, NodeId};

/// Documents, with the number of parameters whose sensitivities are solved as well, and true if they have solutions in lanes.
const DOCUMENTS: [(&str, usize, bool); 7] = [
    (include_str!("../../../../simulations/theories/linear.md"), 4, true),
    (include_str!("../../../../simulations/utube.md"), 3, true),
    (include_str!("../../../../simulations/theories/quadratic.md"), 5, true),
    (include_str!("../../../../simulations/pendulum.md"), 2, false),
    (include_str!("../../../../simulations/coupled-oscillators.md"), 2, true),
    (include_str!("../../../../simulations/bouncing-ball.md"), 1, false),
    (include_str!("../../../../simulations/double-pendulum.md"), 0, false),
];
const LANES: usize = 13;
const TOLERANCES: [f64; 2] = [1e-6, 1e-9];

/// Bits of what is read at each time, and the number of operations.
type Solution = (Vec<u64>, u64);

/// The solution by the stepper; `None` if it does not reach the last time.
fn single(model: &Model, setup: &Setup, tolerance: f64, nodes: &[NodeId], sought: Sought) -> Option<Solution> {
    let initial: Vec<NodeId> = model.states.iter().map(|state| state.initial).collect();
    let mut values = vec![0.0; initial.len()];
    let zeros = values.clone();
    let mut routine = Routine::compile(model, &initial);
    routine.prepare(sought.parameters, &zeros);
    routine.evaluate(0.0, &zeros, &mut values);
    let mut stepper = Stepper::new(model, setup).unwrap();
    stepper.allow_of_peak(tolerance);
    stepper.begin(sought.parameters.to_vec(), &values);
    let begun = stepper.work();
    let mut readings = Routine::compile(model, nodes);
    readings.prepare(sought.parameters, &values);
    let mut bits = Vec::new();
    let mut read = vec![0.0; nodes.len()];
    for &time in sought.times {
        if time > stepper.time() {
            stepper.advance_to(time).ok()?;
        }
        readings.evaluate(time, stepper.state(), &mut read);
        bits.extend(read.iter().map(|value| value.to_bits()));
    }
    Some((bits, stepper.work() - begun))
}

#[test]
fn solutions_at_given_times_have_the_bits_of_the_stepper() {
    for (text, sensitive, has_lanes) in DOCUMENTS {
        let program = document::open(text, &[]).document.unwrap().program;
        let varied: Vec<usize> = (0..sensitive).collect();
        let model = program.model.with_sensitivities(&varied).unwrap();
        let start = Some(vec![0.0; model.states.len()]);
        let setup = Setup { start, method: Method::DormandPrince, ..Setup::of(&program) };
        let nodes: Vec<NodeId> = model.quantities.iter().map(|quantity| quantity.value.node).collect();
        let mut solutions = match Solutions::new(&model, &setup, &nodes) {
            Ok(solutions) => solutions,
            Err(reason) => {
                assert!(
                    !has_lanes && matches!(reason, NoLanes::NotSmooth | NoLanes::Interpreted(_)),
                    "{}: {reason:?}",
                    program.title
                );
                continue;
            }
        };
        assert!(has_lanes, "{}", program.title);
        let parameters = |lane: usize| {
            let mut parameters = setup.parameters.clone();
            for (number, parameter) in parameters.iter_mut().enumerate() {
                *parameter *= 1.0 + 0.01 * ((lane * 7 + number * 3) % 11) as f64;
            }
            if lane == 5 {
                parameters[0] = f64::NAN;
            }
            parameters
        };
        let parameters: Vec<Vec<f64>> = (0..LANES).map(parameters).collect();
        // The start itself, times that are asked for twice, and records of different lengths.
        let times = |lane: usize| -> Vec<f64> {
            let time = |row: usize| 0.37 * setup.step * (row / 2 * (lane + 1)) as f64;
            (0..20 + 9 * lane).map(time).collect()
        };
        let times: Vec<Vec<f64>> = (0..LANES).map(times).collect();
        let sought = parameters.iter().zip(&times).map(|(parameters, times)| Sought { parameters, times });
        let sought: Vec<Sought> = sought.collect();
        for features in [Features::Least, Features::Avx2, Features::Best] {
            solutions.use_features(features);
            for tolerance in TOLERANCES {
                let mut read = vec![Vec::new(); LANES];
                let solved = solutions.solve(tolerance, &sought, &mut |lane, _, values| {
                    read[lane].extend(values.iter().map(|value| value.to_bits()));
                });
                for (lane, (work, read)) in solved.into_iter().zip(read).enumerate() {
                    let expected =
                        if lane == 5 { None } else { single(&model, &setup, tolerance, &nodes, sought[lane]) };
                    assert!(work.map(|work| (read, work)) == expected, "{}, lane {lane}, {features:?}", program.title);
                }
            }
        }
    }
}
