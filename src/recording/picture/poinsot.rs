use nalgebra::{UnitQuaternion, Vector3};

use crate::dynamics::momentum_in_world;
use crate::scenario::PlannedBody;
use crate::telemetry::Channel;

/// Poinsot's construction of a free motion: the energy ellipsoid, fixed in the body, rolls on a plane fixed in the world.
///
/// Lengths are angular velocities in units of `unit`, so that the longest semi-axis is 1. `[Poi51]`
#[derive(Debug, Clone, PartialEq)]
pub struct Poinsot {
    /// What a length of 1 stands for, rad/s.
    pub unit: f64,
    /// Body from principal axes.
    pub body_from_principal: UnitQuaternion<f64>,
    /// Of the ellipsoid of all ω that have the body's energy; principal axes.
    pub semi_axes: Vector3<f64>,
    /// Of the invariable plane, away from the centre: along L; unit, world axes.
    pub normal: Vector3<f64>,
    /// Of the plane from the centre.
    pub distance: f64,
    /// The curve of ω on the ellipsoid, closed; body axes. Empty where it is a point.
    pub polhode: Vec<Vector3<f64>>,
    /// Of the ellipsoid of all L that have the body's energy, in units of |L|; principal axes.
    pub momentum_semi_axes: Vector3<f64>,
    /// The curve of L on the sphere of radius |L| = 1, closed; body axes. Empty where it is a point.
    pub momentum_polhode: Vec<Vector3<f64>>,
}

/// Points of a closed curve.
const POINTS: u32 = 256;

impl Poinsot {
    /// Of a body that turns without loads and of which attitude and ω are recorded.
    #[must_use]
    pub fn of(body: &PlannedBody) -> Option<Self> {
        let is_told = [Channel::Attitude, Channel::AngularVelocity].iter().all(|told| body.channels.contains(told));
        let initial = &body.problem.initial;
        let moments = body.problem.moments.vector();
        let omega = initial.angular_velocity.in_body();
        let momentum = momentum_in_world(body.problem.moments, initial);
        let (size, twice_energy) = (momentum.norm(), omega.dot(&omega.component_mul(&moments)));
        if !is_told || !body.problem.loads.is_empty() || !size.is_normal() || !twice_energy.is_normal() {
            return None;
        }
        let semi_axes = moments.map(|moment| (twice_energy / moment).sqrt());
        let unit = semi_axes.max();
        let body_from_principal = body.properties.body_from_principal;
        let curve = curve(&moments, &(omega.component_mul(&moments) / size));
        let polhode = curve.iter().map(|point| point.component_div(&moments) * (size / unit));
        Some(Self {
            unit,
            body_from_principal,
            semi_axes: semi_axes / unit,
            normal: momentum / size,
            distance: twice_energy / size / unit,
            polhode: polhode.map(|point| body_from_principal * point).collect(),
            momentum_semi_axes: moments.map(|moment| (twice_energy * moment).sqrt() / size),
            momentum_polhode: curve.iter().map(|point| body_from_principal * point).collect(),
        })
    }

    /// Length of the body's axes beside the sphere and the ellipsoid of L.
    #[must_use]
    pub fn axis_length(&self) -> f64 {
        1.2 * self.momentum_semi_axes.max()
    }
}

/// Where the unit sphere meets the energy ellipsoid through `start`, which is unit; principal axes.
///
/// With the axes in the order of their moments, the curve goes round the first or the last, and its shadow along that
/// axis is an ellipse.
fn curve(moments: &Vector3<f64>, start: &Vector3<f64>) -> Vec<Vector3<f64>> {
    let mut order = [0, 1, 2];
    order.sort_by(|a, b| moments[*a].total_cmp(&moments[*b]));
    let [least, middle, most] = order;
    // Of 1/I, which is 2E for L = 1 along that axis.
    let difference = |a: usize, b: usize| (moments[b] - moments[a]) / (moments[a] * moments[b]);
    let square = |axis: usize| start[axis] * start[axis];
    let (below, above) = (difference(least, middle), difference(middle, most));
    let (round, others) = if below * square(least) > above * square(most) {
        (least, [(middle, below), (most, difference(least, most))])
    } else {
        (most, [(least, difference(least, most)), (middle, above)])
    };
    let excess: f64 = others.iter().map(|(axis, difference)| difference * square(*axis)).sum();
    if excess <= 0.0 {
        return Vec::new();
    }
    let point = |index: u32| {
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * f64::from(index) / f64::from(POINTS));
        let mut point = Vector3::zeros();
        for ((axis, difference), part) in others.iter().zip([cos, sin]) {
            point[*axis] = (excess / difference).sqrt() * part;
        }
        point[round] = (1.0 - point.norm_squared()).max(0.0).sqrt().copysign(start[round]);
        point
    };
    (0..=POINTS).map(point).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_goes_through_its_start_and_keeps_the_energy() {
        let moments = Vector3::new(2.0, 0.5, 1.1);
        for start in [Vector3::new(0.3, 0.9, -0.4), Vector3::new(-0.8, 0.2, 0.5), Vector3::new(0.1, 0.1, 1.0)] {
            let start = start.normalize();
            let energy = |l: &Vector3<f64>| l.component_div(&moments).dot(l);
            let curve = curve(&moments, &start);
            assert!(curve.iter().all(|point| (point.norm() - 1.0).abs() < 1e-12));
            assert!(curve.iter().all(|point| (energy(point) - energy(&start)).abs() < 1e-12));
            let nearest = curve.iter().map(|point| (point - start).norm()).fold(f64::INFINITY, f64::min);
            assert!(nearest < std::f64::consts::TAU / f64::from(POINTS), "{nearest}");
        }
    }

    #[test]
    fn a_spin_about_a_principal_axis_has_no_curve() {
        assert!(curve(&Vector3::new(2.0, 0.5, 1.1), &Vector3::x()).is_empty());
        assert!(curve(&Vector3::repeat(1.0), &Vector3::new(0.6, 0.8, 0.0)).is_empty());
    }
}
