"""A robot with a directional antenna among motes, as controllers/network_navigator in C++: it turns once around, fits the peak of each
mote's signal strength, drives a leg towards the mote nearest to the target, and repeats until the target's signal is strong enough
(after Deshpande, Grant and Henderson, IEEE Systems Journal 8(1), 2014)."""

import math

import trundle
from beacon import Beacon
from sweep import Bearing, Sweep, wrap_angle
from trundle import decibel_milliwatts, field, metres, metres_per_second, needs, radians_per_second, text

DEGREE = math.pi / 180
STAND_OFF = 0.7  # m, distance before an intermediate mote at which a leg ends
LEG_FRACTION = 0.8  # of the estimated distance to the target covered by one leg
SHORTEST_LEG = 0.2  # m
AT_REST = 1e-5  # m, largest motion per update that counts as rest
TURN_AWAY = 70 * DEGREE
MOST_ON_ONE_SIDE = 6  # contacts evaded on one side before it tries the other


class _Listener(trundle.Controller):
    """A drive, a radio with a forward-facing antenna, and the samples of the last sweep."""

    turn_rate = field("TurnRate", 0.5, radians_per_second().above(0).at_most(10), "While it listens.")
    radio_name = field("Radio", "radio", needs("Transceiver"), "The robot's Transceiver, whose antenna looks ahead.")
    drive_name = field("Drive", "base", needs("DifferentialDrive"), "The robot's DifferentialDrive.")

    def setup(self, robot):
        self.drive = robot.differential_drive(self.drive_name)
        self.radio = robot.radio(self.radio_name)
        self.sweep = Sweep()
        self.last_heading = 0.0

    def begin_sweep(self):
        """Turns a little more than once around, so that no peak is at the start or end of the sweep."""
        self.sweep.clear()
        self.drive.turn(self.turn_rate, 370 * DEGREE)

    def listen(self):
        """Received packets belong to the heading one tick ago, when they were received."""
        while packet := self.radio.receive():
            self.hear(packet, self.last_heading)
        self.last_heading = self.drive.odometry().heading


class BearingSweep(_Listener):
    """Turns once on the spot and finds the bearing of each sender from the peak of its RSSI."""

    file_name = field("File", "bearings.csv", text(), "A line for each sender, in the log folder.")
    samples_name = field("Samples", "samples.csv", text(), "A line for each packet, in the log folder.")
    started = done = False

    def update(self, since_last):
        if self.done:
            return
        if not self.started:
            self.started = True
            self.samples = self.open_log(self.samples_name)
            self.samples.write("sender,heading [deg],RSSI [dBm]\n")
            self.begin_sweep()
        self.listen()
        if self.drive.done():
            self.report()

    def hear(self, packet, heading):
        self.sweep.add(packet.sender, heading, packet.rssi)
        self.samples.write(f"{packet.sender},{heading / DEGREE:f},{packet.rssi:f}\n")

    def report(self):
        self.done = True
        log = self.open_log(self.file_name)
        log.write("sender,packets,bearing [deg],RSSI [dBm]\n")
        for sender, heard in sorted(self.sweep.samples.items()):
            if not (bearing := self.sweep.bearing(sender)):
                continue
            log.write(f"{sender},{len(heard)},{bearing.heading / DEGREE:f},{bearing.rssi:f}\n")
            print(f"sender {sender} is at {bearing.heading / DEGREE:g} deg, {bearing.rssi:g} dBm, from {len(heard)} packets")


class NetworkNavigator(_Listener):
    """Drives to the target of a network of Motes by the bearings of what it hears, and ends the run there."""

    speed = field("Speed", 0.3, metres_per_second().above(0).at_most(10), "On its legs.")
    leg = field("Leg", 3.0, metres().above(0).at_most(1000), "The longest drive between two sweeps.")
    rssi_at_one_metre = field("RssiAtOneMetre", -30.0, decibel_milliwatts().within(-150, 50),
                              "Of a mote straight ahead; from it and free space it guesses how long a leg may be.")
    arrived_rssi = field("ArrivedRssi", -28.0, decibel_milliwatts().within(-150, 50),
                         "The target is reached when it is heard with this.")
    good_rssi = field("GoodRssi", -75.0, decibel_milliwatts().within(-150, 50),
                      "A mote that is heard with less must be that much nearer to the target to be chosen.")
    back_off = field("BackOff", 0.3, metres().above(0).at_most(100), "From what it touches.")
    detour = field("Detour", 0.8, metres().above(0).at_most(100), "Past what it touched.")
    touch_name = field("Touch", "frontTouch", needs("TouchSensor"), "The robot's TouchSensor in front.")
    file_name = field("File", "navigation.csv", text(), "A line for each leg, in the log folder.")

    def setup(self, robot):
        super().setup(robot)
        self.touch = robot.touch(self.touch_name)
        self.beacons = {}  # of the current sweep
        self.doing = self.start
        self.length = 0.0  # m, of the leg after the turn
        self.least_so_far, self.side = 1e9, 1
        self.rest = (1e9, 1e9)  # m, odometry at the previous update
        self.legs = self.bumps = self.bumps_here = 0

    def update(self, since_last):
        self.listen()
        self.doing()

    def hear(self, packet, heading):
        beacon = Beacon.read(packet.bytes)
        if not beacon or not beacon.knows_target:
            return
        if self.doing == self.sweeping:
            self.beacons[packet.sender] = beacon
            self.sweep.add(packet.sender, heading, packet.rssi)
        if beacon.hops == 0 and packet.rssi >= self.arrived_rssi and self.doing != self.arrived:
            self.arrive(packet)

    # What it does in an update, one function for each state.

    def start(self):
        self.log = self.open_log(self.file_name)
        self.log.write("time [s],mote,hops,cost,heading [deg],RSSI [dBm],leg [m]\n")
        self.start_sweep()

    def sweeping(self):
        if self.drive.done():
            self.choose()

    def turning(self):
        if self.drive.done():
            self.go(self.driving, self.length)

    def driving(self):
        if self.touch.pressed():
            self.evade()
        elif self.drive.done():
            self.start_sweep()

    def backing_off(self):
        if self.drive.done():
            self.turn(self.side * TURN_AWAY, self.detour)

    def arrived(self):
        """Ends the run when the wheels have come to rest."""
        now = self.drive.odometry()
        moved = math.hypot(now.x - self.rest[0], now.y - self.rest[1])
        self.rest = now.x, now.y
        if moved < AT_REST:
            self.finish("reached")

    # Changes of the state.

    def arrive(self, packet):
        self.drive.stop()
        self.doing = self.arrived
        print(f"reached the target, RSSI {packet.rssi:g} dBm, after {self.legs} legs, {self.bumps} bumps and {self.time:g} s")
        self.write("arrived", Beacon(), Bearing(self.drive.odometry().heading, packet.rssi), 0)

    def start_sweep(self):
        self.doing = self.sweeping
        self.beacons.clear()
        self.begin_sweep()

    def choose(self):
        """Chooses the mote with the least cost to the target; a weak signal increases the cost."""
        least, way, mote = 1e9, None, 0
        for sender, beacon in sorted(self.beacons.items()):
            bearing = self.sweep.bearing(sender)
            if bearing is None:
                continue
            cost = beacon.cost + max(0.0, self.good_rssi - bearing.rssi)
            if cost < least:
                least, way, mote = cost, bearing, sender
        if mote == 0:
            return self.drive_randomly()  # no mote was received here
        beacon = self.beacons[mote]
        if least < self.least_so_far:
            self.least_so_far, self.bumps_here = least, 0
        distance = math.pow(10, (self.rssi_at_one_metre - way.rssi) / 20)
        wanted = max(SHORTEST_LEG, LEG_FRACTION * distance) if beacon.hops == 0 else distance - STAND_OFF
        self.legs += 1
        self.write(mote, beacon, way, min(self.leg, wanted))
        if wanted < SHORTEST_LEG:
            return self.drive_randomly()  # it is already close to this mote and receives none nearer to the target
        self.turn(wrap_angle(way.heading - self.drive.odometry().heading), min(self.leg, wanted))

    def drive_randomly(self):
        self.turn(self.random(-180, 180) * DEGREE, self.leg / 2)

    def turn(self, angle, next_leg):
        """Turns by an angle (rad), then drives a straight leg of `next_leg` m."""
        self.length = next_leg
        if abs(angle) < 0.2 * DEGREE:
            return self.go(self.driving, self.length)
        self.doing = self.turning
        self.drive.turn(1.0, angle)

    def go(self, what, metres):
        self.doing = what
        self.drive.drive(math.copysign(self.speed, metres), 0.0, metres, 0.0)

    def evade(self):
        """Evades an obstacle, always on the same side, until it is nearer to the target than ever before or the number of tries is
        reached."""
        self.bumps += 1
        if self.bumps_here == 0:
            self.side = 1 if self.random() < 0.5 else -1
        elif self.bumps_here % MOST_ON_ONE_SIDE == 0:
            self.side = -self.side
        self.bumps_here += 1
        self.go(self.backing_off, -self.back_off)

    def write(self, mote, beacon, way, metres):
        self.log.write(f"{self.time:f},{mote},{beacon.hops},{beacon.cost},{way.heading / DEGREE:f},{way.rssi:f},{metres:f}\n")
