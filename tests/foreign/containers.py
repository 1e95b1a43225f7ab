# pip install mcap==1.6.0 mcap-protobuf-support==0.6.0 foxglove-schemas-protobuf==0.4.0 rosbags==0.11.9 rerun-sdk==0.36.3
# python containers.py
#
# One motion, a top whose axis goes round at an angle of 0.4 rad, as programs that know nothing of this crate write it:
# attitude Rz(0.7 t) Rx(0.4) Rz(1.9 t), position (t, 2, −t). The test makes the same of t.
import json
import math

import foxglove_schemas_protobuf.FrameTransform_pb2 as frame_transform
import foxglove_schemas_protobuf.FrameTransforms_pb2 as frame_transforms
import foxglove_schemas_protobuf.Odometry_pb2 as odometry
import foxglove_schemas_protobuf.PoseInFrame_pb2 as pose_in_frame
import foxglove_schemas_protobuf.PosesInFrame_pb2 as poses_in_frame
import numpy
import rerun
from mcap.writer import CompressionType, Writer
from mcap_protobuf.writer import Writer as ProtobufWriter
from rosbags.typesys import Stores, get_typestore

TILT, ROUND, SPIN = 0.4, 0.7, 1.9
START = 1_700_000_000_123_456_789
STEPS = [index * 20_000_000 for index in range(40)]  # ns


def product(p, q):
    a, b, c, d = p
    e, f, g, h = q
    return (a * e - b * f - c * g - d * h, a * f + b * e + c * h - d * g,
            a * g - b * h + c * e + d * f, a * h + b * g - c * f + d * e)


def attitude(t):
    z = lambda angle: (math.cos(angle / 2), 0, 0, math.sin(angle / 2))
    x = lambda angle: (math.cos(angle / 2), math.sin(angle / 2), 0, 0)
    return product(product(z(ROUND * t), x(TILT)), z(SPIN * t))


def rates_in_body(t):
    s = math.sin(TILT)
    return (ROUND * s * math.sin(SPIN * t), ROUND * s * math.cos(SPIN * t), ROUND * math.cos(TILT) + SPIN)


def rates_in_world(t):
    s = math.sin(TILT)
    return (SPIN * s * math.sin(ROUND * t), -SPIN * s * math.cos(ROUND * t), SPIN * math.cos(TILT) + ROUND)


def position(t):
    return (t, 2.0, -t)


STORE = get_typestore(Stores.ROS2_HUMBLE)
ROS = STORE.types


def header(stamp, frame):
    time = ROS["builtin_interfaces/msg/Time"](sec=stamp // 10**9, nanosec=stamp % 10**9)
    return ROS["std_msgs/msg/Header"](stamp=time, frame_id=frame)


def vector(values, kind="Vector3"):
    x, y, z = map(float, values)
    return ROS[f"geometry_msgs/msg/{kind}"](x=x, y=y, z=z)


def quaternion(values):
    w, x, y, z = map(float, values)
    return ROS["geometry_msgs/msg/Quaternion"](x=x, y=y, z=z, w=w)


def transform(stamp, parent, child, place, turn):
    body = ROS["geometry_msgs/msg/Transform"](translation=vector(place), rotation=quaternion(turn))
    return ROS["geometry_msgs/msg/TransformStamped"](header=header(stamp, parent), child_frame_id=child, transform=body)


class Ros:
    def __init__(self, name, compression):
        self.file = open(name, "wb")
        self.writer = Writer(self.file, chunk_size=4096, compression=compression)
        self.writer.start(profile="ros2", library="containers.py")
        self.topics = {}

    def write(self, topic, kind, log_time, message):
        if topic not in self.topics:
            text, _ = STORE.generate_msgdef(kind, ros_version=2)
            schema = self.writer.register_schema(kind, "ros2msg", text.encode())
            self.topics[topic] = self.writer.register_channel(topic, "cdr", schema)
        data = bytes(STORE.serialize_cdr(message, kind))
        self.writer.add_message(self.topics[topic], log_time, data, log_time)

    def finish(self):
        self.writer.finish()
        self.file.close()


# As a robot's bag: transforms with absolute stamps, one of them static, and an IMU that measures rates only.
bag = Ros("ros2_zstd.mcap", CompressionType.ZSTD)
TF = ROS["tf2_msgs/msg/TFMessage"]
bag.write("/tf_static", "tf2_msgs/msg/TFMessage", START,
          TF(transforms=[transform(START, "base_link", "camera", (0.1, 0, 0), (1, 0, 0, 0))]))
unknown = numpy.zeros(9)
unknown[0] = -1
for step in STEPS:
    stamp, t = START + step, step / 1e9
    logged = stamp + 1_500_000  # it takes a while to arrive
    bag.write("/tf", "tf2_msgs/msg/TFMessage", logged,
              TF(transforms=[transform(stamp, "odom", "base_link", position(t), attitude(t))]))
    imu = ROS["sensor_msgs/msg/Imu"](
        header=header(stamp, "base_link"), orientation=quaternion((1, 0, 0, 0)), orientation_covariance=unknown,
        angular_velocity=vector(rates_in_body(t)), angular_velocity_covariance=numpy.zeros(9),
        linear_acceleration=vector((0, 0, 9.8)), linear_acceleration_covariance=numpy.zeros(9))
    bag.write("/imu", "sensor_msgs/msg/Imu", logged, imu)
bag.finish()

# As a simulator's: time from 0, odometry, and pose, twist and wrench on topics of their own, told in the fixed frame.
bag = Ros("ros2_lz4.mcap", CompressionType.LZ4)
for step in STEPS:
    t = step / 1e9
    pose = ROS["geometry_msgs/msg/Pose"](position=vector(position(t), "Point"), orientation=quaternion(attitude(t)))
    in_body = ROS["geometry_msgs/msg/Twist"](linear=vector((1, 2, 3)), angular=vector(rates_in_body(t)))
    odom = ROS["nav_msgs/msg/Odometry"](
        header=header(step, "odom"), child_frame_id="base_link",
        pose=ROS["geometry_msgs/msg/PoseWithCovariance"](pose=pose, covariance=numpy.zeros(36)),
        twist=ROS["geometry_msgs/msg/TwistWithCovariance"](twist=in_body, covariance=numpy.zeros(36)))
    bag.write("/odom", "nav_msgs/msg/Odometry", step, odom)
    bag.write("/pose", "geometry_msgs/msg/PoseStamped", step,
              ROS["geometry_msgs/msg/PoseStamped"](header=header(step, "map"), pose=pose))
    twist = ROS["geometry_msgs/msg/Twist"](linear=vector((1, 0, -1)), angular=vector(rates_in_world(t)))
    bag.write("/twist", "geometry_msgs/msg/TwistStamped", step,
              ROS["geometry_msgs/msg/TwistStamped"](header=header(step, "map"), twist=twist))
    wrench = ROS["geometry_msgs/msg/Wrench"](force=vector((7, 8, 9)), torque=vector((0.1, 0.2, t)))
    bag.write("/wrench", "geometry_msgs/msg/WrenchStamped", step,
              ROS["geometry_msgs/msg/WrenchStamped"](header=header(step, "map"), wrench=wrench))
bag.finish()


def set_pose(pose, t):
    pose.position.x, pose.position.y, pose.position.z = position(t)
    w, x, y, z = attitude(t)
    pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z = w, x, y, z


# Foxglove's schemas as protobuf.
with open("foxglove_protobuf.mcap", "wb") as file, ProtobufWriter(file) as writer:
    for step in STEPS:
        t = step / 1e9
        one = frame_transform.FrameTransform(parent_frame_id="world", child_frame_id="top")
        one.timestamp.FromNanoseconds(step)
        one.translation.x, one.translation.y, one.translation.z = position(t)
        one.rotation.w, one.rotation.x, one.rotation.y, one.rotation.z = attitude(t)
        writer.write_message("/tf", frame_transforms.FrameTransforms(transforms=[one]), step, step)
        pose = pose_in_frame.PoseInFrame(frame_id="world")
        pose.timestamp.FromNanoseconds(step)
        set_pose(pose.pose, t)
        writer.write_message("/pose", pose, step, step)
        poses = poses_in_frame.PosesInFrame(frame_id="world")
        poses.timestamp.FromNanoseconds(step)
        first = poses.poses.add()
        first.position.x, first.position.y = 5, t
        first.orientation.w = 1
        set_pose(poses.poses.add(), t)
        writer.write_message("/poses", poses, step, step)
        state = odometry.Odometry(frame_id="world", body_frame_id="body")
        state.timestamp.FromNanoseconds(step)
        set_pose(state.pose, t)
        x, y, z = rates_in_body(t)
        state.angular_velocity.x, state.angular_velocity.y, state.angular_velocity.z = x, y, z
        writer.write_message("/odometry", state, step, step)

# The same as JSON.
with open("foxglove_json.mcap", "wb") as file:
    writer = Writer(file, compression=CompressionType.NONE)
    writer.start(library="containers.py")
    schema = writer.register_schema("foxglove.FrameTransform", "jsonschema", b'{"type": "object"}')
    topic = writer.register_channel("/tf", "json", schema)
    for step in STEPS:
        t = step / 1e9
        w, x, y, z = attitude(t)
        message = {
            "timestamp": {"sec": 0, "nsec": step}, "parent_frame_id": "world", "child_frame_id": "top",
            "translation": dict(zip("xyz", position(t))), "rotation": {"x": x, "y": y, "z": z, "w": w}}
        writer.add_message(topic, step, json.dumps(message).encode(), step)
    writer.finish()


# Rerun's own SDK: one transform as quaternion, one as axis and angle the other way round, one as matrix.
def record(name, log):
    stream = rerun.RecordingStream("containers", recording_id="containers", send_properties=False)
    stream.save(name)
    stream.reset_time()
    for index, step in enumerate(STEPS):
        log(stream, index, step)
    stream.flush()
    stream.disconnect()


def in_all_forms(stream, index, step):
    t = step / 1e9
    w, x, y, z = attitude(t)
    stream.set_time("sim", duration=t)
    stream.set_time("frame", sequence=index)
    if index == 0:
        stream.log("world/ground", rerun.Transform3D(quaternion=rerun.Quaternion(xyzw=[0, 0, 0, 1])), static=True)
        stream.log("world/back", rerun.Transform3D(relation=rerun.TransformRelation.ChildFromParent), static=True)
    stream.log("world/top", rerun.Transform3D(translation=position(t), quaternion=rerun.Quaternion(xyzw=[x, y, z, w])))
    sine = math.sqrt(x * x + y * y + z * z)
    turn = rerun.RotationAxisAngle(axis=[-x / sine, -y / sine, -z / sine], radians=2 * math.atan2(sine, w))
    stream.log("world/back", rerun.Transform3D.from_fields(rotation_axis_angle=turn))
    rows = [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]
    stream.log("world/matrix", rerun.Transform3D(mat3x3=rows))


def by_frames(stream, index, step):
    w, x, y, z = attitude(step / 1e9)
    stream.set_time("frame", sequence=index)
    stream.log("top", rerun.Transform3D(quaternion=rerun.Quaternion(xyzw=[x, y, z, w])))


record("rerun.rrd", in_all_forms)
record("rerun_frames.rrd", by_frames)
