#include "core/base/memory_limit.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <system_error>
#ifdef __unix__
#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace terratact {
namespace {

enum class Bound : std::uint8_t { None, AddressSpace, Data, Commit };

struct MemoryLimit {
    Bound bound = Bound::None;
    std::uint64_t bytes = 0;  ///< AddressSpace, Data: the limit
};

#ifdef __unix__
bool promisesOnlyWhatItHas()
{
    char mode = '0';
    const int file = open("/proc/sys/vm/overcommit_memory", O_RDONLY | O_CLOEXEC);
    if (file < 0) return false;
    const bool isRead = read(file, &mode, 1) == 1;
    close(file);
    return isRead && mode == '2';
}

MemoryLimit memoryLimit()
{
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
        return {Bound::AddressSpace, limit.rlim_cur};
    if (getrlimit(RLIMIT_DATA, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
        return {Bound::Data, limit.rlim_cur};
    return {promisesOnlyWhatItHas() ? Bound::Commit : Bound::None, 0};
}

// Returns the bytes of address space or data that this process uses.
std::uint64_t used(Bound bound)
{
    std::array<unsigned long long, 6> pages{};
    std::FILE* file = std::fopen("/proc/self/statm", "re");
    if (!file) return 0;
    for (unsigned long long& count : pages)
        if (std::fscanf(file, "%llu", &count) != 1) break;
    std::fclose(file);
    return (bound == Bound::Data ? pages[5] : pages[0])
         * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}
#else
MemoryLimit memoryLimit()
{
    return {};
}
std::uint64_t used(Bound)
{
    return 0;
}
#endif

std::uint64_t megabytes(std::uint64_t bytes)
{
    return (bytes + 999'999) / 1'000'000;
}

}  // namespace

bool memoryIsLimited()
{
    return memoryLimit().bound != Bound::None;
}

std::string outOfMemory(const std::string& forWhat, std::size_t bytes)
{
    std::string text = bytes == 0
                         ? fmt::format("{} needs more memory than there is", forWhat)
                         : fmt::format("{} needs {} MB of memory", forWhat, megabytes(bytes));
    const MemoryLimit limit = memoryLimit();
    if (limit.bound == Bound::None) return text + ": end other programs";
    if (limit.bound == Bound::Commit)
        return text + ", which the kernel refuses (vm.overcommit_memory is 2): end other programs";
    const char option = limit.bound == Bound::AddressSpace ? 'v' : 'd';
    const std::uint64_t uses = used(limit.bound);
    text += fmt::format("; this process uses {} of the {} MB that ulimit -{} leaves it",
                        megabytes(uses), limit.bytes / 1'000'000, option);
    if (uses + bytes > limit.bytes && bytes > 0)
        text += fmt::format(", so {} MB are missing", megabytes(uses + bytes - limit.bytes));
    return text + fmt::format(". Raise the limit, or lift it: ulimit -{} unlimited", option);
}

std::string memoryMissing(const std::string& forWhat, std::size_t bytes)
{
    // volatile: a compiler could otherwise remove the allocation
    void* volatile probe = std::malloc(bytes);
    if (probe == nullptr) return outOfMemory(forWhat, bytes);
    std::free(probe);
    return {};
}

std::string describeFailure(const std::exception& error)
{
    if (dynamic_cast<const std::bad_alloc*>(&error)) return outOfMemory("this work", 0);
    const auto* system = dynamic_cast<const std::system_error*>(&error);
    const bool noThread = system && system->code() == std::errc::resource_unavailable_try_again;
    return noThread && memoryIsLimited() ? outOfMemory("another thread", 0) : error.what();
}

}  // namespace terratact
