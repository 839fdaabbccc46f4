// OpenBLAS starts a thread per processor when it is loaded, before main(). If the memory for them is refused, it
// retries forever. This program needs none of these threads. With limited memory it therefore restarts itself with an
// environment that limits OpenBLAS to one thread. Sanitizer builds do not need this.
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define TERRATACT_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TERRATACT_SANITIZED
#endif

#if defined(__linux__) && !defined(TERRATACT_SANITIZED)
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <climits>
#include <cstddef>
#include <cstring>

#include "core/base/memory_limit.h"

namespace {

constexpr char kName[] = "OPENBLAS_NUM_THREADS=";
char oneThread[] = "OPENBLAS_NUM_THREADS=1";

// Runs before the constructors of all libraries, so it may use neither libraries nor the usual allocation.
void startWithoutThreads(int /*count*/, char** arguments, char** environment)
{
    std::size_t size = 0;
    for (; environment[size] != nullptr; ++size)
        if (std::strcmp(environment[size], oneThread) == 0) return;
    if (!terratact::memoryIsLimited()) return;
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
