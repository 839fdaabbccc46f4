#include "core/bags/bag_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "core/bags/bag_file.h"
#include "core/bags/byte_cursor.h"
#include "core/bags/decompress.h"
#include "core/bags/schema_texts.h"
#include "core/base/text.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

constexpr std::string_view kBagVersion = "#ROSBAG V2.0\n";
constexpr std::uint64_t kMaxBagHeader = std::uint64_t{1} << 20U;  // bytes of a record's header
constexpr std::uint64_t kMaxBagIndex = std::uint64_t{64}
                                    << 20U;  // bytes of connections and chunk infos

/// Records of the format, by their field `op`.
enum class BagOp : std::uint8_t {
    Message = 0x02,
    Header = 0x03,
    Index = 0x04,
    Chunk = 0x05,
    ChunkInfo = 0x06,
    Connection = 0x07,
};

/// Fields "name=value" of a header, each behind its length.
class BagFields {
public:
    explicit BagFields(std::string_view header)
    {
        ByteCursor in(header);
        while (in.left() > 0 && in.isValid()) {
            const std::string_view field = in.text();
            const std::size_t equals = field.find('=');
            if (equals == std::string_view::npos) break;
            fields_.try_emplace(field.substr(0, equals), field.substr(equals + 1));
        }
    }

    std::string_view text(std::string_view name) const
    {
        const auto found = fields_.find(name);
        return found == fields_.end() ? std::string_view() : found->second;
    }

    template <class T>
    std::optional<T> number(std::string_view name) const
    {
        const auto found = fields_.find(name);
        if (found == fields_.end() || found->second.size() != sizeof(T)) return std::nullopt;
        return ByteCursor(found->second).number<T>();
    }

    BagOp op() const { return static_cast<BagOp>(number<std::uint8_t>("op").value_or(0)); }

    /// Returns a time of two numbers of 32 bits [ns]; empty if it is missing.
    std::optional<std::int64_t> time() const
    {
        const auto both = number<std::uint64_t>("time");
        if (!both) return std::nullopt;
        return static_cast<std::int64_t>(*both & 0xFFFFFFFFU) * 1'000'000'000
             + static_cast<std::int64_t>(*both >> 32U);
    }

private:
    std::map<std::string_view, std::string_view> fields_;
};

/// A record in bytes: its header and its data.
struct BagRecord {
    std::string_view header, data;
};

std::optional<BagRecord> nextRecord(ByteCursor& in)
{
    const BagRecord record{in.text(), in.text()};
    return in.isValid() ? std::optional(record) : std::nullopt;
}

class BagRecording final : public Recording {
public:
    BagRecording(const std::string& path, BagFile file)
        : Recording(path), file_(std::move(file)), unpacker_(file_.size())
    {
        readIndex();
        file_.goTo(kBagVersion.size());
    }

    std::string_view format() const override { return "ROS 1 bag"; }

    Result<bool> next(RecordedMessage& message) override
    {
        for (;;) {
            if (nextOfChunk(message)) return true;
            if (ended_ || !readRecord(message)) return false;
            if (std::exchange(found_, false)) return true;
        }
    }

    bool isEncrypted() const { return encrypted_; }

private:
    /// Reads connections and chunk infos behind index_pos of the first record.
    void readIndex()
    {
        file_.goTo(kBagVersion.size());
        const std::uint64_t offset = file_.at();
        std::string header, index;
        if (!readHead(header)) return noIndex();
        const BagFields fields(header);
        encrypted_ = !fields.text("encryptor").empty();
        const auto begin = fields.number<std::uint64_t>("index_pos");
        if (fields.op() != BagOp::Header || !begin || *begin <= offset || *begin > file_.size())
            return noIndex();
        file_.goTo(*begin);
        if (!file_.read(file_.left(), kMaxBagIndex, index)) return noIndex();
        ByteCursor in(index);
        while (in.left() > 0) {
            const auto record = nextRecord(in);
            if (!record) return chunks_.clear();
            addConnection(*record);
            addChunkInfo(*record);
        }
    }

    void noIndex() { note("has no index; it is read from its beginning"); }

    /// Reads the header of a record and goes behind it.
    bool readHead(std::string& header)
    {
        std::string length;
        if (!file_.read(4, 4, length)) return false;
        return file_.read(ByteCursor(length).number<std::uint32_t>(), kMaxBagHeader, header);
    }

    void addConnection(const BagRecord& record)
    {
        const BagFields fields(record.header);
        const auto id = fields.number<std::uint32_t>("conn");
        if (fields.op() != BagOp::Connection || !id || topicOf_.contains(*id)
            || topics_.size() >= kMaxTopics)
            return;
        const BagFields about(record.data);
        RecordedTopic topic{.name = keptName(fields.text("topic")),
                            .type = keptName(about.text("type")),
                            .encoding = "ros1",
                            .schemaEncoding = "ros1msg"};
        topic.schema = texts_.keep(topic.type, about.text("message_definition"));
        if (!topic.schema) note(topic.schema.error().text);
        if (about.text("message_definition").empty()) topic.schemaEncoding.clear();
        topicOf_[*id] = topics_.size();
        topics_.push_back(std::move(topic));
    }

    void addChunkInfo(const BagRecord& record)
    {
        const BagFields fields(record.header);
        const auto place = fields.number<std::uint64_t>("chunk_pos");
        if (fields.op() != BagOp::ChunkInfo || !place) return;
        std::vector<std::uint32_t> connections;
        ByteCursor counts(record.data);
        while (counts.left() >= 8) {
            connections.push_back(counts.number<std::uint32_t>());
            const auto count = counts.number<std::uint32_t>();
            if (const auto topic = topicOf_.find(connections.back()); topic != topicOf_.end()) {
                auto& messages = topics_[topic->second].messages;
                messages = messages.value_or(0) + count;
            }
        }
        chunks_[*place] = std::move(connections);
    }

    /// Returns true if the index says that no selected topic is in the chunk at this offset.
    bool canSkip(std::uint64_t offset) const
    {
        const auto place = chunks_.find(offset);
        if (place == chunks_.end() || selectsAll()) return false;
        return std::ranges::none_of(place->second, [this](std::uint32_t connection) {
            const auto topic = topicOf_.find(connection);
            return topic == topicOf_.end() || isSelected(topics_[topic->second]);
        });
    }

    /// Reads the file's next record. Returns false at its end.
    bool readRecord(RecordedMessage& message)
    {
        const std::uint64_t offset = file_.at();
        if (file_.left() == 0) return ended_ = true, false;
        std::string header, length;
        if (!readHead(header) || !file_.read(4, 4, length)) return endsAt(offset);
        const std::uint64_t size = ByteCursor(length).number<std::uint32_t>();
        if (size > file_.left()) return endsAt(offset);
        const std::uint64_t behind = file_.at() + size;
        const BagFields fields(header);
        if (fields.op() == BagOp::Chunk) {
            if (!canSkip(offset)) readChunk(offset, fields, size);
        } else if (fields.op() == BagOp::Message || fields.op() == BagOp::Connection) {
            if (!file_.read(size, kMaxChunkBytes, data_))
                remark(fmt::format(
                    "the record at byte {} has {} bytes, more than {}; it is passed over", offset,
                    size, kMaxChunkBytes));
            else if (fields.op() == BagOp::Connection)
                addConnection({header, data_});
            else
                found_ = readMessage({header, data_}, offset, message);
        }
        file_.goTo(behind);
        return true;
    }

    bool endsAt(std::uint64_t offset)
    {
        ended_ = true;
        remark(fmt::format("ends within the record at byte {}; it was read up to there", offset));
        return false;
    }

    void readChunk(std::uint64_t offset, const BagFields& fields, std::uint64_t size)
    {
        at_ = 0;
        chunk_.clear();
        chunkAt_ = offset;
        Status done = Done{};
        if (!file_.read(size, kMaxChunkBytes, data_))
            done = Error{fmt::format("has {} bytes, more than {}", size, kMaxChunkBytes)};
        else
            done = unpacker_.unpack(fields.text("compression"), data_, chunk_);
        const auto declared = fields.number<std::uint32_t>("size");
        if (done && declared && *declared != chunk_.size())
            done =
                Error{fmt::format("has {} bytes where it declares {}", chunk_.size(), *declared)};
        if (done) return;
        chunk_.clear();
        remark(fmt::format("the chunk at byte {} {}; it is left out", offset, done.error().text));
    }

    bool readMessage(const BagRecord& record, std::uint64_t offset, RecordedMessage& message)
    {
        const BagFields fields(record.header);
        const auto connection = fields.number<std::uint32_t>("conn");
        const auto time = fields.time();
        const auto topic = connection ? topicOf_.find(*connection) : topicOf_.end();
        if (!time || topic == topicOf_.end()) {
            remark(fmt::format("the message at byte {} has no time, or no connection that the file "
                               "defines; it is left out",
                               offset));
            return false;
        }
        if (!isSelected(topics_[topic->second])) return false;
        message = {.topic = topic->second, .time = *time, .offset = offset, .data = record.data};
        return true;
    }

    /// Goes to the next message of the open chunk. Returns false behind the last.
    bool nextOfChunk(RecordedMessage& message)
    {
        while (at_ < chunk_.size()) {
            ByteCursor in(std::string_view(chunk_).substr(at_));
            const auto record = nextRecord(in);
            if (!record) {
                remark(fmt::format("the chunk at byte {} ends within a record", chunkAt_));
                at_ = chunk_.size();
                return false;
            }
            at_ += in.at();
            if (BagFields(record->header).op() != BagOp::Message)
                addConnection(*record);
            else if (readMessage(*record, chunkAt_, message))
                return true;
        }
        return false;
    }

    BagFile file_;
    ChunkUnpacker unpacker_;
    SchemaTexts texts_;
    std::map<std::uint32_t, std::size_t> topicOf_;  ///< by connection
    std::map<std::uint64_t, std::vector<std::uint32_t>>
        chunks_;  ///< connections, by the chunk's offset
    std::string data_, chunk_;
    std::size_t at_ = 0;
    std::uint64_t chunkAt_ = 0;
    bool ended_ = false, found_ = false, encrypted_ = false;
};

}  // namespace

Result<std::unique_ptr<Recording>> openBag(const std::string& path)
{
    auto file = BagFile::open(path);
    if (!file) return file.error();
    std::string version;
    if (!file->read(kBagVersion.size(), kBagVersion.size(), version) || version != kBagVersion)
        return fileError(path,
                         fmt::format("is a ROS bag of another version, expected 2.0; `rosbag fix` "
                                     "converts it: {}",
                                     shown(version.substr(0, 12))));
    auto bag = std::make_unique<BagRecording>(path, std::move(*file));
    if (bag->isEncrypted())
        return fileError(path, "is encrypted; `rosbag decompress` writes it without encryption");
    return std::unique_ptr<Recording>(std::move(bag));
}

}  // namespace terratact
