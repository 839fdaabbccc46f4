#include "app/figures/report/mission_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include "app/figures/report/mission_log.h"
#include "app/figures/report/payload_facts.h"
#include "app/figures/report/strip_figure.h"
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
Message methodsText(const SessionReader& session)
{
    std::map<std::string, std::vector<double>> seconds;
    for (const EstimateRow& row : session.estimates())
        seconds[std::string(name(row.estimate.side[0].settings.method))].push_back(row.seconds);
    if (seconds.empty()) return TR_NOOP("Report", "nothing was estimated");
    std::vector<Message> parts;
    parts.reserve(seconds.size());
    for (auto& [method, times] : seconds) {
        const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
        std::ranges::nth_element(times, middle);
        parts.emplace_back(TR_NOOP("Report", "%1 %2 (median %3 s)"), method, times.size(),
                           fixed(*middle, 3));
    }
    return Message::listed(std::move(parts), ", ");
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

Message sourceText(const SessionStart& start)
{
    return {start.transmits ? TR_NOOP("Report", "%1, bus %2, commands could be sent")
                            : TR_NOOP("Report", "%1, bus %2, listened only"),
            sourceMessage(start.source), start.bus};
}

Message countsText(const SessionReader& session)
{
    return {TR_NOOP("Report", "decisions %1, of these stop %2, halt %3, abort %4; markers %5"),
            eventsOfKind(session, EventKind::Decision),
            decisionsNamed(session, "stop"),
            decisionsNamed(session, "halt"),
            decisionsNamed(session, "abort"),
            eventsOfKind(session, EventKind::Marker)};
}

DocumentPart sessionPart(const SessionReader& session, const RobotModel& robot,
                         const Wording& wording)
{
    const SessionStart& start = session.start();
    const auto at = [&](SessionTime time) { return utcText(wallTimeOf(start, time)); };
    DocumentPart part;
    part.heading = wording(TR_NOOP("Report", "The session"));
    const auto add = [&](SourceText what, const Message& text) {
        part.facts.emplace_back(wording(what), wording(text));
    };
    const auto addPlain = [&](SourceText what, std::string text) {
        add(what, Message::verbatim(std::move(text)));
    };
    addPlain(TR_NOOP("Report", "file"), std::filesystem::path(session.path()).filename().string());
    addPlain(TR_NOOP("Report", "begins"), at(session.begin()));
    addPlain(TR_NOOP("Report", "ends"), at(session.end()));
    addPlain(TR_NOOP("Report", "lasts"), durationText(session));
    addPlain(TR_NOOP("Report", "robot"), robot.name);
    add(TR_NOOP("Report", "source"), sourceText(start));
    addPlain(TR_NOOP("Report", "recorded by"), start.program);
    add(TR_NOOP("Report", "closed"),
        session.sealed() ? TR_NOOP("Report", "yes, sealed")
                         : TR_NOOP("Report", "NO: still being recorded, or its program died"));
    addPlain(TR_NOOP("Report", "frames"), std::to_string(session.frameCount()));
    add(TR_NOOP("Report", "estimates"),
        {TR_NOOP("Report", "%1 (scenes: %2); by method: %3"), session.estimates().size(),
         session.scenes().size(), methodsText(session)});
    add(TR_NOOP("Report", "probes"),
        {TR_NOOP("Report", "proposed %1, approved %2, refused %3"), session.proposals().size(),
         decisionsNamed(session, "approve"), decisionsNamed(session, "refuse")});
    add(TR_NOOP("Report", "operator"), countsText(session));
    return part;
}

DocumentPart hashesPart(const SessionReader& session, const SessionVerification& found,
                        const Wording& wording)
{
    const SessionStart& start = session.start();
    DocumentPart part;
    part.heading = wording(TR_NOOP("Report", "Hashes"));
    part.note =
        wording(TR_NOOP("Report", "Each hash is SHA-256. The last link of the chain proves the "
                                  "session if it is known from elsewhere."));
    const auto add = [&](SourceText what, const Message& text) {
        part.facts.emplace_back(wording(what), wording(text));
    };
    add(TR_NOOP("Report", "result"),
        holdsEverything(found)
            ? Message(TR_NOOP("Report", "every hash holds: %1 batches, %2 frames, %3 events"),
                      found.batches, found.frames, found.events)
            : Message(TR_NOOP("Report", "PARTS ARE NOT WHAT WAS RECORDED")));
    add(TR_NOOP("Report", "last link"), Message::verbatim(found.chain));
    add(TR_NOOP("Report", "robot file"), Message::verbatim(start.robotHash));
    for (const ModelRow& model : session.models()) {
        add(TR_NOOP("Report", "model"), {TR_NOOP("Report", "%1, %2, from %3 on"), model.name,
                                         model.hash, momentText(model.time)});
        if (!model.trailName.empty())
            add(TR_NOOP("Report", "networks"),
                Message::verbatim(fmt::format("{}, {}", model.trailName, model.trailHash)));
    }
    if (found.broken)
        add(TR_NOOP("Report", "broken"),
            {TR_NOOP("Report", "nothing is proven from %1"), damageMessage(start, *found.broken)});
    for (const SessionDamage& damage : found.damage)
        add(TR_NOOP("Report", "damage"), damageMessage(start, damage));
    return part;
}

/// Returns one sentence that says how far the report can be relied on.
std::string summaryOf(const SessionReader& session, const SessionVerification& found,
                      const Wording& wording)
{
    std::vector<Message> parts{
        {SourceText{"", "%1, %2."}, utcText(wallTimeOf(session.start(), session.begin())),
         durationText(session)},
        holdsEverything(found)
            ? TR_NOOP("Report", "Every hash holds.")
            : TR_NOOP("Report", "PARTS ARE NOT WHAT WAS RECORDED: see Hashes. They are left out.")};
    if (!session.sealed()) parts.emplace_back(TR_NOOP("Report", "The session was not closed."));
    return wording(Message::listed(std::move(parts), " "));
}

}  // namespace

Result<ReportDocument> missionReportOf(SessionReader& session,
                                       const std::function<bool(double)>& progress,
                                       const std::shared_ptr<const DbcBook>& book,
                                       const Wording& wording)
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
        session, *robot, [&](double share) { return !progress || progress(0.4 + 0.6 * share); },
        kMaxReportRows, wording);
    if (!decisions) return decisions.error();
    ReportDocument document{
        .title = wording({TR_NOOP("Report", "Mission report of %1"),
                          std::filesystem::path(session.path()).filename().string()}),
        .summary = summaryOf(session, found, wording),
        .parts = {sessionPart(session, *robot, wording)},
        .wording = wording};
    for (auto& fact : payloadFacts(session, book, session.end(), wording))
        document.parts[0].facts.push_back(std::move(fact));
    document.parts.push_back(stripPart(strip, {}, wording));
    document.parts.push_back(std::move(*decisions));
    document.parts.push_back(missionAlarms(session, wording));
    document.parts.push_back(missionSettings(session, kMaxReportRows, wording));
    document.parts.push_back(hashesPart(session, found, wording));
    return document;
}

}  // namespace terratact
