//! Ground given by its influence function: against built-in layers and coatings, the half-plane, and product integration.

use std::f64::consts::FRAC_PI_4;

use shtaerman::{
    Contact, Elastic, Foundation, Influence, LayerBase, Layering, Load, Problem, Profile, Punch,
    Rotational, Vertical,
};

fn pressed(foundation: &Foundation, profile: &str, rotational: Rotational) -> Problem {
    let punch = Punch::new(1.0).unwrap().with_profile(Profile::expression(profile).unwrap());
    let load = Load::new(Vertical::Force(0.8), rotational).unwrap();
    Problem::new(foundation.clone(), punch, load).unwrap()
}

fn bare(theta0: f64) -> Foundation {
    Foundation::dimensionless(theta0).unwrap()
}

/// Settlement, tilt and pressures agree to what both state of their errors.
fn agree(one: &Contact, two: &Contact, settlement: f64) {
    let [a, b] = [one.error().unwrap(), two.error().unwrap()];
    let [p, q] = [one, two].map(Contact::dimensionless);
    let moved = p.settlement() + settlement - q.settlement();
    let floor = 1e-13 * q.settlement().abs().max(1.0);
    assert!(moved.abs() <= a.settlement + b.settlement + floor, "{moved:e} {a:?} {b:?}");
    let turned = p.tilt() - q.tilt();
    assert!(turned.abs() <= a.tilt + b.tilt + 1e-13, "{turned:e} {a:?} {b:?}");
    for xi in [-0.97, -0.4, 0.0, 0.3, 0.8] {
        let off = p.pressure(xi).unwrap() - q.pressure(xi).unwrap();
        assert!(off.abs() <= a.pressure + b.pressure + 1e-13, "{xi}: {off:e} {a:?} {b:?}");
    }
}

const PROFILES: [&str; 2] = ["0.1*xi^2", "2*xi^2 + 0.3*xi"];

#[test]
fn a_transfer_function_is_that_of_the_layer() {
    for base in [LayerBase::Frictionless, LayerBase::Bonded { poisson_ratio: 0.3 }] {
        for thickness in [0.1, 0.7, 8.0] {
            let layering = Layering::layer(thickness, base).unwrap();
            let known = layering.clone();
            let own = Influence::by_transfer(thickness, 0.0, move |u| known.transfer(u)).unwrap();
            for profile in PROFILES {
                let [built_in, own] = [
                    bare(3.0).with_layering(layering.clone()),
                    bare(3.0).with_influence(own.clone()),
                ]
                .map(|on| pressed(&on, profile, Rotational::Moment(0.05)).solve().unwrap());
                agree(&own, &built_in, 0.0);
            }
        }
    }
}

#[test]
fn a_transfer_function_is_that_of_the_coating() {
    let [hard, soft] = [Elastic::new(5.0, 0.2).unwrap(), Elastic::new(1.0, 0.3).unwrap()];
    let layering = Layering::coating(0.2, hard, soft).unwrap();
    let (known, share) = (layering.clone(), layering.far_share());
    let own = Influence::by_transfer(0.2, share, move |u| known.transfer(u)).unwrap();
    // The material of an influence function is that at the surface.
    let coated = Foundation::new(soft).with_roughness(0.3).unwrap().with_layering(layering);
    let own = Foundation::new(hard).with_roughness(0.3).unwrap().with_influence(own);
    for profile in PROFILES {
        let [coated, own] =
            [&coated, &own].map(|on| pressed(on, profile, Rotational::Tilt(0.02)).solve().unwrap());
        let off = coated.settlement() / own.settlement() - 1.0;
        assert!(off.abs() < 1e-10, "{off:e}");
        for x in [-0.9, 0.0, 0.5] {
            let [p, q] = [&coated, &own].map(|contact| contact.pressure(x).unwrap());
            assert!((p - q).abs() < 1e-9 * coated.peak_pressure(), "{profile} {x}: {p} {q}");
        }
    }
}

#[test]
fn no_remainder_is_the_half_plane_and_a_constant_one_moves_the_datum() {
    for profile in PROFILES {
        let solve =
            |on: &Foundation| pressed(on, profile, Rotational::Moment(0.1)).solve().unwrap();
        let plain = solve(&bare(4.0));
        for constant in [0.0, 2.5] {
            let own = solve(&bare(4.0).with_influence(Influence::by_remainder(move |_| constant)));
            agree(&plain, &own, 4.0 * constant * 0.8);
        }
        let one = Influence::by_transfer(1.0, 1.0, |_| 1.0).unwrap();
        agree(&plain, &solve(&bare(4.0).with_influence(one)), 0.0);
    }
}

/// `M = tanh u` has `K = ln coth(pi d/(4h))`; lengths in metres are those of the punch, whatever its half-width.
#[test]
fn both_forms_are_one_ground() {
    let (h, a) = (2e-3, 5e-3f64);
    let c = FRAC_PI_4 / h;
    let beside = move |d: f64| if d == 0.0 { -c.ln() } else { -((c * d).tanh() / d).ln() };
    let forms = [
        Influence::by_transfer(h, 0.0, f64::tanh).unwrap(),
        Influence::by_remainder(move |d| beside(d) - a.ln()),
    ];
    let steel = Foundation::new(Elastic::new(200e9, 0.3).unwrap()).with_roughness(1e-14).unwrap();
    for (profile, moment) in [("x^2/1.6", 100.0), ("x^2/(2*0.05) + x/500", 20.0)] {
        let [one, two] = forms.clone().map(|form| {
            let punch = Punch::new(a).unwrap().with_profile(Profile::expression(profile).unwrap());
            let load = Load::force(0.4e6).unwrap().with_moment(moment).unwrap();
            let problem = Problem::new(steel.with_influence(form), punch, load).unwrap();
            let contact = problem.solve().unwrap();
            let check = problem.cross_check(&contact).unwrap();
            assert!(check.agrees, "{check:?}");
            contact
        });
        assert!((one.settlement() / two.settlement() - 1.0).abs() < 1e-10);
        assert!((one.tilt() / two.tilt() - 1.0).abs() < 1e-9);
        assert!((one.contact_width() / two.contact_width() - 1.0).abs() < 1e-9);
        // By the linearised equation, and by differences of solutions
        let [tangent, differences] =
            [one.tangent_sensitivities().unwrap(), one.difference_sensitivities().unwrap()];
        let [p, q] = [tangent, differences].map(|found| found.settlement.unwrap().force.unwrap());
        assert!((p / q - 1.0).abs() < 1e-6, "{p} {q}");
    }
}

/// As in the book, chapter *Layers and coatings*.
#[test]
fn sand_that_is_stiffer_below() {
    let share = 1.0 / 1.5;
    let transfer = move |u: f64| 1.0 - (1.0 - share) * (-2.0 * u).exp() * (1.0 + 2.0 * u);
    let ground = Influence::by_transfer(4.0, share, transfer).unwrap();
    let plain = Foundation::new(Elastic::new(40e6, 0.3).unwrap()).with_roughness(1e-9).unwrap();
    let load = Load::force(300e3).unwrap().with_moment(60e3).unwrap();
    let solve = |on: Foundation| {
        let footing = Problem::new(on, Punch::new(1.5).unwrap(), load).unwrap();
        let contact = footing.solve().unwrap();
        assert!(footing.cross_check(&contact).unwrap().agrees);
        contact
    };
    let [stiffer, plain] = [solve(plain.with_influence(ground)), solve(plain)];
    assert!(stiffer.tilt().abs() < plain.tilt().abs());
}

#[test]
fn layers_and_coatings_are_cross_checked() {
    let [hard, soft] = [Elastic::new(5.0, 0.2).unwrap(), Elastic::new(1.0, 0.3).unwrap()];
    let layer = |h: f64, base| bare(3.0).with_layering(Layering::layer(h, base).unwrap());
    let coating = |h: f64, on: [Elastic; 2]| {
        let coating = Layering::coating(h, on[0], on[1]).unwrap();
        Foundation::new(on[1]).with_roughness(0.3).unwrap().with_layering(coating)
    };
    for (foundation, profile) in [
        (layer(0.1, LayerBase::Frictionless), "2*xi^2 + 0.3*xi"),
        (layer(0.5, LayerBase::Bonded { poisson_ratio: 0.5 }), "0"),
        (layer(20.0, LayerBase::Bonded { poisson_ratio: 0.0 }), "2*xi^2 + 0.3*xi"),
        (coating(0.05, [hard, soft]), "0"),
        (coating(0.3, [soft, hard]), "2*xi^2 + 0.3*xi"),
    ] {
        let problem = pressed(&foundation, profile, Rotational::Moment(0.05));
        let check = problem.cross_check(&problem.solve().unwrap()).unwrap();
        assert!(check.agrees && check.limits.is_none(), "{profile} {foundation:?} {check:?}");
        assert!(check.pressure < 1e-7, "{profile} {foundation:?} {check:?}");
    }
}

#[test]
fn what_is_no_ground_is_refused_in_plain_words() {
    let refused = |form: Influence| {
        let problem = pressed(&bare(1.0).with_influence(form), "xi^2", Rotational::Moment(0.0));
        problem.solve().unwrap_err().to_string()
    };
    let said = refused(Influence::by_remainder(|d| 0.1 * d));
    assert!(said.contains("without a term in d itself"), "{said}");
    let said = refused(Influence::by_remainder(|_| -1.0));
    assert!(said.contains("positive"), "{said}");
    let said = refused(Influence::by_remainder(|d| if d < 0.7 { 0.0 } else { 0.1 }));
    assert!(said.contains("smooth"), "{said}");
    let said = refused(Influence::by_remainder(|d| 1.0 / (d - 0.3)));
    assert!(said.contains("smooth") || said.contains("finite"), "{said}");
    let kinked = |u: f64| u.tanh() + 0.1 * (u - 1.03).max(0.0) * (-2.0 * u).exp();
    let said = refused(Influence::by_transfer(1.0, 0.0, kinked).unwrap());
    assert!(said.contains("smooth"), "{said}");

    let transfer = |function: fn(f64) -> f64| Influence::by_transfer(1.0, 0.0, function);
    for (function, word) in [
        ((|_| -1.0) as fn(f64) -> f64, "positive"),
        (|_| f64::NAN, "positive"),
        (|u| u / (1.0 + u), "1 at u = 25"),
    ] {
        let said = transfer(function).unwrap_err().to_string();
        assert!(said.contains(word), "{said}");
    }
    assert!(Influence::by_transfer(0.0, 0.0, f64::tanh).is_err());
    assert!(Influence::by_transfer(1.0, -0.1, f64::tanh).is_err());

    let own = || Influence::by_transfer(1.0, 0.0, f64::tanh).unwrap();
    let load = Load::force(1.0).unwrap();
    for punch in [Punch::circular(1.0).unwrap(), Punch::periodic(1.0, 3.0).unwrap()] {
        assert!(Problem::new(bare(1.0).with_influence(own()), punch, load).is_err());
    }
    let steel = Foundation::new(Elastic::new(2.0, 0.3).unwrap()).with_influence(own());
    let said = Problem::new(steel, Punch::new(1.0).unwrap(), load).unwrap_err().to_string();
    assert!(said.contains("roughness"), "{said}");
}

/// A remainder that bends within a small share of the base is resolved, by the solution and by the reference, or refused.
#[test]
fn narrow_features_are_seen() {
    let narrow = |width: f64| {
        let form =
            Influence::by_remainder(move |d| 0.05 * (-((d - 0.734_56) / width).powi(2)).exp());
        pressed(&bare(10.0).with_influence(form), "xi^2", Rotational::Moment(0.02))
    };
    let plain = pressed(&bare(10.0), "xi^2", Rotational::Moment(0.02)).solve().unwrap();
    for width in [0.1, 0.01] {
        let problem = narrow(width);
        let contact = problem.solve().unwrap();
        let check = problem.cross_check(&contact).unwrap();
        assert!(check.agrees, "{width}: {check:?}");
        assert!((contact.settlement() - plain.settlement()).abs() > 1e-3 * width);
    }
    for width in [0.001, 0.0005] {
        let said = narrow(width).solve().unwrap_err().to_string();
        assert!(said.contains("smooth"), "{width}: {said}");
    }
    let waves = Influence::by_remainder(|d| 0.1 * (150.0 * d).cos());
    let problem = pressed(&bare(10.0).with_influence(waves), "xi^2", Rotational::Moment(0.02));
    let check = problem.cross_check(&problem.solve().unwrap()).unwrap();
    assert!(check.agrees, "{check:?}");
    // The leading digits of a large constant are lost, not the answer.
    let raised = Influence::by_remainder(|_| 1e6);
    let raised = pressed(&bare(10.0).with_influence(raised), "xi^2", Rotational::Moment(0.02));
    assert!(raised.solve().is_ok());
}
