//! How pictures look, the same for all commands.

use clap::{Args, ValueEnum};

use crate::plot::Theme;

/// How a picture looks.
#[derive(Debug, Args)]
#[command(next_help_heading = "Picture")]
pub struct PictureArguments {
    /// Title in place of the one that the command gives; "" for none.
    #[arg(long, value_name = "TEXT", requires = "plot", allow_hyphen_values = true)]
    pub title: Option<String>,
    /// Size, such as "160 mm x 100 mm", "6in x 4in" or 800x600, which is in 1/96 inch.
    #[arg(long, value_name = "WIDTHxHEIGHT", requires = "plot", allow_hyphen_values = true)]
    pub size: Option<String>,
    /// Where it is to be looked at.
    #[arg(long, value_enum, default_value_t, value_name = "THEME", requires = "plot")]
    pub theme: PictureTheme,
    /// Dots per inch of a PNG [default: 192].
    #[arg(long, value_name = "DOTS", requires = "plot")]
    pub dpi: Option<u32>,
}

/// Where a picture is to be looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum PictureTheme {
    /// Large text on white with a grid.
    #[default]
    Screen,
    /// Text of 7.5 to 10 points and thin strokes on white, 160 mm wide unless --size says otherwise.
    Print,
    /// As for a screen, light on dark.
    Dark,
}

impl From<PictureTheme> for Theme {
    fn from(theme: PictureTheme) -> Self {
        match theme {
            PictureTheme::Screen => Self::Screen,
            PictureTheme::Print => Self::Print,
            PictureTheme::Dark => Self::Dark,
        }
    }
}
