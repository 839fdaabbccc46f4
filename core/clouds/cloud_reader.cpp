#include "core/clouds/cloud_reader.h"

#include <cmath>

#include "core/base/text.h"
#include "core/clouds/cloud_formats.h"
#include "core/store/csv_field.h"

namespace terratact {
namespace {

bool isNear(double coordinate)
{
    return std::abs(coordinate) <= kFarthestPoint;  // false for NaN
}

/// Returns the beginning of a sentence about a known file that is no cloud; empty: it may be one.
std::string_view otherKind(std::string_view head)
{
    using namespace std::string_view_literals;
    if (head.starts_with("LASF")) return "is LAS or LAZ; convert it to PLY or PCD";
    if (head.starts_with("\x89MCAP"sv) || head.starts_with("#ROSBAG")
        || head.starts_with("SQLite format 3"))
        return "is a recording; name the topic of its clouds with --topic";
    if (head.starts_with("\x1f\x8b"sv)) return "is compressed by gzip; unpack it";
    if (head.starts_with("PK")) return "is a ZIP archive; unpack it";
    return {};
}

bool isBinary(std::string_view head)
{
    return head.find('\0') != std::string_view::npos;
}

/// Returns true if a line of the head begins as one of a PCD header does.
bool isPcd(std::string_view head)
{
    while (!head.empty()) {
        const std::size_t end = head.find('\n');
        const std::string_view line = withoutBlanks(head.substr(0, end), " \t\r");
        for (const std::string_view word : {"VERSION", "FIELDS", "COLUMNS", "# .PCD"})
            if (line.starts_with(word)) return true;
        if (end == std::string_view::npos || !(line.empty() || line.starts_with('#'))) return false;
        head.remove_prefix(end + 1);
    }
    return false;
}

}  // namespace

void CloudReader::add(std::vector<CloudPoint>& block, const CloudPoint& point)
{
    ++points_;
    if (isNear(point.x) && isNear(point.y) && isNear(point.z))
        block.push_back(point);
    else
        ++leftOut_;
}

Result<std::unique_ptr<CloudReader>> openCloud(const std::string& path)
{
    auto file = CloudFile::open(path);
    if (!file) return file.error();
    std::string head;
    file->read(1024, head);
    file->goTo(0);
    if (head.empty()) return file->error("is empty: a point cloud was expected");
    if (isPcd(head)) return openPcd(*std::move(file));
    if (head.starts_with("ply\n") || head.starts_with("ply\r")) return openPly(*std::move(file));
    if (const auto other = otherKind(head); !other.empty()) return file->error(other);
    if (isBinary(head))
        return file->error("is no PCD, PLY or text of x y z; convert it to one of these");
    return openTextCloud(*std::move(file));
}

}  // namespace terratact
