//! Jumps whose places a formula leaves open by its roundings: whatever side a number lies on, the answer is as exact as elsewhere.

use std::f64::consts::PI;

use shtaerman::ErrorKind;

/// A wave in full contact under terraces of `cos(pi (xi - c))`: at rest the mean of the heights and of the pressure, `delta = P/2 + mean f`, as the kernel of a wave has no mean. Terraces
/// begin where the cosine is `v`, at `acos(v)/pi` from `c`.
#[test]
fn terraces_of_a_wave() {
    let cases = [
        (44.64, 0.96407, [-0.14546, 0.66531], [0.4, 0.0, 0.35178], 7.80584, 0.298494),
        (1.83683, 0.75371, [-0.66475, 0.26567], [0.4, 0.0, 0.53089], 0.542337, 2.65878),
    ];
    for (theta0, centre, [first, second], [low, middle, high], size, force) in cases {
        let toml = format!(
            "[dimensionless]\ntheta0 = {theta0}\ngeometry = \"periodic\"\nperiod = 2\nprofile = \"{size}*(where(cos(pi*(xi-({centre})))<{first}, {low}, where(cos(pi*(xi-({centre})))<{second}, \
             {middle}, {high})))\"\nforce = {force}\nmoment = 0\n[solver]\ncontact = \"bilateral\"\n"
        );
        let contact =
            shtaerman::file::parse(&toml, "test").unwrap().solve().unwrap().audited().unwrap();
        let stated = contact.accuracy().unwrap();
        let [below, above] = [first, second].map(|v: f64| v.acos() / PI);
        let mean = size * (low * (1.0 - below) + middle * (below - above) + high * above);
        let off = (contact.settlement0() - (0.5 * force + mean)).abs();
        let largest = contact.peak_pressure0().0;
        println!("{off:e} {stated:?} {largest}");
        assert_eq!(stated.kind, ErrorKind::Bound);
        // The closed form is rounded, too.
        assert!(off <= stated.settlement + 4.0 * f64::EPSILON * mean.abs(), "{off:e} {stated:?}");
        assert!(stated.pressure < 1e-9 * largest, "{stated:?}");
        assert!(contact.peak_error0().is_none_or(|error| error < 1e-9 * largest));
    }
}
