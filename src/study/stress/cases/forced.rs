use super::case::{Case, body};
use crate::scenario::{BodySpec, BrakeSpec, DampingSpec, GravityGradientSpec, MomentSpec, PivotSpec, TorqueSpecs};

/// Three different moments, kg m².
const MOMENTS: [f64; 3] = [1.0, 1.7, 2.4];
/// A tumbling, rad/s.
const RATES: [f64; 3] = [1.0, 2.0, 1.5];
/// s: some eight turns.
const SPAN: f64 = 20.0;

/// Bodies that something acts on.
pub(super) fn cases() -> Vec<Case> {
    let groups =
        [("torques", torques()), ("tops", tops()), ("extreme loads", extremes()), ("long, with loads", long())];
    groups.into_iter().flat_map(|(name, cases)| Case::grouped(name, cases)).collect()
}

fn moment(moment_n_m: [f64; 3]) -> MomentSpec {
    MomentSpec { moment_n_m, start_s: None, end_s: None }
}

fn pulse(moment_n_m: [f64; 3], start: f64, end: f64) -> MomentSpec {
    MomentSpec { moment_n_m, start_s: Some(start), end_s: Some(end) }
}

fn damping(coefficient: f64) -> TorqueSpecs {
    let damping = DampingSpec { coefficient_n_m_s: coefficient, start_s: None, end_s: None };
    TorqueSpecs { linear_damping: vec![damping], ..TorqueSpecs::default() }
}

fn in_body(moments: Vec<MomentSpec>) -> TorqueSpecs {
    TorqueSpecs { constant_body: moments, ..TorqueSpecs::default() }
}

fn in_world(moments: Vec<MomentSpec>) -> TorqueSpecs {
    TorqueSpecs { constant_world: moments, ..TorqueSpecs::default() }
}

fn brake(rate: f64) -> TorqueSpecs {
    let brake = BrakeSpec { rate_per_s: rate, start_s: None, end_s: None };
    TorqueSpecs { momentum_brake: vec![brake], ..TorqueSpecs::default() }
}

fn gradient(mean_motion: f64) -> TorqueSpecs {
    let gradient = GravityGradientSpec { mean_motion_rad_s: mean_motion, start_s: None, end_s: None };
    TorqueSpecs { gravity_gradient: vec![gradient], ..TorqueSpecs::default() }
}

fn under(key: &'static str, title: &'static str, span: f64, rates: [f64; 3], torque: TorqueSpecs) -> Case {
    Case::new(key, title, span, BodySpec { torque, ..body(MOMENTS, rates) })
}

fn torques() -> Vec<Case> {
    let short = pulse([40.0, -30.0, 20.0], 7.3, 7.300_001);
    let train = (0..8).map(|n| 2.4 * f64::from(n) + 0.37).map(|start| pulse([0.3, -0.2, 0.1], start, start + 0.01));
    let (middle, orbit) = ([1e-6, 5.0, 1e-6], gradient(1.1e-3));
    vec![
        under("body_torque", "a constant torque in body axes", SPAN, RATES, in_body(vec![moment([0.1, 0.2, -0.1])])),
        under("world_torque", "a constant torque in world axes", SPAN, RATES, in_world(vec![moment([0.1, 0.2, -0.1])])),
        under(
            "middle_torque",
            "near the middle axis, under a torque",
            8.0,
            middle,
            in_body(vec![moment([0.0, 0.1, 0.0])]),
        ),
        under("pulse", "a pulse of 1 µs", 15.0, RATES, in_body(vec![short])),
        under("pulse_train", "eight pulses of 10 ms", SPAN, RATES, in_body(train.collect())),
        under("brake", "a brake along L", SPAN, RATES, brake(0.05)),
        under("brake_hard", "a brake along L that stops the body at once", SPAN, RATES, brake(1e3)),
        under("damping", "linear damping", SPAN, RATES, damping(0.05)),
        under("damping_stiff", "linear damping of 1e3 /s", 5.0, RATES, damping(1e3)),
        under(
            "axial_torque",
            "a torque along a steady spin",
            SPAN,
            [0.0, 0.0, 3.0],
            in_body(vec![moment([0.0, 0.0, 0.2])]),
        ),
        under("from_rest", "a torque on a body at rest", 20.0, [0.0; 3], in_body(vec![moment([0.1, 0.2, -0.1])])),
        under("gravity_gradient", "libration on an orbit", 20e3, [0.0, 1e-4, 1.2e-3], orbit.clone()),
        under("gradient_tumbling", "a fast tumbling on an orbit", SPAN, RATES, orbit),
    ]
}

/// Tops about a pivot: I₁ = I₂ = 1, I₃ = 0.5 kg m², m g l = 5 N m, tilted by an angle in the x-z plane.
fn tops() -> Vec<Case> {
    let top = |key, title, span, tilt: f64, rates: [f64; 3], moments: [f64; 3]| {
        let spec = BodySpec {
            attitude: Some([libm::cos(0.5 * tilt), 0.0, libm::sin(0.5 * tilt), 0.0]),
            gravity_m_s2: Some([0.0, 0.0, -10.0]),
            centre_of_mass_m: Some([0.0, 0.0, 0.5]),
            pivot: Some(PivotSpec { position_m: [0.0; 3], inertia_about_pivot: true }),
            ..body(moments, rates)
        };
        Case::new(key, title, span, spec)
    };
    let round = [1.0, 1.0, 0.5];
    vec![
        top("top", "Lagrange's top", 10.0, 0.5, [0.0, 0.0, 20.0], round),
        top("top_sleeping", "a sleeping top", 10.0, 0.0, [0.0, 0.0, 20.0], round),
        top("top_just_unstable", "upright and slow, 1e-6 rad off", 4.0, 1e-6, [0.0, 0.0, 8.0], round),
        top("top_homoclinic", "upright, slow, 1e-12 rad off", 20.0, 1e-12, [0.0, 0.0, 4.0], round),
        top("top_hanging", "hanging at rest, almost", 10.0, std::f64::consts::PI - 6.5e-7, [0.0, 0.0, 1e-3], round),
        top("top_not_round", "moments unequal to 10 %: no closed form", 10.0, 0.5, [0.0, 0.0, 20.0], [1.0, 1.1, 0.5]),
        top("top_chaotic", "a heavy body that tumbles", 6.0, 2.0, [1.0, 2.0, 3.0], [1.0, 1.4, 0.5]),
    ]
}

fn extremes() -> Vec<Case> {
    let tiny = in_body(vec![moment([1e-300, 2e-300, -1e-300])]);
    vec![
        under("torque_1e-300", "a torque too small to act", SPAN, RATES, tiny),
        under("torque_1e9", "a torque of 1e9 N m", 1e-4, RATES, in_body(vec![moment([1e9, 2e9, -1e9])])),
        under("torque_1e100", "a torque of 1e100 N m", 1.0, RATES, in_world(vec![moment([1e100, 0.0, 0.0])])),
        under("torque_1e300", "a torque of 1e300 N m", 1.0, RATES, in_body(vec![moment([1e300, 2e300, -1e300])])),
        under("damping_1e15", "damping of 1e15 N m s", 1.0, RATES, damping(1e15)),
        under("gradient_1e9", "an orbit of 1e9 rad/s", 1.3e-7, RATES, gradient(1e9)),
        under(
            "late_torque",
            "a torque of 1e30 N m that starts late",
            9.0,
            RATES,
            in_body(vec![pulse([1e30, 0.0, 0.0], 5.0, 6.0)]),
        ),
    ]
}

fn long() -> Vec<Case> {
    vec![
        under(
            "world_torque_1e4_s",
            "a constant torque in world axes for 1e4 s",
            1e4,
            RATES,
            in_world(vec![moment([1e-3, 2e-3, -1e-3])]),
        )
        .long(),
        under("gradient_1000", "a thousand orbits", 5.7e6, [0.0, 1e-4, 1.2e-3], gradient(1.1e-3)).long(),
    ]
}
