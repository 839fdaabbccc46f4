"""Tests the Debian package made by cpack: contents, dependencies and desktop files. Both programs must run from where
it is unpacked, with the packaged files only. Arguments: cpack, the build folder. cmake/package_check.sh tests the
installation on a clean system."""

import configparser
import gzip
import os
import pathlib
import re
import shutil
import sqlite3
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml

from support import CLI, SOURCE

CPACK, BUILD = sys.argv[1:]
sys.argv[1:] = []
DESKTOP = pathlib.Path(SOURCE, "resources/desktop")
ID = "org.terratact.console"
MIME = "{http://www.freedesktop.org/standards/shared-mime-info}"
STATUS = pathlib.Path("/var/lib/dpkg/status")
MISSING = [tool for tool in ("dpkg-deb", "dpkg-query", "dpkg-shlibdeps", "file", "gzip", "ldd") if not shutil.which(tool)]
MISSING += [] if STATUS.exists() else [str(STATUS)]
MISSING += [] if os.path.exists(CPACK) else ["cpack"]


def output(*command, code=0, **options):
    done = subprocess.run([*map(str, command)], capture_output=True, text=True, timeout=300, check=False, **options)
    assert done.returncode == code, f"{command}: exit {done.returncode}\n{done.stdout}\n{done.stderr}"
    return done.stdout + done.stderr


def entry():
    parser = configparser.ConfigParser(interpolation=None)
    parser.optionxform = str
    parser.read(DESKTOP / f"{ID}.desktop")
    return parser["Desktop Entry"]


class Debian:
    """This system's packages from dpkg: dependencies and owners of files. Needs no network."""

    def __init__(self):
        self.depends, self.providers = {}, {}
        for paragraph in STATUS.read_text(encoding="utf-8").split("\n\n"):
            fields = dict(re.findall(r"^([A-Z][A-Za-z-]*): (.*)$", paragraph, re.MULTILINE))
            if not fields.get("Status", "").endswith(" installed"):
                continue
            name = fields["Package"]
            self.depends[name] = ",".join(fields[key] for key in ("Depends", "Pre-Depends") if key in fields)
            for provided in [name, *self.names(fields.get("Provides", ""))]:
                self.providers.setdefault(provided, []).append(name)

    @staticmethod
    def names(field):
        return [re.match(r"[a-z0-9][a-z0-9.+-]*", part.strip()).group() for part in re.split("[,|]", field) if part.strip()]

    def closure(self, depends):
        """Returns the packages that a Depends field requires; of alternatives, the first installed one."""
        found, fields = set(), [depends]
        while fields:
            for group in filter(str.strip, fields.pop().split(",")):
                here = [package for name in self.names(group) for package in self.providers.get(name, [])]
                assert here, f"{group.strip()} is not installed here: nothing can be said of what it brings"
                if here[0] not in found:
                    found.add(here[0])
                    fields.append(self.depends[here[0]])
        return found

    def strangers(self, files, depends):
        """Returns file -> owner for files, and libraries they need, that no package of the closure contains."""
        closure, owners = self.closure(depends), self.owners(files)
        return {file: owners.get(file) for file in files if owners.get(file) not in closure}

    @staticmethod
    def owners(files):
        """Returns the package of each file, also under old names: Debian moved /lib below /usr."""
        names = {name: file for file in files for real in [os.path.realpath(file)] for name in (real, real.removeprefix("/usr"))}
        said = subprocess.run(["dpkg-query", "-S", *names], capture_output=True, text=True, timeout=60, check=False).stdout
        found = re.findall(r"^([a-z0-9.+-]+)(?::\w+)?(?:, .*)?: (/.*)$", said, re.MULTILINE)
        return {names[name]: package for package, name in found}


def libraries(*files):
    """Returns all libraries that the loader loads for these programs and plugins; the loader itself has no arrow."""
    told = "".join(output("ldd", file) for file in files)
    assert "not found" not in told, told
    return set(re.findall(r"=> (/\S+)", told))


class Desktop(unittest.TestCase):
    @unittest.skipUnless(shutil.which("desktop-file-validate"), "desktop-file-utils is not installed")
    def test_the_entry_is_valid(self):
        self.assertEqual(output("desktop-file-validate", DESKTOP / f"{ID}.desktop"), "")

    @unittest.skipUnless(shutil.which("appstreamcli"), "appstream is not installed")
    def test_the_metainfo_is_valid(self):
        self.assertIn("successful", output("appstreamcli", "validate", "--no-net", "--pedantic", DESKTOP / f"{ID}.metainfo.xml"))

    def test_program_type_and_icon_agree(self):
        metainfo = xml.parse(DESKTOP / f"{ID}.metainfo.xml")
        mimes = xml.parse(DESKTOP / f"{ID}.mime.xml").findall(f"{MIME}mime-type")
        types = [mime.get("type") for mime in mimes]
        self.assertEqual(len(types), 2)
        self.assertEqual(metainfo.findtext("id"), ID)
        self.assertEqual(metainfo.findtext("launchable"), f"{ID}.desktop")
        self.assertEqual(entry()["MimeType"], "".join(f"{kind};" for kind in types))
        self.assertEqual([node.text for node in metainfo.findall("provides/mediatype")], types)
        self.assertEqual(entry()["Exec"], metainfo.findtext("provides/binary") + " --errors-in-window %f")
        self.assertEqual({ID}, {entry()["Icon"], metainfo.findtext("icon"),
                                *(mime.find(f"{MIME}icon").get("name") for mime in mimes)})
        self.assertTrue(xml.parse(DESKTOP / f"{ID}.svg").getroot().tag.endswith("svg"))

    def test_a_file_is_known_by_its_content(self):
        for mime, magic in zip(xml.parse(DESKTOP / f"{ID}.mime.xml").findall(f"{MIME}mime-type"), (b"TTS1", b"TTT1"), strict=True):
            match = mime.find(f"{MIME}magic/{MIME}match")
            inner = match.find(f"{MIME}match")
            with tempfile.NamedTemporaryFile() as file:
                with sqlite3.connect(file.name) as base:
                    base.execute(f"PRAGMA application_id = 0x{magic.hex()}")
                    base.execute("CREATE TABLE something (x)")
                head = pathlib.Path(file.name).read_bytes()[:100]
            self.assertEqual((match.get("type"), inner.get("type")), ("string", "big32"))
            for rule, value in ((match, match.get("value").encode()), (inner, int(inner.get("value"), 0).to_bytes(4, "big"))):
                offset = int(rule.get("offset"))
                self.assertEqual(head[offset:offset + len(value)], value)
            self.assertEqual(int(inner.get("value"), 0).to_bytes(4, "big"), magic)

    def test_the_version_is_the_programs(self):
        version = output(CLI, "--version").split()[1]
        self.assertEqual(xml.parse(DESKTOP / f"{ID}.metainfo.xml").find("releases/release").get("version"), version)
        self.assertTrue((DESKTOP / "changelog").read_text().startswith(f"terratact ({version}) "))


@unittest.skipUnless(shutil.which("git"), "git is not installed")
class Version(unittest.TestCase):
    """cmake/version.sh in a repository of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        (self.root / "cmake").mkdir()
        shutil.copy(pathlib.Path(SOURCE, "cmake/version.sh"), self.root / "cmake")
        self.project("0.2.0")

    def project(self, version):
        (self.root / "CMakeLists.txt").write_text(f"project(Terratact VERSION {version} LANGUAGES CXX)\n")

    def git(self, *arguments):
        output("git", "-C", self.root, "-c", "user.name=x", "-c", "user.email=x@y", "-c", "commit.gpgsign=false",
               "-c", "tag.gpgsign=false", *arguments)

    def version(self, code=0):
        return output(self.root / "cmake/version.sh", code=code).strip()

    def test_it_is_the_projects_without_git_or_tag(self):
        self.assertEqual(self.version(), "0.2.0")
        self.git("init", "-q")
        self.git("commit", "-q", "--allow-empty", "-m", "x")
        self.assertEqual(self.version(), "0.2.0")

    def test_it_counts_commits_from_the_tag(self):
        self.git("init", "-q")
        self.git("commit", "-q", "--allow-empty", "-m", "x")
        self.git("tag", "-a", "v0.2.0", "-m", "x")
        self.assertEqual(self.version(), "0.2.0")
        self.git("commit", "-q", "--allow-empty", "-m", "x")
        self.assertRegex(self.version(), r"^0\.2\.0\+1\.g[0-9a-f]+$")
        self.project("0.3.0")
        self.assertRegex(self.version(), r"^0\.3\.0~1\.g[0-9a-f]+$")

    def test_a_tag_of_another_version_is_refused(self):
        self.git("init", "-q")
        self.git("commit", "-q", "--allow-empty", "-m", "x")
        self.git("tag", "-a", "v0.9.0", "-m", "x")
        self.assertIn("the tag is v0.9.0, but CMakeLists.txt says 0.2.0", self.version(code=1))


@unittest.skipUnless(shutil.which("dpkg-deb"), "dpkg is not installed")
class Repository(unittest.TestCase):
    """What cmake/apt_repository.sh refuses. cmake/apt_repository_check.sh tests what it makes on a clean system."""

    def refused(self, version, keys):
        with tempfile.TemporaryDirectory() as folder:
            control = pathlib.Path(folder, "files/DEBIAN/control")
            control.parent.mkdir(parents=True)
            control.write_text(f"Package: terratact\nVersion: {version}\nArchitecture: all\nMaintainer: x <x@y.invalid>\n"
                               "Description: x\n")
            output("dpkg-deb", "-b", f"{folder}/files", f"{folder}/x.deb")
            told = output(pathlib.Path(SOURCE, "cmake/apt_repository.sh"), f"{folder}/{keys}", f"{folder}/served",
                          f"{folder}/x.deb", code=1)
            self.assertFalse(pathlib.Path(folder, "served").exists())
            return told

    def test_a_package_of_no_known_release_is_refused(self):
        self.assertIn("expected one that ends in ~deb12 or ~deb13", self.refused("0.2.0", "keys"))

    def test_a_key_that_would_be_served_is_refused(self):
        self.assertIn("the key would be served", self.refused("0.2.0~deb12", "served/keys"))


@unittest.skipIf(MISSING, f"not installed: {', '.join(MISSING)}")
class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.root = pathlib.Path(cls.folder.name, "root")
        output(CPACK, "--config", f"{BUILD}/CPackConfig.cmake", "-G", "DEB", "-B", cls.folder.name)
        cls.package, = pathlib.Path(cls.folder.name).glob("terratact_*.deb")
        output("dpkg-deb", "-x", cls.package, cls.root)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def files(self):
        return {str(path.relative_to(self.root)) for path in self.root.rglob("*") if path.is_file()}

    def run_installed(self, program, *arguments, code=0):
        clean = {"PATH": "/usr/bin:/bin", "HOME": self.folder.name, "LC_ALL": "C.UTF-8", "QT_QPA_PLATFORM": "offscreen"}
        return output(self.root / "usr/bin" / program, *arguments, code=code, env=clean, cwd=self.folder.name)

    def test_files_are_in_debians_places(self):
        share = "usr/share"
        self.assertLessEqual(
            {"usr/bin/terratact", "usr/bin/terratact-console",
             f"{share}/man/man1/terratact.1.gz", f"{share}/man/man1/terratact-console.1.gz",
             f"{share}/bash-completion/completions/terratact", f"{share}/bash-completion/completions/terratact-console",
             f"{share}/applications/{ID}.desktop", f"{share}/metainfo/{ID}.metainfo.xml", f"{share}/mime/packages/{ID}.xml",
             f"{share}/icons/hicolor/scalable/apps/{ID}.svg",
             f"{share}/doc/terratact/copyright", f"{share}/doc/terratact/changelog.gz", f"{share}/doc/terratact/can_demo.log"},
            self.files())
        shipped = {path.split("terratact/", 1)[1] for path in self.files() if path.startswith(f"{share}/terratact/")}
        self.assertEqual(shipped, {"models/default.ttm", "models/default.card.toml", "models/default.presets.csv", "models/default.ttn",
                                   "models/one_plane.ttm",
                                   "robots/absolem.toml", "sessions/demo.tts", "sessions/feel_forward.tts",
                                   "sessions/two_tracks.tts", "dbc/terratact.dbc", "panels/example.toml", "mappings/ctu_absolem.toml",
                                   "mappings/simulated_robot.toml", "mappings/terratact.toml",
                                   "mappings/terratact_signals.toml"})
        for line in output("dpkg-deb", "-c", self.package).splitlines():
            self.assertRegex(line, r"^(drwxr-xr-x|-rwxr-xr-x|-rw-r--r--) root/root ")

    def field(self, name):
        return output("dpkg-deb", "-f", self.package, name).strip()

    def test_the_version_names_the_release(self):
        system = dict(re.findall(r'^(\w+)="?([^"\n]*)', pathlib.Path("/etc/os-release").read_text(), re.MULTILINE))
        suffix = "~" + system["ID"].replace("debian", "deb") + system.get("VERSION_ID", "")
        program = output(CLI, "--version").split()[1]
        self.assertRegex(self.field("Version"), rf"^{re.escape(program)}([+~]\d+\.g[0-9a-f]+)?{re.escape(suffix)}$")
        self.assertEqual(self.package.name, f"terratact_{self.field('Version')}_{self.field('Architecture')}.deb")

    def test_homepage_and_maintainer_are_named(self):
        installed = self.root / f"usr/share/metainfo/{ID}.metainfo.xml"
        self.assertRegex(self.field("Homepage"), r"^https://\S+$")
        self.assertEqual(xml.parse(installed).findtext("url[@type='homepage']"), self.field("Homepage"))
        self.assertRegex(self.field("Maintainer"), r"^\S.* <\S+@\S+>$")

    def test_no_link_in_the_documents_is_dead(self):
        folder = self.root / "usr/share/doc/terratact"
        links = [(document.name, link) for document in folder.rglob("*.md")
                 for link in re.findall(r"\]\(([^)\s#]+)(?:#[^)]*)?\)", document.read_text())
                 if not re.match(r"[a-z]+:", link)]
        self.assertGreater(len(links), 30)
        self.assertEqual([(name, link) for name, link in links if not (folder / link).exists()], [])

    def test_it_depends_on_linked_and_loaded_libraries(self):
        depends = output("dpkg-deb", "-f", self.package, "Depends")
        for needed in ("libc6 (>=", "libqt6gui6", "libqt6widgets6", "libcairo2", "libopenblas0", "libsqlite3-0", "libsdl2-2.0-0",
                       "fonts-dejavu-core"):
            self.assertIn(needed, depends)
        recommends = output("dpkg-deb", "-f", self.package, "Recommends")
        self.assertIn("qt6-wayland", recommends)
        self.assertIn("qt6-translations-l10n", recommends)
        self.assertIn("pipewire-alsa | libasound2-plugins", recommends)

    def programs(self):
        return [path for path in self.root.rglob("*")
                if path.is_file() and not path.is_symlink() and path.read_bytes()[:4] == b"\x7fELF"]

    def needed(self, *files):
        """Returns the needed files that other packages must provide."""
        return {file for file in libraries(*files) if not pathlib.Path(file).is_relative_to(self.root)}

    def test_dependencies_cover_every_linked_library(self):
        depends = output("dpkg-deb", "-f", self.package, "Depends").strip()
        needed = self.needed(*self.programs())
        self.assertGreater(len(needed), 30)
        self.assertEqual(Debian().strangers(needed, depends), {})

    def test_dependencies_cover_every_loaded_library(self):
        """Covers Qt's platform plugins and SVG icon engine, ALSA's configuration, and a font."""
        depends = output("dpkg-deb", "-f", self.package, "Depends").strip()
        gui, = (file for file in libraries(self.root / "usr/bin/terratact-console") if "libQt6Gui.so" in file)
        plugins = [pathlib.Path(gui).parent / "qt6/plugins" / name
                   for name in ("platforms/libqxcb.so", "platforms/libqoffscreen.so", "iconengines/libqsvgicon.so")]
        others = ["/usr/share/alsa/alsa.conf", "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"]
        self.assertEqual(Debian().strangers({*map(str, plugins), *self.needed(*plugins), *others}, depends), {})

    def test_a_missing_dependency_is_detected(self):
        debian, needed = Debian(), self.needed(*self.programs())
        groups = output("dpkg-deb", "-f", self.package, "Depends").strip().split(",")
        for stem in ("libsodium", "libgpiod", "libtomlplusplus3"):
            package, = (name for name in debian.names(",".join(groups)) if re.fullmatch(rf"{stem}\d*(t64)?", name))
            less = ",".join(group for group in groups if debian.names(group) != [package])
            self.assertEqual(set(debian.strangers(needed, less).values()), {package})

    def test_programs_are_stripped_and_hold_no_build_paths(self):
        for name in ("terratact", "terratact-console"):
            program = self.root / "usr/bin" / name
            self.assertIn(", stripped", output("file", program))
            content = program.read_bytes()
            for place in (SOURCE, BUILD):
                self.assertNotIn(place.encode(), content)
            self.assertNotRegex(output("readelf", "-d", program), "RPATH|RUNPATH")

    def test_compressed_files_have_no_time_stamp(self):
        for name in ("man/man1/terratact.1.gz", "man/man1/terratact-console.1.gz", "doc/terratact/changelog.gz"):
            content = (self.root / "usr/share" / name).read_bytes()
            self.assertEqual(content[4:8], bytes(4))
            self.assertTrue(gzip.decompress(content))

    def test_the_copyright_names_qwt(self):
        self.assertIn("based in part on the work of the Qwt project (http://qwt.sf.net)",
                      (self.root / "usr/share/doc/terratact/copyright").read_text())

    def test_programs_run_with_the_packaged_files(self):
        self.assertRegex(self.run_installed("terratact", "--version"), r"^terratact \d")
        self.run_installed("terratact", "demo", "--out", "demo")
        self.assertEqual(len(list(pathlib.Path(self.folder.name, "demo").iterdir())), 4)
        self.run_installed("terratact-console", "--screenshot", "console.png")
        self.assertTrue(pathlib.Path(self.folder.name, "console.png").read_bytes().startswith(b"\x89PNG"))

    def test_programs_read_only_the_packaged_files(self):
        hidden = self.root / "usr/share/elsewhere"
        shipped = self.root / "usr/share/terratact"
        shipped.rename(hidden)
        self.addCleanup(hidden.rename, shipped)
        for program, arguments in (("terratact", ["demo"]), ("terratact-console", ["--screenshot", "none.png"])):
            complaint = self.run_installed(program, *arguments, code=1)
            self.assertRegex(complaint, rf"^{program}: {re.escape(str(shipped))}/")


if __name__ == "__main__":
    unittest.main()
