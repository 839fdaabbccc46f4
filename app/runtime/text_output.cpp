#include "app/runtime/text_output.h"

#include <ext/stdio_filebuf.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <iostream>
#include <system_error>
#include <utility>

#include "core/base/text.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

/// Writes to a descriptor and closes it.
class DescriptorStream final : public std::ostream {
public:
    explicit DescriptorStream(int descriptor)
        : std::ostream(nullptr), buffer_(descriptor, std::ios::out | std::ios::binary)
    {
        rdbuf(&buffer_);
    }
    /// A failure sets badbit.
    void close()
    {
        if (!buffer_.close()) setstate(std::ios::badbit);
    }

private:
    __gnu_cxx::stdio_filebuf<char> buffer_;
};

/// Passes whole lines to a terminal, as printableLines(), and the unfinished one at its end.
class TerminalBuffer final : public std::streambuf {
public:
    explicit TerminalBuffer(std::streambuf* terminal) : terminal_(terminal) {}
    ~TerminalBuffer() override { (void)sync(); }
    TerminalBuffer(const TerminalBuffer&) = delete;
    TerminalBuffer& operator=(const TerminalBuffer&) = delete;

protected:
    int overflow(int character) override
    {
        if (character == traits_type::eof()) return traits_type::not_eof(character);
        line_ += traits_type::to_char_type(character);
        if (line_.back() == '\n' && sync() != 0) return traits_type::eof();
        return character;
    }
    int sync() override
    {
        const std::string line = printableLines(std::exchange(line_, {}));
        const auto size = static_cast<std::streamsize>(line.size());
        return terminal_->sputn(line.data(), size) == size ? terminal_->pubsync() : -1;
    }

private:
    std::streambuf* terminal_;
    std::string line_;
};

/// Writes to a terminal. stream: of the terminal.
class TerminalStream final : public std::ostream {
public:
    explicit TerminalStream(std::unique_ptr<std::ostream> stream)
        : std::ostream(nullptr), terminal_(std::move(stream)), buffer_(terminal_->rdbuf())
    {
        rdbuf(&buffer_);
    }

private:
    std::unique_ptr<std::ostream> terminal_;
    TerminalBuffer buffer_;
};

std::unique_ptr<std::ostream> streamFor(int descriptor, std::unique_ptr<std::ostream> stream)
{
    if (::isatty(descriptor) == 0) return stream;
    return std::make_unique<TerminalStream>(std::move(stream));
}

}  // namespace

bool isStandardOutput(std::string_view path)
{
    constexpr std::array<std::string_view, 4> kNames{"-", "/dev/stdout", "/dev/fd/1",
                                                     "/proc/self/fd/1"};
    return std::find(kNames.begin(), kNames.end(), path) != kNames.end();
}

bool isStream(const std::string& path)
{
    struct stat found {};
    return ::stat(path.c_str(), &found) == 0 && (S_ISFIFO(found.st_mode) || S_ISCHR(found.st_mode));
}

namespace {

bool takesAtOnce(const std::string& path)
{
    return isStandardOutput(path) || isStream(path);
}

}  // namespace

std::FILE* messagesBeside(const std::string& out)
{
    return isStandardOutput(out) ? stderr : stdout;
}

TextOutput::TextOutput(std::string path, std::optional<NewFile> file,
                       std::unique_ptr<std::ostream> stream)
    : path_(std::move(path)), file_(std::move(file)), stream_(std::move(stream))
{
}

Result<TextOutput> TextOutput::begin(const std::string& path)
{
    if (isStandardOutput(path))
        return TextOutput(
            "the standard output", std::nullopt,
            streamFor(STDOUT_FILENO, std::make_unique<std::ostream>(std::cout.rdbuf())));
    std::optional<NewFile> file;
    if (isStream(path)) {
        if (Status direct = checkLinks(path); !direct) return direct.error();
    } else {
        Result<NewFile> begun = NewFile::begin(path);
        if (!begun) return begun.error();
        file = *std::move(begun);
    }
    const int descriptor =
        file ? file->openTemporary() : ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0)
        return fileError(path, "cannot be written: " + std::generic_category().message(errno),
                         errno);
    return TextOutput(path, std::move(file),
                      streamFor(descriptor, std::make_unique<DescriptorStream>(descriptor)));
}

Status TextOutput::end()
{
    stream_->flush();
    if (auto* const opened = dynamic_cast<DescriptorStream*>(stream_.get())) opened->close();
    if (!*stream_) return fileError(path_, "cannot be written: is the disk full?");
    return Done{};
}

Status TextOutput::commit()
{
    if (Status ended = end(); !ended) return ended;
    return file_ ? file_->commit() : Status(Done{});
}

Status TextOutput::addTo(FileGroup& files)
{
    if (Status ended = end(); !ended || !file_) return ended;
    if (Status flushed = file_->flush(); !flushed) return flushed;
    files.add(*std::move(file_));
    return Done{};
}

Status writeText(const std::string& path, std::string_view content)
{
    Result<TextOutput> output = TextOutput::begin(path);
    if (!output) return output.error();
    output->stream() << content;
    return output->commit();
}

Status addText(FileGroup& files, const std::string& path, std::string_view content)
{
    return takesAtOnce(path) ? writeText(path, content) : files.add(path, content);
}

Status writeTogether(FileGroup& files, const std::string& path, std::string_view content)
{
    const bool streams = takesAtOnce(path);
    if (!streams)
        if (Status added = files.add(path, content); !added) return added;
    if (Status written = files.commit(); !written) return written;
    return streams ? writeText(path, content) : Status(Done{});
}

}  // namespace terratact
