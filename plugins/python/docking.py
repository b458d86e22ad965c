"""Works until the battery is low, goes to the light on its charger, charges by touching it, leaves, and works on, as controllers/docking in
C++."""

import math

import trundle
from trundle import field, metres, metres_per_second, needs, number, output, radians_per_second, unit_of

TANGENT = 1.1917535925942100  # of 50 degrees, by which each light sensor is turned outwards
SMOOTHING = 0.2  # share of a new reading in the smoothed light
WAYS = 0.12  # m, that it drives back from what it has touched
PROGRESS = 0.05  # m, that it is to go towards the light in each
PROGRESS_TIME = 5  # s
CREEP = 0.03  # m/s, to stay in contact


def clamp(value, low, high):
    return min(max(value, low), high)


def distance(a, b):
    return math.sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y))


class Docking(trundle.Controller):
    """Works until its battery is low, finds its charger by the light on it, charges by touch, and works on."""

    low = field("Low", 0.5, number().within(0.01, 0.99).live(), "Share of the charge at which it looks for its charger.")
    full = field("Full", 0.9, number().within(0.02, 1).live(), "Share of the charge with which it leaves it.")
    charges = field("Charges", 2, number().within(0, 1e6), "The run ends at work after so many; 0: never.")
    speed = field("Speed", 0.12, metres_per_second().above(0).at_most(10).live(), "At most.")
    turn_rate = field("TurnRate", 1.5, radians_per_second().above(0).at_most(100).live(), "At most.")
    clearance = field("Clearance", 0.04, metres().within(0, 10), "It turns away from what is nearer.")
    dim = field("Dim", 8.0, unit_of("lx").above(0).at_most(1e9), "Weaker light, above that of the room, is no charger.")
    near = field("Near", 2500.0, unit_of("lx").above(0).at_most(1e9), "Where it is so bright, what is ahead is the charger.")
    range_names = field("Ranges", ["prox7", "prox0", "prox6", "prox1"], needs("RangeSensor").counted(2, 100),
                        "RangeSensors ahead: of the left, of the right, and so on.")
    led_names = field("Leds", ["led0", "led1", "led2", "led3", "led4", "led5", "led6", "led7"], needs("Led").counted(0, 100),
                      "That show what it does: green at work, yellow on its way, blue while it charges.")
    left_name = field("Left", "leftLight", needs("LightSensor"), "The robot's LightSensor on the left, turned outwards by 50 degrees.")
    right_name = field("Right", "rightLight", needs("LightSensor"), "The one on the right.")
    battery_name = field("Battery", "battery", needs("Battery"), "The robot's Battery.")
    touch_name = field("Touch", "touch", needs("TouchSensor"), "The TouchSensor of the contacts of the battery.")
    drive_name = field("Drive", "base", needs("DifferentialDrive"), "The robot's DifferentialDrive.")
    charged = output("charged", "", "How often it has charged.", type=int)
    worked = output("worked", "m", "Way that it went at work.")

    def setup(self, robot):
        self.ranges = [robot.range_sensor(name) for name in self.range_names]
        self.leds = [robot.led(name) for name in self.led_names]
        self.left = robot.light_sensor(self.left_name)
        self.right = robot.light_sensor(self.right_name)
        self.battery = robot.battery(self.battery_name)
        self.touch = robot.touch(self.touch_name)
        self.drive = robot.differential_drive(self.drive_name)
        self.state = None
        self.on_left = self.on_right = self.room = self.turning = self.last_contact = self.progress_at = 0.0

    def update(self, since_last):
        if self.left.time() < 0 or self.right.time() < 0 or self.ranges[0].time() < 0:
            return
        if self.battery.voltage() <= 0 and self.time > 0:
            self.finish("its battery is empty")
            return
        self.here = self.drive.odometry()
        share = SMOOTHING if self.state else 1
        self.on_left += (self.left.illuminance() - self.on_left) * share
        self.on_right += (self.right.illuminance() - self.on_right) * share
        if not self.state:
            self.enter(self.calibrate)
            self.room = min(self.on_left, self.on_right)
        self.turned += abs(math.remainder(self.here.heading - self.before.heading, 2 * math.pi))
        self.state()
        self.before = self.here

    def enter(self, state):
        self.state = state
        self.since = self.time
        self.turned = self.turn_until = 0.0
        self.before = self.start = self.here
        if state == self.work:
            self.show(0, 1, 0)
        elif state == self.seek:
            self.show(1, 0.8, 0)
        elif state == self.charge:
            self.show(0, 0.3, 1)

    def elapsed(self):
        """s in this state"""
        return self.time - self.since

    def show(self, red, green, blue):
        for led in self.leds:
            led.set_on(True)
            led.set_color(red, green, blue)

    def calibrate(self):
        """The light of the room is the least that it sees in one turn: that with the charger behind it."""
        self.room = min(self.room, self.on_left, self.on_right)
        self.drive.move(0, self.turn_rate)
        if self.turned >= 2 * math.pi:
            self.enter(self.work)

    def wander(self):
        """Straight ahead, and away from what is in the way. True: it turns away."""
        if self.time < self.turn_until:
            self.drive.move(0, self.turning)
            return True
        left = min(sensor.range() for sensor in self.ranges[0::2])
        right = min(sensor.range() for sensor in self.ranges[1::2])
        if min(left, right) < self.clearance:
            self.turning = -self.turn_rate if left < right else self.turn_rate
            self.turn_until = self.time + (0.4 + self.random()) / self.turn_rate
            self.drive.move(0, self.turning)
            return True
        self.drive.move(self.speed, 0)
        return False

    def work(self):
        self.worked += distance(self.here, self.before)
        self.wander()
        if self.charges > 0 and self.charged >= self.charges and self.elapsed() > 10:
            self.drive.stop()
            self.finish("it works, charged")
        elif self.battery.level() < self.low:
            self.enter(self.seek)

    def seek(self):
        """Towards the light, by the difference of its sensors."""
        if self.battery.charging():
            self.drive.stop()
            self.enter(self.charge)
            return
        if self.touch.pressed() and self.elapsed() > 0.5:
            self.enter(self.back_off)
            return
        if distance(self.here, self.start) > PROGRESS:
            self.progress_at, self.start = self.time, self.here
        if self.time - max(self.progress_at, self.since) > PROGRESS_TIME:
            self.leave_the_way(0.0, 2 + 3 * self.random())
            return
        left, right = max(self.on_left - self.room, 0.0), max(self.on_right - self.room, 0.0)
        most = max(left, right)
        if most < self.dim:
            self.drive.move(0, self.turn_rate)
            return
        if most < self.near and self.wander():
            self.leave_the_way(self.turn_until, 1.5 + 3 * self.random())
            return
        # A lamp at the bearing b gives both cos(50 deg +- b), where both see it.
        bearing = math.atan((left - right) / (left + right) / TANGENT)
        if min(left, right) < 0.03 * most:
            turn = self.turn_rate if left > right else -self.turn_rate
        else:
            turn = clamp(3 * bearing, -self.turn_rate, self.turn_rate)
        ahead = (self.speed if most < self.near else self.speed / 2) if abs(bearing) < 0.35 else 0
        self.drive.move(ahead, turn)

    def leave_the_way(self, until, seconds):
        """Goes where it can for `seconds`, after it has turned until `until`: around what is in the way, or to where the light is seen."""
        self.enter(self.search)
        self.turn_until = until
        self.search_end = self.time + seconds

    def search(self):
        self.wander()
        if self.battery.charging():
            self.enter(self.charge)
            return
        if self.time > self.search_end:
            self.enter(self.seek)

    def back_off(self):
        """What it touched is no charger."""
        if distance(self.here, self.start) < WAYS / 2 and self.elapsed() < 3:
            self.drive.move(-self.speed / 2, 0)
            return
        self.turning = -self.turn_rate if self.random() < 0.5 else self.turn_rate
        self.leave_the_way(self.time + (0.5 + self.random()) / self.turn_rate, 3)

    def charge(self):
        if self.battery.level() >= self.full:
            self.charged += 1
            self.print("charged for ", self.elapsed(), " s")
            self.enter(self.leave)
        elif self.battery.charging():
            self.last_contact = self.time
            self.drive.stop()
        else:
            self.drive.move(CREEP, 0)
            if self.time - self.last_contact > 2:
                self.enter(self.seek)

    def leave(self):
        if distance(self.here, self.start) < WAYS and self.elapsed() < 5:
            self.drive.move(-self.speed / 2, 0)
            return
        self.enter(self.work)
        self.turning = -self.turn_rate if self.random() < 0.5 else self.turn_rate
        self.turn_until = self.time + (0.5 * math.pi + self.random()) / self.turn_rate
