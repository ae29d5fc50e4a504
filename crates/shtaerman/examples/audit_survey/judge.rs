//! What became of a problem: its answer, its audit, and the reference beside them.

use std::path::Path;
use std::time::Instant;

use shtaerman::equation::EquationFile;
use shtaerman::{Contact, CrossCheck, Error, ErrorKind, Errors, Problem};
use shtaerman_reference::{Break, Kernel, Layer, Rotational, Vertical};

use super::coarse;
use super::draw::Case;

/// How an attempt ended.
pub(crate) enum Outcome {
    /// The file states no problem: a force outside the base, heights beyond range.
    NoProblem(String),
    /// Refused for what `limits.md` names.
    Limit(String),
    /// Refused otherwise.
    Refused(String),
    Answered(Box<Answered>),
}

/// An answer held against others.
#[derive(Clone)]
pub(crate) struct Answered {
    /// Seconds of the solve and of the audit.
    pub(crate) times: [f64; 2],
    /// `bound`, `estimate` or `none`.
    pub(crate) audit: &'static str,
    /// The relative error stated, and what is aimed at.
    pub(crate) reached: [f64; 2],
    /// What was compared; none where the reference was not asked or refused.
    pub(crate) checked: Option<Checked>,
    /// Why the reference refused.
    pub(crate) unchecked: Option<String>,
    /// Stated over true errors of answers that are off on purpose: of pressures, and of the rest.
    pub(crate) coarse: [Vec<f64>; 2],
}

/// The answer and the reference.
#[derive(Clone)]
pub(crate) struct Checked {
    /// What both say, where they differ by more than they state together.
    pub(crate) violation: Option<String>,
    /// Bound over true error of what is off by more than `1e-11` of its size, where the reference knows it ten times better.
    pub(crate) ratios: Vec<f64>,
}

/// What an answer is held against.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Against {
    /// The method that shares no code.
    Reference,
    /// Its audit on halved panels.
    SecondAudit,
}

/// Solves a case, hands over its answer, and judges that; `folder` has its measured base.
pub(crate) fn judge(
    case: &Case,
    folder: &Path,
    against: Against,
    is_answered: impl FnOnce(Answered),
) -> Outcome {
    if case.is_equation {
        return judge_equation(case, against == Against::Reference, is_answered);
    }
    let problem = match shtaerman::file::from_bytes(case.toml.as_bytes(), "survey", folder, &[]) {
        Ok(problem) => problem,
        Err(error) => return Outcome::NoProblem(error.to_string()),
    };
    let start = Instant::now();
    let contact = match problem.solve() {
        Ok(contact) => contact,
        Err(error) => return refused(&error),
    };
    let solved = start.elapsed().as_secs_f64();
    let contact = match contact.audited() {
        Ok(contact) => contact,
        Err(error) => return refused(&error),
    };
    let times = [solved, start.elapsed().as_secs_f64() - solved];
    let audit = match contact.audited_by() {
        Some(Ok(audit)) => audit.kind.name(),
        Some(Err(_)) | None => "none",
    };
    let reached = [contact.relative_error(), aim(&problem)];
    let mut answered = Answered {
        times,
        audit,
        reached,
        checked: None,
        unchecked: None,
        coarse: Default::default(),
    };
    is_answered(answered.clone());
    (answered.checked, answered.unchecked) = match against {
        Against::Reference => held(&problem, &contact),
        Against::SecondAudit => (twice_audited(&contact), None),
    };
    let (ratios, violation) = coarse::ratios(case, folder, &contact);
    answered.coarse = ratios;
    if violation.is_some() {
        answered.checked = Some(Checked { violation, ratios: vec![] });
    }
    Outcome::Answered(Box::new(answered))
}

/// What is aimed at by default.
fn aim(problem: &Problem) -> f64 {
    let theta0 = problem.theta0();
    if problem.profile().measured_points().is_some() {
        1e-10 * (theta0 / 100.0).max(1.0)
    } else {
        1e-12 * (theta0 / 10.0).max(1.0)
    }
}

fn refused(error: &Error) -> Outcome {
    let text = error.to_string();
    // Loads that no pressure on the base balances, bases clear of the body, tilted disks that lift off: limits.md.
    let is_limit = matches!(
        error,
        Error::TipsOver { .. }
            | Error::NoContact
            | Error::SettlementOutOfReach { .. }
            | Error::LiftsOff { .. }
    );
    // A layer with a power law does not pull: a bilateral contact that would is none.
    let is_pulled = text.contains("known for compression only");
    if is_limit || is_pulled { Outcome::Limit(text) } else { Outcome::Refused(text) }
}

/// A second audit, on twice as many panels, is bound to find about the same: beyond this factor one of both is wrong.
const ALIKE: f64 = 100.0;

/// The answer beside its audit on halved panels, where it has a bound: for answers too large for the reference.
fn twice_audited(contact: &Contact) -> Option<Checked> {
    let Some(Ok(first)) = contact.audited_by() else { return None };
    if first.kind != ErrorKind::Bound {
        return None;
    }
    let violation = match contact.audit_on_halved_panels() {
        Ok(second) if second.pressure() <= ALIKE * first.pressure() => None,
        second => Some(format!("on halved panels: {second:?}; first {first:?}")),
    };
    Some(Checked { violation, ratios: Vec::new() })
}

/// The answer beside the reference, or beside a second audit where the reference is too large.
fn held(problem: &Problem, contact: &Contact) -> (Option<Checked>, Option<String>) {
    let check = match problem.cross_check(contact) {
        Ok(check) => check,
        Err(error) => match twice_audited(contact) {
            Some(checked) => return (Some(checked), None),
            None => return (None, Some(error.to_string())),
        },
    };
    let violation = (!check.agrees).then(|| {
        format!(
            "differences {check:?}; stated {:?}, edges {:?}, zones {:?}",
            contact.dimensionless().error(),
            contact.dimensionless().error().and_then(|error| error.zones),
            contact.dimensionless().zones()
        )
    });
    let ratios = contact
        .dimensionless()
        .error()
        .map_or_else(Vec::new, |stated| ratios(contact, stated, &check));
    (Some(Checked { violation, ratios }), None)
}

fn ratios(contact: &Contact, stated: Errors, check: &CrossCheck) -> Vec<f64> {
    let own = &check.reference_error;
    let displacement =
        contact.dimensionless().settlement().abs().max(contact.dimensionless().tilt().abs());
    let force = contact.dimensionless().force().abs().max(contact.dimensionless().moment().abs());
    let parts = [
        (
            stated.pressure,
            check.pressure,
            own.pressure,
            contact.dimensionless().peak_pressure().abs(),
        ),
        (stated.settlement, check.settlement, own.settlement, displacement),
        (stated.tilt, check.tilt, own.tilt, displacement),
        (stated.force, check.force, own.force, force),
        (stated.moment, check.moment, own.moment, force),
    ];
    (parts.into_iter())
        .filter(|(_, off, own, size)| {
            *off > 1e-11 * size && off > &(10.0 * own) && size.is_finite()
        })
        .map(|(stated, off, ..)| stated / off)
        .collect()
}

/// An equation beside bilateral contact under a base that is the right-hand side turned round, where the kernel is one of the reference's; else beside its other method.
fn judge_equation(case: &Case, is_checked: bool, is_answered: impl FnOnce(Answered)) -> Outcome {
    let file = match EquationFile::from_bytes(case.toml.as_bytes(), "survey", &[]) {
        Ok(file) => file,
        Err(error) => return Outcome::NoProblem(error.to_string()),
    };
    let start = Instant::now();
    let solved = match file.equation().solve() {
        Ok(solved) => solved,
        Err(error) => return Outcome::Refused(error.to_string()),
    };
    let times = [start.elapsed().as_secs_f64(), 0.0];
    let stated = *solved.error();
    let places = solved.places(102).unwrap_or_default();
    let value = |x: f64| solved.evaluate(x).ok().flatten().unwrap_or(f64::NAN);
    let size = places.iter().fold(0.0f64, |most, x| most.max(value(*x).abs()));
    let mut answered = Answered {
        times,
        audit: if solved.audit_report().is_some() { "estimate" } else { "none" },
        reached: [stated.solution / size, 1e-12],
        checked: None,
        unchecked: None,
        coarse: Default::default(),
    };
    is_answered(answered.clone());
    if !is_checked {
        return Outcome::Answered(Box::new(answered));
    }
    let Some((kernel, theta, pieces)) = same_kernel(&case.toml) else {
        match solved.cross_check() {
            Ok(check) => {
                let violation = (!check.agrees).then(|| format!("the other method: {check:?}"));
                answered.checked = Some(Checked { violation, ratios: vec![] });
            }
            Err(error) => answered.unchecked = Some(error.to_string()),
        }
        return Outcome::Answered(Box::new(answered));
    };
    let rhs = file.equation().right_hand_side();
    let base = |x: f64| -rhs.evaluate(&[x]);
    let breaks: Vec<Break> = (case.bends.iter())
        .filter(|(at, _)| pieces[0] < *at && *at < pieces[1])
        .map(|(at, is_sharp)| Break { at: *at, is_sharp: *is_sharp })
        .collect();
    let posed = shtaerman_reference::Problem {
        kernel,
        theta,
        layer: Layer::Linear,
        pieces: &[pieces],
        is_bilateral: true,
        vertical: Vertical::Settlement(0.0),
        rotational: Rotational::Tilt(0.0),
        base: &base,
        breaks: &breaks,
    };
    match posed.solve(None) {
        Ok(truth) => {
            let (mut worst, mut violation, mut uncertain) = (0.0f64, None, 0.0f64);
            for x in &places {
                if breaks.iter().any(|cut| cut.is_sharp && (cut.at - x).abs() < 1e-13) {
                    continue;
                }
                let [p, own] = truth.pressure(*x);
                let off = (p - value(*x)).abs();
                worst = worst.max(off);
                uncertain = uncertain.max(own);
                // What is not a number is within nothing.
                let is_within = off <= stated.solution + own;
                if !is_within {
                    violation = Some(format!(
                        "phi({x}) off by {off:e}, stated {:e}, reference {own:e}",
                        stated.solution
                    ));
                }
            }
            let is_known = worst > 1e-11 * size && worst > 10.0 * uncertain;
            let ratios = if is_known { vec![stated.solution / worst] } else { vec![] };
            answered.checked = Some(Checked { violation, ratios });
        }
        Err(reason) => answered.unchecked = Some(reason.to_string()),
    }
    Outcome::Answered(Box::new(answered))
}

/// The kernel of an equation's file in the words of the reference, its `theta` and the interval.
fn same_kernel(toml: &str) -> Option<(Kernel<'static>, f64, [f64; 2])> {
    let find = |key: &str| -> Option<&str> {
        toml.lines().find_map(|line| line.strip_prefix(key)?.strip_prefix(" = "))
    };
    let number = |key: &str| find(key)?.parse::<f64>().ok();
    let lambda = number("lambda")?;
    match find("name")?.trim_matches('"') {
        "log" => Some((Kernel::Logarithm, lambda, [-1.0, 1.0])),
        "log-sine" => {
            let alpha = number("alpha")?;
            let period = std::f64::consts::TAU;
            Some((Kernel::Row { period }, lambda, [-alpha, alpha]))
        }
        "power" => Some((Kernel::Power { exponent: number("mu")? }, lambda, [-1.0, 1.0])),
        "weber-sonine" => {
            let (harmonic, exponent) = (number("mu")? as u8, 2.0 * number("gamma")?);
            // The reference's first harmonic has no base: it is for tilts.
            let kernel = Kernel::Disk { exponent, harmonic };
            (harmonic == 0).then_some((kernel, lambda / std::f64::consts::PI, [0.0, 1.0]))
        }
        _ => None,
    }
}
