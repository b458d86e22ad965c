# SPDX-License-Identifier: BSD-2-Clause
"""Ports: a controller's access to the devices of its robot. Bind them in setup, by name. A port reads what the devices published at the
end of the last tick; what it writes takes effect in this one. SI units and radians throughout."""

import math
from typing import NamedTuple

from .camera import CameraPort
from .radio import RadioPort
from .signals import UnknownPort, unknown_signal


class Pose2(NamedTuple):
    """A pose on the floor: m, rad, positive to the left."""
    x: float
    y: float
    heading: float


class Pose(NamedTuple):
    """A pose in the world: x, y, z [m] and the quaternion w, x, y, z."""
    position: tuple
    rotation: tuple

    def direction(self, v):
        """A direction of its axes in those of the world."""
        w, x, y, z = self.rotation
        a, b, c = 2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])
        return v[0] + w * a + y * c - z * b, v[1] + w * b + z * a - x * c, v[2] + w * c + x * b - y * a

    def point(self, p):
        """A point of its axes in those of the world, m."""
        turned = self.direction(p)
        return tuple(a + b for a, b in zip(self.position, turned))


class Port:
    """Any device: its outputs are read, its commands read and written, by name."""

    def __init__(self, slots):
        self._slots = slots

    def names(self):
        return list(self._slots)

    def size(self, signal):
        return self._slot(signal).count

    def get(self, signal, element=0):
        return self._slot(signal).get(element)

    def values(self, signal):
        return self._slot(signal).values()

    def set(self, signal, value, element=0):
        slot = self._slot(signal)
        if not slot.writable:
            raise AttributeError(f"'{signal}' is measured, not commanded")
        slot.set(value, element)

    def _slot(self, signal):
        try:
            return self._slots[signal]
        except KeyError:
            raise UnknownPort(unknown_signal(signal, self._slots)) from None


class BasePort(Port):
    """What the ports of all bases have: amounts with an end, and odometry."""

    _number = 0.0

    def done(self):
        """True once the last amount that this port commanded has finished or was refused."""
        return self.get("finished") >= min(self._number, self.get("sequence"))  # a reset counts from 0 again

    def odometry(self):
        """Pose of the base's centre, as in `pose` of its kind, from wheel odometry, relative to the start."""
        now = self._slots["odometry"]
        return Pose2(now.get(0), now.get(1), now.get(2))

    def _begin(self):
        self._number = self.get("sequence") + 1
        self.set("sequence", self._number)


class DifferentialDrivePort(BasePort):
    """A DifferentialDrive, a SkidDrive or a TrackDrive."""

    def move(self, linear, angular):
        """Drives at `linear` m/s and turns left at `angular` rad/s until the next command. Cancels a running drive()."""
        self._command(linear, angular, 0.0, 0.0)

    def stop(self):
        self.move(0.0, 0.0)

    def drive(self, linear, angular, linear_amount, angular_amount):
        """Drives `linear_amount` m and turns `angular_amount` rad, at most at the given speeds. An amount of 0 means no limit. Each
        amount must have the sign of its speed."""
        self._command(linear, angular, linear_amount, angular_amount)
        self._begin()

    def turn(self, speed, angle):
        """Turns in place by `angle` rad at `speed` rad/s; the sign is that of the angle. An angle of 0 is no turn."""
        self.drive(0.0, math.copysign(speed, angle) if angle else 0.0, 0.0, angle)

    def _command(self, linear, angular, linear_amount, angular_amount):
        self.set("linearVelocity", linear)
        self.set("angularVelocity", angular)
        self.set("linearAmount", linear_amount)
        self.set("angularAmount", angular_amount)


class OmniDrivePort(BasePort):
    """An OmniDrive or a MecanumDrive."""

    def move(self, forward, left, angular):
        """Moves at `forward` and `left` m/s, in its own frame, and turns left at `angular` rad/s until the next command. Cancels a
        running drive()."""
        self._command(forward, left, angular, 0.0, 0.0)

    def stop(self):
        self.move(0.0, 0.0, 0.0)

    def drive(self, forward, left, angular, linear_amount, angular_amount):
        """Goes `linear_amount` m along the velocity and turns `angular_amount` rad, at most at the given speeds. An amount of 0 means
        no limit. The way is positive; the angle has the sign of its speed."""
        self._command(forward, left, angular, linear_amount, angular_amount)
        self._begin()

    def turn(self, speed, angle):
        """Turns in place by `angle` rad at `speed` rad/s; the sign is that of the angle. An angle of 0 is no turn."""
        self.drive(0.0, 0.0, math.copysign(speed, angle) if angle else 0.0, 0.0, angle)

    def _command(self, forward, left, angular, linear_amount, angular_amount):
        self.set("linearVelocity", forward)
        self.set("lateralVelocity", left)
        self.set("angularVelocity", angular)
        self.set("linearAmount", linear_amount)
        self.set("angularAmount", angular_amount)


class AckermannDrivePort(BasePort):
    def move(self, linear, steering_angle):
        """Drives at `linear` m/s with the wheels steered by `steering_angle` rad, positive to the left, until the next command. Cancels
        a running drive()."""
        self._command(linear, steering_angle, 0.0)

    def stop(self):
        """Brakes, and keeps its wheels as they are steered."""
        self.move(0.0, self.get("steeringAngle"))

    def drive(self, linear, steering_angle, linear_amount):
        """Drives `linear_amount` m, which has the sign of `linear`, at most at that speed."""
        self._command(linear, steering_angle, linear_amount)
        self._begin()

    def steering(self):
        """rad, the angle that it has."""
        return self.get("steering")

    def _command(self, linear, steering_angle, linear_amount):
        self.set("linearVelocity", linear)
        self.set("steeringAngle", steering_angle)
        self.set("linearAmount", linear_amount)


class MotorPort(Port):
    def set_voltage(self, volts):
        self.set("servo", 0.0)
        self.set("voltage", volts)

    def current(self):
        """A."""
        return self.get("current")

    def torque(self):
        """N m at the joint."""
        return self.get("torque")

    def rate(self):
        """rad/s of the joint."""
        return self.get("rate")


class EncoderPort(Port):
    def count(self):
        """Counts since the start, negative backwards."""
        return int(self.get("count"))

    def angle(self):
        """rad, from the counts."""
        return self.get("angle")

    def rate(self):
        """rad/s, from the counts of the last tick."""
        return self.get("rate")

    def index(self):
        return self.get("index") != 0


class TouchPort(Port):
    def pressed(self):
        return self.get("pressed") != 0

    def force(self):
        """N."""
        return self.get("force")

    def contacts(self):
        return int(self.get("count"))


class SensorPort(Port):
    """A sensor whose readings have a time."""

    _seen = -1.0

    def time(self):
        """When the reading was measured, s; -1 before the first."""
        return self.get("time")

    def fresh(self):
        """True if there is a reading newer than at the last call."""
        now = self.time()
        is_new, self._seen = now != self._seen, now
        return is_new


class RangePort(SensorPort):
    def range(self):
        """m."""
        return self.get("range")

    def voltage(self):
        """V; of infrared sensors."""
        return self.get("voltage")


class LidarPort(SensorPort):
    def ranges(self):
        """m, layer by layer from below, each from -FieldOfView/2 counter-clockwise: a read-only memoryview of doubles, in place;
        numpy.asarray() makes an array of it without a copy. It shows the next scan when there is one."""
        return self.values("ranges")

    def range(self, beam):
        """m."""
        return self.get("ranges", beam)

    def intensities(self):
        """Share of light that is returned, in the order of ranges(); zeros unless Intensity is set. Memory as of ranges()."""
        return self.values("intensities")


class ImuPort(SensorPort):
    def angular_velocity(self):
        """rad/s in its own frame."""
        return tuple(self.values("angularVelocity"))

    def acceleration(self):
        """m/s^2 in its own frame."""
        return tuple(self.values("acceleration"))

    def orientation(self):
        """In the world, quaternion w, x, y, z; identity unless Orientation is set."""
        turned = tuple(self.values("orientation"))
        return turned if any(turned) else (1.0, 0.0, 0.0, 0.0)


class CompassPort(SensorPort):
    def heading(self):
        """rad, from -pi to pi."""
        return self.get("heading")


class GpsPort(SensorPort):
    def position(self):
        """m in the world."""
        return tuple(self.values("position"))

    def velocity(self):
        """m/s in the world."""
        return tuple(self.values("velocity"))


class GroundPort(SensorPort):
    def reflectance(self):
        """From 0 (black) to 1 (white)."""
        return self.get("reflectance")


class ForcePort(SensorPort):
    """Of the joint's parent on its child, in the sensor's own frame."""

    def force(self):
        """N."""
        return tuple(self.values("force"))

    def torque(self):
        """N m about the sensor's place."""
        return tuple(self.values("torque"))


class LightPort(SensorPort):
    def illuminance(self):
        """lx."""
        return self.get("illuminance")


class ServoPort(Port):
    """Of a Servo or a LinearMotor."""

    def set_target(self, target):
        """rad or m, with Mode=speed rad/s or m/s."""
        self.set("target", target)

    def position(self):
        """rad or m."""
        return self.get("position")

    def rate(self):
        """rad/s or m/s."""
        return self.get("rate")

    def saturated(self):
        """Its torque, force or speed is not enough."""
        return self.get("saturated") != 0


class BatteryPort(Port):
    def voltage(self):
        """V; 0 when it is empty."""
        return self.get("voltage")

    def current(self):
        """A."""
        return self.get("current")

    def charge(self):
        """C that is left."""
        return self.get("charge")

    def level(self):
        """Share that is left, from 0 to 1."""
        return self.get("level")

    def charge_current(self):
        """A from a Charger."""
        return self.get("chargeCurrent")

    def charging(self):
        return self.charge_current() > 0


class GripperPort(Port):
    def set_opening(self, opening):
        """m from the start pose; negative closes."""
        self.set("opening", opening)

    def position(self):
        """m."""
        return self.get("position")

    def force(self):
        """N between its jaws."""
        return self.get("force")

    def holding(self):
        """Something is between its jaws."""
        return self.get("holding") != 0


class BeltPort(Port):
    """Of a Belt or a Track."""

    def set_speed(self, speed):
        """m/s."""
        self.set("speed", speed)

    def rate(self):
        """m/s."""
        return self.get("rate")

    def travel(self):
        """m, negative backwards."""
        return self.get("travel")


class PenPort(Port):
    def set_down(self, down):
        self.set("down", 1.0 if down else 0.0)

    def length(self):
        """m, of all that it has drawn."""
        return self.get("length")


class LedPort(Port):
    def set_on(self, on):
        self.set("on", 1.0 if on else 0.0)

    def set_color(self, red, green, blue):
        """From 0 to 1, as in pictures."""
        for element, value in enumerate((red, green, blue)):
            self.set("color", value, element)

    def lit(self):
        """It is on and has power."""
        return self.get("lit") != 0


class ChargerPort(Port):
    def connected(self):
        """A battery takes power."""
        return self.get("connected") != 0

    def voltage(self):
        """V."""
        return self.get("voltage")

    def current(self):
        """A."""
        return self.get("current")

    def energy(self):
        """J since the start."""
        return self.get("energy")


class LatchPort(Port):
    def set_engage(self, engage):
        self.set("engage", 1.0 if engage else 0.0)

    def engaged(self):
        """It holds something."""
        return self.get("engaged") != 0

    def in_reach(self):
        """Something that it could hold is within Reach."""
        return self.get("inReach") != 0

    def force(self):
        """N between it and what it holds."""
        return self.get("force")


class GroundTruthPort:
    """Exact state that a real robot cannot measure; to evaluate a controller, not for control."""

    def __init__(self, image):
        self._pose, self._velocity = image.truth("pose"), image.truth("velocity")

    def pose(self):
        """Of the robot's config frame in the world."""
        now = tuple(self._pose.values())
        return Pose(now[:3], now[3:])

    def linear_velocity(self):
        """m/s."""
        return tuple(self._velocity.values()[:3])

    def angular_velocity(self):
        """rad/s."""
        return tuple(self._velocity.values()[3:])


def _binder(name, port, kind):
    def bind(self, device):
        return port(self._image.bind_all(kind, device))

    bind.__name__ = name
    bind.__doc__ = f"The port of a {kind}."
    return bind


class RobotPorts:
    """Passed to Controller.setup to bind ports. An unknown name raises UnknownPort, whose message lists the available names."""

    def __init__(self, image, tick, outside):
        self._image, self._tick, self._outside = image, tick, outside

    @property
    def name(self):
        return self._image.robot

    @property
    def tick(self):
        """s."""
        return self._tick

    def has(self, device, signal=""):
        """Whether the robot has a device with this name and, if given, the device a signal with that name."""
        return self._image.has(device, signal)

    differential_drive = _binder("differential_drive", DifferentialDrivePort, "DifferentialDrive")
    motor = _binder("motor", MotorPort, "RotaryMotor")
    encoder = _binder("encoder", EncoderPort, "Encoder")
    touch = _binder("touch", TouchPort, "TouchSensor")
    range_sensor = _binder("range_sensor", RangePort, "RangeSensor")
    lidar = _binder("lidar", LidarPort, "Lidar")
    imu = _binder("imu", ImuPort, "Imu")
    compass = _binder("compass", CompassPort, "Compass")
    gps = _binder("gps", GpsPort, "Gps")
    ground_sensor = _binder("ground_sensor", GroundPort, "GroundSensor")
    force_sensor = _binder("force_sensor", ForcePort, "ForceSensor")
    light_sensor = _binder("light_sensor", LightPort, "LightSensor")
    servo = _binder("servo", ServoPort, "Servo")
    linear_motor = _binder("linear_motor", ServoPort, "LinearMotor")
    battery = _binder("battery", BatteryPort, "Battery")
    gripper = _binder("gripper", GripperPort, "Gripper")
    skid_drive = _binder("skid_drive", DifferentialDrivePort, "SkidDrive")
    omni_drive = _binder("omni_drive", OmniDrivePort, "OmniDrive")
    mecanum_drive = _binder("mecanum_drive", OmniDrivePort, "MecanumDrive")
    ackermann_drive = _binder("ackermann_drive", AckermannDrivePort, "AckermannDrive")
    belt = _binder("belt", BeltPort, "Belt")
    track = _binder("track", BeltPort, "Track")
    track_drive = _binder("track_drive", DifferentialDrivePort, "TrackDrive")
    pen = _binder("pen", PenPort, "Pen")
    led = _binder("led", LedPort, "Led")
    charger = _binder("charger", ChargerPort, "Charger")
    latch = _binder("latch", LatchPort, "Latch")

    def object_name(self, number):
        """Name of an object by its number in a ground truth signal, "box1/block"; "" if there is none."""
        return self._outside.object_name(int(number))

    def camera(self, device):
        """The port of a Camera."""
        streams = self._image.device("Camera", device)[2] > 0
        return CameraPort(self._outside, device, self._image.bind("Camera", device, "frame") if streams else None)

    def radio(self, device):
        """The port of a Transceiver."""
        self._image.bind("Transceiver", device, "rssi")
        return RadioPort(self._outside, self._outside.find_radio(f"{self.name}/{device}"))

    def port(self, device, kind=""):
        """The port of a device of any kind, for example of a module."""
        return Port(self._image.bind_all(kind, device))

    def signal(self, device, signal):
        """Any signal of any device. Only commands can be set."""
        return self._image.bind("", device, signal)

    def ground_truth(self, path=None):
        """The robot's own ground truth; with a path, such as "base/pose", that signal of a device."""
        return GroundTruthPort(self._image) if path is None else self._image.truth(path)
