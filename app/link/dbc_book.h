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

/// A frame of a DBC file.
struct DescribedFrame {
    DbcMessage message;
    std::string file;  ///< without its folders
};

/// What DBC files say of frames that the robot's protocol does not know.  The protocol is never overruled, and of two
/// files that describe the same identifier the first counts.
class DbcBook {
public:
    explicit DbcBook(CanProtocol protocol = CanProtocol::Terratact) : protocol_(protocol) {}

    /// Adds a regular file.  What of it is not used, is among the remarks from then on.
    Status add(const std::string& path);

    /// Null: no file describes it.  Remote, error and the protocol's own frames are never described.  A parameter group
    /// of J1939 is found from any source address; a message with the very identifier comes first.
    std::shared_ptr<const DescribedFrame> find(const CanFrame& frame) const;

    std::size_t frames() const { return frames_.size(); }
    struct File {
        std::string path;
        std::size_t frames = 0;  ///< that are used
    };
    const std::vector<File>& files() const { return files_; }
    const std::vector<std::string>& remarks() const { return remarks_; }  ///< a sentence each

private:
    CanProtocol protocol_;
    std::unordered_map<std::uint32_t, std::shared_ptr<const DescribedFrame>> frames_;  // by keys
    std::unordered_map<std::uint32_t, std::shared_ptr<const DescribedFrame>> groups_;  // of J1939
    std::vector<File> files_;
    std::vector<std::string> remarks_;
};

/// A book of these files; null of none, and the Error of the first that cannot be used.
Result<std::shared_ptr<const DbcBook>> readDbcBook(CanProtocol protocol,
                                                   const std::vector<std::string>& paths);

/// Those of a book that may be null.
std::vector<std::string> remarksOf(const std::shared_ptr<const DbcBook>& book);

/// The value of a signal for people: its word, which may be cut, or a number with the digits that its scale resolves.
std::string wordOrNumber(const DbcSignal& signal, std::uint64_t bits);
std::string wordOrNumber(const DbcSignal& signal,
                         double value);  ///< of a value whose bits are not known

/// The same for files: the whole word, or all digits.
std::string exactWordOrNumber(const DbcSignal& signal, std::uint64_t bits);

/// The signals of a frame that are in it, for people.
std::vector<NamedValue> valuesOf(const DbcMessage& message, const CanFrame& frame);

/// A reader of the protocol's frames that puts all others into the words of the book; null: there is none.
std::unique_ptr<FrameReader> frameReader(CanProtocol protocol, std::shared_ptr<const DbcBook> book);

}  // namespace terratact
