#include "drivers/audio_output.h"

#include <alsa/asoundlib.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>

namespace terratact {
namespace {

constexpr unsigned kLatency = 100'000;                // [us]
constexpr std::chrono::milliseconds kPatience{1000};  // longest wait for room in the buffer

struct Close {
    void operator()(snd_pcm_t* pcm) const { snd_pcm_close(pcm); }
};
using Pcm = std::unique_ptr<snd_pcm_t, Close>;

// ALSA would print its messages on the terminal.
void ignoreAlsaError(const char* /*file*/, int /*line*/, const char* /*function*/, int /*error*/,
                     const char* /*format*/, ...)
{
}

}  // namespace

Status playAudio(const std::string& device, std::span<const std::int16_t> samples, unsigned rate)
{
    const auto failed = [&device](const char* what, long error) {
        const int code = static_cast<int>(-error);
        return Error{fmt::format("sound device {}: {}: {}", device, what,
                                 snd_strerror(static_cast<int>(error))),
                     code};
    };
    snd_lib_error_set_handler(ignoreAlsaError);
    snd_pcm_t* opened = nullptr;
    // Non-blocking, because another program may hold the device.
    if (const int error =
            snd_pcm_open(&opened, device.c_str(), SND_PCM_STREAM_PLAYBACK, SND_PCM_NONBLOCK);
        error < 0)
        return failed("cannot be opened", error);
    const Pcm pcm(opened);
    if (const int error = snd_pcm_set_params(opened, SND_PCM_FORMAT_S16,
                                             SND_PCM_ACCESS_RW_INTERLEAVED, 1, rate, 1, kLatency);
        error < 0)
        return failed("takes no such samples", error);
    while (!samples.empty()) {
        const auto wrote = snd_pcm_writei(opened, samples.data(), samples.size());
        if (wrote > 0) {
            samples = samples.subspan(static_cast<std::size_t>(wrote));
            continue;
        }
        const long error = wrote == -EAGAIN
                             ? snd_pcm_wait(opened, static_cast<int>(kPatience.count()))
                             : snd_pcm_recover(opened, static_cast<int>(wrote), 1);
        if (wrote == -EAGAIN && error == 0) return failed("takes no more", -ETIMEDOUT);
        if (error < 0) return failed("cannot be written to", error);
    }
    // short sounds do not start by themselves
    if (snd_pcm_state(opened) == SND_PCM_STATE_PREPARED) snd_pcm_start(opened);
    snd_pcm_sframes_t left = 0;
    if (snd_pcm_delay(opened, &left) == 0 && left > 0)
        std::this_thread::sleep_for(
            std::min(std::chrono::milliseconds(1000L * left / rate), kPatience));
    return Done{};
}

}  // namespace terratact
