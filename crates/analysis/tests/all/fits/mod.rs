//! Fits of models to data with known results.
mod bounded;
mod classic;
mod coverage;
mod elsewhere;
mod judged;
mod kinks;
mod known;
mod nist;
mod parts;
mod ranking;
mod robust;
mod scale;
mod sentinels;
mod starts;
mod undersampled;
mod undetermined;
mod utube;
