"""A mote of a sensor network, as controllers/mote in C++: the target floods the network with a number; every mote keeps its best route
to the target from the newest floods and broadcasts it to its neighbours (after Deshpande, Grant and Henderson, IEEE Systems Journal
8(1), 2014)."""

import trundle
from beacon import UNKNOWN, Beacon
from trundle import decibel_milliwatts, field, flag, needs, output, seconds

TIMEOUT = 3  # floods without an update of its route before it accepts a worse one


class Mote(trundle.Controller):
    """Sends beacons with the distance to the target mote, from hops and signal strengths."""

    target = field("Target", False, flag(), "It is the target itself.")
    period = field("Period", 0.1, seconds().within(0.01, 1000), "Mean time between its beacons.")
    flood_period = field("FloodPeriod", 2.0, seconds().within(0.1, 1000), "Between two floods of the target.")
    power = field("Power", 0.0, decibel_milliwatts().within(-100, 100), "It sends with.")
    good_rssi = field("GoodRssi", -75.0, decibel_milliwatts().within(-150, 50), "A hop with more costs no more than one hop.")
    radio_name = field("Radio", "radio", needs("Transceiver"), "Its Transceiver.")
    hops = output("hops", "", "To the target; -1: no route is known.", type=int)
    cost = output("cost", "", "Of its route to the target: 10 for a good hop, more for a weak one; -1: no route is known.", type=int)

    def setup(self, robot):
        self.radio = robot.radio(self.radio_name)
        self.learn(Beacon())
        self.next_beacon = self.period * self.random()
        self.next_flood = 0.0

    def update(self, since_last):
        while packet := self.radio.receive():
            if beacon := Beacon.read(packet.bytes):
                self.heard(beacon, packet.rssi)
        if self.target and self.time >= self.next_flood:
            self.next_flood += self.flood_period
            self.learn(Beacon(self.known.flood + 1 & 0xffff, 0, 0))
        if self.time < self.next_beacon:
            return
        self.next_beacon = self.time + self.period * self.random(0.5, 1.5)  # random, so that neighbours do not collide repeatedly
        self.radio.send(self.known.bytes(), self.power)

    def heard(self, beacon, rssi):
        """Handles a neighbour's route to the target and the RSSI of the hop to that neighbour."""
        if self.target or not beacon.knows_target:
            return
        total = beacon.cost + 10 + max(0.0, self.good_rssi - rssi)
        if total >= UNKNOWN or beacon.hops >= 254:
            return
        if self.known.knows_target:
            ahead = (beacon.flood - self.known.flood + 0x8000 & 0xffff) - 0x8000  # the number wraps around
            if ahead < 0 or (ahead == 0 and total >= self.known.cost):
                return
            if ahead < TIMEOUT and total > self.known.cost:
                return
        self.learn(Beacon(beacon.flood, beacon.hops + 1, int(total)))

    def learn(self, way):
        self.known = way
        self.hops = way.hops if way.knows_target else -1
        self.cost = way.cost if way.knows_target else -1
