#include "app/review_notes.h"

#include <QByteArray>
#include <QLocale>
#include <filesystem>

#include "core/file_write.h"
#include "core/learn/csv.h"

namespace terratact {
namespace {

constexpr const char* kHeader = "t_s,note";
constexpr std::size_t kMostNotes = 100'000;

std::string plain(std::string text)
{
    for (char& c : text) {
        if (c == ',') c = ';';
        if (c == '"') c = '\'';
        if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    }
    return text;
}

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
    auto csv = CsvReader::open(path);
    if (!csv) return csv.error();
    for (bool isHeader = true;; isHeader = false) {
        const Result<bool> more = csv->next();
        if (!more) return more.error();
        if (!*more) return notes;
        const auto& fields = csv->fields();
        if (isHeader) {
            if (fields.size() != 2 || fields[0] != "t_s" || fields[1] != "note")
                return csv->error("is no file of notes: expected the columns t_s,note");
            continue;
        }
        if (fields.size() != 2) return csv->error("expected a time and a note");
        if (notes.size() >= kMostNotes) return csv->error("too many notes");
        const auto time = csv->number(0, "t_s");
        if (!time) return time.error();
        notes.push_back({*time, std::string(fields[1])});
    }
}

Status writeNotes(const std::string& session, const std::vector<ReviewNote>& notes)
{
    std::string text = std::string(kHeader) + "\n";
    for (const ReviewNote& note : notes)
        text += QByteArray::number(note.time, 'g', QLocale::FloatingPointShortest).toStdString()
              + "," + plain(note.text) + "\n";
    return writeFileAtomically(notesPath(session), text);
}

}  // namespace terratact
