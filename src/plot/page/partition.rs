use std::collections::BTreeMap;

use nalgebra::Vector3;

use crate::body::Surface;

/// A body's sides in an order that is right from everywhere: a tree of planes, each with the sides in it, those before it
/// and those behind it. Sides that a plane cuts are cut in two, so that solids may stick in one another. `[FuchsEtAl80]`
#[derive(Debug, Clone, Default)]
pub struct Partition {
    nodes: Vec<Node>,
}

#[derive(Debug, Clone)]
struct Node {
    normal: Vector3<f64>,
    sides: Vec<Side>,
    before: Option<usize>,
    behind: Option<usize>,
}

/// A flat convex piece of a surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Side {
    /// Outwards, unit.
    pub normal: Vector3<f64>,
    pub corners: Vec<Vector3<f64>>,
}

/// Triangles that are drawn as they are; a finer mesh is made coarser, for a page is to be read, not to be waited for.
const MOST: usize = 2000;
/// Cells of the grid for that, in sizes of the body.
const COARSENESS: [f64; 4] = [0.05, 0.08, 0.12, 0.2];
/// Pieces to which cuts may add.
const MOST_PIECES: usize = 4 * MOST;
/// Planes tried for each node.
const TRIED: usize = 6;
/// Of the body's size: what is nearer to a plane is in it. Vertices are in single precision.
const THICK: f64 = 1e-6;

/// Sides that are still to be put under a node.
struct Open {
    sides: Vec<Side>,
    parent: Option<(usize, bool)>,
}

impl Partition {
    /// Of a body's surfaces, body axes.
    pub fn of(surfaces: &[Surface]) -> Self {
        let size = surfaces.iter().map(Surface::extent).fold(0.0, f64::max);
        let sides = sides(surfaces, size);
        let mut room = MOST_PIECES.saturating_sub(sides.len());
        let mut tree = Self::default();
        let mut open = vec![Open { sides, parent: None }];
        while let Some(Open { mut sides, parent }) = open.pop() {
            let Some(chosen) = chosen(&sides, THICK * size) else { continue };
            let (normal, offset) = plane(&sides[chosen]);
            sides.swap(0, chosen);
            let number = tree.nodes.len();
            let mut node = Node { normal, sides: Vec::new(), before: None, behind: None };
            let (mut before, mut behind) = (Vec::new(), Vec::new());
            for side in sides {
                match place(&side, &normal, offset, THICK * size) {
                    Place::In => node.sides.push(side),
                    Place::Before => before.push(side),
                    Place::Behind => behind.push(side),
                    Place::Across if room == 0 => before.push(side),
                    Place::Across => {
                        room -= 1;
                        before.extend(part(&side, &normal, offset, 1.0));
                        behind.extend(part(&side, &normal, offset, -1.0));
                    }
                }
            }
            tree.nodes.push(node);
            match parent {
                Some((above, true)) => tree.nodes[above].before = Some(number),
                Some((above, false)) => tree.nodes[above].behind = Some(number),
                None => {}
            }
            open.push(Open { sides: before, parent: Some((number, true)) });
            open.push(Open { sides: behind, parent: Some((number, false)) });
        }
        tree
    }

    /// The sides that face an eye far away in the direction `towards`, those that others may hide first.
    pub fn seen_from(&self, towards: &Vector3<f64>) -> Vec<&Side> {
        let mut seen = Vec::new();
        let mut open: Vec<(usize, bool)> = if self.nodes.is_empty() { Vec::new() } else { vec![(0, false)] };
        while let Some((number, is_due)) = open.pop() {
            let node = &self.nodes[number];
            if is_due {
                seen.extend(node.sides.iter().filter(|side| side.normal.dot(towards) > 0.0));
                continue;
            }
            let is_before = node.normal.dot(towards) >= 0.0;
            let (near, far) = if is_before { (node.before, node.behind) } else { (node.behind, node.before) };
            // What is put last comes first.
            open.extend(near.map(|near| (near, false)));
            open.push((number, true));
            open.extend(far.map(|far| (far, false)));
        }
        seen
    }
}

/// The triangles of all surfaces. Fine meshes are made coarser: vertices in one cell of a grid become one.
fn sides(surfaces: &[Surface], size: f64) -> Vec<Side> {
    let total: usize = surfaces.iter().map(|surface| surface.triangles.len()).sum();
    let all = |coarseness: f64| -> Vec<Side> {
        surfaces.iter().flat_map(|surface| triangles(surface, coarseness)).filter_map(flat).collect()
    };
    if total <= MOST {
        return all(0.0);
    }
    let coarser = COARSENESS.into_iter().map(|part| all(part * size));
    coarser
        .fold(None, |found: Option<Vec<Side>>, next| match found {
            Some(found) if found.len() <= MOST => Some(found),
            _ => Some(next),
        })
        .unwrap_or_default()
}

fn triangles(surface: &Surface, coarseness: f64) -> Vec<[Vector3<f64>; 3]> {
    let vertices: Vec<Vector3<f64>> =
        surface.vertices.iter().map(|vertex| Vector3::from(vertex.map(f64::from))).collect();
    #[expect(clippy::cast_possible_truncation, reason = "a few dozen cells")]
    let cell = |vertex: &Vector3<f64>| [0, 1, 2].map(|axis: usize| (vertex[axis] / coarseness).round() as i64);
    let mut places = vertices.clone();
    if coarseness > 0.0 {
        let mut sums: BTreeMap<[i64; 3], (Vector3<f64>, f64)> = BTreeMap::new();
        for vertex in &vertices {
            let (sum, count) = sums.entry(cell(vertex)).or_default();
            *sum += vertex;
            *count += 1.0;
        }
        places = vertices.iter().map(|vertex| sums.get(&cell(vertex)).map_or(*vertex, |(sum, n)| sum / *n)).collect();
    }
    let place = |index: u32| usize::try_from(index).ok().and_then(|index| places.get(index)).copied();
    let corners = surface.triangles.iter().filter_map(|[a, b, c]| Some([place(*a)?, place(*b)?, place(*c)?]));
    corners.collect()
}

/// A triangle that has an area.
fn flat([a, b, c]: [Vector3<f64>; 3]) -> Option<Side> {
    let normal = (b - a).cross(&(c - a)).try_normalize(0.0)?;
    Some(Side { normal, corners: vec![a, b, c] })
}

/// The one of a few sides whose plane cuts the fewest others.
fn chosen(sides: &[Side], thick: f64) -> Option<usize> {
    let step = sides.len().div_ceil(TRIED).max(1);
    let cuts = |index: &usize| {
        let (normal, offset) = plane(&sides[*index]);
        sides.iter().filter(|side| matches!(place(side, &normal, offset, thick), Place::Across)).count()
    };
    (0..sides.len()).step_by(step).min_by_key(cuts)
}

fn plane(side: &Side) -> (Vector3<f64>, f64) {
    (side.normal, side.normal.dot(&side.corners[0]))
}

enum Place {
    In,
    Before,
    Behind,
    Across,
}

fn place(side: &Side, normal: &Vector3<f64>, offset: f64, thick: f64) -> Place {
    let heights = || side.corners.iter().map(|corner| normal.dot(corner) - offset);
    let (is_before, is_behind) = (heights().any(|height| height > thick), heights().any(|height| height < -thick));
    match (is_before, is_behind) {
        (false, false) => Place::In,
        (true, false) => Place::Before,
        (false, true) => Place::Behind,
        (true, true) => Place::Across,
    }
}

/// The part of a side before a plane (`sign` 1) or behind it (−1).
fn part(side: &Side, normal: &Vector3<f64>, offset: f64, sign: f64) -> Option<Side> {
    let height = |corner: &Vector3<f64>| sign * (normal.dot(corner) - offset);
    let mut corners = Vec::new();
    for (index, corner) in side.corners.iter().enumerate() {
        let next = &side.corners[(index + 1) % side.corners.len()];
        let (here, there) = (height(corner), height(next));
        if here >= 0.0 {
            corners.push(*corner);
        }
        if (here > 0.0 && there < 0.0) || (here < 0.0 && there > 0.0) {
            corners.push(corner + (next - corner) * (here / (here - there)));
        }
    }
    (corners.len() > 2).then_some(Side { normal: side.normal, corners })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square of side 2 across `axis`, in two triangles, `at` on it.
    fn square(axis: usize, at: f32) -> Surface {
        let corner = |u: f32, v: f32| {
            let mut corner = [u, u, u];
            corner[axis] = at;
            corner[(axis + 1) % 3] = u;
            corner[(axis + 2) % 3] = v;
            corner
        };
        let vertices = vec![corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
        Surface { normals: vertices.clone(), vertices, triangles: vec![[0, 1, 2], [0, 2, 3]] }
    }

    fn area(side: &Side) -> f64 {
        let fan = side.corners[1..].windows(2);
        fan.map(|pair| 0.5 * (pair[0] - side.corners[0]).cross(&(pair[1] - side.corners[0])).norm()).sum()
    }

    #[test]
    fn what_is_nearer_comes_later_whatever_the_order_of_surfaces() {
        for surfaces in [[square(2, 0.0), square(2, 1.0)], [square(2, 1.0), square(2, 0.0)]] {
            let tree = Partition::of(&surfaces);
            let heights: Vec<f64> = tree.seen_from(&Vector3::z()).iter().map(|side| side.corners[0].z).collect();
            assert_eq!(heights, [0.0, 0.0, 1.0, 1.0]);
            assert!(tree.seen_from(&-Vector3::z()).is_empty(), "seen from behind");
        }
    }

    #[test]
    fn a_fine_mesh_is_made_coarser_and_keeps_its_size() {
        let side = 100_u16;
        let at = |index: u16| 2.0 * f32::from(index) / f32::from(side) - 1.0;
        let vertices: Vec<[f32; 3]> =
            (0..=side).flat_map(|row| (0..=side).map(move |column| [at(column), at(row), 0.0])).collect();
        let corner = |row: u16, column: u16| u32::from(row) * (u32::from(side) + 1) + u32::from(column);
        let squares = (0..side).flat_map(|row| (0..side).map(move |column| (row, column)));
        let halves = |(row, column): (u16, u16)| {
            let [a, b] = [corner(row, column), corner(row, column + 1)];
            let [c, d] = [corner(row + 1, column + 1), corner(row + 1, column)];
            [[a, b, c], [a, c, d]]
        };
        let surface = Surface { normals: vertices.clone(), vertices, triangles: squares.flat_map(halves).collect() };
        let tree = Partition::of(&[surface]);
        let seen = tree.seen_from(&Vector3::z());
        assert!((500..=MOST).contains(&seen.len()), "{}", seen.len());
        let area: f64 = seen.iter().copied().map(area).sum();
        // The outermost cells are half a cell narrower.
        assert!((3.6..=4.0).contains(&area), "{area}");
    }

    #[test]
    fn squares_that_stick_in_one_another_are_cut_and_lose_no_area() {
        let tree = Partition::of(&[square(0, 0.0), square(1, 0.0)]);
        let seen = tree.seen_from(&Vector3::new(1.0, 1.0, 0.0));
        let total: f64 = seen.iter().copied().map(area).sum();
        assert!((total - 8.0).abs() < 1e-12, "{total}");
        // Of the one that is cut, the half behind the other comes before it.
        let depth = |side: &Side| side.corners.iter().map(|corner| corner.x + corner.y).sum::<f64>();
        assert!(depth(seen[0]) < 0.0 && depth(seen[seen.len() - 1]) > 0.0);
    }
}
