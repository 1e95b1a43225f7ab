//! The same body described in different ways has the same mass properties.

use std::f64::consts::FRAC_PI_2;

use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use polhode::body::{
    BodyError, MassProperties, Particle, ParticleCloud, Shape, Solid, TriangleMesh, mass_properties_of,
};
use proptest::prelude::*;

const SIZE: [f64; 3] = [0.3, 0.5, 1.1];
const DENSITY: f64 = 800.0;
/// Of mass, centre and tensor between two descriptions, relative: a few roundings.
const ROUNDING: f64 = 2.0 * f64::EPSILON;
/// Of a tensor put together again from its principal moments and axes, relative to its norm; twice the worst of 10⁶.
const ROUND_TRIP: f64 = 12.0 * f64::EPSILON;

fn box_of(size: [f64; 3]) -> Solid {
    Solid::new(Shape::Box { size }, DENSITY).unwrap()
}

fn tilt() -> UnitQuaternion<f64> {
    UnitQuaternion::from_scaled_axis(Vector3::new(0.31, -0.2, 0.44))
}

fn hole(solid: Solid) -> Solid {
    Solid { density: -solid.density, ..solid }
}

fn assert_same(found: &MassProperties, wanted: &MassProperties, room: f64) {
    let (mass, wanted_mass) = (found.mass.unwrap(), wanted.mass.unwrap());
    assert!((mass / wanted_mass - 1.0).abs() <= room, "mass {mass} is not {wanted_mass} kg");
    let (tensor, wanted_tensor) = (found.tensor(), wanted.tensor());
    let off = (tensor - wanted_tensor).norm() / wanted_tensor.norm();
    assert!(off <= room, "tensor off by {off:e}:{tensor}{wanted_tensor}");
    let moments = (found.moments.vector() - wanted.moments.vector()).amax();
    assert!(moments <= room * wanted.moments.vector().amax(), "moments off by {moments:e} kg m²");
    // A length on the scale of the body and of its distance from the origin.
    let scale = (wanted_tensor.norm() / wanted_mass).sqrt() + wanted.centre_of_mass.norm();
    for (point, wanted) in [(found.centre_of_mass, wanted.centre_of_mass), (found.about, wanted.about)] {
        assert!((point - wanted).norm() <= room * scale, "{point:?} is not {wanted:?}");
    }
}

/// A box from `low` to `high`, twelve triangles.
fn box_mesh(low: Vector3<f64>, high: Vector3<f64>) -> TriangleMesh {
    let corner =
        |index: usize| Vector3::from([0, 1, 2].map(|axis| if index >> axis & 1 == 1 { high[axis] } else { low[axis] }));
    let faces = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    TriangleMesh {
        vertices: (0..8).map(corner).collect(),
        triangles: faces.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect(),
    }
}

#[test]
fn box_of_particles_tends_to_the_box_as_their_number_grows() {
    let wanted = mass_properties_of(&[box_of(SIZE)]).unwrap();
    for half in [1_u32, 2, 4, 8, 16] {
        let along = 2 * half;
        let mass = wanted.mass.unwrap() / f64::from(along.pow(3));
        let at = |index: u32, edge: f64| ((f64::from(index) + 0.5) / f64::from(along) - 0.5) * edge;
        let particle =
            |i, j, k| Particle { mass, position: Vector3::new(at(i, SIZE[0]), at(j, SIZE[1]), at(k, SIZE[2])) };
        let row = |(i, j)| (0..along).map(move |k| particle(i, j, k));
        let particles = (0..along).flat_map(|i| (0..along).map(move |j| (i, j))).flat_map(row).collect();
        let found = ParticleCloud::new(particles).unwrap().mass_properties().unwrap();
        // Cells have moments of their own, which particles lack: for N cells along each edge exactly 1/N² of the whole.
        let share = 1.0 - 1.0 / f64::from(along * along);
        let moments = (wanted.moments.vector() * share).into();
        assert_same(&found, &MassProperties::from_principal(wanted.mass, moments).unwrap(), ROUNDING);
        assert_eq!(found.body_from_principal, UnitQuaternion::identity());
    }
}

#[test]
fn box_is_the_same_as_solid_tensor_moments_and_mesh() {
    let wanted = mass_properties_of(&[box_of(SIZE)]).unwrap();
    let [a, b, c] = SIZE;
    let mass = DENSITY * a * b * c;
    let moments = [b * b + c * c, c * c + a * a, a * a + b * b].map(|sum| mass / 12.0 * sum);
    assert_same(&wanted, &MassProperties::from_principal(Some(mass), moments).unwrap(), ROUNDING);
    let tensor = Matrix3::from_diagonal(&moments.into());
    assert_same(&wanted, &MassProperties::from_tensor(Some(mass), tensor).unwrap(), ROUNDING);
    let half = Vector3::from(SIZE) * 0.5;
    assert_same(&box_mesh(-half, half).mass_properties(DENSITY).unwrap(), &wanted, ROUNDING);
    let from_mass = Solid::from_mass(Shape::Box { size: SIZE }, mass).unwrap();
    assert_same(&mass_properties_of(&[from_mass]).unwrap(), &wanted, ROUNDING);
}

#[test]
fn tilted_box_is_the_same_as_solid_tensor_and_mesh() {
    let upright = mass_properties_of(&[box_of(SIZE)]).unwrap();
    let wanted = MassProperties { body_from_principal: tilt(), ..upright.clone() };
    let tensor = wanted.tensor();
    assert!(tensor[(0, 2)].abs() > 0.05 * tensor.norm(), "no product of inertia");
    let half = Vector3::from(SIZE) * 0.5;
    let mut mesh = box_mesh(-half, half);
    mesh.vertices.iter_mut().for_each(|vertex| *vertex = tilt() * *vertex);
    for found in [
        mass_properties_of(&[box_of(SIZE).turned(tilt())]).unwrap(),
        MassProperties::from_tensor(upright.mass, tensor).unwrap(),
        mesh.mass_properties(DENSITY).unwrap(),
    ] {
        assert_same(&found, &wanted, 2.0 * ROUNDING);
        assert!(found.body_from_principal.angle_to(&tilt()) < 4.0 * ROUNDING, "axes differ");
    }
}

#[test]
fn distance_from_the_origin_costs_no_digits_of_the_tensor() {
    // Exact in binary, as are the moved corners.
    let size = [0.5, 0.75, 1.25];
    let far = Vector3::new(1024.0, -4096.0, 512.0);
    let wanted = mass_properties_of(&[box_of(size)]).unwrap().shifted(far).unwrap();
    let half = Vector3::from(size) * 0.5;
    assert_same(&box_mesh(far - half, far + half).mass_properties(DENSITY).unwrap(), &wanted, ROUNDING);
    assert_same(&mass_properties_of(&[box_of(size).at(far)]).unwrap(), &wanted, ROUNDING);
    let parts = [-1.0, 1.0].map(|side| box_of([0.25, 0.75, 1.25]).at(far + Vector3::x() * (0.125 * side)));
    assert_same(&mass_properties_of(&parts).unwrap(), &wanted, ROUNDING);
}

#[test]
fn box_in_parts_is_the_box() {
    let [a, b, c] = SIZE;
    let whole = mass_properties_of(&[box_of(SIZE)]).unwrap();
    let left = box_of([0.4 * a, b, c]).at(Vector3::x() * (-0.3 * a));
    let right = box_of([0.6 * a, b, c]).at(Vector3::x() * (0.2 * a));
    assert_same(&mass_properties_of(&[left, right]).unwrap(), &whole, ROUNDING);
    // Bored, and the bore filled again.
    let bore = Solid::new(Shape::Cylinder { radius: 0.1, length: 0.2 }, DENSITY).unwrap();
    let bore = bore.at(Vector3::new(0.02, -0.1, 0.3)).turned(tilt());
    assert_same(&mass_properties_of(&[box_of(SIZE), hole(bore), bore]).unwrap(), &whole, ROUNDING);
    // Hollow: a hole in a solid, a skin turned inwards in a mesh.
    let (half, inner) = (Vector3::from(SIZE) * 0.5, Vector3::new(0.1, 0.2, 0.3));
    let place = Vector3::new(0.03, -0.04, 0.2);
    let hollow = [box_of(SIZE), hole(box_of((inner * 2.0).into())).at(place)];
    let mut mesh = box_mesh(-half, half);
    let void = box_mesh(place - inner, place + inner);
    mesh.vertices.extend(void.vertices);
    mesh.triangles.extend(void.triangles.into_iter().map(|[a, b, c]| [a + 8, c + 8, b + 8]));
    let hollow = mass_properties_of(&hollow).unwrap();
    assert_same(&mesh.mass_properties(DENSITY).unwrap(), &hollow, 2.0 * ROUNDING);
}

#[test]
fn two_cylinders_make_the_t_handle_worked_by_hand() {
    let bar = Solid::from_mass(Shape::Cylinder { radius: 0.01, length: 0.1 }, 0.2).unwrap();
    let bar = bar.turned(UnitQuaternion::from_axis_angle(&Vector3::y_axis(), FRAC_PI_2));
    let stem = Solid::from_mass(Shape::Cylinder { radius: 0.01, length: 0.06 }, 0.1).unwrap();
    let stem = stem.turned(UnitQuaternion::from_axis_angle(&Vector3::x_axis(), FRAC_PI_2));
    let handle = mass_properties_of(&[bar, stem.at(Vector3::new(0.0, 0.04, 0.0))]).unwrap();
    // Its own axes are principal axes, though turning the cylinders by π/2 rounds.
    assert_eq!(handle.body_from_principal, UnitQuaternion::identity());
    // Bar (along x): m r²/2 = 1e-5 and m (3 r² + l²)/12 = 206e-6/1.2. Stem (along y): 5e-6 and 3.25e-5. Steiner with
    // the reduced mass 1/15 kg over 0.04 m: 128e-6/1.2. Sums, in 1e-6/1.2 kg m²: 12+39+128, 206+6, 206+39+128.
    let moments = [179.0, 212.0, 373.0].map(|count| count * 1e-6 / 1.2);
    let by_hand = MassProperties::from_principal(Some(0.3), moments).unwrap();
    assert_same(&handle, &by_hand.shifted(Vector3::new(0.0, 0.04 / 3.0, 0.0)).unwrap(), ROUNDING);
}

#[test]
fn parallel_axes_lead_back_to_where_they_began() {
    let body = mass_properties_of(&[box_of(SIZE).at(Vector3::new(0.3, -0.1, 0.2)).turned(tilt())]).unwrap();
    let pivot = Vector3::new(-0.2, 0.4, 0.1);
    let about_pivot = body.about(pivot).unwrap();
    assert_eq!((about_pivot.about, about_pivot.centre_of_mass), (pivot, body.centre_of_mass));
    assert_same(&about_pivot.about(body.about).unwrap(), &body, 4.0 * ROUNDING);
    // A top: a rod on its end has m l²/3 about it, and m l²/12 about its middle.
    let top = MassProperties::from_principal(Some(3.0), [4.0, 4.0, 1e-3]).unwrap();
    let top = top.with_centre_of_mass(Vector3::z()).unwrap();
    let about_centre = top.about(Vector3::z()).unwrap();
    assert_eq!(about_centre.moments.vector(), Vector3::new(1.0, 1.0, 1e-3));
    assert_eq!(about_centre.body_from_principal, UnitQuaternion::identity());
    let refused = top.with_centre_of_mass(Vector3::z() * 1.2).unwrap_err();
    assert!(matches!(refused, BodyError::MomentNotPositive(_)), "{refused}");
    let massless = MassProperties::from_principal(None, [4.0, 4.0, 1e-3]).unwrap();
    assert_eq!(massless.about(Vector3::zeros()).unwrap(), massless);
    assert!(matches!(massless.about(Vector3::x()).unwrap_err(), BodyError::MassUnknown { .. }));
}

#[test]
fn bodies_that_cannot_be_are_refused() {
    let tensor = |a: [f64; 9]| MassProperties::from_tensor(Some(1.0), Matrix3::from_row_slice(&a)).unwrap_err();
    let skew = tensor([2.0, 0.1, 0.0, 0.2, 2.0, 0.0, 0.0, 0.0, 2.0]);
    assert_eq!(skew, BodyError::NotSymmetric { row: 0, column: 1, upper: 0.1, lower: 0.2 });
    let not_finite = tensor([2.0, f64::NAN, 0.0, f64::NAN, 2.0, 0.0, 0.0, 0.0, 2.0]);
    assert!(matches!(not_finite, BodyError::NotFinite { .. }));
    // Its diagonal is a body's, but not its principal moments 0.5, 1 and 1.5 + 0.5.
    let hidden = tensor([1.25, 0.75, 0.0, 0.75, 1.25, 0.0, 0.0, 0.0, 1.0]);
    assert!(matches!(hidden, BodyError::TriangleInequality(_)), "{hidden}");
    assert!(matches!(tensor([1.0, 2.0, 0.0, 2.0, 1.0, 0.0, 0.0, 0.0, 1.0]), BodyError::MomentNotPositive(_)));
    assert!(matches!(tensor([0.0; 9]), BodyError::MomentNotPositive(_)));
    assert!(MassProperties::from_principal(Some(-1.0), [1.0; 3]).is_err());
    assert_eq!(mass_properties_of(&[]).unwrap_err(), BodyError::Empty("solids"));
    let too_much = mass_properties_of(&[box_of([1.0; 3]), hole(box_of([1.0, 1.0, 1.5]))]).unwrap_err();
    assert!(too_much.to_string().starts_with("total mass = -400 kg"), "{too_much}");
    let beside = mass_properties_of(&[box_of([1.0; 3]), hole(box_of([0.5; 3])).at(Vector3::x() * 9.0)]);
    assert!(beside.is_err(), "a hole beside the body");
}

#[test]
fn small_moments_of_graded_tensors_keep_their_own_digits() {
    let (middle, product, small) = (1.0_f64, 1.0 / f64::from(1 << 21), 1.0 / f64::from(1 << 20));
    let tensor = Matrix3::new(middle, 0.0, product, 0.0, 1.0, 0.0, product, 0.0, small);
    let largest = 0.5 * (middle + small) + (0.25 * (middle - small) * (middle - small) + product * product).sqrt();
    // The determinant of the plane is exact.
    let smallest = (middle * small - product * product) / largest;
    let found = MassProperties::from_tensor(None, tensor).unwrap().moments.vector().z;
    assert!((found / smallest - 1.0).abs() <= 2.0 * f64::EPSILON, "{found:e} is not {smallest:e}");
}

#[test]
fn tilted_symmetric_body_keeps_two_equal_moments_and_turns_only_its_axis() {
    let body =
        mass_properties_of(&[Solid::new(Shape::Cylinder { radius: 0.2, length: 1.0 }, DENSITY).unwrap()]).unwrap();
    let lean = UnitQuaternion::from_scaled_axis(Vector3::new(0.2, -0.3, 0.0));
    // A turn about its own axis before that changes nothing.
    let spun = lean * UnitQuaternion::from_scaled_axis(Vector3::z() * 0.7);
    let tensor = MassProperties { body_from_principal: spun, ..body.clone() }.tensor();
    let found = MassProperties::from_tensor(body.mass, tensor).unwrap();
    let [first, second, _] = found.moments.vector().into();
    assert_eq!(first.to_bits(), second.to_bits());
    assert!(found.body_from_principal.angle_to(&lean) < 4.0 * ROUNDING, "{}", found.body_from_principal);
    let ball = MassProperties::from_principal(None, [0.7; 3]).unwrap();
    let tilted = MassProperties { body_from_principal: tilt(), ..ball.clone() }.tensor();
    assert_eq!(MassProperties::from_tensor(None, tilted).unwrap().body_from_principal, UnitQuaternion::identity());
}

/// Moments of a body with second moments from 1 down to 10⁻⁶, some nearly equal.
fn moments() -> impl Strategy<Value = Vector3<f64>> {
    let graded = || (-6.0..0.0_f64).prop_map(libm::exp10);
    let near = (-16.0..-1.0_f64).prop_map(|exponent| 1.0 + libm::exp10(exponent));
    let shape = prop_oneof![
        (graded(), graded(), graded()),
        (graded(), graded(), near.clone()).prop_map(|(x, z, near)| (x, x * near, z)),
        (near.clone(), near).prop_map(|(x, y)| (x, y, 1.0)),
    ];
    shape.prop_map(|(x, y, z)| Vector3::new(y + z, z + x, x + y))
}

fn rotation() -> impl Strategy<Value = UnitQuaternion<f64>> {
    let component = || -1.0..1.0_f64;
    let any = (component(), component(), component()).prop_map(|(x, y, z)| Vector3::new(x, y, z) * 3.0);
    let slight = (any.clone(), -17.0..0.0_f64).prop_map(|(turn, exponent)| turn * libm::exp10(exponent));
    prop_oneof![any, slight].prop_map(UnitQuaternion::from_scaled_axis)
}

/// Units from micrograms on millimetres to ships.
fn scale() -> impl Strategy<Value = f64> {
    (-12.0..12.0_f64).prop_map(libm::exp10)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn tensors_are_put_together_again(moments in moments(), rotation in rotation(), scale in scale()) {
        let moments = moments * scale;
        let matrix = rotation.to_rotation_matrix();
        let tensor = matrix * Matrix3::from_diagonal(&moments) * matrix.inverse();
        let tensor = (tensor + tensor.transpose()) * 0.5;
        let body = MassProperties::from_tensor(None, tensor).unwrap();
        let off = (body.tensor() - tensor).norm() / tensor.norm();
        prop_assert!(off <= ROUND_TRIP, "{off:e}");
        prop_assert!((body.body_from_principal.norm() - 1.0).abs() <= f64::EPSILON);
        let mut found: [f64; 3] = body.moments.vector().into();
        let mut wanted: [f64; 3] = moments.into();
        found.sort_by(f64::total_cmp);
        wanted.sort_by(f64::total_cmp);
        for (found, wanted) in found.into_iter().zip(wanted) {
            prop_assert!((found - wanted).abs() <= ROUND_TRIP * moments.amax(), "{found:e} is not {wanted:e}");
        }
    }

    #[test]
    fn axes_are_the_nearest(rotation in rotation()) {
        let moments = Vector3::new(2.0, 3.0, 4.0);
        let matrix = rotation.to_rotation_matrix();
        let tensor = matrix * Matrix3::from_diagonal(&moments) * matrix.inverse();
        let body = MassProperties::from_tensor(None, (tensor + tensor.transpose()) * 0.5).unwrap();
        prop_assert!(body.body_from_principal.angle() <= rotation.angle() + ROUND_TRIP);
        // No order and signs of the axes is further away than this.
        prop_assert!(body.body_from_principal.angle() <= 63_f64.to_radians());
    }
}
