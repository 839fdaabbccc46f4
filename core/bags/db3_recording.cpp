#include "core/bags/db3_recording.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <map>
#include <utility>

#include "core/bags/decompress.h"
#include "core/bags/schema_texts.h"
#include "core/base/text.h"
#include "core/store/content_kind.h"
#include "core/store/file_read.h"
#include "core/store/sqlite.h"

namespace terratact {
namespace {

/// A definition of message_definitions.
struct StoredDefinition {
    std::string encoding;
    Result<std::shared_ptr<const std::string>> text;  ///< errors are those of SchemaTexts
};

bool hasTable(SqliteFile& file, const char* name)
{
    SqliteStatement query =
        file.prepare("SELECT count(*) FROM sqlite_schema WHERE type = 'table' AND name = ?");
    query.bind(0, name);
    return query.step() && query.integer(0) == 1;
}

class Db3Recording final : public Recording {
public:
    Db3Recording(const std::string& path, SqliteFile file) : Recording(path), file_(std::move(file))
    {
        const auto definitions = readDefinitions();
        SqliteStatement rows =
            file_.prepare("SELECT id, name, type, serialization_format FROM topics ORDER BY id");
        while (rows.step() && topics_.size() < kMaxTopics) {
            RecordedTopic topic{.name = keptName(rows.text(1)),
                                .type = keptName(rows.text(2)),
                                .encoding = keptName(rows.text(3))};
            if (const auto found = definitions.find(topic.type); found != definitions.end()) {
                topic.schemaEncoding = found->second.encoding;
                topic.schema = found->second.text;
            } else if (hasMoreDefinitions_) {
                topic.schema =
                    Error{fmt::format("the definition of {} is not among the first {} of the file, "
                                      "which alone are read",
                                      printable(topic.type), MessageSchema::kMaxStructs)};
            }
            topicOf_[rows.integer(0)] = topics_.size();
            topics_.push_back(std::move(topic));
        }
        messages_ = std::make_unique<SqliteStatement>(
            file_.prepare("SELECT id, topic_id, timestamp, data FROM messages"));
    }

    std::string_view format() const override { return "ROS 2 bag (SQLite)"; }
    std::string_view offsetUnit() const override { return "row"; }

    Result<bool> next(RecordedMessage& message) override
    {
        while (!ended_) {
            try {
                if (!messages_->step()) break;
                row_ = static_cast<std::uint64_t>(messages_->integer(0));
                if (!hasTypes()) {
                    remark(
                        fmt::format("row {} of messages holds values of a wrong type; it is left "
                                    "out",
                                    row_));
                    continue;
                }
                const auto topic = topicOf_.find(messages_->integer(1));
                if (topic == topicOf_.end()) {
                    remark(fmt::format("row {} of messages is of no topic; it is left out", row_));
                    continue;
                }
                if (!isSelected(topics_[topic->second])) continue;
                data_ = messages_->blob(3);
                message = {.topic = topic->second,
                           .time = messages_->integer(2),
                           .offset = row_,
                           .data = data_};
                return true;
            } catch (const SqliteError& error) {
                remark(
                    fmt::format("is damaged behind row {} of messages: {}; it was read up to there",
                                row_, error.what()));
                break;
            }
        }
        ended_ = true;
        return false;
    }

private:
    /// Returns the definitions of the file by their types.
    std::map<std::string, StoredDefinition> readDefinitions()
    {
        std::map<std::string, StoredDefinition> all;
        if (!hasTable(file_, "message_definitions")) return all;
        SchemaTexts texts;
        SqliteStatement rows = file_.prepare(
            "SELECT topic_type, encoding, encoded_message_definition FROM message_definitions");
        while (rows.step()) {
            hasMoreDefinitions_ = all.size() == MessageSchema::kMaxStructs;
            if (hasMoreDefinitions_) break;
            const std::string type = keptName(rows.text(0));
            const std::string text = rows.text(2);
            if (text.empty()) continue;  // its recorder did not find the definition
            const std::string encoding = keptName(rows.text(1));
            const auto kept = texts.keep(type, text, encoding);
            all.insert_or_assign(type, StoredDefinition{.encoding = encoding, .text = kept});
            if (!kept) note(kept.error().text);
        }
        return all;
    }

    /// SQLite stores any type in any column.
    bool hasTypes() const
    {
        return messages_->type(1) == SQLITE_INTEGER && messages_->type(2) == SQLITE_INTEGER
            && messages_->type(3) == SQLITE_BLOB;
    }

    SqliteFile file_;
    std::unique_ptr<SqliteStatement> messages_;
    std::map<std::int64_t, std::size_t> topicOf_;  ///< by id
    std::string data_;
    std::uint64_t row_ = 0;
    bool hasMoreDefinitions_ = false;  ///< than readDefinitions() returns
    bool ended_ = false;
};

}  // namespace

Result<std::unique_ptr<Recording>> openDb3(const std::string& path)
{
    if (contentKindOfFile(path) == ContentKind::Session)
        return fileError(path, "is a recorded session already; open it in the review");
    try {
        SqliteFile file = SqliteFile::openLog(path, static_cast<int>(kMaxChunkBytes));
        for (const char* const table : {"topics", "messages"})
            if (!hasTable(file, table))
                return fileError(path,
                                 fmt::format("has no table {}, expected a bag of rosbag2", table));
        return std::unique_ptr<Recording>(std::make_unique<Db3Recording>(path, std::move(file)));
    } catch (const SqliteError& error) {
        return fileError(path,
                         Message::joined(Message::verbatim("cannot be read as a bag of rosbag2"),
                                         error.message()));
    }
}

}  // namespace terratact
