use super::case::{Case, body};
use crate::scenario::BodySpec;

/// Three different moments, kg m².
const MOMENTS: [f64; 3] = [1.0, 1.7, 2.4];
/// A tumbling, rad/s.
const RATES: [f64; 3] = [1.0, 2.0, 1.5];
/// s: some eight turns.
const SPAN: f64 = 20.0;

/// Bodies that nothing acts on.
pub(super) fn cases() -> Vec<Case> {
    let groups = [
        ("shapes", shapes()),
        ("middle axis", separatrices()),
        ("frames", frames()),
        ("units", units()),
        ("long spans", long()),
    ];
    groups.into_iter().flat_map(|(name, cases)| Case::grouped(name, cases)).collect()
}

fn shapes() -> Vec<Case> {
    let case = |key, title, span, moments, rates| Case::new(key, title, span, body(moments, rates));
    vec![
        case("tumbling", "three moments, no axis near", SPAN, MOMENTS, RATES),
        case("sphere", "three equal moments", SPAN, [1.7; 3], RATES),
        case("near_sphere", "moments equal to 1e-6", SPAN, [1.0, 1.000_000_5, 1.000_001], RATES),
        case("near_sphere_ulp", "moments equal to one rounding", SPAN, [1.0, 1.0 + f64::EPSILON, 1.0], RATES),
        case("symmetric", "two equal moments", SPAN, [1.0, 1.0, 1.6], RATES),
        case("needle", "I₃/I₁ = 1e-6", 0.5, [1e-6, 1.0, 1.000_000_5], [300.0, 1.0, 1.5]),
        case("needle_1e-12", "I₃/I₁ = 1e-12", 0.5, [1e-12, 1.0, 1.0], [300.0, 1.0, 1.5]),
        case("lamina", "I₃ = I₁ + I₂ exactly", SPAN, [1.0, 2.0, 3.0], RATES),
        case("rest", "no rates", SPAN, MOMENTS, [0.0; 3]),
        case("principal_axis", "steady spin about the largest moment", SPAN, MOMENTS, [0.0, 0.0, 3.0]),
    ]
}

/// Near the middle axis of 1, 2, 3 kg m², or exactly on it, or on the separatrix: 2·3·ω₁² = 6·1·ω₃² holds exactly.
fn separatrices() -> Vec<Case> {
    let near = |key, title, span, off: f64| Case::new(key, title, span, body([1.0, 2.0, 3.0], [off, 5.0, off]));
    vec![
        near("middle_1e-3", "1e-3 rad/s from the middle axis", 20.0, 1e-3),
        near("middle_1e-6", "1e-6 rad/s from the middle axis", 14.0, 1e-6),
        near("middle_1e-9", "1e-9 rad/s from the middle axis", 12.0, 1e-9),
        near("middle_1e-12", "1e-12 rad/s from the middle axis", 14.0, 1e-12),
        near("middle_1e-300", "1e-300 rad/s from the middle axis", 20.0, 1e-300),
        near("middle_axis", "on the middle axis exactly", 20.0, 0.0),
        Case::new("separatrix", "on the separatrix exactly", 12.0, body([2.0, 5.0, 6.0], [1.0, 2.0, 1.0])),
    ]
}

/// The same physics in other axes.
fn frames() -> Vec<Case> {
    let tensor = |inertia: [[f64; 3]; 3], rates| BodySpec {
        inertia_kg_m2: Some(inertia),
        principal_moments_kg_m2: None,
        ..body(MOMENTS, rates)
    };
    // 1 + n nᵀ with n = (1, 2, 2)/3: the two equal moments leave their axes open.
    let [a, b, c] = [1.0 / 9.0, 2.0 / 9.0, 4.0 / 9.0];
    let tilted = [[1.0 + a, b, b], [b, 1.0 + c, c], [b, c, 1.0 + c]];
    let products = [[1.3, -0.2, 0.1], [-0.2, 1.9, 0.3], [0.1, 0.3, 2.1]];
    // MuJoCo issue 3553: stable as it stands, unstable written as a fixed child, which is to say turned.
    let mujoco = [1.7231e-4, 6.58e-6, 1.7243e-4];
    let [p, q, r] = mujoco;
    // Turned by 90° and by 45° about axes: sums and differences only.
    let [mean, half] = [0.5 * (p + q), 0.5 * (p - q)];
    let turned = [[mean, half, 0.0], [half, mean, 0.0], [0.0, 0.0, r]];
    vec![
        Case::new("tilted_symmetric", "two equal moments in a tilted frame", SPAN, tensor(tilted, RATES)),
        Case::new("products", "products of inertia", SPAN, tensor(products, RATES)),
        Case::new("unsorted", "moments out of order, an odd permutation", SPAN, body([1.7, 1.0, 2.4], RATES)),
        Case::new(
            "mujoco_3553",
            "a rod's inertia that a physics engine blew up on",
            12.0,
            body(mujoco, [2.0, 9.0, 1.0]),
        ),
        Case::new("mujoco_3553_turned", "the same written in turned axes", 12.0, tensor(turned, [2.0, 9.0, 1.0])),
    ]
}

/// The same motion in units that try f64.
fn units() -> Vec<Case> {
    let scaled = |key, title, inertia: f64, rate: f64| {
        let span = (SPAN / rate).min(9e9);
        Case::new(key, title, span, body(MOMENTS.map(|moment| moment * inertia), RATES.map(|value| value * rate)))
    };
    vec![
        scaled("slow", "1e-9 rad/s, for 9e9 s", 1.0, 1e-9),
        scaled("fast", "1e6 rad/s", 1.0, 1e6),
        scaled("moments_1e-12", "moments of 1e-12 kg m²", 1e-12, 1.0),
        scaled("moments_1e12", "moments of 1e12 kg m²", 1e12, 1.0),
        scaled("moments_1e-59", "moments near the least allowed", 1e-59, 1.0),
        scaled("moments_1e59", "moments near the largest allowed", 4e59, 1.0),
        scaled("moments_1e-300", "moments of 1e-300 kg m²", 1e-300, 1.0),
        scaled("moments_1e300", "moments of 1e300 kg m²", 1e300, 1.0),
        scaled("denormal_moments", "moments below the smallest normal number", 1e-310, 1.0),
        scaled("denormal_rates", "rates below the smallest normal number", 1.0, 1e-310),
        scaled("rates_1e-160", "rates whose squares are denormal", 1.0, 1e-160),
        Case::new("fast_1e9", "1e9 rad/s", 1.3e-7, body(MOMENTS, RATES.map(|value| value * 1e9))),
        Case::new(
            "rates_1e6_9e9_s",
            "5e15 rad: near the largest angle allowed",
            9e9,
            body(MOMENTS, RATES.map(|value| value * 2e5)),
        ),
        Case::new("rates_1e160", "rates whose squares overflow", 1.0, body(MOMENTS, RATES.map(|value| value * 1e160))),
        Case::new("rates_1e300", "rates near the largest number", 1.0, body(MOMENTS, RATES.map(|value| value * 1e300))),
    ]
}

fn long() -> Vec<Case> {
    let case = |key, title, span, moments, rates| Case::new(key, title, span, body(moments, rates)).long();
    vec![
        case("tumbling_1000", "a thousand turns and more", 2.5e3, MOMENTS, RATES),
        case("tumbling_1e6_s", "a million s", 1e6, MOMENTS, RATES),
        case("tumbling_1e8_steps", "1e8 steps, 64 to a turn", 3_646_000.0, MOMENTS, RATES).paced(64),
        case("tumbling_1e9_s", "1e9 s", 1e9, MOMENTS, RATES),
        case("symmetric_1e9_s", "two equal moments for 1e9 s", 1e9, [1.0, 1.0, 1.6], RATES),
        case("needle_1e9_s", "I₃/I₁ = 1e-6 for 1e9 s", 1e9, [1e-6, 1.0, 1.000_000_5], [300.0, 1.0, 1.5]),
        case("middle_1e-3_1e9_s", "1e-3 rad/s from the middle axis for 1e9 s", 1e9, [1.0, 2.0, 3.0], [1e-3, 5.0, 1e-3]),
    ]
}
