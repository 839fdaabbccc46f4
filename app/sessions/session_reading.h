#pragma once

#include <QObject>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/recording/session_listing.h"
#include "core/base/message.h"

namespace terratact {

/// Reads the recordings of a folder in its own thread, the last name first. The destructor cancels it. GUI thread only.
class SessionReading final : public QObject {
    Q_OBJECT
public:
    static constexpr std::size_t kMax = 10'000;  ///< recordings; older names are left out

    /// What was read since the last call of consume().
    struct News {
        std::vector<ListedSession> sessions{};
        std::size_t files = 0;    ///< recordings of the folder that are listed
        std::size_t leftOut = 0;  ///< older ones beyond kMax
        Message trouble{};        ///< why the folder cannot be read
        bool ended = false;       ///< everything was read
    };

    /// recorded: returns the file that this program is recording, which is not opened; empty: none.
    SessionReading(std::string folder, std::string recorded);
    ~SessionReading() override;

    void start();  ///< call once, after connecting the signal
    News consume();

signals:
    void news();  ///< consume() has news; emitted in the thread, once until consume()

private:
    void run(const std::stop_token& stop);
    void add(const std::function<void(News&)>& change);

    std::string folder_, recorded_;
    std::mutex mutex_;  // guards the members below
    News news_;
    bool announced_ = false;
    std::jthread thread_;  // last member: it ends before all others are destroyed
};

}  // namespace terratact
