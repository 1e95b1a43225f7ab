use nalgebra::{Matrix4, Vector4};

use crate::numerics::DoubleDouble;

/// A quaternion w, x, y, z in double-double, for what is worked out once.
#[derive(Debug, Clone, Copy)]
pub struct ExactQuaternion(pub [DoubleDouble; 4]);

impl ExactQuaternion {
    /// The unit quaternion along these components.
    pub fn normalised(components: [DoubleDouble; 4]) -> Self {
        let [w, x, y, z] = components;
        let over_norm = (w.square() + x.square() + y.square() + z.square()).sqrt().recip();
        Self(components.map(|component| component * over_norm))
    }

    /// Hamilton's product.
    pub fn times(self, other: Self) -> Self {
        let (Self([a, b, c, d]), Self([w, x, y, z])) = (self, other);
        Self([
            a * w - b * x - c * y - d * z,
            a * x + b * w + c * z - d * y,
            a * y - b * z + c * w + d * x,
            a * z + b * y - c * x + d * w,
        ])
    }

    /// The inverse of a unit quaternion.
    pub fn conjugate(self) -> Self {
        let Self([w, x, y, z]) = self;
        Self([w, -x, -y, -z])
    }

    /// The matrix that takes the components of p to those of `self` p `right`.
    pub fn around(self, right: Self) -> Matrix4<f64> {
        let mut matrix = Matrix4::zeros();
        let [w, x, y, z] = self.0;
        // Products of `self` with 1, i, j, k.
        let images = [[w, x, y, z], [-x, w, z, -y], [-y, -z, w, x], [-z, y, -x, w]];
        for (column, image) in images.into_iter().enumerate() {
            let Self(image) = Self(image).times(right);
            for row in 0..4 {
                matrix[(row, column)] = image[row].hi();
            }
        }
        matrix
    }
}

/// w, x, y, z divided by their length: as near to unit as four f64 can be.
#[inline]
pub fn unit(q: Vector4<f64>) -> [f64; 4] {
    let [w, x, y, z] = q.into();
    let over_length = 1.0 / ((w * w + x * x) + (y * y + z * z)).sqrt();
    [w * over_length, x * over_length, y * over_length, z * over_length]
}
