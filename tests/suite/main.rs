#![allow(missing_docs)]

#[cfg(feature = "serde")]
mod bad_scenes;
mod certificates;
#[cfg(feature = "cli")]
mod cli;
#[cfg(feature = "cli")]
mod cli_compare;
#[cfg(feature = "cli")]
mod cli_files;
#[cfg(feature = "cli")]
mod cli_scenes;
#[cfg(feature = "cli")]
mod cli_stress;
mod closed_torques;
mod compare;
#[cfg(feature = "cli")]
mod contested_names;
#[cfg(feature = "serde")]
mod convert;
#[cfg(feature = "serde")]
mod corpora;
mod csv_format;
mod derived_channels;
mod effort;
mod equivalence;
mod faults;
mod fixed_step;
mod floors;
mod forced_oracle;
#[cfg(all(feature = "mcap", feature = "rerun"))]
mod foreign_containers;
#[cfg(feature = "serde")]
mod foreign_engines;
#[cfg(feature = "mcap")]
mod foreign_messages;
mod foreign_tables;
mod free_laws;
mod full_disks;
mod functions_of_time;
#[cfg(feature = "serde")]
mod general_loads;
#[cfg(feature = "serde")]
mod general_scenes;
#[cfg(feature = "cli")]
mod golden;
#[cfg(feature = "golden")]
mod golden_hold;
mod hostile;
#[cfg(all(feature = "cli", unix))]
mod killed_runs;
mod lagrange_top;
mod limits;
#[cfg(all(feature = "cli", target_os = "linux"))]
mod machine;
#[cfg(feature = "mcap")]
mod mcap_format;
#[cfg(feature = "serde")]
mod mesh_files;
mod motions;
#[cfg(feature = "serde")]
mod near_misses;
mod numerics;
mod oracle;
mod order;
#[cfg(feature = "serde")]
mod overrides;
mod particle_cloud;
mod particles;
#[cfg(feature = "serde")]
mod pivot_loads;
mod planned;
#[cfg(feature = "cli")]
mod plots;
mod precise;
#[cfg(feature = "serde")]
mod probes;
mod promises;
mod properties;
#[cfg(feature = "serde")]
mod recover;
mod reference;
#[cfg(feature = "rerun")]
mod rerun_format;
mod same_bits;
#[cfg(feature = "cli")]
mod same_bytes;
#[cfg(feature = "serde")]
mod same_motion;
#[cfg(feature = "serde")]
mod scenarios;
#[cfg(feature = "serde")]
mod scene_checks;
#[cfg(feature = "schema")]
mod scene_schema;
mod stress;
mod tapes;
mod torque_laws;
mod torque_steps;
mod trajectories;
#[cfg(feature = "serde")]
mod verify;
#[cfg(feature = "serde")]
mod views;
mod work_precision;
