//! Messages of ROS 2, by the definitions that all its distributions share. Quaternions are x, y, z, w.

use super::cdr::Cdr;
use crate::recording::foreign::gathering::{Place, Statement};

/// A stamp of a header, ns, and the frame that it names.
struct Header {
    stamp_ns: i64,
    frame: String,
}

fn header(cdr: &mut Cdr) -> Option<Header> {
    let (seconds, nanoseconds) = (cdr.u32()?.cast_signed(), cdr.u32()?);
    let stamp_ns = i64::from(seconds) * 1_000_000_000 + i64::from(nanoseconds);
    Some(Header { stamp_ns, frame: cdr.text()? })
}

fn quaternion(cdr: &mut Cdr) -> Option<[f64; 4]> {
    let [x, y, z, w] = cdr.doubles()?;
    Some([w, x, y, z])
}

/// `tf2_msgs/msg/TFMessage`
pub(super) fn transforms(cdr: &mut Cdr, said: &mut Vec<Statement>) -> Option<()> {
    for _ in 0..cdr.u32()? {
        transform(cdr, said)?;
    }
    Some(())
}

/// `geometry_msgs/msg/TransformStamped`
pub(super) fn transform(cdr: &mut Cdr, said: &mut Vec<Statement>) -> Option<()> {
    let (Header { stamp_ns, frame }, child) = (header(cdr)?, cdr.text()?);
    let (position, attitude) = (Some(cdr.doubles()?), Some(quaternion(cdr)?));
    let place = Place::transform(frame, child);
    said.push(Statement { place, stamp_ns: Some(stamp_ns), position, attitude, ..Statement::default() });
    Some(())
}

/// `geometry_msgs/msg/PoseStamped`
pub(super) fn pose(cdr: &mut Cdr, said: &mut Vec<Statement>) -> Option<()> {
    let Header { stamp_ns, frame } = header(cdr)?;
    let (position, attitude) = (Some(cdr.doubles()?), Some(quaternion(cdr)?));
    let place = Place { fixed: Some(frame), ..Place::default() };
    said.push(Statement { place, stamp_ns: Some(stamp_ns), position, attitude, ..Statement::default() });
    Some(())
}

/// `geometry_msgs/msg/PoseWithCovarianceStamped`
pub(super) fn pose_with_covariance(cdr: &mut Cdr, said: &mut Vec<Statement>) -> Option<()> {
    pose(cdr, said)?;
    cdr.doubles::<36>().map(drop)
}

/// `geometry_msgs/msg/TwistStamped`
pub(super) fn twist(cdr: &mut Cdr, said: &mut Vec<Statement>) -> Option<()> {
    let Header { stamp_ns, frame } = header(cdr)?;
    let (velocity, angular_velocity) = (Some(cdr.doubles()?), Some(cdr.doubles()?));
    let place = Place { axes: Some(frame), ..Place::default() };
    said.push(Statement { place, stamp_ns: Some(stamp_ns), velocity, angular_velocity, ..Statement::default() });
    Some(())
}

/// `geometry_msgs/msg/TwistWithCovarianceStamped`
pub(super) fn twist_with_covariance(cdr: &mut Cdr, said: &mut Vec<Statement>) -> Option<()> {
    twist(cdr, said)?;
    cdr.doubles::<36>().map(drop)
}

/// `geometry_msgs/msg/WrenchStamped`
pub(super) fn wrench(cdr: &mut Cdr, said: &mut Vec<Statement>) -> Option<()> {
    let Header { stamp_ns, frame } = header(cdr)?;
    let _force: [f64; 3] = cdr.doubles()?;
    let moment = Some(cdr.doubles()?);
    let place = Place { axes: Some(frame), ..Place::default() };
    said.push(Statement { place, stamp_ns: Some(stamp_ns), moment, ..Statement::default() });
    Some(())
}

/// `sensor_msgs/msg/Imu`: in the axes of its own frame; what it does not measure has −1 for its first covariance.
pub(super) fn imu(cdr: &mut Cdr, said: &mut Vec<Statement>) -> Option<()> {
    let Header { stamp_ns, frame } = header(cdr)?;
    let (attitude, [attitude_covariance, ..]) = (quaternion(cdr)?, cdr.doubles::<9>()?);
    let (rates, [rate_covariance, ..]) = (cdr.doubles()?, cdr.doubles::<9>()?);
    let _acceleration: ([f64; 3], [f64; 9]) = (cdr.doubles()?, cdr.doubles()?);
    said.push(Statement {
        place: Place { moving: Some(frame.clone()), axes: Some(frame), ..Place::default() },
        stamp_ns: Some(stamp_ns),
        attitude: (attitude_covariance != -1.0).then_some(attitude),
        angular_velocity: (rate_covariance != -1.0).then_some(rates),
        ..Statement::default()
    });
    Some(())
}

/// `nav_msgs/msg/Odometry`: the pose in the header's frame, the twist in the child's.
pub(super) fn odometry(cdr: &mut Cdr, said: &mut Vec<Statement>) -> Option<()> {
    let (Header { stamp_ns, frame }, child) = (header(cdr)?, cdr.text()?);
    let (position, attitude) = (Some(cdr.doubles()?), Some(quaternion(cdr)?));
    let _pose_covariance: [f64; 36] = cdr.doubles()?;
    let (velocity, angular_velocity) = (Some(cdr.doubles()?), Some(cdr.doubles()?));
    let _twist_covariance: [f64; 36] = cdr.doubles()?;
    said.push(Statement {
        place: Place { fixed: Some(frame), moving: Some(child.clone()), axes: Some(child), ..Place::default() },
        stamp_ns: Some(stamp_ns),
        attitude,
        position,
        angular_velocity,
        velocity,
        ..Statement::default()
    });
    Some(())
}
