// Tests that refused models and sessions are explained in the operator's language. The errors are not listed here: the
// readers produce them for files broken in many ways. No English word may remain in the translations.
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <functional>
#include <set>
#include <utility>

#include "app/recording/review_notes.h"
#include "app/recording/what_if.h"
#include "core/learn/model/file/model_file.h"
#include "core/log/session_reader.h"
#include "core/store/file_read.h"
#include "tests/app/review/refusals.h"
#include "tests/support/random_model.h"
#include "tests/support/sessions/sessions.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

void attempt(const std::string& path, const std::string& sql)
{
    sqlite3* file = nullptr;
    sqlite3_open(path.c_str(), &file);
    const std::string quickly = "PRAGMA synchronous = OFF; PRAGMA journal_mode = MEMORY; ";
    // A violated constraint leaves the file unchanged.
    sqlite3_exec(file, (quickly + sql).c_str(), nullptr, nullptr, nullptr);
    sqlite3_close(file);
}

/// Returns tables and their columns.
std::vector<std::pair<std::string, std::string>> columnsOf(const std::string& path)
{
    std::vector<std::pair<std::string, std::string>> columns;
    sqlite3* file = nullptr;
    sqlite3_open(path.c_str(), &file);
    const auto take = [](void* all, int, char** row, char**) {
        static_cast<decltype(columns)*>(all)->emplace_back(row[0], row[1]);
        return 0;
    };
    sqlite3_exec(file,
                 "SELECT s.name, c.name FROM sqlite_schema s, pragma_table_info(s.name) c "
                 "WHERE s.type = 'table'",
                 take, &columns, nullptr);
    sqlite3_close(file);
    return columns;
}

/// Breaks the file: each column, in one row and in all rows, gets an invalid value; also cuts the bytes.
void breakTables(const TemporaryDirectory& dir, const std::string& path,
                 const std::vector<std::string>& more,
                 const std::function<void(const std::string& file)>& read)
{
    const std::string bytes = contentOf(path);
    const auto after = [&](const std::string& sql) {
        const std::string broken = dir.write("broken.ttm", bytes);
        attempt(broken, sql);
        read(broken);
    };
    std::set<std::string> tables;
    for (const auto& [table, column] : columnsOf(path)) {
        tables.insert(table);
        const std::string set = "UPDATE OR IGNORE " + table + " SET \"" + column + "\" = ";
        const std::string one =
            " WHERE \"" + column + "\" = (SELECT max(\"" + column + "\") FROM " + table + ")";
        for (const char* const value :
             {"0", "-1", "9e99", "77", "0.5", "''", "'wrong'", "'7'", "x''"}) {
            after(set + value);
            after(set + value + one);
        }
    }
    for (const std::string& table : tables) {
        after("DELETE FROM " + table);
        after("DELETE FROM " + table + " WHERE rowid = 1");
        after("DROP TABLE " + table);
    }
    for (const std::string& sql : more) after(sql);
    for (const std::size_t size :
         {std::size_t{0}, std::size_t{50}, bytes.size() - 1, bytes.size() - 4096})
        read(dir.write("broken.ttm", bytes.substr(0, size)));
    read(dir.write("broken.ttm", bytes + "x"));
    for (std::size_t at = 4096; at < bytes.size(); at += 4096) {
        std::string broken = bytes;
        broken.replace(at, 64, 64, 'x');
        read(dir.write("broken.ttm", broken));
    }
    read(dir.file("none.ttm"));
    read(dir.file(""));
}

TEST(Refusals, ofModels)
{
    const TemporaryDirectory dir;
    const std::string path = dir.file("model.ttm");
    ASSERT_TRUE(writeModel(path, randomModel(3)));
    QSet<QString> names;
    for (const auto& [table, column] : columnsOf(path))
        names << format::text(table) << format::text(column);
    names << "pa"
          << "paf"
          << "command"
          << "seed";
    Refusals refusals(names);
    breakTables(dir, path,
                {"PRAGMA application_id = 7",
                 "PRAGMA application_id = 1414811953",
                 "PRAGMA user_version = 1",
                 "CREATE TABLE zebra(x)",
                 "DELETE FROM meta WHERE key = 'seed'",
                 "UPDATE meta SET value = 'x' WHERE key = 'seed'",
                 "INSERT INTO meta VALUES('inducing_rows', '-5')",
                 "INSERT INTO meta VALUES('bins', '1')",
                 "INSERT INTO clearance VALUES('more', 1.0)",
                 "INSERT INTO scanned_row SELECT 7, 0,0,0,0,0,0,0,0,0,0,0",
                 "UPDATE meta SET value = 'another' WHERE key = 'command'",
                 "UPDATE input SET name = 'roll_rad' WHERE position = 11",
                 "UPDATE bin SET feature_set = 'pax' WHERE feature_set = 'pa' AND bin = 3",
                 "INSERT INTO bin SELECT 'other', bin, name, 1.0, 1.0, 1.0 FROM bin WHERE "
                 "feature_set = 'pa'",
                 "INSERT INTO bin SELECT 'pa', 12, name, 1.0, 1.0, 1.0 FROM bin LIMIT 1",
                 "INSERT INTO surface SELECT 12, 0, 0.0, 1.0, 1.0, 1.0",
                 "DELETE FROM surface_scale WHERE bin = 3 AND input = 10",
                 "DELETE FROM surface_scale WHERE bin = 3 AND input = 4",
                 "DELETE FROM surface_weight WHERE bin = 3 AND position = 2",
                 "INSERT INTO clearance_conditional VALUES(3, 0, 1.0, 1.0); "
                 "INSERT INTO clearance_conditional_scale VALUES(3, 0, 0, 1.0)",
                 "DELETE FROM residual_row WHERE row = 2",
                 "DELETE FROM scanned_row WHERE row = 0",
                 "DELETE FROM length_scale WHERE feature_set = 'pa' AND bin = 10 AND input = 13"},
                [&](const std::string& file) { refusals.add(readModel(file)); });
    EXPECT_GE(refusals.size(), 50U);
    refusals.expectTranslated();
}

TEST(Refusals, ofSessions)
{
    const TemporaryDirectory dir;
    const std::string path = dir.file("session.tts");
    {
        auto writer = someSession(path, 400);
        ASSERT_TRUE(writer) << writer.error().text;
        ASSERT_TRUE(writer->seal());
    }
    QSet<QString> names{"meta",      "bus",   "program", "robot", "source",
                        "transmits", "batch", "chain",   "base",  "note"};
    for (const auto& [table, column] : columnsOf(path))
        names << format::text(table) << format::text(column);
    Refusals refusals(names);
    breakTables(
        dir, path,
        {"PRAGMA application_id = 7", "PRAGMA user_version = 1", "CREATE TABLE zebra(x)",
         "DELETE FROM meta WHERE key = 'bus'", "INSERT INTO meta VALUES('zebra', 'x')",
         "UPDATE meta SET value = 'x' WHERE key = 'transmits'",
         "UPDATE meta SET value = 'x' WHERE key = 'wall_time_ns'", "DELETE FROM batch WHERE id = 2",
         "UPDATE event SET batch = 77", "UPDATE estimate_draws SET draws = x'00'",
         "DELETE FROM estimate_draws", "DELETE FROM can_frame WHERE seq = 7",
         "INSERT INTO can_frame SELECT 100000, t, id, flags, data FROM can_frame WHERE seq = 1"},
        [&](const std::string& file) {
            auto session = SessionReader::open(file);
            refusals.add(session);
            if (!session) return;
            for (const SessionDamage& damage : session->verify().damage) refusals.add(damage.why);
        });
    auto session = SessionReader::open(path);
    ASSERT_TRUE(session);
    refusals.add(robotOf(*session));
    const ModelRow row{
        .id = 1, .name = "default.ttm", .hash = std::string(8, 'c') + std::string(56, '1')};
    const std::string a = dir.write("a.ttm", "x"), b = dir.write("b.ttm", "y");
    refusals.add(modelFileOf(row, {}));
    refusals.add(modelFileOf(row, std::array{a}));
    refusals.add(modelFileOf(row, std::array{a, b}));
    refusals.add(modelFileOf(row, std::array{a, b, dir.file("none.ttm")}));
    for (const char* const notes : {"", "x\n", "t_s,note", "t_s\n", "t_s,\"note\n",
                                    "t_s,note\nx,y\n", "t_s,note\n1,2,3\n", "x,y\n"}) {
        dir.write("session.tts.notes.csv", notes);
        refusals.add(readNotes(path));
    }
    EXPECT_GE(refusals.size(), 25U);
    refusals.expectTranslated();
}

}  // namespace
}  // namespace terratact
