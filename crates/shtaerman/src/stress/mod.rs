//! Stresses below the surface of a plane contact.
//!
//! All of them follow from one analytic function, `F(z) = int p(s)/(z - s) ds`, the Cauchy transform of the pressure, and its derivative. Close to the surface
//! a plain sum over nodes fails, as the pole of the integrand lies between two of them; Stenger's sinc formula accounts for the pole and
//! is exact to rounding at every depth, on the surface itself as well.

mod complex;
mod contact;
mod field;
mod first_yield;
mod measure;
mod nodes;
mod panel;
mod peak;
mod sampling;
mod tensor;

pub use field::StressField;
pub use first_yield::FirstYield;
pub use measure::Criterion;
pub use peak::Peak;
pub use tensor::Stress;
