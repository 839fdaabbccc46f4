#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/bags/bag_file.h"
#include "core/base/result.h"

namespace terratact {

/// File of lines and bytes that is read in pieces: a cloud's header and its points.
class CloudFile {
public:
    static constexpr std::size_t kMaxLine = 65'536;     ///< [bytes]
    static constexpr std::size_t kMaxPadding = 65'536;  ///< [bytes]

    /// Errors are those of BagFile::open().
    static Result<CloudFile> open(const std::string& path);

    /// Reads the next line without its end (LF, CR LF) into `line`. Returns false after the last. Errors
    /// name the line: it is longer than kMaxLine.
    Result<bool> line(std::string& line);

    /// Reads up to `count` bytes into `into`. Returns their number; fewer than `count` at the end.
    std::size_t read(std::size_t count, std::string& into);

    void goTo(std::uint64_t offset);

    std::uint64_t at() const { return file_.at() - (buffer_.size() - used_); }
    std::uint64_t left() const { return file_.size() - at(); }
    std::uint64_t lines() const { return lines_; }  ///< lines read so far
    const std::string& path() const { return path_; }

    /// Looks behind the last point, here. Zeros, at most kMaxPadding, are a remark: the Point Cloud Library fills its
    /// files so. Returns it; empty: the file ends here. Errors: other bytes. points: "1000 points".
    Result<std::string> behind(std::string_view points);
    Error error(std::string_view cause) const;  ///< "file: cause"
    Error
    lineError(std::string_view cause) const;  ///< "file: line 7: cause", of the line read last
    Error lineError(std::string_view cause, std::uint64_t line) const;  ///< of another line

private:
    CloudFile(std::string path, BagFile file) : path_(std::move(path)), file_(std::move(file)) {}
    bool fill();

    std::string path_;
    BagFile file_;
    std::string buffer_;
    std::size_t used_ = 0;
    std::uint64_t lines_ = 0;
};

}  // namespace terratact
