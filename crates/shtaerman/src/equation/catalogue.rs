//! The kernels that have a name. To add one, add its entry here.

use fredholm::Interval;
use fredholm::kernel::{
    Logarithm, LogarithmRatio, LogarithmRatioLimit, LogarithmSine, LogarithmSquare, Macdonald,
    MacdonaldHalfLine, Power, WeberSonine, Yukawa,
};

use super::family::{Family, Operator, Parameter, Route};

const HALF_LENGTH: Parameter = Parameter::real("a", "greater than 0, the half-length");
const OUTER: Parameter = Parameter::real("a", "greater than b, the outer end");

const RADIUS: Parameter = Parameter::real("a", "greater than 0, the radius");

const ORDER: Parameter = Parameter::real(
    "mu",
    "between -1/2 and 1/2, where the kernel is positive and the weight integrable",
);
const DECAY: Parameter = Parameter::real("kappa", "greater than 0, the decay");

/// All kernels, in the order of the paper.
pub(super) static FAMILIES: [Family; 10] = [
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
    Family {
        name: "power",
        is_half_line: false,
        formula: "|x - s|^-mu",
        interval: "(-a, a)",
        weight: "(a^2 - x^2)^((mu - 1)/2)",
        measure: "ds",
        integral_of: "phi",
        parameters: &[
            HALF_LENGTH,
            Parameter::real("mu", "between 0 and 1, where the kernel is positive and integrable"),
        ],
        aliases: &[("half_length", "a"), ("exponent", "mu")],
        build: |values| {
            Ok(Operator::closed(Power::new(Interval::symmetric(values[0])?, values[1])?))
        },
    },
    Family {
        name: "macdonald",
        is_half_line: false,
        formula: "K_mu(kappa |x - s|)/|x - s|^mu",
        interval: "(-a, a)",
        weight: "(a^2 - x^2)^(mu - 1/2)",
        measure: "ds",
        integral_of: "phi",
        parameters: &[HALF_LENGTH, ORDER, DECAY],
        aliases: &[
            ("half_length", "a"),
            ("order", "mu"),
            ("decay", "kappa"),
            ("decay * half_length", "kappa a"),
        ],
        build: |values| {
            let kernel = Macdonald::new(values[0], values[1], values[2])?;
            Ok(Operator::prepared(kernel, Macdonald::relation))
        },
    },
    Family {
        name: "macdonald",
        is_half_line: true,
        formula: "K_mu(kappa |x - s|)/|x - s|^mu",
        interval: "(0, inf)",
        weight: "x^(mu - 1/2)",
        measure: "ds",
        integral_of: "phi",
        parameters: &[ORDER, DECAY],
        aliases: &[("order", "mu"), ("decay", "kappa")],
        build: |values| {
            let kernel = MacdonaldHalfLine::new(values[0], values[1])?;
            Ok(Operator::closed(kernel.clone()).with_route(Route::HalfLine(kernel)))
        },
    },
    Family {
        name: "weber-sonine",
        is_half_line: false,
        formula: "int_0^inf J_mu(t x) J_mu(t s) t^(2 gamma) dt",
        interval: "(0, a)",
        weight: "(a^2 - x^2)^(gamma - 1/2)",
        measure: "s ds",
        integral_of: "phi x^(mu+1)",
        parameters: &[
            RADIUS,
            Parameter::real("mu", "from 0 to 100: below 0 the kernel need not be positive"),
            Parameter::real("gamma", "between -1/2 and 1/2, where the kernel is integrable"),
        ],
        aliases: &[("radius", "a"), ("order", "mu"), ("exponent", "gamma")],
        build: |values| Ok(Operator::closed(WeberSonine::new(values[0], values[1], values[2])?)),
    },
    Family {
        name: "yukawa",
        is_half_line: false,
        formula: "2 int_0^pi exp(-chi0 R)/R cos(m u) du, R^2 = x^2 + s^2 - 2 x s cos u",
        interval: "(0, a)",
        weight: "1/sqrt(a^2 - x^2)",
        measure: "s ds",
        integral_of: "phi x^(m+1)",
        parameters: &[
            RADIUS,
            Parameter::real("chi0", "0 or more, so that the potential decays"),
            Parameter::whole("m", "0, 1, 2, ..., the harmonic"),
        ],
        aliases: &[
            ("radius", "a"),
            ("screening", "chi0"),
            ("harmonic", "m"),
            ("screening * radius", "chi0 a"),
        ],
        build: |values| {
            let kernel = Yukawa::new(values[0], values[1], values[2] as u32)?;
            Ok(Operator::prepared(kernel, Yukawa::relation))
        },
    },
];
