//! Every load of a scene, at random: told in a scene, in other axes, in a turned world, from a later time on.

mod formulae;
mod telling;
mod turning;

use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use polhode::dynamics::Interpolation;
use proptest::prelude::*;

use crate::properties::starts::{attitude, decades, vector};
pub use turning::{begun, later};

type Vector = Vector3<f64>;

/// From when to when it acts, s, as a scene has it.
pub type Span = [Option<f64>; 2];

/// A load. Points are from the body's origin.
#[derive(Debug, Clone)]
pub enum Kind {
    ConstantBody(Vector),
    ConstantWorld(Vector),
    LinearDamping(f64),
    MomentumBrake(f64),
    Dipole {
        dipole: Vector,
        field: Vector,
    },
    Gradient {
        mean_motion: f64,
    },
    Table {
        rows: Vec<(f64, Vector)>,
        is_world: bool,
        interpolation: Interpolation,
        holds: bool,
        point: Option<Vector>,
    },
    ForceBody {
        force: Vector,
        point: Vector,
    },
    ForceWorld {
        force: Vector,
        point: Vector,
    },
    Thruster {
        direction: Vector,
        thrust: f64,
        point: Vector,
        pulses: Vec<[f64; 3]>,
    },
    Spring {
        anchor: Vector,
        point: Vector,
        stiffness: f64,
        rest: f64,
        damping: f64,
        is_tether: bool,
    },
    Drag {
        coefficient: f64,
        point: Vector,
    },
    QuadraticDamping(f64),
    Sphere {
        inertia: f64,
        coefficient: f64,
        relative: Vector,
    },
    Feedback {
        target: UnitQuaternion<f64>,
        stiffness: f64,
        damping: f64,
        limit: Option<f64>,
        dead_band: f64,
    },
    RateFeedback {
        gain: f64,
        limit: Option<f64>,
    },
    BDot {
        field: Vector,
        turning: Vector,
        gain: f64,
        limit: Option<f64>,
    },
    Rotor {
        axis: Vector,
        momenta: Vec<(f64, f64)>,
    },
    /// −A ω + b sin(ν t + φ) + Rᵀ w, body axes.
    FormulaBody {
        matrix: Matrix3<f64>,
        swing: Vector,
        beat: [f64; 2],
        world: Vector,
    },
    /// A R u + b sin(ν t + φ), world axes, u in the body.
    FormulaWorld {
        matrix: Matrix3<f64>,
        swing: Vector,
        beat: [f64; 2],
        body: Vector,
    },
    /// −k (x − a) − c v + b sin(ν t + φ), world axes, at a point.
    FormulaForce {
        pull: [f64; 2],
        anchor: Vector,
        swing: Vector,
        beat: [f64; 2],
        point: Vector,
    },
}

fn points() -> impl Strategy<Value = Vector> {
    vector(-1.5, 0.0)
}

fn limit() -> impl Strategy<Value = Option<f64>> {
    prop_oneof![Just(None), decades(-1.0, 0.5).prop_map(Some)]
}

fn matrix() -> impl Strategy<Value = Matrix3<f64>> {
    [vector(-1.5, 0.0), vector(-1.5, 0.0), vector(-1.5, 0.0)].prop_map(|columns| Matrix3::from_columns(&columns))
}

fn beat() -> impl Strategy<Value = [f64; 2]> {
    [0.3..3.0_f64, -3.0..3.0_f64]
}

/// Ascending from near 0 on, none closer than 0.2 s.
fn instants(count: std::ops::Range<usize>) -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(0.2..1.5_f64, count).prop_map(|steps| {
        let mut now = -0.5;
        steps
            .into_iter()
            .map(|step| {
                now += step;
                now
            })
            .collect()
    })
}

fn table() -> impl Strategy<Value = Kind> {
    let interpolation = prop_oneof![Just(Interpolation::Hold), Just(Interpolation::Linear), Just(Interpolation::Cubic)];
    let rows = instants(2..6).prop_flat_map(|times| {
        let count = times.len();
        (Just(times), prop::collection::vec(vector(-1.5, 0.3), count))
    });
    let point = prop_oneof![Just(None), points().prop_map(Some)];
    (rows, any::<bool>(), interpolation, any::<bool>(), point).prop_map(
        |((times, values), is_world, interpolation, holds, point)| {
            let rows = times.into_iter().zip(values).collect();
            Kind::Table { rows, is_world, interpolation, holds, point }
        },
    )
}

fn thruster() -> impl Strategy<Value = Kind> {
    (attitude(), decades(-1.5, 0.3), points(), instants(2..7), 0.2..1.0_f64).prop_map(
        |(turn, thrust, point, edges, share)| {
            let pairs = edges.windows(2).step_by(2).filter(|pair| pair[0] >= 0.0);
            let pulses = pairs.map(|pair| [pair[0], pair[1], share]).collect();
            Kind::Thruster { direction: turn * Vector::x(), thrust, point, pulses }
        },
    )
}

fn spring() -> impl Strategy<Value = Kind> {
    let damper = prop_oneof![Just(0.0), decades(-1.0, 0.0)];
    (vector(-0.3, 0.5), points(), decades(-0.5, 1.0), prop_oneof![Just(0.0), decades(-1.0, 0.0)], damper, any::<bool>())
        .prop_map(|(anchor, point, stiffness, rest, damping, is_tether)| {
            let damping = if is_tether { 0.0 } else { damping };
            Kind::Spring { anchor, point, stiffness, rest, damping, is_tether }
        })
}

fn rotor() -> impl Strategy<Value = Kind> {
    let momenta = prop::collection::vec(-1.0..1.0_f64, 6);
    (attitude(), instants(1..6), momenta).prop_map(|(turn, times, momenta)| Kind::Rotor {
        axis: turn * Vector::z(),
        momenta: times.into_iter().zip(momenta).collect(),
    })
}

fn listed() -> impl Strategy<Value = Kind> {
    let push = || vector(-1.5, 0.3);
    prop_oneof![
        push().prop_map(Kind::ConstantBody),
        push().prop_map(Kind::ConstantWorld),
        decades(-1.5, 0.0).prop_map(Kind::LinearDamping),
        decades(-1.5, 0.0).prop_map(Kind::MomentumBrake),
        (push(), vector(-1.0, 0.0)).prop_map(|(dipole, field)| Kind::Dipole { dipole, field }),
        decades(-1.0, 0.0).prop_map(|mean_motion| Kind::Gradient { mean_motion }),
        table(),
        (push(), points()).prop_map(|(force, point)| Kind::ForceBody { force, point }),
        (push(), points()).prop_map(|(force, point)| Kind::ForceWorld { force, point }),
        thruster(),
        rotor(),
    ]
}

fn general() -> impl Strategy<Value = Kind> {
    prop_oneof![
        spring(),
        (decades(-1.5, 0.0), points()).prop_map(|(coefficient, point)| Kind::Drag { coefficient, point }),
        decades(-1.5, 0.0).prop_map(Kind::QuadraticDamping),
        (0.1..0.7_f64, decades(-1.5, 0.0), vector(-1.0, 0.0))
            .prop_map(|(inertia, coefficient, relative)| Kind::Sphere { inertia, coefficient, relative }),
        (attitude(), decades(-1.0, 0.5), decades(-1.0, 0.3), limit(), prop_oneof![Just(0.0), decades(-2.0, -0.5)])
            .prop_map(|(target, stiffness, damping, limit, dead_band)| {
                Kind::Feedback { target, stiffness, damping, limit, dead_band }
            }),
        (decades(-1.0, 0.3), limit()).prop_map(|(gain, limit)| Kind::RateFeedback { gain, limit }),
        (vector(-0.5, 0.0), prop_oneof![Just(Vector::zeros()), vector(-1.0, 0.0)], decades(-1.0, 0.3), limit())
            .prop_map(|(field, turning, gain, limit)| Kind::BDot { field, turning, gain, limit }),
    ]
}

/// Formulae are read where scenes are.
fn formulae() -> impl Strategy<Value = Kind> {
    prop_oneof![
        (matrix(), vector(-1.5, 0.0), beat(), vector(-1.5, 0.0))
            .prop_map(|(matrix, swing, beat, world)| Kind::FormulaBody { matrix, swing, beat, world }),
        (matrix(), vector(-1.5, 0.0), beat(), vector(-1.5, 0.0))
            .prop_map(|(matrix, swing, beat, body)| Kind::FormulaWorld { matrix, swing, beat, body }),
        ([decades(-1.0, 0.5), decades(-1.0, 0.0)], vector(-0.5, 0.5), vector(-1.5, 0.0), beat(), points())
            .prop_map(|(pull, anchor, swing, beat, point)| Kind::FormulaForce { pull, anchor, swing, beat, point }),
    ]
}

fn span() -> impl Strategy<Value = Span> {
    prop_oneof![
        Just([None, None]),
        (0.0..2.0_f64, 0.3..3.0_f64).prop_map(|(start, length)| [Some(start), Some(start + length)]),
        (0.0..2.0_f64).prop_map(|start| [Some(start), None]),
        (0.3..4.0_f64).prop_map(|end| [None, Some(end)]),
    ]
}

/// One to three, of which at most one is a gravity gradient and one a sphere inside; in units of the body.
pub fn kinds() -> impl Strategy<Value = Vec<(Kind, Span)>> {
    let kind = if cfg!(feature = "serde") {
        prop_oneof![5 => listed().boxed(), 4 => general().boxed(), 3 => formulae().boxed()].boxed()
    } else {
        prop_oneof![5 => listed().boxed(), 4 => general().boxed()].boxed()
    };
    let load = (kind, span()).prop_map(|(kind, span)| {
        let span = if kind.has_span() { span } else { [None, None] };
        (kind, span)
    });
    prop::collection::vec(load, 1..4).prop_map(|mut loads| {
        let (mut orbits, mut spheres) = (0, 0);
        loads.retain(|(kind, _)| {
            orbits += u32::from(matches!(kind, Kind::Gradient { .. }));
            spheres += u32::from(matches!(kind, Kind::Sphere { .. }));
            match kind {
                Kind::Gradient { .. } => orbits == 1,
                Kind::Sphere { .. } => spheres == 1,
                _ => true,
            }
        });
        loads
    })
}
