# SPDX-License-Identifier: MIT
"""Solvers from outside: the C and the C++ example against the installed library, the Python module, what each says when something is wrong.

usage: outside.py --build FOLDER [unittest's arguments]
"""
import os
import re
import subprocess
from pathlib import Path

import numpy as np

from coupled_run import ROOT, run
from outside_test import ARGUMENTS, CASE, OutsideTest, main

C_EXAMPLE = ROOT / "coupler_lib" / "c_api" / "spring_plate.c"
CPP_EXAMPLE = C_EXAMPLE.with_suffix(".cpp")
PLATE = ROOT / "coupler_lib" / "python" / "examples" / "plate"
PYTHON_EXAMPLE = PLATE / "spring_plate.py"
# A constant pressure of 1000 Pa on a metre, m = 100 kg, k = 1e6 N/m: u = -1 mm (1 - cos 100 t), small steps.
SETTINGS = ["fluid.fluid.radiating=false", "fluid.fluid.dt=1e-5", "coupling.time.end=0.03", "coupling.coupling.acceleration=nodal"]
EXACT = -1e-3 * (1 - np.cos(100 * 0.03))
TWO_RUNS = """
import sys, numpy as np, rivage
from mpi4py import MPI
rank, case = MPI.COMM_WORLD.Get_rank(), sys.argv[1]
roles = ("fluid", "solid") if rank == 0 else ("solid", "fluid")   # the other way round in the second run
runs = [rivage.Participant(role, case, world=MPI.COMM_WORLD.Dup()) for role in roles]
sides = [run.fluid(2, 1e5) if run.role == "fluid" else run.solid(2, [0, 1], [[1 + k, 0], [k, 0]], [[0, 1]]) for k, run in enumerate(runs)]
fluid, solid = sides if rank == 0 else sides[::-1]
for window in (rivage.Window(-1, 0, 0), rivage.Window(0, 0, 1e-3, True)):
    corners = None if window.step < 0 else np.tile([[0.0, -3.0]], (fluid.facet_count, 4, 1)) * [[[1], [1], [0], [0]]]
    fluid.send(window, corner_force=corners)
    assert solid.receive() == window
    solid.send(solid.reference, 0 * solid.reference, 0 * solid.reference, work=rank + 1.0)
    report = fluid.receive()
assert solid.force.tolist() == [[0, -3], [0, -3]] and report.work == 2 - rank
assert fluid.position[0, 0] == (1 if rank == 1 else 0) + 1, fluid.position   # the surface of the run in which I am the fluid
for run in runs:
    run.leave()
open(f"{sys.argv[2]}/ended_{rank}", "w").close()      # mpirun may mix what two ranks print
"""


class Outside(OutsideTest):
    def fluid(self, *settings: str) -> list[str]:
        overrides = [word for setting in (*SETTINGS, *settings) for word in ("--set", setting)]
        return ["-n", "1", str(ARGUMENTS.build / "bin" / "fake_fluid"), str(CASE), "--out", str(self.folder / "out"), *overrides]

    def script(self, text: str) -> str:
        path = self.folder / "solver.py"
        path.write_text(text, encoding="utf-8")
        return str(path)

    def assert_swings(self, done: subprocess.CompletedProcess) -> None:
        self.assertEqual(done.returncode, 0, done.stdout)
        found = re.search(r"plate: u = (\S+) m at t = 0.03 s", done.stdout)
        self.assertIsNotNone(found, done.stdout)
        self.assertAlmostEqual(float(found[1]) / EXACT, 1, delta=0.003)

    def installed(self, compiler: str, source: Path) -> str:
        """The example, built against the installed library."""
        prefix, example = self.folder / "prefix", self.folder / compiler.replace("/", "_")
        subprocess.run(["cmake", "--install", str(ARGUMENTS.build), "--prefix", str(prefix), "--component", "coupler"],
                       check=True, stdout=subprocess.DEVNULL)
        package = next(prefix.rglob("rivage.pc")).parent
        flags = subprocess.run(["pkg-config", "--cflags", "--libs", "rivage"], env=os.environ | {"PKG_CONFIG_PATH": str(package)},
                               check=True, capture_output=True, text=True).stdout.split()
        subprocess.run([*compiler.split(), "-Wall", "-Wextra", "-Werror", str(source), *flags, f"-Wl,-rpath,{package.parent}",
                        "-o", str(example)], check=True)
        return str(example)

    def test_the_c_and_the_cpp_example_with_the_installed_library(self) -> None:
        for compiler, source in (("cc -std=c11", C_EXAMPLE), ("c++ -std=c++11", CPP_EXAMPLE)):
            with self.subTest(compiler):
                example = self.installed(compiler, source)
                self.assert_swings(self.mpirun(self.fluid(), ["-n", "1", example, str(CASE), *SETTINGS]))
                wrong = self.mpirun(self.fluid(), ["-n", "1", example, str(CASE), *SETTINGS, "coupling.time.ende=1"])
                self.assertEqual(wrong.returncode, 2, wrong.stdout)
                self.assertIn("did you mean 'end'", wrong.stdout)

    def test_an_exception_in_cpp_ends_all_with_its_message(self) -> None:
        text = CPP_EXAMPLE.read_text(encoding="utf-8")
        for good, bad, code, words in (("double u = 0", 'throw std::runtime_error("the spring is broken"); double u = 0', 3, "the spring is broken"),
                                       ("wet.send({1, u, 0, u}", "wet.send({1, u}", 2, "want an entry for each coordinate")):
            (self.folder / "wrong.cpp").write_text(text.replace(good, bad), encoding="utf-8")
            done = self.mpirun(self.fluid(), ["-n", "1", self.installed("c++ -std=c++11", self.folder / "wrong.cpp"), str(CASE), *SETTINGS])
            self.assertEqual(done.returncode, code, done.stdout)
            self.assertIn(words, done.stdout)
            self.assertEqual(done.stdout.count("rivage: "), 1, done.stdout)

    def test_the_cmake_package(self) -> None:
        prefix, project = self.folder / "prefix", self.folder / "project"
        subprocess.run(["cmake", "--install", str(ARGUMENTS.build), "--prefix", str(prefix), "--component", "coupler"],
                       check=True, stdout=subprocess.DEVNULL)
        project.mkdir()
        (project / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.25)\nproject(own LANGUAGES C)\nfind_package(rivage REQUIRED)\n"
            f"add_executable(own {C_EXAMPLE})\ntarget_link_libraries(own rivage::rivage)\n", encoding="utf-8")
        for line in (["cmake", "-S", str(project), "-B", str(project / "b"), f"-DCMAKE_PREFIX_PATH={prefix}"],
                     ["cmake", "--build", str(project / "b")]):
            subprocess.run(line, check=True, stdout=subprocess.DEVNULL)

    def test_the_page_shows_the_examples(self) -> None:
        page = (ROOT / "docs" / "couple_your_own_solver.md").read_text(encoding="utf-8")
        for example, begin in ((PYTHON_EXAMPLE, "import sys"), (CPP_EXAMPLE, "#include")):
            text = example.read_text(encoding="utf-8")
            self.assertIn(text[text.index(begin):], page)
        self.assertIn((PLATE / "coupling.toml").read_text(encoding="utf-8"), page)

    def test_the_python_example(self) -> None:
        self.assert_swings(self.mpirun(self.fluid(), ["-n", "1", "/usr/bin/python3", str(PYTHON_EXAMPLE), str(CASE), *SETTINGS]))

    def test_the_python_example_as_a_case(self) -> None:
        self.assertEqual(run(PLATE, ARGUMENTS.build / "bin", self.folder / "out"), 0)
        for name, column, wanted in (("solid/probes.csv", 1, EXACT), ("coupling/interface.csv", None, 0.0)):
            rows = [line.split(",") for line in (self.folder / "out" / name).read_text(encoding="utf-8").splitlines() if line[0] != "#"]
            names = [cell.split("[")[0] for cell in rows[0]]
            last = dict(zip(names, map(float, rows[-1])))
            found = last[names[column]] if column else last["work_on_fluid"] + last["work_on_solid"]
            self.assertAlmostEqual(found, wanted, delta=0.003 * abs(EXACT))

    def test_words_of_the_command_line(self) -> None:
        done = self.mpirun(self.fluid(), ["-n", "1", "/usr/bin/python3", str(PYTHON_EXAMPLE), str(CASE), "--as", "solid", "--out", str(self.folder / "o"),
                                          *(word for setting in SETTINGS for word in ("--set", setting))])
        self.assert_swings(done)
        self.assertTrue((self.folder / "o/solid/probes.csv").exists())
        for words, text in ((["--ass", "solid"], "'--ass' is no argument"), (["--as"], "a value is missing after '--as'"), (["end"], "'end' is no argument")):
            done = self.mpirun(self.fluid(), ["-n", "1", "/usr/bin/python3", str(PYTHON_EXAMPLE), str(CASE), *SETTINGS, *words])
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertIn(text, done.stdout)

    def test_a_solver_that_forgets_something(self) -> None:
        text = PYTHON_EXAMPLE.read_text(encoding="utf-8")
        begin = text.index("        wet.send("), text.index("        tables.write(")
        silent = text[:begin[0]] + "        pass\n" + text[begin[1]:]
        bare = text.replace("with rivage.Participant(\"solid\", sys.argv[1], sys.argv[2:]) as me:", "me = rivage.Participant(\"solid\", sys.argv[1], sys.argv[2:])\nif me:")
        early = bare.replace("        a = (force", "        if window.step == 3: sys.exit()\n        a = (force")
        averaged = ['coupling.interface.load="averaged"']
        for script, more, code, words in ((silent, [], 3, "window -1 was not answered"), (bare, [], 0, "plate: u ="), (early, [], 3, "ended before the run did"),
                                          (text, averaged, 3, 'interface.load is "averaged"')):
            with self.subTest(words):
                done = self.mpirun(self.fluid(*more), ["-n", "1", "/usr/bin/python3", self.script(script), str(CASE), *SETTINGS, *more])
                self.assertEqual(done.returncode, code, done.stdout)
                self.assertIn(words, done.stdout)

    def test_an_exception_in_python_ends_all_with_its_message(self) -> None:
        text = PYTHON_EXAMPLE.read_text(encoding="utf-8").replace("a = (force", "1 / (2 - window.step); a = (force")
        done = self.mpirun(self.fluid(), ["-n", "1", "/usr/bin/python3", self.script(text), str(CASE), *SETTINGS])
        self.assertEqual(done.returncode, 3, done.stdout)
        self.assertIn("ZeroDivisionError: division by zero (solver.py, line ", done.stdout)
        self.assertEqual(done.stdout.count("rivage: "), 1, done.stdout)

    def test_leaving_by_sys_exit_ends_all_too(self) -> None:
        text = PYTHON_EXAMPLE.read_text(encoding="utf-8").replace("a = (force", "sys.exit(1) if window.step == 2 else 0; a = (force")
        done = self.mpirun(self.fluid(), ["-n", "1", "/usr/bin/python3", self.script(text), str(CASE), *SETTINGS])
        self.assertEqual(done.returncode, 3, done.stdout)
        self.assertIn("SystemExit: 1", done.stdout)

    def test_wrong_arrays_are_named(self) -> None:
        text = PYTHON_EXAMPLE.read_text(encoding="utf-8")
        for good, bad, words in (("vertical(v), vertical(a),", "vertical(v)[0], vertical(a),", "velocity has the shape (2,)"),
                                 ('"kinetic":', '"kinetik":', "'kinetik' is no field of a report"),
                                 ("vertical(a), **", "vertical(a * np.nan), **", "is not a number")):
            done = self.mpirun(self.fluid(), ["-n", "1", "/usr/bin/python3", self.script(text.replace(good, bad)), str(CASE), *SETTINGS])
            self.assertIn(words, done.stdout)
            self.assertNotEqual(done.returncode, 0)

    def test_a_role_that_nobody_knows(self) -> None:
        text = PYTHON_EXAMPLE.read_text(encoding="utf-8").replace('"solid"', '"soild"')
        done = self.mpirun(self.fluid(), ["-n", "1", "/usr/bin/python3", self.script(text), str(CASE), *SETTINGS])
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertIn("did you mean 'solid'", done.stdout)

    def test_two_runs_in_one_process(self) -> None:
        done = self.mpirun(["-n", "2", "/usr/bin/python3", self.script(TWO_RUNS), str(CASE), str(self.folder)])
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertEqual(sorted(path.name for path in self.folder.glob("ended_*")), ["ended_0", "ended_1"])


if __name__ == "__main__":
    main(__doc__)
