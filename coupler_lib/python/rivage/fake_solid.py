# SPDX-License-Identifier: MIT
"""A solid with an analytic answer, for whoever couples a fluid: python3 -m rivage.fake_solid coupling.toml MOTION ...

    spring   a rigid plate of mass m on a spring k            under a sudden force F: u = F/k (1 - cos(t sqrt(k/m)))
    rigid    a plate that moves as told, u = A sin(2 pi f t)  under a constant force F: its work is F u
    beam     a pinned beam, by its first modes                under a sudden pressure p, at x from its end:
             w = sum over odd n of 4 p / (n pi m w_n^2) sin(n pi x/L) (1 - cos w_n t),  w_n = (n pi/L)^2 sqrt(EI/m)

2D, one rank, per metre of depth. The wet surface is the straight line from --start to --end, the body on its left; motion is
along its normal, positive into the body, that is, the way a pressure pushes. With --out: ROLE/probes.csv with the motion of the
line's middle, ROLE/energy.csv.
"""
import argparse

import numpy as np

from rivage.fake_program import add_common, command, run
from rivage.participant import Error, Participant
from rivage.tables import SolidTables


class Modes:
    """Independent oscillators m a + k q = f, stepped by the trapezoidal rule under a load that is constant in a step:

        q_1 = q_0 + dt v_0 + dt^2/4 (a_0 + a_1),  v_1 = v_0 + dt/2 (a_0 + a_1),  a = (f - k q)/m at both ends

    so that energy grows by f (q_1 - q_0) to round-off.
    """

    def __init__(self, mass, stiffness):
        self.mass, self.stiffness = np.atleast_1d(mass).astype(float), np.atleast_1d(stiffness).astype(float)
        self.q, self.v, self.a = (np.zeros_like(self.mass) for _ in range(3))
        self.work = 0.0

    def load(self, force: np.ndarray) -> None:
        self.a = (force - self.stiffness * self.q) / self.mass

    def advance(self, force: np.ndarray, dt: float) -> None:
        self.load(force)
        ahead = self.q + dt * self.v + 0.25 * dt**2 * self.a
        after = (force - self.stiffness * ahead) / (self.mass + 0.25 * dt**2 * self.stiffness)
        self.work += float(force @ (ahead + 0.25 * dt**2 * after - self.q))
        self.q, self.v, self.a = ahead + 0.25 * dt**2 * after, self.v + 0.5 * dt * (self.a + after), after

    @property
    def kinetic(self) -> float:
        return float(0.5 * self.mass @ self.v**2)

    @property
    def strain(self) -> float:
        return float(0.5 * self.stiffness @ self.q**2)


class Told:
    """A motion that no load changes."""
    kinetic = strain = 0.0

    def __init__(self, amplitude: float, frequency: float):
        self.amplitude, self.omega, self.time, self.work = amplitude, 2 * np.pi * frequency, 0.0, 0.0
        self.move()

    def move(self) -> None:
        phase = self.omega * self.time
        self.q, self.v = np.array([self.amplitude * np.sin(phase)]), np.array([self.amplitude * self.omega * np.cos(phase)])
        self.a = -self.omega**2 * self.q

    def load(self, force: np.ndarray) -> None:
        pass

    def advance(self, force: np.ndarray, dt: float) -> None:
        before = self.q
        self.time += dt
        self.move()
        self.work += float(force @ (self.q - before))


def parse() -> argparse.Namespace:
    parser = command("solid", __doc__)
    motions = parser.add_subparsers(dest="motion", required=True)
    for name, numbers in {"spring": ("mass", "stiffness"), "rigid": ("amplitude", "frequency"), "beam": ("mass", "bending")}.items():
        motion = motions.add_parser(name)
        for number in numbers:
            motion.add_argument(f"--{number}", type=float, required=True, help={
                "mass": "kg per metre of depth; of the beam: m, per square metre", "stiffness": "N/m per metre of depth",
                "bending": "EI per metre of depth [N m]", "amplitude": "m", "frequency": "Hz"}[number])
        if name == "beam":
            motion.add_argument("--modes", type=int, default=9)
        motion.add_argument("--start", type=float, nargs=2, default=[1.0, 0.0], help="m (1 0)")
        motion.add_argument("--end", type=float, nargs=2, default=[0.0, 0.0], help="m (0 0)")
        motion.add_argument("--facets", type=int, default=20)
    add_common(motions.choices.values(), "solid")
    return parser.parse_args()


def make(told: argparse.Namespace, share: np.ndarray, length: float) -> tuple[np.ndarray, Modes | Told]:
    """The shapes [modes, nodes], with what moves them. share: of the length, of each node."""
    if told.motion == "beam":
        n = np.arange(1, told.modes + 1)[:, None] * np.pi
        mass = np.full(told.modes, told.mass * length / 2)
        return np.sin(n * share), Modes(mass, told.bending * (n[:, 0] / length)**4 * length / 2)
    return np.ones((1, len(share))), Modes(told.mass, told.stiffness) if told.motion == "spring" else Told(told.amplitude, told.frequency)


def play(told: argparse.Namespace, me: Participant) -> None:
    if me.impedance_share > 0:
        raise Error(2, 'rivage.fake_solid takes the load as it comes: write coupling.scheme = "parallel" or "serial"')
    share = np.linspace(0, 1, told.facets + 1)
    along = np.subtract(told.end, told.start)
    length = float(np.hypot(*along))
    normal = np.array([-along[1], along[0]]) / length           # into the body
    reference = told.start + share[:, None] * along
    wet = me.solid(2, np.arange(len(share)), reference, [[k, k + 1] for k in range(told.facets)])
    shapes, motion = make(told, share, length)

    def field(q: np.ndarray) -> np.ndarray:
        return (q @ shapes)[:, None] * normal

    tables, middle, dt = SolidTables(me, ["middle.u[m]"]), shapes[:, len(share) // 2], 0.0
    for window in wet.windows():
        force = wet.nodal_force(reference) @ normal      # the direction as at the start
        if me.serial and window.step > 0:
            motion.advance(shapes @ force, dt)
        else:
            motion.load(shapes @ force)
        u = field(motion.q)
        energies = {"work": motion.work, "kinetic": motion.kinetic, "strain": motion.strain}
        wet.send(reference + u, field(motion.v), field(motion.a), force=force.sum() * normal, displacement_max=np.abs(u).max(), **energies)
        tables.write(window, [motion.q @ middle], **energies)
        dt = window.dt
        if not (me.serial or window.last or window.step < 0):
            motion.advance(shapes @ force, dt)
    print(f"rivage.fake_solid: u = {np.abs(u).max():.9e} m at t = {window.time:g} s, work {motion.work:.9e} J/m", flush=True)


if __name__ == "__main__":
    run(parse(), play)
