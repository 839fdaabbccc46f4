#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/bags/message_decoder.h"
#include "core/base/result.h"

namespace terratact {

/// One message of a recording. `data` is valid until the recording's next call.
struct RecordedMessage {
    std::size_t topic = 0;     ///< index into topics()
    std::int64_t time = 0;     ///< [ns] at which the recorder wrote it
    std::uint64_t offset = 0;  ///< byte of the file, row of a database, or line of a text
    std::string_view data;
};

/// Called with the place of each message that is read, and whether it counts bytes. An exception
/// that it throws ends the reading, as cancellation does.
using RecordingWatch = std::function<void(std::uint64_t place, bool isByte)>;

/// Topics of timed messages in a file of another program. Nothing in the file is trusted. A file
/// that is cut or lacks its index is read as far as it goes. Remarks say where it ends.
///
///     for (RecordedMessage message;;) {
///         const Result<bool> more = recording->next(message);
///         if (!more) return more.error();
///         if (!*more) break;
///         … recording->decode(message) …
///     }
class Recording {
public:
    explicit Recording(std::string path) : path_(std::move(path)) {}
    virtual ~Recording() = default;
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;

    const std::string& path() const { return path_; }
    virtual std::string_view format() const = 0;  ///< "MCAP", "ROS 1 bag", …
    /// Returns what RecordedMessage::offset counts.
    virtual std::string_view offsetUnit() const { return "byte"; }

    /// Returns the topics found so far. Files without an index name their topics among the messages.
    const std::vector<RecordedTopic>& topics() const { return topics_; }

    /// Selects the topics to read; parts of the file without them are skipped if it has an index.
    void select(std::set<std::string> names) { selected_ = std::move(names); }

    /// Goes to the next message of a selected topic. Messages are not in the order of their times.
    /// Returns false after the last. Errors name the file, the byte and what was expected.
    virtual Result<bool> next(RecordedMessage& message) = 0;

    /// Calls `watch` with each message of read().
    void follow(RecordingWatch watch) { watch_ = std::move(watch); }
    /// The same as next(), and calls the watch: for readers of whole recordings.
    Result<bool> read(RecordedMessage& message);

    /// Decodes a message that next() returned. Errors name the file, the topic and the message's place. One of
    /// them: the definitions of all decoded topics have more than kMaxParts structs and fields. A remark says
    /// where the shipped definition of a common type was used, because the file's encoding is not read.
    virtual Result<FieldValue> decode(const RecordedMessage& message);

    static constexpr std::size_t kMaxParts = 100'000;

    /// Returns the sentences about damage, and about how the file was read, since the last call. They lack
    /// the file's name.
    std::vector<std::string> consumeRemarks();
    /// Returns the first sentence about damage so far; empty: none was found.
    const std::string& damage() const { return damage_; }

protected:
    static constexpr std::size_t kMaxTopics = 10'000;

    bool isSelected(const RecordedTopic& topic) const
    {
        return !selected_ || selected_->contains(topic.name);
    }
    bool selectsAll() const { return !selected_; }
    void remark(std::string text);  ///< of damage
    void note(std::string text);    ///< of how the file is read, although it is whole

    std::vector<RecordedTopic> topics_;

private:
    std::string path_;
    RecordingWatch watch_;
    std::optional<std::set<std::string>> selected_;
    std::string damage_;
    std::vector<std::string> remarks_;
    std::size_t remarked_ = 0;
    /// What a decoder depends on: type, encodings, and the definition or why it is left out. Many topics
    /// may share one.
    using DecoderKey =
        std::tuple<std::string, std::string, std::string, const std::string*, std::string>;
    const Result<MessageDecoder>& decoderOf(std::size_t topic);
    Result<MessageDecoder> newDecoder(const RecordedTopic& topic);

    std::size_t parts_ = 0;  ///< of all decoders
    std::map<DecoderKey, Result<MessageDecoder>> decoders_;
    std::vector<const Result<MessageDecoder>*> decoderOfTopic_;  ///< null: not used yet
};

/// Column with the time of each row of a CSV file.
struct CsvTime {
    std::string
        column{};  ///< empty: the first of __time, %time, time, timestamp, stamp, t, seconds, also
                   ///< with an ending such as _s, _ms, _us, _ns or [s]
    double unit = 0.0;  ///< [s]; 0: by the ending of the column's name, else by the first value:
                        ///< above 1e17 ns, above 1e14 µs, above 1e11 ms, else s
};

/// Opens a recording by its content, not by its name: MCAP, a ROS 1 bag, a ROS 2 bag in SQLite, or
/// CSV. csv: for a CSV file. Errors name the file, what it is, and what was expected.
Result<std::unique_ptr<Recording>> openRecording(const std::string& path, const CsvTime& csv = {});

}  // namespace terratact
