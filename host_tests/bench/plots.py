"""One picture: time by depth, time by triangles, and unions."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from targets import PAIR  # noqa: E402

STYLE = {
    "scan-runs": ("black", "o"), "scan-bits": ("grey", "s"), "scan-simple": ("grey", "x"), "osem-centre": ("tab:blue", "o"),
    "osem-three": ("tab:cyan", "s"), "plain-centre": ("tab:blue", "x"), "plain-three": ("tab:cyan", "x"),
    "vdb-fill": ("tab:red", "^"),
}


def curve(axes, method, points):
    points = sorted(points)
    if points:
        colour, marker = STYLE[method]
        axes.plot([x for x, _ in points], [y for _, y in points], color=colour, marker=marker, markersize=4,
                  linestyle="--" if method.startswith("plain") else "-", label=method)


def by_depth(axes, found, solid):
    for method in STYLE:
        curve(axes, method, [(cells, found.ms("convert", solid, cells, method))
                             for name, cells in found.subjects("convert")
                             if name == solid and found.get("convert", solid, cells, method)])
    axes.set(title=f"Conversion of {solid}", xlabel="cells along an axis", ylabel="ms")


def by_triangles(axes, found, prefix, title):
    for method in STYLE:
        curve(axes, method, [(int(name.split("-")[1]), found.ms("convert", name, cells, method))
                             for name, cells in found.subjects("convert")
                             if name.startswith(prefix) and found.get("convert", name, cells, method)])
    axes.set(title=title, xlabel="triangles", ylabel="ms")


def booleans(axes, found):
    bars = [(one["method"], one["ms"]) for one in found.as_list()
            if one["theme"] == "union" and one["solid"] == PAIR and one["side"] == 1024]
    axes.barh([method for method, _ in bars], [ms for _, ms in bars], log=True)
    axes.set(title=f"Union of {PAIR} at 1024", xlabel="ms")


def draw(found, path):
    figure, axes = plt.subplots(2, 3, figsize=(16, 9))
    by_depth(axes[0][0], found, "armadillo")
    by_depth(axes[0][1], found, "rotor")
    by_depth(axes[0][2], found, "bracket")
    by_triangles(axes[1][0], found, "sphere-", "Sphere that fills the root, at 1024")
    by_triangles(axes[1][1], found, "dot-", "Sphere of 1/16 of the root, at 1024")
    booleans(axes[1][2], found)
    for one in axes.flat[:5]:
        one.set_xscale("log", base=2)
        one.xaxis.set_major_formatter("{x:,.0f}")
        one.set_yscale("log")
        one.grid(True, which="both", alpha=0.3)
        one.margins(x=0.1, y=0.35) # room for the legend above the curves
        if one.lines:
            one.legend(fontsize=8, ncols=3, loc="upper left")
    for one in axes.flat:
        one.set_visible(bool(one.lines or one.patches)) # what was not measured is not drawn
    figure.tight_layout()
    figure.savefig(path, dpi=110)
