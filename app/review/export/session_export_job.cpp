#include "app/review/export/session_export_job.h"

#include <filesystem>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/figures/report/mission_report.h"
#include "app/figures/report/session_report.h"
#include "app/figures/report/strip_file.h"
#include "app/recording/what_if.h"
#include "core/log/session_reader.h"

namespace terratact {
namespace {

using Progress = std::function<bool(double)>;

Status writeReportOf(SessionReader& session, const SessionExportJob::Wish& wish,
                     const Progress& progress)
{
    const auto book = readDbcBook(CanProtocol::Terratact, wish.dbc);
    if (!book) return book.error();
    if (wish.scene == 0) {
        const auto mission = missionReportOf(session, progress, *book, inReadersLanguage);
        if (!mission) return mission.error();
        return writeDocument(wish.out, *mission);
    }
    const auto report = reportOf(session, wish.scene, progress, *book, inReadersLanguage);
    if (!report) return report.error();
    return writeReport(wish.out, *report);
}

Status writeStripOf(SessionReader& session, const std::string& out, const Progress& progress)
{
    const auto robot = robotOf(session);
    if (!robot) return robot.error();
    const auto strip = stripOf(session, *robot, progress);
    if (!strip) return Error{out + ": not written: ended before all was read"};
    const auto name = std::filesystem::path(session.path()).filename().string();
    return writeStrip(out, strip, *robot, inReadersLanguage(stripTitle(name)), {},
                      inReadersLanguage);
}

}  // namespace

SessionExportJob::SessionExportJob(Wish wish) : wish_(std::move(wish)) {}

SessionExportJob::~SessionExportJob()
{
    cancel();
}

void SessionExportJob::start()
{
    thread_ = std::jthread([this] { run(); });
}

void SessionExportJob::cancel()
{
    cancelled_ = true;
}

bool SessionExportJob::goOn(double share)
{
    if (const int percent = static_cast<int>(100.0 * share); percent != percent_) {
        percent_ = percent;
        emit progressed(share);
    }
    return !cancelled_;
}

Result<ExportCounts> SessionExportJob::write(SessionReader& session)
{
    const Progress progress = [this](double share) { return goOn(share); };
    if (wish_.strip || !wish_.format) {
        const Status written = wish_.strip ? writeStripOf(session, wish_.out, progress)
                                           : writeReportOf(session, wish_, progress);
        return written ? Result<ExportCounts>(ExportCounts{}) : written.error();
    }
    const auto book = readDbcBook(CanProtocol::Terratact, wish_.dbc);
    if (!book) return book.error();
    wish_.selection.book = *book;
    return writeExport(session, wish_.out, *wish_.format, wish_.selection, progress);
}

void SessionExportJob::run()
{
    auto session = SessionReader::open(wish_.session);
    if (!session) {
        emit ended(translated(session.error().message), 0, 0, 0);
        return;
    }
    const auto written = write(*session);
    const ExportCounts counts = written ? *written : ExportCounts{};
    emit ended(written ? QString() : translated(written.error().message), counts.leftOut,
               static_cast<int>(session->damage().size()), static_cast<int>(counts.withoutColumns));
}

}  // namespace terratact
