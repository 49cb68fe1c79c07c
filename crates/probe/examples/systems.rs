//! Prints the time per step of each system in microseconds, as `chain-machine 1.2` and `chain-hand 0.9`, and the time
//! to check a document of 2,000 lines in milliseconds.

use probe::{System, check, long_document};
use std::hint::black_box;
use std::time::Instant;

/// Name of each system and number of steps per measurement.
const SYSTEMS: [(&str, u32); 3] = [("chain", 20_000), ("string", 5_000), ("gas", 500)];
const ROUNDS: usize = 5;

fn main() -> Result<(), String> {
    for (name, steps) in SYSTEMS {
        let system = System::new(name)?;
        let (mut machine, mut hand) = (f64::INFINITY, f64::INFINITY);
        // Alternating, with the best of each, to reduce the influence of other load on the machine.
        for _ in 0..ROUNDS {
            let start = Instant::now();
            black_box(system.machine(steps)?);
            machine = machine.min(start.elapsed().as_secs_f64());
            let start = Instant::now();
            black_box(system.by_hand(steps));
            hand = hand.min(start.elapsed().as_secs_f64());
        }
        let microseconds = |seconds: f64| 1e6 * seconds / f64::from(steps);
        println!("{name}-machine {:.3}\n{name}-hand {:.3}", microseconds(machine), microseconds(hand));
    }
    let text = long_document();
    let mut best = f64::INFINITY;
    for _ in 0..ROUNDS {
        let start = Instant::now();
        black_box(check(&text, 1)?);
        best = best.min(start.elapsed().as_secs_f64());
    }
    println!("check-lines {:.3}", 1000.0 * best);
    Ok(())
}
