//! Special functions for which no library of ours serves.

mod cosine_integral;
mod elementary;
pub(crate) mod elliptic;
pub(crate) mod exponential_sum;
mod gamma_quotient;
mod macdonald;
mod oscillatory_tail;
mod poles;

pub use cosine_integral::cosine_integral_pi;
pub(crate) use elementary::{
    logarithms, logarithms_of_one_and, powers, powers_within, sines, sines_of_half_turns,
};
pub use elliptic::arithmetic_geometric_mean;
pub(crate) use gamma_quotient::{half_gamma_quotient, mean_digamma};
pub use macdonald::macdonald;
pub(crate) use macdonald::{
    LARGEST as LARGEST_MACDONALD, SmallArgument, macdonald_scaled, polynomial, sigma,
};
pub(crate) use oscillatory_tail::oscillatory_tail;
pub use poles::pole_sums;
