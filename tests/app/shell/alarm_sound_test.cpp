#include "app/shell/alarm_sound.h"

#include <alsa/asoundlib.h>
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <QPushButton>
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <vector>

#include "app/console/pages/alarms_page.h"
#include "app/mission/console_alarms.h"
#include "core/store/file_read.h"
#include "drivers/audio_output.h"
#include "tests/support/gui.h"
#include "tests/support/temporary_directory.h"
#include "widgets/signals/alarm_table.h"

namespace {

/// Maximum samples the card accepts at once, and whether it was full before.
std::optional<snd_pcm_uframes_t> mostAtOnce;
bool isFull = false;

}  // namespace

/// The library's function, replaced by the one above.
extern "C" snd_pcm_sframes_t snd_pcm_writei(snd_pcm_t* pcm, const void* samples,
                                            snd_pcm_uframes_t count)
{
    static const auto write =
        reinterpret_cast<decltype(&snd_pcm_writei)>(dlsym(RTLD_NEXT, "snd_pcm_writei"));
    if (!mostAtOnce) return write(pcm, samples, count);
    isFull = !isFull;
    return isFull ? -EAGAIN : write(pcm, samples, std::min(count, *mostAtOnce));
}

namespace terratact {
namespace {

constexpr unsigned kRate = 48'000;  // [Hz]

/// A sound card that writes its samples to a file.
struct SoundCard : testing::Test {
    SoundCard()
    {
        install("pcm.silent { type null }\n"
                "pcm.!default { type file slave.pcm silent format raw file \""
                + played + "\" }\n");
    }
    /// Call before the first sound, because the library reads the file once.
    void install(const std::string& config)
    {
        ::setenv("ALSA_CONFIG_PATH", directory.write("asound.conf", config).c_str(), 1);
    }
    std::vector<std::int16_t> heard() const
    {
        const auto bytes = readFile(played, 1U << 20U);
        if (!bytes) return {};
        std::vector<std::int16_t> samples(bytes->size() / sizeof(std::int16_t));
        std::memcpy(samples.data(), bytes->data(), samples.size() * sizeof(std::int16_t));
        return samples;
    }
    TemporaryDirectory directory;
    std::string played = directory.file("played.raw");
};

TEST(AlarmSamples, areTwoTonesThatNeitherClickNorClip)
{
    const std::vector<std::int16_t> samples = alarmSamples(kRate);
    const double seconds = static_cast<double>(samples.size()) / kRate;
    EXPECT_GT(seconds, 0.3);
    EXPECT_LT(seconds, 0.6);
    const auto [least, most] = std::minmax_element(samples.begin(), samples.end());
    EXPECT_GT(*most, 18'000);
    EXPECT_LT(*least, -18'000);
    EXPECT_EQ(samples.front(), 0);
    EXPECT_EQ(samples.back(), 0);
    int step = 0;
    for (std::size_t i = 1; i < samples.size(); ++i)
        step = std::max(step, std::abs(samples[i] - samples[i - 1]));
    EXPECT_LT(step, 4000) << "a jump clicks";
}

TEST(ContactSamples, areShortSoftAndUnlikeTheAlarm)
{
    const std::vector<std::int16_t> samples = contactSamples(kRate, 528.0, 1.0);
    EXPECT_LT(static_cast<double>(samples.size()) / kRate, 0.1) << "the alarm waits no longer";
    const auto [least, most] = std::minmax_element(samples.begin(), samples.end());
    EXPECT_GT(*most, 2000);
    EXPECT_LT(std::max(-*least, +*most), 9000) << "less than half of the alarm";
    EXPECT_EQ(samples.front(), 0);
    EXPECT_NEAR(samples.back(), 0, 50);
    const auto soft = contactSamples(kRate, 528.0, 0.2);
    EXPECT_LT(*std::max_element(soft.begin(), soft.end()), *most / 4);
    const auto silent = contactSamples(kRate, 528.0, 0.0);
    EXPECT_EQ(*std::max_element(silent.begin(), silent.end()), 0);
}

TEST_F(SoundCard, isGivenATick)
{
    const auto tone = alarmTone();
    tone->tick(444.0, 0.5);
    const auto wanted = contactSamples(kRate, 444.0, 0.5);
    ASSERT_TRUE(gui::eventually([&] { return heard().size() >= wanted.size(); }));
    EXPECT_EQ(heard(), wanted);
}

TEST_F(SoundCard, isGivenTheAlarmBeforeATick)
{
    const auto tone = alarmTone();
    tone->sound();
    tone->tick(444.0, 1.0);
    auto wanted = alarmSamples(kRate);
    ASSERT_TRUE(gui::eventually([&] { return heard().size() >= wanted.size(); }));
    auto begin = heard();
    begin.resize(wanted.size());
    EXPECT_EQ(begin, wanted);
}

TEST_F(SoundCard, isGivenEverySampleOfTheTone)
{
    const auto tone = alarmTone();
    tone->sound();
    const auto wanted = alarmSamples(kRate);
    ASSERT_TRUE(gui::eventually([&] { return heard().size() >= wanted.size(); }));
    EXPECT_EQ(heard(), wanted);
    EXPECT_EQ(tone->trouble(), "");
}

TEST_F(SoundCard, isGivenEverySampleWhereItTakesAFewAtATime)
{
    mostAtOnce = 1000;
    const std::vector<std::int16_t> wanted = alarmSamples(kRate);
    const Status done = playAudio("default", wanted, kRate);
    mostAtOnce.reset();
    EXPECT_TRUE(done) << done.error().text;
    EXPECT_EQ(heard(), wanted);
}

TEST_F(SoundCard, takesASoundThatIsShorterThanItsBuffer)
{
    const std::vector<std::int16_t> click{0, 1000, -1000, 0};
    const Status done = playAudio("default", click, kRate);
    EXPECT_TRUE(done) << done.error().text;
    EXPECT_EQ(heard(), click);
}

TEST_F(SoundCard, missingIsNamed)
{
    const Status done = playAudio("no-such-card", alarmSamples(kRate), kRate);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().text,
              "sound device no-such-card: cannot be opened: No such file or directory");
}

TEST_F(SoundCard, missingIsReportedOnThePage)
{
    install("pcm.!default { type hw card 31 }\n");
    ConsoleAlarms alarms(alarmTone());
    AlarmsPage page(alarms);
    gui::showActive(page);
    page.table()->trySoundButton()->click();
    ASSERT_TRUE(gui::eventually([&] { return !alarms.soundTrouble().isEmpty(); }));
    page.refresh(0.0);
    EXPECT_TRUE(std::ranges::any_of(page.findChildren<QLabel*>(), [](const QLabel* label) {
        return label->isVisible() && label->text().contains("Only the desktop's bell can sound");
    }));
}

}  // namespace
}  // namespace terratact
