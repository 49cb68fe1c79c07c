//! Work of each method: an edit that costs evaluations fails here. Bits of runs: they must be the same on all machines and
//! after every edit that does not intend to change them.

use crate::support::{U_TUBE, model, setup};
use engine::{Method, Setup, Stepper};

#[test]
fn evaluations_of_the_equations() {
    let model = model(U_TUBE);
    let counts: Vec<(&str, u64, u64)> = Method::ALL
        .into_iter()
        .map(|method| {
            let mut stepper = Stepper::new(&model, &setup(&model, method, 0.05)).unwrap();
            for _ in 0..1000 {
                stepper.advance(|_, _, _| {}).unwrap();
            }
            (method.name(), stepper.evaluations(), stepper.jacobians())
        })
        .collect();
    let expected = [
        ("euler", 1000, 0),
        ("euler-richardson", 2000, 0),
        ("velocity-verlet", 2000, 0),
        ("rk4", 4000, 0),
        ("dormand-prince", 2857, 0),
        ("rosenbrock", 12012, 2002),
    ];
    assert_eq!(counts, expected);
}

#[test]
fn evaluations_by_tolerance_for_stiff_and_orbital_problems() {
    let orbit = model(
        "independent t\nr = sqrt(x^2 + y^2)\nx'' = -x/r^3\ny'' = -y/r^3\nx(0) = 0.4\nx'(0) = 0\ny(0) = 0\ny'(0) = 2\n",
    );
    let stiff = model("independent t\nparameter mu = 1000\ny'' = mu*(1 - y^2)*y' - y\ny(0) = 2\ny'(0) = 0\n");
    let mut counts = Vec::new();
    for (model, method, step) in [(&orbit, Method::DormandPrince, 1.0), (&stiff, Method::Rosenbrock, 20.0)] {
        for tolerance in [1e-3, 1e-6, 1e-9] {
            let mut stepper = Stepper::new(model, &Setup { tolerance, ..setup(model, method, step) }).unwrap();
            for _ in 0..100 {
                stepper.advance(|_, _, _| {}).unwrap();
            }
            counts.push((stepper.evaluations(), stepper.jacobians()));
        }
    }
    assert_eq!(counts, [(1663, 0), (4837, 0), (16585, 0), (1878, 235), (5520, 874), (53976, 8982)]);
}

/// Times that need not be on the grid are read from the same steps as rows.
#[test]
fn times_within_a_step_have_the_bits_of_rows() {
    let model = model(U_TUBE);
    for method in [Method::DormandPrince, Method::Rosenbrock] {
        let mut rows = Stepper::new(&model, &setup(&model, method, 0.05)).unwrap();
        let mut times = rows.clone();
        for row in 1..=200 {
            rows.advance(|_, _, _| {}).unwrap();
            times.advance_to(f64::from(row) * 0.05).unwrap();
            assert_eq!((times.time(), times.state()), (rows.time(), rows.state()));
            assert_eq!(times.evaluations(), rows.evaluations(), "row {row} by {}", method.name());
        }
    }
}

/// The step that is not finite is counted once.
#[test]
fn evaluations_up_to_an_error() {
    let model = model("independent t\ny' = y^2\ny(0) = 1\n");
    let mut stepper = Stepper::new(&model, &setup(&model, Method::RungeKutta4, 0.1)).unwrap();
    let mut rows = 0;
    let error = loop {
        match stepper.advance(|_, _, _| {}) {
            Ok(_) => rows += 1,
            Err(error) => break error,
        }
    };
    assert!(rows > 10 && stepper.state()[0].is_finite());
    assert_eq!(stepper.evaluations(), 4 * (rows + 1));
    assert_eq!(stepper.advance(|_, _, _| {}).unwrap_err(), error);
}

#[test]
fn instructions_of_the_u_tube() {
    let model = model(U_TUBE);
    let rates: Vec<program::NodeId> = model.states.iter().map(|state| state.derivative).collect();
    // The quotients of parameters come before the run; a product remains, and a product with a sum.
    assert_eq!(engine::Routine::compile(&model, &rates).instructions(), 2);
}

#[test]
fn golden_runs() {
    let pendulum = model(
        "independent t\nq'' = -sin(q) - 0.1*q' + 0.5*cos(0.7*t)\nq(0) = 1\nq'(0) = 0\nwhen q > 1.2 { q' = -0.9*q' }\n",
    );
    let tube = model(U_TUBE);
    let prints: Vec<[u64; 2]> = Method::ALL
        .into_iter()
        .map(|method| {
            [&tube, &pendulum]
                .map(|model| crate::support::run(model, setup(model, method, 0.05), 1000).history().fingerprint())
        })
        .collect();
    let expected: [[u64; 2]; 6] = [
        [0x0733_22b0_aaaa_a2de, 0x39dc_ad81_2adc_d117],
        [0x66f7_e21b_f15e_f06e, 0xd4b8_c775_337b_17ae],
        [0x20eb_e177_534b_1a65, 0x4ded_038f_dafb_b528],
        [0x8426_e105_a776_4702, 0x9980_99bb_7139_f57b],
        [0xa1af_aec0_415f_27f5, 0x98c7_c7a2_6459_84d5],
        [0x17d2_49ec_6f17_ab12, 0xfeda_1223_8bb2_e24c],
    ];
    assert_eq!(prints, expected);
}
