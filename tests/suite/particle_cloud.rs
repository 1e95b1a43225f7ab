//! Particles on springs.
use std::sync::Arc;

use nalgebra::Vector3;
use polhode::body::{AngularVelocity, Attitude, Particle, ParticleCloud, State};
use polhode::dynamics::{General, GeneralLoad, Load, Problem, SpringCloud, Springs, Torque, Window};
use polhode::propagation::{FreeRotation, PreciseTaylor, Propagator, States, Taylor, attitude_distance, attitude_distances};

use crate::motions::{grid, row, run};

fn particles() -> ParticleCloud {
    let at = |mass, [x, y, z]: [f64; 3]| Particle { mass, position: Vector3::new(x, y, z) };
    ParticleCloud::new(vec![
        at(0.06, [0.0, 0.05, 0.03]),
        at(0.06, [0.0, -0.05, 0.03]),
        at(0.05, [0.0, 0.0, -0.04]),
        at(0.03, [0.02, 0.0, 0.03]),
        at(0.03, [-0.02, 0.0, 0.03]),
    ])
    .unwrap()
}

fn problem(springs: Option<Springs>) -> Problem {
    let cloud = particles();
    let body = cloud.mass_properties().unwrap();
    let loads = springs.map(|springs| {
        let kind = General::Cloud(SpringCloud::new(&cloud, &body, springs).unwrap());
        Load { torque: Torque::General(Arc::new(GeneralLoad::new(kind))), window: Window::ALWAYS }
    });
    Problem {
        moments: body.moments,
        mass: body.mass,
        initial: State {
            attitude: Attitude::from_world_from_body(nalgebra::UnitQuaternion::from_scaled_axis(Vector3::new(0.3, 1.1, -0.7))),
            angular_velocity: AngularVelocity::from_vector(Vector3::new(0.04, 0.0, 4.0)),
            position: Vector3::zeros(),
            velocity: Vector3::zeros(),
        },
        loads: loads.into_iter().collect(),
        gravity: Vector3::zeros(),
        wants_attitude: true,
        wants_translation: false,
    }
}

#[test]
fn explore() {
    let times = grid(20.0, 200);
    let rigid = run(FreeRotation::new(&problem(None)).unwrap(), &times);
    println!("moments {:?}", problem(None).moments);
    for relaxed in [false, true] {
        for k in [100.0, 400.0, 1600.0, 6400.0] {
            let p = problem(Some(Springs { stiffness: k, damping: 0.0, is_relaxed: relaxed }));
            let [lo, hi] = p.cloud().unwrap().natural_frequencies();
            let mut t = Taylor::new(&p, 1e-16).unwrap();
            let mut s = States::default();
            let start = std::time::Instant::now();
            t.fill(&times, &mut s).unwrap();
            let el = start.elapsed();
            let e = attitude_distance(&rigid, &s);
            let at2: Vec<f64> = attitude_distances(&rigid, &s).collect();
            println!("k {k} relaxed {relaxed} freq {lo} {hi} steps {} order {} time {el:?} err {e:e} at 2 s {:e} {:e}", t.effort().steps, t.order(), at2[20], at2[200]);
            let en = |i: usize| s.cloud.kinetic_energy[i] + s.cloud.elastic_energy[i];
            let drift = (0..times.len()).map(|i| (en(i) / en(0) - 1.0).abs()).fold(0.0, f64::max);
            let l = |i: usize| {
                let q = nalgebra::UnitQuaternion::new_unchecked(nalgebra::Quaternion::new(s.attitude[0][i], s.attitude[1][i], s.attitude[2][i], s.attitude[3][i]));
                let w = Vector3::from(row(&s.angular_velocity, i));
                q * p.moments.vector().component_mul(&w)
            };
            let ld = (0..times.len()).map(|i| (l(i) - l(0)).norm() / l(0).norm()).fold(0.0, f64::max);
            let net = (0..times.len()).map(|i| {
                let f: Vec<Vector3<f64>> = s.cloud.particles.iter().map(|p| Vector3::from(row(&p.force, i))).collect();
                let x: Vec<Vector3<f64>> = s.cloud.particles.iter().map(|p| Vector3::from(row(&p.arm, i))).collect();
                let g: f64 = f.iter().map(|f| f.norm()).sum();
                let sum: Vector3<f64> = f.iter().sum();
                let t: Vector3<f64> = f.iter().zip(&x).map(|(f, x)| x.cross(f)).sum();
                let gt: f64 = f.iter().zip(&x).map(|(f, x)| x.norm() * f.norm()).sum();
                if g == 0.0 { [0.0, 0.0] } else { [sum.norm() / g, t.norm() / gt] }
            }).fold([0.0_f64, 0.0], |a, b| [a[0].max(b[0]), a[1].max(b[1])]);
            println!("    energy drift {drift:e} L {ld:e} net {net:?} elastic/kin {:e}", s.cloud.elastic_energy[100]/s.cloud.kinetic_energy[100]);
        }
    }
    let p = problem(Some(Springs { stiffness: 400.0, damping: 0.0, is_relaxed: false }));
    let s = run(Taylor::new(&p, 1e-16).unwrap(), &times);
    let start = std::time::Instant::now();
    let mut e = PreciseTaylor::new(&p).unwrap();
    let mut other = e.clone().with_tolerance(1e-30);
    for (i, t) in times.iter().enumerate().step_by(50) {
        let x = e.at(*t).unwrap().unwrap();
        let y = other.at(*t).unwrap().unwrap();
        let d: Vec<f64> = (0..4).map(|j| (x.attitude[j].hi() - s.attitude[j][i])).collect();
        let dd: Vec<f64> = (0..4).map(|j| (x.attitude[j] - y.attitude[j]).hi()).collect();
        let w: Vec<f64> = (0..3).map(|j| (x.angular_velocity[j].hi() - s.angular_velocity[j][i])).collect();
        println!("{t} {d:?} {w:?} {dd:?}");
    }
    println!("{:?} {}", start.elapsed(), e.effort().steps);
    panic!();
}
