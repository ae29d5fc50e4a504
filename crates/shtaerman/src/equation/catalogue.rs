//! The kernels that have a name. To add one, add its entry here.

use fredholm::kernel::{
    Logarithm, LogarithmRatio, LogarithmRatioLimit, LogarithmSine, LogarithmSquare,
};

use super::family::{Family, Operator, Parameter, Route};

const HALF_LENGTH: Parameter = Parameter::real("a", "greater than 0, the half-length");
const OUTER: Parameter = Parameter::real("a", "greater than b, the outer end");

/// All kernels, in the order of the paper.
pub(super) static FAMILIES: [Family; 5] = [
    Family {
        name: "log",
        is_half_line: false,
        formula: "ln 1/|x - s|",
        interval: "(-a, a)",
        weight: "1/sqrt(a^2 - x^2)",
        measure: "ds",
        integral_of: "phi",
        parameters: &[HALF_LENGTH],
        aliases: &[("half_length", "a")],
        build: |values| {
            let kernel = Logarithm::new(values[0])?;
            Ok(Operator::closed(kernel).with_route(Route::Bounds(kernel)))
        },
    },
    Family {
        name: "log-ratio",
        is_half_line: false,
        formula: "ln (x + s)/|x - s|",
        interval: "(b, a)",
        weight: "1/sqrt((a^2 - x^2) (x^2 - b^2))",
        measure: "ds",
        integral_of: "phi",
        parameters: &[
            OUTER,
            Parameter::real(
                "b",
                "greater than 0, where the weight would not be integrable, and less than a",
            ),
        ],
        aliases: &[("inner end", "b"), ("outer end", "a")],
        build: |values| Ok(Operator::closed(LogarithmRatio::new(values[1], values[0])?)),
    },
    Family {
        name: "log-ratio-limit",
        is_half_line: false,
        formula: "ln (x + s)/|x - s|",
        interval: "(0, a)",
        weight: "1/sqrt(a^2 - x^2)",
        measure: "ds",
        integral_of: "phi",
        parameters: &[Parameter::real("a", "greater than 0, the length")],
        aliases: &[("length", "a")],
        build: |values| Ok(Operator::closed(LogarithmRatioLimit::new(values[0])?)),
    },
    Family {
        name: "log-square",
        is_half_line: false,
        formula: "ln 1/|x^2 - s^2|",
        interval: "(b, a)",
        weight: "2 x/sqrt((a^2 - x^2) (x^2 - b^2))",
        measure: "ds",
        integral_of: "phi",
        parameters: &[OUTER, Parameter::real("b", "at least 0 and less than a")],
        aliases: &[("inner end", "b"), ("outer end", "a")],
        build: |values| Ok(Operator::closed(LogarithmSquare::new(values[1], values[0])?)),
    },
    Family {
        name: "log-sine",
        is_half_line: false,
        formula: "ln 1/(2 sin(|x - s|/2))",
        interval: "(-alpha, alpha)",
        weight: "even n: cos(x/2)/sqrt(2 (cos x - cos alpha)); odd n: cos(alpha/2)/cos(x/2)^2 times that",
        measure: "ds",
        integral_of: "phi",
        parameters: &[Parameter::real(
            "alpha",
            "between 0 and pi: on the whole circle the kernel is no longer positive definite",
        )],
        aliases: &[],
        build: |values| Ok(Operator::closed(LogarithmSine::new(values[0])?)),
    },
];
