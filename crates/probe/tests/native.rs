//! Native tests of the probe: the golden runs, and agreement of the loops whose speed is compared.

use probe::{Pace, Shipped, System, check, fingerprint, golden, long_document};

#[test]
fn golden_runs_have_the_bits_in_the_repository() {
    let expected = include_str!("../golden.txt");
    assert_eq!(
        golden(),
        expected,
        "if the bits changed for a good reason: cargo run --release --package probe --example golden > crates/probe/golden.txt"
    );
    for line in expected.lines() {
        let fingerprint = line.rsplit(' ').next().unwrap_or_default();
        assert_eq!((fingerprint.len(), u64::from_str_radix(fingerprint, 16).is_ok()), (16, true), "{line}");
    }
}

/// `bits.txt` has a line for each number of the bits and the hash of `golden.txt` at that number.
#[test]
fn the_number_of_the_bits_belongs_to_the_golden_runs() {
    let stated: Vec<(u32, &str)> = include_str!("../bits.txt")
        .lines()
        .filter_map(|line| line.split_once(' '))
        .map(|(bits, hash)| (bits.parse().unwrap(), hash))
        .collect();
    assert!(stated.windows(2).all(|lines| lines[0].0 < lines[1].0), "{stated:?}");
    let hash = format!("{:016x}", units::fnv::hashed(units::fnv::START, *include_bytes!("../golden.txt")));
    assert_eq!(
        stated.last(),
        Some(&(program::BITS, hash.as_str())),
        "if golden.txt changed, so did results: raise program::BITS and add a line to bits.txt; lines that stand stay"
    );
}

#[test]
fn both_loops_solve_the_same_equation() {
    let pace = Pace::new().unwrap();
    for steps in [1, 100, 2000, 19_999, 20_000] {
        let (machine, hand) = (pace.machine(steps).unwrap(), pace.by_hand(steps));
        // The results differ only by rounding, about 1e-16 of the amplitude per step: the virtual machine chooses the
        // order of operations.
        assert!((machine - hand).abs() < 1e-12, "{machine} and {hand} after {steps} steps");
    }
    // The closed form after 5 s, weakly damped.
    let (gamma, omega) = (50.0 / 700.0, (19.6_f64 / 7.0 - (50.0 / 700.0) * (50.0 / 700.0)).sqrt());
    let expected = 0.5 * libm::exp(-gamma * 5.0) * (libm::cos(omega * 5.0) + gamma / omega * libm::sin(omega * 5.0));
    assert!((pace.by_hand(100) - expected).abs() < 4e-6);
}

#[test]
fn what_cannot_run_says_why() {
    let cases = [
        ("y' = -y\ny(0) = 1", "rk4", "the term `y` has one factor of time too many"),
        ("independent s\ny' = -y\ny(0) = 1", "magic", "no method magic"),
    ];
    for (model, method, expected) in cases {
        let document = format!("```model\n{model}\n```");
        assert_eq!(fingerprint(&document, method, 1.0), expected);
    }
}

#[test]
fn systems_move_as_the_loops_written_by_hand() {
    for (name, steps, size) in [("chain", 500, 0.01), ("string", 500, 3e-3), ("gas", 20, 0.2)] {
        let system = System::new(name).unwrap();
        for steps in [0, 1, steps] {
            let (machine, hand) = (system.machine(steps).unwrap(), system.by_hand(steps));
            assert_eq!(machine.len(), hand.len());
            for (machine, hand) in machine.iter().zip(&hand) {
                assert!((machine - hand).abs() < 1e-11 * size, "{name}: {machine} {hand} after {steps} steps");
            }
        }
        let (start, end) = (system.by_hand(0), system.by_hand(steps));
        assert!(start.iter().zip(&end).any(|(start, end)| (start - end).abs() > 1e-3 * size), "{name} rests");
    }
    assert_eq!(System::new("swarm").err().as_deref(), Some("no system swarm"));
}

#[test]
fn the_long_document_is_long_and_without_errors() {
    let text = long_document();
    assert!(text.lines().count() > 2000, "{}", text.lines().count());
    assert_eq!(document::open(&text, &[]).diagnostics, []);
    assert_eq!(check(&text, 1), Ok(100));
}

#[test]
fn an_interpreted_document_says_why_and_its_rows_repeat() {
    let mut stiff = Shipped::new(include_str!("../../../simulations/van-der-pol.md")).unwrap();
    assert_eq!(stiff.emit(), Err("Interpreted(Method(Rosenbrock))".to_owned()));
    assert_eq!(stiff.rows(3000), stiff.rows(3000));
    assert_ne!(stiff.rows(3000), stiff.rows(2999));
}
