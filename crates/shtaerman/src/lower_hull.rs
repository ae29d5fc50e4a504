//! The lower convex hull of points.

/// Its corners from left to right, of points `[x, y]` that come so.
pub(crate) fn lower_hull(points: impl Iterator<Item = [f64; 2]>) -> Vec<[f64; 2]> {
    let mut hull: Vec<[f64; 2]> = Vec::new();
    for next in points {
        while let [.., before, last] = hull[..]
            && (last[1] - before[1]) * (next[0] - before[0])
                >= (next[1] - before[1]) * (last[0] - before[0])
        {
            hull.pop();
        }
        hull.push(next);
    }
    hull
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_hangs_lowest_is_left() {
        let points = [[0.0, 1.0], [1.0, 3.0], [2.0, 0.0], [3.0, 0.5], [4.0, 1.0], [5.0, 9.0]];
        let hull = lower_hull(points.into_iter());
        assert_eq!(hull, [[0.0, 1.0], [2.0, 0.0], [4.0, 1.0], [5.0, 9.0]]);
    }
}
