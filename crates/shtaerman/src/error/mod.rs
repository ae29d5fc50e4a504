//! What can go wrong with a problem.

mod inverse;
mod numerical;
mod requirement;
mod roughness;
mod words;

pub use inverse::InverseError;
pub(crate) use requirement::{finite, positive, require};

use std::time::Duration;

use crate::document::FileError;
use crate::expression::Defect;
use crate::quantity::plain;
use roughness::or_roughness;
use words::{attempt, lifts_off, relative, unsolved};

/// Why a problem has no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A quantity lies outside the range where the model holds.
    #[error("{field} = {}: must be {requirement}", plain(*value))]
    InvalidValue {
        /// Name of the quantity, as in the problem file.
        field: &'static str,
        /// The value given, SI.
        value: f64,
        /// What would be right.
        requirement: &'static str,
    },

    /// A quantity that a dimensionless problem has not.
    #[error(
        "{field}: must be left out of a dimensionless problem, whose theta0 stands for all of its material"
    )]
    NotDimensionless {
        /// Name of the quantity, as in the problem file.
        field: &'static str,
    },

    /// The profile is not finite somewhere on the punch.
    #[error("the profile {defect} at {variable} = {at}: it must be finite on the whole punch")]
    ProfileNotFinite {
        /// `x` (metres) or `xi`.
        variable: &'static str,
        /// Where.
        at: f64,
        /// How it fails to be finite.
        defect: Defect,
    },

    /// A point for evaluation lies beyond the punch.
    #[error(
        "{variable} = {at} is beyond the punch: pressure is known for {variable} from {left} to {right}"
    )]
    BeyondPunch {
        /// `x` (metres) or `xi`.
        variable: &'static str,
        /// Where.
        at: f64,
        /// Left edge.
        left: f64,
        /// Right edge.
        right: f64,
    },

    /// An answer leaves the range of double precision.
    #[error(
        "the {quantity} comes out as {}: load, profile and moduli together leave the range of double precision", plain(*value)
    )]
    Overflow {
        /// Which part of the answer.
        quantity: &'static str,
        /// What it came out as.
        value: f64,
    },

    /// An explicit tolerance, or one hundredth where none is given, was not met.
    #[error(
        "the tolerance {tolerance:e} was not met: the {method} method with n = {n} reached a relative error of {reached:.1e} \
         (delta0 = {settlement0}, alpha0 = {tilt0}); double precision allows about 1e-12 to 1e-14, and less at large theta0"
    )]
    ToleranceNotMet {
        /// What was asked for.
        tolerance: f64,
        /// The best relative error reached.
        reached: f64,
        /// Method that reached it.
        method: &'static str,
        /// Its size.
        n: usize,
        /// Its `delta0`.
        settlement0: f64,
        /// Its `alpha0`.
        tilt0: f64,
    },

    /// The search for an answer did not end in the time allowed.
    #[error(
        "no answer was found within the time limit of {} s: allow more by `time_limit` (--time-limit), or resolve what the profile shows by fewer kinks, steps or measured points",
        limit.as_secs_f64()
    )]
    TimeLimit {
        /// What was allowed.
        limit: Duration,
    },

    /// The search for an answer took more work than one may that has no limit of time.
    #[error(
        "no answer was found with the work that a search does by itself, a few seconds of it: a `time_limit` (--time-limit) of your own in its place, such as \"1 min\", allows more; or resolve what the profile shows by fewer kinks, steps or measured points{}", or_roughness(*roughness)
    )]
    WorkLimit {
        /// A roughness in place of 0 that may serve.
        roughness: Option<f64>,
    },

    /// The audit found the answer wrong.
    #[error("no answer was found that stands the audit: {reason}")]
    AuditFailed {
        /// What is wrong with it.
        reason: String,
    },

    /// The force of a unilateral contact acts beyond the base.
    #[error(
        "{field} = {}: tips the punch over: its magnitude must be less than {name} = {}, or no pressure on the base balances it", plain(*value), plain(*limit)
    )]
    TipsOver {
        /// `moment` or `eccentricity`.
        field: &'static str,
        /// The value given, SI.
        value: f64,
        /// What its magnitude must stay below.
        limit: f64,
        /// The limit as a formula.
        name: &'static str,
    },

    /// No force at the prescribed eccentricity leads to the settlement prescribed.
    #[error(
        "settlement = {}: is out of reach of a force at the eccentricity {}: whatever the force, the middle of the punch settles no {bound} \
         than about {}, as the punch turns; prescribe the force, the tilt or the moment instead, or a smaller eccentricity", plain(*value), plain(*eccentricity), plain(words::about(*limit))
    )]
    SettlementOutOfReach {
        /// The settlement given, SI.
        value: f64,
        /// The eccentricity given, SI.
        eccentricity: f64,
        /// The settlement found that comes closest, to three digits, SI.
        limit: f64,
        /// On which side of it no settlement is in reach: `deeper` or `less deep`.
        bound: &'static str,
    },

    /// The prescribed displacements of a unilateral contact leave the base clear of the body.
    #[error(
        "the punch touches nowhere: under the prescribed settlement and tilt no point of the base lies below the surface; \
         the settlement must be larger than the lowest height of the base"
    )]
    NoContact,

    /// A circular punch lifts off on one side.
    #[error("{}", lifts_off(field, *value, *limit))]
    LiftsOff {
        /// `moment`, `eccentricity` or `tilt`.
        field: &'static str,
        /// The value given, SI.
        value: f64,
        /// The largest magnitude with full contact, SI; 0 where the base does not touch as a whole without a moment.
        limit: f64,
    },

    /// The contact of a smooth circular punch is no single disk, and there is a moment or a tilt, or the ground is graded.
    #[error(
        "the contact is no single disk: {found} at {variable} = {at}; on a smooth surface a circular punch with a moment or a tilt, or on graded ground, is solved for one disk \
         of contact only, rings without them: leave out moment and tilt, or keep the full base in contact with contact = \"bilateral\"{}", or_roughness(*roughness)
    )]
    Rings {
        /// `x` (metres) or `xi`, the distance from the axis.
        variable: &'static str,
        /// Where.
        at: f64,
        /// What says so: `tension`, `penetration`, ..
        found: &'static str,
        /// A roughness in place of 0 that may serve.
        roughness: Option<f64>,
    },

    /// A layer with a power law would pull.
    #[error(
        "the pressure would pull at {variable} = {at}, and the power law of the layer is known for compression only: \
         let the punch lift off (contact = \"unilateral\"), or press harder"
    )]
    Pulls {
        /// `x` (metres) or `xi`.
        variable: &'static str,
        /// Where.
        at: f64,
    },

    /// No zones of contact were found on which pressure and gap have their signs.
    #[error("the zones of contact were not found: {}", attempt(*tension, *penetration))]
    NotComplementary {
        /// Largest tension over the largest pressure; NaN where no attempt came to an end.
        tension: f64,
        /// Largest penetration over the size of the displacements; NaN likewise.
        penetration: f64,
    },

    /// More zones of contact than are solved together.
    #[error(
        "the contact has about {zones} zones, and at most {most} are solved together: a layer (roughness > 0) on homogeneous ground, or on graded ground under a plane punch, allows thousands"
    )]
    TooManyZones {
        /// Zones that cells show.
        zones: usize,
        /// Most that are solved.
        most: usize,
    },

    /// More smooth parts of a profile than are solved together.
    #[error(
        "the profile falls into {parts} parts between its kinks, steps and narrow features, and at most {most} are solved together: a linear layer (roughness > 0) under one plane punch, or two, \
         on homogeneous ground allows hundreds"
    )]
    TooManyParts {
        /// Parts of the base.
        parts: usize,
        /// Most that are solved.
        most: usize,
    },

    /// A wave in full contact with features narrower than its nodes show.
    #[error(
        "the profile has a part {width:.1e} of the half-width wide, and where a wave keeps in contact over its whole period parts of {least:.1e} and more are resolved: leave narrow features out"
    )]
    TooNarrow {
        /// Width of the part, `xi`.
        width: f64,
        /// Width that is resolved.
        least: f64,
    },

    /// An answer with an error that nobody asked for.
    #[error(
        "the {method} method with n = {n} reached {}, and answers beyond {most:e} are none unless that is asked for: \
         allow more by `tolerance`, or resolve what the profile shows by fewer kinks, steps or measured points{}", relative(*reached), or_roughness(*roughness)
    )]
    NotAccurate {
        /// The relative error reached.
        reached: f64,
        /// The largest that needs no permission.
        most: f64,
        /// Method that reached it.
        method: &'static str,
        /// Its size.
        n: usize,
        /// A roughness in place of 0 that may serve.
        roughness: Option<f64>,
    },

    /// An answer whose audit bounds its error by more than anybody asked for.
    #[error(
        "the audit knows no more than {}, and answers beyond {most:e} are none unless that is asked for; the {method} method with n = {n} itself states {}: \
         do without the audit (`--no-audit`, `audit=False`), or allow more by `tolerance`", relative(*reached), relative(*stated)
    )]
    NotBounded {
        /// The relative error that the audit bounds or estimates.
        reached: f64,
        /// The largest that needs no permission.
        most: f64,
        /// The relative error that the method states.
        stated: f64,
        /// The method.
        method: &'static str,
        /// Its size.
        n: usize,
    },

    /// A bend of the profile under a smooth surface that nothing tells the power of.
    #[error(
        "no error of the pressure can be stated: on other nodes there is no such contact (by the force instead of the settlement there may be), or the profile bends somewhere as several powers of the distance that nearly cancel there, or so near to an end of the contact, or on graded ground to its middle, \
         that nothing shows its power; one power at a place, a rounded bend such as sqrt(x^2 + r^2) for abs(x), or a small roughness instead of 0 leaves an answer"
    )]
    UnclearBend,

    /// Zones of a smooth contact, or of neighbouring punches, that come too close for the modes that can be kept.
    #[error(
        "the zones of contact (in a row those of neighbouring punches, too) come within {gap:.1e} of the half-width: on a smooth surface that is too close to be resolved; \
         without the gap they are one zone{}", or_roughness(*roughness)
    )]
    ZonesTooClose {
        /// The narrowest gap, `xi`.
        gap: f64,
        /// A roughness in place of 0 that keeps such gaps in reach.
        roughness: Option<f64>,
    },

    /// Stresses below the surface of a body whose stress field is not known.
    #[error("stresses below the surface are known for the plane, homogeneous half-space only")]
    NoStresses,

    /// Stresses out of the plane need Poisson's ratio.
    #[error(
        "Poisson's ratio is missing: a dimensionless problem has none, and the stress out of the plane needs it"
    )]
    NoPoissonRatio,

    /// No load has the yield stress as its largest equivalent stress.
    #[error(
        "no load brings the largest equivalent stress to the yield stress {}: the nearest is about {}; a corner with infinite pressure yields at once, \
         a profile that is forced into contact may yield without any force", plain(*yield_stress), plain(words::about(*nearest))
    )]
    NoYield {
        /// The yield stress.
        yield_stress: f64,
        /// The nearest largest stress.
        nearest: f64,
    },

    /// The right-hand side of an equation is not finite somewhere on the interval.
    #[error("the right-hand side {defect} at x = {at}: it must be finite on the whole interval")]
    RightHandSide {
        /// Where.
        at: f64,
        /// How it fails to be finite.
        defect: Defect,
    },

    /// A point for evaluation lies beyond the interval of an equation.
    #[error("x = {at} is beyond the interval, which reaches from {left} to {right}")]
    BeyondInterval {
        /// Where.
        at: f64,
        /// Left end.
        left: f64,
        /// Right end, perhaps infinite.
        right: f64,
    },

    /// The solution of an equation leaves the range of double precision.
    #[error(
        "the {quantity} comes out as {}: kernel, lambda and right-hand side together leave the range of double precision", plain(*value)
    )]
    EquationOverflow {
        /// Which part of the answer.
        quantity: &'static str,
        /// What it came out as.
        value: f64,
    },

    /// An explicit tolerance of an equation was not met.
    #[error(
        "the tolerance {tolerance:e} was not met: the {method} method with n = {n} reached a relative error of {reached:.1e}; \
         double precision allows about 1e-12 to 1e-14, and less near a singular lambda"
    )]
    EquationTolerance {
        /// What was asked for.
        tolerance: f64,
        /// The relative error reached.
        reached: f64,
        /// Method that reached it.
        method: &'static str,
        /// Its size.
        n: usize,
    },

    /// The method failed: the error of the solution is no longer small beside the solution.
    #[error(
        "{}: the {method} method with n = {n} states a relative error of {reached:.1e}; \
         the right-hand side is too rough, grows too fast, or is none that the first kind can have; \
         with method = \"spectral\" an n of one's own is solved whatever its error, and a tolerance says which error would do", unsolved(*reached)
    )]
    EquationUnsolved {
        /// The relative error.
        reached: f64,
        /// Method that reached it.
        method: &'static str,
        /// Its size.
        n: usize,
    },

    /// The same of an equation on a kernel of one's own.
    #[error(
        "{}: collocation with n = {n} states a relative error of {reached:.1e}; the kernel has too narrow a peak, a kink or a jump beside x = s, the right-hand side is too rough, \
         or -1/lambda is nearly an eigenvalue; a tolerance says which error would do", unsolved(*reached)
    )]
    OwnEquationUnsolved {
        /// The relative error.
        reached: f64,
        /// Number of nodes.
        n: usize,
    },

    /// The other method of a cross-check failed, so that any difference would be allowed.
    #[error(
        "nothing to compare with: the {method} method with n = {n}, which is to check the answer, states a relative error of {reached:.1e} itself; \
         method = \"spectral\" with a larger n is checked by collocation"
    )]
    CheckUnsolved {
        /// The relative error.
        reached: f64,
        /// Method that reached it.
        method: &'static str,
        /// Its size.
        n: usize,
    },

    /// The solution of an equation of the first kind is infinite at a place inside.
    #[error(
        "no digit of the solution is certain: it is infinite at x = {at}, where the right-hand side has {what}, as small as that may be; one that is smooth there has a solution, \
         the second kind takes any, and with method = \"spectral\" an n of one's own is solved for its integral"
    )]
    InfiniteSolution {
        /// The place.
        at: f64,
        /// What the right-hand side has there.
        what: &'static str,
    },

    /// A right-hand side of the first kind on a disk comes to a point at the centre.
    #[error(
        "the right-hand side is a cone at the centre, its slope at x = 0 is {slope}: the solution of the first kind is infinite there, which no sum of eigenfunctions is; \
         one that is smooth on the disk depends on x^2 there, and the second kind takes any"
    )]
    Cone {
        /// Its slope at the centre.
        slope: f64,
    },

    /// A second method was asked for where there is one only.
    #[error(
        "the first kind has one method, the spectral relation of its kernel: `shtaerman spectrum KERNEL --verify` checks that by independent quadrature"
    )]
    NoOtherMethod,

    /// The reference that is to check an answer was not found.
    #[error(
        "nothing to compare with: the reference, product integration on graded panels, does not solve this contact: {reason}; the line `audit` of the answer says whether that checks it"
    )]
    NoReference {
        /// Why.
        reason: shtaerman_reference::Refusal,
    },

    /// The degenerate kernel is not what solves the problem, so that there is no convergence to study.
    #[error(
        "the study of convergence is one of the degenerate kernel, which solves one plane punch on a linear layer with its full base in contact: here {found}; {remedy}"
    )]
    NoDegenerateKernel {
        /// What the problem has instead.
        found: &'static str,
        /// What would be right.
        remedy: &'static str,
    },

    /// The problem has no table for a finite-element program.
    #[error("no table: {reason}")]
    NoTable {
        /// Why, and what would be right.
        reason: &'static str,
    },

    /// An inverse problem has no answer.
    #[error(transparent)]
    Inverse(#[from] InverseError),

    /// The problem file cannot be read as a problem.
    #[error(transparent)]
    File(#[from] FileError),

    /// What the problem file asks for takes more than this machine or a method has: the file is sound.
    #[error(transparent)]
    Beyond(FileError),

    /// The integral equation could not be solved.
    #[error(transparent)]
    Equation(fredholm::Error),
}

impl From<fredholm::Error> for Error {
    fn from(error: fredholm::Error) -> Self {
        Self::Equation(error)
    }
}
