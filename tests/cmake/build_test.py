"""cmake/build.sh configures a preset when it must, and keeps what a build for a few targets made."""

import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["TERRATACT_SOURCE_DIR"])

PROJECT = """cmake_minimum_required(VERSION 3.25)
project(small LANGUAGES NONE)
option(TERRATACT_TESTS "Build the tests" ON)
set(part ${CMAKE_BINARY_DIR}/CMakeFiles/part)  # where objects are, which --fresh deletes
add_custom_command(OUTPUT ${part} COMMAND ${CMAKE_COMMAND} -E touch ${part})
add_custom_target(few ALL DEPENDS ${part})
if(TERRATACT_TESTS)
  add_custom_target(tests ALL COMMAND ${CMAKE_COMMAND} -E touch tested)
endif()
"""


def preset(name, **variables):
    return {"name": name, "generator": "Ninja", "binaryDir": "${sourceDir}/build/" + name, "cacheVariables": variables}


class Build(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.project = pathlib.Path(folder.name)
        (self.project / "cmake").mkdir()
        shutil.copy(SOURCE / "cmake/build.sh", self.project / "cmake")
        (self.project / "CMakeLists.txt").write_text(PROJECT)
        presets = [preset("usual"), preset("bare", TERRATACT_TESTS="OFF")]
        (self.project / "CMakePresets.json").write_text(json.dumps({
            "version": 6, "configurePresets": presets,
            "buildPresets": [{"name": each["name"], "configurePreset": each["name"]} for each in presets]}))

    def build(self, *arguments):
        subprocess.run([self.project / "cmake/build.sh", *arguments], check=True, capture_output=True, text=True)

    def made(self, name, file):
        path = self.project / "build" / name / file
        return path.stat().st_mtime_ns if path.exists() else None

    def test_a_build_of_few_targets_gets_its_tests_later(self):
        self.build("usual", "few")
        part = self.made("usual", "CMakeFiles/part")
        self.assertIsNotNone(part)
        self.assertIsNone(self.made("usual", "tested"))
        for _ in range(2):
            self.build("usual")
            self.assertIsNotNone(self.made("usual", "tested"))
            self.assertEqual(self.made("usual", "CMakeFiles/part"), part)

    def test_a_preset_without_tests_stays_without(self):
        self.build("bare", "few")
        part = self.made("bare", "CMakeFiles/part")
        for _ in range(2):
            self.build("bare")
            self.assertIsNone(self.made("bare", "tested"))
            self.assertEqual(self.made("bare", "CMakeFiles/part"), part)

    def test_a_changed_preset_is_configured_anew(self):
        self.build("usual")
        presets = self.project / "CMakePresets.json"
        presets.write_text(presets.read_text().replace('"cacheVariables": {}', '"cacheVariables": {"X": "new"}', 1))
        self.build("usual")
        self.assertIn("X:UNINITIALIZED=new", (self.project / "build/usual/CMakeCache.txt").read_text())


if __name__ == "__main__":
    unittest.main()
