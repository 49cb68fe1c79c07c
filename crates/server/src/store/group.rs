//! Sizes of group commit.

/// Number of changes that wait at most; further ones wait before they are queued.
pub const QUEUE: usize = 4096;

/// Maximum number of changes in one transaction.
pub const GROUP: usize = 256;
