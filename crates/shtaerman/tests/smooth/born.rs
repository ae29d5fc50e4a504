//! Zones that have just begun to touch: what is stated of how they widen.

use shtaerman::{Contact, Problem, file};

/// Mirrored, a problem has another rounding of every place and height.
fn problem(ground: &str, punch: [&str; 2], force: f64) -> Problem {
    let [geometry, profile] = punch;
    let toml = format!(
        "[foundation]\n{ground}\npoisson_ratio = 0.3\nroughness = 0\n\
         [punch]\n{geometry}\nhalf_width = 1\nprofile = \"{profile}\"\n\
         [load]\nforce = {force:e}\nmoment = 0\n"
    );
    file::parse(&toml, "test").unwrap()
}

/// None where the zone is too narrow to be told from none: such a force may be refused.
fn zones(ground: &str, punch: [&str; 2], force: f64) -> usize {
    problem(ground, punch, force).solve().map_or(0, |contact| contact.zones().len())
}

/// The least force under which a zone more than under half of it touches, to all digits.
fn birth(ground: &str, punch: [&str; 2]) -> f64 {
    let count = |force: f64| zones(ground, punch, force);
    let forces = (0..60).map(|k| 10.0 * 1.3f64.powi(k));
    let pairs = forces.clone().zip(forces.skip(1));
    let (mut below, mut above) =
        pairs.into_iter().find(|(low, high)| count(*high) > count(*low)).unwrap();
    let few = count(below);
    loop {
        let middle = below.midpoint(above);
        if middle <= below || middle >= above {
            return above;
        }
        if count(middle) > few { above = middle } else { below = middle }
    }
}

/// Rates by the logarithm of the force with their stated errors, of the width and of the tilt.
fn rates(contact: &Contact) -> [[f64; 2]; 2] {
    let found = contact.sensitivities().unwrap();
    let size = contact.settlement() / contact.problem().punch().half_width();
    [(Some(found.contact_width), contact.contact_width()), (found.tilt, size)].map(
        |(rate, size)| {
            let Some(rate) = rate else { return [0.0; 2] };
            let by_force = rate.force.unwrap() * contact.force();
            let by_all = [by_force, rate.profile.unwrap(), size];
            let largest = by_all.into_iter().fold(0.0f64, |most, rate| most.max(rate.abs()));
            [by_force, rate.error * largest]
        },
    )
}

#[test]
fn rates_of_a_zone_that_has_just_begun() {
    let plane = ["young_modulus = 2e8", "geometry = \"plane\""];
    let wave = ["young_modulus = 2e8", "geometry = \"periodic\"\nperiod = 2.3"];
    let graded = ["grading_modulus = 2e8\ngrading_exponent = 0.3", "geometry = \"plane\""];
    let crests = "5e-4*x^4 - 1e-4*cos(9.1*x + 0.9)";
    let mirrored = "5e-4*(0-x)^4 - 1e-4*cos(9.1*(0-x) + 0.9)";
    let mut compared = 0;
    for [ground, geometry] in [plane, wave, graded] {
        let born = birth(ground, [geometry, crests]);
        for excess in [1e-10, 1e-9, 1e-8, 1e-6, 1e-4] {
            let force = born * (1.0 + excess);
            let [one, other] = [crests, mirrored]
                .map(|profile| problem(ground, [geometry, profile], force).solve());
            // So close to its birth rounding decides whether there is a zone.
            let (Ok(one), Ok(other)) = (one, other) else { continue };
            if one.zones().len() != other.zones().len() {
                continue;
            }
            let (mut there, images) = (one.zones(), other.zones());
            there.reverse();
            for (zone, image) in there.iter().zip(images) {
                let gap = (zone[0] + image[1]).abs().max((zone[1] + image[0]).abs());
                let stated =
                    [&one, &other].map(|of| of.error().unwrap().zones.unwrap()).iter().sum::<f64>();
                assert!(
                    gap <= stated,
                    "{geometry}, {excess:e}: {zone:?} {image:?}, stated {stated:.1e}"
                );
            }
            let [one, other] = [rates(&one), rates(&other)];
            for (name, k, sign) in [("width", 0, 1.0), ("tilt", 1, -1.0)] {
                let ([rate, error], [mirrored, its]) = (one[k], other[k]);
                let gap = (rate - sign * mirrored).abs();
                assert!(
                    gap <= error + its,
                    "{name}, {geometry}, {excess:e}: {rate} for {mirrored}, stated {error:.1e} {its:.1e}"
                );
                compared += 1;
            }
        }
    }
    assert!(compared >= 24, "{compared}");
}
