#include "app/pages/numbers_page.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/display/format.h"
#include "app/shell/key_table.h"
#include "widgets/base/card.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"
#include "widgets/terrain/readings/numbers_table.h"
#include "widgets/terrain/readings/two_track_text.h"
#include "widgets/terrain/readings/verdict_strip.h"

namespace terratact {
namespace {

/// Returns the answer, those of the sides, the probability of a step and the reason.
QStringList textsOf(const TwoTrackVerdict& verdict, double limit)
{
    const Verdict& plane = verdict.side[0];
    if (verdict.onePlane)
        return {VerdictStrip::answerOf(plane), VerdictStrip::probabilityOf(plane, limit),
                VerdictStrip::whyOf(plane)};
    Verdict robot = plane;
    robot.stepVerdict = verdict.both;
    robot.horizon = std::min(plane.horizon, verdict.side[1].horizon);
    robot.feltTo = std::min(plane.feltTo, verdict.side[1].feltTo);
    QStringList texts{VerdictStrip::answerOf(robot), sidesText(verdict), eitherText(verdict, limit),
                      whyText(verdict, false)};
    texts.removeAll(QString());
    return texts;
}

}  // namespace

NumbersPage::NumbersPage(std::function<NumbersViewState()> read, QWidget* parent)
    : Page(parent), read_(std::move(read))
{
    auto* card = new Card(tr("The scene as numbers"), this);
    copy_ = new QPushButton(tr("Copy (Ctrl+C)"), card);
    copy_->setFocusPolicy(Qt::TabFocus);
    setTip(*copy_, tr("Copies the whole table, columns separated by tabs"));
    card->titleRow()->addWidget(copy_);
    verdict_ = new PlainLabel(card);
    verdict_->setWordWrap(true);
    verdict_->setAccessibleName(tr("Verdict"));
    setTone(*verdict_, Tone::Strong);
    summary_ = new PlainLabel(card);
    summary_->setWordWrap(true);
    summary_->setAccessibleName(tr("Estimate"));
    setTone(*summary_, Tone::Muted);
    table_ = new NumbersTable(card);
    card->body()->addWidget(verdict_);
    card->body()->addWidget(summary_);
    card->body()->addWidget(table_, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 10, 12, 10);
    column->addWidget(card);
    connect(copy_, &QPushButton::clicked, table_, &NumbersTable::copy);
    verdict_->hide();
    summary_->setText(read_().whyNoEstimate);
}

void NumbersPage::addKeys(KeyTable& keys)
{
    keys.add({.keys = {QKeyCombination(Qt::CTRL, Qt::Key_C)},
              .meaning = tr("copy the numbers, on their page"),
              .pressed = [this] { table_->copy(); },
              .applies = [this] { return isVisible(); }});
}

void NumbersPage::showVerdict(const NumbersViewState& viewState)
{
    verdict_->setVisible(viewState.verdict.has_value());
    if (!viewState.verdict) return;
    const bool isOld = std::ranges::any_of(viewState.verdict->side, [](const Verdict& side) {
        return std::ranges::find(side.withheldFor, WithholdReason::Stale) != side.withheldFor.end();
    });
    QStringList parts = textsOf(*viewState.verdict, viewState.stepLimit);
    if (isOld && viewState.age)
        parts << tr("last telemetry %1 ago").arg(format::age(*viewState.age));
    const QString text = parts.join(QStringLiteral(" · "));
    if (verdict_->text() == text) return;
    verdict_->setText(text);
    setTone(*verdict_, isOld ? Tone::Bad : Tone::Strong);
}

void NumbersPage::refresh(double /*now*/)
{
    const NumbersViewState viewState = read_();
    showVerdict(viewState);
    if (!viewState.estimate) {
        if (shown_) table_->clearEstimate();
        shown_.reset();
        summary_->setText(viewState.whyNoEstimate);
        return;
    }
    if (shown_ == viewState.revision && shownLimit_ == viewState.stepLimit) return;
    shown_ = viewState.revision;
    const TerrainEstimate& estimate = viewState.estimate->side[0];  // both have the same settings
    shownLimit_ = viewState.stepLimit;
    table_->setEstimate(*viewState.estimate, shownLimit_);
    summary_->setText(
        tr("%1, %2 draws, seed %3; heights above the IMU, steps of more than %4. "
           "The verdict's P counts steps over two bins (%5) anywhere ahead, the "
           "column those to the next bin alone")
            .arg(format::text(name(estimate.settings.method)))
            .arg(estimate.draws.size())
            .arg(estimate.settings.seed)
            .arg(format::length(shownLimit_, 2), format::length(kStepBins * kBinWidth, 1)));
}

}  // namespace terratact
