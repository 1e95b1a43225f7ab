use super::bodies::{Gathered, Gathering};
use super::stamped::Stamped;
use crate::recording::Axes;

impl Gathering {
    /// Rates and moments on topics of their own go to the body whose frame they are told in; or, told in the frame that
    /// is fixed, to the only body that moves in it.
    pub(super) fn join_rates(&mut self) {
        self.bodies.iter_mut().for_each(Gathered::find_axes);
        let alone = |body: &Gathered| body.attitude.len() == 0 && body.position.len() == 0;
        let (rates, mut bodies): (Vec<_>, Vec<_>) = std::mem::take(&mut self.bodies).into_iter().partition(alone);
        for rates in rates {
            match owner(&rates, &bodies) {
                Some((number, axes)) if bodies[number].lacks(&rates, axes) => {
                    let remark = format!(
                        "{}: taken for {}, in {} axes",
                        rates.place.topic,
                        bodies[number].place.name(),
                        if axes == Axes::Body { "its" } else { "world" },
                    );
                    self.remarks.push(remark);
                    bodies[number].join(rates, axes);
                }
                _ => bodies.push(rates),
            }
        }
        self.bodies = bodies;
    }
}

/// Whose rates these are, and in which axes.
fn owner(rates: &Gathered, bodies: &[Gathered]) -> Option<(usize, Axes)> {
    let frame = rates.place.axes.as_deref()?;
    let only = |is_it: &dyn Fn(&Gathered) -> bool| {
        let mut found = bodies.iter().enumerate().filter(|(_, body)| body.attitude.len() > 1 && is_it(body));
        found.next().filter(|_| found.next().is_none()).map(|(number, _)| number)
    };
    if let Some(number) = only(&|body| body.place.moving.as_deref() == Some(frame)) {
        return Some((number, Axes::Body));
    }
    // An IMU turns with the frame it is told in, whether or not that frame is told of.
    if rates.place.moving.is_some() {
        return None;
    }
    only(&|body| body.place.fixed.as_deref() == Some(frame)).map(|number| (number, Axes::World))
}

impl Gathered {
    fn find_axes(&mut self) {
        let Some(axes) = &self.place.axes else { return };
        if self.place.moving.as_ref() == Some(axes) {
            self.axes = Some(Axes::Body);
        } else if self.place.fixed.as_ref() == Some(axes) {
            self.axes = Some(Axes::World);
        }
    }

    /// Whether nothing that the other tells is told already, or in other axes.
    fn lacks(&self, other: &Self, axes: Axes) -> bool {
        let pairs = [
            (&self.angular_velocity, &other.angular_velocity),
            (&self.moment, &other.moment),
            (&self.velocity, &other.velocity),
        ];
        let is_free = pairs.iter().all(|(mine, theirs)| mine.len() == 0 || theirs.len() == 0);
        let has_none = pairs.iter().all(|(mine, _)| mine.len() == 0);
        is_free && (has_none || self.axes == Some(axes))
    }

    fn join(&mut self, other: Self, axes: Axes) {
        let fill = |mine: &mut Stamped<3>, theirs: Stamped<3>| {
            if theirs.len() > 0 {
                *mine = theirs;
            }
        };
        fill(&mut self.angular_velocity, other.angular_velocity);
        fill(&mut self.moment, other.moment);
        fill(&mut self.velocity, other.velocity);
        self.axes = Some(axes);
        self.resolution = self.resolution.max(other.resolution);
    }
}
