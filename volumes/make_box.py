#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the sample medium of [BG91]: 10 x 10 x 10 zones of 0.1 x 0.1 x 0.05 m with density 1.

Usage: make_box.py [FILE], with Debian's python3-openvdb; FILE is box.vdb beside this script.
"""
import os
import sys

import pyopenvdb as vdb

path = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(__file__), "box.vdb")
density = vdb.FloatGrid()
density.name = "density"
density.gridClass = vdb.GridClass.FOG_VOLUME
density.transform = vdb.createLinearTransform(
    [[0.1, 0, 0, 0], [0, 0.1, 0, 0], [0, 0, 0.05, 0], [0, 0, 0, 1]])
density.fill((0, 0, 0), (9, 9, 9), 1.0)
vdb.write(path, grids=[density])
