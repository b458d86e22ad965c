"""Texts of the measured experiments, made from nothing but the shipped configs."""

import math


def pattern(count):
    """Columns and rows of the grid that holds `count` robots: as square as it divides."""
    rows = int(math.sqrt(count))
    while count % rows:
        rows -= 1
    return count // rows, rows


def crowd(count, seconds, tick=0.01):
    """`count` shipped robots, one per square metre, wandering in a walled room of at least 4 m x 4 m."""
    columns, rows = pattern(count)
    x, y = max(columns, 4), max(rows, 4)
    return f"""Tick = {tick}   Duration = {seconds}   Solver = exact
#import robots/simple_robot.sim
#import common/materials.sim
#import common/surfaces.sim
#loadModule controllers/random_drive

StaticConfig Room {{
  Plane floor {{ Material=concrete Surface=ground }}
  Box north {{ Pos=0, {y / 2 + 0.05}, 0.15   Size={x + 0.2}, 0.1, 0.3  Material=wood Surface=wall }}
  Box south {{ Pos=0, {-y / 2 - 0.05}, 0.15  Size={x + 0.2}, 0.1, 0.3  Material=wood Surface=wall }}
  Box east  {{ Pos={x / 2 + 0.05}, 0, 0.15   Size=0.1, {y}, 0.3  Material=wood Surface=wall }}
  Box west  {{ Pos={-x / 2 - 0.05}, 0, 0.15  Size=0.1, {y}, 0.3  Material=wood Surface=wall }}
}}
Static room {{ Config=Room }}
Grid crowd {{
  Config=SimpleRobot  Count={columns},{rows}  Spacing=1
  RandomDrive brain {{ Speed=0.3 TurnRate=1 Period=1 }}
}}
"""


def straight(distance, speed):
    return _drive("linear_motion", f"LinearMotion brain {{ Distance={distance} Speed={speed} }}", abs(distance) / speed + speed + 1)


def arc(angle, speed, turn_rate):
    # the drive's ramps: 1 m/s^2 and 4 rad/s^2
    return _drive("arc_motion", f"ArcMotion brain {{ Angle={angle} Speed={speed} TurnRate={turn_rate} }}",
                  math.radians(abs(angle)) / turn_rate + speed + turn_rate / 4 + 1)


def _drive(module, controller, seconds):
    return f"""Tick = 0.01   Duration = {seconds:.2f}
#import robots/simple_robot.sim
#import arenas/open_floor.sim
#loadModule controllers/{module}
Static floor {{ Config=OpenFloor }}
Robot robot0 {{ Config=SimpleRobot  {controller} }}
"""
