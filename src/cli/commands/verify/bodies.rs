use crate::cli::args::VerifyArguments;
use crate::cli::execute::scenario;
use crate::recording::{Observed, Recording};
use crate::scenario::{BodySpec, Plan, PlannedBody, Scenario, ScenarioError};

/// The bodies that a file is held against, if any are known.
pub struct Bodies {
    all: Vec<PlannedBody>,
    /// Where they come from.
    pub source: Option<String>,
}

impl Bodies {
    /// As the arguments say, or the scene that the file carries.
    pub fn of(arguments: &VerifyArguments) -> Result<Self, ScenarioError> {
        if let Some(name) = &arguments.scene {
            let plan = Plan::new(&scenario(name, &arguments.set)?)?;
            return Ok(Self { all: plan.bodies, source: Some(format!("scene {name}")) });
        }
        if let Some(spec) = typed(arguments) {
            let scene =
                Scenario { duration_s: Some(1.0), sample_every_s: Some(1.0), body: vec![spec], ..Scenario::default() };
            return Ok(Self { all: Plan::new(&scene)?.bodies, source: Some("the inertia given".into()) });
        }
        // A file of another program is no recording of this one: that is no fault here.
        let carried = Recording::open(&arguments.file).ok().and_then(|recording| recording.heading().scene.clone());
        let Some(text) = carried else { return Ok(Self { all: Vec::new(), source: None }) };
        let plan = Plan::new(&Scenario::parse(&text, "the scene in the recording", &[])?)?;
        Ok(Self { all: plan.bodies, source: Some("the scene in the file".into()) })
    }

    /// The one that `observed` is: of the same name, or the only one of a file with `count` bodies.
    pub fn find(&self, observed: &Observed, count: usize) -> Option<&PlannedBody> {
        let named = self.all.iter().find(|body| body.name == observed.name);
        match self.all.as_slice() {
            [only] if count == 1 => Some(only),
            _ => named,
        }
    }
}

fn typed(arguments: &VerifyArguments) -> Option<BodySpec> {
    let spec = BodySpec { angular_velocity_rad_s: Some([0.0, 0.0, 1.0]), ..BodySpec::default() };
    match (arguments.principal_moments.as_slice(), arguments.inertia.as_slice()) {
        (&[a, b, c], _) => Some(BodySpec { principal_moments_kg_m2: Some([a, b, c]), ..spec }),
        (_, &[xx, yy, zz, xy, xz, yz]) => {
            Some(BodySpec { inertia_kg_m2: Some([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]), ..spec })
        }
        _ => None,
    }
}
