//! A random body in a random state under random loads, the scene that tells of it, and what its recording reads.

use std::path::Path;

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};
use polhode::body::Attitude;
use polhode::scenario::{BodySpec, MomentSpec, Plan, PlannedBody, Scenario};
use polhode::telemetry::Channel;
use proptest::prelude::*;

use super::kinds::{Kind, Span, kinds};
use crate::properties::starts::{attitude, decades, vector};

/// A body, how it starts and what acts on it. Vectors in body axes are along its own, whatever they are.
#[derive(Debug, Clone)]
pub struct Case {
    /// kg.
    pub mass: f64,
    /// Of mass, from the origin, body axes, m.
    pub centre: Vector3<f64>,
    /// About the centre of mass, body axes, kg m².
    pub tensor: Matrix3<f64>,
    pub attitude: UnitQuaternion<f64>,
    /// Body axes, rad/s.
    pub rates: Vector3<f64>,
    pub position: Vector3<f64>,
    pub velocity: Vector3<f64>,
    pub gravity: Vector3<f64>,
    pub loads: Vec<(Kind, Span)>,
}

/// What a recording reads at one time.
#[derive(Debug, Clone, Copy)]
pub struct Row {
    pub attitude: UnitQuaternion<f64>,
    /// Body axes, rad/s.
    pub rates: Vector3<f64>,
    /// World axes, N m s.
    pub momentum: Vector3<f64>,
    pub position: Vector3<f64>,
    pub velocity: Vector3<f64>,
}

/// How far two recordings are apart: rad, rad/s, N m s, m and m/s.
#[derive(Debug, Clone, Copy, Default)]
pub struct Gap([f64; 5]);

impl Gap {
    /// Roundings of what is recorded, however it comes about, of numbers of size 1.
    const FLOOR: f64 = 16.0 * f64::EPSILON;

    fn between(a: &Row, b: &Row) -> Self {
        let angle = Attitude::from_world_from_body(a.attitude).angle_to(Attitude::from_world_from_body(b.attitude));
        let vectors = [a.rates - b.rates, a.momentum - b.momentum, a.position - b.position, a.velocity - b.velocity];
        let [rates, momentum, position, velocity] = vectors.map(|difference| difference.norm());
        Self([angle, rates, momentum, position, velocity])
    }

    /// The largest of each at any time.
    pub fn worst(a: &[Row], b: &[Row]) -> Self {
        assert_eq!(a.len(), b.len());
        let gaps = a.iter().zip(b).map(|(a, b)| Self::between(a, b).0);
        Self(gaps.fold([0.0; 5], |worst, gap| std::array::from_fn(|i| worst[i].max(gap[i]))))
    }

    /// Of the attitudes, rad.
    pub fn angle(&self) -> f64 {
        self.0[0]
    }

    /// Whether each is within so many times the other and the floor, which is of the motion's `size`.
    pub fn is_within(&self, times: f64, room: &Self, size: &Self) -> bool {
        (0..5).all(|i| self.0[i] <= times * room.0[i] + Self::FLOOR * size.0[i])
    }

    /// By how much of that the worst exceeds it: for messages.
    pub fn share(&self, times: f64, room: &Self, size: &Self) -> [f64; 5] {
        std::array::from_fn(|i| self.0[i] / (times * room.0[i] + Self::FLOOR * size.0[i]))
    }
}

/// The largest of what is recorded, in the units of a [`Gap`].
fn size(rows: &[Row]) -> Gap {
    let of = |row: &Row| [1.0, row.rates.norm(), row.momentum.norm(), row.position.norm(), row.velocity.norm()];
    Gap(rows.iter().map(of).fold([0.0; 5], |most, row| std::array::from_fn(|i| most[i].max(row[i]))))
}

impl Row {
    /// The same told in body axes that are the old ones' images: `turn` takes old components to new ones.
    pub fn in_axes(&self, turn: &UnitQuaternion<f64>) -> Self {
        Self { attitude: self.attitude * turn.inverse(), rates: turn * self.rates, ..*self }
    }

    /// The same with the world turned.
    pub fn turned(&self, turn: &UnitQuaternion<f64>) -> Self {
        Self {
            attitude: turn * self.attitude,
            rates: self.rates,
            momentum: turn * self.momentum,
            position: turn * self.position,
            velocity: turn * self.velocity,
        }
    }
}

/// A quaternion as a scene has it.
pub fn wxyz(q: &UnitQuaternion<f64>) -> [f64; 4] {
    [q.w, q.i, q.j, q.k]
}

impl Case {
    /// As a body of a scene, its inertia told by the tensor.
    pub fn spec(&self) -> BodySpec {
        let t = &self.tensor;
        let mut spec = BodySpec {
            mass_kg: Some(self.mass),
            inertia_kg_m2: Some([0, 1, 2].map(|row| [0, 1, 2].map(|column| t[(row, column)]))),
            centre_of_mass_m: Some(self.centre.into()),
            ..self.unspecified()
        };
        for (kind, span) in &self.loads {
            kind.add_to(&mut spec, span);
        }
        spec
    }

    /// The start alone.
    fn unspecified(&self) -> BodySpec {
        BodySpec {
            attitude: Some(wxyz(&self.attitude)),
            angular_velocity_rad_s: Some(self.rates.into()),
            position_m: Some(self.position.into()),
            velocity_m_s: Some(self.velocity.into()),
            gravity_m_s2: Some(self.gravity.into()),
            ..BodySpec::default()
        }
    }

    /// The same told in other body axes: `turn` takes components along the old to those along the new.
    pub fn in_axes(&self, turn: &UnitQuaternion<f64>) -> Self {
        let matrix = turn.to_rotation_matrix().into_inner();
        let tensor = matrix * self.tensor * matrix.transpose();
        Self {
            centre: turn * self.centre,
            tensor: (tensor + tensor.transpose()) * 0.5,
            attitude: self.attitude * turn.inverse(),
            rates: turn * self.rates,
            loads: self.loads.iter().map(|(kind, span)| (kind.in_axes(turn), *span)).collect(),
            ..self.clone()
        }
    }

    /// The same with the world turned, and all that is fixed in it.
    pub fn turned(&self, turn: &UnitQuaternion<f64>) -> Self {
        Self {
            attitude: turn * self.attitude,
            position: turn * self.position,
            velocity: turn * self.velocity,
            gravity: turn * self.gravity,
            loads: self.loads.iter().map(|(kind, span)| (kind.turned(turn), *span)).collect(),
            ..self.clone()
        }
    }

    pub fn rows(&self, times: &[f64]) -> Vec<Row> {
        rows(self.spec(), Path::new(""), times)
    }

    /// The rows, with how far one rounding of each number of the scene moves them: the sum over the tensor's elements, the
    /// rates, the attitude, a moment and a force that act always, position and velocity. And the size of what is recorded.
    pub fn room(&self, times: &[f64]) -> (Vec<Row>, Gap, Gap) {
        let plain = self.rows(times);
        let mut room = Gap::default();
        // Of a body that nothing pushes, no push is rounded, and its motion stays known in closed form.
        let is_free = self.loads.is_empty() && self.gravity == Vector3::zeros();
        for which in 0..if is_free { Self::NUDGES_OF_STARTS } else { Self::NUDGES } {
            let worst = Gap::worst(&plain, &rows(self.nudged(which), Path::new(""), times));
            room = Gap(std::array::from_fn(|i| room.0[i] + worst.0[i]));
        }
        let size = size(&plain);
        (plain, room, size)
    }

    const NUDGES: usize = 24;
    const NUDGES_OF_STARTS: usize = 18;

    fn nudged(&self, which: usize) -> BodySpec {
        const ELEMENTS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
        let unit = |axis: usize, size: f64| Vector3::ith(axis % 3, size * f64::EPSILON);
        let (norm, length) = (self.tensor.norm(), 1.0 + self.centre.norm());
        let mut case = self.clone();
        match which {
            0..6 => {
                let (row, column) = ELEMENTS[which];
                let element = self.tensor[(row, column)] + norm * f64::EPSILON;
                (case.tensor[(row, column)], case.tensor[(column, row)]) = (element, element);
            }
            6..9 => case.rates += unit(which, self.rates.norm()),
            9..12 => case.attitude = UnitQuaternion::from_scaled_axis(unit(which, 1.0)) * self.attitude,
            12..15 => case.position += unit(which, length + self.position.norm()),
            15..18 => case.velocity += unit(which, 1.0 + self.velocity.norm()),
            _ => {}
        }
        let mut spec = case.spec();
        let always = |moment_n_m| MomentSpec { moment_n_m, start_s: None, end_s: None };
        let push = self.push();
        match which {
            18..21 => spec.torque.constant_body.push(always(unit(which, push).into())),
            21..24 => {
                let gravity = self.gravity + unit(which, push / self.mass);
                spec.gravity_m_s2 = Some(gravity.into());
            }
            _ => {}
        }
        spec
    }

    /// How large moments and forces are.
    fn push(&self) -> f64 {
        self.tensor.norm() * self.rates.norm_squared() + self.loads.iter().map(|(kind, _)| kind.size()).sum::<f64>()
    }
}

/// One body as planned.
pub fn planned(spec: BodySpec, folder: &Path) -> PlannedBody {
    let scenario = Scenario {
        sample_times_s: Some(vec![0.0, 8.0]),
        folder: folder.to_owned(),
        body: vec![spec],
        ..Scenario::default()
    };
    Plan::new(&scenario).unwrap_or_else(|error| panic!("{error}")).bodies.remove(0)
}

/// What its recording reads.
pub fn rows(spec: BodySpec, folder: &Path, times: &[f64]) -> Vec<Row> {
    recorded(&planned(spec, folder), times)
}

/// What a recording of a planned body reads.
pub fn recorded(body: &PlannedBody, times: &[f64]) -> Vec<Row> {
    let channels = [
        Channel::Attitude,
        Channel::AngularVelocity,
        Channel::AngularMomentumWorld,
        Channel::Position,
        Channel::Velocity,
    ];
    let samples = body.sample(&channels, times).expect("a finite motion");
    let columns = |channel| samples.channel(channel).expect("watched");
    let vector =
        |channel, row: usize| Vector3::from_fn(|axis, _| columns(channel)[axis].get(row).copied().unwrap_or(0.0));
    let each = (0..times.len()).map(|row| {
        let [w, x, y, z] = [0, 1, 2, 3].map(|part| columns(Channel::Attitude)[part][row]);
        Row {
            attitude: UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z)),
            rates: vector(Channel::AngularVelocity, row),
            momentum: vector(Channel::AngularMomentumWorld, row),
            position: vector(Channel::Position, row),
            velocity: vector(Channel::Velocity, row),
        }
    });
    each.collect()
}

/// Mean squares of a uniform body about its centre, m²: needles and plates to a hundredth, some alike.
fn mean_squares() -> impl Strategy<Value = Vector3<f64>> {
    let edge = || decades(-1.0, 0.0);
    prop_oneof![3 => [edge(), edge(), edge()], 1 => (edge(), edge()).prop_map(|(a, b)| [a, a, b])]
        .prop_map(|edges| Vector3::from(edges.map(|edge| edge * edge)))
}

/// A body alone, nothing acting: any attitude of its axes, its centre off the origin.
pub fn bodies() -> impl Strategy<Value = (Vector3<f64>, UnitQuaternion<f64>, Case)> {
    let start = (attitude(), vector(-0.5, 0.5), vector(-1.0, 0.3), vector(-1.0, 0.3));
    (mean_squares(), attitude(), vector(-2.0, 0.3), decades(-0.5, 0.5), start).prop_map(
        |(squares, turn, centre, mass, (attitude, rates, position, velocity))| {
            let [x, y, z] = squares.into();
            let matrix = turn.to_rotation_matrix().into_inner();
            let tensor =
                matrix * Matrix3::from_diagonal(&(mass * Vector3::new(y + z, z + x, x + y))) * matrix.transpose();
            let tensor = (tensor + tensor.transpose()) * 0.5;
            let gravity = Vector3::zeros();
            (
                squares,
                turn,
                Case { mass, centre, tensor, attitude, rates, position, velocity, gravity, loads: Vec::new() },
            )
        },
    )
}

/// A body under one to three loads, now and then in uniform gravity.
pub fn case() -> impl Strategy<Value = Case> {
    let gravity = prop_oneof![2 => Just(Vector3::zeros()), 1 => vector(-1.0, 0.5)];
    (bodies(), kinds(), gravity).prop_map(|((squares, _, body), loads, gravity)| {
        let least = body.mass * (squares.sum() - squares.max());
        let loads = loads.into_iter().map(|(kind, span)| (kind.scaled(least, body.mass), span)).collect();
        Case { gravity, loads, ..body }
    })
}
