// Tests that the terrain is the largest part of its page in every font, window size, layout and language.
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "app/console/main_window.h"
#include "app/start/language.h"
#include "core/sim/ground/terrain_shapes.h"
#include "tests/support/absolem.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "tests/support/sim_source.h"
#include "widgets/base/card.h"
#include "widgets/base/theme.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

using gui::eventually;

constexpr QSize kWindows[]{{1200, 680}, {1366, 768}, {1440, 900}, {1920, 1080}};
constexpr double kWider = 1.15;  ///< minimum ratio to the width of any card beside it

std::unique_ptr<MainWindow> openConsole()
{
    SimulatedRobot::Options simulated;
    simulated.startX = 2.1;
    MainWindow::Options options;
    options.robot = absolem();
    options.source =
        std::make_unique<SimSource>(SimulatedRobot(options.robot, demoTerrain(), simulated), 20.0);
    options.model = []() -> Result<LoadedModel> {
        return LoadedModel{.estimate =
                               [](const EstimateRequest& request, const Watch&) {
                                   TerrainEstimate e = stepEstimate();
                                   e.settings = request.settings;
                                   return equalSides(e);
                               },
                           .name = "fake.ttm",
                           .details = {}};
    };
    options.exploration.linkLostAfter = options.exploration.staleAfter = 30.0;
    options.exploration.limits = {
        .halt = 600.0, .press = 600.0, .estimate = 600.0, .approval = 600.0, .probe = 600.0};
    auto window = std::make_unique<MainWindow>(std::move(options));
    gui::showActive(*window);
    return window;
}

int area(const QWidget& widget)
{
    return widget.width() * widget.height();
}

/// Returns the outermost visible cards of the page except the terrain's.
QList<const Card*> otherCards(const MainWindow& window, const QWidget& terrain)
{
    QList<const Card*> cards;
    for (const Card* card : window.findChildren<Card*>())
        if (card->isVisible() && card != &terrain) cards << card;
    return cards;
}

void expectTerrainFirst(MainWindow& window, const std::string& where)
{
    const QWidget& terrain = *window.terrain()->parentWidget();
    const auto smaller = [&] {
        for (const Card* card : otherCards(window, terrain))
            if (area(terrain) <= 1.2 * area(*card)
                || (card->mapTo(&window, QPoint()).y()
                        < terrain.mapTo(&window, QPoint()).y() + terrain.height()
                    && terrain.width() < kWider * card->width()))
                return card;
        return static_cast<const Card*>(nullptr);
    };
    QTest::qWait(20);
    (void)eventually([&] { return !smaller() && gui::cramped(window).empty(); },
                     1000);  // waits for the layout
    for (const std::string& text : gui::cramped(window))
        ADD_FAILURE() << where << ", letters " << lookInForce().fontScale << ": " << text;
    if (const Card* card = smaller())
        ADD_FAILURE() << where << ", letters " << lookInForce().fontScale << ": terrain "
                      << terrain.width() << " x " << terrain.height() << " (drawn "
                      << window.terrain()->width() << " x " << window.terrain()->height()
                      << "), a card " << card->width() << " x " << card->height();
}

struct TerrainFirst : testing::TestWithParam<const char*> {
    void SetUp() override
    {
        ASSERT_EQ(installLanguage(*qApp, GetParam()), QLatin1String(GetParam()));
        applyLook(*qApp);
        window = openConsole();
    }
    void TearDown() override
    {
        window.reset();
        installLanguage(*qApp, "en");
        applyLook(*qApp);
    }
    void inEveryWindow(const char* state)
    {
        for (const int letters : {100, 150, 200})
            for (const QSize size : kWindows)
                for (const auto& [layout, name] :
                     {std::pair{Layout::Probe, "probe"}, std::pair{Layout::Drive, "drive"}}) {
                    window->setRoom(size);
                    window->preferences().change([=, layout = layout](Preferences& p) {
                        p.fontScale = letters;
                        p.layout = layout;
                    });
                    window->resize(size);
                    const std::string where = std::string(state) + ", " + name + ", "
                                            + std::to_string(letters) + " %, "
                                            + std::to_string(size.width());
                    expectTerrainFirst(*window, where);
                    const QString folder = qEnvironmentVariable("TERRATACT_PICTURES");
                    if (!folder.isEmpty())
                        window->grab().save(QStringLiteral("%1/%2_%3_%4_%5_%6.png")
                                                .arg(folder, state, name, GetParam())
                                                .arg(letters)
                                                .arg(size.width()));
                }
    }
    std::unique_ptr<MainWindow> window;
};

TEST_P(TerrainFirst, isLargestBeforeAndDuringAProbeProposal)
{
    ASSERT_TRUE(eventually([&] { return window->atemPanel()->requestButton()->isEnabled(); }));
    inEveryWindow("ready");
    QTest::keyClick(window.get(), Qt::Key_A);
    ASSERT_TRUE(eventually([&] { return window->probeCard()->asks(); }, 60000));
    inEveryWindow("asked");
}

INSTANTIATE_TEST_SUITE_P(Languages, TerrainFirst, testing::Values("en", "cs", "de"));

}  // namespace
}  // namespace terratact
