/// A quantity that can be watched. Its name, unit, frame and width stand in one table, [`Channel::row`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Channel {
    /// World from body, quaternion w, x, y, z.
    Attitude,
    /// ω in body axes.
    AngularVelocity,
    /// ω in world axes.
    AngularVelocityWorld,
    /// L in world axes, about the reference point.
    AngularMomentumWorld,
    /// L in body axes, about the reference point.
    AngularMomentumBody,
    /// τ in body axes, about the reference point.
    MomentBody,
    /// τ in world axes, about the reference point.
    MomentWorld,
    /// Position of the reference point in world axes.
    Position,
    /// Velocity of the reference point in world axes.
    Velocity,
    /// Net force in world axes.
    ForceWorld,
    /// ω · Iω / 2 about the reference point (about a fixed pivot: all of the kinetic energy).
    RotationalEnergy,
    /// m v² / 2.
    TranslationalEnergy,
    /// Of the forces that have a potential.
    PotentialEnergy,
    /// Kinetic and potential energy; the Jacobi integral on a circular orbit.
    TotalEnergy,
    /// Change of the total energy since t = 0, relative, in 1e-15.
    EnergyDrift,
    /// How far L is from what its law says, relative, in 1e-15.
    MomentumDrift,
    /// How far the energy ellipsoid is from rolling on the invariable plane without slipping, relative, in 1e-15: the
    /// speed of the body's point that touches the plane, in units of |ω| times its distance from the centre.
    Slip,
    /// Angle between the body's axis and what it leans from, as [`FigureAxis`](super::FigureAxis) says, 0 to π.
    Tilt,
    /// Rate at which the same axis goes round the same reference; 0 where it lies along it.
    PrecessionRate,
    /// Euler angles of the attitude about body axes z, x, z: see [`EulerSequence`](super::EulerSequence).
    EulerZxz,
    /// The same about z, y, z.
    EulerZyz,
    /// The same about z, y, x: yaw, pitch, roll.
    EulerZyx,
    /// The same about x, y, z.
    EulerXyz,
    /// Precession, nutation and spin of the axis of figure, as [`FigureFrame`](super::FigureFrame) says.
    FigureAngles,
    /// The rates of change of these.
    FigureRates,
    /// Angle between L and the principal axis that L goes round at first, 0 to π.
    MomentumTilt,
    /// How far round its polhode ω is: the amplitude of the elliptic functions that ω is made of, −π to π.
    PolhodePhase,
    /// 2 T I₂ / L² − 1, T the rotational energy and I₂ the middle moment: 0 on the separatrix, above it round the axis of
    /// the least moment, below it round that of the greatest.
    SeparatrixDistance,
    /// Of rotation and of translation together.
    KineticEnergy,
    /// ½ ω·Iω + 3/2 n² r·Ir − n `L_z`, on a circular orbit of mean motion n, whatever else acts.
    JacobiIntegral,
    /// |(ω₁ + iω₂)² + (a₁ + ia₂)(f₁ + if₂)/I₃|², of a top of moments 2, 2, 1 that the force f pulls at the arm a.
    KovalevskayaIntegral,
    /// Acceleration of the reference point, or of a body's point, in world axes.
    Acceleration,
    /// The position's components along body axes, from the world's origin.
    PositionBody,
    /// The velocity's components along body axes.
    VelocityBody,
    /// The acceleration's components along body axes.
    AccelerationBody,
    /// ω in the axes of an IMU.
    Gyroscope,
    /// Acceleration less gravity, the specific force, where an IMU is, in its axes.
    Accelerometer,
}

/// One row of the table of channels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Row {
    /// As it is asked for in scenes and flags, and named in recordings.
    pub name: &'static str,
    /// As a plot's title says it, with frame.
    pub title: &'static str,
    /// As people read it.
    pub unit: &'static str,
    /// As names carry it (`rad_s`); empty for a number without unit.
    pub unit_suffix: &'static str,
    /// What each column is called; a single empty one for a scalar.
    pub components: &'static [&'static str],
}

impl Row {
    /// The header of column `index`: name, component, unit (`angular_velocity_x_rad_s`).
    #[must_use]
    pub fn column_name(&self, index: usize) -> String {
        let parts = [self.name, self.components[index], self.unit_suffix];
        parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join("_")
    }
}

const QUATERNION: &[&str] = &["w", "x", "y", "z"];
const VECTOR: &[&str] = &["x", "y", "z"];
const SCALAR: &[&str] = &[""];
const EULER: &[&str] = &["first", "second", "third"];
const FIGURE: &[&str] = &["precession", "nutation", "spin"];

impl Channel {
    /// Every channel, in the order in which recordings hold them.
    pub const ALL: [Self; 37] = [
        Self::Attitude,
        Self::AngularVelocity,
        Self::AngularVelocityWorld,
        Self::AngularMomentumWorld,
        Self::AngularMomentumBody,
        Self::MomentBody,
        Self::MomentWorld,
        Self::Position,
        Self::Velocity,
        Self::ForceWorld,
        Self::RotationalEnergy,
        Self::TranslationalEnergy,
        Self::PotentialEnergy,
        Self::TotalEnergy,
        Self::EnergyDrift,
        Self::MomentumDrift,
        Self::Slip,
        Self::Tilt,
        Self::PrecessionRate,
        Self::EulerZxz,
        Self::EulerZyz,
        Self::EulerZyx,
        Self::EulerXyz,
        Self::FigureAngles,
        Self::FigureRates,
        Self::MomentumTilt,
        Self::PolhodePhase,
        Self::SeparatrixDistance,
        Self::KineticEnergy,
        Self::JacobiIntegral,
        Self::KovalevskayaIntegral,
        Self::Acceleration,
        Self::PositionBody,
        Self::VelocityBody,
        Self::AccelerationBody,
        Self::Gyroscope,
        Self::Accelerometer,
    ];

    /// Name, title, unit and components.
    #[must_use]
    pub const fn row(self) -> Row {
        let (name, title, unit, unit_suffix, components) = match self {
            Self::Attitude => ("attitude", "attitude, world from body", "1", "", QUATERNION),
            Self::AngularVelocity => ("angular_velocity", "ω in body axes", "rad/s", "rad_s", VECTOR),
            Self::AngularVelocityWorld => ("angular_velocity_world", "ω in world axes", "rad/s", "rad_s", VECTOR),
            Self::AngularMomentumWorld => ("angular_momentum_world", "L in world axes", "N m s", "n_m_s", VECTOR),
            Self::AngularMomentumBody => ("angular_momentum_body", "L in body axes", "N m s", "n_m_s", VECTOR),
            Self::MomentBody => ("moment_body", "τ in body axes", "N m", "n_m", VECTOR),
            Self::MomentWorld => ("moment_world", "τ in world axes", "N m", "n_m", VECTOR),
            Self::Position => ("position", "position in world axes", "m", "m", VECTOR),
            Self::Velocity => ("velocity", "velocity in world axes", "m/s", "m_s", VECTOR),
            Self::ForceWorld => ("force_world", "force in world axes", "N", "n", VECTOR),
            Self::RotationalEnergy => ("rotational_energy", "rotational energy", "J", "j", SCALAR),
            Self::TranslationalEnergy => ("translational_energy", "translational energy", "J", "j", SCALAR),
            Self::PotentialEnergy => ("potential_energy", "potential energy", "J", "j", SCALAR),
            Self::TotalEnergy => ("total_energy", "total energy", "J", "j", SCALAR),
            Self::EnergyDrift => ("energy_drift", "energy drift", "1e-15", "per_1e15", SCALAR),
            Self::MomentumDrift => ("momentum_drift", "momentum drift", "1e-15", "per_1e15", SCALAR),
            Self::Slip => ("slip", "slip of the energy ellipsoid on the invariable plane", "1e-15", "per_1e15", SCALAR),
            Self::Tilt => ("tilt", "tilt of the axis", "rad", "rad", SCALAR),
            Self::PrecessionRate => ("precession_rate", "precession rate of the axis", "rad/s", "rad_s", SCALAR),
            Self::EulerZxz => ("euler_zxz", "Euler angles about z, x, z", "rad", "rad", EULER),
            Self::EulerZyz => ("euler_zyz", "Euler angles about z, y, z", "rad", "rad", EULER),
            Self::EulerZyx => ("euler_zyx", "Euler angles about z, y, x", "rad", "rad", EULER),
            Self::EulerXyz => ("euler_xyz", "Euler angles about x, y, z", "rad", "rad", EULER),
            Self::FigureAngles => ("figure_angles", "angles of the axis of figure", "rad", "rad", FIGURE),
            Self::FigureRates => ("figure_rates", "rates of the axis of figure", "rad/s", "rad_s", FIGURE),
            Self::MomentumTilt => ("momentum_tilt", "tilt of the axis from L", "rad", "rad", SCALAR),
            Self::PolhodePhase => ("polhode_phase", "phase on the polhode", "rad", "rad", SCALAR),
            Self::SeparatrixDistance => ("separatrix_distance", "distance from the separatrix", "1", "", SCALAR),
            Self::KineticEnergy => ("kinetic_energy", "kinetic energy", "J", "j", SCALAR),
            Self::JacobiIntegral => ("jacobi_integral", "Jacobi's integral", "J", "j", SCALAR),
            Self::KovalevskayaIntegral => {
                ("kovalevskaya_integral", "Kovalevskaya's integral", "rad⁴/s⁴", "rad4_s4", SCALAR)
            }
            Self::Acceleration => ("acceleration", "acceleration in world axes", "m/s²", "m_s2", VECTOR),
            Self::PositionBody => ("position_body", "position in body axes", "m", "m", VECTOR),
            Self::VelocityBody => ("velocity_body", "velocity in body axes", "m/s", "m_s", VECTOR),
            Self::AccelerationBody => ("acceleration_body", "acceleration in body axes", "m/s²", "m_s2", VECTOR),
            Self::Gyroscope => ("gyroscope", "gyroscope, ω in its own axes", "rad/s", "rad_s", VECTOR),
            Self::Accelerometer => {
                ("accelerometer", "accelerometer, specific force in its own axes", "m/s²", "m_s2", VECTOR)
            }
        };
        Row { name, title, unit, unit_suffix, components }
    }

    /// How many columns.
    #[must_use]
    pub const fn width(self) -> usize {
        self.row().components.len()
    }

    /// Whether it is angles that come round: values apart by 2π are the same.
    #[must_use]
    pub const fn comes_round(self) -> bool {
        matches!(
            self,
            Self::EulerZxz | Self::EulerZyz | Self::EulerZyx | Self::EulerXyz | Self::FigureAngles | Self::PolhodePhase
        )
    }

    /// The channel of that name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|channel| channel.row().name == name)
    }
}
