//! Prints the golden runs as this machine finds them; where the bits have changed for a good reason:
//! `cargo run --release --package probe --example golden > crates/probe/golden.txt`

fn main() {
    print!("{}", probe::golden());
}
