use super::trace::Trace;

/// By which law the largest difference so far has grown.
///
/// Fitted to its logarithm, by least squares, over the last five octaves of time (to 1/32 of the end) before it is a tenth
/// of what it can be: on the logarithm of the time, a power; on the time, an exponential. The one that leaves less is the
/// law, if it leaves less than a factor of e^0.35, root mean square.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Growth {
    /// The law.
    pub law: Law,
    /// How much larger the largest difference is at the end of the fit than at its start.
    pub factor: f64,
    /// Where the fit starts, s.
    pub from_s: f64,
    /// Where it ends, s: the last sample, or where the difference gets as large as a tenth of the motion.
    pub until_s: f64,
    /// Whether the difference gets that large.
    pub is_saturated: bool,
}

/// How a difference grows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Law {
    /// By no more than t^¼.
    Bounded,
    /// As t to this power.
    Power {
        /// 1: as a wrong rate or frequency does; ½: as roundings do that know nothing of each other; 2: as a wrong torque.
        exponent: f64,
    },
    /// As exp(rate · t).
    Exponential {
        /// 1/s.
        rate_per_s: f64,
    },
    /// By none of these.
    Irregular,
}

/// One value of the largest difference so far, with its logarithm.
#[derive(Clone, Copy)]
struct Node {
    time: f64,
    log: f64,
}

/// A straight line, and what it leaves, root mean square.
struct Line {
    slope: f64,
    rest: f64,
}

impl Growth {
    /// The fit looks back to this share of its end.
    const OCTAVES: f64 = 32.0;
    /// Values that are fitted at most, evenly spread in log t.
    const NODES: u32 = 48;
    /// Fewer values are not enough to tell a law.
    const FEWEST: usize = 12;
    /// What a law may leave of the logarithm.
    const REST: f64 = 0.35;
    /// Powers below this are no growth.
    const BOUNDED: f64 = 0.25;
    /// An exponential that goes through less of this could be anything.
    const FOLDS: f64 = 3.0;

    /// Of differences that cannot get larger than about `ceiling`; `None` where there is none, or too few are known.
    #[must_use]
    pub fn of(trace: &Trace, ceiling: f64) -> Option<Self> {
        let largest = so_far(trace);
        let free = largest.iter().take_while(|(_, difference)| *difference <= 0.1 * ceiling).count();
        let is_saturated = free < largest.len();
        let (until_s, _) = *largest[..free].last()?;
        let nodes = nodes(&largest[..free], until_s);
        if nodes.len() < Self::FEWEST {
            return None;
        }
        let (first, last) = (nodes.first()?, nodes.last()?);
        let folds = last.log - first.log;
        let power = line(&nodes, |node| libm::log(node.time));
        let exponential = line(&nodes, |node| node.time);
        let law = if folds <= Self::BOUNDED * libm::log(Self::OCTAVES) || power.slope < Self::BOUNDED {
            Law::Bounded
        } else if exponential.rest < power.rest && exponential.rest < Self::REST && folds > Self::FOLDS {
            Law::Exponential { rate_per_s: exponential.slope }
        } else if power.rest < Self::REST {
            Law::Power { exponent: power.slope }
        } else {
            Law::Irregular
        };
        Some(Self { law, factor: libm::exp(folds), from_s: first.time, until_s, is_saturated })
    }

    /// As it ends a sentence: `grows as t^1.0`.
    #[must_use]
    pub fn in_words(&self) -> String {
        let until = if self.is_saturated { format!(" until {:.3} s", self.until_s) } else { String::new() };
        match self.law {
            Law::Bounded => format!("stays bounded{until}"),
            Law::Power { exponent } => format!("grows as t^{exponent:.1}{until}"),
            Law::Exponential { rate_per_s } => format!("grows e-fold every {} s{until}", short(1.0 / rate_per_s)),
            Law::Irregular => format!("grows by no simple law, {:.0} times{until}", self.factor),
        }
    }
}

/// Three digits.
fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.2e}").parse().unwrap_or(value);
    rounded.to_string()
}

/// The largest difference up to each point of the trace.
fn so_far(trace: &Trace) -> Vec<(f64, f64)> {
    let mut largest = 0.0_f64;
    let rise = |(time_s, difference): (f64, f64)| {
        largest = largest.max(difference);
        (time_s, largest)
    };
    trace.points().map(rise).collect()
}

/// Points of the last octaves before `until_s`, evenly spread in log t, each once.
fn nodes(largest: &[(f64, f64)], until_s: f64) -> Vec<Node> {
    let is_known = |point: &&(f64, f64)| point.0 > 0.0 && point.0 >= until_s / Growth::OCTAVES && point.1 > 0.0;
    let known: Vec<_> = largest.iter().filter(is_known).collect();
    let Some((from_s, _)) = known.first() else { return Vec::new() };
    let ratio = libm::log(until_s / from_s) / f64::from(Growth::NODES - 1);
    let mut nodes: Vec<Node> = Vec::new();
    for number in 0..Growth::NODES {
        let wanted = from_s * libm::exp(ratio * f64::from(number)) * (1.0 + f64::EPSILON * 64.0);
        let after = known.partition_point(|(time, _)| *time <= wanted);
        let Some((time, difference)) = after.checked_sub(1).and_then(|index| known.get(index)) else { continue };
        if nodes.last().is_none_or(|last| last.time < *time) {
            nodes.push(Node { time: *time, log: libm::log(*difference) });
        }
    }
    nodes
}

/// The straight line through the logarithms over `x`.
#[expect(clippy::cast_precision_loss, reason = "few")]
fn line(nodes: &[Node], x: impl Fn(&Node) -> f64) -> Line {
    let count = nodes.len() as f64;
    let mean_x = nodes.iter().map(&x).sum::<f64>() / count;
    let mean_y = nodes.iter().map(|node| node.log).sum::<f64>() / count;
    let (mut across, mut square) = (0.0, 0.0);
    for node in nodes {
        let step = x(node) - mean_x;
        across += step * (node.log - mean_y);
        square += step * step;
    }
    let slope = if square > 0.0 { across / square } else { 0.0 };
    let rest = |node: &Node| node.log - mean_y - slope * (x(node) - mean_x);
    let squares: f64 = nodes.iter().map(|node| rest(node) * rest(node)).sum();
    Line { slope, rest: (squares / count).sqrt() }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 20 s in steps of 0.01 s.
    fn law(difference: impl Fn(f64) -> f64) -> Law {
        let mut trace = Trace::default();
        for index in 0..=2000 {
            let time_s = f64::from(index) * 0.01;
            trace.push(time_s, difference(time_s));
        }
        Growth::of(&trace, 1.0).expect("differences").law
    }

    fn exponent(difference: impl Fn(f64) -> f64) -> f64 {
        match law(difference) {
            Law::Power { exponent } => exponent,
            other => panic!("{other:?} is no power"),
        }
    }

    #[test]
    fn powers_are_found() {
        for power in [0.5, 1.0, 2.0, 4.0] {
            assert!((exponent(|time| 1e-12 * libm::pow(time, power)) - power).abs() < 1e-9);
            // On top of what swings within the growth: the largest so far is within a swing of it.
            let swinging = |time: f64| 1e-12 * libm::pow(time, power) * libm::sin(40.0 * time).abs();
            assert!((exponent(swinging) - power).abs() < 0.1, "{}", exponent(swinging));
        }
    }

    #[test]
    fn exponentials_are_found_until_they_are_as_large_as_the_motion() {
        for rate in [0.5, 2.0, 10.0] {
            let Law::Exponential { rate_per_s } = law(|time| (1e-14 * libm::exp(rate * time)).min(0.8)) else {
                panic!("e^{rate}t is no exponential");
            };
            assert!((rate_per_s / rate - 1.0).abs() < 1e-6, "{rate_per_s} is not {rate}");
        }
    }

    #[test]
    fn what_swings_stays_bounded() {
        assert_eq!(law(|time| 1e-12 * libm::sin(7.0 * time).abs()), Law::Bounded);
        assert_eq!(law(|_| 1e-16), Law::Bounded);
    }

    #[test]
    fn a_jump_is_no_law() {
        assert_eq!(law(|time| if time < 5.0 { 1e-15 } else { 1e-3 }), Law::Irregular);
    }

    #[test]
    fn where_nothing_differs_nothing_grows() {
        let mut trace = Trace::default();
        (0..1000).for_each(|index| trace.push(f64::from(index), 0.0));
        assert_eq!(Growth::of(&trace, 1.0), None);
    }
}
