#include "app/figures/mission_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include "app/figures/mission_log.h"
#include "app/figures/payload_facts.h"
#include "app/figures/strip_figure.h"
#include "app/recording/session_text.h"
#include "app/recording/what_if.h"
#include "core/log/session_strip.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

std::ptrdiff_t decisionsNamed(const SessionReader& session, std::string_view subject)
{
    return std::ranges::count_if(session.events(), [&](const EventRow& event) {
        return event.kind == EventKind::Decision && event.subject == subject;
    });
}

std::ptrdiff_t eventsOfKind(const SessionReader& session, EventKind kind)
{
    return std::ranges::count(session.events(), kind, &EventRow::kind);
}

/// Returns "trail 12 (median 0.310 s), local 3 (median 0.020 s)".
std::string methodsText(const SessionReader& session)
{
    std::map<std::string, std::vector<double>> seconds;
    for (const EstimateRow& row : session.estimates())
        seconds[std::string(name(row.estimate.side[0].settings.method))].push_back(row.seconds);
    std::string text;
    for (auto& [method, times] : seconds) {
        const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
        std::ranges::nth_element(times, middle);
        text += fmt::format("{}{} {} (median {:.3f} s)", text.empty() ? "" : ", ", method,
                            times.size(), *middle);
    }
    return text.empty() ? "nothing was estimated" : text;
}

std::string durationText(const SessionReader& session)
{
    const double seconds = secondsOf(session.end() - session.begin());
    const auto whole = static_cast<std::int64_t>(seconds);
    return fmt::format("{}:{:02}:{:02} h ({:.3f} s)", whole / 3600, whole / 60 % 60, whole % 60,
                       seconds);
}

bool holdsEverything(const SessionVerification& found)
{
    return found.damage.empty() && !found.broken;
}

DocumentPart sessionPart(const SessionReader& session, const RobotModel& robot)
{
    const SessionStart& start = session.start();
    const auto at = [&](SessionTime time) { return utcText(wallTimeOf(start, time)); };
    return {
        .heading = "The session",
        .note = {},
        .facts =
            {{"file", std::filesystem::path(session.path()).filename().string()},
             {"begins", at(session.begin())},
             {"ends", at(session.end())},
             {"lasts", durationText(session)},
             {"robot", robot.name},
             {"source", fmt::format("{}, bus {}, {}", start.source, start.bus,
                                    start.transmits ? "commands could be sent" : "listened only")},
             {"recorded by", start.program},
             {"closed",
              session.sealed() ? "yes, sealed" : "NO: still being recorded, or its program died"},
             {"frames", fmt::format("{}", session.frameCount())},
             {"estimates", fmt::format("{} of {} scenes; by method: {}", session.estimates().size(),
                                       session.scenes().size(), methodsText(session))},
             {"probes",
              fmt::format("proposed {}, approved {}, refused {}", session.proposals().size(),
                          decisionsNamed(session, "approve"), decisionsNamed(session, "refuse"))},
             {"operator",
              fmt::format("decisions {}, of these stop {}, halt {}, abort {}; "
                          "markers {}",
                          eventsOfKind(session, EventKind::Decision),
                          decisionsNamed(session, "stop"), decisionsNamed(session, "halt"),
                          decisionsNamed(session, "abort"),
                          eventsOfKind(session, EventKind::Marker))}},
        .pictures = {},
        .table = {}};
}

DocumentPart hashesPart(const SessionReader& session, const SessionVerification& found)
{
    const SessionStart& start = session.start();
    DocumentPart part{
        .heading = "Hashes",
        .note = "Each hash is SHA-256. The last link of the chain proves the session if it is "
                "known from elsewhere.",
        .facts = {{"result", holdsEverything(found)
                                 ? fmt::format("every hash holds: {} batches, {} frames, {} events",
                                               found.batches, found.frames, found.events)
                                 : "PARTS ARE NOT WHAT WAS RECORDED"},
                  {"last link", found.chain},
                  {"robot file", start.robotHash}},
        .pictures = {},
        .table = {}};
    for (const ModelRow& model : session.models()) {
        part.facts.emplace_back("model", fmt::format("{}, {}, from {} on", model.name, model.hash,
                                                     momentText(model.time)));
        if (!model.trailName.empty())
            part.facts.emplace_back("networks",
                                    fmt::format("{}, {}", model.trailName, model.trailHash));
    }
    if (found.broken)
        part.facts.emplace_back("broken",
                                "nothing is proven from " + damageText(start, *found.broken));
    for (const SessionDamage& damage : found.damage)
        part.facts.emplace_back("damage", damageText(start, damage));
    return part;
}

/// Returns one sentence that says how far the report can be relied on.
std::string summaryOf(const SessionReader& session, const SessionVerification& found)
{
    return fmt::format("{}, {}. {}{}", utcText(wallTimeOf(session.start(), session.begin())),
                       durationText(session),
                       holdsEverything(found)
                           ? "Every hash holds."
                           : "PARTS ARE NOT WHAT WAS RECORDED: see Hashes. They are left out.",
                       session.sealed() ? "" : " The session was not closed.");
}

}  // namespace

Result<ReportDocument> missionReportOf(SessionReader& session,
                                       const std::function<bool(double)>& progress,
                                       const std::shared_ptr<const DbcBook>& book)
{
    const auto robot = robotOf(session);
    if (!robot) return robot.error();
    bool goesOn = true;
    const SessionVerification found =
        session.verify([&](double share) { return goesOn = !progress || progress(0.4 * share); });
    if (!goesOn) return fileError(session.path(), "no report: ended before all was read");
    SessionStrip followed(session, *robot);
    followed.goTo(session.end());
    const auto strip = std::make_shared<const Strip>(followed.strip());
    auto decisions = missionDecisions(
        session, *robot, [&](double share) { return !progress || progress(0.4 + 0.6 * share); });
    if (!decisions) return decisions.error();
    ReportDocument document{
        .title = fmt::format("Mission report of {}",
                             std::filesystem::path(session.path()).filename().string()),
        .summary = summaryOf(session, found),
        .parts = {sessionPart(session, *robot)}};
    for (auto& fact : payloadFacts(session, book, session.end()))
        document.parts[0].facts.push_back(std::move(fact));
    document.parts.push_back(stripPart(strip));
    document.parts.push_back(std::move(*decisions));
    document.parts.push_back(missionAlarms(session));
    document.parts.push_back(missionSettings(session));
    document.parts.push_back(hashesPart(session, found));
    return document;
}

}  // namespace terratact
