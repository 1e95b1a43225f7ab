use nalgebra::{DMatrix, DVector, Vector3};

/// Displacements of a free body in space that stretch nothing.
const RIGID: usize = 6;

/// The forces of the springs for small displacements: F = −K u, three rows and columns for each particle.
pub(super) struct Stiffness<'a> {
    masses: &'a [f64],
    places: &'a [Vector3<f64>],
    constant: f64,
    matrix: DMatrix<f64>,
}

impl<'a> Stiffness<'a> {
    /// Of springs of one `constant`, N/m, between every two of particles at `places`, m.
    pub fn new(masses: &'a [f64], places: &'a [Vector3<f64>], constant: f64) -> Self {
        let mut matrix = DMatrix::zeros(3 * places.len(), 3 * places.len());
        for (first, from) in places.iter().enumerate() {
            for (second, to) in places.iter().enumerate().skip(first + 1) {
                let along = (to - from).normalize();
                for (row, column) in (0..3).flat_map(|row| (0..3).map(move |column| (row, column))) {
                    let pull = constant * along[row] * along[column];
                    matrix[(3 * first + row, 3 * first + column)] += pull;
                    matrix[(3 * second + row, 3 * second + column)] += pull;
                    matrix[(3 * first + row, 3 * second + column)] -= pull;
                    matrix[(3 * second + row, 3 * first + column)] -= pull;
                }
            }
        }
        Self { masses, places, constant, matrix }
    }

    /// The lowest and the highest natural frequency, rad/s; not finite where two particles are in one place.
    pub fn frequencies(&self) -> [f64; 2] {
        if self.matrix.iter().any(|element| !element.is_finite()) {
            return [f64::NAN; 2];
        }
        let weight = |index: usize| self.masses[index / 3].sqrt();
        let weighted = self.matrix.map_with_location(|row, column, value| value / (weight(row) * weight(column)));
        let mut squares: Vec<f64> = weighted.symmetric_eigenvalues().iter().copied().collect();
        squares.sort_by(f64::total_cmp);
        let at = |index: usize| squares.get(index).map_or(f64::NAN, |square| square.max(0.0).sqrt());
        [at(RIGID), at(squares.len().saturating_sub(1))]
    }

    /// u of K u = F, m, without any part that moves or turns the whole, of forces F, N, that do not move or turn it; zero
    /// where the springs do not hold.
    pub fn displacements(&self, forces: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
        let mut held = self.matrix.clone();
        for axis in 0..3 {
            let unit = Vector3::from_fn(|row, _| if row == axis { 1.0 } else { 0.0 });
            let shift = |_: &Vector3<f64>| unit;
            let turn = |place: &Vector3<f64>| unit.cross(place);
            self.hold(&mut held, &shift);
            self.hold(&mut held, &turn);
        }
        let pulls = DVector::from_iterator(3 * forces.len(), forces.iter().flat_map(|force| force.iter().copied()));
        let solved = held.cholesky().map(|held| held.solve(&pulls));
        let found = solved.unwrap_or_else(|| DVector::zeros(3 * forces.len()));
        (0..forces.len()).map(|index| found.fixed_rows::<3>(3 * index).into_owned()).collect()
    }

    /// Adds a spring against one displacement of the whole, weighted by the masses: forces that do not cause it leave it
    /// zero, and the others as they are.
    fn hold(&self, held: &mut DMatrix<f64>, displacement: &dyn Fn(&Vector3<f64>) -> Vector3<f64>) {
        let rows = self.masses.iter().zip(self.places).flat_map(|(mass, place)| {
            let moved = displacement(place) * *mass;
            [moved.x, moved.y, moved.z]
        });
        let rows: Vec<f64> = rows.collect();
        let size: f64 = rows.iter().map(|value| value * value).sum();
        for (i, first) in rows.iter().enumerate() {
            for (j, second) in rows.iter().enumerate() {
                held[(i, j)] += self.constant * first * second / size;
            }
        }
    }
}
