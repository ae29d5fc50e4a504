//! Regions of a map where a value is at least a level, as closed loops.

/// A point of a loop, and whether it lies on the border of the map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Vertex {
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) on_border: bool,
}

/// Values over a rectangular grid, row by row.
pub(super) struct Field<'a> {
    pub(super) x: &'a [f64],
    pub(super) y: &'a [f64],
    pub(super) values: &'a [f64],
}

/// An edge between a point of the grid, surrounded by a rim of points below all levels, and its neighbour to the right or below.
type Edge = usize;

impl Field<'_> {
    fn columns(&self) -> usize {
        self.x.len() + 2
    }

    fn rows(&self) -> usize {
        self.y.len() + 2
    }

    /// The value at a point of the rimmed grid; none on the rim.
    fn value(&self, column: usize, row: usize) -> Option<f64> {
        let (i, j) = (column.checked_sub(1)?, row.checked_sub(1)?);
        if i >= self.x.len() || j >= self.y.len() {
            return None;
        }
        self.values.get(j * self.x.len() + i).copied()
    }

    fn place(&self, column: usize, row: usize) -> (f64, f64) {
        let clamped = |index: usize, along: &[f64]| {
            along[index.saturating_sub(1).min(along.len().saturating_sub(1))]
        };
        (clamped(column, self.x), clamped(row, self.y))
    }

    fn edge(&self, column: usize, row: usize, downward: bool) -> Edge {
        2 * (row * self.columns() + column) + usize::from(downward)
    }

    /// The closed loops around the regions where the value is at least `level`; holes run the other way round.
    pub(super) fn regions(&self, level: f64) -> Vec<Vec<Vertex>> {
        if self.x.is_empty() || self.y.is_empty() {
            return Vec::new();
        }
        let mut next: Vec<Option<Edge>> = vec![None; 2 * self.columns() * self.rows()];
        for row in 0..self.rows() - 1 {
            for column in 0..self.columns() - 1 {
                self.cross(column, row, level, &mut next);
            }
        }
        let mut loops = Vec::new();
        for start in 0..next.len() {
            let mut vertices = Vec::new();
            let mut edge = start;
            while let Some(following) = next[edge].take() {
                vertices.push(self.vertex(edge, level));
                edge = following;
            }
            if !vertices.is_empty() {
                loops.push(vertices);
            }
        }
        loops
    }

    /// Joins the edges of a cell that the border of the region crosses.
    fn cross(&self, column: usize, row: usize, level: f64, next: &mut [Option<Edge>]) {
        let corners = [(column, row), (column + 1, row), (column + 1, row + 1), (column, row + 1)];
        let edges = [
            self.edge(column, row, false),
            self.edge(column + 1, row, true),
            self.edge(column, row + 1, false),
            self.edge(column, row, true),
        ];
        let values = corners.map(|(i, j)| self.value(i, j));
        let inside = values.map(|value| value.is_some_and(|value| value >= level));
        let leaves: Vec<usize> = (0..4).filter(|&i| inside[i] && !inside[(i + 1) % 4]).collect();
        let enters: Vec<usize> = (0..4).filter(|&i| !inside[i] && inside[(i + 1) % 4]).collect();
        match (leaves.as_slice(), enters.as_slice()) {
            ([leave], [enter]) => next[edges[*leave]] = Some(edges[*enter]),
            ([_, _], [_, _]) => {
                // A saddle: the middle tells whether the corners inside are joined.
                let middle = values.iter().flatten().sum::<f64>() / 4.0;
                let joined = values.iter().all(Option::is_some) && middle >= level;
                for leave in leaves {
                    let turn = if joined { 1 } else { 3 };
                    next[edges[leave]] = Some(edges[(leave + turn) % 4]);
                }
            }
            _ => {}
        }
    }

    fn vertex(&self, edge: Edge, level: f64) -> Vertex {
        let (point, downward) = (edge / 2, edge % 2 == 1);
        let (column, row) = (point % self.columns(), point / self.columns());
        let other = if downward { (column, row + 1) } else { (column + 1, row) };
        let (from, to) = (self.place(column, row), self.place(other.0, other.1));
        let (part, on_border) = match (self.value(column, row), self.value(other.0, other.1)) {
            (Some(one), Some(two)) => (((level - one) / (two - one)).clamp(0.0, 1.0), false),
            // The rim lies on the border.
            _ => (0.0, true),
        };
        let part = if part.is_nan() { 0.5 } else { part };
        Vertex { x: from.0 + part * (to.0 - from.0), y: from.1 + part * (to.1 - from.1), on_border }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(points: &[Vertex]) -> f64 {
        let next = points.iter().cycle().skip(1);
        0.5 * points.iter().zip(next).map(|(a, b)| a.x * b.y - b.x * a.y).sum::<f64>()
    }

    fn grid(count: usize, f: impl Fn(f64, f64) -> f64) -> (Vec<f64>, Vec<f64>) {
        let along: Vec<f64> =
            (0..count).map(|i| 2.0 * i as f64 / (count - 1) as f64 - 1.0).collect();
        let values = along.iter().flat_map(|y| along.iter().map(|x| f(*x, *y))).collect();
        (along, values)
    }

    #[test]
    fn a_ring_is_a_disk_with_a_hole() {
        let (along, values) = grid(201, |x, y| -(x.hypot(y) - 0.6).abs());
        let field = Field { x: &along, y: &along, values: &values };
        let loops = field.regions(-0.2);
        assert_eq!(loops.len(), 2);
        let total: f64 = loops.iter().map(|points| area(points)).sum();
        let exact = std::f64::consts::PI * (0.8f64.powi(2) - 0.4f64.powi(2));
        assert!((total.abs() - exact).abs() < 1e-3, "{total}");
        assert!(area(&loops[0]) * area(&loops[1]) < 0.0);
        assert!(loops.iter().flatten().all(|vertex| !vertex.on_border));
    }

    #[test]
    fn what_reaches_the_border_ends_there() {
        let (along, values) = grid(21, |x, _| x);
        let field = Field { x: &along, y: &along, values: &values };
        let loops = field.regions(0.35);
        assert_eq!(loops.len(), 1);
        assert!((area(&loops[0]).abs() - 2.0 * 0.65).abs() < 1e-12);
        assert!(field.regions(2.0).is_empty());
        assert!((area(&field.regions(-5.0)[0]).abs() - 4.0).abs() < 1e-12);
    }

    #[test]
    fn a_saddle_keeps_its_area() {
        let (along, values) = grid(40, |x, y| x * y);
        let field = Field { x: &along, y: &along, values: &values };
        let total: f64 = field.regions(0.0).iter().map(|points| area(points).abs()).sum();
        assert!((total - 2.0).abs() < 0.01, "{total}");
    }
}
