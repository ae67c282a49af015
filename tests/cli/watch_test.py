"""`vesica run --watch`: the report of a run that goes on, for reading only, on this machine only, without changing a bit."""

import http.client
import json
import os
import socket
import struct
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
PROGRAM = Path(os.environ.get("VESICA_PROGRAM", SOURCE / "build/release/bin/vesica"))
PAGE = PROGRAM.parent.parent / "share/vesica/report.html"

CASE = """title = "watched"
[lattice]
size = [32, 32, 32]
[fluid]
kinematic_viscosity = 0.1666667
[vesicle_type.rbc]
[vesicle_type.rbc.bending]
modulus = 0.25
[[vesicle]]
type = "rbc"
shape = "sphere"
centre = [16, 16, 16]
radius = 8
[run]
steps = 100000
[output]
metrics = { every = 10 }
surfaces = { every = 20 }
"""


@unittest.skipUnless(PAGE.is_file(), "this build has no page of the report")
class Watch(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="vesica-watch-")
        self.addCleanup(scratch.cleanup)
        self.directory = Path(scratch.name)
        (self.directory / "case.toml").write_text(CASE)

    def start(self, *options):
        """A run that is watched, and its port."""
        run = subprocess.Popen([PROGRAM, "run", "case.toml", "-o", "run", "--threads", "1", *options], cwd=self.directory,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

        def end():
            run.kill()
            run.communicate()

        self.addCleanup(end)
        words = run.stdout.readline()
        self.assertRegex(words, r"^watch it at http://127\.0\.0\.1:\d+/$")
        return run, int(words.rsplit(":", 1)[1].strip(" /\n"))

    def ask(self, port, path, method="GET", **headers):
        connection = http.client.HTTPConnection("127.0.0.1", port, timeout=60)
        self.addCleanup(connection.close)
        connection.request(method, path, headers=headers)
        answer = connection.getresponse()
        return answer.status, answer.read(), dict(answer.getheaders())

    def until(self, condition):
        end = time.monotonic() + 120
        while not (found := condition()):
            self.assertLess(time.monotonic(), end)
            time.sleep(0.1)
        return found

    def test_the_page_and_its_data_are_there_while_the_run_goes_on_and_end_with_it(self):
        run, port = self.start("--watch", "0")
        status, page, headers = self.ask(port, "/")
        self.assertEqual((status, headers["X-Content-Type-Options"]), (200, "nosniff"))
        self.assertIn(b'id="vesica-manifest"', page)

        def manifest():
            status, text, _ = self.ask(port, "/manifest")
            self.assertEqual(status, 200)
            return json.loads(text)

        first = self.until(lambda: (now := manifest())["metrics"]["rows"] > 0 and now["frames"] and now)
        self.assertEqual((first["live"], first["state"], first["title"]), (True, "running", "watched"))
        self.assertIn("reduced volume", first["plan"])
        self.until(lambda: len(manifest()["frames"]) > len(first["frames"]))
        status, frame, _ = self.ask(port, f"/frame/{first['frames'][-1]['step']}")
        self.assertEqual(status, 200)
        header = json.loads(frame[4:4 + struct.unpack("<I", frame[:4])[0]])
        self.assertEqual(header["step"], first["frames"][-1]["step"])
        self.assertEqual(len(header["spreads"]), len(first["quantities"]))

        # It is for reading what is the run's, by this machine's own pages.
        for path in ("/frame/7", "/frame/99999999999999999999999", "/frame/../../case.toml", "/../run/case.toml", "/case.toml"):
            self.assertEqual(self.ask(port, path)[0], 404, path)
        for method in ("POST", "PUT", "DELETE"):
            self.assertEqual(self.ask(port, "/manifest", method)[0], 405, method)
        # What somebody sends is not even read.
        with socket.create_connection(("127.0.0.1", port), timeout=60) as sender:
            sender.sendall(b"POST / HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 1000000000000\r\n\r\n")
            self.assertIn(b" 405 ", sender.recv(4096))
        for host in ("elsewhere.example", "127.elsewhere.example", "127.0.0.1.elsewhere.example", "128.0.0.1"):
            self.assertEqual(self.ask(port, "/manifest", Host=host)[0], 403, host)
        self.assertEqual(self.ask(port, "/manifest", Host=f"localhost:{port}")[0], 200)
        own = {info[4][0] for info in socket.getaddrinfo(socket.gethostname(), None, socket.AF_INET)} - {"127.0.0.1"}
        for address in own:
            with self.assertRaises(OSError):
                socket.create_connection((address, port), timeout=5).close()

        # A second run cannot have the port, and leaves nothing behind.
        other = subprocess.run([PROGRAM, "run", "case.toml", "-o", "other", "--watch", str(port)], cwd=self.directory,
                               capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual(other.returncode, 1)
        self.assertIn(f"127.0.0.1 port {port} cannot be listened to: it is in use", other.stderr)
        self.assertFalse((self.directory / "other").exists())

        # The end of the run reaches who has watched, and then there is nobody to ask.
        run.terminate()
        self.until(lambda: manifest()["state"] == "stopped" if run.poll() is None else True)
        self.assertEqual(run.wait(60), 3)
        with self.assertRaises(OSError):
            self.ask(port, "/")

    def test_a_watched_run_leaves_the_same_bits(self):
        steps = ("--steps", "60")
        run, port = self.start("--watch", "0", *steps)
        try:
            while run.poll() is None:
                self.ask(port, "/manifest")
                self.ask(port, "/frame/20")
        except OSError:
            pass  # the run has ended
        self.assertEqual(run.wait(60), 0)
        subprocess.run([PROGRAM, "run", "case.toml", "-o", "alone", "--threads", "1", *steps], cwd=self.directory, check=True,
                       capture_output=True, timeout=300)
        for name in ("metrics.csv", "surfaces/surface_000000060.vtp"):
            self.assertEqual((self.directory / "run" / name).read_bytes(), (self.directory / "alone" / name).read_bytes(), name)

    def test_what_cannot_be_served_is_refused_before_the_run(self):
        for options, status, words in (
                (["--watch", "99999"], 2, "--watch is 99999; expected a port"), (["--watch", ""], 2, "--watch is empty"),
                (["--watch-address", "0.0.0.0"], 2, "--watch-address is 0.0.0.0, but nothing is to be served"),
                (["--watch", "0", "--watch-address", "203.0.113.7"], 1, "203.0.113.7 port 0 cannot be listened to")):
            done = subprocess.run([PROGRAM, "run", "case.toml", "-o", "none", *options], cwd=self.directory, capture_output=True,
                                  text=True, timeout=60, check=False)
            self.assertEqual(done.returncode, status, done.stderr)
            self.assertIn(words, done.stderr)
        self.assertFalse((self.directory / "none").exists())


if __name__ == "__main__":
    unittest.main()
