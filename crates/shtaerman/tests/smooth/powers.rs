//! `f = |x - c|^n`: `theta0 P = n a^n/pi int_-1^1 |t|^n/sqrt(1 - t^2) dt`, and flat punches put one on another give the pressure
//! `int_d^a n P b^(n-1)/(a^n pi sqrt(b^2 - d^2)) db`, in the middle `n P/((n-1) pi a)` for `n > 1`, infinite below.

use std::f64::consts::PI;

use crate::smooth::support::{integral, level, punch};

fn half(n: f64, force: f64) -> f64 {
    (PI * force / (n * moments(n))).powf(1.0 / n)
}

/// `int_0^pi |cos|^n` with its cusp at an end of either half.
fn moments(n: f64) -> f64 {
    2.0 * integral(PI / 2.0, |from, _| from.sin().powf(n))
}

fn solved(n: f64, c: f64, force: f64) -> crate::smooth::support::Solved {
    let height = move |x: f64| (x - c).abs().powf(n);
    punch(1.0, height, level(force)).formula(&format!("abs(x - {c})^{n}")).breaks(&[c]).solved()
}

#[test]
fn powers_have_closed_forms() {
    for c in [0.0, 0.6] {
        for (n, force) in [(0.8, 0.01), (0.8, 0.1), (1.3, 0.001), (1.5, 1e-5), (1.5, 0.05)] {
            let contact = solved(n, c, force);
            let (a, what) = (half(n, force), format!("n = {n}, c = {c}, P = {force}"));
            let [zone] = contact.zones().try_into().unwrap();
            for (end, exact) in zone.ends.into_iter().zip([c - a, c + a]) {
                let allowed = 1e-10 * a + 1e-15 + contact.zones_error();
                assert!((end - exact).abs() < allowed, "{what}: {end} {exact}");
            }
            let middle = contact.pressure(c);
            if n < 1.0 {
                assert_eq!(middle, f64::INFINITY, "{what}");
            } else {
                let exact = n * force / ((n - 1.0) * PI * a);
                let allowed = contact.contact.relative_error().max(1e-12);
                assert!(
                    (middle / exact - 1.0).abs() <= allowed,
                    "{what}: {middle} {exact} {allowed:e}"
                );
            }
        }
    }
}

/// With `f = x^2 + max(0, x)^n` and `theta0 = 1` the pressure at the bend is `sqrt(-l r)/pi^2` times `int f'(s)/(s sqrt((s - l)(r - s))) ds` over the zone `l .. r`.
#[test]
fn powers_on_one_side_have_their_pressure_at_the_bend() {
    for n in [1.1, 1.5, 1.8] {
        for side in [1.0, -1.0] {
            let height = move |x: f64| x * x + (side * x).max(0.0).powf(n);
            let text = format!("x^2 + max(0, {side}*x)^{n}");
            let smooth = punch(1.0, height, level(0.02)).formula(&text);
            let contact = smooth.solved();
            let [zone] = contact.zones().try_into().unwrap();
            let [left, right] = zone.ends;
            let [near, far] = if side > 0.0 { [right, -left] } else { [-left, right] };
            let own = |from: f64, to: f64| from.powf(n - 2.0) / ((far + from) * to).sqrt();
            let whole = |from: f64, to: f64| (from * to).sqrt().recip();
            let sum = n * integral(near, own) + 2.0 * integral(near + far, whole);
            assert_eq!(zone.is_free(), [true; 2]);
            let exact = (near * far).sqrt() / PI.powi(2) * sum;
            let found = contact.pressure(0.0);
            let stated = contact.contact.relative_error().max(1e-12);
            let what = format!("n = {n}, {side}");
            println!("{what}: {:e} {stated:e}", found / exact - 1.0);
            assert!((found / exact - 1.0).abs() <= stated, "{what}: {found} {exact} {stated:e}");
            // It falls from there as the power of the distance on the other side, and less on this.
            let fallen = |d: f64| (contact.pressure(-side * d) - found) / d.powf(n - 1.0);
            let [one, two] = [1e-13, 1e-10].map(fallen);
            let allowed = 5e-2 * two.abs() + 2.0 * stated * found / 1e-13f64.powf(n - 1.0);
            assert!(one < 0.0 && (one - two).abs() <= allowed, "{what}: {one} {two}");
        }
    }
}

/// Powers add up at one place: with `theta0 = 1` and `f = sum A |t|^n` each adds `A n a^n m/pi` to the force, `m = int_-1^1 |t|^n/sqrt(1 - t^2) dt`, and `n/((n-1) pi a)` of that to the pressure in the middle. What cannot be told of that is refused.
#[test]
fn several_powers_at_one_place_are_as_exact_as_stated_or_refused() {
    let (mut solved, mut refused) = (0, 0);
    for [one, two, less] in [
        [1.06, 1.23, 1e-3],
        [1.06, 1.23, 0.1],
        [1.2, 1.29, -0.25],
        [1.3, 1.4, -0.1],
        [1.09, 1.6, 1e-2],
        [1.25, 1.8, 0.5],
        [1.05, 1.1, -0.3],
        [1.4, 1.9, 1e-4],
    ] {
        let height = move |x: f64| x.abs().powf(two) + less * x.abs().powf(one);
        let text = format!("abs(x)^{two} + ({less})*abs(x)^{one}");
        let contact = match punch(1.0, height, level(0.02)).formula(&text).solve() {
            Ok(contact) => contact,
            Err(error) => {
                assert!(matches!(error, shtaerman::Error::UnclearBend), "{text}: {error}");
                refused += 1;
                continue;
            }
        };
        solved += 1;
        let [zone] = contact.zones().try_into().unwrap();
        let [left, right] = zone.ends;
        let a: f64 = 0.5 * (right - left);
        let parts = [(1.0, two), (less, one)];
        let sum = |of: &dyn Fn(f64) -> f64| -> f64 {
            parts.iter().map(|(size, n)| size * n * a.powf(*n) * moments(*n) / PI * of(*n)).sum()
        };
        assert!((sum(&|_| 1.0) / 0.02 - 1.0).abs() < 1e-9, "{text}");
        let exact = sum(&|n| n / ((n - 1.0) * PI * a));
        let (off, stated) = ((contact.pressure(0.0) - exact).abs(), contact.error().pressure);
        assert!(off <= stated, "{text}: off {off:e}, stated {stated:e} of {exact}");
    }
    assert!(solved >= 2 && refused >= 1, "{solved} {refused}");
}
