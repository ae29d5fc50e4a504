//! Prints what answers state of themselves and what their audit bounds, with the times of both: `cargo run --release -p shtaerman --example audit_files -- FILE.toml ..`
use std::time::Instant;

fn main() {
    for path in std::env::args().skip(1) {
        let problem = match shtaerman::file::open(std::path::Path::new(&path), &[]) {
            Ok(problem) => problem,
            Err(error) => {
                println!("{path}: {error}");
                continue;
            }
        };
        let start = Instant::now();
        let contact = match problem.solve() {
            Ok(contact) => contact,
            Err(error) => {
                println!("{path}: {error}");
                continue;
            }
        };
        let solved = start.elapsed();
        let start = Instant::now();
        let audit = contact.audit();
        let audited = start.elapsed();
        println!("{path}: solve {solved:?}, audit {audited:?}");
        println!(
            "  stated {:?} edges {:?}",
            contact.dimensionless().error(),
            contact.dimensionless().error().and_then(|error| error.zones)
        );
        println!("  peak {:?} {audit:?}", contact.dimensionless().peak_pressure());
    }
}
