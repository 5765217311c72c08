# SPDX-License-Identifier: MIT
"""The elastic gate's solid played by Code_Aster. NOT YET RUN WITH A REAL CODE_ASTER: tested against a stand-in of the calls below.

    mpirun -n 1 sph_solver coupling.toml : -n 1 python3 gate.py coupling.toml [KEY=VALUE ...]

in an environment in which `import code_aster` and `import rivage` work. Syntax of versions 16 and 17 (package code_aster, objects of
code_aster.CA). gate.med holds QUAD8 and SEG3 cells and the groups "top" (clamped) and "wet" (the three other sides).
One call of DYNA_NON_LINE a step goes on from the last. interface.load = "conservative": the fluid's forces on the nodes (FORCE_NODALE);
"averaged": its pressure as a following load (TYPE_CHARGE="SUIV") through an evolving load.
"""
import sys

import numpy as np
from code_aster import CA
from code_aster.Commands import (
    _F, AFFE_CHAR_CINE, AFFE_CHAR_MECA, AFFE_MATERIAU, AFFE_MODELE, CREA_CHAMP, CREA_RESU, DEFI_LIST_REEL, DEFI_MATERIAU, DYNA_NON_LINE,
    FIN, LIRE_MAILLAGE, MODI_MAILLAGE)

import rivage
from rivage.external_solver import carry

YOUNG, POISSON, DENSITY = 12.0e6, 0.4, 1100.0    # [Pa], [-], [kg/m^3]
ALPHA = -0.05                                    # of HHT


class WetSurface:
    """Nodes and segments of the group "wet". A SEG3 (a, b, m) gives a-m and m-b; ORIE_PEAU has turned it so that the body is on its left."""

    def __init__(self, mesh):
        connectivity = mesh.getConnectivity()
        cells = [connectivity[cell] for cell in mesh.getCells("wet")]
        self.nodes = sorted({node for cell in cells for node in cell})
        at = {node: k for k, node in enumerate(self.nodes)}
        self.facets = [[at[a], at[b]] for start, end, middle in cells for a, b in ((start, middle), (middle, end))]
        self.reference = np.reshape(mesh.getCoordinates().getValues(), (-1, 3))[self.nodes, :2]

    def on_nodes(self, pressure: np.ndarray) -> np.ndarray:
        """Mean of the facets that meet at each node."""
        total, count = np.zeros(len(self.nodes)), np.zeros(len(self.nodes))
        for nodes, p in zip(self.facets, pressure):
            total[nodes] += p
            count[nodes] += 1
        return total / count


class GateSolver:
    """One implicit step a call, with the pressure that came."""

    def __init__(self, mesh, surface: WetSurface):
        self.mesh, self.surface, self.result = mesh, surface, None
        self.model = AFFE_MODELE(MAILLAGE=mesh, AFFE=_F(TOUT="OUI", PHENOMENE="MECANIQUE", MODELISATION="D_PLAN"))
        rubber = DEFI_MATERIAU(ELAS=_F(E=YOUNG, NU=POISSON, RHO=DENSITY))
        self.material = AFFE_MATERIAU(MAILLAGE=mesh, AFFE=_F(TOUT="OUI", MATER=rubber))
        self.clamp = AFFE_CHAR_CINE(MODELE=self.model, MECA_IMPO=_F(GROUP_MA="top", DX=0.0, DY=0.0))
        self.weight = AFFE_CHAR_MECA(MODELE=self.model, PESANTEUR=_F(GRAVITE=9.81, DIRECTION=(0.0, -1.0, 0.0)))
        self.zero = CREA_CHAMP(TYPE_CHAM="NOEU_DEPL_R", OPERATION="AFFE", MODELE=self.model,
                               AFFE=_F(TOUT="OUI", NOM_CMP=("DX", "DY"), VALE=(0.0, 0.0)))

    def load(self, data: dict, begin: float, end: float) -> _F:
        """What came as an entry of EXCIT, the same at both ends of the step."""
        if "fluid_pressure" in data:
            return _F(CHARGE=self.pressing(data["fluid_pressure"], begin, end), TYPE_CHARGE="SUIV")
        forces = [_F(NOEUD=self.mesh.getNodeName(node), FX=float(x), FY=float(y))
                  for node, (x, y) in zip(self.surface.nodes, data["fluid_forces"])]
        return _F(CHARGE=AFFE_CHAR_MECA(MODELE=self.model, FORCE_NODALE=forces))

    def pressing(self, pressure: np.ndarray, begin: float, end: float):
        """The pressure on the wet nodes, as a load that evolves."""
        field = CA.FieldOnNodesReal(self.mesh, "PRES_R", {"PRES": 0.0}).toSimpleFieldOnNodes()
        field.setValues(self.surface.nodes, ["PRES"] * len(self.surface.nodes), list(self.surface.on_nodes(pressure)))
        steady = field.toFieldOnNodes()
        evolving = CREA_RESU(TYPE_RESU="EVOL_CHAR", OPERATION="AFFE",
                             AFFE=tuple(_F(NOM_CHAM="PRES", CHAM_GD=steady, INST=time) for time in (begin, end)))
        return AFFE_CHAR_MECA(MODELE=self.model, EVOL_CHAR=evolving)

    def run_iteration(self, i_iter: int, current_time: float, delta_t: float, data: dict) -> tuple[bool, dict]:
        begin = current_time - delta_t
        go_on = {"ETAT_INIT": _F(DEPL=self.zero, VITE=self.zero)}    # the acceleration follows from the load
        if self.result is not None:
            go_on = {"reuse": self.result, "RESULTAT": self.result, "ETAT_INIT": _F(EVOL_NOLI=self.result)}
        try:
            self.result = DYNA_NON_LINE(
                MODELE=self.model, CHAM_MATER=self.material,
                EXCIT=(_F(CHARGE=self.clamp), _F(CHARGE=self.weight), self.load(data, begin, current_time)),
                COMPORTEMENT=_F(RELATION="ELAS", DEFORMATION="GROT_GDEP"),
                INCREMENT=_F(LIST_INST=DEFI_LIST_REEL(VALE=(begin, current_time)), INST_INIT=begin),
                SCHEMA_TEMPS=_F(SCHEMA="HHT", ALPHA=ALPHA, MODI_EQUI="OUI", FORMULATION="DEPLACEMENT"),
                NEWTON=_F(MATRICE="TANGENTE", REAC_ITER=1), **go_on)
        except CA.ConvergenceError:
            return False, {}
        return True, {"mesh_displacement": self.on_surface("DEPL"), "mesh_velocity": self.on_surface("VITE")}

    def on_surface(self, name: str) -> np.ndarray:
        field = self.result.getField(name, self.result.getLastIndex()).toSimpleFieldOnNodes()
        values, (nodes, components) = field.getValuesWithDescription()
        found = {(node, component): value for node, component, value in zip(nodes, components, values)}
        return np.array([[found[node, component] for component in ("DX", "DY")] for node in self.surface.nodes])


def main() -> None:
    with rivage.Participant("solid", sys.argv[1], sys.argv[2:]) as me:
        CA.init(comm=me.comm)
        mesh = LIRE_MAILLAGE(FORMAT="MED", UNITE=20)
        mesh = MODI_MAILLAGE(reuse=mesh, MAILLAGE=mesh, ORIE_PEAU=_F(GROUP_MA_PEAU="wet"))
        surface = WetSurface(mesh)
        done = carry(me, GateSolver(mesh, surface), surface.nodes, surface.reference, surface.facets)
        print(f"gate: {done.calls} calls, u = {np.linalg.norm(done.displacement, axis=1).max():.9e} m, work {done.work:.9e} J/m", flush=True)
        FIN()


if __name__ == "__main__":
    main()
