#include "core/log/session_summary.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "core/atem/alarms.h"
#include "core/infer/verdict/two_track_verdict.h"
#include "core/log/rows/checked_row.h"
#include "core/log/rows/session_row_reader.h"
#include "core/log/rows/session_tables.h"
#include "core/log/session_journal.h"
#include "core/robot/robot_model.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

constexpr int kMaxSummaryValue = 64 << 20;  // bytes of one value: draws
// Counts, events, estimates, what they refer to, and draws; a row that two queries visit or return
// counts twice.
constexpr int kSummaryPasses = 4;

std::size_t tableNumber(std::string_view table)
{
    const auto found = std::ranges::find(kSessionRowTables, table);
    return static_cast<std::size_t>(found - kSessionRowTables.begin());
}

/// State of telemetry and sensors over the session, from its events.
struct LinkHistory {
    std::vector<SessionTime> gaps;                         ///< silences that were too long
    std::vector<std::pair<SessionTime, bool>> suspicions;  ///< a sensor is suspected from then on

    LinkSinceScene between(SessionTime scene, SessionTime estimate) const
    {
        LinkSinceScene link;
        link.unbroken = std::ranges::none_of(
            gaps, [&](SessionTime gap) { return gap >= scene && gap <= estimate; });
        bool suspected = false;
        for (const auto& [time, isSuspected] : suspicions) {
            if (time > estimate) break;
            if (suspected && time >= scene) link.sensorsSound = false;
            suspected = isSuspected;
        }
        if (suspected) link.sensorsSound = false;
        return link;
    }
};

/// Reads the summary of an open file.
class SessionSummarizer {
public:
    SessionSummarizer(SqliteFile& file, const std::stop_token& stop) : file_(file), stop_(stop) {}

    SessionSummary read(SessionClosing closing, const std::string& path, const std::string& lonely);

private:
    void goOn() const;
    std::int64_t count(const std::string& what);
    void readBatches();
    void readEvents();
    void addEvent(const EventRow& event);
    void readJudged();
    bool addRow(std::size_t table, const SqliteStatement& select);
    void readRows(std::string_view table, const std::string& condition);
    void judge(std::int64_t judged);
    bool addDraws(EstimateRow& row);
    std::optional<StepVerdict> verdictOfRow(const EstimateRow& row) const;

    SqliteFile& file_;
    const std::stop_token& stop_;
    SessionSummary summary_;
    std::optional<RobotModel> robot_;
    LinkHistory link_;
    SessionRows rows_;
    std::int64_t drawBytes_ = 0;
};

/// Begins a step of the reading.
void SessionSummarizer::goOn() const
{
    if (stop_.stop_requested()) throw RefusedRow{TR_NOOP("core", "reading was cancelled")};
}

/// Returns the number of rows. The limits of the file bound each step, but not a count(*).
std::int64_t SessionSummarizer::count(const std::string& what)
{
    goOn();
    SqliteStatement row = file_.prepare("SELECT 1 FROM " + what);
    std::int64_t found = 0;
    while (row.step())
        if (++found % 1024 == 0) goOn();
    return found;
}

SessionSummary SessionSummarizer::read(SessionClosing closing, const std::string& path,
                                       const std::string& lonely)
{
    goOn();
    file_.grantPasses(kSummaryPasses);
    file_.run("BEGIN");  // one state of a file that is still being written
    requireSessionSchema(file_, lonely);
    if (file_.readsJournal()) requireOwnJournal(path, file_);
    const SessionStart start = readSessionStart(file_).start;
    summary_.closing = closing;
    summary_.wallTime = start.wallTime;
    summary_.program = start.program;
    summary_.source = start.source;
    if (auto robot = robotModelFrom("its robot", start.robot)) {
        robot_ = *std::move(robot);
        summary_.robot = robot_->name;
    }
    readBatches();
    summary_.scenes = count("scene");
    summary_.estimates = count("estimate");
    summary_.proposals = count("proposal");
    readEvents();
    readJudged();
    file_.run("COMMIT");
    return std::move(summary_);
}

void SessionSummarizer::readBatches()
{
    goOn();
    for (const char* const condition : {"frame_count > 0", "TRUE"}) {
        SqliteStatement first = file_.prepare("SELECT * FROM batch WHERE " + std::string(condition)
                                              + " ORDER BY id LIMIT 1");
        if (!first.step()) continue;
        summary_.begin = summary_.end = batchFrom(first).batch.first;
        break;
    }
    // The last rows overlap in time: a batch may end before an earlier one does.
    goOn();
    SqliteStatement last = file_.prepare("SELECT * FROM batch ORDER BY id DESC LIMIT 16");
    while (last.step()) {
        const SessionBatch batch = batchFrom(last).batch;
        summary_.end = std::max(summary_.end, batch.last);
        summary_.frames = std::max(summary_.frames, batch.frameFirst + batch.frameCount - 1);
    }
}

void SessionSummarizer::readEvents()
{
    goOn();
    SqliteStatement select = file_.prepare(
        "SELECT * FROM event WHERE kind IN (?, ?, ?) OR (kind = ? AND subject = 'approve') "
        "ORDER BY id");
    select.bind(0, name(EventKind::Alarm));
    select.bind(1, name(EventKind::Marker));
    select.bind(2, name(EventKind::TelemetryGap));
    select.bind(3, name(EventKind::Decision));
    const std::size_t table = tableNumber("event");
    for (std::size_t n = 1; select.step(); ++n) {
        if (addRow(table, select)) addEvent(rows_.events.back());
        rows_.events.clear();
        if (n % 1024 == 0) goOn();
    }
}

void SessionSummarizer::addEvent(const EventRow& event)
{
    switch (event.kind) {
    case EventKind::Alarm: {
        const bool isSensor = event.subject == kSensorAlarm;
        const double state = event.number.value_or(0.0);
        if (state == 3.0) ++summary_.alarms;
        if (isSensor) link_.suspicions.emplace_back(event.time, state >= 2.0);
        break;
    }
    case EventKind::Marker:
        ++summary_.marks;
        if (!event.text.empty() && summary_.notes.size() < SessionSummary::kMaxNotes)
            summary_.notes.push_back(event.text.substr(0, SessionSummary::kMaxNoteBytes));
        break;
    case EventKind::TelemetryGap: link_.gaps.push_back(event.time); break;
    default: ++summary_.probes; break;
    }
}

/// Adds the current row to rows_. Returns false if it holds what no session can hold.
bool SessionSummarizer::addRow(std::size_t table, const SqliteStatement& select)
{
    try {
        rows_.add(table, select);
        return true;
    } catch (const RefusedRow& refused) {
        if (!summary_.damage)
            summary_.damage =
                Message(TR_NOOP("core", "row %1 of its table %2: %3"), select.integer(0),
                        kSessionRowTables.at(table), refused.message());
        return false;
    }
}

/// Reads the rows of a table that meet a condition.
void SessionSummarizer::readRows(std::string_view table, const std::string& condition)
{
    goOn();
    const std::size_t number = tableNumber(table);
    SqliteStatement select = file_.prepare("SELECT * FROM " + std::string(table) + " WHERE "
                                           + condition + " ORDER BY id");
    for (std::size_t n = 1; select.step(); ++n) {
        (void)addRow(number, select);
        if (n % 1024 == 0) goOn();
    }
}

/// Reads the last estimate of each of the newest scenes, and what these refer to.
void SessionSummarizer::readJudged()
{
    const std::int64_t judged = count("(SELECT scene FROM estimate WHERE role <> 'second' "
                                      "GROUP BY scene)");
    if (judged == 0) return;
    const std::string wanted = "(SELECT max(id) FROM estimate WHERE role <> 'second' "
                               "GROUP BY scene ORDER BY max(id) DESC LIMIT "
                             + std::to_string(SessionSummary::kMaxJudged) + ")";
    const auto of = [&wanted](const std::string& column) {
        return "id IN (SELECT " + column + " FROM estimate WHERE id IN " + wanted + ")";
    };
    readRows("settings", of("settings"));
    readRows("model", of("model"));
    readRows("scene", of("scene"));
    readRows("estimate", "id IN " + wanted);
    readRows("estimate_bin", "estimate IN " + wanted);
    judge(judged);
}

void SessionSummarizer::judge(std::int64_t judged)
{
    SessionVerdicts& verdicts = summary_.verdicts;
    for (std::size_t k = rows_.estimates.size(); k-- > 0;) {  // newest first
        EstimateRow& row = rows_.estimates[k];
        std::optional<StepVerdict> verdict;
        if (addDraws(row)) verdict = verdictOfRow(row);
        for (TerrainEstimate& side : row.estimate.side) side.draws = {};
        if (verdict == StepVerdict::Clear) ++verdicts.clear;
        if (verdict == StepVerdict::Blocked) ++verdicts.blocked;
        if (verdict == StepVerdict::CannotTell) ++verdicts.cannotTell;
        if (!summary_.last) summary_.last = {row.time, row.stepLimit, row.estimate, verdict};
    }
    verdicts.notRead = judged - verdicts.clear - verdicts.blocked - verdicts.cannotTell;
}

/// Returns false if the draws are missing or would be too many bytes.
bool SessionSummarizer::addDraws(EstimateRow& row)
{
    goOn();
    SqliteStatement size = file_.prepare("SELECT length(draws) FROM estimate_draws WHERE id = ?");
    size.bind(0, row.id);
    if (!size.step()) return false;
    drawBytes_ += size.integer(0);
    if (drawBytes_ > SessionSummary::kMaxDrawBytes) return false;
    SqliteStatement select = file_.prepare("SELECT draws FROM estimate_draws WHERE id = ?");
    select.bind(0, row.id);
    if (!select.step()) return false;
    setDraws(row.estimate, drawsFrom(select.blob(0), row.estimate.onePlane));
    return true;
}

std::optional<StepVerdict> SessionSummarizer::verdictOfRow(const EstimateRow& row) const
{
    if (!robot_ && !row.estimate.onePlane) return std::nullopt;
    const SceneRow* const scene = byId(rows_.scenes, row.scene);
    if (!scene) return std::nullopt;
    const LinkSinceScene since = link_.between(scene->time, row.time);
    return verdictOf(row.estimate, robot_.value_or(RobotModel{}), scene->measurement, since,
                     row.stepLimit)
        .both;
}

}  // namespace

std::string_view name(SessionClosing closing)
{
    constexpr std::array<std::string_view, 3> kNames{"sealed", "open", "torn"};
    return kNames.at(static_cast<std::size_t>(closing));
}

Result<SessionSummary> summarizeSession(const std::string& path, const std::stop_token& stop)
{
    try {
        SqliteFile file = SqliteFile::openLogWithoutTrace(path, kMaxSummaryValue);
        SessionClosing closing = SessionClosing::Open;
        if (!file.readsJournal())
            closing = SqliteFile::isJournaled(path) ? SessionClosing::Torn : SessionClosing::Sealed;
        const auto damage =
            closing == SessionClosing::Sealed ? std::nullopt : damageOfJournal(path);
        std::string lonely;
        if (closing == SessionClosing::Torn && !damage)
            lonely = path.substr(path.find_last_of('/') + 1);
        if (damage) closing = SessionClosing::Torn;
        SessionSummary summary = SessionSummarizer(file, stop).read(closing, path, lonely);
        if (damage) summary.damage = damage;
        return summary;
    } catch (const Failure& failure) {
        return fileError(path, failure.message());
    }
}

}  // namespace terratact
