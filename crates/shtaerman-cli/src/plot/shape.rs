//! Cutting polylines: gaps, dashes, and the parts on one side of a line.

use super::canvas::Point;

/// Points closer together than this cannot be told apart.
const CLOSE: f64 = 0.05;
/// A line longer than this is a scribble whose dashes nobody can see.
const LONGEST_DASHED: f64 = 1e5;

/// Runs of present items.
pub(super) fn runs<T>(items: impl Iterator<Item = Option<T>>) -> Vec<Vec<T>> {
    let mut runs = vec![Vec::new()];
    for item in items {
        match (item, runs.last_mut()) {
            (Some(item), Some(run)) => run.push(item),
            _ => runs.push(Vec::new()),
        }
    }
    runs.retain(|run| !run.is_empty());
    runs
}

/// The polyline without points that lie on their predecessor.
pub(super) fn thinned(points: &[Point]) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::with_capacity(points.len());
    for (index, &point) in points.iter().enumerate() {
        let last = index + 1 == points.len();
        let far = kept.last().is_none_or(|&previous| distance(previous, point) > CLOSE);
        if far || last {
            kept.push(point);
        }
    }
    kept
}

/// The polyline cut into strokes; `pattern` gives lengths of strokes and gaps in turn.
pub(super) fn dashes(points: &[Point], pattern: &[f64]) -> Vec<Vec<Point>> {
    let length: f64 = points.windows(2).map(|pair| distance(pair[0], pair[1])).sum();
    let (Some(&first), false) = (points.first(), length > LONGEST_DASHED) else {
        return vec![points.to_vec()];
    };
    let mut strokes = Vec::new();
    let mut stroke = vec![first];
    let (mut phase, mut left) = (0, pattern[0]);
    for pair in points.windows(2) {
        let (mut from, to) = (pair[0], pair[1]);
        let mut rest = distance(from, to);
        while rest > left {
            from = between(from, to, left / rest);
            rest -= left;
            if phase % 2 == 0 {
                stroke.push(from);
                strokes.push(std::mem::take(&mut stroke));
            } else {
                stroke = vec![from];
            }
            phase = (phase + 1) % pattern.len();
            left = pattern[phase];
        }
        left -= rest;
        if phase % 2 == 0 {
            stroke.push(to);
        }
    }
    if stroke.len() > 1 {
        strokes.push(stroke);
    }
    strokes
}

/// Polygons between a polyline and the level `base`, where the polyline lies below it in the picture
/// (`downward`) or above it.
pub(super) fn beyond(points: &[Point], base: f64, downward: bool) -> Vec<Vec<Point>> {
    let depth = |point: Point| if downward { point.1 - base } else { base - point.1 };
    let mut cut: Vec<Option<Point>> = Vec::new();
    for (index, &point) in points.iter().enumerate() {
        let before = index.checked_sub(1).map(|i| points[i]);
        if let Some(before) = before.filter(|&before| (depth(before) > 0.0) != (depth(point) > 0.0))
        {
            let part = depth(before) / (depth(before) - depth(point));
            cut.push(Some((between(before, point, part).0, base)));
        }
        cut.push((depth(point) > 0.0).then_some(point));
    }
    runs(cut.into_iter())
        .into_iter()
        .map(|run| down_to(&run, base))
        .filter(|p| p.len() > 3)
        .collect()
}

/// The polygon between a polyline and a level.
pub(super) fn down_to(points: &[Point], base: f64) -> Vec<Point> {
    let mut polygon = points.to_vec();
    if let (Some(first), Some(last)) = (points.first(), points.last()) {
        polygon.extend([(last.0, base), (first.0, base)]);
    }
    polygon
}

fn distance(a: Point, b: Point) -> f64 {
    (a.0 - b.0).hypot(a.1 - b.1)
}

fn between(a: Point, b: Point, part: f64) -> Point {
    (a.0 + part * (b.0 - a.0), a.1 + part * (b.1 - a.1))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(polygon: &[Point]) -> f64 {
        let next = polygon.iter().cycle().skip(1);
        let twice: f64 = polygon.iter().zip(next).map(|(a, b)| a.0 * b.1 - b.0 * a.1).sum();
        (0.5 * twice).abs()
    }

    #[test]
    fn gaps_break_a_curve() {
        let items = [None, Some(1), Some(2), None, None, Some(3)];
        assert_eq!(runs(items.into_iter()), [vec![1, 2], vec![3]]);
    }

    #[test]
    fn dashes_cover_their_part_of_the_length_round_corners() {
        let points = [(0.0, 0.0), (30.0, 0.0), (30.0, 70.0)];
        let strokes = dashes(&points, &[6.0, 4.0]);
        let drawn: f64 =
            strokes.iter().flat_map(|s| s.windows(2)).map(|p| distance(p[0], p[1])).sum();
        assert_eq!(strokes.len(), 10);
        assert!((drawn - 60.0).abs() < 1e-9);
    }

    #[test]
    fn the_part_beyond_a_level_has_the_area_of_its_triangles() {
        // A zigzag of two triangles below the level, each 10 wide and 5 deep, cut by a peak between.
        let points = [(0.0, 5.0), (10.0, -5.0), (20.0, 5.0), (30.0, -5.0)];
        let polygons = beyond(&points, 0.0, true);
        let areas: Vec<f64> = polygons.iter().map(|p| area(p)).collect();
        assert_eq!(areas, [12.5, 25.0]);
        let above: f64 = beyond(&points, 0.0, false).iter().map(|p| area(p)).sum();
        assert_eq!(above, 37.5);
    }
}
