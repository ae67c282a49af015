"""The comparison with Palabos holds like beside like, and refuses a peer that computed something else."""

import argparse
import importlib.util
import json
import unittest
from importlib.machinery import SourceFileLoader
from pathlib import Path
from unittest import mock

SCRIPT = Path(__file__).resolve().parents[2] / "benchmarks" / "compare-with-peers"
loader = SourceFileLoader("compare_with_peers", str(SCRIPT))
script = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
loader.exec_module(script)

FLUID = {"peer": "palabos", "case": "fluid", "collision": "bgk", "precision": "double", "edge": 64, "ranks": 2,
         "mlups": 5.0, "decay_over_theory": 1.001}
DROP = {"peer": "palabos", "case": "shan_chen", "collision": "bgk", "precision": "double", "edge": 64, "ranks": 2,
        "mlups": 1.0, "red_in_the_middle": 1.03, "blue_in_the_middle": 0.06, "mass_over_initial": 1.0}


def options(**changes) -> argparse.Namespace:
    given = {"size": 64, "threads": 2, "seconds": 1.0, "repetitions": 1, "statistic": "best", "precisions": ["double"],
             "vesica": Path("vesica"), **changes}
    return argparse.Namespace(**given)


def answer(command: list[str]) -> str:
    """Answer as the programs do: Vesica's bench, or the peer the command line names."""
    if "bench" in command:
        chosen = [command[k + 1] for k, word in enumerate(command) if word == "--case"]
        assert chosen == ["fluid", "mrt", "discocyte"], command
        return json.dumps({"cases": [
            {"name": name, "precision": precision, "mlups": mlups}
            for name, mlups in (("fluid", 40.0), ("mrt", 30.0), ("discocyte", 20.0)) for precision in ("double", "single")
        ]})
    collision = command[command.index("--collision") + 1]
    line = FLUID if any("palabos_fluid" in word for word in command) else DROP
    return json.dumps({**line, "collision": collision})


class CompareWithPeers(unittest.TestCase):
    def test_a_ratio_is_ours_over_theirs_in_the_same_precision(self):
        rates = {("vesica", "fluid", "double"): [40.0], ("vesica", "fluid", "single"): [80.0],
                 ("palabos_fluid", "bgk", "double"): [5.0], ("palabos_fluid", "bgk", "single"): [8.0]}
        rows = script.compare(rates, "best")
        self.assertEqual([(row["precision"], row["ratio"]) for row in rows], [("double", 8.0), ("single", 10.0)])

    def test_best_is_the_fastest_and_median_the_middle_of_the_repetitions(self):
        rates = {("vesica", "fluid", "double"): [30.0, 40.0, 38.0], ("palabos_fluid", "bgk", "double"): [1.0, 2.0, 4.0]}
        self.assertEqual(script.compare(rates, "best")[0]["ratio"], 10.0)
        self.assertEqual(script.compare(rates, "median")[0]["ratio"], 19.0)

    def test_the_membrane_stands_beside_the_drop_and_the_fluid_beside_the_fluid(self):
        peers = [peer for pair in script.PAIRS.values() for peer in pair["peers"]]
        with mock.patch.object(script, "run", side_effect=answer), mock.patch.object(script, "say"):
            rows = script.compare(script.measure(options(repetitions=2), peers), "best")
        ratios = {(row["case"], row["peer"], row["collision"] == "mrt"): row["ratio"] for row in rows}
        self.assertEqual(ratios, {("fluid", "palabos_fluid", False): 8.0, ("mrt", "palabos_fluid", True): 6.0,
                                  ("discocyte", "palabos_shan_chen", False): 20.0})
        self.assertTrue(all(len(row["peer_all"]) == len(row["vesica_all"]) == 2 for row in rows))

    def test_the_table_has_a_line_per_rate(self):
        rates = {("vesica", "discocyte", "single"): [20.0], ("palabos_shan_chen", "bgk", "single"): [1.25]}
        text = script.table(script.compare(rates, "best"), options())
        self.assertIn("shan-chen, bgk", text)
        self.assertRegex(text, r"single +1\.25 +20\.00 +16\.00")
        self.assertNotIn("fluid:", text)

    def test_a_shear_wave_that_decays_wrongly_is_refused(self):
        script.check_peer(FLUID)
        with self.assertRaisesRegex(SystemExit, "decays 1.2 times"):
            script.check_peer({**FLUID, "decay_over_theory": 1.2})
        with self.assertRaisesRegex(SystemExit, "decays"):
            script.check_peer({**FLUID, "decay_over_theory": float("nan")})

    def test_a_drop_that_is_gone_or_grew_is_refused(self):
        script.check_peer(DROP)
        with self.assertRaisesRegex(SystemExit, "the drop is gone"):
            script.check_peer({**DROP, "red_in_the_middle": 0.05})
        with self.assertRaisesRegex(SystemExit, "1.5 times the mass"):
            script.check_peer({**DROP, "mass_over_initial": 1.5})

    def test_a_peer_that_ran_another_size_or_number_of_ranks_is_refused(self):
        with mock.patch.object(script, "run", side_effect=answer):
            with self.assertRaisesRegex(SystemExit, "asked for 32"):
                script.measure_peer("palabos_fluid", "bgk", "double", options(size=32))
            with self.assertRaisesRegex(SystemExit, "on 2 ranks"):
                script.measure_peer("palabos_fluid", "bgk", "double", options(threads=1))

    def test_ranks_have_a_core_each_while_there_are_enough(self):
        self.assertIn("core", script.mpi_command(2, 2))
        self.assertNotIn("--oversubscribe", script.mpi_command(2, 2))
        self.assertIn("--oversubscribe", script.mpi_command(4, 2))

    def test_a_program_that_fails_says_so(self):
        with self.assertRaisesRegex(SystemExit, "status 3\nno luck"):
            script.run(["sh", "-c", "echo no luck >&2; exit 3"])


if __name__ == "__main__":
    unittest.main()
