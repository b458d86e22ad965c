# SPDX-License-Identifier: BSD-2-Clause
"""What controllers and devices have in common for the run: an object of the user's class with the values of its fields."""

from .. import description


class Instance:
    """`title` names it in messages; `outside` is what it and print() of Python reach. Both are set by the derived classes."""

    def __init__(self):
        self.title, self.outside, self.instance, self.values = "", None, None, {}

    def read_values(self, reader):
        for _ in range(reader.number("Q")):
            key = reader.text()
            self.values[key] = reader.value()

    def failed(self, how, why):
        return f"{self.title} {how}: {why}"

    def set(self, field, value):
        setattr(self.instance, field.attribute, field.to_python(*value))

    def make(self, kind):
        self.instance = kind.__new__(kind)
        self.instance._outside = self.outside
        self.instance.__init__()
        for field in description.members(kind, description.field):
            if field.name in self.values:
                self.set(field, self.values[field.name])
