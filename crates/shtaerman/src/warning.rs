//! What a user should know about what was read, and about an answer.

use std::fmt;

use serde::Serialize;

use crate::material;
use crate::quantity::plain;

/// Kind of a warning, stable across releases.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum WarningCode {
    /// The bilateral answer pulls somewhere: the pressure is negative.
    NegativePressure,
    /// The profile could not be resolved to rounding (a kink, a jump, fast oscillation).
    ProfileNotResolved,
    /// The degree is too low for this roughness: the answer has few digits.
    LowDegree,
    /// The error that is aimed at was not reached.
    ToleranceNotMet,
    /// The time limit ended the search: zones and pressure are not final.
    TimeLimit,
    /// Smooth surface: the pressure is infinite at a corner.
    SingularEdge,
    /// Smooth surface: the pressure is infinite under a kink of the base.
    SingularKink,
    /// Circular punch: the base is not proved to be even.
    EvennessNotProved,
    /// The kernel of an equation is not square-summable.
    NotSquareSummable,
    /// The integral of the solution of an equation does not exist.
    NoIntegral,
    /// Of the right-hand side of an equation nothing was proved somewhere.
    NotProved,
    /// The base is steep where it touches; the model assumes small slopes.
    SteepBase,
    /// The tilt is no small angle.
    LargeTilt,
    /// The largest pressure is above what any solid bears elastically.
    HighPressure,
    /// The settlement is more than the half-width.
    LargeDisplacement,
    /// A modulus without a unit is taken in Pa and softer than rubber.
    SoftModulus,
    /// A yield stress without a unit is taken in Pa and below that of anything that is machined.
    LowYieldStress,
    /// The largest pressure is above the yield stress.
    AboveYield,
    /// The base is wider than machines have; millimetres may be meant.
    WideBase,
    /// A trace has no unit that is known where it needs one: its header has something in its place, or hardly a row lies over the base.
    UnknownUnit,
    /// The yield stress of a file is reached by no load.
    NoYield,
}

impl fmt::Display for WarningCode {
    /// The name that JSON has for it, such as `high_pressure`.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.serialize(formatter)
    }
}

/// A warning with its text.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Warning {
    /// Kind.
    pub code: WarningCode,
    /// One sentence for people, with figures.
    pub message: String,
}

impl Warning {
    /// A modulus that was written without a unit (Pa), by its key or option; none where a solid may have it.
    #[must_use]
    pub fn soft_modulus(key: &str, modulus: f64) -> Option<Self> {
        let unit = if modulus < material::STIFFEST { "GPa" } else { "MPa" };
        let shown = plain(modulus);
        let message = format!(
            "{key} = {shown} has no unit and is taken in Pa, which is softer than rubber: is \"{shown} {unit}\" meant?"
        );
        (modulus < material::SOFTEST).then_some(Self { code: WarningCode::SoftModulus, message })
    }

    /// A yield stress that was written without a unit (Pa), by its key or option; none where a metal may have it.
    #[must_use]
    pub fn low_yield_stress(key: &str, stress: f64) -> Option<Self> {
        let unit = if stress < material::HARDEST { "MPa" } else { "kPa" };
        let shown = plain(stress);
        let message = format!(
            "{key} = {shown} has no unit and is taken in Pa, which no metal is as soft as: is \"{shown} {unit}\" meant?"
        );
        (stress < material::SOFTEST).then_some(Self { code: WarningCode::LowYieldStress, message })
    }

    /// A largest pressure that is wanted and was written without a unit (Pa), by its key or option; none for one as high as a yield stress may be.
    #[must_use]
    pub fn low_peak_pressure(key: &str, pressure: f64) -> Option<Self> {
        let shown = plain(pressure);
        let message = format!(
            "{key} = {shown} has no unit and is taken in Pa, far below what metals bear: is \"{shown} MPa\" meant?"
        );
        (pressure < material::SOFTEST).then_some(Self { code: WarningCode::UnknownUnit, message })
    }

    /// What stands in place of the unit of the positions or heights of a trace, read in metres, and the key or option that states one.
    #[must_use]
    pub fn unknown_unit(name: &str, written: &str, stated: &str) -> Self {
        let message = format!(
            "the header has `{written}` for the unit of the {name}, which is none that is known, and they are read in metres: state it, by {stated}"
        );
        Self { code: WarningCode::UnknownUnit, message }
    }

    /// A trace without any unit of its positions, with hardly a row over the base, and the key or option that states the unit; none for more rows.
    #[must_use]
    pub fn few_rows(count: usize, stated: &str) -> Option<Self> {
        let rows = match count {
            0 => "no row",
            1 => "one row",
            _ => return None,
        };
        let message = format!(
            "the trace has {rows} over the base, and no unit: its positions are read in metres, and other units may be meant: state it, by {stated}"
        );
        Some(Self { code: WarningCode::UnknownUnit, message })
    }

    /// Heights of a trace whose positions have a stated unit and whose heights have none anywhere, and the key or option that states it.
    #[must_use]
    pub fn heights_in_metres(stated: &str) -> Self {
        let message = format!(
            "the trace has a unit for its positions and none for its heights, which are read in metres: state it, by {stated}"
        );
        Self { code: WarningCode::UnknownUnit, message }
    }

    /// The relative error aimed at, and the one reached.
    pub(crate) fn tolerance_not_met(tolerance: f64, reached: f64) -> Self {
        let message = format!(
            "the relative error reached is {reached:.1e}, more than the {tolerance:.0e} aimed at"
        );
        Self { code: WarningCode::ToleranceNotMet, message }
    }
}
