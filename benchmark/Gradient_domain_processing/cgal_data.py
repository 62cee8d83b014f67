# Copyright (c) 2026  The Gradient_domain_processing authors.
#
# This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The meshes of CGAL's data."""

import os
import tarfile

ARCHIVE = "/usr/share/doc/libcgal-dev/data.tar.gz"  # Debian: package libcgal-demo


def folder_of_meshes(data, folder):
    """`data` itself, or where the meshes are if it is the archive, which is unpacked into `folder` once."""
    if not os.path.isfile(data):
        return data
    meshes = os.path.join(folder, "data", "meshes")
    if not os.path.isdir(meshes):
        with tarfile.open(data) as archive:
            archive.extractall(folder, [m for m in archive.getmembers() if m.name.startswith("data/meshes/") and m.name.endswith(".off")])
    return meshes
