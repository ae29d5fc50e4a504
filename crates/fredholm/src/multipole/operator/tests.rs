//! Operators on panels against closed forms, and what is shared against one processor.

use super::*;
use crate::kernel::{Kernel, WeberSonine};

/// Panels of very different lengths, with gaps, the last ones ever shorter.
fn uneven(closing: i32) -> Vec<[f64; 2]> {
    let mut bounds = Vec::new();
    let mut left = -1.0;
    for i in 0..400 {
        let length = 0.004 * (1.1 + (1.7 * f64::from(i)).sin()) / 2.2;
        bounds.push([left, left + length]);
        left += length;
        if i % 7 == 3 {
            left += 0.01;
        }
    }
    for i in 0..closing {
        let [from, to] = [1.0 - 0.1 * 0.4f64.powi(i), 1.0 - 0.1 * 0.4f64.powi(i + 1)];
        bounds.push([from, to]);
    }
    bounds
}

#[test]
fn products_agree_with_those_in_closed_form() {
    // phi = 2 + x: int ln(1/|x - s|) (2 + s) ds by its primitive on each panel
    let panels = Panels::new(uneven(20), 6).unwrap();
    let operator = PanelOperator::new(PanelKernel::Logarithm, panels).unwrap();
    let primitive = |x: f64, s: f64| {
        let d = s - x;
        if d == 0.0 {
            return 0.0;
        }
        let logarithm = d.abs().ln();
        (2.0 + x) * d * (1.0 - logarithm) + 0.5 * d * d * (0.5 - logarithm)
    };
    let exact = |x: f64| -> f64 {
        let bounds = operator.panels().bounds();
        bounds.iter().map(|[left, right]| primitive(x, *right) - primitive(x, *left)).sum()
    };
    let values: Vec<f64> = operator.panels().nodes().iter().map(|x| 2.0 + x).collect();
    for (x, found) in operator.panels().nodes().iter().zip(operator.potential(&values)) {
        assert!((found - exact(*x)).abs() < 2e-13, "{x}: {found} {}", exact(*x));
    }
    let field = operator.field(&values);
    for i in -60..=60 {
        let x = f64::from(i) / 57.3;
        assert!((field.at(x) - exact(x)).abs() < 2e-13, "{x}: {} {}", field.at(x), exact(x));
    }
}

#[test]
fn panels_of_one_length_have_the_potentials_of_others() {
    // int ln(1/|x - s|) ds over [left, right] by its primitive; most nodes are seen from panels of the same length beside them.
    let bounds: Vec<[f64; 2]> =
        (0..300).map(|i| [-0.9 + 0.005 * f64::from(i), -0.9 + 0.005 * f64::from(i + 1)]).collect();
    let [from, to] = [bounds[0][0], bounds[299][1]];
    let primitive = |d: f64| if d == 0.0 { 0.0 } else { d * (1.0 - d.abs().ln()) };
    for order in [6, 10, 13] {
        let panels = Panels::new(bounds.clone(), order).unwrap();
        let operator = PanelOperator::new(PanelKernel::Logarithm, panels).unwrap();
        let ones = vec![1.0; operator.panels().count()];
        for (x, found) in operator.panels().nodes().iter().zip(operator.potential(&ones)) {
            let exact = primitive(x - from) + primitive(to - x);
            assert!((found - exact).abs() < 4e-14, "{order} {x}: {found} {exact}");
        }
    }
}

#[test]
fn what_is_shared_among_processors_has_the_bits_of_one() {
    let bounds: Vec<[f64; 2]> = (0..1500)
        .map(|i| [-0.9 + 0.0011 * f64::from(i), -0.9 + 0.0011 * f64::from(i + 1)])
        .collect();
    let panels = Panels::new(bounds, 10).unwrap();
    let operator = PanelOperator::new(PanelKernel::Logarithm, panels).unwrap();
    let own = |turns: f64| -> Vec<f64> {
        operator.panels().nodes().iter().map(|x| (turns * x).sin()).collect()
    };
    let [one, other] = [own(3.0), own(40.0)];
    let together = operator.potentials(&[&one, &other]);
    for (values, shared) in [one, other].into_iter().zip(together) {
        let locals = operator.tree.locals([&operator.panels().charges(&values)], false);
        let mut alone = vec![0.0; values.len()];
        operator.add_up(0..operator.near.len(), &[values], &locals, &mut [&mut alone]);
        assert_eq!(shared, alone);
    }
    let field = operator.field(&own(7.0));
    let places: Vec<f64> = (0..20_000).map(|i| f64::from(i) / 10_000.0 - 1.0).collect();
    let alone: Vec<f64> = places.iter().map(|x| field.at(*x)).collect();
    assert_eq!(field.values(&places), alone);
    // Enough for more than one part.
    assert!(operator.near_pairs() > 1 << 19, "{}", operator.near_pairs());
}

#[test]
fn an_operator_beside_another_is_its_own_to_the_last_bit() {
    let before = uneven(0);
    let mut after = before.clone();
    after[120][1] -= 1e-4;
    after.remove(200);
    let halved = 0.5 * (after[300][0] + after[300][1]);
    let right = mem::replace(&mut after[300][1], halved);
    after.insert(301, [halved, right]);
    let kernels = [PanelKernel::Logarithm, PanelKernel::Sine, PanelKernel::Power { exponent: 0.4 }];
    for kernel in kernels {
        let other =
            PanelOperator::new(kernel.clone(), Panels::new(before.clone(), 4).unwrap()).unwrap();
        let panels = || Panels::new(after.clone(), 4).unwrap();
        let fresh = PanelOperator::new(kernel.clone(), panels()).unwrap();
        let beside = PanelOperator::beside(kernel.clone(), panels(), Some(&other)).unwrap();
        assert!(fresh.near.iter().all(|block| block.iter().all(|entry| entry.is_finite())));
        assert_eq!(fresh.near, beside.near, "{kernel:?}");
        let leaves = &fresh.tree.boxes.leaves;
        let known = leaves.iter().filter(|leaf| other.block(leaf, fresh.panels()).is_some());
        let known = known.count();
        assert!(known > leaves.len() / 2, "{kernel:?}: {known} of {}", leaves.len());
    }
}

#[test]
fn potentials_at_the_end_of_the_shortest_panels_are_exact() {
    // phi = 1: int (1 - s)^-mu ds from 1 - d to 1 is d^(1-mu)/(1-mu). Lengths of some thousand roundings, whose middles are off by a share of them.
    for closing in 24..=34 {
        let from = |i: i32| 1.0 - 0.05 * 0.4f64.powi(i);
        let mut bounds: Vec<[f64; 2]> = (0..closing).map(|i| [from(i), from(i + 1)]).collect();
        bounds.push([from(closing), 1.0]);
        let panels = Panels::new(bounds, 6).unwrap();
        let operator = PanelOperator::new(PanelKernel::Power { exponent: 0.8 }, panels).unwrap();
        let field = operator.field(&vec![1.0; operator.panels().count()]);
        let exact = (1.0 - from(0)).powf(0.2) / 0.2;
        assert!((field.at(1.0) / exact - 1.0).abs() < 1e-12, "{closing}: {}", field.at(1.0));
    }
}

/// Panels that meet at a place, on either side ever shorter towards it, down to some roundings of places.
fn closing_in(on: [f64; 2], place: f64) -> Vec<[f64; 2]> {
    let mut ends = Vec::new();
    for (from, side) in [(on[0], -1.0), (on[1], 1.0)] {
        let reach = (from - place).abs();
        let beside = (0..45).map(|i| place + side * reach.min(0.04) * 0.5f64.powi(i));
        let far = (1..).map(|i| place + side * 0.04 * f64::from(i));
        ends.extend(beside.chain(far.take_while(|end| (end - place).abs() < reach)));
        ends.extend([from, place]);
    }
    ends.sort_by(f64::total_cmp);
    ends.dedup();
    ends.windows(2).map(|pair| [pair[0], pair[1]]).collect()
}

#[test]
fn potentials_are_smooth_where_panels_meet() {
    // phi = 1: each panel gives d^(1 - mu) of the distance d from its end, which those of both take from each other.
    let power = 0.2;
    let exact = |x: f64| ((1.0 + x).powf(power) + (1.0 - x).powf(power)) / power;
    let bounds = closing_in([-1.0, 1.0], 0.3);
    let panels = Panels::new(bounds.clone(), 8).unwrap();
    let operator = PanelOperator::new(PanelKernel::Power { exponent: 0.8 }, panels).unwrap();
    let ones = vec![1.0; operator.panels().count()];
    // The places of nodes are rounded.
    let rounding = |x: f64| f64::EPSILON * (60.0 + 2.0 * (x - 0.3).abs().powf(-0.8));
    for (x, found) in operator.panels().nodes().iter().zip(operator.potential(&ones)) {
        let error = (found - exact(*x)).abs();
        assert!(error < rounding(*x), "{x}: {error:e} for {:e}", rounding(*x));
    }
    let field = operator.field(&ones);
    let beside = |x: f64| [x, x.next_up(), x.next_down(), x + 3e-14, x - 1e-11, x + 1e-8];
    for x in bounds.iter().skip(1).flat_map(|[left, _]| beside(*left)) {
        assert!((field.at(x) - exact(x)).abs() < rounding(x), "{x}: {:e}", field.at(x) - exact(x));
    }
    // Rings, from the axis on, against the place where two meet itself.
    let bounds = rings(0.4);
    let panels = Panels::about_axis(bounds.clone(), 10).unwrap();
    let operator = PanelOperator::new(ring(0, 0.45), panels).unwrap();
    let field = operator.field(&vec![1.0; operator.panels().count()]);
    for [left, _] in &bounds[1..] {
        for x in [left.next_up(), left.next_down(), left + 1e-14, left - 1e-13] {
            let change = field.at(x) / field.at(*left) - 1.0;
            assert!(change.abs() < 1e-12, "{x}: {change:e}");
        }
    }
}

#[test]
fn products_with_powers_agree_with_those_in_closed_form() {
    for exponent in [0.05, 0.5, 0.8] {
        // Beside the singularity rounded distances show in what the primitive gives.
        let panels = Panels::new(uneven(8), 6).unwrap();
        let operator = PanelOperator::new(PanelKernel::Power { exponent }, panels).unwrap();
        // phi = 2 + x by its primitive on each panel
        let power = 1.0 - exponent;
        let primitive = |x: f64, s: f64| {
            let d = s - x;
            let near = d.abs().powf(power).copysign(d);
            (2.0 + x) * near / power + near * d / (1.0 + power)
        };
        let exact = |x: f64| -> f64 {
            let bounds = operator.panels().bounds();
            bounds.iter().map(|[left, right]| primitive(x, *right) - primitive(x, *left)).sum()
        };
        let values: Vec<f64> = operator.panels().nodes().iter().map(|x| 2.0 + x).collect();
        let size = 4.0 / power;
        for (x, found) in operator.panels().nodes().iter().zip(operator.potential(&values)) {
            assert!((found - exact(*x)).abs() < 2e-13 * size, "{exponent} {x}: {found}");
        }
        let field = operator.field(&values);
        for i in -60..=60 {
            let x = f64::from(i) / 57.3;
            let found = field.at(x);
            assert!((found - exact(x)).abs() < 2e-13 * size, "{exponent} {x}: {found}");
        }
    }
    let panels = || Panels::new(uneven(8), 6).unwrap();
    for exponent in [0.0, 1.0, f64::NAN] {
        assert!(PanelOperator::new(PanelKernel::Power { exponent }, panels()).is_err());
    }
}

#[test]
fn on_a_circle_waves_are_divided_by_their_number() {
    // ln 1/(2 sin(y/2)) = sum cos(m y)/m: over the whole turn cos(m pi s) becomes cos(m pi x)/m.
    let mut cuts: Vec<f64> = (0..=60).map(|i| f64::from(i) / 30.0 - 1.0).collect();
    cuts.extend((1..12).map(|i| 1.0 - 0.03 * 0.4f64.powi(i)));
    cuts.sort_by(f64::total_cmp);
    let bounds = cuts.windows(2).map(|pair| [pair[0], pair[1]]).collect();
    let panels = Panels::new(bounds, 13).unwrap();
    let operator = PanelOperator::new(PanelKernel::Sine, panels).unwrap();
    let pi = std::f64::consts::PI;
    for m in [1.0, 2.0, 5.0] {
        let wave = |x: f64| (m * pi * x + 0.3).cos();
        let values: Vec<f64> = operator.panels().nodes().iter().map(|x| wave(*x)).collect();
        for (x, found) in operator.panels().nodes().iter().zip(operator.potential(&values)) {
            assert!((found - wave(*x) / m).abs() < 1e-13, "{m} {x}: {found}");
        }
        let field = operator.field(&values);
        for x in [-1.7, -1.0, -0.99, -0.3, 0.0, 0.77, 1.0, 2.4] {
            assert!((field.at(x) - wave(x) / m).abs() < 1e-13, "{m} {x}: {}", field.at(x));
        }
    }
}

#[test]
fn slopes_at_ends_where_a_function_vanishes_are_exact() {
    // phi = (s - a)(b - s): int phi/(s - a) ds = (b - a)^2/2
    let [a, b] = [-0.9, 0.75];
    let at = |i: i32| a + (b - a) * f64::from(i) / 900.0;
    let panels = Panels::new((0..900).map(|i| [at(i), at(i + 1)]).collect(), 6).unwrap();
    let operator = PanelOperator::new(PanelKernel::Logarithm, panels).unwrap();
    let values: Vec<f64> = operator.panels().nodes().iter().map(|s| (s - a) * (b - s)).collect();
    let field = operator.field(&values);
    let exact = 0.5 * (b - a) * (b - a);
    for ([found, size], exact) in field.slopes(&[at(0), at(900)]).into_iter().zip([exact, -exact]) {
        assert!((found - exact).abs() < 1e-13 && (size - exact.abs()) < 1e-3, "{found} {exact}");
    }
    assert!(field.slopes(&[]).is_empty());
    // By powers, int mu t^(-mu) (l - t) dt over the length l.
    for exponent in [0.2, 0.8] {
        let bounds = [[a, -0.85], [-0.85, -0.8]];
        let panels = Panels::new(bounds.to_vec(), 6).unwrap();
        let operator = PanelOperator::new(PanelKernel::Power { exponent }, panels).unwrap();
        let values: Vec<f64> =
            operator.panels().nodes().iter().map(|s| (s - a) * (-0.8 - s)).collect();
        let exact = exponent * 0.1f64.powf(2.0 - exponent) / ((1.0 - exponent) * (2.0 - exponent));
        for ([found, _], exact) in
            operator.field(&values).slopes(&[a, -0.8]).into_iter().zip([exact, -exact])
        {
            // The nodes of the panel beside are not in its rule.
            assert!((found / exact - 1.0).abs() < 1e-8, "{exponent}: {found} {exact}");
        }
    }
    // The sum over all nodes, in the gaps of uneven panels.
    for kernel in [PanelKernel::Logarithm, PanelKernel::Sine, PanelKernel::Power { exponent: 0.4 }]
    {
        let operator =
            PanelOperator::new(kernel.clone(), Panels::new(uneven(8), 6).unwrap()).unwrap();
        let (panels, turn) = (operator.panels(), 0.5 * std::f64::consts::PI);
        let values: Vec<f64> = panels.nodes().iter().map(|x| (5.0 * x).cos()).collect();
        let gaps = panels.bounds().windows(2).filter(|pair| pair[0][1] < pair[1][0]);
        let places: Vec<f64> = gaps.map(|pair| 0.7 * pair[0][1] + 0.3 * pair[1][0]).collect();
        for (x, [found, size]) in places.iter().zip(operator.field(&values).slopes(&places)) {
            let parts =
                panels.nodes().iter().zip(panels.weights()).zip(&values).map(|((s, w), v)| {
                    let d = x - s;
                    w * v
                        * match kernel {
                            PanelKernel::Logarithm | PanelKernel::Ring(_) => -1.0 / d,
                            PanelKernel::Sine => -turn * (turn * d).cos() / (turn * d).sin(),
                            PanelKernel::Power { exponent } => {
                                -exponent * d.signum() * d.abs().powf(-1.0 - exponent)
                            }
                        }
                });
            let exact: f64 = parts.sum();
            assert!((found - exact).abs() < 1e-12 * size, "{kernel:?} {x}: {found} {exact} {size}");
        }
    }
}

fn ring(harmonic: usize, exponent: f64) -> PanelKernel {
    PanelKernel::Ring(crate::multipole::rings::tests::rings(harmonic, exponent))
}

/// Rings that are ever shorter towards a place, and from the axis on no longer than their distance from it.
fn rings(place: f64) -> Vec<[f64; 2]> {
    let mut bounds = vec![[0.0, 0.01]];
    while let Some(&[_, left]) = bounds.last()
        && left < 0.8
    {
        let nearest = if left < place { 0.4 * (place - left) } else { 0.6 * (left - place) };
        let length = (0.5 * left).min(0.03).min(nearest.max(1e-6));
        bounds.push([left, left + length]);
    }
    bounds
}

#[test]
fn rings_have_the_potentials_in_closed_form() {
    for (order, allowed) in [(8, 3e-12), (10, 3e-14), (13, 2e-14)] {
        let bounds = rings(0.4);
        let radius = bounds[bounds.len() - 1][1];
        let panels = Panels::about_axis(bounds, order).unwrap();
        let operator = PanelOperator::new(ring(0, 0.0), panels).unwrap();
        let exact = |x: f64| radius * crate::multipole::rings::tests::uniform(x / radius);
        let ones = vec![1.0; operator.panels().count()];
        let potential = operator.potential(&ones);
        for (x, found) in operator.panels().nodes().iter().zip(potential) {
            assert!((found - exact(*x)).abs() < allowed, "{order} {x}: {found} {}", exact(*x));
        }
        let field = operator.field(&ones);
        for i in 0..=100 {
            let x = f64::from(i) / 80.0;
            assert!((field.at(x) - exact(x)).abs() < allowed, "{x}: {} {}", field.at(x), exact(x));
        }
        let area: f64 = operator.panels().weights().iter().sum();
        assert!((area - 0.5 * radius * radius).abs() < 1e-15);
    }
}

#[test]
fn rings_of_an_uneven_pressure_have_the_potential_of_a_rule_of_their_own() {
    // An annulus with a gap, and p = cos(3 s^2), by the double exponential rule from the place to all ends.
    let bounds: Vec<[f64; 2]> = rings(0.3).into_iter().filter(|[left, _]| *left >= 0.2).collect();
    let bounds: Vec<[f64; 2]> =
        bounds.into_iter().filter(|[left, right]| *left > 0.55 || *right < 0.5).collect();
    for (harmonic, exponent) in [(0, 0.0), (1, 0.0), (0, 0.1), (0, 0.7), (1, 0.4), (0, 0.9)] {
        uneven_rings(harmonic, exponent, &bounds);
        // From the axis on.
        uneven_rings(harmonic, exponent, &rings(0.3));
    }
}

fn uneven_rings(harmonic: usize, exponent: f64, bounds: &[[f64; 2]]) {
    let panels = Panels::about_axis(bounds.to_vec(), 13).unwrap();
    let operator = PanelOperator::new(ring(harmonic, exponent), panels).unwrap();
    let values: Vec<f64> = operator.panels().nodes().iter().map(|s| (3.0 * s * s).cos()).collect();
    let field = operator.field(&values);
    let exact = |x: f64| -> f64 {
        let kernel = WeberSonine::new(1.0, harmonic as f64, 0.5 * exponent).unwrap();
        let strength = kernel.split(1.0, 1.0, 0.0).factor;
        let defined = |x: f64, s: f64, difference: f64| {
            if exponent == 0.0 {
                return crate::multipole::rings::tests::defined(harmonic, x, s, difference);
            }
            let value = exponent / strength * kernel.pair(x, s, difference.abs()).value;
            if value < 1e300 { value } else { 0.0 }
        };
        let power = 1.0 / (1.0 - exponent);
        let part = |from: f64, to: f64| -> f64 {
            let rule = crate::quadrature::double_exponential(120);
            rule.map(|node| {
                let u = 0.5 * node.from_left;
                let step = (to - from) * u.powf(power);
                let (s, difference) = (from + step, (x - from) - step);
                if difference == 0.0 || s <= 0.0 {
                    return 0.0;
                }
                let kernel = defined(x, s, difference);
                0.5 * node.weight * power * (step / u).abs() * kernel * s * (3.0 * s * s).cos()
            })
            .sum()
        };
        let of = |[left, right]: &[f64; 2]| {
            if *left < x && x < *right {
                part(x, *left) + part(x, *right)
            } else if x <= *left {
                part(*left, *right)
            } else {
                part(*right, *left)
            }
        };
        bounds.iter().map(of).sum()
    };
    for x in [0.0, 0.05, 0.1999, 0.25, 0.3001, 0.41, 0.52, 0.55, 0.7, 0.95] {
        let found = field.at(x);
        let (size, exact) = (1.0 / (1.0 - exponent), exact(x));
        assert!((found - exact).abs() < 1e-13 * size, "{harmonic} {exponent} {x}: {found} {exact}");
    }
    if bounds[0][0] == 0.0 {
        return;
    }
    let slopes = field.slopes(&[0.52, 0.95]);
    for (x, [slope, _]) in [0.52, 0.95].into_iter().zip(slopes) {
        let difference = (exact(x + 1e-4) - exact(x - 1e-4)) / 2e-4;
        // The nodes alone integrate it.
        let allowed = 1e-5 * (1.0 + slope.abs());
        assert!((slope - difference).abs() < allowed, "{exponent} {x}: {slope} {difference}");
    }
}
