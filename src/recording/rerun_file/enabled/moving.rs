use std::io::Write;

use nalgebra::Vector3;
use re_sdk_types::archetypes::{Arrows3D, Points3D, Transform3D};

use super::columns::{quaternion, single, timelines};
use super::cords::Cords;
use super::particles::Particles;
use super::points::MovingPoint;
use super::rolling::Rolling;
use super::scaled::Scaled;
use super::statics::{BodyEntities, LABEL, TIP};
use super::stream::{Rows, Store, Stream};
use super::trail::{Cut, Trail};
use crate::recording::RecordingError;
use crate::recording::picture::{Arrow, BodyPicture, Picture, attitude};
use crate::scenario::{Plan, PlannedBody};
use crate::telemetry::{BodySamples, Channel, Samples};

/// What moves in the picture, at the picture's rate.
pub(super) struct Moving {
    picture: Picture,
    bodies: Vec<MovingBody>,
    points: Vec<MovingPoint>,
    particles: Particles,
    drawn: Drawn,
}

/// The samples of a batch that are drawn: where in the batch, when, and their numbers.
#[derive(Default)]
struct Drawn {
    indices: Vec<usize>,
    stamps: Vec<i64>,
    steps: Vec<i64>,
}

struct MovingBody {
    entities: BodyEntities,
    arrows: Vec<(Arrow, String)>,
    /// Where the body is if its position is not recorded, m.
    position: Vector3<f64>,
    /// What the trail follows, from the reference point, in body axes, m.
    tip: Vector3<f64>,
    has_attitude: bool,
    leaves_path: bool,
    travels: bool,
    trail: Trail,
    path: Trail,
    cords: Option<Cords>,
    rolling: Option<Rolling>,
    scaled: Option<Scaled>,
}

impl Moving {
    pub(super) fn new(plan: &Plan, picture: &Picture, scaled: Vec<Scaled>, particles: Particles) -> Self {
        let cut = Cut::new(plan, picture);
        let bodies = plan.bodies.iter().zip(&picture.bodies).map(|(body, drawing)| MovingBody::new(body, drawing, cut));
        let (mut bodies, mut scaled): (Vec<_>, _) = (bodies.collect(), scaled.into_iter());
        for (body, scaled) in bodies.iter_mut().zip(&mut scaled) {
            body.scaled = Some(scaled);
        }
        let points = MovingPoint::all(plan, cut, scaled);
        Self { picture: picture.clone(), bodies, points, particles, drawn: Drawn::default() }
    }

    /// Logs the pictures of one batch.
    ///
    /// # Errors
    /// If they cannot be written.
    pub(super) fn write<W: Write>(
        &mut self,
        stream: &mut Stream<W>,
        store: Store,
        samples: &Samples,
    ) -> Result<(), RecordingError> {
        self.drawn.select(samples, &self.picture);
        if self.drawn.indices.is_empty() {
            return Ok(());
        }
        let times = timelines(self.drawn.stamps.clone(), self.drawn.steps.clone());
        let rows = Rows { count: self.drawn.indices.len(), times: &times };
        for (body, samples) in self.bodies.iter_mut().zip(&samples.bodies) {
            body.write_transform(stream, store, rows, (&self.drawn.indices, samples))?;
            body.write_along(stream, store, rows, (&self.drawn.indices, samples))?;
            body.write_arrows(stream, store, rows, (&self.drawn.indices, samples))?;
            body.write_traces(stream, store, &self.drawn, samples)?;
            body.write_cords(stream, store, rows, (&self.drawn.indices, samples))?;
            if let Some(scaled) = &body.scaled {
                scaled.write(stream, store, rows, (&self.drawn.indices, samples))?;
            }
            if let Some(rolling) = &mut body.rolling {
                rolling.write(stream, store, rows, (&self.drawn.indices, samples), self.drawn.when())?;
            }
        }
        for (point, samples) in self.points.iter_mut().zip(samples.bodies.iter().skip(self.bodies.len())) {
            point.write(stream, store, rows, (&self.drawn.indices, samples), self.drawn.when())?;
        }
        self.particles.write(stream, store, rows, (&self.drawn.indices, samples))
    }
}

impl Drawn {
    fn select(&mut self, samples: &Samples, picture: &Picture) {
        self.indices.clear();
        self.indices.extend((0..samples.len()).filter(|index| picture.draws(samples.first_index + *index as u64)));
        self.stamps.clear();
        self.stamps.extend(self.indices.iter().map(|index| samples.stamps_ns[*index]));
        self.steps.clear();
        self.steps.extend(self.indices.iter().map(|index| (samples.first_index + *index as u64).cast_signed()));
    }

    /// Stamp (ns) and number of each.
    fn when(&self) -> impl Iterator<Item = (i64, i64)> {
        self.stamps.iter().copied().zip(self.steps.iter().copied())
    }
}

/// Which samples of a body are drawn.
type Selection<'a> = (&'a [usize], &'a BodySamples);

impl MovingBody {
    fn new(body: &PlannedBody, drawing: &BodyPicture, cut: Cut) -> Self {
        let entities = BodyEntities::new(&body.name);
        let arrows = drawing.arrows.iter().map(|arrow| (arrow.clone(), entities.arrow(arrow.quantity))).collect();
        Self {
            arrows,
            position: drawing.position,
            tip: drawing.spin_axis * (drawing.extent * TIP),
            has_attitude: body.channels.contains(&Channel::Attitude),
            leaves_path: body.moves && body.channels.contains(&Channel::Position),
            travels: drawing.travels,
            trail: Trail::new(entities.trail.clone(), cut),
            path: Trail::new(entities.path.clone(), cut),
            cords: Cords::new(&entities.cords, drawing),
            scaled: None,
            rolling: drawing.poinsot.as_ref().map(|poinsot| Rolling::new(&body.name, poinsot, cut)),
            entities,
        }
    }

    fn position(&self, samples: &BodySamples, index: usize) -> Vector3<f64> {
        match samples.channel(Channel::Position) {
            Some([x, y, z]) => Vector3::new(x[index], y[index], z[index]),
            _ => self.position,
        }
    }

    fn write_transform<W: Write>(
        &self,
        stream: &mut Stream<W>,
        store: Store,
        rows: Rows<'_>,
        (indices, samples): Selection<'_>,
    ) -> Result<(), RecordingError> {
        if !self.has_attitude {
            return Ok(());
        }
        let turns = indices.iter().filter_map(|index| attitude(samples, *index)).map(quaternion);
        // Both in every row: the viewer takes a transform from one row, whatever the others say.
        let places = indices.iter().map(|index| single(&self.position(samples, *index)));
        let transform = Transform3D::update_fields().with_many_quaternion(turns).with_many_translation(places);
        let columns = transform.columns_of_unit_batches().map_err(|error| stream.refused(error))?;
        stream.columns(store, &self.entities.body, rows, columns)
    }

    /// Where a view that goes along with the body is.
    fn write_along<W: Write>(
        &self,
        stream: &mut Stream<W>,
        store: Store,
        rows: Rows<'_>,
        (indices, samples): Selection<'_>,
    ) -> Result<(), RecordingError> {
        if !self.travels {
            return Ok(());
        }
        let places = indices.iter().map(|index| single(&self.position(samples, *index)));
        let transform = Transform3D::update_fields().with_many_translation(places);
        let columns = transform.columns_of_unit_batches().map_err(|error| stream.refused(error))?;
        stream.columns(store, &self.entities.along, rows, columns)
    }

    fn write_arrows<W: Write>(
        &self,
        stream: &mut Stream<W>,
        store: Store,
        rows: Rows<'_>,
        (indices, samples): Selection<'_>,
    ) -> Result<(), RecordingError> {
        for (arrow, entity) in &self.arrows {
            let (mut vectors, mut origins, mut tips) = (Vec::new(), Vec::new(), Vec::new());
            let mut lengths = Vec::with_capacity(indices.len());
            for index in indices {
                let Some(vector) = arrow.quantity.in_world(samples, *index) else { break };
                // An empty row makes the arrow of the row before disappear.
                let is_there = vector != Vector3::zeros();
                lengths.push(usize::from(is_there));
                if is_there {
                    let (origin, vector) = (self.position(samples, *index), vector * arrow.metres_per_unit);
                    vectors.push(single(&vector));
                    origins.push(single(&origin));
                    tips.push(single(&(origin + vector * LABEL)));
                }
            }
            if lengths.len() < indices.len() {
                continue;
            }
            let columns = Arrows3D::update_fields()
                .with_vectors(vectors)
                .with_origins(origins)
                .columns(lengths.iter().copied())
                .map_err(|error| stream.refused(error))?;
            let labels = Points3D::update_fields()
                .with_positions(tips)
                .columns(lengths.iter().copied())
                .map_err(|error| stream.refused(error))?;
            stream.columns(store, entity, rows, columns.chain(labels))?;
        }
        Ok(())
    }

    fn write_cords<W: Write>(
        &self,
        stream: &mut Stream<W>,
        store: Store,
        rows: Rows<'_>,
        (indices, samples): Selection<'_>,
    ) -> Result<(), RecordingError> {
        let Some(cords) = &self.cords else { return Ok(()) };
        let places: Vec<_> = indices.iter().map(|index| self.position(samples, *index)).collect();
        cords.write(stream, store, rows, (indices, samples), &places)
    }

    fn write_traces<W: Write>(
        &mut self,
        stream: &mut Stream<W>,
        store: Store,
        drawn: &Drawn,
        samples: &BodySamples,
    ) -> Result<(), RecordingError> {
        let places: Vec<_> = drawn.indices.iter().map(|index| self.position(samples, *index)).collect();
        if self.has_attitude {
            let tips =
                drawn.indices.iter().zip(&places).filter_map(|(index, place)| {
                    attitude(samples, *index).map(|turn| single(&(place + turn * self.tip)))
                });
            let points = drawn.when().zip(tips).map(|((stamp, step), point)| (stamp, step, point));
            self.trail.write(stream, store, points)?;
        }
        if self.leaves_path {
            let points = drawn.when().zip(&places).map(|((stamp, step), place)| (stamp, step, single(place)));
            self.path.write(stream, store, points)?;
        }
        Ok(())
    }
}
