#include "app/sessions/session_reading.h"

#include <filesystem>
#include <system_error>
#include <utility>

namespace terratact {

SessionReading::SessionReading(std::string folder, std::string recorded)
    : folder_(std::move(folder)), recorded_(std::move(recorded))
{
}

SessionReading::~SessionReading()
{
    thread_ = {};  // requests the end and waits
}

void SessionReading::start()
{
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

SessionReading::News SessionReading::consume()
{
    const std::scoped_lock lock(mutex_);
    announced_ = false;
    News rest{.files = news_.files,
              .leftOut = news_.leftOut,
              .trouble = news_.trouble,
              .ended = news_.ended};
    return std::exchange(news_, std::move(rest));
}

void SessionReading::run(const std::stop_token& stop)
{
    const auto files = sessionFilesIn(folder_, kMax);
    if (!files) {
        add([&](News& news) {
            news.trouble = files.error().message;
            news.ended = true;
        });
        return;
    }
    add([&](News& news) {
        news.files = files->paths.size();
        news.leftOut = files->leftOut;
    });
    for (const std::string& path : files->paths) {
        std::error_code none;
        const bool isRecorded =
            !recorded_.empty() && std::filesystem::equivalent(path, recorded_, none);
        ListedSession listed = isRecorded ? listRecorded(path) : listSession(path, stop);
        if (stop.stop_requested()) return;
        add([&](News& news) { news.sessions.push_back(std::move(listed)); });
    }
    add([](News& news) { news.ended = true; });
}

void SessionReading::add(const std::function<void(News&)>& change)
{
    {
        const std::scoped_lock lock(mutex_);
        change(news_);
        if (std::exchange(announced_, true)) return;
    }
    emit news();
}

}  // namespace terratact
