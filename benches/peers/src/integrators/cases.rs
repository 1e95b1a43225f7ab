use polhode::scenario::{BodySpec, MomentSpec, PivotSpec, Plan, PlannedBody, Scenario, ScenarioError, TorqueSpecs};

/// A problem that both sides solve.
pub struct Case {
    pub name: &'static str,
    pub end_s: f64,
    pub moments: [f64; 3],
    /// World from body, w, x, y, z.
    pub attitude: [f64; 4],
    /// Body axes, rad/s.
    pub rates: [f64; 3],
    /// Constant, body axes, N m.
    pub moment: [f64; 3],
    /// m g l of gravity down −z at the body's z axis, N m.
    pub top: f64,
}

/// The outputs of every case, evenly to its end.
const OUTPUTS: u32 = 20;

pub fn all() -> [Case; 4] {
    let free = Case {
        name: "A: nearly about the middle axis, 60 s",
        end_s: 60.0,
        moments: [1.0, 2.0, 3.0],
        attitude: [1.0, 0.0, 0.0, 0.0],
        rates: [1e-3, 5.0, 1e-3],
        moment: [0.0; 3],
        top: 0.0,
    };
    let tumbling = Case { name: "B: tumbling, 1000 s", end_s: 1000.0, rates: [1.0, 2.0, 1.5], ..free };
    let tilt = 15_f64.to_radians();
    let top = Case {
        name: "C: Lagrange top, 20 s",
        end_s: 20.0,
        moments: [1.0, 1.0, 0.5],
        attitude: [tilt.cos(), tilt.sin(), 0.0, 0.0],
        rates: [0.0, 0.0, 20.0],
        top: 5.0,
        ..free
    };
    let driven = Case {
        name: "D: constant body torque, 100 s",
        end_s: 100.0,
        rates: [1.0, 2.0, 1.5],
        moment: [0.1, 0.2, -0.1],
        ..free
    };
    [free, tumbling, top, driven]
}

impl Case {
    pub fn times(&self) -> Vec<f64> {
        (1..=OUTPUTS).map(|index| self.end_s * f64::from(index) / f64::from(OUTPUTS)).collect()
    }

    /// w, x, y, z, then the rates.
    pub fn start(&self) -> [f64; 7] {
        let ([w, x, y, z], [p, q, r]) = (self.attitude, self.rates);
        [w, x, y, z, p, q, r]
    }

    /// About the body's axes: the constant one, and m g l e₃ × Rᵀ(−z) of gravity on a point of the z axis.
    pub fn moment_at(&self, [w, x, y, z, ..]: [f64; 7]) -> [f64; 3] {
        let ([m1, m2, m3], top) = (self.moment, self.top);
        [m1 + top * 2.0 * (y * z + w * x), m2 - top * 2.0 * (x * z - w * y), m3]
    }

    /// The equations of motion that peers without bodies of their own are given.
    pub fn derivative(&self, state: [f64; 7]) -> [f64; 7] {
        let [w, x, y, z, p, q, r] = state;
        let ([i1, i2, i3], [m1, m2, m3]) = (self.moments, self.moment_at(state));
        [
            0.5 * (-x * p - y * q - z * r),
            0.5 * (w * p + y * r - z * q),
            0.5 * (w * q + z * p - x * r),
            0.5 * (w * r + x * q - y * p),
            (m1 + (i2 - i3) * q * r) / i1,
            (m2 + (i3 - i1) * r * p) / i2,
            (m3 + (i1 - i2) * p * q) / i3,
        ]
    }

    /// As polhode plans it.
    pub fn body(&self) -> Result<PlannedBody, ScenarioError> {
        let mut body = BodySpec {
            principal_moments_kg_m2: Some(self.moments),
            attitude: Some(self.attitude),
            angular_velocity_rad_s: Some(self.rates),
            ..BodySpec::default()
        };
        if self.moment != [0.0; 3] {
            let constant = MomentSpec { moment_n_m: self.moment, start_s: None, end_s: None };
            body.torque = TorqueSpecs { constant_body: vec![constant], ..TorqueSpecs::default() };
        }
        if self.top != 0.0 {
            body.mass_kg = Some(1.0);
            body.centre_of_mass_m = Some([0.0, 0.0, 0.5]);
            body.gravity_m_s2 = Some([0.0, 0.0, -2.0 * self.top]);
            body.pivot = Some(PivotSpec { inertia_about_pivot: true, ..PivotSpec::default() });
        }
        let scene = Scenario {
            duration_s: Some(self.end_s),
            sample_every_s: Some(self.end_s / f64::from(OUTPUTS)),
            body: vec![body],
            ..Scenario::default()
        };
        Ok(Plan::new(&scene)?.bodies.swap_remove(0))
    }
}
