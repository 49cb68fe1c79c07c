//! Asks the linker to keep one copy of functions with the same code, a tenth of the library.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    // Rust brings a linker that can for this target alone.
    if std::env::var("TARGET").is_ok_and(|target| target == "x86_64-unknown-linux-gnu") {
        println!("cargo::rustc-cdylib-link-arg=-Wl,--icf=all");
    }
}
