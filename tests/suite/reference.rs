//! The reference trajectories of `tests/reference`, read without losing digits.

use std::fs;
use std::path::{Path, PathBuf};

use polhode::body::{AngularVelocity, Attitude, PrincipalMoments, State};
use polhode::dynamics::Problem;
use polhode::numerics::DoubleDouble;
use serde_json::Value;

/// A case as its file states it. f64 inputs are exact; results hold 31 digits.
pub struct Case {
    pub name: String,
    pub moments: [f64; 3],
    pub mass: f64,
    pub q0: [f64; 4],
    pub q0_unit: [DoubleDouble; 4],
    pub omega0: [f64; 3],
    pub x0: [f64; 3],
    pub v0: [f64; 3],
    pub torques: Value,
    pub t_end: f64,
    pub samples: Vec<Sample>,
    /// What one rounding of the inputs does to the attitude, rad; NaN where the case does not say.
    pub floor_rad: f64,
    /// The same with one rounding of ω inside the run.
    pub floor_steps_rad: f64,
}

/// The motion at one time. Position and velocity are absent where nothing translates.
pub struct Sample {
    pub t: f64,
    pub q: [DoubleDouble; 4],
    pub omega: [DoubleDouble; 3],
    pub l_world: [DoubleDouble; 3],
    pub x: Option<[DoubleDouble; 3]>,
    pub v: Option<[DoubleDouble; 3]>,
}

/// Every case in `tests/reference` and `tests/reference/free`, by name of file.
pub fn cases() -> Vec<Case> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/reference");
    let mut paths = files(&folder);
    paths.extend(files(&folder.join("free")));
    assert!(!paths.is_empty(), "no reference cases in {}", folder.display());
    paths.iter().map(|path| case(path)).collect()
}

/// Every Lagrange top in `tests/reference/top`, by name of file.
pub fn tops() -> Vec<Case> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/reference/top");
    files(&folder).iter().map(|path| case(path)).collect()
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder of cases");
    let mut paths: Vec<_> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "json"));
    paths.sort();
    paths
}

fn case(path: &Path) -> Case {
    let text = fs::read_to_string(path).expect("a readable case");
    let value: Value = serde_json::from_str(&text).expect("JSON");
    let floor = |key: &str| value["conditioning"][key].as_f64().unwrap_or(f64::NAN);
    let or_zero = |key: &str| if value[key].is_null() { [0.0; 3] } else { numbers(&value[key]) };
    Case {
        name: value["name"].as_str().expect("a name").to_owned(),
        moments: numbers(&value["inertia"]),
        mass: value["mass"].as_f64().unwrap_or(1.0),
        q0: numbers(&value["q0"]),
        q0_unit: decimals(&value["q0_unit"]),
        omega0: numbers(&value["omega0_body"]),
        x0: or_zero("x0"),
        v0: or_zero("v0"),
        torques: value["torques"].clone(),
        t_end: value["t_end"].as_f64().expect("t_end"),
        samples: value["samples"].as_array().expect("samples").iter().map(sample).collect(),
        floor_rad: floor("f64_floor_rad"),
        floor_steps_rad: floor("f64_floor_steps_rad"),
    }
}

fn sample(value: &Value) -> Sample {
    Sample {
        t: value["t"].as_f64().expect("t"),
        q: decimals(&value["q"]),
        omega: decimals(&value["omega_body"]),
        l_world: decimals(&value["L_world"]),
        x: value.get("x").map(decimals),
        v: value.get("v").map(decimals),
    }
}

fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    std::array::from_fn(|i| value[i].as_f64().expect("a number"))
}

fn decimals<const N: usize>(value: &Value) -> [DoubleDouble; N] {
    std::array::from_fn(|i| decimal(value[i].as_str().expect("digits in quotes")))
}

/// A decimal such as `-0.0123e-4` to 31 digits.
pub fn decimal(text: &str) -> DoubleDouble {
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let mut exponent: i32 = exponent.parse().expect("an exponent");
    let (negative, mantissa) = mantissa.strip_prefix('-').map_or((false, mantissa), |rest| (true, rest));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    exponent -= i32::try_from(fraction.len()).expect("few digits");
    let digits = whole.to_owned() + fraction;
    let mut value = DoubleDouble::ZERO;
    for chunk in digits.as_bytes().chunks(15) {
        let chunk = std::str::from_utf8(chunk).expect("ASCII");
        let shift = (0..chunk.len()).fold(1.0, |power, _| power * 10.0);
        value = value * shift + DoubleDouble::from(chunk.parse::<f64>().expect("digits"));
    }
    let power = |of: f64| (0..exponent.abs()).fold(DoubleDouble::ONE, |product, _| product * of);
    value = if exponent < 0 { value / power(10.0) } else { value * power(10.0) };
    if negative { -value } else { value }
}

impl Case {
    /// The case as a problem without loads, at its own start.
    pub fn free_problem(&self) -> Problem {
        Problem {
            moments: PrincipalMoments::new(self.moments).expect("moments of a body"),
            mass: Some(self.mass),
            initial: State {
                attitude: Attitude::new(self.q0_unit.map(DoubleDouble::hi)).expect("a unit quaternion"),
                angular_velocity: AngularVelocity::new(self.omega0).expect("finite"),
                position: self.x0.into(),
                velocity: self.v0.into(),
            },
            loads: Vec::new(),
            gravity: nalgebra::Vector3::zeros(),
            wants_attitude: true,
            wants_translation: false,
        }
    }
}

impl Sample {
    /// Angle between this attitude and `q`, rad, however small.
    pub fn attitude_error(&self, q: [f64; 4]) -> f64 {
        let [a, b, c, d] = self.q;
        let [w, x, y, z] = q;
        let imaginary = [a * x - b * w - c * z + d * y, a * y + b * z - c * w - d * x, a * z - b * y + c * x - d * w];
        let real = (a * w + b * x + c * y + d * z).hi();
        2.0 * length(imaginary).atan2(real.abs())
    }

    /// |ω − this ω| over the size of this.
    pub fn omega_error(&self, omega: [f64; 3]) -> f64 {
        relative(self.omega, omega.map(DoubleDouble::from))
    }

    /// |L − this L| in world axes over the size of this, of a body with this attitude and ω.
    pub fn momentum_error(&self, moments: [f64; 3], q: [f64; 4], omega: [f64; 3]) -> f64 {
        let [w, x, y, z] = q.map(DoubleDouble::from);
        let l: [DoubleDouble; 3] = std::array::from_fn(|k| DoubleDouble::product(moments[k], omega[k]));
        let cross = |u: [DoubleDouble; 3], v: [DoubleDouble; 3]| {
            [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        };
        // v + 2 q × (q × v + w v), which needs no unit norm beyond rounding.
        let axis = [x, y, z];
        let first = cross(axis, l);
        let inner: [DoubleDouble; 3] = std::array::from_fn(|k| first[k] + w * l[k]);
        let outer = cross(axis, inner);
        relative(self.l_world, std::array::from_fn(|k| l[k] + outer[k].scale(2.0)))
    }
}

fn length(vector: [DoubleDouble; 3]) -> f64 {
    let [x, y, z] = vector.map(DoubleDouble::hi);
    (x * x + y * y + z * z).sqrt()
}

fn relative(truth: [DoubleDouble; 3], found: [DoubleDouble; 3]) -> f64 {
    let difference = length(std::array::from_fn(|k| found[k] - truth[k]));
    if difference == 0.0 { 0.0 } else { difference / length(truth) }
}
