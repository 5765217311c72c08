# SPDX-License-Identifier: MIT
"""Turns a mesh of Gmsh into a MED file, for a Gmsh that was built without MED, as Debian's is:

    gmsh -2 -format msh22 FILE.geo && /usr/bin/python3 cases/tools/msh_to_med.py FILE.msh FILE.med

Reads MSH 2.2 (text), writes MED 4.1. Physical groups become groups; each cell belongs to one at most.
"""
import sys
from pathlib import Path

import h5py
import numpy as np

# Nodes of a cell beyond its corners, by the corners they lie between: Gmsh's order and MED's. MED counts the corners of a solid's
# first face the other way round.
TET_EDGES = [(0, 1), (1, 2), (0, 2), (0, 3), (2, 3), (1, 3)]
HEX_EDGES = [(0, 1), (0, 3), (0, 4), (1, 2), (1, 5), (2, 3), (2, 6), (3, 7), (4, 5), (4, 7), (5, 6), (6, 7)]
HEX_FACES = [(0, 1, 2, 3), (0, 1, 4, 5), (0, 3, 4, 7), (1, 2, 5, 6), (2, 3, 6, 7), (4, 5, 6, 7)]
MED_TET_EDGES = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]
MED_HEX_EDGES = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
MED_HEX_FACES = [(0, 1, 2, 3), (0, 1, 4, 5), (1, 2, 5, 6), (2, 3, 6, 7), (3, 0, 7, 4), (4, 5, 6, 7)]
TET_TURNED = [0, 2, 1, 3]
HEX_TURNED = [0, 3, 2, 1, 4, 7, 6, 5]
WHOLE = [tuple(range(8))]


def order(turned, gmsh_inner, med_inner):
    """Place in Gmsh's list of each node in MED's list."""
    corners = [frozenset([c]) for c in range(len(turned))]
    gmsh = corners + [frozenset(inner) for inner in gmsh_inner]
    med = [frozenset([turned[c]]) for c in range(len(turned))] + [frozenset(turned[c] for c in inner) for inner in med_inner]
    return [gmsh.index(node) for node in med]


# Gmsh's number of a kind of cell: (dimension, MED's name, MED's geometry code, order of the nodes)
KINDS = {
    15: (0, "PO1", 1, [0]),
    1: (1, "SE2", 102, [0, 1]),
    8: (1, "SE3", 103, [0, 1, 2]),
    2: (2, "TR3", 203, list(range(3))),
    9: (2, "TR6", 206, list(range(6))),
    3: (2, "QU4", 204, list(range(4))),
    16: (2, "QU8", 208, list(range(8))),
    10: (2, "QU9", 209, list(range(9))),
    4: (3, "TE4", 304, order(TET_TURNED, [], [])),
    11: (3, "T10", 310, order(TET_TURNED, TET_EDGES, MED_TET_EDGES)),
    5: (3, "HE8", 308, order(HEX_TURNED, [], [])),
    17: (3, "H20", 320, order(HEX_TURNED, HEX_EDGES, MED_HEX_EDGES)),
    12: (3, "H27", 327, order(HEX_TURNED, HEX_EDGES + HEX_FACES + WHOLE, MED_HEX_EDGES + MED_HEX_FACES + WHOLE)),
}


def sections(text):
    """The lines of each $Section."""
    found, name = {}, None
    for line in text.splitlines():
        if line.startswith("$"):
            name = None if line.startswith("$End") else line[1:].strip()
            found.setdefault(name, [])
        elif name:
            found[name].append(line)
    return found


def read_msh(path):
    """Names by (dimension, tag), points, and cells by Gmsh's kind: rows of (tag, nodes from 1)."""
    parts = sections(Path(path).read_text())
    if not parts.get("MeshFormat", [""])[0].startswith("2.2 0"):
        sys.exit(f"{path}: not a text file of MSH 2.2; write it by gmsh -format msh22")
    names = {}
    for line in parts.get("PhysicalNames", [])[1:]:
        dimension, tag, name = line.split(maxsplit=2)
        names[int(dimension), int(tag)] = name.strip('"')
    nodes = np.loadtxt(parts["Nodes"][1:], ndmin=2)
    number = {int(tag): k + 1 for k, tag in enumerate(nodes[:, 0])}
    cells = {}
    for line in parts["Elements"][1:]:
        row = [int(word) for word in line.split()]
        kind, tags = row[1], row[2]
        if kind not in KINDS:
            sys.exit(f"{path}: element {row[0]} is of a kind ({kind}) that MED or this tool does not have")
        cells.setdefault(kind, []).append((row[3], [number[node] for node in row[3 + tags:]]))
    return names, nodes[:, 1:], cells


def fixed(text, width):
    return np.frombuffer(text.encode().ljust(width, b"\0"), dtype=np.int8)


def attributes(group, **values):
    for name, value in values.items():
        group.attrs[name] = value


def write_cells(step, points, cells, family):
    common = dict(CGT=np.int32(1), CGS=np.int32(1), PFL=np.bytes_("MED_NO_PROFILE_INTERNAL"))
    nodes = step.create_group("NOE")
    attributes(nodes, **common)
    data = nodes.create_dataset("COO", data=points.flatten(order="F"))
    attributes(data, CGT=np.int32(1), NBR=np.int32(len(points)))
    every = step.create_group("MAI")
    attributes(every, CGT=np.int32(1))
    for kind, rows in sorted(cells.items(), key=lambda item: KINDS[item[0]][2]):
        dimension, name, code, places = KINDS[kind]
        group = every.create_group(name)
        attributes(group, GEO=np.int32(code), **common)
        connectivity = np.array([row for _, row in rows], dtype=np.int32)[:, places]
        data = group.create_dataset("NOD", data=connectivity.flatten(order="F"))
        attributes(data, CGT=np.int32(1), NBR=np.int32(len(rows)))
        numbers = np.array([family.get((dimension, tag), 0) for tag, _ in rows], dtype=np.int32)
        data = group.create_dataset("FAM", data=numbers)
        attributes(data, CGT=np.int32(1), NBR=np.int32(len(rows)))


def write_families(file, mesh, names, family):
    families = file.create_group(f"FAS/{mesh}", track_order=True)
    members = families.create_group("ELEME", track_order=True)  # the library goes through them in the order of their making
    attributes(families.create_group("FAMILLE_ZERO"), NUM=np.int32(0))
    for key, name in names.items():
        group = members.create_group(f"FAM_{family[key]}_{name}")
        attributes(group, NUM=np.int32(family[key]))
        groups = group.create_group("GRO")
        attributes(groups, NBR=np.int32(1))
        data = groups.create_dataset("NOM", (1,), dtype=np.dtype((np.int8, (80,))))
        data[0] = fixed(name, 80)


def write_med(path, names, points, cells, mesh):
    family = {key: -(k + 1) for k, key in enumerate(sorted(names))}
    dimension = max(KINDS[kind][0] for kind in cells)
    with h5py.File(path, "w", libver=("v108", "v108")) as file:
        attributes(file.create_group("INFOS_GENERALES"), MAJ=np.int32(4), MIN=np.int32(1), REL=np.int32(0))
        head = file.create_group(f"ENS_MAA/{mesh}")
        attributes(head, DIM=np.int32(dimension), ESP=np.int32(3), REP=np.int32(0), SRT=np.int32(1), TYP=np.int32(0),
                   UNT=np.bytes_(""), UNI=np.bytes_("m".ljust(16) * 3), NOM=np.bytes_("".join(a.ljust(16) for a in "XYZ")),
                   DES=np.bytes_("from Gmsh"), NXI=np.int32(-1), NXT=np.int32(-1))
        step = head.create_group("-0000000000000000001-0000000000000000001")
        attributes(step, CGT=np.int32(1), NDT=np.int32(-1), NOR=np.int32(-1), PDT=-1.0, NXI=np.int32(-1), NXT=np.int32(-1),
                   PVI=np.int32(-1), PVT=np.int32(-1))
        write_cells(step, points, cells, family)
        write_families(file, mesh, names, family)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    names, points, cells = read_msh(sys.argv[1])
    write_med(sys.argv[2], names, points, cells, Path(sys.argv[2]).stem)


if __name__ == "__main__":
    main()
