#include "app/signals_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/acquisition.h"
#include "app/bus_words.h"
#include "app/can_source.h"
#include "app/can_words.h"
#include "widgets/card.h"
#include "widgets/look.h"
#include "widgets/palette.h"
#include "widgets/raw_trace.h"
#include "widgets/robot_readout.h"
#include "widgets/words.h"

namespace terratact {
namespace {

// A number that changes more often cannot be read.
constexpr double kRows = 0.1, kTrace = 0.2;  // [s]

QString frameName(const CanFrame& frame)
{
    if (frame.error) return SignalsPage::tr("error frame");
    const bool mayBeOurs = !frame.extended && !frame.remote && !frame.fd;
    const auto kind = mayBeOurs ? kindOfId(frame.id) : std::nullopt;
    return kind ? words::text(layoutOf(*kind).name) : SignalsPage::tr("unknown");
}

/// As wordsOf() says it; names are those of the DBC in every language.
QString contentOf(const std::vector<NamedValue>& values)
{
    if (values.size() == 1 && values[0].name == "Measured") return words::sentence("not measured");
    QStringList parts;
    for (const NamedValue& value : values)
        parts << QStringLiteral("%1 %2 %3")
                     .arg(words::text(value.name), words::sentence(value.value),
                          words::text(value.unit))
                     .trimmed();
    return parts.join(QStringLiteral(", "));
}

TraceWords wordsFor(const CanFrame& frame)
{
    // A reader of its own: what the frame says is the same whatever came before.
    const FrameWords said = frameReader(CanProtocol::Terratact)->read(frame, 0.0);
    return {.id = words::text(idText(frame)),
            .name = frameName(frame),
            .bytes = words::text(bytesText(frame)),
            .content = said.values.empty() && frame.error ? words::text(said.verdict)
                                                          : contentOf(said.values)};
}

SignalRow::Standing standingOf(const TappedFrame& frame)
{
    using Standing = SignalRow::Standing;
    if (!frame.age || !frame.isMeasured) return Standing::Stale;
    if (*frame.age <= BusTap::kFresh) return Standing::Fresh;
    const bool isCyclic = frame.kind && layoutOf(*frame.kind).period > 0.0;
    return isCyclic ? Standing::Stale : Standing::Said;
}

QString valueText(const SignalLayout& layout, const std::optional<double>& value)
{
    return value ? words::sentence(wordOf(layout, *value)).replace(QLatin1Char('-'), QChar(0x2212))
                 : words::kNothing;
}

/// A number that only names something has neither least nor most.
bool isQuantity(const SignalLayout& layout)
{
    return !layout.unit.empty();
}

SignalRow rowOf(const TappedFrame& frame, const SignalLayout& layout, const TappedSignal& signal)
{
    SignalRow row;
    row.name = words::text(layout.name);
    row.unit = words::text(layout.unit);
    row.rate = frame.rate;
    row.age = frame.age;
    row.standing = standingOf(frame);
    if (layout.name == "Measured" && frame.age && *frame.age <= BusTap::kFresh)
        row.standing = SignalRow::Standing::Fresh;
    row.value = valueText(layout, signal.last);
    if (isQuantity(layout)) {
        row.least = valueText(layout, signal.least);
        row.most = valueText(layout, signal.most);
    }
    row.history.assign(signal.history.begin(), signal.history.end());
    return row;
}

SignalRow wholeFrame(const TappedFrame& frame)
{
    SignalRow row;
    row.rate = frame.rate;
    row.age = frame.age;
    row.standing = standingOf(frame);
    row.value = words::text(bytesText(frame.newest));
    return row;
}

SignalRow quantity(const QString& name, double value, const QString& unit)
{
    SignalRow row;
    row.name = name;
    row.value = words::number(value, 3);
    row.unit = unit;
    return row;
}

std::vector<SignalRow> rowsOf(const Measurement& m)
{
    const QString radians = QStringLiteral("rad"), amperes = QStringLiteral("A");
    std::vector<SignalRow> rows{
        quantity(SignalsPage::tr("pitch"), m.pitch, radians),
        quantity(SignalsPage::tr("roll"), m.roll, radians),
        quantity(SignalsPage::tr("front flipper left"), m.frontLeft, radians),
        quantity(SignalsPage::tr("front flipper right"), m.frontRight, radians),
        quantity(SignalsPage::tr("rear flipper left"), m.rearLeft, radians),
        quantity(SignalsPage::tr("rear flipper right"), m.rearRight, radians),
        quantity(SignalsPage::tr("front current left"), m.frontLeftCurrent, amperes),
        quantity(SignalsPage::tr("front current right"), m.frontRightCurrent, amperes),
        quantity(SignalsPage::tr("rear current left"), m.rearLeftCurrent, amperes),
        quantity(SignalsPage::tr("rear current right"), m.rearRightCurrent, amperes)};
    for (std::size_t i = 0; i < m.force.size(); ++i)
        rows.push_back(
            quantity(SignalsPage::tr("force %1").arg(i + 1), m.force[i], QStringLiteral("N")));
    if (m.travelled)
        rows.push_back(
            quantity(SignalsPage::tr("way of the tracks"), *m.travelled, QStringLiteral("m")));
    return rows;
}

}  // namespace

std::vector<SignalRow> signalRows(const std::vector<TappedFrame>& frames)
{
    std::vector<SignalRow> rows;
    for (const TappedFrame& frame : frames) {
        const std::size_t first = rows.size();
        if (frame.kind) {
            const auto layout = layoutOf(*frame.kind).payload;
            for (std::size_t i = 0; i < layout.size(); ++i)
                rows.push_back(rowOf(frame, layout[i], frame.payload[i]));
        }
        if (rows.size() == first) rows.push_back(wholeFrame(frame));
        rows[first].frame =
            QStringLiteral("%1 %2").arg(words::text(idText(frame.newest)), frameName(frame.newest));
    }
    return rows;
}

QString loadWords(const BusLoad& load, const BitRate& bitrate)
{
    const double rate = bitrate.bitsPerSecond.value_or(0.0);
    if (!(rate > 0.0))
        return SignalsPage::tr("load --- (bit rate not known): %1 to %2 kbit/s")
            .arg(words::number(load.fewestBits / 1000.0, 1),
                 words::number(load.mostBits / 1000.0, 1));
    const auto percent = [&](double bits) { return words::number(100.0 * bits / rate, 1); };
    const QString said =
        bitrate.nominal
            ? SignalsPage::tr("load %1 to %2 % of nominal %3 kbit/s (without stuff bits, with all "
                              "there can be)")
            : SignalsPage::tr(
                "load %1 to %2 % of %3 kbit/s (without stuff bits, with all there can be)");
    return said.arg(percent(load.fewestBits), percent(load.mostBits),
                    words::number(rate / 1000.0, 0));
}

SignalsPage::SignalsPage(const Acquisition& acquisition, CanSource* link, QWidget* parent)
    : Page(parent), acquisition_(acquisition), link_(link)
{
    auto* signalCard = new Card(tr("Signals"), this);
    headline_ = new QLabel(signalCard);
    headline_->setAccessibleName(tr("State of the bus"));
    headline_->setTextFormat(Qt::PlainText);
    headline_->setWordWrap(true);
    table_ = new SignalTable(signalCard);
    signalCard->body()->addWidget(headline_);
    signalCard->body()->addWidget(table_, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 10, 12, 10);
    if (!link_) {
        column->addWidget(signalCard, 1);
        return;
    }
    signalCard->note()->hide();
    auto* forget = new QPushButton(tr("Forget least and most"), signalCard);
    forget->setFocusPolicy(Qt::TabFocus);
    forget->setMinimumHeight(kTarget);
    connect(forget, &QPushButton::clicked, this, [this] { link_->tap().forgetExtremes(); });
    signalCard->titleRow()->addStretch(1);
    signalCard->titleRow()->addWidget(forget);

    auto* traceCard = new Card(tr("Newest frames"), this);
    trace_ = new RawTrace(wordsFor, frameName, traceCard);
    traceCard->body()->addWidget(trace_, 1);
    auto* both = new QSplitter(Qt::Vertical, this);
    both->addWidget(signalCard);
    both->addWidget(traceCard);
    both->setStretchFactor(0, 3);
    both->setStretchFactor(1, 2);
    both->setChildrenCollapsible(false);
    column->addWidget(both, 1);
}

void SignalsPage::refresh(double now)
{
    if (now - shownAt_ >= kRows - 1e-3) {
        shownAt_ = now;
        if (link_)
            refreshBus(now);
        else
            refreshMeasurement(now);
    }
    if (link_ && now - tracedAt_ >= kTrace - 1e-3) {
        tracedAt_ = now;
        trace_->setFrames(link_->tap().trace());
    }
}

void SignalsPage::refreshBus(double now)
{
    const BusLoad load = link_->tap().load();
    const CanView view = link_->view();
    const auto of = [&](FrameTrouble trouble) {
        return QString::number(load.troubles[static_cast<std::size_t>(trouble)]);
    };
    headline_->setText(
        tr("%1 · %2 frames/s · %3\nSince the start: %4 frames, %5 dropped, %6 error frames, %7 "
           "with "
           "a wrong checksum, %8 out of sequence, %9 not in the DBC")
            .arg(busWords(view.bus, link_->busName()), words::number(load.framesPerSecond, 0),
                 loadWords(load, link_->bitrate()), QString::number(load.frames),
                 QString::number(view.frames.dropped), QString::number(view.frames.errorFrames),
                 of(FrameTrouble::WrongChecksum), of(FrameTrouble::WrongSequence),
                 of(FrameTrouble::Unknown)));
    const bool isSound = view.bus == BusState::Up || view.bus == BusState::Ended;
    setTone(*headline_, isSound ? Tone::Plain : Tone::Bad);
    table_->setRows(signalRows(link_->tap().frames(now)));
}

void SignalsPage::refreshMeasurement(double now)
{
    headline_->setText(
        tr("This source is no CAN bus: it has no frames, and these are its values."));
    const auto latest = acquisition_.latest();
    if (!latest) return table_->setRows({});
    const double age = now - secondsOf(latest->arrived);
    std::vector<SignalRow> rows = rowsOf(latest->sample.measurement);
    for (SignalRow& row : rows) {
        row.age = age;
        row.rate = acquisition_.rate();
        row.standing = age <= kStaleAfter ? SignalRow::Standing::Fresh : SignalRow::Standing::Stale;
    }
    table_->setRows(std::move(rows));
}

QString SignalsPage::headline() const
{
    return headline_->text();
}

}  // namespace terratact
