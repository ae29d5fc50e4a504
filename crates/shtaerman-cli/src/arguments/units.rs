//! Units of results, and whether doubts end a command.

use clap::Args;

/// How results are shown.
#[derive(Debug, Default, Args)]
pub struct UnitArguments {
    /// Units of tables, plots and CSV: si, mm or inch, or one's own such as "length=in, pressure=ksi"; JSON stays SI. In place of `units` of [output] in the file.
    #[arg(long, value_name = "UNITS")]
    pub units: Option<String>,
}

/// What becomes of doubts.
#[derive(Debug, Clone, Copy, Default, Args)]
pub struct SenseArguments {
    /// End with exit code 2 where an engineer would doubt the input: steep bases, large angles, pressures that no solid bears, moduli without a unit and the like, which are warnings otherwise.
    #[arg(long)]
    pub strict: bool,
}
