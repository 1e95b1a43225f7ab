use std::f64::consts::TAU;

use nalgebra::Vector3;

/// From where something is looked at, without perspective: unit vectors to the right, upwards and towards the eye.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// To the right.
    pub right: Vector3<f64>,
    /// Upwards.
    pub up: Vector3<f64>,
    /// Towards the eye.
    pub towards: Vector3<f64>,
}

impl View {
    /// From the side of `towards`, with `up` upwards as far as it can be; `None` if they are parallel.
    #[must_use]
    pub fn new(towards: &Vector3<f64>, up: &Vector3<f64>) -> Option<Self> {
        let towards = towards.try_normalize(0.0)?;
        let right = up.cross(&towards).try_normalize(1e-9)?;
        Some(Self { right, up: towards.cross(&right), towards })
    }

    /// To the right and upwards.
    #[must_use]
    pub fn project(&self, point: &Vector3<f64>) -> [f64; 2] {
        [self.right.dot(point), self.up.dot(point)]
    }
}

/// The ellipsoid of all ρ with ρ · Iρ = 1, in principal axes: Poinsot's ellipsoid of inertia; of a free body also, but for
/// its size, the ellipsoid of all ω that have its energy. `[Poi51]`
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ellipsoid {
    moments: Vector3<f64>,
}

/// A part of a curve on an ellipsoid.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// Whether the eye sees it.
    pub is_seen: bool,
    /// Its points.
    pub points: Vec<Vector3<f64>>,
}

/// Points of an ellipse.
const POINTS: u32 = 180;
/// An ellipsoid more than a thousand times as long as wide is a needle, of which a picture shows nothing.
const ROUND: f64 = 1e-6;

impl Ellipsoid {
    /// Of these moments; `None` where one vanishes beside another.
    #[must_use]
    pub fn new(moments: Vector3<f64>) -> Option<Self> {
        (moments.min() > ROUND * moments.max() && moments.max().is_finite()).then_some(Self { moments })
    }

    /// A sphere of radius 1.
    #[must_use]
    pub fn sphere() -> Self {
        Self { moments: Vector3::repeat(1.0) }
    }

    /// Where the surface is in the direction of `direction`, which is not zero: for ω, ω / √(ω · Iω).
    #[must_use]
    pub fn point(&self, direction: &Vector3<f64>) -> Vector3<f64> {
        direction / direction.dot(&direction.component_mul(&self.moments)).sqrt()
    }

    /// How far a point of the surface is turned to the eye: its normal Iρ along the line of sight. Negative behind.
    #[must_use]
    pub fn facing(&self, point: &Vector3<f64>, view: &View) -> f64 {
        point.component_mul(&self.moments).dot(&view.towards)
    }

    /// A curve on the surface in parts that are seen and parts that the body hides. It changes where Iρ · v = 0, which on
    /// a straight piece between two points is one place, found without search.
    #[must_use]
    pub fn parts(&self, curve: &[Vector3<f64>], view: &View) -> Vec<Part> {
        let mut parts: Vec<Part> = Vec::new();
        let mut last: Option<(Vector3<f64>, f64)> = None;
        for point in curve {
            let facing = self.facing(point, view);
            let is_seen = facing >= 0.0;
            match (parts.last_mut(), last) {
                (Some(part), Some((before, from))) if part.is_seen != is_seen => {
                    let edge = self.point(&(before + (point - before) * (from / (from - facing))));
                    part.points.push(edge);
                    parts.push(Part { is_seen, points: vec![edge, *point] });
                }
                (Some(part), Some(_)) => part.points.push(*point),
                _ => parts.push(Part { is_seen, points: vec![*point] }),
            }
            last = Some((*point, facing));
        }
        parts
    }

    /// The outline: all points whose normal is across the line of sight.
    #[must_use]
    pub fn silhouette(&self, view: &View) -> Vec<Vector3<f64>> {
        let roots = self.moments.map(f64::sqrt);
        // In coordinates √I ρ the surface is the unit sphere and the outline a great circle.
        let pole = view.towards.component_mul(&roots).normalize();
        let one = pole.cross(&Vector3::ith(pole.iamin(), 1.0)).normalize();
        let other = pole.cross(&one);
        ellipse(&one.component_div(&roots), &other.component_div(&roots))
    }

    /// The ellipses in which the planes across each principal axis through the centre cut the surface.
    #[must_use]
    pub fn equators(&self) -> [Vec<Vector3<f64>>; 3] {
        let end = |axis: usize| self.point(&Vector3::ith(axis, 1.0));
        [(1, 2), (2, 0), (0, 1)].map(|(one, other)| ellipse(&end(one), &end(other)))
    }

    /// The principal axes in the order of their moments, least first.
    #[must_use]
    pub fn order(&self) -> [usize; 3] {
        let mut order = [0, 1, 2];
        order.sort_by(|a, b| self.moments[*a].total_cmp(&self.moments[*b]));
        order
    }

    /// The separatrices, on which a spin about the middle axis leaves it and comes back after ever so long: two ellipses
    /// through that axis, where ω₁² I₁ (I₂ − I₁) = ω₃² I₃ (I₃ − I₂). None where two moments are equal.
    #[must_use]
    pub fn separatrices(&self) -> Vec<Vec<Vector3<f64>>> {
        let [first, second, third] = self.order();
        let [least, middle, most] = [first, second, third].map(|axis| self.moments[axis]);
        let [below, above] = [least * (middle - least), most * (most - middle)];
        if below <= 1e-9 * most * most || above <= 1e-9 * most * most {
            return Vec::new();
        }
        let crossing = |sign: f64| {
            let mut direction = Vector3::zeros();
            direction[first] = above.sqrt();
            direction[third] = sign * below.sqrt();
            ellipse(&self.point(&Vector3::ith(second, 1.0)), &self.point(&direction))
        };
        vec![crossing(1.0), crossing(-1.0)]
    }
}

/// All cos φ a + sin φ b, closed.
fn ellipse(a: &Vector3<f64>, b: &Vector3<f64>) -> Vec<Vector3<f64>> {
    let point = |index: u32| {
        let (sin, cos) = libm::sincos(TAU * f64::from(index) / f64::from(POINTS));
        cos * a + sin * b
    };
    (0..=POINTS).map(point).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const MOMENTS: Vector3<f64> = Vector3::new(2.0, 0.5, 1.1);

    fn view() -> View {
        View::new(&Vector3::new(0.6, 0.3, 0.5), &Vector3::z()).expect("not along z")
    }

    fn is_on(ellipsoid: &Ellipsoid, point: &Vector3<f64>) -> bool {
        (point.component_mul(&ellipsoid.moments).dot(point) - 1.0).abs() < 1e-14
    }

    #[test]
    fn every_curve_lies_on_the_ellipsoid() {
        let ellipsoid = Ellipsoid::new(MOMENTS).expect("round enough");
        let curves = ellipsoid.equators().into_iter().chain(ellipsoid.separatrices());
        for curve in curves.chain([ellipsoid.silhouette(&view())]) {
            assert!(curve.iter().all(|point| is_on(&ellipsoid, point)));
        }
        assert!(is_on(&ellipsoid, &ellipsoid.point(&Vector3::new(3.0, -2.0, 5.0))));
    }

    #[test]
    fn separatrices_have_the_momentum_of_a_spin_about_the_middle_axis() {
        let ellipsoid = Ellipsoid::new(MOMENTS).expect("round enough");
        // L² = 2 E I₂ with 2 E = 1.
        for point in ellipsoid.separatrices().iter().flatten() {
            assert!((point.component_mul(&MOMENTS).norm_squared() - 1.1).abs() < 1e-14);
        }
        assert!(Ellipsoid::sphere().separatrices().is_empty());
        assert!(Ellipsoid::new(Vector3::new(1.0, 1.0, 0.0)).is_none());
    }

    #[test]
    fn a_silhouette_is_seen_edge_on_and_holds_every_point() {
        let ellipsoid = Ellipsoid::new(MOMENTS).expect("round enough");
        let view = view();
        let outline = ellipsoid.silhouette(&view);
        assert!(outline.iter().all(|point| ellipsoid.facing(point, &view).abs() < 1e-14));
        let reach = |direction: [f64; 2], points: &[Vector3<f64>]| {
            let along = |point: &Vector3<f64>| {
                let [x, y] = view.project(point);
                x * direction[0] + y * direction[1]
            };
            points.iter().map(along).fold(f64::NEG_INFINITY, f64::max)
        };
        for direction in [[1.0, 0.0], [0.0, 1.0], [-0.6, 0.8]] {
            for curve in ellipsoid.equators() {
                assert!(reach(direction, &curve) < reach(direction, &outline) + 1e-3);
            }
        }
    }

    #[test]
    fn seen_from_x_the_equator_is_hidden_where_x_is_negative() {
        let ellipsoid = Ellipsoid::new(Vector3::new(1.0, 2.0, 3.0)).expect("round enough");
        let view = View::new(&Vector3::x(), &Vector3::z()).expect("across");
        let [_, _, equator] = ellipsoid.equators();
        let parts = ellipsoid.parts(&equator, &view);
        assert_eq!(parts.iter().map(|part| part.is_seen).collect::<Vec<_>>(), [true, false, true]);
        for part in &parts {
            let sign = if part.is_seen { 1.0 } else { -1.0 };
            assert!(part.points.iter().all(|point| sign * point.x > -1e-15));
        }
        // It changes at the ends of the y axis, to the last digit.
        let [first, second] = [&parts[0], &parts[1]].map(|part| part.points[part.points.len() - 1]);
        let end = 0.5_f64.sqrt();
        assert!((first - Vector3::new(0.0, end, 0.0)).norm() < 1e-15, "{first}");
        assert!((second + Vector3::new(0.0, end, 0.0)).norm() < 1e-15, "{second}");
        assert_eq!(view.project(&Vector3::new(5.0, 1.0, 2.0)), [1.0, 2.0]);
    }
}
