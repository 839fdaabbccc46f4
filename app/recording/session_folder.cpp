#include "app/recording/session_folder.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/statvfs.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "app/recording/session_text.h"
#include "app/runtime/user_folder.h"
#include "core/log/session_reader.h"
#include "core/log/session_writer.h"

namespace terratact {

std::int64_t wallNow()
{
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::system_clock::now().time_since_epoch())
        .count();
}

std::int64_t sizeOf(const std::string& path)
{
    std::error_code none;
    const auto size = std::filesystem::file_size(path, none);
    return none ? 0 : static_cast<std::int64_t>(size);
}

std::int64_t writtenAt(const std::string& path)
{
    struct stat file {};
    if (::stat(path.c_str(), &file) != 0) return 0;
    return std::int64_t{file.st_mtim.tv_sec} * 1'000'000'000 + file.st_mtim.tv_nsec;
}

std::string sessionFolder()
{
    const std::string state = userFolder("XDG_STATE_HOME", ".local/state");
    return state.empty() ? state : state + "/terratact/sessions";
}

std::optional<std::uint64_t> freeBytes(const std::string& folder)
{
    struct statvfs disk {};
    if (::statvfs(folder.c_str(), &disk) != 0) return std::nullopt;
    return std::uint64_t{disk.f_bavail} * disk.f_frsize;
}

std::vector<std::string> sessionsIn(const std::string& folder)
{
    std::vector<std::string> paths;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(folder, none))
        if (entry.path().extension() == kSessionSuffix && !entry.is_symlink(none)
            && entry.is_regular_file(none))
            paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    return paths;
}

std::vector<Message> recoverDeadSessions(const std::vector<std::string>& paths)
{
    std::vector<Message> reports;
    for (const std::string& path : paths) {
        const auto recovery =
            recoverSession(path, true);  // true: a journal missing in this folder never comes back
        if (!recovery)
            reports.emplace_back(TR_NOOP("core", "session not recovered: %1"),
                                 recovery.error().message);
        else if (*recovery == SessionRecovery::Recovered)
            reports.emplace_back(TR_NOOP("core",
                                         "session recovered, whose program had ended without "
                                         "closing it: %1"),
                                 path);
    }
    return reports;
}

namespace {

constexpr std::int64_t kDay = std::int64_t{86'400} * 1'000'000'000;  // [ns]
constexpr std::int64_t kYear2020 = std::int64_t{1'577'836'800} * 1'000'000'000;

bool canBeTrue(std::int64_t time, std::int64_t now)
{
    return time >= kYear2020 && time <= now + kDay;
}

struct ClosedSession {
    std::string path;
    double bytes;
    std::int64_t ended;   ///< [ns] since 1970
    bool mayBeDeleted;    ///< its times are plausible
    bool tooOld = false;  ///< beyond the age limit; otherwise the total size is
};

/// Returns the closed sessions, oldest first; empty if goesOn() cancelled.
std::vector<ClosedSession> closedOnes(const std::vector<std::string>& paths, std::int64_t now,
                                      const std::function<bool()>& goesOn)
{
    std::vector<ClosedSession> sessions;
    for (const std::string& path : paths) {
        if (!goesOn()) return {};
        // A session being written, even by this process, has a journal and is not opened. Closing any descriptor of it
        // would release this process's locks on the file.
        std::error_code none;
        if (std::filesystem::exists(path + "-wal", none)) continue;
        if (std::filesystem::is_symlink(path, none)) continue;
        const auto session = SessionReader::open(path);
        if (!session || !session->sealed()) continue;
        const std::int64_t recorded = wallTimeOf(session->start(), session->end());
        const std::int64_t written = writtenAt(path);
        sessions.push_back({.path = path,
                            .bytes = static_cast<double>(sizeOf(path)),
                            .ended = std::max(recorded, written),
                            .mayBeDeleted = canBeTrue(recorded, now) && canBeTrue(written, now)});
    }
    std::stable_sort(
        sessions.begin(), sessions.end(),
        [](const ClosedSession& a, const ClosedSession& b) { return a.ended < b.ended; });
    return sessions;
}

/// Returns the sessions beyond the limits, in the same order.
std::vector<ClosedSession> beyond(const std::vector<ClosedSession>& sessions,
                                  const RetentionLimits& limits, std::int64_t now)
{
    double total = 0.0;
    for (const ClosedSession& session : sessions) total += session.bytes;
    std::vector<ClosedSession> found;
    for (ClosedSession session : sessions) {
        const double age = static_cast<double>(now - session.ended) / static_cast<double>(kDay);
        session.tooOld = limits.days > 0.0 && age > limits.days;
        const bool tooMuch = limits.gigabytes > 0.0 && total > limits.gigabytes * 1e9;
        if (!session.mayBeDeleted || (!session.tooOld && !tooMuch)) continue;
        total -= session.bytes;
        found.push_back(session);
    }
    return found;
}

}  // namespace

std::vector<Message> applyRetention(const std::vector<std::string>& paths,
                                    const RetentionLimits& limits, std::int64_t now,
                                    const std::function<bool()>& goesOn)
{
    if ((limits.days <= 0.0 && limits.gigabytes <= 0.0) || now < kYear2020) return {};
    const std::vector<ClosedSession> surplus = beyond(closedOnes(paths, now, goesOn), limits, now);
    if (!limits.confirmed) {
        if (surplus.empty()) return {};
        double bytes = 0.0;
        for (const ClosedSession& session : surplus) bytes += session.bytes;
        return {Message(TR_NOOP("core", "%1 sessions (%2 MB) exceed your limits. None is deleted "
                                        "until you allow it on page Settings"),
                        surplus.size(), fixed(1e-6 * bytes, 1))};
    }
    std::vector<Message> reports;
    for (const ClosedSession& session : surplus) {
        if (!goesOn()) break;
        std::error_code none;
        if (std::filesystem::remove(session.path, none))
            reports.emplace_back(
                session.tooOld
                    ? TR_NOOP("core", "session deleted, since it is older than you have set: %1")
                    : TR_NOOP("core", "session deleted, since all together are larger than you "
                                      "have set: %1"),
                session.path);
    }
    return reports;
}

}  // namespace terratact
