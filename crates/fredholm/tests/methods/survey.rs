//! Seeded random equations on every kernel, solved by collocation and by the degenerate kernel.

use fredholm::conformance::{Comparison, compare};
use fredholm::equation::{collocate_half_line, degenerate};
use fredholm::kernel::{
    Kernel, Logarithm, LogarithmRatio, LogarithmRatioLimit, LogarithmSine, LogarithmSquare,
    Macdonald, MacdonaldHalfLine, Power, SpectralRelation, WeberSonine, Yukawa,
};
use fredholm::{Error, Interval};
use shtaerman_random::Random;

/// A kernel with random parameters, and those in words.
pub(crate) struct Drawn {
    pub(crate) relation: Box<dyn SpectralRelation>,
    /// The same kernel where it lives on the half-line: collocation has a route of its own there.
    pub(crate) half_line: Option<MacdonaldHalfLine>,
    pub(crate) parameters: String,
}

/// Draws a kernel prepared for so many eigenfunctions.
type Draw = fn(&mut Random, usize) -> Result<Drawn, Error>;

/// The kernels by name.
pub(crate) const KERNELS: &[(&str, Draw)] = &[
    ("log", logarithm),
    ("log-ratio", logarithm_ratio),
    ("log-ratio-limit", logarithm_ratio_limit),
    ("log-square", logarithm_square),
    ("log-sine", logarithm_sine),
    ("power", power),
    ("macdonald", macdonald),
    ("weber-sonine", weber_sonine),
    ("macdonald half-line", macdonald_half_line),
    ("yukawa", yukawa),
];

fn drawn(relation: impl SpectralRelation + 'static, parameters: String) -> Result<Drawn, Error> {
    Ok(Drawn { relation: Box::new(relation), half_line: None, parameters })
}

fn logarithm(random: &mut Random, _: usize) -> Result<Drawn, Error> {
    let a = random.scale(1e-3, 1e2);
    let gauge = a * random.scale(0.6, 10.0);
    drawn(Logarithm::with_gauge(a, gauge)?, format!("a = {a}, gauge = {gauge}"))
}

fn logarithm_ratio(random: &mut Random, _: usize) -> Result<Drawn, Error> {
    let a = random.scale(1e-2, 1e2);
    let b = a * gap(random);
    drawn(LogarithmRatio::new(b, a)?, format!("b = {b}, a = {a}"))
}

fn logarithm_ratio_limit(random: &mut Random, _: usize) -> Result<Drawn, Error> {
    let a = random.scale(1e-2, 1e2);
    drawn(LogarithmRatioLimit::new(a)?, format!("a = {a}"))
}

fn logarithm_square(random: &mut Random, _: usize) -> Result<Drawn, Error> {
    let a = random.scale(1e-2, 3.0);
    let b = if random.below(5) == 0 { 0.0 } else { a * gap(random) };
    drawn(LogarithmSquare::new(b, a)?, format!("b = {b}, a = {a}"))
}

/// `b/a`: small, or near 1.
fn gap(random: &mut Random) -> f64 {
    if random.below(2) == 0 { random.scale(1e-6, 0.5) } else { 1.0 - random.scale(1e-3, 0.5) }
}

fn logarithm_sine(random: &mut Random, _: usize) -> Result<Drawn, Error> {
    let alpha = if random.below(2) == 0 {
        random.scale(1e-2, 1.5)
    } else {
        std::f64::consts::PI - random.scale(0.04, 1.6)
    };
    drawn(LogarithmSine::new(alpha)?, format!("alpha = {alpha}"))
}

fn power(random: &mut Random, _: usize) -> Result<Drawn, Error> {
    let a = random.scale(1e-2, 1e2);
    let mu = random.between(1e-3, 0.9);
    drawn(Power::new(Interval::symmetric(a)?, mu)?, format!("a = {a}, mu = {mu}"))
}

fn macdonald(random: &mut Random, count: usize) -> Result<Drawn, Error> {
    let a = random.scale(1e-2, 1e2);
    let mu = random.between(-0.45, 0.45);
    let kappa = random.scale(1e-2, 40.0) / a;
    let relation = Macdonald::new(a, mu, kappa)?.relation(count)?;
    drawn(relation, format!("a = {a}, mu = {mu}, kappa = {kappa}"))
}

fn weber_sonine(random: &mut Random, _: usize) -> Result<Drawn, Error> {
    let a = random.scale(1e-2, 1e2);
    let mu = if random.below(2) == 0 { random.below(6) as f64 } else { random.between(0.3, 5.0) };
    let gamma = if random.below(3) == 0 { 0.0 } else { random.between(-0.45, 0.45) };
    drawn(WeberSonine::new(a, mu, gamma)?, format!("a = {a}, mu = {mu}, gamma = {gamma}"))
}

fn macdonald_half_line(random: &mut Random, _: usize) -> Result<Drawn, Error> {
    let mu = random.between(-0.45, 0.3);
    let kappa = random.scale(1e-2, 1e2);
    let kernel = MacdonaldHalfLine::new(mu, kappa)?;
    let half_line = Some(kernel.clone());
    let parameters = format!("mu = {mu}, kappa = {kappa}");
    Ok(Drawn { relation: Box::new(kernel), half_line, parameters })
}

fn yukawa(random: &mut Random, count: usize) -> Result<Drawn, Error> {
    let a = random.scale(1e-2, 1e2);
    let screening = random.scale(1e-2, 10.0) / a;
    let harmonic = random.below(4) as u32;
    let relation = Yukawa::new(a, screening, harmonic)?.relation(count)?;
    drawn(relation, format!("a = {a}, chi0 = {screening}, m = {harmonic}"))
}

/// A random right-hand side: a polynomial, an exponential or a wave in the share of the interval, times the mass function.
fn right_hand_side(random: &mut Random) -> (Box<dyn Fn(f64) -> f64 + Sync>, String) {
    match random.below(3) {
        0 => {
            let c: Vec<f64> = (0..=random.below(5)).map(|_| random.between(-1.0, 1.0)).collect();
            let text = format!("polynomial {c:?}");
            (Box::new(move |t| c.iter().rev().fold(0.0, |sum, c| sum * t + c)), text)
        }
        1 => {
            let rate = random.between(-3.0, 3.0);
            (Box::new(move |t| (rate * t).exp()), format!("exp({rate} t)"))
        }
        _ => {
            let (wave, phase) = (random.between(0.5, 12.0), random.between(0.0, 6.3));
            (Box::new(move |t| (wave * t + phase).cos()), format!("cos({wave} t + {phase})"))
        }
    }
}

/// One random equation and what came of it.
pub(crate) struct Outcome {
    pub(crate) description: String,
    pub(crate) comparison: Comparison,
}

/// Solves the equation of this number: everything follows from kernel, seed and number.
pub(crate) fn solve(index: usize, seed: u64, number: u64) -> Result<Outcome, (String, Error)> {
    let (name, draw) = KERNELS[index];
    let mut random = Random::new(seed.wrapping_add(number.wrapping_mul(0x2545_f491_4f6c_dd1d)));
    random.bits();
    let degree = 64 + random.below(97);
    let Drawn { relation, half_line, parameters } =
        draw(&mut random, degree + 1).map_err(|error| (name.to_owned(), error))?;
    let extent = relation.extent();
    let (left, length) = (extent.left(), 2.0 * extent.half_length());
    let (shape, text) = right_hand_side(&mut random);
    // Disks: smooth in the square of the radius.
    let on_disk = relation.measure(0.5 * left + 0.5 * extent.right()) != 1.0;
    let f = |x: f64| {
        let t = (x - left) / length;
        // On the half-line right-hand sides must decay.
        let decay = if half_line.is_some() { (-4.0 * t).exp() } else { 1.0 };
        decay * relation.mass_function(x) * shape(if on_disk { t * t } else { t })
    };
    let strength = random.scale(1e-2, 1e3);
    let strength = if random.below(10) == 0 { -strength.min(0.5) } else { strength };
    let parameter = strength / size(&*relation);
    let description = format!(
        "{name}, number {number}: {parameters}; lambda = {parameter}; f = {text}; degree {degree}"
    );
    let comparison = match &half_line {
        None => compare(&*relation, &*relation, parameter, &f, degree),
        Some(kernel) => on_half_line(kernel, parameter, &f, degree),
    }
    .map_err(|error| (description.clone(), error))?;
    Ok(Outcome { description, comparison })
}

fn on_half_line(
    kernel: &MacdonaldHalfLine,
    parameter: f64,
    f: &(dyn Fn(f64) -> f64 + Sync),
    degree: usize,
) -> Result<Comparison, Error> {
    let sinc = collocate_half_line(kernel, parameter, f, kernel.extent().right(), 1e-10)?;
    let spectral = degenerate(kernel, parameter, f, degree)?;
    Ok(Comparison::between(kernel, &sinc, &spectral))
}

/// A bound of the norm of the operator, roughly: the largest of `int |K(x, s)| dm(s)` for a few `x`.
fn size(kernel: &dyn SpectralRelation) -> f64 {
    let extent = kernel.extent();
    let (left, length) = (extent.left(), 2.0 * extent.half_length());
    let row = |share: f64| {
        let x = left + share * length;
        let step = length / 400.0;
        (0..400)
            .map(|i| left + (f64::from(i) + 0.37) * step)
            .map(|s| step * (kernel.value(x, s) * kernel.measure(s)).abs())
            .sum::<f64>()
    };
    [0.1, 0.4, 0.5, 0.8].map(row).into_iter().fold(0.0, f64::max)
}
