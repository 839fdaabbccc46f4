#pragma once

#include <csignal>
#include <initializer_list>

namespace terratact {

/// From its construction on, Ctrl+C (SIGINT) and SIGTERM end nothing by themselves: whoever computes asks.  A second
/// signal ends the program as if nobody asked.
class Interrupt {
public:
    Interrupt()
    {
        for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, take);
    }
    ~Interrupt()
    {
        for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
    }
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    bool came() const { return came_ != 0; }

private:
    static void take(int signal)
    {
        came_ = 1;
        std::signal(signal, SIG_DFL);
    }
    static inline volatile std::sig_atomic_t came_ = 0;
};

}  // namespace terratact
