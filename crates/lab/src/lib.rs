//! The browser shell of the laboratory.
