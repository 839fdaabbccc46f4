#include "app/imports/import_work.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/display/translated.h"
#include "app/recording/survey_text.h"
#include "core/base/text.h"
#include "core/mapping/mapping_proposal.h"
#include "core/mapping/recording_check.h"
#include "core/mapping/recording_survey.h"

namespace terratact {
namespace {

struct ImportCancelled {};

constexpr std::uint64_t kMessagesPerNews = 500;

QString plain(const std::string& text)
{
    return QString::fromStdString(printableLines(text));
}

}  // namespace

ImportWork::ImportWork(std::string file, RobotFile robot, QObject* parent)
    : QObject(parent), file_(std::move(file)), robot_(std::move(robot))
{
    std::error_code none;
    const auto size = std::filesystem::file_size(file_, none);
    bytes_ = none ? 0 : size;
}

ImportWork::~ImportWork()
{
    thread_ = {};  // requests the end and waits
}

RecordingWatch ImportWork::watchOf(const std::stop_token& stop)
{
    return [this, stop, messages = std::uint64_t{0}](std::uint64_t place, bool isByte) mutable {
        if (stop.stop_requested()) throw ImportCancelled{};
        if (++messages % kMessagesPerNews != 0) return;
        const int percent = isByte && bytes_ > 0
                              ? static_cast<int>(std::min<std::uint64_t>(100, place * 100 / bytes_))
                              : -1;
        emit progressed(percent, messages);
    };
}

std::function<void()> ImportWork::refusal(Message why)
{
    return [this, why = withoutControls(std::move(why))] { emit failed(translated(why)); };
}

void ImportWork::start(Job job)
{
    thread_ = {};
    busy_ = true;
    const int number = ++job_;
    thread_ = std::jthread([this, number, job = std::move(job)](const std::stop_token& stop) {
        std::function<void()> news;
        try {
            news = job(watchOf(stop));
        } catch (const ImportCancelled&) {
            news = [this] { emit cancelled(); };
        } catch (const std::exception& error) {
            news = refusal(messageOf(error));
        }
        QMetaObject::invokeMethod(
            this, [this, number, news = std::move(news)] { finish(number, news); },
            Qt::QueuedConnection);
    });
}

void ImportWork::finish(int job, const std::function<void()>& news)
{
    if (job != job_) return;
    busy_ = false;
    news();
}

void ImportWork::cancel()
{
    thread_.request_stop();
}

void ImportWork::survey()
{
    start([this](const RecordingWatch& watch) -> std::function<void()> {
        const auto recording = openRecording(file_);
        if (!recording) return refusal(recording.error().message);
        (*recording)->follow(watch);
        const auto surveys = surveyRecording(**recording);
        if (!surveys) return refusal(surveys.error().message);
        std::string text = surveyText(**recording, *surveys);
        for (const std::string& remark : (*recording)->consumeRemarks()) text += remark + "\n";
        const std::string name = std::filesystem::path(file_).stem().string();
        return [this, text = plain(text), mapping = plain(proposedMapping(*surveys, name))] {
            emit surveyed(text, mapping);
        };
    });
}

void ImportWork::check(const std::string& mapping)
{
    start([this, mapping](const RecordingWatch& watch) -> std::function<void()> {
        const auto read = mappingFrom("mapping", mapping);
        if (!read) return refusal(read.error().message);
        const auto found = checkRecording(file_, *read, robot_.model, watch);
        if (!found) return refusal(found.error().message);
        QStringList doubts;
        for (const std::string& doubt : *found) doubts << plain(doubt);
        return [this, doubts] { emit checked(doubts); };
    });
}

void ImportWork::import(const std::string& mapping, const std::string& out)
{
    start([this, mapping, out](const RecordingWatch& watch) -> std::function<void()> {
        const auto done = importRecording({.file = file_,
                                           .mapping = "mapping",
                                           .robot = robot_.path,
                                           .out = out,
                                           .mappingText = mapping,
                                           .watch = watch});
        if (!done) return refusal(done.error().message);
        return [this, out, report = *done] { emit imported(QString::fromStdString(out), report); };
    });
}

}  // namespace terratact
