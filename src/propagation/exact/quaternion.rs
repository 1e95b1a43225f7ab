use crate::numerics::DoubleDouble;

/// A quaternion w, x, y, z in double-double, for what is worked out once.
#[derive(Debug, Clone, Copy)]
pub struct ExactQuaternion(pub [DoubleDouble; 4]);

impl ExactQuaternion {
    /// These components as they are: no unit length is needed where [`QuaternionMap::unit`] comes last.
    pub fn along(wxyz: [f64; 4]) -> Self {
        Self(wxyz.map(DoubleDouble::from))
    }

    /// Products with 1, i, j and k on the right.
    pub fn times_units(self) -> [Self; 4] {
        let Self([w, x, y, z]) = self;
        [self, Self([-x, w, z, -y]), Self([-y, -z, w, x]), Self([-z, y, -x, w])]
    }

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
            (a * w - b * x) - (c * y + d * z),
            (a * x + b * w) + (c * z - d * y),
            (a * y - b * z) + (c * w + d * x),
            (a * z + b * y) - (c * x - d * w),
        ])
    }

    /// The inverse of a unit quaternion, a positive multiple of the inverse of any other.
    pub fn conjugate(self) -> Self {
        let Self([w, x, y, z]) = self;
        Self([w, -x, -y, -z])
    }
}

/// A linear map from N numbers to the components of a quaternion, as the images of the N units.
#[derive(Debug, Clone, Copy)]
pub struct QuaternionMap<const N: usize>([[f64; 4]; N]);

impl<const N: usize> QuaternionMap<N> {
    /// Everything to 0, for constants that are still being worked out.
    pub const ZERO: Self = Self([[0.0; 4]; N]);

    /// From the images, each rounded once.
    pub fn new(images: [ExactQuaternion; N]) -> Self {
        Self(images.map(|ExactQuaternion(image)| image.map(DoubleDouble::hi)))
    }

    /// The image's direction, w, x, y, z divided by their length: as near to unit as four f64 can be.
    #[inline(always)]
    pub fn unit(&self, of: [f64; N]) -> [f64; 4] {
        let mut q = [0.0; 4];
        for column in 0..N {
            for row in 0..4 {
                q[row] += self.0[column][row] * of[column];
            }
        }
        let [w, x, y, z] = q;
        let over_length = 1.0 / ((w * w + x * x) + (y * y + z * z)).sqrt();
        [w * over_length, x * over_length, y * over_length, z * over_length]
    }
}
