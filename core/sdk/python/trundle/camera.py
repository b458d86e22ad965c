# SPDX-License-Identifier: BSD-2-Clause
"""Access to a robot's cameras. An image is rendered only when it is requested."""

import math


class Picture:
    """The image of a camera at one time, read-only, rows from the top. False if no image is available; `error` says why. Do not use
    it after the update that took it: copy what you keep."""

    names = {}  # of objects, by number, in the pictures of a served run

    def __init__(self, width=0, height=0, time=0.0, pixels=b"", depth=b"", objects=b"", error=""):
        self.width, self.height, self.time, self.error = width, height, time, error
        self._pixels, self._depth, self._objects = pixels, depth, objects

    def __bool__(self):
        return self.width > 0

    @property
    def pixels(self):
        """RGB as a read-only memoryview with the shape (height, width, 3)."""
        return self._shaped(self._pixels, "B", 3)

    @property
    def depths(self):
        """m along the camera's axis, shape (height, width), infinite where there is nothing; None unless Mode has them."""
        return self._shaped(self._depth, "f") if self._depth else None

    @property
    def objects(self):
        """Numbers of the objects, shape (height, width), 0 for none; None unless Mode=segmentation. See CameraPort.object_name."""
        return self._shaped(self._objects, "I") if self._objects else None

    @property
    def array(self):
        """The pixels as a read-only NumPy array with the shape (height, width, 3). Needs NumPy."""
        try:
            import numpy
        except ImportError:
            raise ImportError("Picture.array needs NumPy, which is not installed (python3-numpy); Picture.pixels does not") from None
        return numpy.frombuffer(self._pixels, numpy.uint8).reshape(self.height, self.width, 3)

    def at(self, x, y):
        """(red, green, blue), 0 ... 255; black outside the image."""
        if not (0 <= x < self.width and 0 <= y < self.height):
            return (0, 0, 0)
        first = 3 * (y * self.width + x)
        return tuple(self._pixels[first:first + 3])

    def depth(self, x, y):
        """m; infinite where there is no object."""
        if not self._depth or not (0 <= x < self.width and 0 <= y < self.height):
            return math.inf
        return self.depths[y, x]

    def object(self, x, y):
        if not self._objects or not (0 <= x < self.width and 0 <= y < self.height):
            return 0
        return self.objects[y, x]

    def _shaped(self, data, format, *more):
        if not data:
            return memoryview(b"")
        return memoryview(data).cast("B").cast(format, (self.height, self.width, *more))


class CameraPort:
    def __init__(self, outside, name, frame):
        self._outside, self._name, self._frame = outside, name, frame
        self._seen = -1.0
        self.error = ""  # of the last save

    def capture(self):
        """Renders the current image. For a camera with an UpdatePeriod, returns the newest image of its stream."""
        picture = self._outside.capture(self._name)
        if picture and self._frame:
            self._seen = self._frame.get()
        return picture

    def save(self, file_name):
        """Saves the image that capture() would return in the run's log folder, as .png or .jpg. False: `error` says why."""
        self.error = self._outside.save_picture(self._name, file_name)
        return not self.error

    def fresh(self):
        """For a camera with an UpdatePeriod: its stream has an image that capture() has not returned. Otherwise always true."""
        return self._frame is None or self._frame.get() != self._seen

    def object_name(self, number):
        """"robot1/chassis/hull" for a number of Picture.objects; "" if there is no such object."""
        return self._outside.object_name(number)
