use super::motion::{Motion, Springs};
use super::vector::{Vector, cross, difference, matrix, scaled, solved, sum, tensor, turned, unit};
use crate::dynamics::Problem;
use crate::numerics::DoubleDouble;

/// The particles at t = 0: rᵢ = R pᵢ, vᵢ = R (ω × pᵢ), their centre of mass at rest in the origin.
///
/// Of a relaxed start pᵢ are the places stretched by the spin, and ω is such that L is that of the unstretched body:
/// so a rigid body of the same L turns as the cloud does, but for what stretching makes of its inertia.
pub(super) fn start(problem: &Problem, springs: &Springs) -> Motion {
    let cloud = &springs.cloud;
    let exact = |vector: nalgebra::Vector3<f64>| <[f64; 3]>::from(vector).map(DoubleDouble::from);
    let masses: Vec<DoubleDouble> = cloud.masses().iter().copied().map(DoubleDouble::from).collect();
    let omega = problem.initial.angular_velocity.in_body();
    let moments = problem.moments.vector();
    let mut places: Vec<_> = cloud.places().iter().map(|place| exact(*place)).collect();
    if cloud.springs().is_relaxed {
        let acceleration = -omega.cross(&moments.component_mul(&omega)).component_div(&moments);
        let stretched = cloud.stretched(&omega, &acceleration);
        places = places.into_iter().zip(stretched).map(|(place, moved)| sum(place, exact(moved))).collect();
    }
    centre(&masses, &mut places);
    let momentum = exact(moments.component_mul(&omega));
    let inertia = tensor(masses.iter().zip(&places).map(|(mass, place)| (*mass, *place, *place)));
    let rates = if cloud.springs().is_relaxed { solved(inertia, momentum) } else { exact(omega) };
    let rows = matrix(unit(problem.initial.attitude.wxyz().map(DoubleDouble::from)));
    Motion {
        positions: places.iter().map(|place| turned(rows, *place)).collect(),
        velocities: places.iter().map(|place| turned(rows, cross(rates, *place))).collect(),
    }
}

/// Takes off what the places' rounding has moved the centre of mass by: times ω it would be a velocity.
fn centre(masses: &[DoubleDouble], places: &mut [Vector<DoubleDouble>]) {
    let zero = DoubleDouble::ZERO;
    let mass = masses.iter().fold(zero, |sum, mass| sum + *mass);
    let whole = masses.iter().zip(&*places).fold([zero; 3], |whole, (mass, place)| sum(whole, scaled(*mass, *place)));
    let centre = whole.map(|component| component / mass);
    for place in places {
        *place = difference(*place, centre);
    }
}
