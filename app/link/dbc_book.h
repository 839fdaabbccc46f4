#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "app/link/can_text.h"
#include "core/base/result.h"
#include "core/wire/can_frame.h"
#include "core/wire/dbc/dbc.h"

namespace terratact {

/// A frame described by a DBC file.
struct DescribedFrame {
    DbcMessage message;
    std::string file;  ///< file name without folders
};

/// Frame descriptions from DBC files, for frames outside the robot's protocol. They never override the protocol. If two
/// files describe the same identifier, the first file wins.
class DbcBook {
public:
    explicit DbcBook(CanProtocol protocol = CanProtocol::Terratact) : protocol_(protocol) {}

    /// Adds a regular file. Parts that are not used are listed in remarks().
    Status add(const std::string& path);

    /// Returns the description of a frame; null if no file describes it. Remote frames, error frames and frames of the
    /// protocol are never described. A message with the exact identifier takes precedence. A J1939 parameter group
    /// matches any source address. Among messages of one group, the frame's source address is preferred, and then the
    /// null address FE. Otherwise the first message counts.
    std::shared_ptr<const DescribedFrame> find(const CanFrame& frame) const;

    std::size_t frames() const { return frames_.size(); }
    struct File {
        std::string path;
        std::size_t frames = 0;  ///< number of described frames in use
    };
    const std::vector<File>& files() const { return files_; }
    const std::vector<Message>& remarks() const { return remarks_; }  ///< one sentence each

private:
    void addGroup(const std::shared_ptr<const DescribedFrame>& described);

    CanProtocol protocol_;
    std::unordered_map<std::uint32_t, std::shared_ptr<const DescribedFrame>>
        frames_;  // by frame key
    std::unordered_map<std::uint32_t, std::shared_ptr<const DescribedFrame>>
        groupsOfSource_;  // J1939 messages by parameter group and source address
    std::unordered_map<std::uint32_t, std::shared_ptr<const DescribedFrame>>
        groups_;  // J1939 messages for any other source address
    std::vector<File> files_;
    std::vector<Message> remarks_;
};

/// Reads these files into a book; null without files. Returns the Error of the first file that cannot be used.
Result<std::shared_ptr<const DbcBook>> readDbcBook(CanProtocol protocol,
                                                   const std::vector<std::string>& paths);

/// Returns the remarks of a book that may be null.
std::vector<Message> remarksOf(const std::shared_ptr<const DbcBook>& book);

/// Returns a signal's value as text: its label, possibly elided, or the digits that its scale resolves.
std::string wordOrNumber(const DbcSignal& signal, std::uint64_t bits);
std::string wordOrNumber(const DbcSignal& signal,
                         double value);  ///< for a value whose raw bits are unknown

/// Returns the value for files: the whole label, or all digits.
std::string exactWordOrNumber(const DbcSignal& signal, std::uint64_t bits);

/// Returns the signals present in a frame, as text.
std::vector<NamedValue> valuesOf(const DbcMessage& message, const CanFrame& frame);

/// Length of a reader's text about a frame that a DBC file describes: name only, or also verdict and values.
enum class FrameDepth : std::uint8_t { Name, Values };

/// Returns a reader of the protocol's frames that decodes all others with the book; a null book decodes none.
std::unique_ptr<FrameReader> frameReader(CanProtocol protocol, std::shared_ptr<const DbcBook> book,
                                         FrameDepth depth = FrameDepth::Values);

}  // namespace terratact
