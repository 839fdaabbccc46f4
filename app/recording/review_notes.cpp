#include "app/recording/review_notes.h"

#include <array>
#include <filesystem>
#include <utility>

#include "core/base/text.h"
#include "core/store/csv_reader.h"
#include "core/store/csv_text.h"
#include "core/store/file_write.h"

namespace terratact {
namespace {

constexpr const char* kHeader = "t_s,note";
constexpr std::size_t kMaxNotes = 100'000;

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
    Result<CsvReader> csv = CsvReader::open(path);
    if (!csv) return csv.error();
    if (const auto header = csv->next(); !header) return header.error();
    if (const auto& names = csv->fields();
        names.size() != 2 || names[0] != "t_s" || names[1] != "note")
        return csv->error(TR_NOOP("core", "is no file of notes: expected the columns t_s,note"));
    csv->useAsHeader({});
    for (;;) {
        const Result<bool> more = csv->next();
        if (!more) return more.error();
        if (!*more) return notes;
        if (notes.size() >= kMaxNotes) return csv->error(TR_NOOP("core", "too many notes"));
        const Result<double> time = csv->number(0, "t_s");
        if (!time) return time.error();
        notes.push_back({*time, csvText(csv->fields()[1])});
    }
}

Status writeNotes(const std::string& session, const std::vector<ReviewNote>& notes)
{
    std::string text = std::string(kHeader) + "\n";
    for (const ReviewNote& note : notes)
        text += csvLine(std::array{numberText(note.time), note.text});
    return writeFileAtomically(notesPath(session), text, Access::OwnerAlways);
}

}  // namespace terratact
