"""Files that docs/development.md and the READMEs of rooms name are there. The README around a room names the room.
Test programs that the documents run are there. Sources stay short."""
import os
import pathlib
import re
import unittest

SOURCE = pathlib.Path(os.environ["TERRATACT_SOURCE_DIR"])
ROOMS = ("app", "core", "drivers", "widgets")
FILE = re.compile(r"`((?:[\w.-]+/)*[\w.-]+\.(?:h|cpp))`")
PROGRAM = re.compile(r'(?:\$build|\$3"\)|build/\w+)/(?:tests/)?((?:app|core|drivers|widgets)\.[\w.]+)')
NAME = re.compile(r"\(((?:`[\w:]+`(?:, )?)+)\)")


def table_rows():
    text = (SOURCE / "docs/development.md").read_text()
    section = text.split("## Where things are")[1].split("\n## ")[0]
    return [line for line in section.splitlines() if line.startswith("| ") and not line.startswith(("| question", "| ---"))]


def files_of(row):
    """The files of a row. A file without a folder stands beside the one before it."""
    folder = SOURCE
    for name in FILE.findall(row):
        path = SOURCE / name if "/" in name else folder / name
        folder = path.parent
        yield path


class WhereThingsAre(unittest.TestCase):
    def test_every_file_of_the_table_is_there(self):
        rows = table_rows()
        self.assertGreater(len(rows), 50)
        missing = [(row, str(path)) for row in rows for path in files_of(row) if not path.is_file()]
        self.assertEqual(missing, [])

    def test_names_of_the_table_are_in_files_of_their_rows(self):
        lost = []
        for row in table_rows():
            texts = [path.read_text() for path in files_of(row) if path.is_file()]
            for names in NAME.findall(row):
                for name in re.findall(r"`([\w:]+)`", names):
                    if not any(re.search(rf"\b{name.split('::')[-1]}\b", text) for text in texts):
                        lost.append((row, name))
        self.assertEqual(lost, [])


class Rooms(unittest.TestCase):
    def readmes(self):
        return [path for room in ROOMS for path in sorted((SOURCE / room).rglob("README.md"))]

    def test_every_file_that_a_readme_names_is_there(self):
        missing = []
        for readme in self.readmes():
            for name in FILE.findall(readme.read_text()):
                pattern = name.replace("NAME", "*")  # one for each page, text, subcommand
                if not any(readme.parent.glob(pattern)) and not (SOURCE / name).is_file():
                    missing.append((str(readme.relative_to(SOURCE)), name))
        self.assertEqual(missing, [])

    def test_a_readme_names_every_room_inside(self):
        unnamed = []
        readmes = {readme.parent for readme in self.readmes()}
        for room in readmes:
            around = next((folder for folder in room.parents if folder in readmes), None)
            if around and f"`{room.relative_to(around)}/`" not in (around / "README.md").read_text():
                unnamed.append(str(room.relative_to(SOURCE)))
        self.assertEqual(unnamed, [])


class TestPrograms(unittest.TestCase):
    def test_every_one_that_a_document_runs_is_there(self):
        cmake = "".join(path.read_text() for path in (SOURCE / "tests").rglob("CMakeLists.txt"))
        known = {name.replace("/", ".") for name in re.findall(r"\bterratact_test\(([\w/]+)", cmake)}
        self.assertGreater(len(known), 50)
        named = [(path.name, name) for path in (SOURCE / "docs").iterdir() if path.suffix in (".md", ".sh")
                 for name in PROGRAM.findall(path.read_text())]
        self.assertGreater(len(named), 5)
        self.assertEqual([(page, name) for page, name in named if name not in known], [])


class Sources(unittest.TestCase):
    def test_none_is_longer_than_450_lines(self):
        sources = [path for room in ROOMS for path in (SOURCE / room).rglob("*.[hc]*") if path.suffix in (".h", ".cpp")]
        self.assertGreater(len(sources), 1000)
        lengths = {str(path.relative_to(SOURCE)): len(path.read_text().splitlines()) for path in sources}
        self.assertEqual({path: lines for path, lines in lengths.items() if lines > 450}, {})


if __name__ == "__main__":
    unittest.main()
