//! Special functions for which no library of ours serves.

mod cosine_integral;
mod macdonald;
mod oscillatory_tail;

pub use cosine_integral::cosine_integral_pi;
pub use macdonald::macdonald;
pub(crate) use macdonald::{
    LARGEST as LARGEST_MACDONALD, SmallArgument, macdonald_scaled, polynomial, sigma,
};
pub(crate) use oscillatory_tail::oscillatory_tail;
