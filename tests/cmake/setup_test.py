"""cmake/setup.sh finds the archive of each release, and says what is wrong with it. Fake apt-get and dpkg install nothing."""

import os
import pathlib
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(os.environ["TERRATACT_SOURCE_DIR"], "cmake/setup.sh")

# Every package is installed, and no suite has a source. sources.list of each attempt goes to the file $SEEN.
TOOLS = {
    "apt-get": """#!/bin/sh
for word; do
  case $word in
    indextargets) cat "$TARGETS"; exit ;;
    Dir::Etc::SourceList=*) list=${word#*=} ;;
    update) cat "$list" >>"$SEEN"; exit 100 ;;
  esac
done
""",
    "dpkg": "#!/bin/sh\necho amd64\n",
    "dpkg-query": """#!/bin/sh
shift 3
for package; do echo "installed $package:amd64"; done
""",
}

BOOKWORM = "ID=debian\nVERSION_CODENAME=bookworm\n"
NOBLE = "ID=ubuntu\nID_LIKE=debian\nVERSION_CODENAME=noble\nUBUNTU_CODENAME=noble\n"
MINT = "ID=linuxmint\nID_LIKE=\"ubuntu debian\"\nVERSION_CODENAME=wilma\nUBUNTU_CODENAME=noble\n"


class Archives(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "bin").mkdir()
        for name, content in TOOLS.items():
            (self.folder / "bin" / name).write_text(content)
            (self.folder / "bin" / name).chmod(0o755)
        (self.folder / "cmake").mkdir()
        script = SCRIPT.read_text().replace("os_release=/etc/os-release", f"os_release={self.folder}/os-release")
        script = script.replace("keyrings=/usr/share/keyrings", f"keyrings={self.folder}/keyrings")
        (self.folder / "cmake/setup.sh").write_text(script)
        (self.folder / "keyrings").mkdir()
        for system in "debian", "ubuntu":
            (self.folder / f"keyrings/{system}-archive-keyring.gpg").touch()

    def run_it(self, release, targets):
        """Returns the entries that it tried, and its last words. targets: what `apt-get indextargets` prints."""
        seen = self.folder / "seen"
        seen.write_text("")
        (self.folder / "os-release").write_text(release)
        (self.folder / "targets").write_text(targets)
        done = subprocess.run(["bash", self.folder / "cmake/setup.sh", "kernel"], capture_output=True, text=True, check=False,
                              env={"PATH": f"{self.folder}/bin:{os.environ['PATH']}", "SEEN": seen,
                                   "TARGETS": self.folder / "targets"})
        self.assertEqual(done.returncode, 1, done.stderr)
        return seen.read_text().splitlines(), done.stderr.splitlines()[-1]

    def entries(self, system, mirror, suites, components):
        return [f"deb-src [signed-by={self.folder}/keyrings/{system}-archive-keyring.gpg] {mirror} {suite} {components}"
                for suite in suites]

    def test_debian_asks_its_own_suite_and_then_newer_ones(self):
        for name, suite in (("bookworm", "bookworm"), ("bookworm", "oldstable"), ("trixie", "stable"), ("sid", "unstable"),
                            ("forky", "testing")):
            tried, words = self.run_it(f"ID=debian\nVERSION_CODENAME={name}\n", f"other http://x/y\n{suite} http://m.test/debian\n")
            suites = [name, "trixie", "forky", "sid"]
            self.assertEqual(tried, self.entries("debian", "http://m.test/debian", suites, "main"))
            self.assertRegex(words, rf"no suite of the mirror \({' '.join(suites)}\) gave a signed source of libgpiod 2")

    def test_ubuntu_and_what_descends_from_it_have_their_own(self):
        for release in NOBLE, MINT:
            tried, _ = self.run_it(release, "noble http://m.test/ubuntu\n")
            self.assertEqual(tried, self.entries("ubuntu", "http://m.test/ubuntu", ["noble", "devel"], "main universe"))

    def test_ubuntus_mirrors_of_other_architectures_hold_no_sources(self):
        tried, _ = self.run_it(NOBLE, "noble http://ports.m.test/ubuntu-ports\n")
        self.assertEqual(tried[0].split()[2], "http://archive.m.test/ubuntu")

    def test_a_missing_mirror_or_key_is_named(self):
        self.assertIn("found no mirror of debian bookworm", self.run_it(BOOKWORM, "")[1])
        (self.folder / "keyrings/ubuntu-archive-keyring.gpg").unlink()
        self.assertIn("install ubuntu-archive-keyring", self.run_it(NOBLE, "noble http://m.test/ubuntu\n")[1])


if __name__ == "__main__":
    unittest.main()
