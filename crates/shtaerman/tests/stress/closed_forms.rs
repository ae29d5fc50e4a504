//! Hertz, the strip load and the flat punch, from the surface to far below.

use shtaerman::{Elastic, Foundation, Load, Problem, Punch, Rotational, StressField, Vertical};

use crate::stress::support::{DEPTHS, flat_punch, hertz, places, strip, worst};

const RATIO: f64 = 0.3;

#[test]
fn hertz_is_exact_at_every_depth() {
    let pressure = |_: usize, left: f64, right: f64| (left * right).sqrt();
    let field = StressField::from_pressure(&[[-1.0, 1.0]], None, RATIO, pressure).unwrap();
    let worst = worst(&field, |x, y| hertz(x, y, RATIO));
    assert!(worst.0 < 1e-12, "{worst:?}, {} nodes, {:e}", field.nodes(), field.error());
}

/// K. L. Johnson, *Contact Mechanics*, (4.49), with the real quantities `m` and `n`.
#[test]
fn hertz_agrees_with_the_form_of_textbooks() {
    let pressure = |_: usize, left: f64, right: f64| (left * right).sqrt();
    let field = StressField::from_pressure(&[[-1.0, 1.0]], None, RATIO, pressure).unwrap();
    for y in [2.0, 0.786_151, 0.3, 0.1, 1e-3] {
        for i in -30..=30 {
            let x = f64::from(i) / 10.0 + 0.003;
            let even = 1.0 - x * x + y * y;
            let whole = even.hypot(2.0 * x * y);
            let m = (0.5 * (whole + even)).sqrt();
            let n = (0.5 * (whole - even)).sqrt().copysign(x);
            let quotient = (y * y + n * n) / (m * m + n * n);
            let stress = field.stress(x, y).unwrap();
            // m or n is a difference of large numbers beside or under the contact: 1e-3 below it costs 6 digits.
            let allowed = if y < 0.1 { 1e-9 } else { 1e-12 };
            assert!((stress.sigma_x + m * (1.0 + quotient) - 2.0 * y).abs() < allowed);
            assert!((stress.sigma_y + m * (1.0 - quotient)).abs() < allowed);
            assert!((stress.tau_xy + n * (m * m - y * y) / (m * m + n * n)).abs() < allowed);
        }
    }
}

#[test]
fn a_uniform_strip_is_exact_at_every_depth() {
    let field = StressField::from_pressure(&[[-1.0, 1.0]], None, RATIO, |_, _, _| 1.0).unwrap();
    let worst = worst(&field, |x, y| strip(x, y, RATIO));
    assert!(worst.0 < 1e-12, "{worst:?}, {} nodes, {:e}", field.nodes(), field.error());
}

#[test]
fn a_flat_punch_is_exact_relative_to_the_stress() {
    let pressure =
        |_: usize, left: f64, right: f64| (left * right).sqrt().recip() / std::f64::consts::PI;
    let field = StressField::from_pressure(&[[-1.0, 1.0]], None, RATIO, pressure).unwrap();
    let worst = worst(&field, |x, y| flat_punch(x, y, RATIO));
    assert!(worst.0 < 1e-11, "{worst:?}, {} nodes, {:e}", field.nodes(), field.error());
}

/// The contact itself as the source: a smooth flat punch of half-width and modulus 1 under the force 1.
#[test]
fn a_smooth_contact_keeps_its_corners() {
    let body = Elastic::new(1.0, RATIO).unwrap();
    let (foundation, punch) =
        (Foundation::new(body).with_roughness(0.0).unwrap(), Punch::new(1.0).unwrap());
    let load = Load::new(Vertical::Force(1.0), Rotational::Moment(0.0)).unwrap();
    let problem = Problem::new(foundation, punch, load).unwrap();
    let field = StressField::new(&problem.solve().unwrap(), None).unwrap();
    let worst = worst(&field, |x, y| flat_punch(x, y, RATIO));
    assert!(worst.0 < 1e-11, "{worst:?}, {} nodes, {:e}", field.nodes(), field.error());
}

/// A strip cut into panels is the same strip; so is one moved, stretched and pressed harder.
#[test]
fn panels_and_units_change_nothing() {
    let cut = [[-1.0, -0.3], [-0.3, 0.1], [0.1, 1.0]];
    let field = StressField::from_pressure(&cut, None, RATIO, |_, _, _| 1.0).unwrap();
    assert_eq!(field.zones(), [[-1.0, 1.0]]);
    let found = worst(&field, |x, y| strip(x, y, RATIO));
    assert!(found.0 < 1e-12, "{found:?}");
    let (scale, shift, load) = (1e-3, 0.25, 4e8);
    let ends = [[shift - scale, shift + scale]];
    let field = StressField::from_pressure(&ends, None, RATIO, |_, _, _| load).unwrap();
    for y in &DEPTHS[..6] {
        for x in places().filter(|x| (x.abs() - 1.0).abs() > 1e-4) {
            let exact = strip(x, *y, RATIO);
            let stress = field.stress(shift + scale * x, scale * y).unwrap();
            // The shift costs digits of the place, which a stress near an end feels.
            assert!((stress.sigma_x / load - exact.sigma_x).abs() < 1e-10, "{x} {y}");
        }
    }
}

/// The surface: `-p` under the contact, nothing beside it.
#[test]
fn the_surface_carries_the_pressure() {
    let pressure = |_: usize, left: f64, right: f64| (left * right).sqrt() * (2.0 + left);
    let field = StressField::from_pressure(&[[-1.0, 1.0]], None, RATIO, pressure).unwrap();
    for x in places() {
        let exact = if x.abs() < 1.0 { pressure(0, 1.0 + x, 1.0 - x) } else { 0.0 };
        let stress = field.stress(x, 0.0).unwrap();
        assert!(
            (stress.sigma_x + exact).abs() < 1e-13 * 3.0,
            "{x}: {} for {exact}",
            stress.sigma_x
        );
        assert_eq!(stress.sigma_x, stress.sigma_y);
        assert_eq!(stress.tau_xy, 0.0);
    }
}

/// Layers at the ends, a steep hump and fast waves need more nodes, and get them.
#[test]
fn the_number_of_nodes_follows_the_pressure() {
    let smooth = StressField::from_pressure(&[[-1.0, 1.0]], None, RATIO, |_, _, _| 1.0).unwrap();
    let hump = |_: usize, left: f64, _: f64| 1.0 / (1.0 + ((left - 1.0) / 0.2).powi(2));
    let field = StressField::from_pressure(&[[-1.0, 1.0]], None, RATIO, hump).unwrap();
    assert!(field.nodes() > 2 * smooth.nodes() && field.error() < 1e-13);
    let waves = |_: usize, left: f64, _: f64| (40.0 * (left - 1.0)).cos();
    let field = StressField::from_pressure(&[[-1.0, 1.0]], None, RATIO, waves).unwrap();
    assert!(field.nodes() > 2 * smooth.nodes() && field.error() < 1e-12);
    for x in [-0.9, -0.31, 0.02, 0.5] {
        assert!((field.pressure(x) - (40.0 * x).cos()).abs() < 1e-12);
    }
}
