//! Studies in which a value is looked for in every case.

use shtaerman::document::{Field, FileError, TableReader};
use shtaerman::inverse::{self, Found, Goal};
use shtaerman::quantity::Dimension;
use shtaerman::{Error, Problem};

/// The value that is looked for in every case, and what it is to give.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Find {
    is_force: bool,
    goal: Goal,
}

impl Find {
    /// Reads `find.force = { peak_pressure = "350 MPa" }`.
    pub(crate) fn read(
        table: &TableReader<'_>,
        is_dimensionless: bool,
    ) -> Result<Option<Self>, FileError> {
        let Some(find) = table.table("find")? else { return Ok(None) };
        let unknown = find.exactly_one(&["force", "roughness"]).map_err(|error| {
            error.with_help(
                "write find.force = { peak_pressure = .. } or find.roughness = { settlement = .. }",
            )
        })?;
        let is_force = unknown.name().ends_with("force");
        if is_dimensionless && !is_force {
            return Err(unknown.error("a dimensionless problem has no roughness to be found: it is the scale of its displacements"));
        }
        let goals = unknown.table()?;
        let wanted = if is_force {
            goals.exactly_one(&["peak_pressure", "contact_width"])?
        } else {
            goals.exactly_one(&["peak_pressure", "contact_width", "settlement"])?
        };
        Ok(Some(Self { is_force, goal: goal(&wanted, is_dimensionless)? }))
    }

    /// The keys that say what is looked for, and so cannot vary.
    pub(crate) fn keys(self) -> &'static [&'static str] {
        if self.is_force {
            &["load.force", "load.settlement", "dimensionless.force", "dimensionless.settlement"]
        } else {
            &["foundation.roughness", "foundation.subgrade_modulus", "dimensionless.theta0"]
        }
    }

    /// The contact of a problem in which the value is what is wanted.
    pub(crate) fn run(self, problem: &Problem) -> Result<Found, Error> {
        if self.is_force {
            inverse::force(problem, self.goal)
        } else {
            inverse::roughness(problem, self.goal)
        }
    }
}

fn goal(wanted: &Field<'_>, is_dimensionless: bool) -> Result<Goal, FileError> {
    let named: fn(f64) -> Goal = match wanted.name().rsplit('.').next() {
        Some("peak_pressure") => Goal::PeakPressure,
        Some("contact_width") => Goal::ContactWidth,
        _ => Goal::Settlement,
    };
    let dimension = if is_dimensionless { Dimension::NONE } else { named(1.0).dimension() };
    let value = wanted.quantity(dimension)?;
    if value <= 0.0 && !matches!(named(1.0), Goal::Settlement(_)) {
        return Err(wanted.error("must be greater than zero"));
    }
    Ok(named(value))
}
