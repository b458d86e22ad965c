# SPDX-License-Identifier: BSD-2-Clause
"""Controllers of Trundle in Python: derive from Controller, describe fields and outputs as class attributes, bind ports in setup, act in
update. A text loads the file with #loadModule my_controller.py; the guide page python.md has a complete example."""

from .camera import CameraPort, Picture
from .controller import Controller, Log, fnv1a64, random_bits
from .description import VERSION as __version__
from .description import exactly_one_of, field, output
from .driver import DriveAmounts, Driver
from .ports import (AckermannDrivePort, CompassPort, DifferentialDrivePort, EncoderPort, GpsPort, GroundPort, GroundTruthPort, ImuPort,
                    LidarPort, LightPort, MotorPort, OmniDrivePort, Port, Pose, Pose2, RangePort, RobotPorts, ServoPort, TouchPort)
from .quantity import (Quantity, amperes, decibel_milliwatts, decibels, degrees, file, flag, hertz, kilograms, metres,
                       metres_per_second, metres_per_second_squared, milliseconds, needs, newton_metres, newtons, number, ohms, one_of,
                       radians_per_second, radians_per_second_squared, reference, seconds, text, unit_of, volts)
from .radio import EVERYBODY, FULL_POWER, Packet, RadioPort
from .remote import Disconnected, Reading, Remote, RemoteError, TextError, connect
from .signals import Slot, UnknownPort
from .simulation import Simulation
