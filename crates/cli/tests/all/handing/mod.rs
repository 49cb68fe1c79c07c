//! Hand-ins: those of a class, and hostile ones.

mod hand_ins;
mod hostile_hand_ins;
mod marks;
