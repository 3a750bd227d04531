"""A place seen from above: its walls, its road, and the rest."""

import numpy as np
from PIL import Image, ImageDraw

from f1tenth_sim2d.environments.place import Place

PAPER, ROAD, LINE, WALL = (250, 250, 248), (226, 228, 232), (190, 194, 200), (70, 83, 106)
VIEW = 800
"""Pixels of the longer side of what is shown."""
_LARGEST = 4000
"""Pixels of the longer side of a place that is shown in parts."""
_LEAST_SCALE = 14.0  # pixels per m; a place that would be smaller is shown in parts
_FLOODED = 400  # pixels of the longer side of the image in which a road without a centreline is found
_MARGIN = 0.5  # m
_HEIGHT = 0.16  # m, at which the world is cut


class Ground:
    """The image of a place, all of it.

    Attributes:
        image: PIL image; its colours are PAPER, ROAD, LINE and WALL.
        view: (width, height) of what is shown of it at a time, pixels.
    """

    def __init__(self, outlines, circles, seen, centreline=None):
        """Draw it.

        Args:
            outlines: arrays of shape (n, 2), m; holes turn clockwise, as World.section has them.
            circles: rows of x, y and radius, m.
            seen: places that must be in the image, m, of shape (n, 2); the first is on the road.
            centreline: of the road, if it is known, see Place.
        """
        self._start, self._centreline = np.asarray(seen)[:1], centreline
        self._shapes = _by_size(outlines, circles)
        corners = [shape.corners for shape in self._shapes]
        corners += [seen] if centreline is None else [centreline[:, :2]]
        points = np.concatenate([np.atleast_2d(each) for each in corners])
        self._low = points.min(axis=0) - _MARGIN
        self._size = points.max(axis=0) + _MARGIN - self._low
        longer = self._size.max()
        self.scale = max(VIEW / longer, min(_LEAST_SCALE, _LARGEST / longer))
        """Pixels per m."""
        self.image = self._draw(self.scale)
        if centreline is None:
            self._add_flooded_road()
        self.view = tuple(min(VIEW, each) for each in self.image.size)

    @classmethod
    def of(cls, place: Place):
        """That of a place."""
        start = np.array([place.world.start[:2]])
        outlines, circles = place.world.section(_HEIGHT)
        return cls(outlines, circles, start, place.centreline)

    def pixels(self, points):
        """Points (m, shape (n, 2)) in the image."""
        return self._pixels(points, self.scale)

    def corner(self, x, y):
        """The upper left corner of the view that has a point (m) in its middle, as far as there is ground."""
        middle = self.pixels(np.array([(x, y)]))[0]
        room = np.array(self.image.size) - self.view
        return tuple(int(each) for each in np.clip(np.array(middle) - np.array(self.view) / 2, 0, room))

    def _draw(self, scale):
        size = tuple(np.ceil(self._size * scale).astype(int).clip(1).tolist())
        image, walls = Image.new("RGB", size, PAPER), Image.new("1", size, 0)
        if self._centreline is not None:
            self._draw_road(ImageDraw.Draw(image), scale)
        for shape in self._shapes:
            # With its outline, or a hole would eat the thin wall around it.
            ImageDraw.Draw(walls).polygon(self._pixels(shape.corners, scale), fill=shape.is_solid, outline=1)
        image.paste(WALL, mask=walls)
        return image

    def _draw_road(self, draw, scale):
        right, left = _edges(self._centreline)
        for i in range(len(right)):
            draw.polygon(
                self._pixels(np.array([right[i - 1], right[i], left[i], left[i - 1]]), scale), fill=ROAD
            )
        middle = np.concatenate([self._centreline[:, :2], self._centreline[:1, :2]])
        draw.line(self._pixels(middle, scale), fill=LINE, width=2)

    def _add_flooded_road(self):
        """Without a centreline the road is what can be reached from the start, unless that is everything."""
        scale = _FLOODED / self._size.max()
        flooded = self._draw(scale)
        start = self._pixels(self._start, scale)[0]
        ImageDraw.floodfill(flooded, tuple(int(each) for each in start), ROAD)
        if flooded.getpixel((0, 0)) == ROAD:
            return
        road = np.asarray(flooded.resize(self.image.size, Image.Resampling.NEAREST)) == ROAD
        pixels = np.asarray(self.image).copy()
        pixels[road.all(axis=2) & (pixels == PAPER).all(axis=2)] = ROAD
        self.image = Image.fromarray(pixels)

    def _pixels(self, points, scale):
        right_and_up = (points - self._low) * scale
        return [(x, self._size[1] * scale - y) for x, y in right_and_up]


class _Shape:
    """What is inside an outline: matter, or a hole in it."""

    def __init__(self, corners):
        x, y = corners.T
        self.corners = corners
        self.area = float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)) / 2.0
        self.is_solid = self.area > 0.0


def _by_size(outlines, circles):
    """The largest first: a hole is drawn over what it is in, and what stands in it over the hole."""
    turn = np.linspace(0.0, 2.0 * np.pi, 48, endpoint=False)
    around = np.column_stack([np.cos(turn), np.sin(turn)])
    shapes = [_Shape(each) for each in outlines]
    shapes += [_Shape(np.array([x, y]) + radius * around) for x, y, radius in circles]
    return sorted(shapes, key=lambda shape: -abs(shape.area))


def _edges(centreline):
    """The right and the left edge of a road, each of shape (n, 2), m."""
    middle = centreline[:, :2]
    along = np.roll(middle, -1, axis=0) - np.roll(middle, 1, axis=0)
    left = np.column_stack([-along[:, 1], along[:, 0]]) / np.hypot(*along.T)[:, np.newaxis]
    return middle - centreline[:, 2:3] * left, middle + centreline[:, 3:4] * left
