#pragma once

#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "core/log/session_survey.h"

namespace terratact {

/// What has been found so far.
struct Surveyed {
    std::vector<SessionSpan> contacts{}, silences{};
    std::vector<SessionDamage> damage{};
    double share = 0.0;     ///< 0 … 1 of the session
    std::string trouble{};  ///< why it does not go on; empty: it does
};

/// Surveys a session (core/log/session_survey.h) in a thread of its own, with a reader of its own, and follows one
/// that still grows.
class SessionIndexer {
public:
    SessionIndexer(std::string path, RobotModel robot, double threshold);

    std::uint64_t version() const;  ///< another where found() is
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
    std::jthread thread_;  // last: it starts when all else stands
};

}  // namespace terratact
