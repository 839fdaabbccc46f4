// OpenBLAS starts a thread per processor when it is loaded, before main(). Later versions than 0.3.21 also allocate a
// buffer then. If the memory is refused, it retries forever. This program needs none of these threads. With limited
// memory it therefore restarts itself in an environment that limits OpenBLAS to one thread. It refuses to start if the
// buffer does not fit in memory. Sanitizer builds do not need this.
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define TERRATACT_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TERRATACT_SANITIZED
#endif

#if defined(__linux__) && !defined(TERRATACT_SANITIZED)
#include <openblas_config.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <climits>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>

#include "core/base/memory_limit.h"

namespace {

constexpr char kName[] = "OPENBLAS_NUM_THREADS=";
char oneThread[] = "OPENBLAS_NUM_THREADS=1";

constexpr std::size_t kBuffer = std::size_t{128} << 20U;

/// Returns true for OpenBLAS 0.3.22 and later; older versions allocate the buffer when it is first used.
constexpr bool allocatesAtStart()
{
    constexpr std::string_view kVersion = OPENBLAS_VERSION;  // such as " OpenBLAS 0.3.29 "
    int patch = 0;
    for (std::size_t i = kVersion.find("0.3.") + 4;
         i < kVersion.size() && kVersion[i] >= '0' && kVersion[i] <= '9'; ++i)
        patch = 10 * patch + (kVersion[i] - '0');
    return kVersion.find("0.3.") == std::string_view::npos || patch > 21;
}

/// Ends the program with a sentence if OpenBLAS would wait for its buffer forever.
void requireBuffer(const char* program)
{
    void* room = mmap(nullptr, kBuffer, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (room != MAP_FAILED) {
        munmap(room, kBuffer);
        return;
    }
    const char* slash = std::strrchr(program, '/');
    const std::string text = std::string(slash ? slash + 1 : program) + ": "
                           + terratact::outOfMemory("OpenBLAS", kBuffer) + "\n";
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
    _exit(1);
}

// Runs before the constructors of all libraries, so it may use no state of theirs.
void startWithoutThreads(int /*count*/, char** arguments, char** environment)
{
    if (!terratact::memoryIsLimited()) return;
    if (allocatesAtStart()) requireBuffer(arguments[0] ? arguments[0] : "terratact");
    std::size_t size = 0;
    for (; environment[size] != nullptr; ++size)
        if (std::strcmp(environment[size], oneThread) == 0) return;
    std::array<char, PATH_MAX> program{};
    if (readlink("/proc/self/exe", program.data(), program.size() - 1) < 0) return;
    void* room = mmap(nullptr, (size + 2) * sizeof(char*), PROT_READ | PROT_WRITE,
                      MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (room == MAP_FAILED) return;
    char** next = static_cast<char**>(room);
    for (std::size_t i = 0; i < size; ++i)
        if (std::strncmp(environment[i], kName, sizeof kName - 1) != 0) *next++ = environment[i];
    *next = oneThread;
    execve(program.data(), arguments, static_cast<char**>(room));
}

[[gnu::section(".preinit_array"), gnu::used]] void (*const kAtStart)(int, char**,
                                                                     char**) = startWithoutThreads;

}  // namespace
#endif
