//! Layers of finite thickness and coatings against their boundary value problems, limits, and the residual by Fourier and Hankel transforms.

use std::f64::consts::{FRAC_2_PI, PI};

use shtaerman::{
    Contact, Elastic, Foundation, Geometry, LayerBase, Layering, Load, Problem, Profile, Punch,
    Rotational, Vertical,
};

/// What the punch is pressed into, and the punch without its profile.
type Body = (Foundation, Punch);

const BASES: [LayerBase; 3] = [
    LayerBase::Frictionless,
    LayerBase::Bonded { poisson_ratio: 0.3 },
    LayerBase::Bonded { poisson_ratio: 0.5 },
];

fn in_numbers(geometry: Geometry, theta0: f64) -> Body {
    let foundation = Foundation::dimensionless(theta0).unwrap();
    (foundation, Punch::in_geometry(geometry, 1.0).unwrap())
}

fn on_layer(geometry: Geometry, theta0: f64, thickness: f64, base: LayerBase) -> Body {
    let (foundation, punch) = in_numbers(geometry, theta0);
    (foundation.with_layering(Layering::layer(thickness, base).unwrap()), punch)
}

fn posed(
    (foundation, punch): Body,
    profile: &str,
    vertical: Vertical,
    rotational: Rotational,
) -> Problem {
    let is_circular = punch.geometry() == Geometry::Circular;
    let profile = if is_circular { Profile::radial(profile) } else { Profile::expression(profile) };
    let load = Load::new(vertical, rotational).unwrap();
    Problem::new(foundation, punch.with_profile(profile.unwrap()), load).unwrap()
}

fn solved(body: Body, profile: &str, force: f64, rotational: Rotational) -> Contact {
    posed(body, profile, Vertical::Force(force), rotational).solve().unwrap()
}

/// `p/E` at a place in half-widths.
fn pressure(contact: &Contact, xi: f64) -> f64 {
    contact.dimensionless().pressure(xi).unwrap()
}

/// Solves linear equations, the right-hand side last in each row.
fn eliminate(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let n = rows.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&i, &j| rows[i][k].abs().total_cmp(&rows[j][k].abs())).unwrap();
        rows.swap(k, pivot);
        for i in (0..n).filter(|i| *i != k) {
            let factor = rows[i][k] / rows[k][k];
            let source = rows[k].clone();
            rows[i].iter_mut().zip(source).for_each(|(entry, s)| *entry -= factor * s);
        }
    }
    (0..n).map(|k| rows[k][n] / rows[k][k]).collect()
}

/// What Airy's function `f(y) cos ux` has at a depth, from `[f, f', f'', f''']`: minus the normal stress over `u^2`, the shear over `u`, both times the material's `E*` left out, and both
/// displacements times `E*`: `E* u^2 v = f''' - (2 - nu)/(1 - nu) u^2 f'`, `E* u u_x = f'' + nu/(1 - nu) u^2 f`.
fn state([f0, f1, f2, f3]: [f64; 4], u: f64, poisson: f64) -> [f64; 4] {
    let sink = (f3 - (2.0 - poisson) / (1.0 - poisson) * u * u * f1) / (u * u);
    let slide = (f2 + poisson / (1.0 - poisson) * u * u * f0) / u;
    [f0, f1, sink, slide]
}

/// The functions `exp(ku y)` and `y exp(ku y)`, `k = -1` and 1, with three derivatives.
fn functions(u: f64, y: f64) -> [[f64; 4]; 4] {
    let of = |k: f64| {
        let (q, e) = (k * u, (k * u * y).exp());
        let plain = [e, q * e, q * q * e, q * q * q * e];
        let with = [
            y * e,
            (1.0 + q * y) * e,
            (2.0 * q + q * q * y) * e,
            (3.0 * q * q + q * q * q * y) * e,
        ];
        [plain, with]
    };
    let ([a, b], [c, d]) = (of(-1.0), of(1.0));
    [a, b, c, d]
}

/// `M(u)` of a coating `0 <= y <= 1` on a half-plane below it (`y` goes down), from the equations of both: no shear and the load `cos ux` on top, and at `y = 1` both stresses and both
/// displacements of one side as of the other.
fn transfer_of_the_coating(u: f64, coating: [f64; 2], substrate: [f64; 2]) -> f64 {
    let [e1, nu1] = coating;
    let [e2, nu2] = substrate;
    let [top, bottom] = [0.0, 1.0].map(|y| functions(u, y).map(|f| state(f, u, nu1)));
    // Of the half-plane the two that fall, from y = 1.
    let below: Vec<[f64; 4]> = functions(u, 0.0)[..2].iter().map(|f| state(*f, u, nu2)).collect();
    let mut rows = vec![
        (0..4).map(|k| top[k][0]).chain([0.0, 0.0, 1.0 / (u * u)]).collect::<Vec<f64>>(),
        (0..4).map(|k| top[k][1]).chain([0.0, 0.0, 0.0]).collect(),
    ];
    for part in 0..4 {
        let [one, two] = if part < 2 { [1.0, 1.0] } else { [1.0 / e1, 1.0 / e2] };
        let upper = bottom.iter().map(|state| one * state[part]);
        let lower = below.iter().map(|state| -two * state[part]);
        rows.push(upper.chain(lower).chain([0.0]).collect());
    }
    let found = eliminate(rows);
    let sink: f64 = (0..4).map(|k| found[k] * top[k][2]).sum();
    // y goes down and the load presses: the face sinks by 2 M/(E* u) cos ux.
    0.5 * u * sink.abs()
}

#[test]
fn coatings_solve_their_boundary_value_problem() {
    for nus in [[0.3, 0.3], [0.0, 0.5], [0.49, 0.1]] {
        for ratio in [1e-3, 0.3, 1.0, 2.0, 500.0] {
            let upper = Elastic::new(ratio, nus[0]).unwrap();
            let lower = Elastic::new(1.0, nus[1]).unwrap();
            let layering = Layering::coating(1.0, upper, lower).unwrap();
            let moduli = [upper, lower].map(|material| material.plane_strain_modulus());
            for u in [0.02, 0.1, 0.6, 1.0, 2.5, 7.0] {
                let [one, two] = [[moduli[0], nus[0]], [moduli[1], nus[1]]];
                let exact = transfer_of_the_coating(u, one, two);
                let found = layering.transfer(u);
                assert!((found / exact - 1.0).abs() < 1e-8, "{nus:?} {ratio} {u}: {found} {exact}");
            }
            let far = layering.far_share();
            assert!((layering.transfer(1e-9) / far - 1.0).abs() < 1e-5, "{ratio}");
            assert!((layering.transfer(30.0) - 1.0).abs() < 1e-15);
        }
    }
}

/// A rigid half-plane below a coating is a bonded layer, a coating like what it lies on is none.
#[test]
fn limits_of_coatings() {
    let steel = Elastic::new(2.0, 0.3).unwrap();
    let same = Layering::coating(1.0, steel, steel).unwrap();
    let soft = Elastic::new(2e-4, 0.3).unwrap();
    let on_steel = Layering::coating(1.0, soft, steel).unwrap();
    let bonded = Layering::layer(1.0, LayerBase::Bonded { poisson_ratio: 0.3 }).unwrap();
    for u in [1e-3, 0.1, 1.0, 4.0] {
        assert!((same.transfer(u) - 1.0).abs() < 1e-14, "{u}");
        let [one, two] = [on_steel.transfer(u), bonded.transfer(u)];
        assert!((one - two).abs() < 2e-4, "{u}: {one} {two}");
    }
}

/// `lim k(t) + ln t = int_0^inf (M - m - (1 - m) (1 - exp(-u)))/u du`, by Simpson's rule.
fn constant(layering: &Layering) -> f64 {
    let far = layering.far_share();
    let at = |u: f64| (layering.transfer(u) - far - (1.0 - far) * -(-u).exp_m1()) / u;
    let (count, last) = (40_000, 40.0);
    let step = last / f64::from(count);
    (1..=count)
        .map(|j| {
            let (left, right) = (f64::from(j - 1) * step, f64::from(j) * step);
            let middle = 0.5 * (left + right);
            step / 6.0 * (at(left.max(1e-7)) + 4.0 * at(middle) + at(right))
        })
        .sum()
}

#[test]
fn thick_layers_are_half_planes() {
    let (theta0, force) = (3.0, 0.9);
    for profile in ["0", "4*xi^2"] {
        let half_plane =
            solved(in_numbers(Geometry::Plane, theta0), profile, force, Rotational::Moment(0.1));
        for base in BASES {
            let layering = Layering::layer(1.0, base).unwrap();
            let mut last = f64::INFINITY;
            for thickness in [30.0, 300.0, 3000.0] {
                let frame = on_layer(Geometry::Plane, theta0, thickness, base);
                let contact = solved(frame, profile, force, Rotational::Moment(0.1));
                let gauge = theta0 * force * (thickness.ln() + constant(&layering));
                let off = (contact.settlement() - gauge - half_plane.settlement()).abs();
                let at = (pressure(&contact, 0.1) - pressure(&half_plane, 0.1)).abs();
                // The first term left out is of the order h^-2.
                let allowed = 4.0 * thickness.powi(-2) + 1e-9;
                assert!(
                    off < allowed && at < allowed,
                    "{profile} {base:?} {thickness}: {off:e} {at:e}"
                );
                assert!(off < last + 1e-9);
                last = off;
            }
        }
    }
}

#[test]
fn thick_layers_are_half_spaces() {
    let (theta0, force) = (2.0, 1.5);
    let disk = in_numbers(Geometry::Circular, theta0);
    let half_space = solved(disk, "3*r^2", force, Rotational::Tilt(0.0));
    for base in BASES {
        for thickness in [30.0, 3000.0] {
            let frame = on_layer(Geometry::Circular, theta0, thickness, base);
            let contact = solved(frame, "3*r^2", force, Rotational::Tilt(0.0));
            // theta0 P0/2 int (M - 1) du/h, the displacement far below that the base takes away.
            let off = contact.settlement() - half_space.settlement();
            assert!(
                off < 0.0 && off.abs() < 2.0 * theta0 * force / thickness,
                "{base:?} {thickness}: {off:e}"
            );
            let at = (pressure(&contact, 0.1) - pressure(&half_space, 0.1)).abs();
            assert!(at < 30.0 * thickness.powi(-3) + 1e-9, "{base:?} {thickness}: {at:e}");
        }
    }
}

/// A thin layer is a bed of springs that adds `pi theta0 h M'(0)`, `M'(0) = 1/2` or `(1 - 2 nu)/(2 (1 - nu)^2)`: `(1 - nu^2) h/E` and `(1 - 2 nu)(1 + nu)/(1 - nu) h/E`.
#[test]
fn thin_layers_are_springs() {
    for geometry in [Geometry::Plane, Geometry::Circular] {
        for (base, slope) in [(BASES[0], 0.5), (BASES[1], 0.5 * 0.4 / 0.49)] {
            let mut last = f64::INFINITY;
            for thickness in [0.4, 0.2, 0.1] {
                let theta0 = 0.3 / thickness;
                let springs = 1.0 + PI * theta0 * thickness * slope;
                let frame = on_layer(geometry, theta0, thickness, base);
                let load = Vertical::Settlement(1.0);
                let contact = posed(frame, "0", load, Rotational::Tilt(0.0)).solve().unwrap();
                let in_the_middle = pressure(&contact, 0.0) * springs - 1.0;
                let area = if geometry == Geometry::Circular { PI } else { 2.0 };
                let whole = (contact.force() * springs / area - 1.0).abs();
                assert!(
                    whole < 3.0 * thickness && whole < 0.6 * last,
                    "{geometry:?} {base:?} {thickness}: {whole}"
                );
                assert!(
                    in_the_middle.abs() < 3e-5 || thickness > 0.1,
                    "{geometry:?} {base:?}: {in_the_middle}"
                );
                last = whole;
            }
        }
    }
}

/// A thin, incompressible, bonded layer gives by `-(h^3/E) p''`: without dimensions `(2 pi theta0/3) h^3`, and the pressure `1 - cosh(xi/l)/cosh(1/l)` under a flat punch.
#[test]
fn thin_incompressible_layers_are_squeezed_aside() {
    let mut last = f64::INFINITY;
    for thickness in [0.1, 0.05] {
        let length = 0.3f64;
        let theta0 = length * length / (2.0 * PI / 3.0 * f64::powi(thickness, 3));
        let frame = on_layer(Geometry::Plane, theta0, thickness, BASES[2]);
        let contact =
            posed(frame, "0", Vertical::Settlement(1.0), Rotational::Tilt(0.0)).solve().unwrap();
        let exact = |xi: f64| 1.0 - (xi / length).cosh() / (1.0 / length).cosh();
        let off = [0.0, 0.4, 0.7]
            .map(|xi| (pressure(&contact, xi) - exact(xi)).abs())
            .into_iter()
            .fold(0.0, f64::max);
        // The pressure vanishes a share of the thickness beside the edge.
        assert!(off < 2.0 * thickness && off < 0.7 * last, "{thickness}: {off}");
        last = off;
    }
}

#[test]
fn equal_materials_are_no_coating() {
    let steel = Elastic::new(210e9, 0.3).unwrap();
    let plain = Foundation::new(steel).with_roughness(3e-15).unwrap();
    let coated = plain.with_layering(Layering::coating(2e-5, steel, steel).unwrap());
    for profile in ["0", "x^2/0.2"] {
        let [plain, coated] = [&plain, &coated].map(|foundation| {
            let punch = Punch::new(1e-3).unwrap();
            solved((foundation.clone(), punch), profile, 3e5, Rotational::Moment(20.0))
        });
        assert!((plain.settlement() / coated.settlement() - 1.0).abs() < 1e-10);
        assert!((plain.tilt() / coated.tilt() - 1.0).abs() < 1e-9);
        for xi in [-0.9, 0.0, 0.3] {
            let [one, two] = [pressure(&plain, xi), pressure(&coated, xi)];
            assert!(
                (one - two).abs() < 1e-10 * plain.dimensionless().peak_pressure(),
                "{xi}: {one} {two}"
            );
        }
    }
}

/// Nodes and weights on an interval: Gauss's rule of five places on so many parts.
fn nodes([left, right]: [f64; 2], parts: u32) -> Vec<[f64; 2]> {
    let rule = [
        [0.0, 0.568_888_888_888_888_9],
        [0.538_469_310_105_683_1, 0.478_628_670_499_366_5],
        [0.906_179_845_938_664, 0.236_926_885_056_189_1],
    ];
    let half = 0.5 * (right - left) / f64::from(parts);
    (0..parts)
        .flat_map(|k| {
            let middle = left + (2.0 * f64::from(k) + 1.0) * half;
            rule.into_iter().flat_map(move |[y, w]| {
                let both = if y == 0.0 { vec![0.0] } else { vec![-y, y] };
                both.into_iter().map(move |y| [middle + half * y, half * w])
            })
        })
        .collect()
}

/// The displacement that a pressure makes, by transforms: `theta0 int (M(uh)/u) p^(u) cos ux du` for even pressures on a layer in a plane,
/// `pi theta0 int M(uh) p^(u) J_0(ur) du` on a disk.
fn displacement(contact: &Contact, theta0: f64, layering: &Layering, at: f64) -> f64 {
    let round = contact.problem().punch().geometry() == Geometry::Circular;
    let zone = contact.dimensionless().zones()[0];
    let wave = |z: f64| if round { libm::j0(z) } else { z.cos() };
    let pressures: Vec<[f64; 2]> = nodes([0.0, zone[1]], 60)
        .into_iter()
        .map(|[s, w]| [s, w * pressure(contact, s) * if round { s } else { 2.0 }])
        .collect();
    let h = layering.thickness();
    let sum: f64 = nodes([0.0, 400.0], 500)
        .into_iter()
        .map(|[u, w]| {
            let transform: f64 = pressures.iter().map(|[s, p]| p * wave(u * s)).sum();
            let share = if round { PI } else { 1.0 / u };
            w * share * layering.transfer(u * h) * transform * wave(u * at)
        })
        .sum();
    theta0 * sum
}

#[test]
fn transforms_leave_no_residual() {
    for geometry in [Geometry::Plane, Geometry::Circular] {
        for base in BASES {
            for (thickness, theta0) in [(0.25, 12.0), (1.3, 2.0)] {
                let frame = on_layer(geometry, theta0, thickness, base);
                let profile = if geometry == Geometry::Circular { "6*r^2" } else { "6*xi^2" };
                let contact = solved(frame, profile, 0.4, Rotational::Tilt(0.0));
                let layering = Layering::layer(thickness, base).unwrap();
                let edge = contact.dimensionless().zones()[0][1];
                assert!(edge < 0.99 && contact.dimensionless().zones().len() == 1);
                for share in [0.0, 0.4, 0.8] {
                    let xi = share * edge;
                    let given =
                        pressure(&contact, xi) + displacement(&contact, theta0, &layering, xi);
                    let wanted = contact.settlement() - 6.0 * xi * xi;
                    // The transform of a pressure that falls to 0 like a line falls as u^-2, its displacement's as u^-3.
                    assert!(
                        (given - wanted).abs() < 2e-4 * contact.settlement(),
                        "{geometry:?} {base:?} {thickness} {xi}: {given} {wanted}"
                    );
                }
                // Beside the punch there is no pressure, and its effect fades within some thicknesses.
                for xi in [1.0, 1.4, 2.3, 6.0] {
                    let given = contact.elastic_displacement(xi);
                    let wanted = displacement(&contact, theta0, &layering, xi);
                    assert!(
                        (given - wanted).abs() < 2e-4 * contact.settlement(),
                        "{geometry:?} {base:?} {thickness} {xi}: {given} {wanted}"
                    );
                }
            }
        }
    }
}

/// A coating adds `int (M - m)/u cos(ut)` to what the substrate gives, which is compared with the half-plane's own answer to the same pressure.
#[test]
fn coatings_leave_no_residual() {
    let lower = Elastic::new(1.0, 0.3).unwrap();
    for (ratio, thickness) in [(3.0, 0.1), (0.2, 0.3), (20.0, 0.05)] {
        let upper = Elastic::new(ratio, 0.25).unwrap();
        let layering = Layering::coating(thickness, upper, lower).unwrap();
        let chi = 0.2;
        let foundation =
            Foundation::new(lower).with_roughness(chi).unwrap().with_layering(layering.clone());
        let punch = Punch::new(1.0).unwrap();
        let contact = solved((foundation, punch), "0.9*x^2", 0.3, Rotational::Tilt(0.0));
        let theta0 = contact.problem().theta0();
        assert!((theta0 - FRAC_2_PI * 0.91 / chi).abs() < 1e-14);
        let edge = contact.dimensionless().zones()[0][1];
        assert!(edge < 0.99 && contact.dimensionless().zones().len() == 1, "{ratio}: {edge}");
        let far = layering.far_share();
        let pressures: Vec<[f64; 2]> = nodes([0.0, edge], 60)
            .into_iter()
            .map(|[s, w]| [s, w * pressure(&contact, s)])
            .collect();
        let coated = |x: f64| -> f64 {
            nodes([0.0, 400.0], 600)
                .into_iter()
                .map(|[u, w]| {
                    let transform: f64 =
                        pressures.iter().map(|[s, p]| 2.0 * p * (u * s).cos()).sum();
                    w * (layering.transfer(u * thickness) - far) / (far * u)
                        * transform
                        * (u * x).cos()
                })
                .sum()
        };
        // int ln(1/|x - s|) p ds, with the value at x taken out
        let plain = |x: f64| -> f64 {
            let p = pressure(&contact, x);
            let both: f64 = [-1.0, 1.0]
                .into_iter()
                .flat_map(|sign| {
                    pressures
                        .iter()
                        .zip(nodes([0.0, edge], 60))
                        .map(move |([s, wp], [_, w])| (sign * s, *wp, w))
                })
                .map(|(s, wp, w)| -(wp - w * p) * (x - s).abs().max(1e-300).ln())
                .sum();
            let own = |d: f64| d - d * d.ln();
            both + p * (own(edge - x) + own(edge + x))
        };
        for share in [0.123, 0.5, 0.8] {
            let x = share * edge;
            let given = pressure(&contact, x) + theta0 * (plain(x) + coated(x));
            // Displacements are counted in chi E, and E = 1.
            let wanted = (contact.settlement() - 0.9 * x * x) / chi;
            assert!(
                (given - wanted).abs() < 5e-4 * given.abs().max(0.1),
                "{ratio} {thickness} {x}: {given} {wanted}"
            );
        }
    }
}

/// A bonded layer is of the foundation's material, and a coating lies on it.
#[test]
fn layers_are_of_the_material_of_their_foundation() {
    let rubber = Elastic::new(3e6, 0.49).unwrap();
    let foundation = Foundation::new(rubber).with_roughness(1e-10).unwrap();
    let load = Load::force(1e3).unwrap();
    let posed = |layering: Layering| {
        let on = foundation.with_layering(layering);
        Problem::new(on, Punch::new(0.01).unwrap(), load)
    };
    let bonded = |poisson_ratio: f64| {
        posed(Layering::layer(8e-3, LayerBase::Bonded { poisson_ratio }).unwrap())
    };
    assert!(bonded(0.49).is_ok());
    assert!(bonded(0.1).unwrap_err().to_string().contains("that of the foundation"));
    let hard = Elastic::new(1e9, 0.3).unwrap();
    let coated = |substrate| posed(Layering::coating(1e-3, hard, substrate).unwrap());
    assert!(coated(rubber).is_ok());
    assert!(coated(Elastic::new(3e6, 0.3).unwrap()).is_err());
}
