#include "core/bags/mcap_recording.h"

#include <fmt/format.h>
#include <zlib.h>

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

/// Records of the format, by their first byte.
enum class McapOp : std::uint8_t {
    Footer = 0x02,
    Schema = 0x03,
    Channel = 0x04,
    Message = 0x05,
    Chunk = 0x06,
    ChunkIndex = 0x08,
    Statistics = 0x0B,
};

constexpr std::uint64_t kRecordHead = 9;                         // byte of the kind, length
constexpr std::uint64_t kFooter = kRecordHead + 20 + 8;          // with the magic behind it
constexpr std::uint64_t kMaxSummary = std::uint64_t{64} << 20U;  // bytes

struct McapSchema {
    std::string name, encoding;
    Result<std::shared_ptr<const std::string>> text;
};

/// Place of a chunk and its channels, from the summary.
struct ChunkPlace {
    std::uint64_t at = 0;
    std::vector<std::uint16_t> channels;  ///< empty: the writer did not say
};

/// Schemas and channels of a file; the same record may come again.
class McapChannels {
public:
    explicit McapChannels(std::vector<RecordedTopic>& topics) : topics_(topics) {}

    /// Errors are those of SchemaTexts; the schema's topics keep them.
    Status addSchema(std::string_view record)
    {
        ByteCursor in(record);
        const auto id = in.number<std::uint16_t>();
        McapSchema schema{.name = keptName(in.text()),
                          .encoding = keptName(in.text()),
                          .text = std::shared_ptr<const std::string>()};
        const std::string_view text = in.text();
        if (!in.isValid() || schemas_.contains(id) || schemas_.size() >= kMaxEntries) return Done{};
        if (text.empty()) schema.encoding.clear();
        schema.text = texts_.keep(schema.name, text, schema.encoding);
        const McapSchema& kept = schemas_.emplace(id, std::move(schema)).first->second;
        return kept.text ? Status(Done{}) : kept.text.error();
    }

    void addChannel(std::string_view record)
    {
        ByteCursor in(record);
        const auto id = in.number<std::uint16_t>();
        const auto schema = in.number<std::uint16_t>();
        RecordedTopic topic{.name = keptName(in.text()), .encoding = keptName(in.text())};
        if (!in.isValid() || topicOf_.contains(id) || topics_.size() >= kMaxEntries) return;
        if (const auto found = schemas_.find(schema); found != schemas_.end()) {
            topic.type = found->second.name;
            topic.schemaEncoding = found->second.encoding;
            topic.schema = found->second.text;
        }
        topicOf_[id] = topics_.size();
        topics_.push_back(std::move(topic));
    }

    void addStatistics(std::string_view record)
    {
        constexpr std::uint64_t kBefore = 8 + 2 + 4 + 4 + 4 + 4 + 8 + 8;
        ByteCursor in(record);
        in.bytes(kBefore);
        ByteCursor counts(in.text());
        while (counts.left() > 0) {
            const auto id = counts.number<std::uint16_t>();
            const auto count = counts.number<std::uint64_t>();
            if (const auto topic = topicOf(id); topic && counts.isValid())
                topics_[*topic].messages = count;
        }
    }

    std::optional<std::size_t> topicOf(std::uint16_t channel) const
    {
        const auto found = topicOf_.find(channel);
        return found == topicOf_.end() ? std::nullopt : std::optional(found->second);
    }

private:
    static constexpr std::size_t kMaxEntries = 10'000;  // schemas, and topics

    std::vector<RecordedTopic>& topics_;
    SchemaTexts texts_;
    std::map<std::uint16_t, McapSchema> schemas_;
    std::map<std::uint16_t, std::size_t> topicOf_;
};

class McapRecording final : public Recording {
public:
    McapRecording(const std::string& path, BagFile file)
        : Recording(path), file_(std::move(file)), unpacker_(file_.size()), channels_(topics_)
    {
        readSummary();
        file_.goTo(kMcapMagic.size());
    }

    std::string_view format() const override { return "MCAP"; }

    Result<bool> next(RecordedMessage& message) override
    {
        for (;;) {
            if (nextOfChunk(message)) return true;
            if (ended_ || !readRecord(message)) return false;
            if (found_) return found_ = false, true;
        }
    }

private:
    /// Reads the summary, if it is there and whole. It names topics and chunks.
    void readSummary()
    {
        std::string footer;
        if (file_.size() < kFooter + kMcapMagic.size()) return noIndex();
        file_.goTo(file_.size() - kFooter);
        if (!file_.read(kFooter, kFooter, footer) || !footer.ends_with(kMcapMagic)
            || static_cast<McapOp>(footer.front()) != McapOp::Footer)
            return noIndex();
        ByteCursor in(std::string_view(footer).substr(kRecordHead));
        const auto begin = in.number<std::uint64_t>();
        if (begin == 0) return noIndex();
        std::string summary;
        file_.goTo(begin);
        const std::uint64_t end = file_.size() - kFooter;
        if (begin > end || !file_.read(end - begin, kMaxSummary, summary)) return noIndex();
        if (!readSummary(summary)) chunks_.clear();
    }

    void noIndex() { note("has no index; it is read from its beginning"); }

    bool readSummary(std::string_view summary)
    {
        ByteCursor in(summary);
        while (in.left() > 0) {
            const auto op = static_cast<McapOp>(in.number<std::uint8_t>());
            const std::string_view record = in.bytes(in.number<std::uint64_t>());
            if (!in.isValid()) return false;
            if (op == McapOp::ChunkIndex)
                addChunkIndex(record);
            else
                addCommon(op, record);
        }
        return true;
    }

    void addChunkIndex(std::string_view record)
    {
        ByteCursor in(record);
        in.bytes(16);  // first and last time
        ChunkPlace place{.at = in.number<std::uint64_t>(), .channels = {}};
        in.bytes(8);  // length of the chunk
        ByteCursor offsets(in.text());
        while (offsets.left() > 0) {
            place.channels.push_back(offsets.number<std::uint16_t>());
            offsets.bytes(8);
        }
        if (in.isValid() && offsets.isValid()) chunks_[place.at] = std::move(place);
    }

    void addCommon(McapOp op, std::string_view record)
    {
        if (op == McapOp::Schema) {
            const Status kept = channels_.addSchema(record);
            if (!kept) note(kept.error().text);
        }
        if (op == McapOp::Channel) channels_.addChannel(record);
        if (op == McapOp::Statistics) channels_.addStatistics(record);
    }

    /// Returns true if the index says that no selected topic is in the chunk at this offset.
    bool canSkip(std::uint64_t offset) const
    {
        const auto place = chunks_.find(offset);
        if (place == chunks_.end() || place->second.channels.empty() || selectsAll()) return false;
        return std::ranges::none_of(place->second.channels, [this](std::uint16_t channel) {
            const auto topic = channels_.topicOf(channel);
            return !topic || isSelected(topics_[*topic]);
        });
    }

    void endsAt(std::uint64_t offset)
    {
        ended_ = true;
        remark(fmt::format("ends within the record at byte {}; it was read up to there", offset));
    }

    /// Ends behind the footer. Files that were joined have more behind it.
    void endsWith(std::uint64_t end)
    {
        ended_ = true;
        if (end >= file_.size()) return;
        remark(
            fmt::format("ends at byte {}, and the {} bytes behind it are not read: if files were "
                        "joined, split them there",
                        end, file_.size() - end));
    }

    /// Reads the file's next record. Returns false at its end.
    bool readRecord(RecordedMessage& message)
    {
        const std::uint64_t offset = file_.at();
        std::string head;
        if (file_.left() == 0) return ended_ = true, false;
        if (!file_.read(kRecordHead, kRecordHead, head)) return endsAt(offset), false;
        ByteCursor in(head);
        const auto op = static_cast<McapOp>(in.number<std::uint8_t>());
        const auto length = in.number<std::uint64_t>();
        if (length > file_.left()) return endsAt(offset), false;
        const std::uint64_t behind = file_.at() + length;
        if (op == McapOp::Footer) return endsWith(behind + kMcapMagic.size()), false;
        if (op == McapOp::Chunk) {
            if (!canSkip(offset)) readChunk(offset, length);
        } else if (op == McapOp::Schema || op == McapOp::Channel || op == McapOp::Message) {
            if (!file_.read(length, kMaxChunkBytes, record_))
                remark(fmt::format(
                    "the record at byte {} has {} bytes, more than {}; it is passed over", offset,
                    length, kMaxChunkBytes));
            else if (op == McapOp::Message)
                found_ = readMessage(record_, offset, message);
            else
                addCommon(op, record_);
        }
        file_.goTo(behind);
        return true;
    }

    bool readMessage(std::string_view record, std::uint64_t offset, RecordedMessage& message)
    {
        ByteCursor in(record);
        const auto channel = in.number<std::uint16_t>();
        in.bytes(4);  // sequence
        const auto time = in.number<std::uint64_t>();
        in.bytes(8);  // time of publication
        const auto topic = channels_.topicOf(channel);
        if (!in.isValid() || time > static_cast<std::uint64_t>(INT64_MAX)) {
            remark(fmt::format("the message at byte {} is cut or has no valid time; it is left out",
                               offset));
            return false;
        }
        if (!topic) {
            remark(fmt::format("the message at byte {} is of the channel {}, which the file does "
                               "not define; it is left out",
                               offset, channel));
            return false;
        }
        if (!isSelected(topics_[*topic])) return false;
        message = {.topic = *topic,
                   .time = static_cast<std::int64_t>(time),
                   .offset = offset,
                   .data = record.substr(in.at())};
        return true;
    }

    void readChunk(std::uint64_t offset, std::uint64_t length)
    {
        const auto leaveOut = [&](std::string_view cause) {
            chunk_.clear();
            remark(fmt::format("the chunk at byte {} {}; it is left out", offset, cause));
        };
        at_ = 0;
        chunk_.clear();
        chunkAt_ = offset;
        if (!file_.read(length, kMaxChunkBytes, record_))
            return leaveOut(fmt::format("has {} bytes, more than {}", length, kMaxChunkBytes));
        ByteCursor in(record_);
        in.bytes(16);  // first and last time
        const auto size = in.number<std::uint64_t>();
        const auto checksum = in.number<std::uint32_t>();
        const std::string method(in.text());
        const std::string_view bytes = in.bytes(in.number<std::uint64_t>());
        if (!in.isValid()) return leaveOut("is cut");
        if (const Status done = unpacker_.unpack(method, bytes, chunk_); !done)
            return leaveOut(done.error().text);
        if (chunk_.size() != size)
            return leaveOut(fmt::format("has {} bytes where it declares {}", chunk_.size(), size));
        const auto sum = ::crc32(0, reinterpret_cast<const Bytef*>(chunk_.data()),
                                 static_cast<uInt>(chunk_.size()));
        if (checksum != 0 && sum != checksum) return leaveOut("has a wrong checksum");
    }

    /// Goes to the next message of the open chunk. Returns false behind the last.
    bool nextOfChunk(RecordedMessage& message)
    {
        while (at_ < chunk_.size()) {
            ByteCursor in(std::string_view(chunk_).substr(at_));
            const auto op = static_cast<McapOp>(in.number<std::uint8_t>());
            const std::string_view record = in.bytes(in.number<std::uint64_t>());
            if (!in.isValid()) {
                remark(fmt::format("the chunk at byte {} ends within a record", chunkAt_));
                break;
            }
            at_ += in.at();
            if (op != McapOp::Message)
                addCommon(op, record);
            else if (readMessage(record, chunkAt_, message))
                return true;
        }
        at_ = chunk_.size();
        return false;
    }

    BagFile file_;
    ChunkUnpacker unpacker_;
    McapChannels channels_;
    std::map<std::uint64_t, ChunkPlace> chunks_;
    std::string record_;
    std::string chunk_;  ///< decompressed
    std::size_t at_ = 0;
    std::uint64_t chunkAt_ = 0;
    bool ended_ = false, found_ = false;
};

}  // namespace

Result<std::unique_ptr<Recording>> openMcap(const std::string& path)
{
    auto file = BagFile::open(path);
    if (!file) return file.error();
    std::string magic;
    if (!file->read(kMcapMagic.size(), kMcapMagic.size(), magic) || magic != kMcapMagic)
        return fileError(path, "is no MCAP file");
    return std::unique_ptr<Recording>(std::make_unique<McapRecording>(path, std::move(*file)));
}

}  // namespace terratact
