//! From what was asked to what will be done: the only place where rules are checked.

mod bodies;
mod channels;
mod checks;
mod events;
mod loads;
mod mass;
mod mesh;
mod new;
mod path;
mod points;
mod promise;
mod rules;
mod sampling;
mod solids;
mod work;

pub(crate) use bodies::MOST_BODIES;
pub(crate) use promise::nudged;
