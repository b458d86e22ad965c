"""The packet that motes send to each other and to passing robots: the distance to the target, in hops and by link quality."""

import struct
from typing import NamedTuple

UNKNOWN = 0xffff
_MARK = 0xb1
_LAYOUT = struct.Struct(">BHBH")  # big-endian


class Beacon(NamedTuple):
    flood: int = 0  # number of the target's flood from which the other values come
    hops: int = 0  # to the target
    cost: int = UNKNOWN  # 10 for a good hop, more for a weak one; summed over the hops

    def bytes(self):
        return _LAYOUT.pack(_MARK, self.flood, self.hops, self.cost)

    @classmethod
    def read(cls, data):
        """The beacon in a packet; None if it is something else."""
        if len(data) != _LAYOUT.size or data[0] != _MARK:
            return None
        return cls(*_LAYOUT.unpack(data)[1:])

    @property
    def knows_target(self):
        return self.cost != UNKNOWN
