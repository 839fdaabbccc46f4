#include "widgets/terrain/readings/estimate_strip.h"

#include <QEvent>
#include <QFontMetrics>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "app/display/format.h"
#include "app/display/place_text.h"
#include "app/display/translated.h"
#include "core/infer/estimate/two_track_estimate.h"
#include "widgets/base/elided_label.h"
#include "widgets/base/palette.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

QString methodName(Method method)
{
    switch (method) {
    case Method::Pa: return QStringLiteral("PA");
    case Method::Pac: return QStringLiteral("PAC");
    case Method::Pafc: return QStringLiteral("PAFc");
    case Method::Pafac: return QStringLiteral("PAFAc");
    case Method::Clearance: return QStringLiteral("clearance");
    case Method::Joint: return QStringLiteral("joint");
    case Method::Local: return QStringLiteral("local");
    case Method::Trail: return QStringLiteral("trail");
    }
    return {};
}

/// Returns the reason that sampling ended; empty: nothing was sampled.
QString endingText(Ending ending)
{
    switch (ending) {
    case Ending::Converged: return EstimateStrip::tr("ended: converged");
    case Ending::Sweeps: return EstimateStrip::tr("ended: all draws made");
    case Ending::Time: return EstimateStrip::tr("ended: time limit");
    case Ending::NotSampled: break;
    }
    return {};
}

std::vector<Message> warningsOf(const TerrainEstimate& estimate)
{
    if (!estimate.converged && estimate.warnings.empty())
        return {TR_NOOP("terratact::EstimateStrip", "the chains have not converged")};
    return estimate.warnings;
}

double largestSd(const TerrainEstimate& estimate)
{
    return *std::ranges::max_element(estimate.sd);
}

}  // namespace

EstimateStrip::EstimateStrip(QWidget* parent) : QWidget(parent)
{
    headline_ = new ElidedLabel(this);
    headline_->setAccessibleName(tr("Result"));
    headline_->setProperty("headline", true);
    details_ = new PlainLabel(this);
    details_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setTone(*details_, Tone::Muted);
    warnings_ = new PlainLabel(this);
    warnings_->setWordWrap(true);
    warnings_->setAccessibleName(tr("Warnings about the result"));
    setTone(*warnings_, Tone::Warning);
    progress_ = new QProgressBar(this);
    progress_->setRange(0, 1000);
    progress_->setAccessibleName(tr("Progress of the estimate"));
    cancel_ = new QPushButton(tr("Cancel (Esc)"), this);
    cancel_->setFocusPolicy(Qt::TabFocus);
    setTip(*cancel_, tr("Ends the estimate and the exploration"));

    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    row->addWidget(headline_);
    row->addStretch(1);
    row->addWidget(details_);
    row->addWidget(progress_, 100);  // grows up to its maximum width
    row->addWidget(cancel_);
    connect(cancel_, &QPushButton::clicked, this, &EstimateStrip::cancelled);
    setNothing(QString());
    setProgress(std::nullopt);
    resizeToFont();
}

void EstimateStrip::resizeToFont()
{
    setFixedHeight(scaled(kTarget));
    progress_->setMaximumWidth(scaled(180));
    arrange();
}

void EstimateStrip::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange && cancel_) resizeToFont();
}

void EstimateStrip::setEstimate(const TerrainEstimate& plane, double seconds, const QString& memory)
{
    showEstimate(plane, ProbeSide::Middle, seconds, memory);
    showWarnings(warningsOf(plane));
}

void EstimateStrip::setEstimate(const TwoTrackEstimate& estimate, double seconds,
                                const QString& memory)
{
    if (estimate.onePlane) return setEstimate(estimate.side[0], seconds, memory);
    const auto& [left, right] = estimate.side;
    const bool isLeft = largestSd(left) >= largestSd(right);
    showEstimate(isLeft ? left : right, isLeft ? ProbeSide::Left : ProbeSide::Right, seconds,
                 memory);
    showWarnings(ofBothSides(warningsOf(left), warningsOf(right)));
}

/// Shows the numbers of an estimate; side: of two tracks, the one with the largest sd.
void EstimateStrip::showEstimate(const TerrainEstimate& estimate, ProbeSide side, double seconds,
                                 const QString& memory)
{
    const auto widest = std::ranges::max_element(estimate.sd) - estimate.sd.begin();
    const auto at = static_cast<std::size_t>(widest);
    const bool doubtful = estimate.sd[at] > estimate.settings.probeAbove;
    const QString bin = sidePlace({static_cast<int>(widest), side});
    const QString sd = format::length(estimate.sd[at], 2);
    headline_->setText(doubtful ? tr("Uncertain at %1: ± %2").arg(bin, sd)
                                : tr("Known to ± %1, widest at %2").arg(sd, bin));
    headline_->setVisible(true);
    setTone(*headline_, doubtful ? Tone::Warning : Tone::Good);
    const QString dot = QStringLiteral(" · ");
    const QString method = methodName(estimate.settings.method);
    const QString made =
        tr("%1 · %2 draws · %3").arg(method).arg(estimate.draws.size()).arg(format::age(seconds));
    const QString ended = endingText(estimate.ending);
    QString all = ended.isEmpty() ? made : made + dot + ended;
    const QString shown = estimate.ending == Ending::Time ? all : made;
    detailTexts_ = {shown};
    if (!memory.isEmpty()) {
        const QString onlyWay = memory.section(dot, 0, 0);
        detailTexts_ = {shown + dot + memory, method + dot + memory, method + dot + onlyWay,
                        method};
        detailTexts_.removeDuplicates();
    }
    if (!memory.isEmpty()) all += dot + memory;
    for (QLabel* const label : std::initializer_list<QLabel*>{headline_, details_})
        setTip(*label, all);
    arrange();
}

void EstimateStrip::showWarnings(const std::vector<Message>& warnings)
{
    QStringList texts;
    for (const Message& warning : warnings) texts << translated(warning);
    warnings_->setText(texts.isEmpty() ? QString()
                                       : QStringLiteral("! ") + texts.join(QStringLiteral(" · ")));
    warnings_->setVisible(!texts.isEmpty());
}

void EstimateStrip::setLive(const QString& note)
{
    setNothing(note);
    setTone(*headline_, Tone::Warning);
}

void EstimateStrip::setNothing(const QString& why)
{
    headline_->setText(why);
    headline_->setVisible(!why.isEmpty());
    setTip(*headline_, QString());
    setTone(*headline_, Tone::Muted);
    details_->clear();
    detailTexts_.clear();
    warnings_->clear();
    warnings_->setVisible(false);
}

void EstimateStrip::setProgress(std::optional<double> share)
{
    progress_->setVisible(share.has_value());
    cancel_->setVisible(share.has_value());
    arrange();
    if (!share) return;
    const double done = std::isfinite(*share) ? std::clamp(*share, 0.0, 1.0) : 0.0;
    progress_->setValue(static_cast<int>(done * 1000.0));
    progress_->setFormat(tr("estimating %p %"));
}

void EstimateStrip::arrange()
{
    // Showing a part triggers a layout that may call this function again.
    if (std::exchange(arranges_, true)) return;
    const int room = width() - headline_->sizeHint().width() - 3 * layout()->spacing();
    const QFontMetrics metrics = details_->fontMetrics();
    const auto fits = [&](const QString& text) { return metrics.size(0, text).width() <= room; };
    const auto fitting = std::ranges::find_if(detailTexts_, fits);
    const bool isRoom = fitting != detailTexts_.end();
    QString text = isRoom ? *fitting : detailTexts_.value(0);
    // Better the begin of a reason that nothing is remembered than the method alone. A number is never cut.
    const bool isAlone = isRoom && detailTexts_.size() > 1 && text == detailTexts_.last();
    const QString longer = isAlone ? detailTexts_.at(detailTexts_.size() - 2) : QString();
    const QString cut = text + QStringLiteral(" · no memory: …");
    const bool isReason = metrics.size(0, longer).width() > 5 * metrics.size(0, cut).width() / 4;
    if (isReason && fits(cut)) text = metrics.elidedText(longer, Qt::ElideRight, room);
    if (details_->text() != text) details_->setText(text);
    details_->setVisible(progress_->isHidden() && isRoom);
    arranges_ = false;
}

void EstimateStrip::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    arrange();
}

bool EstimateStrip::event(QEvent* event)
{
    const bool handled = QWidget::event(event);
    if (event->type() == QEvent::LayoutRequest && cancel_) arrange();  // the parts need a new width
    return handled;
}

QString EstimateStrip::headline() const
{
    return headline_->text();
}

QString EstimateStrip::details() const
{
    return details_->text();
}

QString EstimateStrip::warningText() const
{
    return warnings_->text();
}

}  // namespace terratact
