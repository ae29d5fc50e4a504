//! `[solver]`.

use std::time::Duration;

use crate::bodies::Bodies;
use crate::document::{Field, TableReader};
use crate::quantity::Dimension;
use crate::solver::{check_memory, most_degree};
use crate::{ContactKind, Error, MethodChoice, Solver};

const UNILATERAL_METHOD: &str = "is \"spectral\", which solves on the full base only: the zones of a unilateral contact are solved by collocation";
const BILATERAL_HELP: &str = "write contact = \"bilateral\" in [solver] to keep the full base in contact, where the pressure may pull; or leave this key out";

/// Without `[solver]` the defaults hold.
pub(super) fn read(reader: &TableReader<'_>) -> Result<Solver, Error> {
    let Some(table) = reader.table("solver")? else { return Ok(Solver::default()) };
    let contact = match table.optional("contact") {
        Some(field) if field.one_of(&["unilateral", "bilateral"])? == "bilateral" => {
            ContactKind::Bilateral
        }
        _ => ContactKind::Unilateral,
    };
    let method = match table.optional("method") {
        Some(field) => match field.one_of(&["auto", "spectral", "sinc"])? {
            "spectral" if contact == ContactKind::Unilateral => {
                return Err(field.error(UNILATERAL_METHOD).with_help(BILATERAL_HELP).into());
            }
            "spectral" => MethodChoice::Spectral,
            "sinc" => MethodChoice::Sinc,
            _ => MethodChoice::Auto,
        },
        None => MethodChoice::Auto,
    };
    let degree = match table.optional("n") {
        Some(field) if method == MethodChoice::Sinc => {
            let message =
                "belongs to method = \"spectral\"; collocation chooses its nodes by the error";
            return Err(field.error(message).into());
        }
        Some(field) if contact == ContactKind::Unilateral => {
            return Err(field
                .error("belongs to contact = \"bilateral\": the zones of a unilateral contact are solved by collocation, which chooses its nodes by the error")
                .with_help(BILATERAL_HELP)
                .into());
        }
        Some(field) => Some(degree_of(&field)?),
        None => None,
    };
    let tolerance = table.optional("tolerance").map(|field| field.tolerance()).transpose()?;
    let time_limit = match table.optional("time_limit") {
        Some(field) => Some(time_limit_of(&field)?),
        None => None,
    };
    Ok(Solver { contact, method, degree, tolerance, time_limit })
}

/// Refuses what asks for the degenerate kernel where that does not solve the problem.
pub(super) fn require_degenerate_kernel(
    reader: &TableReader<'_>,
    bodies: &Bodies,
) -> Result<(), Error> {
    let (Some(table), Some(found)) = (reader.table("solver")?, bodies.without_degenerate_kernel())
    else {
        return Ok(());
    };
    let method = table.optional("method");
    let spectral = method.filter(|field| field.string().is_ok_and(|name| name == "spectral"));
    let Some(field) = spectral.or_else(|| table.optional("n")) else { return Ok(()) };
    let message = format!(
        "asks for the degenerate kernel, which solves one plane punch on a linear layer and a half-plane: here {found}"
    );
    let help =
        "leave it out: the method follows from the problem, and the error is part of the answer";
    Err(field.error(message).with_help(help).into())
}

/// How long a search may take.
fn time_limit_of(field: &Field<'_>) -> Result<Duration, Error> {
    let seconds = field.quantity(Dimension::TIME)?;
    if seconds.is_nan() || seconds <= 0.0 {
        let message = format!("is {seconds} s: must be greater than 0, like \"10 s\"");
        return Err(field.error(message).into());
    }
    // Longer than a duration holds is no limit, and the shortest is that of its unit.
    let limit = Duration::try_from_secs_f64(seconds).unwrap_or(Duration::MAX);
    Ok(limit.max(Duration::from_nanos(1)))
}

/// A degree whose solve fits into memory.
fn degree_of(field: &Field<'_>) -> Result<usize, Error> {
    let degree = field.count(1..=usize::MAX >> 12)?;
    check_memory(degree).map_err(|error| match error {
        Error::Equation(fredholm::Error::TooLarge { needed, available, .. }) => {
            let fault = field.error(format!(
                "is {degree}: that needs {:.3} GB of memory, and {:.3} GB are free",
                needed as f64 / 1e9,
                available as f64 / 1e9
            ));
            let most = most_degree(available);
            Error::Beyond(fault.with_help(format!("n may be {most} at most here")))
        }
        other => other,
    })?;
    Ok(degree)
}
