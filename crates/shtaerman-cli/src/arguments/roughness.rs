//! The arguments of `shtaerman roughness`.

use std::path::PathBuf;

use clap::{Args, Subcommand, ValueEnum};

use super::common::OutputArguments;
use super::units::SenseArguments;

/// `shtaerman roughness`.
#[derive(Debug, Args)]
pub struct RoughnessArguments {
    /// What is known.
    #[command(subcommand)]
    pub source: RoughnessSource,
}

/// What is known of the rough surface.
#[derive(Debug, Subcommand)]
pub enum RoughnessSource {
    /// Asperities of Gaussian height with round tips (Greenwood and Williamson 1966).
    #[command(visible_alias = "gw")]
    GreenwoodWilliamson(GreenwoodWilliamsonArguments),
    /// The bearing curve (Abbott and Firestone), by its parameters or from a trace; asperities crushed or elastic.
    Bearing(BearingArguments),
    /// Pressures against approaches: measured, or a pressure-overclosure law of a finite-element program.
    Table(TableArguments),
}

/// The law that goes into the problem file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Law {
    /// v = chi p, Shtaerman's.
    Linear,
    /// v = B p^kappa.
    Power,
}

/// `shtaerman roughness greenwood-williamson`.
#[derive(Debug, Args)]
pub struct GreenwoodWilliamsonArguments {
    /// Standard deviation of the heights of the summits, such as "0.5 um".
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub deviation: String,
    /// Asperities per area, such as "1e4 1/mm^2".
    #[arg(long, value_name = "DENSITY", allow_hyphen_values = true)]
    pub density: String,
    /// Radius of their tips, such as "20 um".
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub radius: String,
    /// Composite plane-strain modulus E* of the asperities and what they touch, such as "110 GPa".
    #[arg(long, value_name = "PRESSURE", allow_hyphen_values = true)]
    pub modulus: String,
    /// Working pressure: the layer's compliance there.
    #[arg(
        long,
        value_name = "PRESSURE",
        allow_hyphen_values = true,
        required_unless_present = "range"
    )]
    pub pressure: Option<String>,
    /// Range of pressures that the laws are fitted to, such as "20 MPa,200 MPa".
    #[arg(long, value_name = "P1,P2", allow_hyphen_values = true)]
    pub range: Option<String>,
    /// Hardness, for the plasticity index.
    #[arg(long, value_name = "PRESSURE", allow_hyphen_values = true)]
    pub hardness: Option<String>,
    /// The law that goes into the problem file [default: power with --range, else linear].
    #[arg(long, value_enum, value_name = "LAW")]
    pub law: Option<Law>,
    #[command(flatten)]
    /// The result.
    pub output: OutputArguments,
    #[command(flatten)]
    /// What becomes of doubts.
    pub sense: SenseArguments,
}

/// `shtaerman roughness bearing`.
#[derive(Debug, Args)]
pub struct BearingArguments {
    /// Coefficient b of the bearing curve eta = b (v/R)^nu.
    #[arg(long, value_name = "B", allow_hyphen_values = true, required_unless_present = "trace")]
    pub b: Option<String>,
    /// Exponent nu of the bearing curve, at least 1.
    #[arg(long, value_name = "NU", allow_hyphen_values = true, required_unless_present = "trace")]
    pub nu: Option<String>,
    /// Height R from the lowest to the highest point, such as "6 um".
    #[arg(
        long,
        value_name = "LENGTH",
        allow_hyphen_values = true,
        required_unless_present = "trace"
    )]
    pub height: Option<String>,
    /// Trace in two columns, position and height, to fit the curve to.
    #[arg(long, value_name = "FILE.csv", conflicts_with_all = ["b", "nu", "height"])]
    pub trace: Option<PathBuf>,
    /// Unit of the positions of the trace.
    #[arg(long, value_name = "UNIT", default_value = "m", requires = "trace")]
    pub position_unit: String,
    /// Unit of the heights of the trace.
    #[arg(long, value_name = "UNIT", default_value = "m", requires = "trace")]
    pub height_unit: String,
    /// Shares of the surface between which the curve is fitted [default: 0.01,0.5].
    #[arg(long, value_name = "S1,S2", allow_hyphen_values = true, requires = "trace")]
    pub shares: Option<String>,
    /// Hardness: the asperities are crushed.
    #[arg(long, value_name = "PRESSURE", allow_hyphen_values = true, required_unless_present = "modulus", conflicts_with_all = ["modulus", "radius"])]
    pub hardness: Option<String>,
    /// Composite plane-strain modulus E*: the asperities are elastic spheres.
    #[arg(long, value_name = "PRESSURE", allow_hyphen_values = true, requires = "radius")]
    pub modulus: Option<String>,
    /// Radius of the elastic asperities' tips.
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, requires = "modulus")]
    pub radius: Option<String>,
    /// Working pressure: approach and compliance there.
    #[arg(long, value_name = "PRESSURE", allow_hyphen_values = true)]
    pub pressure: Option<String>,
    /// The law that goes into the problem file; linear is the compliance at the working pressure [default: power].
    #[arg(long, value_enum, value_name = "LAW")]
    pub law: Option<Law>,
    #[command(flatten)]
    /// The result.
    pub output: OutputArguments,
    #[command(flatten)]
    /// What becomes of doubts.
    pub sense: SenseArguments,
}

/// What the columns of a table are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ColumnOrder {
    /// Approach, then pressure.
    ApproachPressure,
    /// Pressure, then approach (overclosure), as finite-element programs have it.
    PressureApproach,
}

/// `shtaerman roughness table`.
#[derive(Debug, Args)]
pub struct TableArguments {
    /// Table in two columns, or an input file of Abaqus or `CalculiX` with a tabular pressure-overclosure law.
    #[arg(
        value_name = "FILE",
        help = "Table in two columns, or an input file of Abaqus or CalculiX with a tabular pressure-overclosure law"
    )]
    pub file: PathBuf,
    /// What the columns are [default: what their header says, else approach-pressure; in an input file pressure, then overclosure].
    #[arg(long, value_enum, value_name = "ORDER")]
    pub columns: Option<ColumnOrder>,
    /// Unit of the approach [default: that of the header, else m; of an input file the one that it tells, as exported ones do].
    #[arg(long, value_name = "UNIT")]
    pub approach_unit: Option<String>,
    /// Unit of the pressure [default: that of the header, else Pa; of an input file the one that it tells].
    #[arg(long, value_name = "UNIT")]
    pub pressure_unit: Option<String>,
    /// The law that goes into the problem file [default: that with the smaller largest deviation].
    #[arg(long, value_enum, value_name = "LAW")]
    pub law: Option<Law>,
    #[command(flatten)]
    /// The result.
    pub output: OutputArguments,
}
