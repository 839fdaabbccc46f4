#include "app/review_notes.h"

#include <QByteArray>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "app/csv_field.h"
#include "core/file_read.h"
#include "core/file_write.h"
#include "core/text.h"

namespace terratact {
namespace {

constexpr const char* kHeader = "t_s,note";
constexpr std::size_t kMostNotes = 100'000;

constexpr std::size_t kMostBytes = 64U << 20U;

/// The records of a file of notes, one after the other.
class NoteFile {
public:
    NoteFile(std::string path, std::string_view text) : path_(std::move(path)), rest_(text) {}

    bool atEnd() const { return rest_.empty(); }
    Error error(const std::string& cause) const
    {
        return fileError(path_, "line " + std::to_string(line_) + ": " + cause);
    }

    /// Two fields, or an Error.
    Result<std::pair<std::string, std::string>> next()
    {
        const std::string_view before = rest_;
        const auto time = takeCsvField(rest_);
        if (!time || !rest_.starts_with(',')) return error("expected a time and a note");
        rest_.remove_prefix(1);
        auto note = takeCsvField(rest_);
        if (!note) return error("a quote does not end");
        if (rest_.starts_with('\r')) rest_.remove_prefix(1);
        if (rest_.empty()) return error("is torn: no line end");
        if (!rest_.starts_with('\n')) return error("expected a time and a note");
        rest_.remove_prefix(1);
        const std::string_view record = before.substr(0, before.size() - rest_.size());
        line_ += std::count(record.begin(), record.end(), '\n');
        return std::pair(*time, std::move(*note));
    }

private:
    std::string path_;
    std::string_view rest_;
    std::ptrdiff_t line_ = 1;
};

}  // namespace

std::string notesPath(const std::string& session)
{
    return session + ".notes.csv";
}

Result<std::vector<ReviewNote>> readNotes(const std::string& session)
{
    const std::string path = notesPath(session);
    std::vector<ReviewNote> notes;
    std::error_code none;
    if (!std::filesystem::exists(path, none)) return notes;
    const auto text = readFile(path, kMostBytes);
    if (!text) return text.error();
    NoteFile file(path, *text);
    for (bool isHeader = true; isHeader || !file.atEnd(); isHeader = false) {
        if (notes.size() >= kMostNotes) return file.error("too many notes");
        const NoteFile here = file;  // whose line errors name
        auto record = file.next();
        if (!record) return record.error();
        const auto& [time, note] = *record;
        if (isHeader) {
            if (time != "t_s" || note != "note")
                return here.error("is no file of notes: expected the columns t_s,note");
            continue;
        }
        const auto seconds = numberFrom(time);
        if (!seconds || !std::isfinite(*seconds)) return here.error("t_s is no number");
        notes.push_back({*seconds, note});
    }
    return notes;
}

Status writeNotes(const std::string& session, const std::vector<ReviewNote>& notes)
{
    std::string text = std::string(kHeader) + "\n";
    for (const ReviewNote& note : notes)
        text += QByteArray::number(note.time, 'g', QLocale::FloatingPointShortest).toStdString()
              + "," + csvField(note.text) + "\n";
    return writeFileAtomically(notesPath(session), text);
}

}  // namespace terratact
