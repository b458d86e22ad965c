# SPDX-License-Identifier: BSD-2-Clause
"""Sending and receiving radio packets."""

from typing import NamedTuple

EVERYBODY = 0xffff
FULL_POWER = 1000.0  # dBm: the radio's maximum
MOST_PAYLOAD = 116  # bytes


class Packet(NamedTuple):
    """A received packet: RSSI in dBm, LQI from 110 down to 50, the time of its last bit on the radio's own clock [s]."""
    bytes: bytes
    rssi: float
    lqi: int
    time: float
    sender: int
    receiver: int


class RadioPort:
    """A Transceiver. A packet contains up to 116 bytes."""

    def __init__(self, outside, radio):
        self._outside, self._radio = outside, radio

    @property
    def address(self):
        """1 ... 65534, unique for each radio."""
        return self._radio.address

    def send(self, data, power=FULL_POWER, to=EVERYBODY):
        """Sends bytes or a text to one address, or broadcasts by default. False if it is too long or the queue is full."""
        if isinstance(data, int):  # of which bytes() makes as many zeros
            raise TypeError(f"a packet has bytes or a text, not {data!r}")
        if not 1 <= to <= EVERYBODY:
            raise ValueError(f"addresses are 1 to {EVERYBODY - 1}, and {EVERYBODY} for all, not {to!r}")
        data = data.encode() if isinstance(data, str) else bytes(data)
        return len(data) <= MOST_PAYLOAD and self._outside.send_packet(self._radio, data, to, power)

    def receive(self):
        """The oldest packet in the queue; None if there is none."""
        return self._outside.receive_packet(self._radio)
