//! The same body as tensor, principal moments, solids, parts, point masses and mesh, in its own axes and in others.

use std::path::Path;

use nalgebra::{UnitQuaternion, Vector3};
use polhode::body::MassProperties;
use polhode::scenario::{BodySpec, BoxSpec, EllipsoidSpec, ParticleSpec, RoundSpec, SolidSpecs};
use proptest::prelude::*;

use super::case::{Gap, planned, rows, wxyz};
use super::frames::TIMES;
use super::{Case, bodies, case};
use crate::properties::cases;
use crate::properties::starts::attitude;

/// Roundings of a tensor that its description may make: of each piece, turned and moved, and of the principal axes.
const DESCRIBED: f64 = 16.0;

/// A uniform body with its axes turned by `turn` from body axes.
struct Body<'a> {
    squares: Vector3<f64>,
    turn: UnitQuaternion<f64>,
    case: &'a Case,
}

impl Body<'_> {
    /// The start and the loads, without what the body is.
    fn bare(&self) -> BodySpec {
        BodySpec { mass_kg: None, inertia_kg_m2: None, centre_of_mass_m: None, ..self.case.spec() }
    }

    fn place(&self, in_own_axes: Vector3<f64>) -> [f64; 3] {
        (self.case.centre + self.turn * in_own_axes).into()
    }

    fn cuboid(&self, size: Vector3<f64>, at: Vector3<f64>, mass: f64) -> BoxSpec {
        BoxSpec {
            size_m: size.into(),
            mass_kg: Some(mass),
            density_kg_m3: None,
            position_m: Some(self.place(at)),
            rotation: Some(wxyz(&self.turn)),
        }
    }

    /// Edges of the box that has the mean squares.
    fn edges(&self) -> Vector3<f64> {
        self.squares.map(|square| (12.0 * square).sqrt())
    }

    fn of_solids(&self, solid: SolidSpecs) -> BodySpec {
        BodySpec { solid, ..self.bare() }
    }

    fn as_box(&self) -> BodySpec {
        let cuboid = vec![self.cuboid(self.edges(), Vector3::zeros(), self.case.mass)];
        self.of_solids(SolidSpecs { cuboid, ..SolidSpecs::default() })
    }

    /// Cut across one edge.
    fn as_two_boxes(&self, axis: usize, share: f64) -> BodySpec {
        let edges = self.edges();
        let part = |share: f64, middle: f64| {
            let mut size = edges;
            size[axis] *= share;
            self.cuboid(size, Vector3::ith(axis, middle * edges[axis]), share * self.case.mass)
        };
        let cuboid = vec![part(share, 0.5 * (share - 1.0)), part(1.0 - share, 0.5 * share)];
        self.of_solids(SolidSpecs { cuboid, ..SolidSpecs::default() })
    }

    /// A box with a hole, and what fills it.
    fn as_filled_box(&self) -> BodySpec {
        let whole = self.cuboid(self.edges(), Vector3::zeros(), self.case.mass);
        let (inner, at) = (self.edges() * 0.25, self.edges() * 0.1);
        let density = self.case.mass / self.edges().product();
        let filling = self.cuboid(inner, at, density * inner.product());
        let hole = BoxSpec { mass_kg: None, density_kg_m3: Some(-density), ..filling.clone() };
        self.of_solids(SolidSpecs { cuboid: vec![whole, hole, filling], ..SolidSpecs::default() })
    }

    fn as_ellipsoid(&self) -> BodySpec {
        let ellipsoid = EllipsoidSpec {
            semi_axes_m: self.squares.map(|square| (5.0 * square).sqrt()).into(),
            mass_kg: Some(self.case.mass),
            density_kg_m3: None,
            position_m: Some(self.place(Vector3::zeros())),
            rotation: Some(wxyz(&self.turn)),
        };
        self.of_solids(SolidSpecs { ellipsoid: vec![ellipsoid], ..SolidSpecs::default() })
    }

    /// Of a body that is round about its third axis.
    fn as_cylinder(&self) -> Option<BodySpec> {
        let [across, other, along] = self.squares.into();
        let cylinder = RoundSpec {
            radius_m: 2.0 * across.sqrt(),
            length_m: (12.0 * along).sqrt(),
            mass_kg: Some(self.case.mass),
            density_kg_m3: None,
            position_m: Some(self.place(Vector3::zeros())),
            rotation: Some(wxyz(&self.turn)),
        };
        (across == other).then(|| self.of_solids(SolidSpecs { cylinder: vec![cylinder], ..SolidSpecs::default() }))
    }

    fn of_particles(&self, places: impl Iterator<Item = Vector3<f64>>, count: f64) -> BodySpec {
        let particle = |place: Vector3<f64>| ParticleSpec {
            mass_kg: self.case.mass / count,
            position_m: self.place(place),
            ..ParticleSpec::default()
        };
        BodySpec { particle: places.map(particle).collect(), ..self.bare() }
    }

    /// Two on each axis.
    fn as_six(&self) -> BodySpec {
        let squares = self.squares;
        let places = (0..6).map(|index| {
            let far = (3.0 * squares[index / 2]).sqrt();
            Vector3::ith(index / 2, if index % 2 == 0 { far } else { -far })
        });
        self.of_particles(places, 6.0)
    }

    /// One at each corner.
    fn as_eight(&self) -> BodySpec {
        let far = self.squares.map(f64::sqrt);
        let places = (0..8_usize)
            .map(|corner| Vector3::from_fn(|axis, _| if corner >> axis & 1 == 1 { far[axis] } else { -far[axis] }));
        self.of_particles(places, 8.0)
    }

    /// The box, as a file of its skin; how many kg/m³ fill it.
    #[cfg(feature = "serde")]
    fn as_mesh(&self, folder: &Path) -> BodySpec {
        use std::fmt::Write;
        let mut text = String::new();
        for corner in 0..8_usize {
            let at = Vector3::from_fn(|axis, _| if corner >> axis & 1 == 1 { 0.5 } else { -0.5 } * self.edges()[axis]);
            let [x, y, z] = self.place(at);
            writeln!(text, "v {x:?} {y:?} {z:?}").expect("text");
        }
        for [a, b, c, d] in [[1, 5, 7, 3], [2, 4, 8, 6], [1, 2, 6, 5], [3, 7, 8, 4], [1, 3, 4, 2], [5, 6, 8, 7]] {
            writeln!(text, "f {a} {b} {c}\nf {a} {c} {d}").expect("text");
        }
        std::fs::write(folder.join("box.obj"), text).expect("a file");
        let density_kg_m3 = self.case.mass / self.edges().product();
        let mesh = polhode::scenario::MeshSpec { file: "box.obj".into(), density_kg_m3, metres_per_unit: None };
        BodySpec { mesh: Some(mesh), ..self.bare() }
    }

    /// Every way to say it in the same body axes.
    fn described(&self, axis: usize, share: f64, folder: &Path) -> Vec<(&'static str, BodySpec)> {
        let mut all = vec![
            ("box", self.as_box()),
            ("two boxes", self.as_two_boxes(axis, share)),
            ("filled box", self.as_filled_box()),
            ("ellipsoid", self.as_ellipsoid()),
            ("six particles", self.as_six()),
            ("eight particles", self.as_eight()),
        ];
        all.extend(self.as_cylinder().map(|cylinder| ("cylinder", cylinder)));
        #[cfg(feature = "serde")]
        all.push(("mesh", self.as_mesh(folder)));
        #[cfg(not(feature = "serde"))]
        let _ = folder;
        all
    }

    /// Its own axes as body axes, and its moments alone.
    fn in_principal_axes(&self) -> BodySpec {
        let [x, y, z] = self.squares.into();
        let moments = (self.case.mass * Vector3::new(y + z, z + x, x + y)).into();
        let turned = self.case.in_axes(&self.turn.inverse());
        BodySpec { inertia_kg_m2: None, principal_moments_kg_m2: Some(moments), ..turned.spec() }
    }
}

fn assert_same_body(name: &str, found: &MassProperties, case: &Case) {
    let mass = found.mass.expect("known");
    assert!((mass / case.mass - 1.0).abs() <= DESCRIBED * f64::EPSILON, "{name}: {mass} kg");
    let length = (case.tensor.norm() / case.mass).sqrt();
    let off = (found.centre_of_mass - case.centre).norm() / (length + case.centre.norm());
    assert!(off <= DESCRIBED * f64::EPSILON, "{name}: centre {off:e} off");
    // A distance from the origin rounds each piece's place.
    let room = 1.0 + case.centre.norm() / length;
    let off = (found.tensor() - case.tensor).norm() / case.tensor.norm();
    assert!(off <= DESCRIBED * f64::EPSILON * room, "{name}: tensor {off:e} off");
}

/// All tellings have the mass properties and move as the tensor does.
fn assert_all_same(body: &Body<'_>, tilt: UnitQuaternion<f64>, (axis, share): (usize, f64)) {
    let folder = tempfile::tempdir().expect("a folder");
    let case = body.case;
    let (expected, room, size) = case.room(&TIMES);
    let places = 1.0 + case.centre.norm() / (case.tensor.norm() / case.mass).sqrt();
    let assert_moves = |name: &str, found: &[super::Row]| {
        let gap = Gap::worst(found, &expected);
        let share = gap.share(DESCRIBED * places, &room, &size);
        assert!(gap.is_within(DESCRIBED * places, &room, &size), "{name}: {gap:?} of {share:?}");
    };
    for (name, spec) in body.described(axis, share, folder.path()) {
        assert_same_body(name, &planned(spec.clone(), folder.path()).properties, case);
        assert_moves(name, &rows(spec, folder.path(), &TIMES));
    }
    let tilted = case.in_axes(&tilt);
    assert_same_body("tilted tensor", &planned(tilted.spec(), folder.path()).properties, &tilted);
    let back = |rows: Vec<super::Row>, turn: &UnitQuaternion<f64>| -> Vec<_> {
        rows.iter().map(|row| row.in_axes(turn)).collect()
    };
    assert_moves("tilted tensor", &back(tilted.rows(&TIMES), &tilt.inverse()));
    let principal = rows(body.in_principal_axes(), folder.path(), &TIMES);
    assert_moves("principal moments", &back(principal, &body.turn));
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn free_bodies_are_what_they_are_however_described(
        (squares, turn, case) in bodies(), tilt in attitude(), cut in (0..3_usize, 0.1..0.9_f64),
    ) {
        assert_all_same(&Body { squares, turn, case: &case }, tilt, cut);
    }

    #[test]
    fn loaded_bodies_are_what_they_are_however_described(
        (squares, turn, body) in bodies(), loaded in case(), tilt in attitude(), cut in (0..3_usize, 0.1..0.9_f64),
    ) {
        let least = |case: &Case| case.tensor.symmetric_eigenvalues().min();
        let by = (least(&body) / least(&loaded)).min(1.0);
        let loads = loaded.loads.into_iter().map(|(kind, span)| (kind.unlimited().scaled(by, by), span)).collect();
        let case = Case { loads, gravity: loaded.gravity, ..body };
        assert_all_same(&Body { squares, turn, case: &case }, tilt, cut);
    }
}
