//! A smooth kernel of a user's own: Love's equation, for the two-disk capacitor and the Lieb-Liniger gas.
//!
//! ```text
//! cargo run --release -p fredholm --example love
//! ```

mod equation;

use equation::{
    by_collocation, by_degenerate_kernel, capacitance, close_disks, energy, weak_coupling,
};
use fredholm::Error;

fn main() -> Result<(), Error> {
    capacitors()?;
    gas()
}

fn capacitors() -> Result<(), Error> {
    println!("Two disks at opposite potentials, C/(epsilon_0 a)\n");
    println!("kappa    collocation        nodes  estimate  degenerate kernel  pairs  close disks");
    for kappa in [10.0, 1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01] {
        let sinc = by_collocation(kappa, -1.0)?;
        print!("{kappa:<6} {:>16.12} {:>7}   {:.1e}", capacitance(sinc), sinc.count, sinc.error);
        match by_degenerate_kernel(kappa, -1.0, 150) {
            Ok(love) => print!(" {:>18.12} {:>6}", capacitance(love), love.count),
            Err(error) => print!(" {error}"),
        }
        println!("  {:>11.6}", close_disks(kappa));
    }
    Ok(())
}

fn gas() -> Result<(), Error> {
    println!("\nLieb-Liniger gas, e(gamma)\n");
    println!("gamma    collocation          degenerate kernel    weak coupling");
    for gamma in [100.0, 10.0, 1.0, 0.1] {
        let sinc = energy(gamma, |kappa| by_collocation(kappa, -1.0))?;
        let degenerate = energy(gamma, |kappa| by_degenerate_kernel(kappa, -1.0, 150))?;
        println!("{gamma:<5} {sinc:>18.15} {degenerate:>18.15} {:>18.15}", weak_coupling(gamma));
    }
    Ok(())
}
