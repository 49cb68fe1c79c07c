//! Prints the time of a native fit of the measured record U3, in milliseconds. A generated record is used if U3 is
//! absent.

use std::time::Instant;

fn main() -> Result<(), String> {
    let (times, level) = record();
    let fits = probe::Fits::new(&times, &level)?;
    let measure = |work: &dyn Fn(u32) -> Result<f64, String>, count: u32| {
        work(1)?;
        let start = Instant::now();
        let rmse = work(count)?;
        Ok::<_, String>((1000.0 * start.elapsed().as_secs_f64() / f64::from(count), rmse))
    };
    let (formula, rmse) = measure(&|count| fits.formula(count), 500)?;
    eprintln!("rmse {rmse:e}");
    println!("fit-formula {formula}");
    let (motion, rmse) = measure(&|count| fits.motion(count), 50)?;
    eprintln!("rmse {rmse:e}");
    println!("fit-motion {motion}");
    Ok(())
}

/// Times in s and levels in m: of the reference data beside the project, or of a damped cosine at 30 frames per second.
fn record() -> (Vec<f64>, Vec<f64>) {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/data/utube/U3.txt");
    let rows = std::fs::read_to_string(path).unwrap_or_default();
    let rows: Vec<(f64, f64)> = rows
        .lines()
        .filter_map(|line| {
            let mut cells = line.split(' ').map(str::parse);
            Some((cells.next()?.ok()?, cells.next()?.ok()?))
        })
        .collect();
    if !rows.is_empty() {
        return rows.into_iter().unzip();
    }
    (0..207_u32)
        .map(|frame| {
            let time = f64::from(frame) / 30.0;
            (time, 0.056 * libm::exp(-0.387 * time) * libm::sin(9.61 * time - 1.6) - 0.0027)
        })
        .unzip()
}
