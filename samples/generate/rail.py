#!/usr/bin/env python3
"""samples/generate/rail.py OUT.vdb: a stamp for the brush org.burin.vdb-trail, a ring that stands around a rail.

Needs OpenVDB's Python module (Debian: python3-openvdb). The level set repeats every 32 voxels along x.
"""
import math
import sys

import numpy
import pyopenvdb

PERIOD, ACROSS, HEIGHT = 32, 32, 32  # voxels
RAIL, WIRE, RING = 3.0, 2.6, 9.5     # radii of the rail, of the ring's wire and of its middle line, voxels
BAND = 3.0


def distance(x, y, z):
    """Of a place from the rail and the rings, voxels."""
    along = (x + PERIOD / 2) % PERIOD - PERIOD / 2
    from_axis = numpy.hypot(y, z)
    ring = numpy.hypot(along + 0.35 * z, from_axis - RING) - WIRE  # leaning
    return numpy.minimum(from_axis - RAIL, ring * math.cos(math.atan(0.35)))


x, y, z = numpy.meshgrid(numpy.arange(PERIOD) + 0.5 - PERIOD / 2, numpy.arange(ACROSS) + 0.5 - ACROSS / 2,
                         numpy.arange(HEIGHT) + 0.5 - HEIGHT / 2, indexing="ij")
grid = pyopenvdb.FloatGrid(background=BAND)
grid.copyFromArray(numpy.clip(distance(x, y, z), -BAND, BAND).astype(numpy.float32))
grid.name = "rail"
grid.gridClass = pyopenvdb.GridClass.LEVEL_SET
grid.transform = pyopenvdb.createLinearTransform(voxelSize=1.0)
pyopenvdb.write(sys.argv[1], grids=[grid])
