#include "app/runtime/progress.h"
#include "app/runtime/print_text.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>

namespace terratact {

using std::chrono::steady_clock;

Progress::Progress(std::string what, int total)
    : what_(std::move(what)), total_(total), terminal_(isatty(STDERR_FILENO) == 1),
      start_(steady_clock::now()), shown_(start_)
{
}

Progress::~Progress()
{
    if (printed_) printText(stderr, "\r\033[K");
}

void Progress::tick()
{
    show(++done_);
}

void Progress::reach(int done)
{
    done_ = done;
    show(done);
}

void Progress::show(int done)
{
    if (!terminal_ || done <= 0) return;
    const std::scoped_lock lock(mutex_);
    const auto now = steady_clock::now();
    if (now - start_ < std::chrono::seconds(1) || now - shown_ < std::chrono::milliseconds(200))
        return;
    shown_ = now;
    printed_ = true;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    printText(stderr, "\r\033[K{} {} of {}, about {:.0f} s left", what_, done, total_,
              elapsed * (total_ - done) / done);
    std::fflush(stderr);
}

}  // namespace terratact
