"""Draw a vesicle by VTK without a display: by its curvature, and bare, by the force of its bending."""

from PIL import Image

import vesica

case = vesica.Case("cases/prolate.toml", {"lattice.size": [32, 32, 40], "vesicle[0].centre": [16, 16, 20],
                                          "vesicle[0].radius": 9, "output.surfaces.every": 20})
run = vesica.run(case, "out/render_a_surface", steps=20, overwrite=True)
run.render(colour_by="mean_curvature").savefig("out/curvature.png")
Image.fromarray(run.render(step=0, colour_by="bending_force", annotated=False)).save("out/bending.png")  # one of a film
