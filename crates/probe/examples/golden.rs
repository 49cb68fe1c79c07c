//! Prints the golden runs of this machine. To update them after an intended change of bits:
//! `cargo run --release --package probe --example golden > crates/probe/golden.txt`

fn main() {
    print!("{}", probe::golden());
}
