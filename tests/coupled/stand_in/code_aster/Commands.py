# SPDX-License-Identifier: MIT
"""The operators of the stand-in: each refuses a keyword that it does not know, wants those that it needs."""
from collections.abc import Callable

import numpy as np

from code_aster.CA import HIGH, LOW, ConvergenceError, FieldOnNodesReal, Mesh


class _F(dict):
    def __init__(self, **keywords):
        super().__init__(keywords)


def operator(needed: str, optional: str = "", **inner: str) -> Callable:
    """Keywords, as words; inner: those of a factor keyword, all known, none needed."""
    def checked(body: Callable) -> Callable:
        def call(**keywords):
            missing, unknown = set(needed.split()) - set(keywords), set(keywords) - set(f"{needed} {optional}".split())
            assert not missing and not unknown, f"{body.__name__}: missing {missing}, unknown {unknown}"
            for name, known in inner.items():
                for one in np.atleast_1d(np.array(keywords.get(name, []), dtype=object)):
                    assert set(one) <= set(known.split()), f"{body.__name__}, {name}: {set(one) - set(known.split())} unknown"
            return body(keywords)
        call.__name__ = body.__name__
        return call
    return checked


@operator("FORMAT UNITE")
def LIRE_MAILLAGE(told):
    assert told["FORMAT"] == "MED"
    return Mesh()


@operator("reuse MAILLAGE ORIE_PEAU", ORIE_PEAU="GROUP_MA_PEAU")
def MODI_MAILLAGE(told):
    assert told["reuse"] is told["MAILLAGE"]
    told["MAILLAGE"].orient()
    return told["MAILLAGE"]


@operator("MAILLAGE AFFE", AFFE="TOUT PHENOMENE MODELISATION")
def AFFE_MODELE(told):
    assert told["AFFE"]["MODELISATION"] == "D_PLAN"
    return told["MAILLAGE"]


@operator("ELAS", ELAS="E NU RHO")
def DEFI_MATERIAU(told):
    return told["ELAS"]


@operator("MAILLAGE AFFE", AFFE="TOUT MATER")
def AFFE_MATERIAU(told):
    return told["AFFE"]["MATER"]


@operator("MODELE MECA_IMPO", MECA_IMPO="GROUP_MA DX DY")
def AFFE_CHAR_CINE(told):
    return {}


@operator("MODELE", "PESANTEUR EVOL_CHAR FORCE_NODALE", PESANTEUR="GRAVITE DIRECTION", FORCE_NODALE="NOEUD FX FY")
def AFFE_CHAR_MECA(told):
    return {name: told[name] for name in ("PESANTEUR", "EVOL_CHAR", "FORCE_NODALE") if name in told}


@operator("TYPE_CHAM OPERATION MODELE AFFE", AFFE="TOUT NOM_CMP VALE")
def CREA_CHAMP(told):
    assert told["TYPE_CHAM"] == "NOEU_DEPL_R"
    return FieldOnNodesReal(told["MODELE"], "DEPL_R", dict(zip(told["AFFE"]["NOM_CMP"], told["AFFE"]["VALE"])))


@operator("TYPE_RESU OPERATION AFFE", AFFE="NOM_CHAM CHAM_GD INST")
def CREA_RESU(told):
    assert told["TYPE_RESU"] == "EVOL_CHAR" and {one["NOM_CHAM"] for one in told["AFFE"]} == {"PRES"}
    return {one["INST"]: one["CHAM_GD"] for one in told["AFFE"]}


@operator("VALE")
def DEFI_LIST_REEL(told):
    assert (np.diff(told["VALE"]) > 0).all()
    return told["VALE"]


class Result:
    """A non-linear result: the motion along y, step by step."""

    def __init__(self, mesh: Mesh, q: float, v: float, a: float):
        self.mesh, self.q, self.v, self.a, self.times = mesh, q, v, a, []

    def getLastIndex(self) -> int:
        return len(self.times)

    def getField(self, name: str, index: int) -> FieldOnNodesReal:
        assert index == len(self.times)
        return FieldOnNodesReal(self.mesh, "DEPL_R", {"DX": 0.0, "DY": {"DEPL": self.q, "VITE": self.v}[name]})


def pushing(entry: dict, mesh: Mesh, mass: float, time: float) -> float:
    """Force along y of an entry of EXCIT [N/m]; of a pressure on the cells of "wet", linear between their nodes."""
    charge = entry["CHARGE"]
    if "PESANTEUR" in charge:
        return mass * charge["PESANTEUR"]["GRAVITE"] * charge["PESANTEUR"]["DIRECTION"][1]
    if "FORCE_NODALE" in charge:
        assert [one["NOEUD"] for one in charge["FORCE_NODALE"]] == [f"N{node + 1}" for node in range(len(mesh.points))]
        return sum(one["FY"] for one in charge["FORCE_NODALE"])
    if "EVOL_CHAR" not in charge:
        return 0.0
    assert entry["TYPE_CHARGE"] == "SUIV"
    pressure, total = charge["EVOL_CHAR"][time], 0.0
    for a, b, middle in mesh.cells:
        for one, other in ((a, middle), (middle, b)):
            p = 0.5 * (pressure.values[one, "PRES"] + pressure.values[other, "PRES"])
            total += p * (mesh.points[other, 0] - mesh.points[one, 0])
    return total


@operator("MODELE CHAM_MATER EXCIT COMPORTEMENT INCREMENT SCHEMA_TEMPS NEWTON ETAT_INIT", "reuse RESULTAT", EXCIT="CHARGE TYPE_CHARGE",
          COMPORTEMENT="RELATION DEFORMATION", INCREMENT="LIST_INST INST_INIT", SCHEMA_TEMPS="SCHEMA ALPHA MODI_EQUI FORMULATION",
          NEWTON="MATRICE REAC_ITER", ETAT_INIT="EVOL_NOLI DEPL VITE ACCE")
def DYNA_NON_LINE(told):
    """One step of HHT in its full form, MODI_EQUI='OUI': the plate's mass on its spring. Both loads are those of this call."""
    begin, end = told["INCREMENT"]["LIST_INST"]
    assert told["SCHEMA_TEMPS"]["MODI_EQUI"] == "OUI" and abs(told["INCREMENT"]["INST_INIT"] - begin) < 1e-12
    k, m = told["CHAM_MATER"]["E"], told["CHAM_MATER"]["RHO"] * (HIGH[0] - LOW[0]) * (HIGH[1] - LOW[1])
    before, after = (sum(pushing(one, told["MODELE"], m, time) for one in told["EXCIT"]) for time in (begin, end))
    state = told["ETAT_INIT"].get("EVOL_NOLI")
    if state is None:
        state = Result(told["MODELE"], 0.0, 0.0, before / m)
    assert state is told.get("reuse", state) and (not state.times or abs(state.times[-1] - begin) < 1e-12)
    step(state, k, m, before, after, told["SCHEMA_TEMPS"]["ALPHA"], end - begin)
    state.times.append(end)
    if abs(state.q) > HIGH[1] - LOW[1]:
        raise ConvergenceError("the plate has left its place")
    return state


def step(state: Result, k: float, m: float, before: float, after: float, alpha: float, dt: float) -> None:
    """m a_1 + (1+alpha)(k q_1 - f_1) - alpha (k q_0 - f_0) = 0"""
    beta, gamma = (1 - alpha)**2 / 4, 0.5 - alpha
    ahead = state.q + dt * state.v + dt**2 * (0.5 - beta) * state.a
    a = ((1 + alpha) * (after - k * ahead) + alpha * (k * state.q - before)) / (m + (1 + alpha) * beta * dt**2 * k)
    state.v += dt * ((1 - gamma) * state.a + gamma * a)
    state.q, state.a = ahead + beta * dt**2 * a, a


def FIN() -> None:
    """Nothing to close here."""
