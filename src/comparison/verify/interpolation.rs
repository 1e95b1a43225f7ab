use nalgebra::Vector3;

/// A few neighbouring times, through whose values a polynomial goes.
pub struct Stencil<'a> {
    first: usize,
    times: &'a [f64],
}

impl<'a> Stencil<'a> {
    /// `width` times (or all there are) about the interval from time `k` to the next.
    pub fn between(times: &'a [f64], k: usize, width: usize) -> Self {
        let width = width.min(times.len());
        let first = (k + 1).saturating_sub(width / 2).min(times.len() - width);
        Self { first, times: &times[first..first + width] }
    }

    /// Lagrange's weights of the values, at a time.
    fn weights(&self, time: f64) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.times.iter().enumerate().map(move |(j, own)| {
            let others = self.times.iter().enumerate().filter(|(m, _)| *m != j);
            (self.first + j, others.map(|(_, other)| (time - other) / (own - other)).product())
        })
    }

    /// The polynomial's value at a time; `values` belong to all times.
    pub fn vector(&self, values: &[Vector3<f64>], time: f64) -> Vector3<f64> {
        self.weights(time).map(|(index, weight)| values[index] * weight).sum()
    }

    /// The polynomial's derivative at one of its times, `at`.
    pub fn slope(&self, values: &[Vector3<f64>], at: usize) -> Vector3<f64> {
        let own = at - self.first;
        let (mut sum, here): (Vector3<f64>, f64) = (Vector3::zeros(), self.times[own]);
        for (j, time) in self.times.iter().enumerate() {
            if j == own {
                continue;
            }
            let others = self.times.iter().enumerate().filter(|(m, _)| *m != j && *m != own);
            let weight: f64 = others.map(|(_, other)| (here - other) / (time - other)).product();
            sum += (values[self.first + j] * weight - values[at]) / (time - here);
        }
        sum
    }
}
