# SPDX-License-Identifier: BSD-2-Clause
"""Controllers and components of Trundle in Python. A controller derives from Controller, describes fields and outputs as class attributes,
binds ports in setup, acts in update; a sensor derives from Sensor, any other component from Device. A text loads the file with
#loadModule my_controller.py; the guide pages python.md and components.md have complete examples."""

from .camera import CameraPort, Picture
from .controller import Controller, Log, fnv1a64, random_bits
from .description import VERSION as __version__
from .description import command, exactly_one_of, field, output, truth
from .device import BodyState, Contact, Device, Echoes, Geom, JointState, Mount, Peer, Supply, World, Wrench
from .driver import DriveAmounts, Driver
from .ports import (AckermannDrivePort, CompassPort, DifferentialDrivePort, EncoderPort, GpsPort, GroundPort, GroundTruthPort, ImuPort,
                    LidarPort, LightPort, MotorPort, OmniDrivePort, Port, Pose, Pose2, RangePort, RobotPorts, ServoPort, TouchPort)
from .quantity import (Quantity, amperes, decibel_milliwatts, decibels, degrees, file, flag, hertz, kilograms, metres,
                       metres_per_second, metres_per_second_squared, milliseconds, needs, newton_metres, newtons, number, ohms, one_of,
                       radians_per_second, radians_per_second_squared, reference, seconds, text, unit_of, volts)
from .radio import EVERYBODY, FULL_POWER, Packet, RadioPort
from .remote import Disconnected, Reading, Remote, RemoteError, TextError, connect
from .sensor import RangeNoise, Sensor, SensorClock, normal_deviate
from .signals import Slot, UnknownPort
from .simulation import Simulation
