"""The items' names, in the paper's order, and the modules that make them."""

import importlib

MODULES = {
    "fig1": "deflation",
    "fig2": "sections",
    "fig3": "surface_maps",
    "fig4": "inertia_over_time",
    "fig5": "profile",
    "fig6": "streaklines",
    "fig7": "shear_rates",
    "fig8": "shear_recovery",
    "fig9": "shear_surfaces",
    "fig10": "pair",
    "table3": "grid_convergence",
    "table4": "inertia",
    "table5": "phase_diagram",
    "gauss-bonnet": "gauss_bonnet",
    "appendix-a": "collision",
    "appendix-b": "frames",
}


def module_of(name):
    """With TITLE, PAPER (what the paper shows and says), plan(quick) -> simulations, judge(item, finished)."""
    return importlib.import_module(f"items.{MODULES[name]}")
