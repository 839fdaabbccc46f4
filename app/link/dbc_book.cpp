#include "app/link/dbc_book.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>
#include <variant>

#include "core/store/file_read.h"
#include "core/wire/absolem.h"
#include "core/wire/dbc/dbc_file.h"
#include "core/wire/dbc/dbc_number.h"
#include "core/wire/dbc/dbc_text.h"
#include "core/wire/frame_layout.h"

namespace terratact {
namespace {

constexpr std::size_t kMaxNamed = 4;  // identifiers named in one sentence

constexpr std::uint32_t kNullAddress = 0xFE;  // J1939: describes frames of any source

std::uint32_t sourceAddressOf(std::uint32_t id)
{
    return id & 0xFFU;
}

std::uint32_t keyOf(std::uint32_t id, bool extended)
{
    return id | (extended ? 0x8000'0000U : 0U);
}

CanFrame frameOf(const DbcMessage& message)
{
    return {.id = message.id, .extended = message.extended};
}

bool isOf(CanProtocol protocol, const CanFrame& frame)
{
    if (frame.extended) return false;
    if (protocol == CanProtocol::Terratact) return kindOfId(frame.id).has_value();
    const auto taken = absolemFrame(frame);
    const auto* verdict = std::get_if<AbsolemVerdict>(&taken);
    return !verdict || *verdict != AbsolemVerdict::UnknownId;
}

/// A list of identifiers of which the first few are named.
class SomeIds {
public:
    void add(const CanFrame& frame)
    {
        if (++count_ <= kMaxNamed) ids_ += (ids_.empty() ? "" : ", ") + idText(frame);
    }
    std::size_t count() const { return count_; }
    /// Returns "frame 022", "7 frames (022, 023, 024, 025 …)".
    Message text() const
    {
        if (count_ == 1) return {TR_NOOP("core", "frame %1"), ids_};
        return {TR_NOOP("core", "%1 frames (%2)"), count_, ids_ + (count_ > kMaxNamed ? " …" : "")};
    }

private:
    std::size_t count_ = 0;
    std::string ids_;
};

/// Returns the signals that do not fit in a frame, the first few named; empty if all fit.
std::string missingText(const DbcMessage& message, const CanFrame& frame)
{
    std::string names;
    std::size_t count = 0;
    for (const DbcSignal& signal : message.payload) {
        if (bitsOf(signal, frame) || !signal.selectedBy.empty()) continue;
        if (++count <= kMaxNamed) names += (names.empty() ? "" : ", ") + signal.name;
    }
    if (count == 0) return {};
    return fmt::format(", {} for {}{}",
                       frame.isCut ? "cut before it was stored, too short" : "too short", names,
                       count > kMaxNamed ? " …" : "");
}

/// Returns "by engine.dbc, source address 0x00".
std::string verdictOf(const DescribedFrame& described, const CanFrame& frame)
{
    const DbcMessage& message = described.message;
    return "by " + described.file
         + (message.isParameterGroup
                ? fmt::format(", source address 0x{:02X}", sourceAddressOf(frame.id))
                : std::string())
         + missingText(message, frame);
}

class DescribingReader final : public FrameReader {
public:
    DescribingReader(CanProtocol protocol, std::shared_ptr<const DbcBook> book, FrameDepth depth)
        : reader_(frameReader(protocol)), book_(std::move(book)), depth_(depth)
    {
    }
    FrameWords read(const CanFrame& frame, double now) override
    {
        FrameWords words = reader_->read(frame, now);
        if (words.trouble != FrameTrouble::Unknown) return words;
        const auto described = book_->find(frame);
        if (!described) return words;
        if (depth_ == FrameDepth::Name) return {.name = described->message.name};
        return {.name = described->message.name,
                .verdict = verdictOf(*described, frame),
                .trouble = FrameTrouble::None,
                .values = valuesOf(described->message, frame)};
    }

private:
    std::unique_ptr<FrameReader> reader_;
    std::shared_ptr<const DbcBook> book_;
    FrameDepth depth_;
};

}  // namespace

Status DbcBook::add(const std::string& path)
{
    std::error_code ignored;
    const auto type = std::filesystem::status(path, ignored).type();
    if (type == std::filesystem::file_type::fifo || type == std::filesystem::file_type::character)
        return fileError(
            path, TR_NOOP("core", "is no regular file, which would be waited for: copy it to one"));
    Result<DbcFile> file = readDbc(path);
    if (!file) return file.error();
    SomeIds ours;
    std::map<std::string, SomeIds> theirs;  // grouped by the file that describes them
    File& added = files_.emplace_back(File{path});
    for (DbcMessage& message : file->messages) {
        const CanFrame frame = frameOf(message);
        if (isOf(protocol_, frame)) {
            ours.add(frame);
            continue;
        }
        const auto described = std::make_shared<const DescribedFrame>(
            DescribedFrame{std::move(message), std::filesystem::path(path).filename().string()});
        if (described->message.isParameterGroup) addGroup(described);
        const auto [place, isNew] = frames_.emplace(keyOf(frame.id, frame.extended), described);
        if (isNew)
            ++added.frames;
        else
            theirs[place->second->file].add(frame);
    }
    remarks_.insert(remarks_.end(), file->warnings.begin(), file->warnings.end());
    if (ours.count() > 0)
        remarks_.push_back(
            fileError(path,
                      Message(TR_NOOP("core", "%1: ignored; the robot's protocol already uses "
                                              "this identifier"),
                              ours.text()))
                .message);
    for (const auto& [other, ids] : theirs)
        remarks_.push_back(
            fileError(path, Message(TR_NOOP("core", "%1: ignored; %2 already describes it"),
                                    ids.text(), other))
                .message);
    return Done{};
}

void DbcBook::addGroup(const std::shared_ptr<const DescribedFrame>& described)
{
    const std::uint32_t id = described->message.id, group = parameterGroupOf(id);
    groupsOfSource_.emplace(group | sourceAddressOf(id), described);
    auto& ofOthers = groups_.emplace(group, described).first->second;
    const bool isForAny = sourceAddressOf(ofOthers->message.id) == kNullAddress;
    if (!isForAny && sourceAddressOf(id) == kNullAddress) ofOthers = described;
}

std::shared_ptr<const DescribedFrame> DbcBook::find(const CanFrame& frame) const
{
    if (frame.error || frame.remote) return nullptr;
    const auto found = frames_.find(keyOf(frame.id, frame.extended));
    if (found != frames_.end()) return found->second;
    if (!frame.extended) return nullptr;
    const std::uint32_t group = parameterGroupOf(frame.id);
    const auto ofSource = groupsOfSource_.find(group | sourceAddressOf(frame.id));
    if (ofSource != groupsOfSource_.end()) return ofSource->second;
    const auto ofAny = groups_.find(group);
    return ofAny == groups_.end() ? nullptr : ofAny->second;
}

Result<std::shared_ptr<const DbcBook>> readDbcBook(CanProtocol protocol,
                                                   const std::vector<std::string>& paths)
{
    if (paths.empty()) return std::shared_ptr<const DbcBook>();
    auto book = std::make_shared<DbcBook>(protocol);
    for (const std::string& path : paths)
        if (Status added = book->add(path); !added) return added.error();
    return std::shared_ptr<const DbcBook>(std::move(book));
}

std::vector<Message> remarksOf(const std::shared_ptr<const DbcBook>& book)
{
    return book ? book->remarks() : std::vector<Message>();
}

std::string wordOrNumber(const DbcSignal& signal, double value)
{
    if (const std::string* word = wordOf(signal, value)) return shownDbcText(*word);
    return shownText(signal, value);
}

std::string wordOrNumber(const DbcSignal& signal, std::uint64_t bits)
{
    if (const std::string* word = wordOfBits(signal, bits)) return shownDbcText(*word);
    return shownText(signal, bits);
}

std::string exactWordOrNumber(const DbcSignal& signal, std::uint64_t bits)
{
    const std::string* word = wordOfBits(signal, bits);
    return word ? *word : exactText(signal, bits);
}

std::vector<NamedValue> valuesOf(const DbcMessage& message, const CanFrame& frame)
{
    std::vector<std::optional<std::uint64_t>> bits(message.payload.size());
    decodeBits(message, frame, bits);
    std::vector<NamedValue> said;
    for (std::size_t i = 0; i < bits.size(); ++i) {
        if (!bits[i]) continue;
        const DbcSignal& signal = message.payload[i];
        NamedValue value{signal.name, wordOrNumber(signal, *bits[i]), signal.unit};
        std::string exact = exactWordOrNumber(signal, *bits[i]);
        if (exact != value.value) value.exact = std::move(exact);
        said.push_back(std::move(value));
    }
    return said;
}

std::unique_ptr<FrameReader> frameReader(CanProtocol protocol, std::shared_ptr<const DbcBook> book,
                                         FrameDepth depth)
{
    if (!book) return frameReader(protocol);
    return std::make_unique<DescribingReader>(protocol, std::move(book), depth);
}

}  // namespace terratact
