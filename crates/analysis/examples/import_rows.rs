//! Speed of the import in rows per second: a million rows of time, position, velocity and acceleration, as written by
//! Tracker. Prints it for decimal points, `points 1500000`, and for decimal commas.

use std::fmt::Write;
use std::time::Instant;

const ROWS: usize = 1_000_000;

fn main() {
    let mut text = "t\tx\tv\ta\n".to_owned();
    for row in 0..ROWS {
        let t = row as f64 / 30.0;
        let x = libm::sin(t);
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{t:.9E}\t{x:.9E}\t{:.9E}\t{:.9E}", 0.7 * x, -x);
    }
    for (name, text) in [("points", text.clone()), ("commas", text.replace('.', ","))] {
        let mut best = f64::INFINITY;
        for _ in 0..3 {
            let start = Instant::now();
            let rows = analysis::import::text(text.as_bytes()).map_or(0, |import| import.table.rows());
            assert_eq!(rows, ROWS, "all rows are read");
            best = best.min(start.elapsed().as_secs_f64());
        }
        eprintln!("{name}: {:.0} MB/s", text.len() as f64 / best / 1e6);
        println!("{name} {:.0}", ROWS as f64 / best);
    }
}
