//! Profiles that are no text: points, and callables that were sampled.

use numpy::{PyReadonlyArray1, PyReadonlyArrayDyn};
use pyo3::FromPyObject;
use shtaerman::document::FileError;
use shtaerman::profile::{CsvOptions, read_csv};
use shtaerman::{Error, Problem, Profile};

/// A piece of a sampled callable: where it begins and ends, and the coefficients of its Chebyshev series there.
#[derive(FromPyObject)]
pub(crate) struct Piece<'py>(f64, f64, PyReadonlyArray1<'py, f64>);

/// A profile that takes the place of the one in a text.
#[derive(FromPyObject)]
pub(crate) enum Sampled<'py> {
    /// Positions and heights, as of a trace.
    #[pyo3(transparent)]
    Points((PyReadonlyArrayDyn<'py, f64>, PyReadonlyArrayDyn<'py, f64>)),
    /// Neighbouring pieces from left to right.
    #[pyo3(transparent)]
    Pieces(Vec<Piece<'py>>),
}

impl Sampled<'_> {
    /// The same problem with this profile.
    pub(crate) fn on(&self, problem: &Problem) -> Result<Problem, Error> {
        let half_width = problem.punch().half_width();
        let profile = match self {
            Self::Points((positions, heights)) => {
                let (x, f) = (positions.as_array(), heights.as_array());
                through(x.iter().zip(f.iter()), half_width)?
            }
            Self::Pieces(pieces) => piecewise(pieces)?,
        };
        problem.with_profile(profile)
    }
}

/// The spline through points, read as a file with two columns is.
fn through<'a>(
    points: impl Iterator<Item = (&'a f64, &'a f64)>,
    half_width: f64,
) -> Result<Profile, FileError> {
    let options = CsvOptions {
        position_unit: 1.0,
        height_unit: 1.0,
        flip: false,
        cover: [-half_width, half_width],
    };
    let rows: Vec<String> = points.map(|(x, f)| format!("{x:e},{f:e}\n")).collect();
    read_csv(rows.concat().as_bytes(), "profile", &options)
}

/// A Chebyshev series on an interval.
struct Series {
    left: f64,
    right: f64,
    coefficients: Vec<f64>,
}

impl Series {
    /// By Clenshaw's recurrence; beyond the interval as at its nearer end.
    fn at(&self, x: f64) -> f64 {
        let y = ((x - self.left) - (self.right - x)) / (self.right - self.left);
        let y = y.clamp(-1.0, 1.0);
        let (mut one, mut two) = (0.0, 0.0);
        for c in self.coefficients.iter().skip(1).rev() {
            (one, two) = (c + 2.0 * y * one - two, one);
        }
        self.coefficients.first().copied().unwrap_or(0.0) + y * one - two
    }
}

fn piecewise(pieces: &[Piece<'_>]) -> Result<Profile, Error> {
    let series: Vec<Series> = (pieces.iter())
        .map(|Piece(left, right, coefficients)| Series {
            left: *left,
            right: *right,
            coefficients: coefficients.as_array().to_vec(),
        })
        .collect();
    let breaks: Vec<f64> = series.iter().skip(1).map(|piece| piece.left).collect();
    let places = breaks.clone();
    let height = move |x: f64| {
        // At a break the piece to the right.
        let piece = places.partition_point(|at| *at <= x);
        series.get(piece).map_or(f64::NAN, |series| if x.is_nan() { x } else { series.at(x) })
    };
    Profile::from_fn(height).with_breaks(breaks)
}
