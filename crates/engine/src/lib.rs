//! Runs a model: virtual machine, methods, events, history.
