#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "app/recording/export/session_export.h"
#include "core/log/session_reader.h"
#include "tests/support/sessions/sessions.h"
#include "tests/support/temporary_directory.h"

namespace terratact {

/// Writes sessions of the shipped robot and exports them.
struct SessionFiles : testing::Test {
    /// Writes a session of the shipped robot with the rows that `fill` adds.
    template <class Fill>
    std::string session(const std::string& name, Fill fill, std::int64_t laterBy = 0)
    {
        const std::string path = directory.file(name);
        SessionStart start = someStart();
        start.wallTime += laterBy;
        start.robot = contentOf(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml");
        auto writer = SessionWriter::create(path, start);
        EXPECT_TRUE(writer) << writer.error().text;
        fill(*writer);
        EXPECT_TRUE(writer->seal());
        return path;
    }

    std::string exported(const std::string& path, const std::string& name,
                         std::optional<ExportKind> what = {})
    {
        auto reader = SessionReader::open(path);
        EXPECT_TRUE(reader);
        const std::string out = directory.file(name);
        counts = *writeExport(*reader, out, *exportFormatOf(out), {.what = what});
        return contentOf(out);
    }

    TemporaryDirectory directory;
    ExportCounts counts;
};

}  // namespace terratact
