//! The version of a release.

/// Version of the workspace, stated in `Cargo.toml` alone.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");
