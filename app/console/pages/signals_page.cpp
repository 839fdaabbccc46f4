#include "app/console/pages/signals_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/link/can_source.h"
#include "app/link/robot_moment.h"
#include "app/mission/text/bus_text.h"
#include "app/pages/dbc_files.h"
#include "app/plotting/telemetry_signals.h"
#include "widgets/base/card.h"
#include "widgets/base/palette.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"
#include "widgets/control/robot_readout.h"
#include "widgets/signals/raw_trace.h"
#include "widgets/signals/signal_table.h"

namespace terratact {
namespace {

// Update periods slow enough to read.
constexpr double kRows = 0.1, kTrace = 0.2;  // [s]

/// Returns the rows of a line; what a robot may lack has a row only if it was measured.
std::vector<SignalRow> rowsOf(const Measurement& m)
{
    std::vector<SignalRow> rows;
    const auto all = telemetrySignals();
    rows.reserve(kEverySignals);
    for (std::size_t i = 0; i < kEverySignals; ++i) {
        const std::optional<double> value = telemetryValue(i, m);
        if (!value && i >= kSensorSignals) continue;
        SignalRow& row = rows.emplace_back();
        row.name = translated(all[i].name);
        row.value = value ? format::number(*value, 3) : format::kNothing;
        row.unit = format::text(all[i].unit);
    }
    return rows;
}

}  // namespace

QString busLoadText(const BusLoad& load, const BitRate& bitrate)
{
    const double rate = bitrate.bitsPerSecond.value_or(0.0);
    if (!(rate > 0.0))
        return SignalsPage::tr("load --- (bit rate not known): %1 to %2 kbit/s")
            .arg(format::number(load.fewestBits / 1000.0, 1),
                 format::number(load.mostBits / 1000.0, 1));
    const auto percent = [&](double bits) { return format::number(100.0 * bits / rate, 1); };
    const QString said =
        bitrate.nominal
            ? SignalsPage::tr(
                "load %1 to %2 % of nominal %3 kbit/s (without stuff bits, with the most possible)")
            : SignalsPage::tr(
                "load %1 to %2 % of %3 kbit/s (without stuff bits, with the most possible)");
    return said.arg(percent(load.fewestBits), percent(load.mostBits),
                    format::number(rate / 1000.0, 0));
}

SignalsPage::SignalsPage(const RobotMoment& moment, const Acquisition& acquisition, CanSource* link,
                         PreferenceStore& preferences, QWidget* parent)
    : Page(parent), moment_(moment), acquisition_(acquisition), link_(link)
{
    auto* signalCard = new Card(tr("Signals"), this);
    headline_ = new PlainLabel(signalCard);
    headline_->setAccessibleName(tr("State of the bus"));
    headline_->setWordWrap(true);
    table_ = new SignalTable(signalCard);
    signalCard->body()->addWidget(headline_);
    if (link_) addDbc(*signalCard, preferences);
    signalCard->body()->addWidget(table_, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 10, 12, 10);
    if (!link_) {
        column->addWidget(signalCard, 1);
        return;
    }

    auto* traceCard = new Card(tr("Newest frames"), this);
    trace_ = new RawTrace([this](const CanFrame& frame) { return traceText(frame, book_); },
                          [this](const CanFrame& frame) { return frameName(frame, book_.get()); },
                          traceCard);
    traceCard->body()->addWidget(trace_, 1);
    auto* both = new QSplitter(Qt::Vertical, this);
    both->addWidget(signalCard);
    both->addWidget(traceCard);
    both->setStretchFactor(0, 3);
    both->setStretchFactor(1, 2);
    both->setChildrenCollapsible(false);
    column->addWidget(both, 1);
}

void SignalsPage::addDbc(Card& card, PreferenceStore& preferences)
{
    card.note()->hide();
    dbc_ = new DbcFiles(preferences, *this);
    addTools(*card.titleRow());
    dbc_->addLines(*card.body());
    connect(dbc_, &DbcFiles::wereRead, this, [this](const DbcReading& reading) {
        protocol_ = reading.protocol;
        book_ = reading.book;
        link_->tap().describe(book_);
    });
    dbc_->read();
}

void SignalsPage::addTools(QHBoxLayout& row)
{
    row.addStretch(1);
    dbc_->addButtons(row);
    auto* forget = new QPushButton(tr("Reset min and max"), this);
    forget->setFocusPolicy(Qt::TabFocus);
    forget->setMinimumHeight(kTarget);
    setTip(*forget, tr("Counts restart with the next frames"));
    row.addWidget(forget);
    connect(forget, &QPushButton::clicked, this, [this] { link_->tap().forgetExtremes(); });
}

void SignalsPage::refresh(double now)
{
    if (now - shownAt_ >= kRows - 1e-3) {
        shownAt_ = now;
        if (moment_.bus)
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
    const CanView& view = *moment_.bus;
    const auto of = [&](FrameTrouble trouble) {
        return QString::number(load.troubles[static_cast<std::size_t>(trouble)]);
    };
    headline_->setText(
        tr("%1 · %2 frames/s · %3\nSince the start: %4 frames, %5 dropped, %6 error frames, %7 "
           "with "
           "a wrong checksum, %8 out of sequence, %9 not in the DBC")
            .arg(busStateText(view.bus, link_->busName()), format::number(load.framesPerSecond, 0),
                 busLoadText(load, link_->bitrate()), QString::number(load.frames),
                 QString::number(view.frames.dropped), QString::number(view.frames.errorFrames),
                 of(FrameTrouble::WrongChecksum), of(FrameTrouble::WrongSequence),
                 of(FrameTrouble::Unknown)));
    setTone(*headline_, toneOf(view.bus));
    table_->setRows(signalRows(link_->tap().frames(now), protocol_));
}

void SignalsPage::refreshMeasurement(double now)
{
    headline_->setText(
        tr("This source is no CAN bus: it has no frames, and these are its values."));
    const auto& latest = moment_.latest;
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
