//! Fits of models to data with known results.
mod classic;
mod coverage;
mod elsewhere;
mod judged;
mod known;
mod nist;
mod parts;
mod robust;
mod scale;
mod sentinels;
mod undersampled;
mod utube;
