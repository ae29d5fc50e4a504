//! Evaluation at fixed points.

use std::sync::Arc;

use super::mesh::Mesh;
use super::solution::{line, sine_of_turns};
use super::{Place, SincOperator, SincSolution};
use crate::Error;
use crate::linear::dot;

/// Points fixed beforehand: every solution on the nodes of one operator is then evaluated at all of them by a product
/// with one matrix, `P x N` multiplications for `P` points.
#[derive(Debug, Clone)]
pub struct PointSet {
    mesh: Arc<Mesh>,
    places: Vec<Place>,
    /// Sinc functions of the panel at the points, a row for each.
    rows: Vec<f64>,
}

impl PointSet {
    /// The points, in any order; those outside the interval count as the nearer end.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN.
    pub fn new(operator: &SincOperator, points: &[f64]) -> Result<Self, Error> {
        if let Some(&value) = points.iter().find(|point| point.is_nan()) {
            return Err(Error::NotFinite { what: "list of points", at: value, value });
        }
        let mesh = Arc::clone(operator.mesh());
        let places: Vec<Place> = points.iter().map(|&x| mesh.locate(x)).collect();
        let rows = places.iter().flat_map(|place| sinc_row(&mesh, *place)).collect();
        Ok(Self { mesh, places, rows })
    }

    /// Number of points.
    #[must_use]
    pub fn count(&self) -> usize {
        self.places.len()
    }

    /// `phi` at the points, given `f` there, without allocation.
    ///
    /// # Errors
    /// [`Error::WrongLength`] unless both lists have one value for each point and the solution lives on the nodes of the
    /// operator the set was made for.
    pub fn evaluate_into(
        &self,
        solution: &SincSolution,
        right_hand_side: &[f64],
        values: &mut [f64],
    ) -> Result<(), Error> {
        require(right_hand_side.len(), "right-hand side at the points", self.count())?;
        require(values.len(), "list of results", self.count())?;
        let same_mesh = Arc::ptr_eq(&self.mesh, solution.mesh());
        if !same_mesh {
            return Err(Error::WrongLength {
                what: "solution of another operator",
                found: solution.values().len(),
                expected: self.mesh.count(),
            });
        }
        let count = self.mesh.panel_count();
        for (k, place) in self.places.iter().enumerate() {
            let bubble = &solution.bubble()[place.panel * count..(place.panel + 1) * count];
            let potential = line(solution.boundaries(), self.mesh.left_end(place.panel), *place)
                + dot(&self.rows[k * count..(k + 1) * count], bubble);
            values[k] = right_hand_side[k] - solution.parameter() * potential;
        }
        Ok(())
    }
}

fn require(found: usize, what: &'static str, expected: usize) -> Result<(), Error> {
    if found == expected { Ok(()) } else { Err(Error::WrongLength { what, found, expected }) }
}

/// `sinc(t/h - j)` for the nodes of one panel; zero at the ends of the panel.
pub(super) fn sinc_row(mesh: &Mesh, place: Place) -> impl Iterator<Item = f64> + use<> {
    let half_count = mesh.grid().half_count() as f64;
    let at_end = place.from_left <= 0.0 || place.from_right <= 0.0;
    let tau = mesh.grid().inverse(place) / mesh.grid().step();
    let nearest = tau.round();
    let at_node = (tau - nearest).abs() < 1e-13;
    let sine = sine_of_turns(tau, nearest);
    (0..mesh.panel_count()).map(move |index| {
        let j = index as f64 - half_count;
        if at_end {
            0.0
        } else if at_node {
            f64::from(u8::from(j == nearest))
        } else if j % 2.0 == 0.0 {
            sine / (tau - j)
        } else {
            -sine / (tau - j)
        }
    })
}
