use std::path::PathBuf;

use clap::Args;

use crate::comparison::verify::DEFAULT_TOLERANCE_RAD;

#[derive(Debug, Args)]
pub(in crate::cli) struct VerifyArguments {
    /// The recording, of any program: .mcap, .rrd, .csv, .tsv, .txt or .dat.
    pub file: PathBuf,
    /// The scene that it is of, for its bodies and torques: a name or a TOML file. Left out: the one that the file carries.
    #[arg(long, value_name = "SCENE", conflicts_with_all = ["principal_moments", "inertia"])]
    pub scene: Option<String>,
    /// Any key of that scene.
    #[arg(long, value_name = "KEY=VALUE", requires = "scene")]
    pub set: Vec<String>,
    /// Moments of inertia about body axes that are principal axes, kg m²; nothing acts.
    #[arg(long, value_name = "I1,I2,I3", value_delimiter = ',', conflicts_with = "inertia")]
    pub principal_moments: Vec<f64>,
    /// Inertia tensor in body axes, kg m²: products with the sign of the matrix, Ixy = −∫ x y dm; nothing acts.
    #[arg(long, value_name = "XX,YY,ZZ,XY,XZ,YZ", value_delimiter = ',', allow_hyphen_values = true)]
    pub inertia: Vec<f64>,
    /// The body of the file to verify; left out: all of them.
    #[arg(long, value_name = "NAME")]
    pub body: Option<String>,
    /// What the file's columns, frames and topics mean: a TOML file.
    #[arg(long, value_name = "FILE", conflicts_with = "columns")]
    pub map: Option<PathBuf>,
    /// The same for a table of one body, such as `time=t, quaternion=qw qx qy qz, angular_velocity=wx wy wz`.
    #[arg(long, value_name = "KEY=COLUMNS,…")]
    pub columns: Option<String>,
    /// How far attitudes may be from the exact motion through the first state, rad.
    #[arg(long, value_name = "RAD", default_value_t = DEFAULT_TOLERANCE_RAD)]
    pub tolerance: f64,
    /// As JSON.
    #[arg(long)]
    pub json: bool,
}
