//! Formulae as text.

use nalgebra::{Matrix3, Vector3};

/// A number, in brackets: it may be negative.
fn number(value: f64) -> String {
    format!("({value:?})")
}

fn swing(amplitude: f64, [rate, phase]: [f64; 2]) -> String {
    format!("{}*sin({}*t+{})", number(amplitude), number(rate), number(phase))
}

/// Σ aⱼ nameⱼ.
fn along<S: AsRef<str>>(factors: [f64; 3], names: &[S; 3]) -> String {
    let terms: Vec<String> =
        factors.iter().zip(names).map(|(factor, name)| format!("{}*{}", number(*factor), name.as_ref())).collect();
    terms.join("+")
}

fn row(matrix: &Matrix3<f64>, row: usize) -> [f64; 3] {
    [0, 1, 2].map(|column| matrix[(row, column)])
}

pub fn in_body(matrix: &Matrix3<f64>, amplitude: &Vector3<f64>, beat: [f64; 2], world: &Vector3<f64>) -> [String; 3] {
    [0, 1, 2].map(|i| {
        let images = [1, 2, 3].map(|j| format!("r{j}{}", i + 1));
        let rates = along(row(matrix, i), &["wx", "wy", "wz"]);
        format!("-({rates})+{}+{}", swing(amplitude[i], beat), along((*world).into(), &images))
    })
}

pub fn in_world(matrix: &Matrix3<f64>, amplitude: &Vector3<f64>, beat: [f64; 2], body: &Vector3<f64>) -> [String; 3] {
    let image = [1, 2, 3].map(|i| format!("({})", along((*body).into(), &[1, 2, 3].map(|j| format!("r{i}{j}")))));
    [0, 1, 2].map(|i| format!("{}+{}", along(row(matrix, i), &image), swing(amplitude[i], beat)))
}

pub fn pull(
    [spring, damper]: [f64; 2],
    anchor: &Vector3<f64>,
    amplitude: &Vector3<f64>,
    beat: [f64; 2],
) -> [String; 3] {
    let names = [("x", "vx"), ("y", "vy"), ("z", "vz")];
    [0, 1, 2].map(|i| {
        let (place, speed) = names[i];
        let back = format!("{}*({place}-{})+{}*{speed}", number(spring), number(anchor[i]), number(damper));
        format!("-({back})+{}", swing(amplitude[i], beat))
    })
}
