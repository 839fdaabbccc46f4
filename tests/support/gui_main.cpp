// main() of every GUI test: an offscreen QApplication around GoogleTest, with a screen that is large enough for every
// window, also at two pixels to a point. No display is needed.
#include <gtest/gtest.h>

#include <QApplication>

int main(int argc, char** argv)
{
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM",
                "offscreen:configfile=" TERRATACT_SOURCE_DIR "/tests/data/screens/3840x2400.json");
    testing::InitGoogleTest(&argc, argv);
    const QApplication app(argc, argv);
    return RUN_ALL_TESTS();
}
