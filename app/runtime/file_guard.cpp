#include "app/runtime/file_guard.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "app/runtime/text_output.h"
#include "core/learn/model/model_card.h"
#include "core/store/content_kind.h"
#include "core/store/file_read.h"
#include "core/store/file_write.h"

namespace terratact {
namespace {

/// Identity of the file that a name leads to.
struct Identity {
    std::string name;  ///< name in messages
    std::optional<std::pair<dev_t, ino_t>> file;
    std::string place;  ///< path after links, if the file does not exist

    bool operator==(const Identity& other) const
    {
        if (file || other.file) return file == other.file;
        return !place.empty() && place == other.place;
    }
};

std::optional<std::pair<dev_t, ino_t>> fileOf(const struct stat& found)
{
    return S_ISREG(found.st_mode) ? std::optional(std::pair(found.st_dev, found.st_ino))
                                  : std::nullopt;
}

/// Returns the identity of an open file: standard input or output. A file that is not regular equals no other.
Identity identityOf(int descriptor, std::string name)
{
    struct stat found {};
    const bool known = ::fstat(descriptor, &found) == 0;
    return {std::move(name), known ? fileOf(found) : std::nullopt, {}};
}

Identity identityOf(const std::string& path)
{
    struct stat found {};
    if (::stat(path.c_str(), &found) == 0) return {path, fileOf(found), {}};
    std::error_code none;
    const auto place =
        std::filesystem::weakly_canonical(std::filesystem::absolute(path, none), none);
    return {path, std::nullopt, place.string()};
}

Identity inputIdentity(const std::string& path)
{
    return path == "-" ? identityOf(STDIN_FILENO, "the standard input") : identityOf(path);
}

Identity outputIdentity(const std::string& path)
{
    return isStandardOutput(path) ? identityOf(STDOUT_FILENO, "the standard output")
                                  : identityOf(path);
}

/// Checks that `output` is none of `files`.
Status checkApart(const Identity& output, const Paths& files)
{
    for (const std::string& path : files) {
        const Identity input = inputIdentity(path);
        if (!(output == input)) continue;
        const std::string what =
            output.name == input.name ? "is read by this command" : "is the same file as " + path;
        return fileError(output.name,
                         what + ", and no input is overwritten: name another file to write");
    }
    return Done{};
}

/// The files a command writes; add() checks each against all earlier ones.
class Written {
public:
    Status add(const std::string& path)
    {
        const Identity output = outputIdentity(path);
        for (const Identity& other : files_)
            if (output == other)
                return fileError(output.name, "is the same file as " + other.name
                                                  + ", and both are written: name another file");
        files_.push_back(output);
        if (isStandardOutput(path)) return Done{};
        if (isStream(path)) return checkLinks(path);
        return checkReplaceable(path);
    }

    const std::vector<Identity>& files() const { return files_; }

private:
    std::vector<Identity> files_;
};

}  // namespace

Paths companionsOf(const std::string& input)
{
    switch (contentKindOfFile(input)) {
    case ContentKind::Sqlite: return {cardPath(input)};
    case ContentKind::Session: return {input + ".notes.csv", input + "-wal"};
    default: return {};
    }
}

Status checkCommandFiles(const CommandFiles& files)
{
    Written written;
    bool onStandardOutput = false;
    for (const std::string& path : files.outputs) {
        onStandardOutput = onStandardOutput || isStandardOutput(path);
        const Identity output = outputIdentity(path);
        if (Status s = checkApart(output, files.inputs); !s) return s;
        if (Status s = checkApart(output, files.companions); !s) return s;
        if (Status s = written.add(path); !s) return s;
        if (isSessionName(path) && std::ranges::count(files.sessions, path) == 0)
            return fileError(path, "ends in .tts, as sessions do, and is none: name another file");
    }
    for (const std::string& path : files.updates) {
        if (Status s = checkApart(outputIdentity(path), files.inputs); !s) return s;
        if (Status s = written.add(path); !s) return s;
    }
    if (onStandardOutput) return Done{};
    if (Status s = checkApart(outputIdentity("-"), files.inputs); !s) return s;
    return written.add("-");
}

}  // namespace terratact
