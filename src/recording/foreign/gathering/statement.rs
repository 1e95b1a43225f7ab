/// What one message says of one body.
#[derive(Debug, Clone, Default, PartialEq)]
pub(in crate::recording) struct Statement {
    /// Of whom.
    pub place: Place,
    /// When, as the message says, ns; `None` or 0 if it does not.
    pub stamp_ns: Option<i64>,
    /// When it was recorded, ns.
    pub log_ns: i64,
    /// World from body, w, x, y, z.
    pub attitude: Option<[f64; 4]>,
    /// Whether the attitude is told in a form that leaves the sign of its quaternion open.
    pub is_of_either_sign: bool,
    /// m, in the axes of the fixed frame.
    pub position: Option<[f64; 3]>,
    /// rad/s.
    pub angular_velocity: Option<[f64; 3]>,
    /// N m.
    pub moment: Option<[f64; 3]>,
    /// m/s.
    pub velocity: Option<[f64; 3]>,
    /// Half a unit in the last place of these numbers, relative.
    pub resolution: f64,
}

impl Statement {
    /// Whether it tells any quantity.
    pub fn tells(&self) -> bool {
        let vectors = [self.position, self.angular_velocity, self.moment, self.velocity];
        self.attitude.is_some() || vectors.iter().any(Option::is_some)
    }
}

/// Where a body is told of, and in which axes.
#[derive(Debug, Clone, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::recording) struct Place {
    /// What it is called unless its frame is: the topic or entity.
    pub topic: String,
    /// Whether it is the same on whatever topic: a transform between two frames.
    pub is_on_any_topic: bool,
    /// The frame that counts as fixed, if it is told.
    pub fixed: Option<String>,
    /// The frame that moves with the body, if it is told.
    pub moving: Option<String>,
    /// The frame in whose axes rates and moments are.
    pub axes: Option<String>,
}

impl Place {
    /// A frame in another, on whatever topic.
    pub fn transform(fixed: String, moving: String) -> Self {
        let axes = Some(moving.clone());
        Self { topic: String::new(), is_on_any_topic: true, axes, fixed: Some(fixed), moving: Some(moving) }
    }

    /// What the body is called.
    pub fn name(&self) -> String {
        match &self.moving {
            Some(frame) if self.is_on_any_topic => frame.clone(),
            _ => self.topic.clone(),
        }
    }
}
