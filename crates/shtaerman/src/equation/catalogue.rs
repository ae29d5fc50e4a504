//! The kernels that have a name. To add one, add its entry here.

use fredholm::kernel::Logarithm;

use super::family::{Family, Operator, Parameter, Route};

const A: Parameter = Parameter::real("a", "greater than 0: the half-length of the interval");

/// All kernels, in the order of the paper.
pub(super) static FAMILIES: [Family; 1] = [Family {
    name: "log",
    is_half_line: false,
    formula: "ln 1/|x - s|",
    interval: "(-a, a)",
    weight: "1/sqrt(a^2 - x^2)",
    measure: "ds",
    integral_of: "phi",
    parameters: &[A],
    aliases: &[("half_length", "a")],
    build: |values| {
        let kernel = Logarithm::new(values[0])?;
        Ok(Operator::closed(kernel).with_route(Route::Bounds(kernel)))
    },
}];
