use std::io::Write;

use serde_json::{Map, Value, json};

use crate::recording::picture::Picture;
use crate::recording::{PartFile, RecordingError};
use crate::scenario::{Plan, Watched};
use crate::telemetry::Channel;

/// Channels that share a plot, and its title.
const PLOTS: [(&str, &[Channel]); 21] = [
    ("ω in body axes (rad/s)", &[Channel::AngularVelocity]),
    ("tilt (rad)", &[Channel::Tilt]),
    ("precession rate (rad/s)", &[Channel::PrecessionRate]),
    ("L in world axes (N m s)", &[Channel::AngularMomentumWorld]),
    (
        "energy (J)",
        &[
            Channel::RotationalEnergy,
            Channel::TranslationalEnergy,
            Channel::PotentialEnergy,
            Channel::TotalEnergy,
            Channel::KineticEnergy,
            Channel::JacobiIntegral,
        ],
    ),
    ("drift, relative (1e-15)", &[Channel::EnergyDrift, Channel::MomentumDrift, Channel::Slip]),
    ("accelerometer (m/s²)", &[Channel::Accelerometer]),
    ("gyroscope (rad/s)", &[Channel::Gyroscope]),
    ("acceleration in world axes (m/s²)", &[Channel::Acceleration]),
    ("acceleration in body axes (m/s²)", &[Channel::AccelerationBody]),
    ("velocity in body axes (m/s)", &[Channel::VelocityBody]),
    ("position in body axes (m)", &[Channel::PositionBody]),
    ("precession, nutation, spin (rad)", &[Channel::FigureAngles]),
    ("rates of precession, nutation, spin (rad/s)", &[Channel::FigureRates]),
    ("tilt from L, phase on the polhode (rad)", &[Channel::MomentumTilt, Channel::PolhodePhase]),
    ("distance from the separatrix (1)", &[Channel::SeparatrixDistance]),
    ("Kovalevskaya's integral (rad⁴/s⁴)", &[Channel::KovalevskayaIntegral]),
    ("Euler angles about z, x, z (rad)", &[Channel::EulerZxz]),
    ("Euler angles about z, y, z (rad)", &[Channel::EulerZyz]),
    ("Euler angles about z, y, x (rad)", &[Channel::EulerZyx]),
    ("Euler angles about x, y, z (rad)", &[Channel::EulerXyz]),
];

/// Okabe and Ito's colours, as the other format draws x, y, z and what follows.
const COLOURS: [&str; 5] = ["#d55e00", "#009e73", "#56b4e9", "#f0e442", "#cc79a7"];

/// Writes the layout that Foxglove and Lichtblick import for the `.mcap` of `plan`, and names the file.
///
/// # Errors
/// If it cannot be written, or the motion cannot be looked over for the camera.
pub fn write(plan: &Plan, mut file: PartFile) -> Result<(), RecordingError> {
    let layout = layout(plan, &Picture::of(plan)?);
    file.write_all(format!("{layout:#}\n").as_bytes()).map_err(|source| RecordingError::Io {
        attempt: "write",
        path: file.path().into(),
        source,
    })?;
    file.publish()
}

/// The picture above the events on the left, plots below each other on the right.
fn layout(plan: &Plan, picture: &Picture) -> Value {
    let mut panels = Map::new();
    panels.insert("3D!scene".into(), scene(plan, picture));
    panels.insert("RosOut!log".into(), json!({ "topicToRender": "/log", "minLogLevel": 1, "searchTerms": [] }));
    let mut plots = Vec::new();
    for (number, (title, channels)) in PLOTS.iter().enumerate() {
        let paths: Vec<_> = plan.watched().flat_map(|watched| paths(plan, watched, channels)).collect();
        if !paths.is_empty() {
            let id = format!("Plot!{number}");
            panels.insert(id.clone(), plot(title, &coloured(paths)));
            plots.push(id);
        }
    }
    let left = json!({ "direction": "column", "first": "3D!scene", "second": "RosOut!log", "splitPercentage": 82 });
    let whole = match stacked(&plots) {
        Some(plots) => json!({ "direction": "row", "first": left, "second": plots, "splitPercentage": 60 }),
        None => left,
    };
    json!({
        "configById": panels,
        "globalVariables": {},
        "userNodes": {},
        "playbackConfig": { "speed": picture.playback_speed },
        "layout": whole,
    })
}

/// Looks from where the other format does: `phi` is the angle from +z, `thetaOffset` that from −y to the left.
fn scene(plan: &Plan, picture: &Picture) -> Value {
    let from_target = picture.eye - picture.target;
    let distance = from_target.norm();
    let flat = libm::hypot(from_target.x, from_target.y);
    json!({
        "cameraState": {
            "perspective": true,
            "distance": distance,
            "phi": libm::atan2(flat, from_target.z).to_degrees(),
            "thetaOffset": libm::atan2(-from_target.x, -from_target.y).to_degrees(),
            "target": [0, 0, 0],
            "targetOffset": picture.target.as_slice(),
            "targetOrientation": [0, 0, 0, 1],
            "fovy": 55,
            "near": 0.01 * distance,
            "far": 100.0 * distance,
        },
        "followMode": "follow-none",
        "followTf": "world",
        "foxglovePanelTitle": plan.title,
        "lichtblickPanelTitle": plan.title,
        "scene": { "backgroundColor": "#15171b", "transforms": { "showLabel": false, "axisScale": 0 } },
        "layers": {
            "floor": {
                "layerId": "foxglove.Grid",
                "instanceId": "floor",
                "label": "Floor",
                "visible": true,
                "frameLocked": true,
                "frameId": "world",
                "size": 4.0 * distance,
                "divisions": 40,
                "lineWidth": 1,
                "color": "#8c96a032",
                "position": [picture.target.x, picture.target.y, picture.floor],
                "rotation": [0, 0, 0],
            },
        },
        "topics": { "/scene": { "visible": true }, "/scene/surfaces": { "visible": true } },
    })
}

/// Message paths and labels of what is recorded of `channels`.
fn paths(plan: &Plan, watched: Watched, channels: &[Channel]) -> Vec<(String, String)> {
    let name = watched.name();
    let owner = if plan.watched().nth(1).is_some() { format!("{name} ") } else { String::new() };
    let mut paths = Vec::new();
    for channel in channels.iter().filter(|channel| watched.channels().contains(channel)) {
        let row = channel.row();
        for component in row.components {
            let (dot, space) = if component.is_empty() { ("", "") } else { (".", " ") };
            let path = format!("/body/{name}/state.{}{dot}{component}", row.name);
            paths.push((path, format!("{owner}{}{space}{component}", row.title)));
        }
    }
    paths
}

fn coloured(paths: Vec<(String, String)>) -> Vec<Value> {
    let curve = |((path, label), colour): ((String, String), &&str)| json!({ "value": path, "label": label, "color": colour, "enabled": true, "timestampMethod": "receiveTime" });
    paths.into_iter().zip(COLOURS.iter().cycle()).map(curve).collect()
}

fn plot(title: &str, paths: &[Value]) -> Value {
    json!({
        "foxglovePanelTitle": title,
        "lichtblickPanelTitle": title,
        "paths": paths,
        "isSynced": true,
        "xAxisVal": "timestamp",
        "showLegend": true,
        "legendDisplay": "floating",
        "showXAxisLabels": true,
        "showYAxisLabels": true,
        "showPlotValuesInLegend": false,
        "sidebarDimension": 240,
    })
}

/// Below each other, all of one height.
fn stacked(panels: &[String]) -> Option<Value> {
    let (first, rest) = panels.split_first()?;
    let Some(below) = stacked(rest) else { return Some(json!(first)) };
    let share = 100.0 / f64::from(u32::try_from(panels.len()).unwrap_or(u32::MAX));
    Some(json!({ "direction": "column", "first": first, "second": below, "splitPercentage": share }))
}
