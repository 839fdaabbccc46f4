#include "app/console/past/history_control.h"

#include <cmath>
#include <utility>

#include "app/console/past/history_window.h"
#include "app/console/past/past_text.h"
#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/mission/estimate_history.h"
#include "app/mission/exploration.h"
#include "app/pages/terrain_page.h"
#include "app/shell/console_window.h"

namespace terratact {
namespace {

/// Returns a revision that no present estimate has.
std::uint64_t pastRevision(std::int64_t number)
{
    return (std::uint64_t{1} << 62U) + static_cast<std::uint64_t>(number);
}

}  // namespace

HistoryControl::HistoryControl(Exploration& exploration, ConsoleWindow& window)
    : exploration_(exploration), console_(window), history_(new EstimateHistory(exploration, this))
{
}

HistoryControl::~HistoryControl() = default;

void HistoryControl::open()
{
    if (!list_) {
        list_ = new HistoryWindow(*history_, &console_);
        connect(list_, &HistoryWindow::showWanted, this, &HistoryControl::show);
        connect(list_, &HistoryWindow::layWanted, this, &HistoryControl::lay);
        connect(list_, &HistoryWindow::presentWanted, this, &HistoryControl::showPresent);
        connect(list_, &HistoryWindow::restoreWanted, &exploration_, &Exploration::restoreResult);
    }
    if (!list_->isVisible()) {
        list_->resize(console_.roomBelowHeader().boundedTo(
            list_->sizeHint().expandedTo({console_.width() / 3, console_.height() * 2 / 3})));
        console_.putBelowHeader(*list_);
    }
    list_->setShown(shown_, laid_, exploration_.canRestore());
    list_->show();
    list_->raise();
    list_->activateWindow();
}

void HistoryControl::show(std::int64_t number)
{
    if (number == history_->present()) return showPresent();
    const PastEstimate* const past = history_->entry(number);
    if (!past || number == shown_) return;
    shown_ = number;
    laid_ = 0;
    standing_ = exploration_.estimation().revisions().estimate;
    emit happened(Message(TR_NOOP("terratact::HistoryControl",
                                  "the picture shows the estimate of %1, not the present one"),
                          verbatim(PastText::time(*past))),
                  EventSeverity::Note);
}

void HistoryControl::lay(std::int64_t number)
{
    if (!history_->entry(number)) number = 0;
    shown_ = 0;
    laid_ = number == history_->present() ? 0 : number;
    standing_ = exploration_.estimation().revisions().estimate;
}

void HistoryControl::showPresent()
{
    laid_ = 0;
    if (std::exchange(shown_, 0) != 0)
        emit happened(
            TR_NOOP("terratact::HistoryControl", "the picture shows the present estimate again"),
            EventSeverity::Note);
}

QString HistoryControl::banner() const
{
    if (const PastEstimate* const laid = history_->entry(laid_))
        return tr("Dashed in the picture: the past estimate of %1%2. Backspace takes it away")
            .arg(PastText::time(*laid), drivenSince_);
    const PastEstimate* const past = history_->entry(shown_);
    if (!past) return {};
    return tr("The picture shows the estimate of %1, not the present one. Backspace: the present")
        .arg(PastText::time(*past));
}

/// Returns true if something came that the operator must see in the picture.
bool HistoryControl::isOvertaken(const TerrainViewState& viewState) const
{
    const bool drives =
        viewState.measurement && viewState.measurement->activity == RobotActivity::Driving;
    return viewState.live || exploring(viewState.state.phase) || drives
        || (viewState.estimate && standing_ != exploration_.estimation().revisions().estimate);
}

/// Shows in the banner how far the robot has driven since. The picture has the robot's frame of the past estimate.
void HistoryControl::showWaySince(const PastEstimate& past, const Measurement* now)
{
    constexpr double kStill = 0.005;  // [m]
    const auto &then = past.scene.travelled, &here = now ? now->travelled : std::nullopt;
    if (!then || !here)
        drivenSince_ = tr(", not moved by what was driven since");
    else if (const double way = *here - *then; std::abs(way) < kStill)
        drivenSince_.clear();
    else
        drivenSince_ = tr(", not moved by the %1 driven since").arg(format::signedLength(way, 2));
}

void HistoryControl::apply(TerrainViewState& viewState)
{
    const PastEstimate* const shown = history_->entry(shown_);
    const PastEstimate* const laid = history_->entry(laid_);
    if ((shown_ != 0 || laid_ != 0) && ((!shown && !laid) || isOvertaken(viewState))) {
        showPresent();
    } else if (shown) {
        viewState.past = {.estimate = {shown->estimate.get(), pastRevision(shown->number)},
                          .scene = &shown->scene,
                          .truth = &shown->truth,
                          .sideTruth = &shown->sideTruth,
                          .note = PastText::note(*shown)};
    } else if (laid) {
        showWaySince(*laid, viewState.measurement);
        viewState.second = {laid->estimate.get(), pastRevision(laid->number)};
        viewState.secondName = tr("past: estimate of %1").arg(PastText::time(*laid));
    }
    if (list_) list_->setShown(shown_, laid_, exploration_.canRestore());
}

}  // namespace terratact
