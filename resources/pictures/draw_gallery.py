#!/usr/bin/env python3
"""Draws the gallery: one picture of each shipped robot and arena, `resources/pictures/gallery/NAME.png`, and of the samples with
cameras and radios, `resources/pictures/samples/NAME.png`.

`python3 resources/pictures/draw_gallery.py [BUILD]` after a build; BUILD is build/release where none is given. Each robot stands on a
plain floor, each arena as it is; the pictures are those of `trundle-cli render`. On a display (or below `xvfb-run -a`) it also draws
README's `window.png`, the window itself.
"""

import glob
import os
import re
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
SIZE = "640x360"
# Of each robot: how far away (m) the eye is, how high what it looks at, and how far ahead of the origin. One that is not named is shown whole from farther away.
ROBOTS = {"soccer_robot": (0.58, 0.062), "simple_robot": (0.85, 0.06), "camera_robot": (1.0, 0.12), "radio_robot": (1.05, 0.13), "evbot": (1.4, 0.19), "amr": (1.9, 0.18), "tmote_sky": (0.2, 0.01), "lidar_robot": (0.62, 0.1), "round_robot": (0.24, 0.026), "research_base": (1.4, 0.1), "tractor": (1.1, 0.1), "rover": (1.9, 0.25), "car": (1.2, 0.08, 0.165), "maze_robot": (0.26, 0.012)}
# Of each sample: after how many seconds, from where and what is in the middle (m).
SAMPLES = {
    "camera_swarm": ("2", "-2.6,-2.4,1.5", "0.1,0.1,0"),
    "turn_angle": ("1.2", "-1.35,-0.95,0.72", "0.35,0.35,0.03"),
    "network_navigation": ("3", "-8.9,-7.4,1.15", "-5.6,-4.3,0.1"),
    "wall_follow": ("60", "-0.75,-0.6,0.75", "0.45,0.55,0.08"),
    "line_follow": ("17", "-1.02,-0.12,0.4", "-0.52,0.36,0"),
    "braitenberg": ("18", "0.1,-0.2,0.32", "0.75,0.37,0.02"),
    "lidar_map": ("11", "-0.15,-0.75,0.75", "0.75,0.45,0.06"),
    "collect": ("117", "-0.5,-1.5,0.8", "-1.75,0.1,0.05"),
    "docking": ("6", "-0.33,-1.12,0.2", "-0.06,-0.7,0.06"),
    "stacking": ("14", "1.15,-0.85,0.75", "0.2,0,0.22"),
    "train": ("9", "0.1,-0.15,0.7", "0.72,1.0,0.03"),
    "car": ("3.6", "2.45,-0.15,0.42", "1.74,0.46,0.05"),
    "maze": ("40", "-0.45,-1.2,1.15", "-0.02,-0.12,0"),
    "rover": ("14", "0.7,-1.7,0.9", "1.5,0,0.2"),
    "blob_follow": ("4", "-2.7,-2.3,1.1", "-0.1,0.55,0.05"),
    "soccer": ("3.6", "0.75,-0.72,0.42", "1.3,0.03,0.03"),
    "directional_antenna": ("1.2", "-0.75,-1.35,0.75", "0.4,0.45,0.08"),
    "sensor_network_amr": ("1", "-7.3,-6.4,1.6", "-4.4,-3.5,0.2"),
}


def text(folder, name, config):
    if folder == "arenas":
        return f"#import arenas/{name}.sim\nStatic it {{ Config={config} }}\n"
    lines = ["#import arenas/open_floor.sim", f"#import robots/{name}.sim", "Static floor { Config=OpenFloor }", f"Robot it {{ Config={config} }}"]
    if name in ROBOTS:
        far, high, *ahead = ROBOTS[name]
        middle = ahead[0] if ahead else 0.01
        lines.append(f"View shown {{ Eye={0.66 * far + (ahead[0] if ahead else 0):g},{-0.62 * far:g},{high + 0.42 * far:g} Target={middle:g},0,{high:g} FieldOfView=40 }}")
    return "\n".join(lines) + "\n"


def picture_of_window(trundle):
    experiment = os.path.join(ROOT, "configs", "experiments", "obstacle_detection.sim")
    picture = os.path.join(HERE, "window.png")
    what = ["--select", "robot0", "--run-for", "11", "--theme", "light", "--size", "1500x900", "--screenshot", picture, "--quit"]
    with tempfile.TemporaryDirectory() as home:  # your own settings change nothing in the picture
        subprocess.run([trundle, experiment, *what], check=True, env=dict(os.environ, HOME=home, XDG_CONFIG_HOME=home, XDG_STATE_HOME=home))
    print(picture)


def main():
    cli = os.path.join(sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, "build", "release"), "bin", "trundle-cli")
    os.makedirs(os.path.join(HERE, "gallery"), exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        for kind, word in (("robots", "RobotConfig"), ("arenas", "StaticConfig")):
            for path in sorted(glob.glob(os.path.join(ROOT, "configs", kind, "*.sim"))):
                name = os.path.splitext(os.path.basename(path))[0]
                with open(path, encoding="utf-8") as file:
                    configs = re.findall(rf"^{word} (\w+)", file.read(), re.MULTILINE)
                if name == "open_floor" or not configs:
                    continue  # nothing to see
                experiment = os.path.join(folder, name + ".sim")
                with open(experiment, "w", encoding="utf-8") as file:
                    file.write(text(kind, name, configs[-1]))
                picture = os.path.join(HERE, "gallery", name + ".png")
                view = ["--view", "shown"] if name in ROBOTS else []
                subprocess.run([cli, "render", experiment, "--size", SIZE, "-o", picture, *view], check=True)
                print(picture)
        # The card of File > New > Robot from Dimensions: a robot that `trundle-cli new robot` makes.
        subprocess.run([cli, "new", "robot", "Rover", "--base", "mecanum", "--in", folder], check=True)
        experiment = os.path.join(folder, "rover", "shown.sim")
        with open(experiment, "w", encoding="utf-8") as file:
            file.write("#import arenas/open_floor.sim\n#import rover.sim\nStatic floor { Config=OpenFloor }\nRobot it { Config=Rover }\n"
                       "View shown { Eye=0.5,-0.47,0.36 Target=0.01,0,0.06 FieldOfView=40 }\n")
        picture = os.path.join(HERE, "gallery", "new_robot.png")
        subprocess.run([cli, "render", experiment, "--size", SIZE, "-o", picture, "--view", "shown"], check=True)
        print(picture)
    for name, (seconds, eye, target) in SAMPLES.items():
        picture = os.path.join(HERE, "samples", name + ".png")
        place = ["--at", seconds, "--eye=" + eye, "--target=" + target]
        subprocess.run([cli, "render", os.path.join(ROOT, "configs", "experiments", name + ".sim"), "--size", SIZE, "-o", picture, *place], check=True)
        print(picture)
    if os.environ.get("DISPLAY"):
        picture_of_window(os.path.join(os.path.dirname(cli), "trundle"))


if __name__ == "__main__":
    main()
