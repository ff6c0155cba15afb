"""Spectrum of a sound over time, as one SVG.

python3 docs/plot_sound.py slide.wav OUT.svg

slide.wav: of 16 bits, as `couloir replay --audio` writes it. Each column is a moment, each row a frequency on a logarithmic scale;
colours go from -110 to -20 dB of a full-scale sine wave.
"""
import base64
import struct
import sys
import wave
import zlib
import numpy

COLUMNS, ROWS = 600, 210             # of the picture
WIDTH, HEIGHT, LEFT, TOP = 672, 290, 52, 24
LEAST_HZ, MOST_HZ = 20.0, 16000.0
WINDOW = 4096                        # samples
DARKEST, BRIGHTEST = -110.0, -20.0   # dB
COLOURS = [(0.00, (10, 12, 30)), (0.35, (46, 60, 120)), (0.65, (120, 150, 190)), (0.85, (240, 200, 120)), (1.00, (255, 250, 235))]


def spectrum(samples, rate):
    """Levels in dB, rows from the highest frequency."""
    hertz = numpy.fft.rfftfreq(WINDOW, 1 / rate)
    wanted = numpy.geomspace(MOST_HZ, LEAST_HZ, ROWS)
    nearest = [numpy.argmin(abs(hertz - each)) for each in wanted]
    shape = numpy.hanning(WINDOW)
    begins = numpy.linspace(0, len(samples) - WINDOW, COLUMNS).astype(int)
    columns = [abs(numpy.fft.rfft(samples[i:i + WINDOW] * shape))[nearest] for i in begins]
    return 20 * numpy.log10(numpy.array(columns).T * 4 / WINDOW + 1e-9)


def png(levels):
    """A PNG with a palette of 32 colours."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    shares = numpy.clip((levels - DARKEST) / (BRIGHTEST - DARKEST), 0, 1)
    places, colours = zip(*COLOURS)
    steps = numpy.linspace(0, 1, 32)
    palette = numpy.stack([numpy.interp(steps, places, [c[i] for c in colours]) for i in range(3)], axis=1).astype(numpy.uint8)
    rows = b"".join(b"\0" + row.tobytes() for row in (shares * 31.99).astype(numpy.uint8))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", COLUMNS, ROWS, 8, 3, 0, 0, 0)) +
            chunk(b"PLTE", palette.tobytes()) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def main():
    source, target = sys.argv[1:]
    with wave.open(source) as file:
        rate, channels = file.getframerate(), file.getnchannels()
        samples = numpy.frombuffer(file.readframes(file.getnframes()), dtype="<i2").reshape(-1, channels).mean(axis=1) / 32768
    seconds = len(samples) / rate
    picture = base64.b64encode(png(spectrum(samples, rate))).decode()
    bottom = TOP + ROWS
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="12" fill="#1d2733">',
             f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#faf8f2"/>',
             f'<image x="{LEFT}" y="{TOP}" width="{COLUMNS}" height="{ROWS}" href="data:image/png;base64,{picture}"/>',
             f'<text x="{LEFT}" y="16">Hz</text>',
             f'<text x="{LEFT + COLUMNS / 2}" y="{HEIGHT - 10}" text-anchor="middle">seconds</text>']
    for hz in (50, 100, 200, 500, 1000, 2000, 5000, 10000):
        y = TOP + ROWS * numpy.log(MOST_HZ / hz) / numpy.log(MOST_HZ / LEAST_HZ)
        lines.append(f'<path d="M{LEFT - 5} {y:.1f}h5" stroke="#1d2733"/><text x="{LEFT - 8}" y="{y + 4:.1f}" text-anchor="end">{hz}</text>')
    for second in range(0, int(seconds) + 1, 20 if seconds > 60 else 5):
        x = LEFT + COLUMNS * second / seconds
        lines.append(f'<path d="M{x:.1f} {bottom}v5" stroke="#1d2733"/><text x="{x:.1f}" y="{bottom + 18}" text-anchor="middle">{second}</text>')
    with open(target, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n</svg>\n")


main()
