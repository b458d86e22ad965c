#!/usr/bin/env python3
"""Writes a robot of many instances of one part: `many_parts.py [COUNT] [--blocks] [--wheels] > parts.sim`.

With one Repeat around one Part, or with --blocks one Part block for each; with --wheels each is a wheel with a motor and an encoder.
"""
import sys

HEAD = """#import common/materials.sim
#import common/surfaces.sim
PartConfig Bolt {
  Param r = 0.01
  Body head { Sphere ball { Radius=$r Mass=0.01 Material=grey Surface=plastic } }
  Fixed nail { Parent=$on Child=head }
}
RobotConfig Plate {
  Body base { Box board { Size=20,20,0.1 Mass=100 Material=grey Surface=plastic } }
"""

FIXED = "  Fixed nail { Parent=$on Child=head }\n"
WHEEL = """  Hinge axle { Parent=$on Child=head Axis=0,1,0 }
  RotaryMotor motor { Joint=axle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 GearRatio=30 MaxVoltage=12 }
  Encoder counts { Joint=axle CountsPerRevolution=100 }
"""


def main(arguments):
    numbers = [int(a) for a in arguments if a.isdigit()]
    count = numbers[0] if numbers else 10000
    sys.stdout.write(HEAD.replace(FIXED, WHEEL) if "--wheels" in arguments else HEAD)
    if "--blocks" in arguments:
        for i in range(count):
            sys.stdout.write(f"  Part bolt{i} {{ Config=Bolt on=base Pos={i % 100 * 0.1:.1f},{i // 100 * 0.1:.1f},0.1 }}\n")
    else:
        place = "$(0.1*mod(index, 100)),$(0.1*floor(index/100)),0.1"
        sys.stdout.write(f"  Repeat bolt {{ Count={count} Pos={place} Part it {{ Config=Bolt on=base }} }}\n")
    sys.stdout.write("}\nRobot plate { Config=Plate }\n")


main(sys.argv[1:])
