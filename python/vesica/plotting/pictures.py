"""Every picture of a run by its name: what `Run.plot`, `Run.render` and `tools/plot-run` draw."""

import numpy

from vesica.errors import InputError, Unavailable
from vesica.plotting import (angle_picture, area_picture, column_picture, conservation_picture, energy_picture,
                             inertia_picture, profile_picture, surface_picture, view)
from vesica.plotting.comparison import nearest_branch
from vesica.plotting.helfrich import HelfrichShapes
from vesica.plotting.surface import fold, read_surface


class Pictures:
    """Of one vesicle of a RunDirectory. Each method returns (figure, one line that says what it shows), or raises
    Unavailable."""

    def __init__(self, run, vesicle=0):
        self.run, self.vesicle = run, vesicle
        self.metrics = run.metrics(vesicle)
        self.shapes = HelfrichShapes()
        self.title = run.title if len(run.vesicles()) == 1 else f"{run.title}, vesicle {vesicle}"
        self.bending_time = run.bending_time(vesicle, self.metrics["volume"][-1])
        self.curvature = run.spontaneous_curvature(vesicle)
        self._surfaces = {}

    def profile(self, step=None):
        path, step = self._surface_file(step)
        same = (self.metrics["step"] == step).nonzero()[0]
        row = same[-1] if len(same) else -1  # the sample of the surface's step, else the last
        v, volume = self.metrics["reduced_volume"][row], self.metrics["volume"][row]
        if not (v > 0.0 and volume > 0.0):
            raise Unavailable("the sample of the last surface has no finite volume and reduced volume")
        folded = fold(self._surface(path))
        remark = f"Helfrich's shapes are those of C0 = 0; this run has C0 = {self.curvature:g}" if self.curvature else ""
        comparison = nearest_branch(folded, self.shapes, v, volume)
        return profile_picture.draw(folded, comparison, v, volume, self.title, remark)

    def energy(self):
        return energy_picture.draw(self.metrics, self.shapes, self.title, self.bending_time, self.curvature)

    def area(self):
        return area_picture.draw(self.metrics, self.title, self.bending_time)

    def inertia(self):
        return inertia_picture.draw(self.metrics, self.shapes, self.title, self.run.density(), self.bending_time,
                                    self.curvature)

    def angle(self):
        return angle_picture.draw(self.metrics, self.title, self.run.shear_rate(), self.run.viscosity_ratio(self.vesicle))

    def conservation(self):
        return conservation_picture.draw(self.metrics, self.title)

    def surface(self, step=None):
        path, step = self._surface_file(step)
        return surface_picture.draw(self._surface(path), f"{self.title}: the surface at step {step}")

    def columns(self, names):
        return column_picture.draw(self.metrics, names, self.title)

    def _surface_file(self, step):
        if step is None:
            return self.run.last_surface()
        found = self.run.surfaces()
        if step not in found:
            raise InputError(f"step is {step}; expected one with a surface: {', '.join(map(str, sorted(found))) or 'none'}")
        return found[step], step

    def _surface(self, path):
        if path not in self._surfaces:
            self._surfaces[path] = read_surface(path, self.vesicle).in_cells(self.run.cell_length())
        return self._surfaces[path]


OVER_TIME = ("energy", "area", "inertia", "angle", "conservation")


def plot(run, quantity, vesicle=0, step=None):
    """The figure of `quantity`: a name of OVER_TIME, "profile", or columns of the metrics."""
    pictures = Pictures(run, vesicle)
    if quantity == "profile":
        return pictures.profile(step)[0]
    if step is not None:
        raise InputError(f"step is {step}, but {quantity} is drawn over time; expected a step for \"profile\" only")
    if isinstance(quantity, str) and quantity in OVER_TIME:
        return getattr(pictures, quantity)()[0]
    names = [quantity] if isinstance(quantity, str) else list(quantity)
    for name in names:
        if name not in pictures.metrics:
            raise InputError(f"quantity is {name!r}; expected one of {', '.join(('profile', *OVER_TIME))}, "
                             f"or a column: {', '.join(pictures.metrics)}")
    if not names:
        raise InputError("quantity is empty; expected the name of a picture or columns of the metrics")
    return pictures.columns(names)[0]


def render(surface, title, colour_by="mean_curvature", annotated=True):
    """The figure, or where it is not `annotated` VTK's pixels, (height, width, 3) uint8."""
    if annotated:
        return surface_picture.draw(surface, title, colour_by)[0]
    colours, _, _ = surface_picture.paint(surface, colour_by)
    pixels = surface_picture.pixels_of(surface, colours, view.choose(surface))
    if pixels is None:
        raise Unavailable("VTK finds no display to render with; expected xvfb-run; try Debian's packages xvfb and xauth")
    return (255.0 * pixels[..., :3] + 0.5).astype(numpy.uint8)
