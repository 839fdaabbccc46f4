#pragma once

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "core/log/session_reader.h"
#include "core/log/session_writer.h"
#include "tests/support/sessions/session_rehash.h"
#include "tests/support/sessions/sessions.h"
#include "tests/support/temporary_directory.h"

namespace terratact {

/// Writes and seals a session with this number of frames.
inline void seal(const std::string& path, std::int64_t frames)
{
    auto writer = someSession(path, frames);
    ASSERT_TRUE(writer) << writer.error().text;
    const Status sealed = writer->seal();
    ASSERT_TRUE(sealed) << sealed.error().text;
}

/// Leaves a session as a crashed program does: with its journal, but without the journal's index.
inline void crashed(const std::string& path, std::int64_t frames)
{
    const pid_t child = ::fork();
    if (child == 0) {
        const auto writer = someSession(path, frames);
        ::_exit(writer ? 0 : 1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_EQ(status, 0);
    std::filesystem::remove(path + "-shm");
}

inline std::vector<FrameRow> allFrames(SessionReader& reader)
{
    std::vector<FrameRow> all;
    for (std::size_t i = 0; i < reader.batches().size(); ++i)
        for (const FrameRow& frame : reader.frames(i)) all.push_back(frame);
    return all;
}

inline void change(const std::string& path, const std::string& sql)
{
    sqlite3* file = nullptr;
    ASSERT_EQ(sqlite3_open(path.c_str(), &file), SQLITE_OK);
    char* message = nullptr;
    EXPECT_EQ(sqlite3_exec(file, sql.c_str(), nullptr, nullptr, &message), SQLITE_OK) << message;
    sqlite3_close(file);
}

/// Writes a session, changes it, and hashes its rows again. Returns the reader's complaints.
inline std::string complaintsAfter(const std::string& path, const std::string& sql)
{
    seal(path, 200);
    change(path, sql);
    rehash(path);
    std::string text;
    const auto reader = SessionReader::open(path);
    if (!reader) return reader.error().text;
    for (const SessionDamage& damage : reader->damage()) text += damage.why.english() + '\n';
    return text;
}

inline int countFrom(const char* variable, int otherwise)
{
    const char* given = std::getenv(variable);
    return given ? std::atoi(given) : otherwise;
}

struct Session : testing::Test {
    TemporaryDirectory directory;
    std::string path = directory.file("a session.tts");
};

}  // namespace terratact
