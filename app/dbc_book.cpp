#include "app/dbc_book.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>
#include <variant>

#include "core/file_read.h"
#include "core/wire/absolem.h"
#include "core/wire/dbc_file.h"
#include "core/wire/frame_layout.h"

namespace terratact {
namespace {

constexpr std::size_t kMostNamed = 4;  // in a sentence about many

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

/// Identifiers, the first few named.
class SomeIds {
public:
    void add(const CanFrame& frame)
    {
        if (++count_ <= kMostNamed) ids_ += (ids_.empty() ? "" : ", ") + idText(frame);
    }
    std::size_t count() const { return count_; }
    /// "frame 022", "7 frames (022, 023, 024, 025 …)"
    std::string text() const
    {
        if (count_ == 1) return "frame " + ids_;
        return fmt::format("{} frames ({}{})", count_, ids_, count_ > kMostNamed ? " …" : "");
    }

private:
    std::size_t count_ = 0;
    std::string ids_;
};

/// How many digits behind the point show every step of a scale; of one that never ends, so many as tell its steps
/// apart.
int digitsOf(double scale)
{
    constexpr int kMostDigits = 6;
    const double size = std::abs(scale);
    for (int digits = 0; digits <= kMostDigits; ++digits) {
        const double steps = size * std::pow(10.0, digits);
        if (std::abs(steps - std::round(steps)) <= 1e-9 * steps) return digits;
    }
    return std::max(0, static_cast<int>(std::ceil(-std::log10(size))) + 1);
}

class DescribingReader final : public FrameReader {
public:
    DescribingReader(CanProtocol protocol, std::shared_ptr<const DbcBook> book)
        : reader_(frameReader(protocol)), book_(std::move(book))
    {
    }
    FrameWords read(const CanFrame& frame, double now) override
    {
        FrameWords words = reader_->read(frame, now);
        if (words.trouble != FrameTrouble::Unknown) return words;
        const auto described = book_->find(frame);
        if (!described) return words;
        return {.name = described->message.name,
                .verdict = "by " + described->file,
                .trouble = FrameTrouble::None,
                .values = valuesOf(described->message, frame)};
    }

private:
    std::unique_ptr<FrameReader> reader_;
    std::shared_ptr<const DbcBook> book_;
};

}  // namespace

Status DbcBook::add(const std::string& path)
{
    std::error_code ignored;
    const auto type = std::filesystem::status(path, ignored).type();
    if (type == std::filesystem::file_type::fifo || type == std::filesystem::file_type::character)
        return fileError(path, "is no regular file, which would be waited for: copy it to one");
    Result<DbcFile> file = readDbc(path);
    if (!file) return file.error();
    SomeIds ours;
    std::map<std::string, SomeIds> theirs;  // by the file that has them
    File& added = files_.emplace_back(File{path});
    for (DbcMessage& message : file->messages) {
        const CanFrame frame = frameOf(message);
        if (isOf(protocol_, frame)) {
            ours.add(frame);
            continue;
        }
        const auto described = std::make_shared<const DescribedFrame>(
            DescribedFrame{std::move(message), std::filesystem::path(path).filename().string()});
        const auto [place, isNew] = frames_.emplace(keyOf(frame.id, frame.extended), described);
        if (isNew)
            ++added.frames;
        else
            theirs[place->second->file].add(frame);
    }
    remarks_.insert(remarks_.end(), file->warnings.begin(), file->warnings.end());
    if (ours.count() > 0)
        remarks_.push_back(fileError(path, ours.text()
                                               + ": the robot's protocol has that "
                                                 "identifier and is what counts")
                               .text);
    for (const auto& [other, ids] : theirs)
        remarks_.push_back(
            fileError(path, fmt::format("{}: {} describes that already and is what counts",
                                        ids.text(), other))
                .text);
    return Done{};
}

std::shared_ptr<const DescribedFrame> DbcBook::find(const CanFrame& frame) const
{
    if (frame.error || frame.remote) return nullptr;
    const auto found = frames_.find(keyOf(frame.id, frame.extended));
    return found == frames_.end() ? nullptr : found->second;
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

std::vector<std::string> remarksOf(const std::shared_ptr<const DbcBook>& book)
{
    return book ? book->remarks() : std::vector<std::string>();
}

std::string wordOrNumber(const DbcSignal& signal, double value)
{
    constexpr double kLargest = 1e12;
    constexpr int kMostDigits = 9;
    if (const std::string* word = wordOf(signal, value)) return *word;
    const bool isFloating =
        signal.type == DbcSignal::Type::Float || signal.type == DbcSignal::Type::Double;
    const int digits = std::max(digitsOf(signal.scale), digitsOf(signal.offset));
    if (isFloating || std::abs(value) >= kLargest || digits > kMostDigits)
        return fmt::format("{:.7g}", value + 0.0);
    return fmt::format("{:.{}f}", value + 0.0, digits);
}

std::vector<NamedValue> valuesOf(const DbcMessage& message, const CanFrame& frame)
{
    std::vector<std::optional<double>> values(message.payload.size());
    decode(message, frame, values);
    std::vector<NamedValue> said;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (values[i])
            said.push_back({message.payload[i].name, wordOrNumber(message.payload[i], *values[i]),
                            message.payload[i].unit});
    return said;
}

std::unique_ptr<FrameReader> frameReader(CanProtocol protocol, std::shared_ptr<const DbcBook> book)
{
    if (!book) return frameReader(protocol);
    return std::make_unique<DescribingReader>(protocol, std::move(book));
}

}  // namespace terratact
