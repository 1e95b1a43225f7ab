/// A ROS 2 message: four bytes that say how it is encoded, then its fields one after the other, each at a multiple of
/// its size, as the OMG's Common Data Representation lays them out.
#[derive(Debug)]
pub(super) struct Cdr<'a> {
    bytes: &'a [u8],
    place: usize,
    is_big_endian: bool,
}

impl<'a> Cdr<'a> {
    /// The fields of a message; `None` if it is not encoded as ROS 2 does it, which is plain CDR of either byte order.
    pub fn of(message: &'a [u8]) -> Option<Self> {
        let (head, bytes) = message.split_first_chunk::<4>()?;
        match head {
            [0, order @ (0 | 1), ..] => Some(Self { bytes, place: 0, is_big_endian: *order == 0 }),
            _ => None,
        }
    }

    pub fn f64(&mut self) -> Option<f64> {
        let bytes = self.aligned()?;
        Some(if self.is_big_endian { f64::from_be_bytes(bytes) } else { f64::from_le_bytes(bytes) })
    }

    pub fn u32(&mut self) -> Option<u32> {
        let bytes = self.aligned()?;
        Some(if self.is_big_endian { u32::from_be_bytes(bytes) } else { u32::from_le_bytes(bytes) })
    }

    /// Several f64 of a fixed number.
    pub fn doubles<const N: usize>(&mut self) -> Option<[f64; N]> {
        let mut values = [0.0; N];
        for value in &mut values {
            *value = self.f64()?;
        }
        Some(values)
    }

    /// A text: its length with the closing zero, its bytes, the zero.
    pub fn text(&mut self) -> Option<String> {
        let length = usize::try_from(self.u32()?).ok()?;
        let text = self.bytes.get(self.place..)?.get(..length)?;
        self.place += length;
        let text = text.strip_suffix(&[0]).unwrap_or(text);
        String::from_utf8(text.to_vec()).ok()
    }

    /// Whether the message ends here; some programs fill the last word.
    pub fn is_at_end(&self) -> bool {
        self.bytes.len() - self.place < 8
    }

    fn aligned<const N: usize>(&mut self) -> Option<[u8; N]> {
        let start = self.place.next_multiple_of(N);
        let bytes = self.bytes.get(start..)?.first_chunk::<N>()?;
        self.place = start + N;
        Some(*bytes)
    }
}
