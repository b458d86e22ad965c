"""Texts of the measured experiments, made from nothing but the shipped configs."""

import math
import os


def pattern(count):
    """Columns and rows of the grid that holds `count` robots: as square as it divides."""
    rows = int(math.sqrt(count))
    while count % rows:
        rows -= 1
    return count // rows, rows


def _room(x, y):
    return f"""StaticConfig Room {{
  Plane floor {{ Material=concrete Surface=ground }}
  Box north {{ Pos=0, {y / 2 + 0.05}, 0.15   Size={x + 0.2}, 0.1, 0.3  Material=wood Surface=wall }}
  Box south {{ Pos=0, {-y / 2 - 0.05}, 0.15  Size={x + 0.2}, 0.1, 0.3  Material=wood Surface=wall }}
  Box east  {{ Pos={x / 2 + 0.05}, 0, 0.15   Size=0.1, {y}, 0.3  Material=wood Surface=wall }}
  Box west  {{ Pos={-x / 2 - 0.05}, 0, 0.15  Size=0.1, {y}, 0.3  Material=wood Surface=wall }}
}}
Static room {{ Config=Room }}
"""


def crowd(count, seconds, tick=0.01):
    """`count` shipped robots, one per square metre, wandering in a walled room of at least 4 m x 4 m."""
    columns, rows = pattern(count)
    x, y = max(columns, 4), max(rows, 4)
    return f"""Tick = {tick}   Duration = {seconds}   Solver = exact   Threads = 1
#import robots/simple_robot.sim
#import common/materials.sim
#import common/surfaces.sim
#loadModule controllers/random_drive

{_room(x, y)}Grid crowd {{
  Config=SimpleRobot  Count={columns},{rows}  Spacing=1
  RandomDrive brain {{ Speed=0.3 TurnRate=1 Period=1 }}
}}
"""


def parked(count, seconds, controlled=True):
    """`count` shipped robots on a plane that stand still; each controller commands that in every tick."""
    columns, rows = pattern(count)
    brain = "RandomDrive brain { Speed=0 TurnRate=0 Period=0.01 }" if controlled else ""
    return f"""Tick = 0.01   Duration = {seconds}
#import robots/simple_robot.sim
#import arenas/open_floor.sim
#loadModule controllers/random_drive
Static floor {{ Config=OpenFloor }}
Grid crowd {{ Config=SimpleRobot  Count={columns},{rows}  Spacing=0.6
  {brain}
}}
"""


def small_crowd(count, seconds):
    """`count` robots of the size and masses of the peer program's: 0.20 m x 0.15 m with two wheels under it and two sliders, one per
    square metre of a walled square, with new speeds every second."""
    columns, rows = pattern(count)
    side = max(2.0, math.sqrt(count))
    wheel = """  Body {0} {{ Pos=0, {1}, 0.04
    Cylinder tyre {{ Radius=0.04 Length=0.02 HPR=0,0,90 Mass=0.1 Material=black Surface=rubber }} }}
  Hinge {0}Axle {{ Parent=chassis Child={0} Axis=0,1,0 }}
  RotaryMotor {0}Motor {{ Joint={0}Axle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 GearRatio=30 MaxVoltage=12 }}
"""
    return f"""Tick = 0.01   Duration = {seconds}   Solver = exact   Threads = 1
#import common/materials.sim
#import common/surfaces.sim
#loadModule controllers/random_drive

RobotConfig SmallRobot {{
  Body chassis {{
    Box hull     {{ Size=0.20,0.15,0.06  Pos=0,0,0.05  Mass=1.5  Material=lightgrey  Surface=wall }}
    Sphere front {{ Radius=0.02  Pos=0.08,0,0.02   Mass=0.001  Material=darkgrey  Surface=slick }}
    Sphere rear  {{ Radius=0.02  Pos=-0.08,0,0.02  Mass=0.001  Material=darkgrey  Surface=slick }}
  }}
{wheel.format("left", 0.065)}{wheel.format("right", -0.065)}
  DifferentialDrive base {{ LeftMotor=leftMotor RightMotor=rightMotor WheelRadius=0.04 WheelSeparation=0.13 }}
}}
{_room(side, side)}Grid crowd {{
  Config=SmallRobot  Count={columns},{rows}  Spacing={side / max(columns, rows):g}
  RandomDrive brain {{ Speed=0.4 TurnRate=2.9 Period=1 }}
}}
"""


def with_lidars(text, pitch=0):
    """The same with a lidar of 360 beams at 10 Hz on each robot of small_crowd()."""
    lidar = f"  Lidar eye {{ Body=chassis Pos=0,0,0.09 HPR=0,{pitch},0 Beams=360 MaxRange=5 UpdatePeriod=0.1 }}\n"
    return text.replace("  DifferentialDrive base", lidar + "  DifferentialDrive base")


def above_hills(text, side, folder):
    """The same above rolling ground of 20,000 triangles in place of the plane. Robots float, so that their contacts cost nothing."""
    cells, step = 100, side / 100
    with open(os.path.join(folder, "hills.obj"), "w", encoding="utf-8") as file:
        for k in range(cells + 1):
            for i in range(cells + 1):
                x, y = (i - cells / 2) * step, (k - cells / 2) * step
                file.write(f"v {x:.6f} {y:.6f} {0.06 * math.sin(1.9 * x) * math.cos(1.3 * y) + 0.05 * math.sin(0.7 * x - 1.1 * y):.6f}\n")
        for k in range(cells):
            for i in range(cells):
                a = k * (cells + 1) + i + 1
                file.write(f"f {a} {a + 1} {a + cells + 1}\nf {a + 1} {a + cells + 2} {a + cells + 1}\n")
    text = text.replace("Plane floor {", "Mesh floor { File=hills.obj").replace("Grid crowd {", "Grid crowd { Pos=0,0,0.12")
    return "Gravity = 0,0,0\n" + text


def singles(count, config="SimpleRobot", further=""):
    """`count` robots, each a block of its own as a person edits them, one per square metre of a walled room; one is named middle."""
    columns, rows = pattern(count)
    text = f"""Tick = 0.01   Duration = 1000
#import robots/simple_robot.sim
#import common/materials.sim
#import common/surfaces.sim
#loadModule controllers/random_drive

{_room(max(columns, 4), max(rows, 4))}{further}"""
    for i in range(count):
        middle = i == columns * (rows // 2) + columns // 2
        x, y = i % columns - columns // 2, i // columns - rows // 2
        text += f"""
Robot {'middle' if middle else f'robot{i}'} {{
  Config={config}
  Pos={'0.0' if middle else x},{y},0  HPR={37 * i % 360},0,0
  RandomDrive brain {{ Speed=0.3 TurnRate=1 Period=1 }}
}}
"""
    return text


def lidars(count):
    """`count` shipped robots with a lidar of 360 beams each, in a walled room."""
    columns, rows = pattern(count)
    return f"""Tick = 0.01   Duration = 1000
#import robots/lidar_robot.sim
#import common/materials.sim
#import common/surfaces.sim

{_room(max(columns, 4), max(rows, 4))}
Grid robots {{ Config=LidarRobot  Count={columns},{rows}  Spacing=1,1 }}
"""


def long_text(lines=2000, robots=150):
    """A text of so many lines: robots, a robot described in it, and scenery of many blocks."""
    here = os.path.dirname(os.path.abspath(__file__))
    with open(os.path.join(here, "..", "..", "configs", "robots", "simple_robot.sim"), encoding="utf-8") as file:
        described = "".join(line for line in file if not line.startswith("#")).replace("SimpleRobot", "OwnRobot")

    def text(walls):
        blocks = "".join(f"  Box block{i} {{ Pos={i % 40 - 20 + 0.5},{i // 40 - 12 + 0.5},0.05  Size=0.1,0.1,0.1  Material=wood Surface=wall }}\n"
                         for i in range(walls))
        return singles(robots, "OwnRobot", f"{described}\nStaticConfig Blocks {{\n{blocks}}}\nStatic blocks {{ Config=Blocks }}\n")

    return text(lines - text(0).count("\n"))


def seen(count, width, height):
    """`count` shipped robots that wander in a walled room, all of them in view of a camera on a tower beside it."""
    columns, rows = pattern(count)
    room = _room(0.7 * columns + 0.6, 0.7 * rows + 0.6)
    return f"""Tick = 0.01   Duration = 1000   Solver = exact   Threads = 1
#import robots/simple_robot.sim
#import common/materials.sim
#import common/surfaces.sim
#loadModule controllers/random_drive

{room}Grid crowd {{
  Config=SimpleRobot  Count={columns},{rows}  Spacing=0.7
  RandomDrive brain {{ Speed=0.3 TurnRate=1 Period=1 }}
}}
RobotConfig Tower {{
  Body mast {{ Box pole {{ Size=0.2,0.2,3.4  Pos=0,0,1.7  Mass=200  Material=steel  Surface=ground }} }}
  Camera eye {{ Body=mast  Pos=0.15,0,3.3  HPR=0,29,0  Resolution={width},{height}  FieldOfView=60 }}
}}
Robot tower {{ Config=Tower  Pos={-0.35 * columns - 3:g},0,0 }}
"""


def camera_robots(count, width, height, seeing, seconds):
    """`count` robots that look for a red ball, each with a camera of its own that takes ten pictures a second, or none."""
    columns, rows = pattern(count)
    brain = "BlobFollow brain { Speed=0.2 KeepEvery=0 UpdatePeriod=0.1 }" if seeing else "RandomDrive brain { Speed=0.2 }"
    return f"""Tick = 0.01   Duration = {seconds}   Solver = auto   Threads = 1
#import robots/camera_robot.sim
#import arenas/colour_yard.sim
#loadModule controllers/blob_follow
#loadModule controllers/random_drive

Static yard {{ Config=ColourYard }}
Grid swarm {{
  Config=CameraRobot  Pos=-0.8,0,0  Count={columns},{rows}  Spacing=0.42,0.7
  eye.Resolution={width},{height}
  {brain}
}}
"""


def straight(distance, speed):
    return _drive("linear_motion", f"LinearMotion brain {{ Distance={distance} Speed={speed} }}", abs(distance) / speed + speed + 1)


def arc(angle, speed, turn_rate):
    # the drive's ramps: 1 m/s^2 and 4 rad/s^2
    return _drive("arc_motion", f"ArcMotion brain {{ Angle={angle} Speed={speed} TurnRate={turn_rate} }}",
                  math.radians(abs(angle)) / turn_rate + speed + turn_rate / 4 + 1)


def motes(count, seconds, period, least, medium):
    """`count` motes 2 m apart that float in nothing; each sends once in `period` seconds and hears what is above `least` dBm."""
    columns, rows = pattern(count)
    return f"""Tick = 0.01   Duration = {seconds}   Gravity = 0,0,0
#import robots/tmote_sky.sim
#loadModule controllers/mote

RadioMedium air {{ {medium} }}
Grid motes {{
  Config=TmoteSky  Count={columns},{rows}  Spacing=2  radio.MinReceivePower={least}
  Mote brain {{ Power=-25 Period={period} }}
}}
"""


def _drive(module, controller, seconds):
    return f"""Tick = 0.01   Duration = {seconds:.2f}
#import robots/simple_robot.sim
#import arenas/open_floor.sim
#loadModule controllers/{module}
Static floor {{ Config=OpenFloor }}
Robot robot0 {{ Config=SimpleRobot  {controller} }}
"""
