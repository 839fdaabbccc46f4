#pragma once

#include <csignal>
#include <initializer_list>

namespace terratact {

/// Catches Ctrl+C (SIGINT) and SIGTERM while it exists; long computations poll it. A second signal ends the program.
class Interrupt {
public:
    Interrupt()
    {
        for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, onSignal);
    }
    ~Interrupt()
    {
        for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
    }
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    bool came() const { return came_ != 0; }

private:
    static void onSignal(int signal)
    {
        came_ = 1;
        std::signal(signal, SIG_DFL);
    }
    static inline volatile std::sig_atomic_t came_ = 0;
};

}  // namespace terratact
