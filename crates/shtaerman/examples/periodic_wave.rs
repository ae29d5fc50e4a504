//! A rigid wave on a smooth half-plane at 0.3 of the pressure that closes it, against Westergaard's closed form at 4096 points:
//! one line of JSON for `benches/peers/run.sh`, which runs other programs beside.

use std::f64::consts::PI;
use std::time::Instant;

use shtaerman::{
    Elastic, Foundation, Geometry, Load, Problem, Profile, Punch, Rotational, Vertical,
};

const PERIOD: f64 = 1.0;
const HEIGHT: f64 = 0.01;
const SHARE: f64 = 0.3;
const POINTS: usize = 4096;
const REPETITIONS: usize = 200;

fn solve() -> Result<Vec<f64>, Box<dyn std::error::Error>> {
    let body = Elastic::new(1.0, 0.0)?;
    let geometry = Geometry::Periodic { period: PERIOD };
    let (foundation, punch) =
        (Foundation::new(body).with_roughness(0.0)?, Punch::in_geometry(geometry, 0.5 * PERIOD)?);
    let mean = SHARE * PI * HEIGHT / PERIOD;
    let load = Load::new(Vertical::Force(mean * PERIOD), Rotational::Tilt(0.0))?;
    let profile = Profile::expression(&format!("-{HEIGHT}*cos(2*pi*x/{PERIOD})"))?;
    let contact = Problem::new(foundation, punch.with_profile(profile), load)?.solve()?;
    Ok(contact.pressures(&places().collect::<Vec<_>>())?)
}

fn places() -> impl Iterator<Item = f64> {
    (0..POINTS).map(|i| PERIOD * (i as f64 / POINTS as f64 - 0.5))
}

/// `2 pbar cos(psi) sqrt(s^2 - sin^2 psi)/s^2`, `psi = pi x/L`, `s^2 = pbar/p*`.
fn westergaard(x: f64) -> f64 {
    let angle = PI * x / PERIOD;
    let inside = SHARE - angle.sin().powi(2);
    2.0 * PI * HEIGHT / PERIOD * angle.cos() * inside.max(0.0).sqrt()
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut best = f64::INFINITY;
    let mut pressures = Vec::new();
    for _ in 0..REPETITIONS {
        let start = Instant::now();
        pressures = solve()?;
        best = best.min(start.elapsed().as_secs_f64());
    }
    let error =
        places().zip(&pressures).map(|(x, p)| (p - westergaard(x)).abs()).fold(0.0, f64::max);
    println!(
        "{{\"name\": \"Shtaerman, with the pressure at all points\", \"error\": {:e}, \"milliseconds\": {}}}",
        error / westergaard(0.0),
        best * 1e3
    );
    Ok(())
}
