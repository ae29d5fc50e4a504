//! A smooth kernel of a user's own: Love's equation, for the two-disk capacitor and the Lieb-Liniger gas.
//!
//! ```text
//! cargo run --release -p fredholm --example love [-- hard]
//! ```
//!
//! `hard` adds close disks and weak coupling, where the kernel is nearly singular: some ten seconds.

#[path = "equation.rs"]
pub mod equation;

use equation::{
    PUBLISHED, by_collocation, by_degenerate_kernel, capacitance, close_disks, energy,
    published_series, strong_coupling, weak_coupling,
};
use fredholm::Error;

/// Most eigenpairs.
const MOST: usize = 150;

/// Prints the tables of the chapter on kernels of one's own.
pub fn main() -> Result<(), Error> {
    let hard = std::env::args().skip(1).any(|argument| argument == "hard");
    published()?;
    for sign in [-1.0, 1.0] {
        capacitors(sign, hard)?;
    }
    gas(hard)
}

fn published() -> Result<(), Error> {
    println!("kappa = 1: phi(0), phi(1), and as published");
    for (sign, coefficients) in PUBLISHED {
        let [centre, end] = by_collocation(1.0, sign)?.values;
        let [published_centre, published_end] =
            [0.0, 1.0].map(|x| published_series(coefficients, x));
        println!(
            "  sign {sign:>2}: {centre:.13} {end:.13}   {published_centre:.7} {published_end:.7}"
        );
    }
    Ok(())
}

fn capacitors(sign: f64, hard: bool) -> Result<(), Error> {
    let name = if sign < 0.0 { "opposite" } else { "equal" };
    println!("\nTwo disks at {name} potentials, Q/(2 V epsilon_0 a)");
    println!(
        "kappa     collocation      nodes  estimate  degenerate kernel  pairs  least nu    close disks"
    );
    let separations = [10.0, 1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01];
    for kappa in &separations[..if hard { 8 } else { 5 }] {
        let sinc = by_collocation(*kappa, sign)?;
        let value = capacitance(&sinc);
        print!("{kappa:<6} {value:>17.12} {:>7}   {:.1e}", sinc.count, sinc.error);
        match by_degenerate_kernel(*kappa, sign, MOST) {
            Ok(found) => {
                print!(" {:>19.12} {:>6}   {:.1e}", capacitance(&found), found.count, found.error);
            }
            Err(Error::NotConverged { .. }) => {
                print!("{:>20} {:>6} {:>9}", "not resolved", "-", "-");
            }
            Err(error) => return Err(error),
        }
        if sign < 0.0 { println!("  {:>13.6}", close_disks(*kappa)) } else { println!() }
    }
    Ok(())
}

fn gas(hard: bool) -> Result<(), Error> {
    println!("\nLieb-Liniger gas, e(gamma)");
    println!(
        "gamma        collocation   degenerate kernel       weak coupling     strong coupling"
    );
    let couplings = [1000.0, 100.0, 10.0, 1.0, 0.1, 0.01];
    for gamma in &couplings[..if hard { 6 } else { 5 }] {
        let sinc = energy(*gamma, |kappa| by_collocation(kappa, -1.0))?;
        let degenerate = energy(*gamma, |kappa| by_degenerate_kernel(kappa, -1.0, MOST))?;
        let shown = |value: f64, valid: bool| {
            if valid { format!("{value:.14}") } else { "-".to_owned() }
        };
        println!(
            "{gamma:<6} {sinc:>17.14} {degenerate:>19.14} {:>19} {:>19}",
            shown(weak_coupling(*gamma), *gamma <= 1.0),
            shown(strong_coupling(*gamma), *gamma >= 10.0)
        );
    }
    Ok(())
}
