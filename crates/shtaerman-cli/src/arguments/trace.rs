//! The arguments of `shtaerman trace`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::common::OutputArguments;
use super::picture::PictureArguments;
use super::units::UnitArguments;

/// `shtaerman trace`.
#[derive(Debug, Args)]
pub struct TraceArguments {
    /// Text file with columns of positions and heights; `-` reads standard input.
    #[arg(value_name = "FILE.csv")]
    pub file: PathBuf,
    /// Column of the positions: its number, or its name in the header [default: 1].
    #[arg(long, value_name = "COLUMN")]
    pub x_column: Option<String>,
    /// Column of the heights: its number, or its name in the header [default: 2].
    #[arg(long, value_name = "COLUMN")]
    pub f_column: Option<String>,
    /// Lines at the beginning that say nothing of the columns.
    #[arg(long, value_name = "LINES", default_value_t = 0)]
    pub skip: usize,
    /// Unit of the positions [default: that of the header, or metres].
    #[arg(long, value_name = "UNIT")]
    pub x_unit: Option<String>,
    /// Unit of the heights [default: that of the header, or metres].
    #[arg(long, value_name = "UNIT")]
    pub f_unit: Option<String>,
    /// Encoding, such as windows-1252 or utf-16 [default: what can be told].
    #[arg(long, value_name = "NAME")]
    pub encoding: Option<String>,
    /// Positions grow to the left: change their sign.
    #[arg(long)]
    pub reverse: bool,
    /// Heights were measured towards the body: change their sign.
    #[arg(long)]
    pub flip: bool,
    /// Shift the positions by this length.
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, conflicts_with = "centre")]
    pub x_shift: Option<String>,
    /// Shift the middle of the trace under the middle of the punch.
    #[arg(long)]
    pub centre: bool,
    /// What is taken off the heights.
    #[arg(long, value_enum, value_name = "LEVEL")]
    pub level: Option<Level>,
    /// Cutoff of a Gaussian filter (ISO 16610-21), such as "0.8 mm".
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub cutoff: Option<String>,
    /// Half-width of the base under which the trace is looked at [default: all of it].
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub half_width: Option<String>,
    #[command(flatten)]
    /// The result; CSV is the trace as it would be used.
    pub output: OutputArguments,
    #[command(flatten)]
    /// The units of the result.
    pub units: UnitArguments,
    /// Draw the trace before and after to this file (.svg, .png, or .pdf, which takes a Chromium or a build with the feature `pdf`).
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    #[command(flatten)]
    /// How the picture looks.
    pub picture: PictureArguments,
}

/// What is taken off heights.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Level {
    /// The line of least squares.
    MeanLine,
}
