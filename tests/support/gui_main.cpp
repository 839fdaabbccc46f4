// main() of every GUI test: an offscreen QApplication around GoogleTest. Its screen is large enough for every window,
// even at a scale factor of 2. No display is needed.
#include <gtest/gtest.h>

#include <QApplication>
#include <cstdio>

int main(int argc, char** argv)
{
    if (qEnvironmentVariable("QT_QPA_PLATFORM", "offscreen") == QLatin1String("offscreen"))
        qputenv("QT_QPA_PLATFORM",
                "offscreen:configfile=" TERRATACT_SOURCE_DIR "/tests/data/screens/3840x2400.json");
    testing::InitGoogleTest(&argc, argv);  // removes its own arguments
    // A window opened for a file is this program again, which must not run the same test again.
    if (argc > 1) {
        std::fprintf(stderr, "no test is run: %s is not for them\n", argv[1]);
        return 0;
    }
    const QApplication app(argc, argv);
    return RUN_ALL_TESTS();
}
