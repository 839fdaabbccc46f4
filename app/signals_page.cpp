#include "app/signals_page.h"

#include <QAction>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>
#include <cstdio>
#include <functional>
#include <utility>

#include "app/acquisition.h"
#include "app/bus_words.h"
#include "app/can_source.h"
#include "app/file_dialog.h"
#include "app/preference_store.h"
#include "app/protocol_dbc.h"
#include "app/resources.h"
#include "app/say.h"
#include "widgets/card.h"
#include "widgets/look.h"
#include "widgets/palette.h"
#include "widgets/plain_label.h"
#include "widgets/raw_trace.h"
#include "widgets/robot_readout.h"
#include "widgets/tips.h"
#include "widgets/words.h"

namespace terratact {
namespace {

// A number that changes more often cannot be read.
constexpr double kRows = 0.1, kTrace = 0.2;  // [s]

/// A path that may be wrapped at its folders.
QString breakable(QString text)
{
    return text.replace(QLatin1Char('/'), QStringLiteral("/\u200B"));
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
        quantity(SignalsPage::tr("front current left"),
                 shownFeature(m, kFrontCurrentFeature, m.frontLeftCurrent), amperes),
        quantity(SignalsPage::tr("front current right"),
                 shownFeature(m, kFrontCurrentFeature, m.frontRightCurrent), amperes),
        quantity(SignalsPage::tr("rear current left"),
                 shownFeature(m, kRearCurrentFeature, m.rearLeftCurrent), amperes),
        quantity(SignalsPage::tr("rear current right"),
                 shownFeature(m, kRearCurrentFeature, m.rearRightCurrent), amperes)};
    for (std::size_t i = 0; i < m.force.size(); ++i)
        rows.push_back(quantity(SignalsPage::tr("force %1").arg(i + 1),
                                shownFeature(m, kFirstForceFeature + i, m.force[i]),
                                QStringLiteral("N")));
    if (m.travelled)
        rows.push_back(
            quantity(SignalsPage::tr("way of the tracks"), *m.travelled, QStringLiteral("m")));
    return rows;
}

/// Empty: it is no longer wanted.
std::optional<DbcReading> readDbcFiles(const QStringList& paths,
                                       const std::function<bool()>& isWanted)
{
    DbcReading reading;
    auto protocol = readProtocolDbc(resourcePath("dbc/terratact.dbc"));
    if (!protocol) reading.troubles.push_back(protocol.error().text);
    if (protocol) reading.protocol = *std::move(protocol);

    auto book = std::make_shared<DbcBook>();
    for (const QString& path : paths) {
        if (!isWanted()) return std::nullopt;
        const Status added = book->add(path.toStdString());
        if (!added) reading.troubles.push_back(added.error().text);
        reading.files.emplace_back(path, added ? std::optional(book->files().back().frames)
                                               : std::nullopt);
    }
    reading.troubles.insert(reading.troubles.end(), book->remarks().begin(), book->remarks().end());
    reading.book = std::move(book);
    return reading;
}

}  // namespace

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

SignalsPage::SignalsPage(const Acquisition& acquisition, CanSource* link,
                         PreferenceStore& preferences, QWidget* parent)
    : Page(parent), acquisition_(acquisition), link_(link), preferences_(preferences)
{
    auto* signalCard = new Card(tr("Signals"), this);
    headline_ = new PlainLabel(signalCard);
    headline_->setAccessibleName(tr("State of the bus"));
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
    addTools(*signalCard->titleRow());
    for (QLabel** label : {&dbcFiles_, &dbcTroubles_}) {
        *label = new PlainLabel(signalCard);
        (*label)->setWordWrap(true);
        QSizePolicy policy = (*label)->sizePolicy();  // names of files are no reason to be wide
        policy.setHorizontalPolicy(QSizePolicy::Ignored);
        (*label)->setSizePolicy(policy);
        signalCard->body()->insertWidget(signalCard->body()->indexOf(table_), *label);
    }
    dbcFiles_->setAccessibleName(tr("DBC files"));
    dbcTroubles_->setAccessibleName(tr("What is wrong with the DBC files"));
    setTone(*dbcTroubles_, Tone::Doubt);
    reader_.setMaxThreadCount(1);
    readDbc();
    connect(&preferences_, &PreferenceStore::changed, this, [this](const Preferences& before) {
        if (preferences_.current().dbc != before.dbc) readDbc();
    });

    auto* traceCard = new Card(tr("Newest frames"), this);
    trace_ = new RawTrace([this](const CanFrame& frame) { return traceWords(frame, book_); },
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

void SignalsPage::addTools(QHBoxLayout& row)
{
    const auto tool = [&row, this](const QString& text, const QString& tip) {
        auto* button = new QPushButton(text, this);
        button->setFocusPolicy(Qt::TabFocus);
        button->setMinimumHeight(kTarget);
        setTip(*button, tip);
        row.addWidget(button);
        return button;
    };
    row.addStretch(1);
    addDbc_ = tool(tr("Add DBC file …"),
                   tr("A file that says what frames mean that are not the robot's"));
    connect(addDbc_, &QPushButton::clicked, this, &SignalsPage::addDbcFile);
    removeDbc_ = tool(tr("Remove DBC file"), tr("Its frames are shown byte by byte again"));
    removeDbc_->setMenu(new QMenu(removeDbc_));
    QPushButton* forget =
        tool(tr("Forget least and most"), tr("They begin anew with the next frames"));
    connect(forget, &QPushButton::clicked, this, [this] { link_->tap().forgetExtremes(); });
}

SignalsPage::~SignalsPage()
{
    ++readings_;
    reader_.clear();
}

/// In a thread of its own: a large file takes longer than an armed robot waits for the operator's sign of life.
void SignalsPage::readDbc()
{
    const int job = ++readings_;
    reader_.clear();
    reader_.start([this, job, paths = preferences_.current().dbc] {
        auto reading = readDbcFiles(paths, [this, job] { return job == readings_; });
        if (!reading) return;
        QMetaObject::invokeMethod(
            this,
            [this, job, reading = *std::move(reading)] {
                if (job == readings_) useDbc(reading);
            },
            Qt::QueuedConnection);
    });
}

void SignalsPage::useDbc(const DbcReading& reading)
{
    QStringList files, sentences;
    for (const auto& [path, frames] : reading.files) {
        const QString name = QFileInfo(path).fileName();
        files << (frames ? tr("%1 (frames: %2)").arg(name).arg(*frames)
                         : tr("%1 (not used)").arg(name));
    }
    for (const std::string& trouble : reading.troubles) {
        say(stderr, "terratact-console: {}\n", trouble);
        sentences << words::sentence(trouble);
    }
    protocol_ = reading.protocol;
    book_ = reading.book;
    link_->tap().describe(book_);
    showDbc(files, sentences);
}

void SignalsPage::showDbc(const QStringList& files, const QStringList& troubles)
{
    constexpr qsizetype kMostLines = 3;
    dbcFiles_->setText(tr("DBC files: %1").arg(files.join(QStringLiteral(", "))));
    dbcFiles_->setVisible(!files.isEmpty());
    QStringList shown;
    for (const QString& trouble : troubles.mid(0, kMostLines))
        shown << QStringLiteral("▲ ") + breakable(trouble);
    if (troubles.size() > kMostLines)
        shown << tr("… and %1 more, all of them in the tip here").arg(troubles.size() - kMostLines);
    dbcTroubles_->setText(shown.join(QLatin1Char('\n')));
    dbcTroubles_->setVisible(!troubles.isEmpty());
    setTip(*dbcTroubles_, plainTip(troubles.join(QLatin1Char('\n'))));

    addDbc_->setEnabled(files.size() < kMostDbcFiles);
    removeDbc_->setVisible(!files.isEmpty());
    removeDbc_->menu()->clear();
    for (const QString& path : preferences_.current().dbc) {
        const QAction* remove = removeDbc_->menu()->addAction(QString(path).replace("&", "&&"));
        const auto removed = [this, path] {
            preferences_.change([path](Preferences& p) { p.dbc.removeAll(path); });
        };
        // Later, as the menu is filled anew then.
        connect(remove, &QAction::triggered, this, removed, Qt::QueuedConnection);
    }
}

void SignalsPage::addDbcFile()
{
    const FileWish wish{.title = tr("Add DBC file"),
                        .filter = tr("DBC files (*.dbc *.DBC);;All files (*)")};
    askForFile(*this, wish, [this](const QString& path) {
        preferences_.change([path](Preferences& p) {
            if (!p.dbc.contains(path)) p.dbc << path;
        });
    });
}

QString SignalsPage::dbcFiles() const
{
    return dbcFiles_ ? dbcFiles_->text() : QString();
}

QString SignalsPage::dbcTroubles() const
{
    return dbcTroubles_ ? dbcTroubles_->text() : QString();
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
    setTone(*headline_, toneOf(view.bus));
    table_->setRows(signalRows(link_->tap().frames(now), protocol_));
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
