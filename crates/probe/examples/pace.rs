//! Prints the number of steps of the U-tube per second in millions: `machine 12.3`, `hand 45.6` and `best 78.9`.

use probe::Pace;
use std::hint::black_box;
use std::time::Instant;

const STEPS: u32 = 2_000_000;
const ROUNDS: usize = 5;

fn main() -> Result<(), String> {
    let pace = Pace::new()?;
    let (mut machine, mut hand, mut best) = (0.0_f64, 0.0_f64, 0.0_f64);
    // Alternating, with the best of each, to reduce the influence of other load on the machine.
    for _ in 0..ROUNDS {
        let start = Instant::now();
        black_box(pace.machine(STEPS)?);
        machine = machine.max(f64::from(STEPS) / start.elapsed().as_secs_f64());
        let start = Instant::now();
        black_box(pace.by_hand(STEPS));
        hand = hand.max(f64::from(STEPS) / start.elapsed().as_secs_f64());
        let start = Instant::now();
        black_box(pace.best_by_hand(STEPS));
        best = best.max(f64::from(STEPS) / start.elapsed().as_secs_f64());
    }
    println!("machine {:.2}\nhand {:.2}\nbest {:.2}", machine / 1e6, hand / 1e6, best / 1e6);
    Ok(())
}
