#include "app/figures/report/strip_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "app/figures/report/strip_figure.h"
#include "app/recording/export/strip_export.h"
#include "app/runtime/text_output.h"
#include "core/log/session_strip.h"

namespace terratact {
namespace {

constexpr int kParts = 50;  // of a session, between two reports of progress
constexpr std::array<std::string_view, 4> kStripPictures{".png", ".svg", ".pdf", ".html"};

}  // namespace

std::shared_ptr<const Strip> stripOf(SessionReader& session, const RobotModel& robot,
                                     const std::function<bool(double)>& progress)
{
    SessionStrip followed(session, robot);
    const SessionTime whole = session.end() - session.begin();
    for (int part = 1; part <= kParts; ++part) {
        followed.goTo(part == kParts ? session.end() : session.begin() + whole / kParts * part);
        if (progress && !progress(static_cast<double>(part) / kParts)) return nullptr;
    }
    return std::make_shared<const Strip>(followed.strip());
}

double groundOf(const Strip& strip)
{
    std::size_t columns = 0;
    for (const StripSection& section : strip.sections()) columns += section.columns.size();
    return kBinWidth * static_cast<double>(columns);
}

Message stripTitle(const std::string& file)
{
    if (file.empty()) return TR_NOOP("Report", "Strip of felt ground of a running drive");
    return {TR_NOOP("Report", "Strip of felt ground of %1"), file};
}

Status writeStrip(const std::string& path, const std::shared_ptr<const Strip>& strip,
                  const RobotModel& robot, const std::string& title, std::optional<int> section,
                  const Wording& wording)
{
    const bool isPly = path.ends_with(".ply");
    const bool isPicture = std::ranges::any_of(
        kStripPictures, [&](std::string_view ending) { return path.ends_with(ending); });
    if (!isPly && !isPicture && !path.ends_with(".csv"))
        return Error{path
                     + ": the ending tells the format, expected .csv, .ply, .png, .svg, .pdf or "
                       ".html"};
    const std::size_t sections = strip->sections().size();
    if (sections == 0) return Error{path + ": not written, because no ground was felt yet"};
    if (section && (*section < 1 || static_cast<std::size_t>(*section) > sections))
        return Error{fmt::format("{}: not written: there is no section {}, expected 1 to {}", path,
                                 *section, sections)};
    if (isPly) return writeText(path, stripPly(*strip, robot, section));
    std::string csv = stripCsv(*strip, robot, section);
    return isPicture ? writeStripPicture(path, strip, {title, std::move(csv)}, section, wording)
                     : writeText(path, csv);
}

}  // namespace terratact
