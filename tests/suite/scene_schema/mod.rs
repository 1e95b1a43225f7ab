//! The JSON Schema of scenes: as committed, as the parser, as the plan, as the manual.

mod against_parser;
mod against_plan;
mod committed;
mod manual;
mod scenes;
mod tables;
