"""Hypsometry and slopes of mountains side by side, as one SVG and a Markdown table.

python3 docs/plot_mountains.py OUT.svg NAME=FILE... --generated NAME=FILE...

Each file is a raster that GDAL reads, of heights in metres, in a projected system, without data where it says so. Rasters finer
than 10 m are averaged to about 10 m first, because slope depends on the spacing at which it is measured.
"""
import sys
import numpy
from osgeo import gdal

gdal.UseExceptions()
WIDTH, HEIGHT, LEFT, TOP, GAP = 420, 300, 60, 50, 90    # of a plot, its place, and the gap between the two; pixels
BIN = 2.0                                               # of slopes, degrees
ABOVE = numpy.linspace(0.0, 1.0, 201)                   # shares of the area, for the curve of heights
REAL, MADE = ["#b3442e", "#d08a2c", "#7a5cad"], "#5d7f9b"


def heights(path):
    """Heights in metres, NaN without data, and their spacing in metres."""
    raster = gdal.Open(path)
    band = raster.GetRasterBand(1)
    z = band.ReadAsArray().astype(float)
    if band.GetNoDataValue() is not None:
        z[z == band.GetNoDataValue()] = numpy.nan
    spacing = abs(raster.GetGeoTransform()[1])
    times = max(1, round(10.0 / spacing))
    rows, columns = (n // times * times for n in z.shape)
    blocks = z[:rows, :columns].reshape(rows // times, times, columns // times, times)
    return blocks.mean(axis=(1, 3)), spacing * times


def measure(path):
    z, spacing = heights(path)
    known = z[~numpy.isnan(z)]
    height = (known - known.min()) / (known.max() - known.min())
    y, x = numpy.gradient(z, spacing)
    slope = numpy.degrees(numpy.arctan(numpy.hypot(x, y)))
    slope = slope[~numpy.isnan(slope)]
    share = numpy.histogram(slope, bins=numpy.arange(0.0, 90.0 + BIN, BIN))[0] / slope.size
    return {"spacing": spacing, "relief": known.max() - known.min(), "integral": height.mean(), "height": numpy.quantile(height, 1.0 - ABOVE),
            "share": share, "median": numpy.median(slope), "release": numpy.mean((slope >= 30) & (slope <= 45)),
            "steep": numpy.mean(slope > 60)}


def line(plot, x, y, colour, width):
    """x and y from 0 to 1, plot 0 or 1."""
    left = LEFT + plot * (WIDTH + GAP)
    points = " ".join(f"{left + a * WIDTH:.1f},{TOP + (1 - b) * HEIGHT:.1f}" for a, b in zip(x, y))
    return f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="{width}"/>'


def text(x, y, words, anchor="start", colour="#1f2933", more=""):
    return f'<text x="{x:.0f}" y="{y:.0f}" text-anchor="{anchor}" fill="{colour}" {more}>{words}</text>'


def frame(plot, title, across, up, ticks_across, ticks_up):
    left = LEFT + plot * (WIDTH + GAP)
    yield f'<rect x="{left}" y="{TOP}" width="{WIDTH}" height="{HEIGHT}" fill="#ffffff" stroke="#aeb9c2"/>'
    yield text(left, TOP - 14, title, more='font-weight="bold"')
    yield text(left + WIDTH / 2, TOP + HEIGHT + 40, across, "middle")
    yield text(0, 0, up, "middle", more=f'transform="translate({left - 42} {TOP + HEIGHT / 2}) rotate(-90)"')
    for at, label in ticks_across:
        yield text(left + at * WIDTH, TOP + HEIGHT + 18, label, "middle")
    for at, label in ticks_up:
        yield text(left - 6, TOP + (1 - at) * HEIGHT + 4, label, "end")


def draw(real, made):
    most = max(one["share"].max() for one in {**real, **made}.values()) * 1.05
    quarters = [(i / 4, f"{i / 4:g}") for i in range(5)]
    percent = [(p / 100 / most, f"{p} %") for p in range(0, int(most * 100) + 1, 2)]
    body = [*frame(0, "Hypsometry", "share of the area that is higher", "height within the relief", quarters, quarters),
            *frame(1, "Slopes", "slope", f"share of the area, each {BIN:g}°", [(d / 90, f"{d}°") for d in range(0, 91, 15)], percent)]
    middle = (numpy.arange(0.0, 90.0, BIN) + BIN / 2) / 90.0
    for group, colours, width in ((made, [MADE] * len(made), 1), (real, REAL, 2.5)):
        for one, colour in zip(group.values(), colours):
            body += [line(0, ABOVE, one["height"], colour, width), line(1, middle, one["share"] / most, colour, width)]
    for row, (name, colour) in enumerate([*zip(real, REAL), (f"massif, seeds {', '.join(made)}", MADE)]):
        body.append(text(LEFT + 2 * WIDTH + GAP - 10, TOP + 22 + 18 * row, name, "end", colour))
    width, height = LEFT + 2 * WIDTH + GAP + 20, TOP + HEIGHT + 56
    return "\n".join([f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
                      'font-family="sans-serif" font-size="13">', '<rect width="100%" height="100%" fill="#faf8f3"/>', *body, "</svg>\n"])


def main(out, *files):
    at = files.index("--generated")
    real, made = ({name: measure(path) for name, path in (file.split("=", 1) for file in group)}
                  for group in (files[:at], files[at + 1:]))
    with open(out, "w") as svg:
        svg.write(draw(real, made))
    print("| mountain | spacing | relief | hypsometric integral | median slope | 30 to 45° | over 60° |\n|---|---|---|---|---|---|---|")
    for name, one in [*real.items(), *((f"massif, seed {name}", one) for name, one in made.items())]:
        print(f"| {name} | {one['spacing']:.1f} m | {one['relief']:.0f} m | {one['integral']:.2f} | {one['median']:.0f}° "
              f"| {100 * one['release']:.0f} % | {100 * one['steep']:.1f} % |")


main(*sys.argv[1:])
