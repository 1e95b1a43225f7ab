//! Messages whose bytes are known but for a time and some numbers. Encoding the rest once is what makes a sample cheap.

use prost::Message;
use prost::encoding::encode_varint;

/// Bytes of a message, with places for numbers of eight bytes.
#[derive(Debug, Clone, Default)]
pub(super) struct Template {
    bytes: Vec<u8>,
    places: Vec<usize>,
}

impl Template {
    /// That of `message`, where the numbers are [`Self::mark`] 0 to `count` − 1.
    pub fn of(message: &impl Message, count: u32) -> Self {
        let bytes = message.encode_to_vec();
        let place = |number| bytes.windows(8).position(|window| window == Self::mark(number).to_le_bytes());
        Self { places: (0..count).filter_map(place).collect(), bytes }
    }

    /// Stands for number `number`: not zero, which would not be written, nor anything that a message says.
    pub fn mark(number: u32) -> f64 {
        f64::from_bits(0x7ff8_6d61_726b_0000 + u64::from(number))
    }

    /// Adds bytes that stay, and a place for a number.
    pub fn push(&mut self, bytes: &[u8]) {
        self.bytes.extend_from_slice(bytes);
        self.places.push(self.bytes.len());
        self.bytes.extend_from_slice(&[0; 8]);
    }

    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    pub fn places(&self) -> &[usize] {
        &self.places
    }

    pub fn len(&self) -> usize {
        self.bytes.len()
    }

    /// Appends the message with these numbers. All are written, zeros too: −0 would not come back.
    pub fn append(&self, numbers: impl IntoIterator<Item = f64>, bytes: &mut Vec<u8>) {
        let start = bytes.len();
        bytes.extend_from_slice(&self.bytes);
        let message = &mut bytes[start..];
        for (place, number) in self.places.iter().zip(numbers) {
            message[*place..*place + 8].copy_from_slice(&number.to_le_bytes());
        }
    }
}

/// A time as a field of messages: `google.protobuf.Timestamp` with its key and length.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stamp {
    bytes: [u8; Self::LONGEST],
    length: usize,
}

impl Stamp {
    /// Key and length; key and ten bytes of seconds; key and five of nanoseconds.
    const LONGEST: usize = 2 + 11 + 6;

    /// In the field of that key.
    pub fn new(key: u8, stamp_ns: i64) -> Self {
        let (seconds, nanos) = (stamp_ns.div_euclid(1_000_000_000), stamp_ns.rem_euclid(1_000_000_000));
        let mut stamp = Self { bytes: [0; Self::LONGEST], length: 2 };
        stamp.number(0x08, seconds);
        stamp.number(0x10, nanos);
        stamp.bytes[0] = key;
        stamp.bytes[1] = (stamp.length - 2).to_le_bytes()[0];
        stamp
    }

    pub fn bytes(&self) -> &[u8] {
        &self.bytes[..self.length]
    }

    pub fn len(&self) -> usize {
        self.length
    }

    /// Seven bits a byte, the lowest first; zero is left out.
    fn number(&mut self, key: u8, number: i64) {
        if number == 0 {
            return;
        }
        let mut rest = number.cast_unsigned();
        self.push(key);
        while rest >= 0x80 {
            self.push(rest.to_le_bytes()[0] | 0x80);
            rest >>= 7;
        }
        self.push(rest.to_le_bytes()[0]);
    }

    fn push(&mut self, byte: u8) {
        self.bytes[self.length] = byte;
        self.length += 1;
    }
}

/// Appends key and length of a message within a message, of `length` bytes.
pub(super) fn begin(key: u8, length: usize, bytes: &mut Vec<u8>) {
    bytes.push(key);
    encode_varint(length as u64, bytes);
}

#[cfg(test)]
mod tests {
    use super::super::foxglove::{Timestamp, Xyz};
    use super::*;

    #[test]
    fn a_template_gives_the_bytes_of_the_derived_encoder() {
        let xyz = |[x, y, z]: [f64; 3]| Xyz { x, y, z };
        let template = Template::of(&xyz([0, 1, 2].map(Template::mark)), 3);
        let mut bytes = Vec::new();
        template.append([1.5, -2.5, 1e300], &mut bytes);
        assert_eq!(bytes, xyz([1.5, -2.5, 1e300]).encode_to_vec());
    }

    #[test]
    fn a_stamp_is_a_timestamp() {
        for stamp_ns in [0, 1, 127, 128, 999_999_999, 1_000_000_000, 86_400_000_000_001, i64::MAX, -1, i64::MIN] {
            let mut bytes = Vec::new();
            prost::encoding::message::encode(2, &Timestamp::of(stamp_ns), &mut bytes);
            assert_eq!(Stamp::new(0x12, stamp_ns).bytes(), bytes, "{stamp_ns} ns");
        }
    }
}
