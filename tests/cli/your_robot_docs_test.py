"""Runs every command of docs/your_robot.md: from recordings and laser maps to a model, its evaluation and its card."""

import unittest

from docs_support import PageCommands
from support import rows


class Commands(PageCommands):
    def test_the_page_ends_with_a_model_that_estimates(self):
        self.run_page("your_robot.md", 20)
        for model in ("generated_on_b", "mixed_on_b"):
            every = [row for row in rows(self.path / model / "tracks.csv")
                     if (row["approach"], row["what"]) == ("two tracks", "all")]
            self.assertEqual(len(every), 1)
            self.assertGreater(int(every[0]["n"]), 300)
            self.assertLess(float(every[0]["mean_m"]), 0.06)


if __name__ == "__main__":
    unittest.main()
