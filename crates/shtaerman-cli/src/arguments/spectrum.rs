//! The arguments of `shtaerman spectrum`.

use std::path::PathBuf;

use clap::Args;

use super::common::OutputArguments;
use super::picture::PictureArguments;

/// `shtaerman spectrum`.
#[derive(Debug, Args)]
pub struct SpectrumArguments {
    /// log, log-ratio, log-ratio-limit, log-sine, log-square, power, macdonald, weber-sonine or yukawa.
    #[arg(value_name = "KERNEL")]
    pub kernel: String,
    #[command(flatten)]
    /// The parameters of the kernel.
    pub parameters: KernelArguments,
    /// Number of eigenvalues.
    #[arg(long, value_name = "N", default_value_t = 10)]
    pub count: usize,
    /// Check the spectral relation, orthogonality, norms, Gram matrix and bilinear sum by independent quadrature; exit code 1 if a check fails.
    #[arg(long)]
    pub verify: bool,
    #[command(flatten)]
    /// The result.
    pub output: OutputArguments,
    /// Draw the first eigenfunctions to this file (.svg, .png, or .pdf, which takes a Chromium or a build with the feature `pdf`).
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    #[command(flatten)]
    /// How the picture looks.
    pub picture: PictureArguments,
}

/// The parameters of a kernel; which of them it takes depends on the kernel.
#[derive(Debug, Args)]
#[command(next_help_heading = "Parameters of the kernel")]
pub struct KernelArguments {
    /// Half-length of the interval, or its outer end.
    #[arg(long, value_name = "A", allow_hyphen_values = true)]
    pub a: Option<String>,
    /// Inner end (log-ratio, log-square).
    #[arg(long, value_name = "B", allow_hyphen_values = true)]
    pub b: Option<String>,
    /// Half-angle (log-sine), in radians or as "150 deg".
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    pub alpha: Option<String>,
    /// Exponent (power), order (macdonald, weber-sonine).
    #[arg(long, value_name = "MU", allow_hyphen_values = true)]
    pub mu: Option<String>,
    /// Decay (macdonald).
    #[arg(long, value_name = "KAPPA", allow_hyphen_values = true)]
    pub kappa: Option<String>,
    /// Half the exponent of the power t^(2 gamma) (weber-sonine).
    #[arg(long, value_name = "GAMMA", allow_hyphen_values = true)]
    pub gamma: Option<String>,
    /// Decay (yukawa).
    #[arg(long, value_name = "CHI0", allow_hyphen_values = true)]
    pub chi0: Option<String>,
    /// Harmonic, a whole number (yukawa).
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    pub m: Option<String>,
    /// "half-line" instead of a finite interval (macdonald).
    #[arg(long, value_name = "INTERVAL")]
    pub interval: Option<String>,
}
