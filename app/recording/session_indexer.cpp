#include "app/recording/session_indexer.h"

#include <chrono>
#include <condition_variable>
#include <utility>

namespace terratact {
namespace {

constexpr std::size_t kPublishEvery = 200;  // batches between two updates of found()
constexpr auto kIndexPeriod = std::chrono::milliseconds(500);

}  // namespace

SessionIndexer::SessionIndexer(std::string path, RobotModel robot, double threshold)
    : path_(std::move(path)), robot_(std::move(robot)), threshold_(threshold),
      thread_([this](const std::stop_token& stop) { run(stop); })
{
}

std::uint64_t SessionIndexer::version() const
{
    const std::scoped_lock lock(mutex_);
    return version_;
}

Surveyed SessionIndexer::found() const
{
    const std::scoped_lock lock(mutex_);
    return found_;
}

void SessionIndexer::publish(const SessionSurvey& survey, const SessionReader& reader)
{
    const auto all = static_cast<double>(reader.batches().size());
    const std::scoped_lock lock(mutex_);
    found_.contacts = survey.contacts();
    found_.silences = survey.silences();
    found_.damage = reader.damage();
    found_.share = all > 0.0 ? static_cast<double>(survey.batchesRead()) / all : 1.0;
    ++version_;
}

void SessionIndexer::run(const std::stop_token& stop)
{
    auto reader = SessionReader::open(path_);
    if (!reader) {
        const std::scoped_lock lock(mutex_);
        found_.trouble = reader.error().text;
        ++version_;
        return;
    }
    SessionSurvey survey(robot_, threshold_);
    std::mutex idle;
    std::condition_variable_any wake;
    while (!stop.stop_requested()) {
        std::size_t taken = 0;
        while (!stop.stop_requested() && survey.addNext(*reader))
            if (++taken % kPublishEvery == 0) publish(survey, *reader);
        if (taken > 0 || found().share < 1.0) publish(survey, *reader);
        if (reader->sealed()) return;
        std::unique_lock lock(idle);
        wake.wait_for(lock, stop, kIndexPeriod, [] { return false; });
        if (const auto more = reader->refresh(); !more) {
            const std::scoped_lock locked(mutex_);
            found_.trouble = more.error().text;
            ++version_;
            return;
        }
    }
}

}  // namespace terratact
