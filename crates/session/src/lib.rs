//! Everything a person can do in the laboratory, as plain state and transitions.
