#include "app/console/pages/live_plots.h"

#include "app/mission/exploration.h"
#include "app/pages/dbc_files.h"
#include "app/pages/plots_page.h"
#include "app/runtime/steady_now.h"

namespace terratact {
namespace {

constexpr double kLoad = 0.1;  // [s] period of the load's history

}  // namespace

LivePlots::LivePlots(Acquisition& acquisition, CanSource* link, const Exploration& exploration,
                     PreferenceStore& preferences, QWidget* parent)
    : acquisition_(acquisition), link_(link), exploration_(exploration), signals_(steadyNow()),
      page_(new PlotsPage(signals_, preferences, PlotsPanel::Kind::Live, parent))
{
    acquisition_.listen([this](const Received& sample) { signals_.add(sample); });
    if (link_)
        link_->tap().listen([this](const BusFrame& received, const JudgedFrame& judged) {
            signals_.add(received, judged);
        });
}

LivePlots::~LivePlots()
{
    acquisition_.listen({});
    if (link_) link_->tap().listen({});
}

void LivePlots::describeBy(DbcFiles& dbc)
{
    connect(&dbc, &DbcFiles::wereRead, this,
            [this](const DbcReading& reading) { signals_.describe(reading.book); });
}

void LivePlots::poll(const RobotMoment& moment)
{
    signals_.setNow(moment.now);
    const Estimation& estimation = exploration_.estimation();
    const std::uint64_t revision = estimation.revisions().estimate;
    if (revision != estimate_ && estimation.estimate()) {
        const TwoTrackEstimate& estimate = *estimation.estimate();
        EstimateFacts facts{
            .estimate = estimate, .verdict = estimation.verdict(), .seconds = estimation.seconds()};
        if (const auto& scene = estimation.scene())
            facts.truth = truthOf(estimate.onePlane, scene->truth, scene->sideTruth);
        signals_.add(facts, moment.now);
    }
    estimate_ = revision;
    if (link_ && moment.now - loadAt_ >= kLoad) {
        loadAt_ = moment.now;
        signals_.addFrameRate(link_->tap().load().framesPerSecond, moment.now);
    }
    // In the dock the panel is visible on other pages, which refresh themselves alone.
    if (page_->panel()->isVisible()) page_->refresh(moment.now);
}

}  // namespace terratact
