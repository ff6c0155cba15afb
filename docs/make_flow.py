"""Writes mesh.obj and velocities.npy for `couloir track`: a disc that moves over an irregular mesh."""
import numpy

SIDE, FRAMES, DT = 41, 100, 0.02        # vertices along a side of 1 m; frames; s between frames
RADIUS, VELOCITY = 0.2, (0.2, 0.1)      # of the disc, m and m/s; all else is at rest

index = numpy.arange(SIDE * SIDE)
column, row = index % SIDE, index // SIDE
inside = (column > 0) & (column < SIDE - 1) & (row > 0) & (row < SIDE - 1)
shift = numpy.stack([numpy.sin(7.0 * index), numpy.sin(11.0 * index)], axis=1)
vertices = (numpy.stack([column, row], axis=1) + 0.2 * shift * inside[:, None]) / (SIDE - 1)
corner = index[(column < SIDE - 1) & (row < SIDE - 1)]

with open("mesh.obj", "w") as obj:
    obj.writelines(f"v {x:.4f} {y:.4f} 0\n" for x, y in vertices)
    for a in corner + 1:                # vertices count from 1
        obj.write(f"f {a} {a + 1} {a + SIDE + 1}\nf {a} {a + SIDE + 1} {a + SIDE}\n")

velocities = numpy.zeros((FRAMES, len(index), 2), "<f4")
for frame in range(FRAMES):
    centre = numpy.array([0.3, 0.4]) + DT * frame * numpy.array(VELOCITY)
    velocities[frame, numpy.hypot(*(vertices - centre).T) < RADIUS] = VELOCITY
numpy.save("velocities.npy", velocities)
