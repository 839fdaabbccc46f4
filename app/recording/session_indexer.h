#pragma once

#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "core/log/session_survey.h"

namespace terratact {

/// Results found so far.
struct Surveyed {
    std::vector<SessionSpan> contacts{}, silences{};
    std::vector<SessionDamage> damage{};
    double share = 0.0;     ///< 0 … 1, indexed share of the session
    std::string trouble{};  ///< reason that indexing stopped; empty: it continues
};

/// Indexes a session (core/log/session_survey.h) in its own thread with its own reader. It follows a session that still
/// grows.
class SessionIndexer {
public:
    SessionIndexer(std::string path, RobotModel robot, double threshold);

    std::uint64_t version() const;  ///< changes whenever found() changes
    Surveyed found() const;

private:
    void run(const std::stop_token& stop);
    void publish(const SessionSurvey& survey, const SessionReader& reader);

    std::string path_;
    RobotModel robot_;
    double threshold_;
    mutable std::mutex mutex_;
    std::uint64_t version_ = 0;
    Surveyed found_;
    std::jthread thread_;  // last member: the thread starts after all others exist
};

}  // namespace terratact
