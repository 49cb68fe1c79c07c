//! Asks the linker to keep one copy of functions with the same code, a tenth of the library, and to put similar functions next to
//! each other: the packed library is 2.6 % smaller.

fn main() {
    // Rust brings a linker that can do so for this target alone. Another one, such as zig's, is named in the environment.
    let own_linker = std::env::var_os("CARGO_TARGET_X86_64_UNKNOWN_LINUX_GNU_LINKER").is_none();
    println!("cargo::rerun-if-env-changed=CARGO_TARGET_X86_64_UNKNOWN_LINUX_GNU_LINKER");
    if own_linker && std::env::var("TARGET").is_ok_and(|target| target == "x86_64-unknown-linux-gnu") {
        println!("cargo::rustc-cdylib-link-arg=-Wl,--icf=all,--bp-compression-sort=both");
    }
}
