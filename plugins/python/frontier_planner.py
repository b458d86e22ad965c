"""Where to drive to see what is not known yet, as controllers/lidar_map/frontier_planner.cpp."""

from collections import deque

from occupancy_grid import FREE, OCCUPIED, UNKNOWN

_NEIGHBOURS = ((1, 0), (0, 1), (-1, 0), (0, -1), (1, 1), (-1, 1), (-1, -1), (1, -1))


class FrontierPlanner:
    """Plans in a map to the nearest frontier: a free cell beside an unknown one (Yamauchi 1997). All on free cells that are at least
    `clearance` m from what is occupied; where the robot is nearer, its way out does not get nearer still."""

    def __init__(self, grid, clearance):
        self.count, self.states = grid.count, grid.states()
        self.needed = int(clearance / grid.cell_size + 0.5)
        self.steps = {}  # of cells nearer than needed to an occupied one: how many there are between
        self._measure_clearances()

    def neighbours(self, cell):
        y, x = divmod(cell, self.count)
        for dx, dy in _NEIGHBOURS:
            if 0 <= x + dx < self.count and 0 <= y + dy < self.count:
                yield cell + dy * self.count + dx

    def _measure_clearances(self):
        """Breadth first from all occupied cells."""
        ring = [cell for cell, state in enumerate(self.states) if state == OCCUPIED]
        for steps in range(self.needed):
            self.steps.update(dict.fromkeys(ring, steps))
            ring = list({following for cell in ring for following in self.neighbours(cell) if following not in self.steps})

    def clearance(self, cell):
        """In cells; at most `needed`."""
        return self.steps.get(cell, self.needed)

    def is_frontier(self, cell):
        return any(self.states[beside] == UNKNOWN for beside in self.neighbours(cell))

    def path(self, start):
        """The cells from `start` to the nearest frontier, without `start`; None: there is no frontier that it could reach."""
        if start is None:
            return None
        origin, waiting = {start: start}, deque([start])
        while waiting:
            here = waiting.popleft()
            clearance = self.clearance(here)
            if clearance >= self.needed and here != start and self.is_frontier(here):
                cells = []
                while here != start:
                    cells.append(here)
                    here = origin[here]
                return cells[::-1]
            for beside in self.neighbours(here):
                if beside in origin or self.states[beside] != FREE or self.clearance(beside) < min(self.needed, clearance):
                    continue
                origin[beside] = here
                waiting.append(beside)
        return None
