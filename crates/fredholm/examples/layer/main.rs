//! A kernel of a user's own: a rough flat punch on an elastic layer of finite thickness.
//!
//! ```text
//! cargo run --release -p fredholm --example layer
//! ```

mod kernel;

use std::f64::consts::PI;
use std::time::Instant;

use fredholm::collocation::solve_adaptive;
use fredholm::kernel::{ComputedRelation, Logarithm, SpectralRelation};
use fredholm::{DegenerateSystem, Error};
use kernel::{Base, Layer};

/// `lambda = 2a/(pi E* chi)`.
const LAMBDA: f64 = 2.0;

fn main() -> Result<(), Error> {
    constants()?;
    for base in [Base::Sliding, Base::Bonded { poisson: 0.3 }] {
        punch(base)?;
    }
    degenerate()
}

fn constants() -> Result<(), Error> {
    println!("a_0, the constant of a thick layer");
    for (name, base) in [
        ("sliding", Base::Sliding),
        ("bonded, nu = 0.3", Base::Bonded { poisson: 0.3 }),
        ("bonded, nu = 0.5", Base::Bonded { poisson: 0.5 }),
    ] {
        println!("  {name:<17} {:.14}", Layer::new(base, 1.0)?.gauge_constant());
    }
    Ok(())
}

fn punch(base: Base) -> Result<(), Error> {
    println!("\n{base:?}, lambda = {LAMBDA}: int phi dx, phi(0), phi(1)");
    println!(
        "h/a      layer                                        estimate  nodes     ms  half-plane       springs"
    );
    for thickness in [100.0, 10.0, 3.0, 1.0, 0.3, 0.1, 0.03, 0.01] {
        let start = Instant::now();
        let layer = Layer::new(base, thickness)?;
        let found = solve_adaptive(&layer, LAMBDA, |_| 1.0, 1e-12)?;
        let time = start.elapsed().as_secs_f64() * 1e3;
        let phi = &found.solution;
        let gauge = thickness * layer.gauge_constant().exp();
        let plane = solve_adaptive(&Logarithm::with_gauge(1.0, gauge)?, LAMBDA, |_| 1.0, 1e-12)
            .map_or(f64::NAN, |found| found.solution.integral(|_| 1.0));
        let springs = 2.0 / (1.0 + LAMBDA * thickness * PI * base.slope());
        println!(
            "{thickness:<5} {:>16.13} {:>15.12} {:>15.12} {:>9.1e} {:>6} {time:>6.1} {plane:>11.7} {springs:>11.7}",
            phi.integral(|_| 1.0),
            phi.evaluate(0.0, 1.0),
            phi.evaluate(1.0, 1.0),
            found.estimate.solution,
            2 * found.half_count + 1,
        );
    }
    Ok(())
}

/// The paper's method with computed eigenpairs.
fn degenerate() -> Result<(), Error> {
    let layer = Layer::new(Base::Sliding, 1.0)?;
    let exact = solve_adaptive(&layer, LAMBDA, |_| 1.0, 1e-12)?.solution;
    println!("\nDegenerate kernel, sliding base, h = a: error of int phi dx, of phi(0), of phi(1)");
    for count in [10, 20, 40, 80] {
        let relation = ComputedRelation::new(Layer::new(Base::Sliding, 1.0)?, count)?;
        let moments = relation.moments(&|_| 1.0, count)?.values;
        let phi = DegenerateSystem::new(&relation, LAMBDA, count - 1)?.solve(&moments);
        let integral: f64 =
            2.0 - phi.correction().iter().zip(&moments).map(|(c, f)| c * f).sum::<f64>();
        println!(
            "{count:>3} pairs (nodes {}, defect {:.0e}): {:.1e} {:.1e} {:.1e}",
            relation.nodes(),
            relation.defect(),
            (integral - exact.integral(|_| 1.0)).abs(),
            (phi.evaluate(0.0, 1.0) - exact.evaluate(0.0, 1.0)).abs(),
            (phi.evaluate(1.0, 1.0) - exact.evaluate(1.0, 1.0)).abs(),
        );
    }
    Ok(())
}
