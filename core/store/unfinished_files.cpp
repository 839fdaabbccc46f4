#include "core/store/unfinished_files.h"

#include <unistd.h>

#include <array>
#include <atomic>

namespace terratact {
namespace {

enum class SlotState { Free, Busy, Noted };

struct NameSlot {
    std::atomic<SlotState> state{SlotState::Free};
    std::array<char, 4096> path{};
};

static_assert(std::atomic<SlotState>::is_always_lock_free, "a signal handler reads it");

std::array<NameSlot, 16> unfinishedNames;

}  // namespace

void noteUnfinished(const std::string& path)
{
    for (NameSlot& slot : unfinishedNames) {
        SlotState expected = SlotState::Free;
        if (path.size() >= slot.path.size()
            || !slot.state.compare_exchange_strong(expected, SlotState::Busy))
            continue;
        path.copy(slot.path.data(), path.size());
        slot.path.at(path.size()) = '\0';
        slot.state = SlotState::Noted;
        return;
    }
}

void forgetUnfinished(const std::string& path)
{
    for (NameSlot& slot : unfinishedNames)
        if (slot.state == SlotState::Noted && path == slot.path.data())
            slot.state = SlotState::Free;
}

void removeUnfinished() noexcept
{
    for (const NameSlot& slot : unfinishedNames)
        if (slot.state == SlotState::Noted) ::unlink(slot.path.data());
}

}  // namespace terratact
