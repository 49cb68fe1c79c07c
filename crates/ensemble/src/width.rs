//! The processor features with which the loops over lanes are compiled.

use pulp::{Arch, Simd, WithSimd};

/// Processor features. The bits do not depend on them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Features {
    /// Those that every processor of this kind has: SSE2 on x86-64, NEON on ARM.
    Least,
    /// AVX2, if the processor has it.
    Avx2,
    /// The best that the processor has, at most AVX-512.
    Best,
}

/// Features that the processor has.
#[derive(Clone, Copy, Debug)]
pub struct Width(Arch);

/// A function that is compiled for each set of features. It and all functions in it with loops over lanes must be
/// `#[inline(always)]`. Closures and function items are compiled once, without features.
pub trait Lanewise {
    /// Its arguments.
    type Arguments<'a>;

    /// Calls it.
    fn call(arguments: Self::Arguments<'_>);
}

struct Work<'a, L: Lanewise>(L::Arguments<'a>);

impl<L: Lanewise> WithSimd for Work<'_, L> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _simd: S) {
        L::call(self.0);
    }
}

impl Width {
    /// These features, or fewer if the processor does not have them.
    pub fn new(features: Features) -> Self {
        Self(match features {
            Features::Least => Arch::Scalar,
            #[cfg(target_arch = "x86_64")]
            Features::Avx2 => pulp::x86::V3::try_new().map_or(Arch::Scalar, Arch::V3),
            _ => Arch::new(),
        })
    }

    /// Calls the function that is compiled for these features.
    #[inline(always)]
    pub fn call<L: Lanewise>(self, arguments: L::Arguments<'_>) {
        self.0.dispatch(Work::<L>(arguments));
    }
}

impl Default for Width {
    fn default() -> Self {
        Self::new(Features::Best)
    }
}
