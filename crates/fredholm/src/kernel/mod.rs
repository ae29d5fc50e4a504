//! Symmetric kernels, their singularities and their spectral relations (paper, section 1).
//!
//! To add a kernel, write one file here: implement [`Kernel`] (value and split of the singularity) and, where one is
//! known, [`SpectralRelation`]; where none is known, [`ComputedRelation`] computes the eigenpairs.

mod computed;
mod half_sums;
mod logarithm;
mod logarithm_ratio;
mod logarithm_ratio_limit;
mod logarithm_sine;
mod logarithm_square;
mod macdonald;
mod potential;
mod power;
mod transfer;
mod weber_sonine;
mod yukawa;

pub use computed::ComputedRelation;
pub use logarithm::Logarithm;
pub use logarithm_ratio::LogarithmRatio;
pub use logarithm_ratio_limit::LogarithmRatioLimit;
pub use logarithm_sine::LogarithmSine;
pub use logarithm_square::LogarithmSquare;
pub(crate) use macdonald::MacdonaldProfile;
pub use macdonald::{Macdonald, MacdonaldHalfLine, MacdonaldRelation};
pub(crate) use potential::EndMoments;
pub use potential::{LogarithmicPotential, end_moments};
pub use power::Power;
pub use transfer::{LAST_WAVENUMBER, TransferDisk, TransferPlane};
pub(crate) use weber_sonine::Homogeneous;
pub use weber_sonine::WeberSonine;
pub use yukawa::{Yukawa, YukawaRelation};

pub(crate) use crate::traits::forward_kernel;
pub use crate::traits::{
    EndExponents, Expansion, Gram, Kernel, Moments, Pair, Parity, Singularity, SpectralRelation,
    Split,
};
