//! The arguments of `shtaerman find`.

use clap::{Args, Subcommand, ValueEnum};

use super::common::{OutputArguments, ProblemArguments, ReportArguments};
use super::units::{SenseArguments, UnitArguments};

/// `shtaerman find`.
#[derive(Debug, Args)]
pub struct FindArguments {
    /// What to find.
    #[command(subcommand)]
    pub unknown: Unknown,
}

/// What `shtaerman find` finds.
#[derive(Debug, Subcommand)]
pub enum Unknown {
    /// The force for a peak pressure or a contact width, keeping the eccentricity M/P or the tilt.
    Force(FindForceArguments),
    /// The roughness behind a measured settlement, contact width or peak pressure.
    Roughness(FindRoughnessArguments),
    /// The crown radius R, base x^2/(2R), that keeps the peak pressure under a limit, and the one of the lowest peak.
    Crown(FindCrownArguments),
    /// The profile that gives a prescribed pressure, as CSV.
    Profile(FindProfileArguments),
}

/// `shtaerman find force`.
#[derive(Debug, Args)]
#[command(group(clap::ArgGroup::new("goal").required(true).args(["peak_pressure", "contact_width"])))]
pub struct FindForceArguments {
    #[command(flatten)]
    /// The problem; its force is where the search begins.
    pub problem: ProblemArguments,
    /// The largest pressure wanted, such as "350 MPa"; p/E for a dimensionless file.
    #[arg(long, value_name = "PRESSURE", allow_hyphen_values = true)]
    pub peak_pressure: Option<String>,
    /// The width of contact wanted, such as "2 mm"; in half-widths for a dimensionless file.
    #[arg(long, value_name = "WIDTH", allow_hyphen_values = true)]
    pub contact_width: Option<String>,
    /// Leave out the audit: errors are then those that the method states of itself.
    #[arg(long)]
    pub no_audit: bool,
    #[command(flatten)]
    /// The result.
    pub output: OutputArguments,
    #[command(flatten)]
    /// The units of the result.
    pub units: UnitArguments,
    #[command(flatten)]
    /// What becomes of doubts.
    pub sense: SenseArguments,
    #[command(flatten)]
    /// The report.
    pub report: ReportArguments,
}

/// `shtaerman find roughness`.
#[derive(Debug, Args)]
#[command(group(clap::ArgGroup::new("goal").required(true).args(["settlement", "contact_width", "peak_pressure"])))]
pub struct FindRoughnessArguments {
    #[command(flatten)]
    /// The problem; its roughness is where the search begins.
    pub problem: ProblemArguments,
    /// The settlement measured under the load, such as "3.1 um", in the gauge ln(a/|x-s|).
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub settlement: Option<String>,
    /// The width of contact measured under the load, such as "2 mm".
    #[arg(long, value_name = "WIDTH", allow_hyphen_values = true)]
    pub contact_width: Option<String>,
    /// The largest pressure measured under the load, such as "350 MPa".
    #[arg(long, value_name = "PRESSURE", allow_hyphen_values = true)]
    pub peak_pressure: Option<String>,
    /// Leave out the audit: errors are then those that the method states of itself.
    #[arg(long)]
    pub no_audit: bool,
    #[command(flatten)]
    /// The result.
    pub output: OutputArguments,
    #[command(flatten)]
    /// The units of the result.
    pub units: UnitArguments,
    #[command(flatten)]
    /// What becomes of doubts.
    pub sense: SenseArguments,
    #[command(flatten)]
    /// The report.
    pub report: ReportArguments,
}

/// `shtaerman find crown`.
#[derive(Debug, Args)]
pub struct FindCrownArguments {
    #[command(flatten)]
    /// The problem; the crown takes the place of its profile.
    pub problem: ProblemArguments,
    /// The limit of the peak pressure, such as "350 MPa"; without it the radius of the lowest peak alone.
    #[arg(long, value_name = "PRESSURE", allow_hyphen_values = true)]
    pub peak_pressure: Option<String>,
    /// Leave out the audit: errors are then those that the method states of itself.
    #[arg(long)]
    pub no_audit: bool,
    #[command(flatten)]
    /// The result.
    pub output: OutputArguments,
    #[command(flatten)]
    /// The units of the result.
    pub units: UnitArguments,
    #[command(flatten)]
    /// What becomes of doubts.
    pub sense: SenseArguments,
    #[command(flatten)]
    /// The report.
    pub report: ReportArguments,
}

/// Where the profile of `shtaerman find profile` is zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Zero {
    /// In the middle.
    Centre,
    /// At its lowest point.
    Lowest,
}

/// `shtaerman find profile`.
#[derive(Debug, Args)]
pub struct FindProfileArguments {
    #[command(flatten)]
    /// The problem; the profile found takes the place of its own.
    pub problem: ProblemArguments,
    /// The pressure wanted, an expression in x, xi and a, scaled to the force: "1" is a uniform one.
    #[arg(long, value_name = "EXPRESSION", allow_hyphen_values = true)]
    pub pressure: String,
    /// Where the profile is zero.
    #[arg(long, value_enum, default_value = "centre", value_name = "PLACE")]
    pub zero: Zero,
    /// Number of points of the trace, from edge to edge and denser at the edges.
    #[arg(long, value_name = "COUNT", default_value_t = 1001)]
    pub points: usize,
    #[command(flatten)]
    /// The result; CSV is the trace, as `profile = { csv = ".." }` reads it.
    pub output: OutputArguments,
    #[command(flatten)]
    /// The units of the result.
    pub units: UnitArguments,
    #[command(flatten)]
    /// The report.
    pub report: ReportArguments,
}
