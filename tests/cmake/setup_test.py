"""cmake/setup.sh finds the archive of each release, takes a signed source from it, and says what is wrong.

Fake apt-get and dpkg install nothing. Where a source is taken, apt reads an archive in a folder of the test.
"""

import hashlib
import io
import os
import pathlib
import shutil
import subprocess
import tarfile
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


# Every package but Qwt is installed, and apt finds no package of Qwt. The fake make installs VERSION.
SOURCE_TOOLS = {
    "apt-get": f"""#!/bin/sh
case $* in
  *indextargets*) cat "$TARGETS" ;;
  *) exec {shutil.which("apt-get")} "$@" ;;
esac
""",
    "apt-cache": "#!/bin/sh\n",
    "dpkg-query": """#!/bin/sh
shift 3
for package; do [ "$package" = libqwt-qt6-dev ] || echo "installed $package:amd64"; done
""",
    "qmake6": "#!/bin/sh\n",
    "make": """#!/bin/sh
[ "$1" = install ] || exit 0
prefix=$(sed -n 's/^ *QWT_INSTALL_PREFIX *= //p' qwtconfig.pri)
mkdir -p "$prefix"
cp VERSION "$prefix"
""",
}
CONFIG = "QWT_INSTALL_PREFIX = /usr\nQWT_CONFIG += QwtPlot\nQWT_CONFIG += QwtDll\n"


class SetUp(unittest.TestCase):
    tools = TOOLS

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "bin").mkdir()
        for name, content in self.tools.items():
            (self.folder / "bin" / name).write_text(content)
            (self.folder / "bin" / name).chmod(0o755)
        (self.folder / "cmake").mkdir()
        script = SCRIPT.read_text().replace("os_release=/etc/os-release", f"os_release={self.folder}/os-release")
        script = script.replace("keyrings=/usr/share/keyrings", f"keyrings={self.folder}/keyrings")
        (self.folder / "cmake/setup.sh").write_text(script)
        (self.folder / "keyrings").mkdir()
        for system in "debian", "ubuntu":
            (self.folder / f"keyrings/{system}-archive-keyring.gpg").touch()

    def set_up(self, group, release, targets):
        """Runs the script. targets: what `apt-get indextargets` prints."""
        (self.folder / "os-release").write_text(release)
        (self.folder / "targets").write_text(targets)
        return subprocess.run(["bash", self.folder / "cmake/setup.sh", group], capture_output=True, text=True, check=False,
                              env={"PATH": f"{self.folder}/bin:{os.environ['PATH']}", "SEEN": self.folder / "seen",
                                   "TARGETS": self.folder / "targets"})


class Archives(SetUp):
    def run_it(self, release, targets):
        """Returns the entries that it tried, and its last words."""
        seen = self.folder / "seen"
        seen.write_text("")
        done = self.set_up("kernel", release, targets)
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

    def test_ubuntu_and_its_descendants_have_their_own(self):
        for release in NOBLE, MINT:
            tried, _ = self.run_it(release, "noble http://m.test/ubuntu\n")
            self.assertEqual(tried, self.entries("ubuntu", "http://m.test/ubuntu", ["noble", "devel"], "main universe"))

    def test_ubuntus_ports_mirrors_hold_no_sources(self):
        tried, _ = self.run_it(NOBLE, "noble http://ports.m.test/ubuntu-ports\n")
        self.assertEqual(tried[0].split()[2], "http://archive.m.test/ubuntu")

    def test_a_missing_mirror_or_key_is_named(self):
        self.assertIn("found no mirror of debian bookworm", self.run_it(BOOKWORM, "")[1])
        (self.folder / "keyrings/ubuntu-archive-keyring.gpg").unlink()
        words = self.run_it(NOBLE, "noble http://m.test/ubuntu\n")[1]
        self.assertTrue(words.endswith("install ubuntu-keyring"), words)
        (self.folder / "keyrings/debian-archive-keyring.gpg").unlink()
        words = self.run_it(BOOKWORM, "bookworm http://m.test/debian\n")[1]
        self.assertTrue(words.endswith("install debian-archive-keyring"), words)


def tarball(version, config):
    """Returns a source of Qwt."""
    content = io.BytesIO()
    with tarfile.open(fileobj=content, mode="w:gz") as tar:
        for name, text in ("qwtconfig.pri", config), ("VERSION", version):
            member = tarfile.TarInfo(f"qwt-{version}/{name}")
            member.size = len(text)
            tar.addfile(member, io.BytesIO(text.encode()))
    return content.getvalue()


def sum_of(data):
    return f"{hashlib.sha256(data).hexdigest()} {len(data)}"


@unittest.skipUnless(shutil.which("apt-get") and shutil.which("gpg"), "apt or gpg is missing")
class Sources(SetUp):
    tools = SOURCE_TOOLS

    @classmethod
    def setUpClass(cls):
        home = tempfile.TemporaryDirectory()
        cls.addClassCleanup(home.cleanup)
        cls.home = home.name
        cls.addClassCleanup(subprocess.run, ["gpgconf", "--homedir", cls.home, "--kill", "all"], check=False)
        for name in "archive", "stranger":
            cls.gpg("--passphrase", "", "--quick-gen-key", f"{name}@m.test", "ed25519", "sign", "never")

    @classmethod
    def gpg(cls, *arguments, data=b""):
        return subprocess.run(["gpg", "--homedir", cls.home, "--batch", "--quiet", *arguments], input=data, check=True,
                              capture_output=True).stdout

    def setUp(self):
        super().setUp()
        (self.folder / "keyrings/debian-archive-keyring.gpg").write_bytes(self.gpg("--export", "archive@m.test"))

    def release(self, suite, version, config=CONFIG, signer="archive"):
        """Puts a release of the source into a suite of the archive. Returns the source's place."""
        pool, folder = self.folder / "debian/pool" / suite, self.folder / "debian/dists" / suite
        pool.mkdir(parents=True)
        (folder / "main/source").mkdir(parents=True)
        source = pool / f"qwt_{version}.orig.tar.gz"
        source.write_bytes(tarball(version, config))
        index = (f"Package: qwt\nBinary: libqwt-dev\nVersion: {version}-1\nFormat: 3.0 (quilt)\nDirectory: pool/{suite}\n"
                 f"Checksums-Sha256:\n {sum_of(source.read_bytes())} {source.name}\n").encode()
        (folder / "main/source/Sources").write_bytes(index)
        text = (f"Suite: {suite}\nCodename: {suite}\nDate: Thu, 01 Jan 2026 00:00:00 UTC\nComponents: main\n"
                f"SHA256:\n {sum_of(index)} main/source/Sources\n")
        (folder / "InRelease").write_bytes(self.gpg("--local-user", f"{signer}@m.test", "--clear-sign", data=text.encode()))
        return source

    def built(self):
        """Returns the version of Qwt that it has built, and its last words."""
        done = self.set_up("gui", BOOKWORM, f"bookworm file://{self.folder}/debian\n")
        version = self.folder / ".deps/qwt/VERSION"
        self.assertEqual(done.returncode == 0, version.exists(), done.stderr)
        self.assertEqual(version.exists(), (self.folder / ".deps/qwt/complete").exists())
        return version.read_text() if version.exists() else None, done.stderr

    def assert_refused(self):
        version, words = self.built()
        self.assertIsNone(version)
        self.assertRegex(words, r"^set-up: no suite of the mirror \(bookworm trixie forky sid\) gave a signed source of qwt 6, "
                                r"6\.2 or newer \(see \.deps/setup\.log\)\n$")
        self.assertEqual(sorted(os.listdir(self.folder / ".deps")), ["lock", "setup.log"])

    def test_a_source_of_another_signer_is_refused(self):
        self.release("trixie", "6.3.0", signer="stranger")
        self.assert_refused()

    def test_a_source_with_another_checksum_is_refused(self):
        self.release("trixie", "6.3.0").write_bytes(tarball("6.3.0", CONFIG + "# changed\n"))
        self.assert_refused()

    def test_older_and_next_major_versions_are_refused(self):
        self.release("bookworm", "6.1.4")
        self.release("trixie", "7.0.0")
        self.assert_refused()

    def test_takes_the_next_suite_where_a_source_is_gone(self):
        self.release("trixie", "6.2.0").unlink()
        self.release("forky", "6.4.1")
        self.assertEqual(self.built(), ("6.4.1", ""))

    def test_an_unknown_layout_is_not_installed(self):
        self.release("trixie", "6.9.0", config="prefix = /usr\n")
        version, words = self.built()
        self.assertIsNone(version)
        self.assertIn("so build_qwt in cmake/setup.sh must be adapted", words)


if __name__ == "__main__":
    unittest.main()
