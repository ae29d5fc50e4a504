//! Audits on layers, coatings and influence functions against product integration, which has the kernel by another quadrature and shares no code with the audit.

use shtaerman::{
    Contact, Elastic, Error, ErrorKind, Foundation, Influence, LayerBase, Layering, Load, Problem,
    Profile, Punch, Rotational, Vertical,
};

/// Seed of the survey, on which nothing was tuned.
const SEED: u64 = 77_031_921;

fn layer(theta0: f64, thickness: f64, base: LayerBase) -> Foundation {
    let layering = Layering::layer(thickness, base).unwrap();
    Foundation::dimensionless(theta0).unwrap().with_layering(layering)
}

fn coating(chi: f64, thickness: f64, ratio: f64) -> Foundation {
    let [upper, lower] = [ratio, 1.0].map(|modulus| Elastic::new(modulus, 0.3).unwrap());
    let layering = Layering::coating(thickness, upper, lower).unwrap();
    Foundation::new(lower).with_roughness(chi).unwrap().with_layering(layering)
}

fn problem(foundation: Foundation, profile: &str, load: (Vertical, Rotational)) -> Problem {
    let punch = Punch::new(1.0).unwrap().with_profile(Profile::expression(profile).unwrap());
    Problem::new(foundation, punch, Load::new(load.0, load.1).unwrap()).unwrap()
}

/// The largest share of what the audit and the reference state that their difference is, and the audit's relative error.
fn judged(contact: Contact, name: &str) -> [f64; 2] {
    let started = std::time::Instant::now();
    let contact = contact.audited().unwrap();
    let taken = started.elapsed();
    let audit = contact.audited_by().unwrap().as_ref().unwrap().clone();
    let stated = contact.dimensionless().error().unwrap();
    assert_eq!((audit.kind, stated.kind), (ErrorKind::Estimate, ErrorKind::Estimate));
    let check = contact.problem().cross_check(&contact).unwrap();
    let other = check.reference_error;
    let share = [
        (check.pressure, stated.pressure, other.pressure),
        (check.settlement, stated.settlement, other.settlement),
        (check.tilt, stated.tilt, other.tilt),
        (check.force, stated.force, other.force),
        (check.moment, stated.moment, other.moment),
    ]
    .into_iter()
    .map(|(off, own, other)| off.abs() / (own + other + 1e-15))
    .fold(0.0, f64::max);
    println!("{name}: share {share:.2e}, {check:?}\n  {stated:?}, {taken:?}");
    [share, stated.pressure / contact.dimensionless().peak_pressure()]
}

#[test]
fn stated_errors_hold_against_product_integration() {
    let mut state = SEED;
    let mut random = move || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    for case in 0..8 {
        let thickness = 10f64.powf(-1.0 + 2.0 * random());
        let theta = 10f64.powf(2.0 * random() - 0.5);
        let foundation = match case % 4 {
            0 => layer(theta, thickness, LayerBase::Frictionless),
            1 => layer(theta, thickness, LayerBase::Bonded { poisson_ratio: 0.5 * random() }),
            2 => coating(1.0 / theta, thickness, 10f64.powf(2.0 * random() - 1.0)),
            _ => {
                let own = Influence::by_transfer(thickness, 0.0, |u| u / (u + (-2.0 * u).exp()));
                Foundation::dimensionless(theta).unwrap().with_influence(own.unwrap())
            }
        };
        let bend = 0.3 + 3.0 * random();
        let text = format!("{bend}*x^2 + {}*sin(4*x)", 0.1 * random());
        let load = (Vertical::Force(0.2 + random()), Rotational::Moment(0.05 * random()));
        let Ok(contact) = problem(foundation, &text, load).solve() else {
            println!("{case}: refused");
            continue;
        };
        let [share, error] =
            judged(contact, &format!("{case}, h {thickness:.3}, theta {theta:.3}"));
        assert!(share <= 1.0, "{case}: {share}");
        assert!(error < 1e-6, "{case}: idle, {error:e}");
    }
}

/// A thick layer moves the settlement alone: the audit states what the half-plane's does, but for what it knows less of the kernel.
#[test]
fn thick_layers_are_audited_as_half_planes() {
    let load = (Vertical::Force(0.9), Rotational::Moment(0.1));
    let thick = layer(3.0, 3000.0, LayerBase::Frictionless);
    let stated = [Foundation::dimensionless(3.0).unwrap(), thick].map(|foundation| {
        let contact = problem(foundation, "x^2", load).solve().unwrap();
        contact.audit().unwrap()
    });
    println!("{stated:?}");
    assert!(stated[1].residual < 100.0 * stated[0].residual + 1e-12);
    assert!(stated[1].pressure() < 100.0 * stated[0].pressure() + 1e-11);
}

#[test]
fn a_stiff_coating_at_a_settlement_has_no_audit() {
    let load = (Vertical::Settlement(1.0), Rotational::Tilt(0.0));
    let contact = problem(coating(0.5, 0.2, 5.0), "x^2", load).solve().unwrap();
    let reason = contact.audit().unwrap_err().to_string();
    assert!(reason.contains("stiffer"), "{reason}");
    let soft = problem(coating(0.5, 0.2, 0.2), "x^2", load).solve();
    let [share, _] = judged(soft.unwrap(), "soft coating at a settlement");
    assert!(share <= 1.0, "{share}");
}

/// A remainder is not known to be positive.
#[test]
fn remainders_have_no_audit() -> Result<(), Error> {
    let own = Influence::by_remainder(|d| 0.1 / (1.0 + d * d));
    let foundation = Foundation::dimensionless(2.0)?.with_influence(own);
    let load = (Vertical::Force(0.5), Rotational::Tilt(0.0));
    let reason = problem(foundation, "x^2", load).solve()?.audit().unwrap_err().to_string();
    assert!(reason.contains("positive"), "{reason}");
    Ok(())
}
