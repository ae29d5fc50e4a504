//! The arguments of the command line.

mod book;
mod common;
mod explore;
mod export;
mod find;
mod picture;
mod roughness;
mod schema;
mod spectrum;
mod started;
mod sweep;
mod trace;
mod units;

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

pub use book::BookArguments;
pub use common::{OutputArguments, ProblemArguments, ReportArguments, ReportFormat};
pub use explore::ExploreArguments;
pub use export::{ExportArguments, Exported, ModelUnits, Program};
pub use find::{
    FindArguments, FindCrownArguments, FindForceArguments, FindProfileArguments,
    FindRoughnessArguments, Unknown, Zero,
};
pub use picture::{PictureArguments, PictureTheme};
pub use roughness::{
    BearingArguments, ColumnOrder, GreenwoodWilliamsonArguments, Law, RoughnessArguments,
    RoughnessSource, TableArguments,
};
pub use schema::{SchemaArguments, SchemaName};
pub use spectrum::{KernelArguments, SpectrumArguments};
pub use started::{CompletionsArguments, ExampleGeometry, InitArguments, ManArguments};
pub use sweep::{PartFormat, SweepArguments};
pub use trace::{Level, TraceArguments};
pub use units::{SenseArguments, UnitArguments};

/// Contact of a rigid punch with a rough elastic body (Shtaerman's model).
///
/// chi p(x) + theta int ln(a/|x-s|) p(s) ds = delta - alpha x - f(x), int p = P, int x p = M.
/// Plane strain, small slopes, no friction, adhesion or plasticity. Compression is positive; a positive moment gives a
/// negative tilt.
#[derive(Debug, Parser)]
#[command(name = "shtaerman", version, propagate_version = true, arg_required_else_help = true)]
#[command(
    after_help = "Exit codes: 0 an answer, 1 a check failed or a result not written, 2 bad input, 3 a numerical promise not kept, 130 interrupted."
)]
pub struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
    /// No warnings and no progress on standard error; errors are told.
    #[arg(long, short, global = true, help_heading = "Everywhere")]
    pub quiet: bool,
}

/// The commands.
#[derive(Debug, Subcommand)]
#[command(defer = true)]
pub enum Command {
    /// Solve a problem file: settlement, tilt, force, moment, pressure.
    Solve(SolveArguments),
    /// Find the force, roughness, crown or profile that gives what is wanted.
    Find(FindArguments),
    /// Check a problem file without solving it.
    Validate(ValidateArguments),
    /// Write a commented example of a problem file.
    Init(InitArguments),
    /// Reproduce every figure of the paper's Tables 1-3, as printed and as it is.
    Reproduce(ReproduceArguments),
    /// Tell how regular the paper's infinite systems are (section 4).
    Regularity(RegularityArguments),
    /// Follow the answer as the degree of the degenerate kernel grows.
    Convergence(ConvergenceArguments),
    /// Solve an equation of the second or first kind on any of the paper's kernels.
    Equation(EquationArguments),
    /// Stresses below the surface: their maxima, a grid, a map, the load at first yield.
    Stress(StressArguments),
    /// List eigenvalues and norms of a kernel, and verify them.
    Spectrum(SpectrumArguments),
    /// Run a study: a problem file with some of its values varied.
    Sweep(SweepArguments),
    /// Explore a problem on a local page in the browser.
    Explore(ExploreArguments),
    /// Open the book in the browser: the model, the methods, tutorials, every command and key.
    Book(BookArguments),
    /// Turn what is known of a rough surface into the roughness of a problem file.
    Roughness(RoughnessArguments),
    /// Write the rough layer, or the whole contact, as tables for a finite-element program.
    Export(ExportArguments),
    /// Show what is read of a measured trace, and what is made of it.
    Trace(TraceArguments),
    /// Write the JSON Schema of problem files, or of the JSON of a command.
    Schema(SchemaArguments),
    /// Write what completes commands and options in a shell.
    Completions(CompletionsArguments),
    /// Write a page for `man` about each command.
    Man(ManArguments),
}

/// `shtaerman solve`.
#[derive(Debug, Args)]
pub struct SolveArguments {
    #[command(flatten)]
    /// The problem.
    pub problem: ProblemArguments,
    #[command(flatten)]
    /// The result.
    pub output: OutputArguments,
    /// Draw pressure and deformed surface to this file (.svg, .png, or .pdf, which takes a Chromium or a build with the feature `pdf`).
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    /// What the picture shows, such as "-2 mm..2 mm" [default: the whole base, or a contact that is much less wide with its neighbourhood].
    #[arg(long, value_name = "X1..X2", requires = "plot", allow_hyphen_values = true)]
    pub x_range: Option<String>,
    /// Solve again by a reference method that shares no code with the others, and report the differences; exit code 1 where they are larger than both state.
    #[arg(long)]
    pub cross_check: bool,
    /// Leave out the audit: errors are then those that the method states of itself.
    #[arg(long)]
    pub no_audit: bool,
    #[command(flatten)]
    /// What becomes of doubts.
    pub sense: SenseArguments,
    /// Places for the pressure, separated by commas: metres or with a unit; xi for a dimensionless file.
    #[arg(long, value_name = "X1,X2,...", allow_hyphen_values = true)]
    pub at: Option<String>,
    /// Number of points of the pressure curve, from edge to edge and denser at the edges.
    #[arg(long, value_name = "COUNT", default_value_t = 201, conflicts_with = "at")]
    pub points: usize,
    /// Give the settlement relative to the surface at this x, such as "1 m"; the plane settlement has no absolute datum.
    #[arg(long, value_name = "X", allow_hyphen_values = true)]
    pub datum_distance: Option<String>,
    /// Give the settlement relative to the point at this depth under the middle of the punch, such as "0.5 m".
    #[arg(long, value_name = "DEPTH", allow_hyphen_values = true)]
    pub datum_depth: Option<String>,
    /// Add surface displacement and gap at this number of points from -3a to 3a (JSON; in CSV in place of the pressure curve).
    #[arg(long, value_name = "COUNT", conflicts_with = "at")]
    pub surface: Option<usize>,
    /// Add how settlement and largest pressure change with roughness, modulus and load (estimated); JSON has it anyway, but where it takes eighteen more solves: under coatings, on cells, and where the pressure is largest at a corner on strongly graded ground.
    #[arg(long)]
    pub sensitivities: bool,
    /// Solve for several values of a key, such as load.force="0.1..2 MN/m:20" (with :log behind it for a logarithmic scale) or foundation.roughness="1e-15,1e-14 m/Pa"; given again, for all
    /// combinations. `sweep` takes more, into a folder.
    #[arg(
        long,
        value_name = "KEY=VALUES",
        allow_hyphen_values = true,
        conflicts_with_all = ["cross_check", "at", "datum_distance", "datum_depth", "surface", "sensitivities", "report"]
    )]
    pub vary: Vec<String>,
    /// What is kept of each answer of --vary, such as "settlement, tilt".
    #[arg(long, value_name = "NAMES", requires = "vary")]
    pub outputs: Option<String>,
    #[command(flatten)]
    /// The units of the result.
    pub units: UnitArguments,
    #[command(flatten)]
    /// How the picture looks.
    pub picture: PictureArguments,
    #[command(flatten)]
    /// The report.
    pub report: ReportArguments,
}

/// How stresses are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum StressFormat {
    /// The maxima, for people, in engineering units.
    Table,
    /// JSON, in SI units.
    Json,
    /// CSV of the grid or of the places asked for, in SI units.
    Csv,
    /// `NumPy` arrays of the grid in one file, in SI units; needs --output.
    Npz,
}

/// A component or an equivalent of the stress.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum StressComponent {
    /// Along the surface.
    SigmaX,
    /// Along the depth.
    SigmaY,
    /// Out of the plane.
    SigmaZ,
    /// Shear stress.
    TauXy,
    /// Largest principal stress.
    #[value(name = "sigma-1")]
    #[serde(rename = "sigma-1")]
    Sigma1,
    /// Middle principal stress.
    #[value(name = "sigma-2")]
    #[serde(rename = "sigma-2")]
    Sigma2,
    /// Least principal stress.
    #[value(name = "sigma-3")]
    #[serde(rename = "sigma-3")]
    Sigma3,
    /// Largest shear stress, half of tresca.
    MaxShear,
    /// Largest difference of principal stresses.
    Tresca,
    /// Equivalent stress of von Mises.
    VonMises,
}

/// `shtaerman stress`.
#[derive(Debug, Args)]
pub struct StressArguments {
    #[command(flatten)]
    /// The problem.
    pub problem: ProblemArguments,
    /// Leave out the audit: errors are then those that the method states of itself.
    #[arg(long)]
    pub no_audit: bool,
    /// Format of the result.
    #[arg(long, value_enum, default_value = "table", value_name = "FORMAT")]
    pub format: StressFormat,
    /// Write the result to this file instead of the terminal.
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Points along the surface and in depth, such as 161x81.
    #[arg(long, value_name = "NXxNY")]
    pub grid: Option<String>,
    /// Ends of the grid along the surface, such as "-4 mm..4 mm": metres or with a unit, half-widths for a dimensionless file [default: twice the contact].
    #[arg(long, value_name = "X1..X2", allow_hyphen_values = true)]
    pub x_range: Option<String>,
    /// Depth of the grid [default: the width of the contact].
    #[arg(long, value_name = "DEPTH", allow_hyphen_values = true)]
    pub depth: Option<String>,
    /// Places "x,y; x,y" instead of the grid, y the depth.
    #[arg(long, value_name = "X,Y;...", allow_hyphen_values = true, conflicts_with_all = ["grid", "x_range", "depth"])]
    pub at: Option<String>,
    /// What the map shows.
    #[arg(long, value_enum, default_value = "von-mises", value_name = "COMPONENT")]
    pub component: StressComponent,
    /// Find the load at first yield for this yield stress, such as "350 MPa" [default: that of the foundation in the file].
    #[arg(long, value_name = "STRESS", allow_hyphen_values = true)]
    pub yield_stress: Option<String>,
    /// Poisson's ratio, for a dimensionless file.
    #[arg(long, value_name = "NU", allow_negative_numbers = true)]
    pub poisson_ratio: Option<f64>,
    /// Draw a map to this file (.svg, .png, or .pdf, which takes a Chromium or a build with the feature `pdf`).
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    #[command(flatten)]
    /// The units of the result.
    pub units: UnitArguments,
    #[command(flatten)]
    /// What becomes of doubts.
    pub sense: SenseArguments,
    #[command(flatten)]
    /// How the picture looks.
    pub picture: PictureArguments,
    #[command(flatten)]
    /// The report.
    pub report: ReportArguments,
}

/// `shtaerman validate`.
#[derive(Debug, Args)]
pub struct ValidateArguments {
    #[command(flatten)]
    /// The problem.
    pub problem: ProblemArguments,
    #[command(flatten)]
    /// What becomes of doubts.
    pub sense: SenseArguments,
}

/// `shtaerman reproduce`.
#[derive(Debug, Args)]
pub struct ReproduceArguments {
    #[command(flatten)]
    /// The result.
    pub output: OutputArguments,
    /// Draw Fig. 2 (f0 = lambda0 xi^2) as the paper computed it and as it is (.svg, .png, or .pdf, which takes a Chromium or a build with the feature `pdf`).
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    #[command(flatten)]
    /// How the picture looks.
    pub picture: PictureArguments,
}

/// `shtaerman regularity`.
#[derive(Debug, Args)]
pub struct RegularityArguments {
    /// The parameter theta0 of the systems (3.10) and (3.11).
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    pub theta0: f64,
    /// Complete regularity asks for row sums of at most this constant, between 0 and 1; without it, for row sums below 1.
    #[arg(long, value_name = "Q0", allow_negative_numbers = true)]
    pub q0: Option<f64>,
    /// Number of rows whose sums are shown.
    #[arg(long, value_name = "COUNT", default_value_t = 10)]
    pub rows: usize,
    #[command(flatten)]
    /// The result.
    pub output: OutputArguments,
}

/// `shtaerman convergence`.
#[derive(Debug, Args)]
pub struct ConvergenceArguments {
    #[command(flatten)]
    /// The problem.
    pub problem: ProblemArguments,
    /// Highest degree.
    #[arg(long, value_name = "N", default_value_t = 1024)]
    pub max_n: usize,
    #[command(flatten)]
    /// The result.
    pub output: OutputArguments,
    /// Draw the differences over n (.svg, .png, or .pdf, which takes a Chromium or a build with the feature `pdf`).
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    #[command(flatten)]
    /// The units of the result.
    pub units: UnitArguments,
    #[command(flatten)]
    /// How the picture looks.
    pub picture: PictureArguments,
}

/// `shtaerman equation`.
#[derive(Debug, Args)]
pub struct EquationArguments {
    /// Equation file (TOML); `-` reads standard input.
    #[arg(value_name = "FILE.toml")]
    pub file: PathBuf,
    /// Override a key of the file, such as kernel.mu=0.3; may be given again.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub overrides: Vec<String>,
    /// End with exit code 3 when there is no solution after this time, such as "10 s".
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub time_limit: Option<String>,
    #[command(flatten)]
    /// The result.
    pub output: OutputArguments,
    /// Draw the solution to this file (.svg, .png, or .pdf, which takes a Chromium or a build with the feature `pdf`).
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    /// What the picture shows, such as "0.8..1" [default: all of the interval].
    #[arg(long, value_name = "X1..X2", requires = "plot", allow_hyphen_values = true)]
    pub x_range: Option<String>,
    /// Solve by the other method as well; exit code 1 if they differ by more than both errors.
    #[arg(long)]
    pub cross_check: bool,
    /// Leave out the audit, which looks at the residual of the solution by quadrature of its own.
    #[arg(long)]
    pub no_audit: bool,
    /// Places for the solution, separated by commas.
    #[arg(long, value_name = "X1,X2,...", allow_hyphen_values = true)]
    pub at: Option<String>,
    /// Number of points of the curve, from end to end and denser at the ends; a half-line is shown to 12/kappa.
    #[arg(long, value_name = "COUNT", default_value_t = 201, conflicts_with = "at")]
    pub points: usize,
    #[command(flatten)]
    /// How the picture looks.
    pub picture: PictureArguments,
    #[command(flatten)]
    /// The report.
    pub report: ReportArguments,
}
