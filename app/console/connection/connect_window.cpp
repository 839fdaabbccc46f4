#include "app/console/connection/connect_window.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QShowEvent>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/shell/file_dialog.h"
#include "app/shell/open_file.h"
#include "drivers/can_interface.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

constexpr int kConnectWide = 720, kConnectHigh = 460;  // [px] at 100 %
constexpr int kStateEvery = 250;                       // [ms] whether the robot is armed or moves

CanFinding::Level worstOf(const BusOffer& bus)
{
    auto worst = CanFinding::Level::Fine;
    for (const CanFinding& finding : bus.findings) worst = std::max(worst, finding.level);
    return worst;
}

QString markOf(CanFinding::Level level)
{
    switch (level) {
    case CanFinding::Level::Fine: return QStringLiteral("✔");
    case CanFinding::Level::Warning: return QStringLiteral("!");
    case CanFinding::Level::Problem: break;
    }
    return QStringLiteral("✘");
}

QString stateOf(const BusOffer& bus)
{
    switch (worstOf(bus)) {
    case CanFinding::Level::Fine: return ConnectWindow::tr("can be used");
    case CanFinding::Level::Warning: return ConnectWindow::tr("can be used, see below");
    case CanFinding::Level::Problem: break;
    }
    return ConnectWindow::tr("cannot be used, see below");
}

QString factsOf(const BusOffer& bus)
{
    QStringList lines;
    for (const CanFinding& finding : bus.findings) {
        lines << markOf(finding.level) + QLatin1Char(' ') + translated(finding.what);
        if (!finding.cure.empty())
            lines << QStringLiteral("    ")
                         + ConnectWindow::tr("repair: %1").arg(translated(finding.cure));
    }
    return lines.join(QLatin1Char('\n'));
}

}  // namespace

std::vector<BusOffer> busOffers(const std::stop_token& stop)
{
    std::vector<std::string> names = inspectInterface("").others;
    if (names.empty()) names.emplace_back("can0");
    const int socketError = canSocketError();
    std::vector<BusOffer> offers;
    offers.reserve(names.size());
    for (const std::string& name : names) {
        if (stop.stop_requested()) break;
        offers.push_back({name, findingsOf(inspectInterface(name), socketError,
                                           controllerFrom(linkDetails(name)))});
    }
    return offers;
}

ConnectWindow::ConnectWindow(Options options, QWidget* parent)
    : QDialog(parent), options_(std::move(options))
{
    setWindowTitle(tr("Connect"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 14, 16, 14);
    column->setSpacing(10);
    auto* inUse = new PlainLabel(tr("In use: %1").arg(options_.inUse), this);
    inUse->setWordWrap(true);
    list_ = new QListWidget(this);
    list_->setAccessibleName(tr("What to work with"));
    facts_ = new PlainLabel(this);
    facts_->setWordWrap(true);
    facts_->setAccessibleName(tr("What was found"));
    facts_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    transmit_ = new QCheckBox(tr("This console may send commands on that bus"), this);
    transmit_->setMinimumHeight(kTarget);
    setTip(*transmit_, tr("Without it, the console only listens; like --transmit at the start"));
    result_ = new PlainLabel(this);
    result_->setWordWrap(true);
    result_->setAccessibleName(tr("Why it is not connected"));
    setTone(*result_, Tone::Bad);
    connect_ = new QPushButton(this);
    connect_->setProperty("role", "primary");
    connect_->setDefault(true);
    search_ = new QPushButton(tr("Look again"), this);
    search_->setAutoDefault(false);
    setTip(*search_, tr("Looks at the CAN interfaces of this computer again"));
    auto* row = new QHBoxLayout;
    row->addWidget(search_);
    row->addStretch(1);
    row->addWidget(connect_);
    for (QPushButton* const button : {connect_, search_}) button->setMinimumHeight(kTarget);
    column->addWidget(inUse);
    column->addWidget(list_, 1);
    column->addWidget(facts_);
    column->addWidget(transmit_);
    column->addWidget(result_);
    column->addLayout(row);
    connect(list_, &QListWidget::currentRowChanged, this, [this] {
        transmit_->setChecked(false);
        result_->clear();
        showChosen();
    });
    connect(list_, &QListWidget::itemDoubleClicked, this, &ConnectWindow::connectChosen);
    connect(connect_, &QPushButton::clicked, this, &ConnectWindow::connectChosen);
    connect(search_, &QPushButton::clicked, this, &ConnectWindow::searchAgain);
    auto* state = new QTimer(this);
    connect(state, &QTimer::timeout, this, [this] {
        if (isVisible()) showChosen();
    });
    state->start(kStateEvery);
    listSources();
    choose(Kind::Simulated);
    resize(scaled(kConnectWide), scaled(kConnectHigh));
}

ConnectWindow::~ConnectWindow()
{
    thread_ = {};  // requests the end and waits
}

void ConnectWindow::showEvent(QShowEvent* event)
{
    QDialog::showEvent(event);
    if (event->spontaneous()) return;
    transmit_->setChecked(false);
    searchAgain();
}

void ConnectWindow::searchAgain()
{
    if (isSearching_) return;
    const Kind before = kind();
    const BusOffer* const bus = chosenBus();
    chosenName_ = bus ? bus->name : std::string();
    buses_.clear();
    isSearching_ = true;
    listSources();
    choose(before == Kind::Bus ? Kind::Searching : before);
    thread_ = std::jthread([this, search = options_.search](const std::stop_token& stop) {
        auto found = search(stop);
        QMetaObject::invokeMethod(
            this, [this, found = std::move(found)] { showFound(found); }, Qt::QueuedConnection);
    });
}

void ConnectWindow::showFound(std::vector<BusOffer> found)
{
    const Kind before = kind();
    buses_ = std::move(found);
    isSearching_ = false;
    listSources();
    if (before != Kind::Searching) return choose(before);
    for (std::size_t i = 0; i < buses_.size(); ++i)
        if (buses_[i].name == chosenName_) return list_->setCurrentRow(static_cast<int>(i) + 1);
    choose(Kind::None);
}

/// Lists what to choose; nothing is chosen then.
void ConnectWindow::listSources()
{
    list_->clear();
    list_->addItem(tr("Simulated robot in this program"));
    if (isSearching_) list_->addItem(tr("Looking for CAN buses …"));
    for (const BusOffer& bus : buses_)
        list_->addItem(tr("CAN bus %1 — %2").arg(format::shownName(bus.name), stateOf(bus)));
    list_->addItem(tr("Log to replay, in another window"));
    list_->addItem(tr("Session to review, in another window"));
    search_->setEnabled(!isSearching_);
}

void ConnectWindow::choose(Kind kind)
{
    const int rows = list_->count();
    switch (kind) {
    case Kind::Simulated: return list_->setCurrentRow(0);
    case Kind::Searching: return list_->setCurrentRow(1);
    case Kind::Log: return list_->setCurrentRow(rows - 2);
    case Kind::Session: return list_->setCurrentRow(rows - 1);
    case Kind::None:
    case Kind::Bus: break;
    }
    list_->setCurrentRow(-1);
    showChosen();
}

ConnectWindow::Kind ConnectWindow::kind() const
{
    const int row = list_->currentRow(), rows = list_->count();
    if (row < 0) return Kind::None;
    if (row == 0) return Kind::Simulated;
    if (row < rows - 2) return isSearching_ ? Kind::Searching : Kind::Bus;
    return row == rows - 2 ? Kind::Log : Kind::Session;
}

const BusOffer* ConnectWindow::chosenBus() const
{
    return kind() == Kind::Bus ? &buses_.at(static_cast<std::size_t>(list_->currentRow() - 1))
                               : nullptr;
}

std::optional<QString> ConnectWindow::whyNotConnecting() const
{
    if (kind() == Kind::Log || kind() == Kind::Session) return std::nullopt;
    if (kind() == Kind::None) return tr("Choose what to work with");
    if (kind() == Kind::Searching) return tr("Looking for CAN buses …");
    if (const auto why = options_.whyNot ? options_.whyNot() : std::nullopt)
        return translated(*why);
    if (const BusOffer* const bus = chosenBus(); bus && worstOf(*bus) == CanFinding::Level::Problem)
        return tr("This interface cannot be used: repair it first, then look again");
    return std::nullopt;
}

void ConnectWindow::showChosen()
{
    const BusOffer* const bus = chosenBus();
    transmit_->setVisible(bus != nullptr);
    QString facts, button = tr("Connect");
    switch (kind()) {
    case Kind::None:
        if (!chosenName_.empty())
            facts = tr("CAN bus %1 is no longer there").arg(format::shownName(chosenName_));
        break;
    case Kind::Searching: break;
    case Kind::Simulated:
        facts = tr("✔ Needs no hardware. Its ground is the one that the console was started with");
        break;
    case Kind::Bus: facts = factsOf(*bus); break;
    case Kind::Log:
        facts = tr("Logs of candump, Vector (.asc), PEAK (.trc), GVRET and python-can, also packed "
                   "by gzip");
        button = tr("Choose a log …");
        break;
    case Kind::Session:
        facts = options_.sessions.isEmpty()
                  ? tr("Recordings of this console (.tts)")
                  : tr("Recordings of this console (.tts), in %1").arg(options_.sessions);
        button = tr("Choose a session …");
        break;
    }
    if (facts_->text() != facts) facts_->setText(facts);
    connect_->setText(button);
    const auto whyNot = whyNotConnecting();
    connect_->setEnabled(!whyNot);
    setTip(*connect_, whyNot.value_or(tr("Restarts the console with it (Return)")));
    if (whyNot)
        result_->setText(*whyNot);
    else if (kind() == Kind::Simulated || bus)
        result_->clear();
}

void ConnectWindow::connectChosen()
{
    if (whyNotConnecting()) return showChosen();
    if (const BusOffer* const bus = chosenBus())
        return emit connectionWanted({bus->name, transmit_->isChecked()});
    if (kind() == Kind::Simulated) return emit connectionWanted({});
    const bool session = kind() == Kind::Session;
    askForFile(
        *this,
        {.title = session ? tr("Session to review") : tr("Log to replay"),
         .start = session ? options_.sessions : QString(),
         .filter = session
                     ? tr("Sessions (*.tts)")
                     : tr("Logs and recordings of other programs (*.log *.asc *.trc *.csv *.gz "
                          "*.mcap *.bag *.db3);;All files (*)")},
        [this, session](const QString& path) { openFile(path, session); });
}

void ConnectWindow::openFile(const QString& path, bool asSession)
{
    const FileKind found = kindOfFile(path);
    const QString name = format::fileName(path);
    const bool isReviewed = found == FileKind::Session || found == FileKind::Recording;
    if (asSession && !isReviewed)
        return result_->setText(
            tr("%1 is no session; choose a recording of this console, or replay it as a log")
                .arg(name));
    if (!asSession && found == FileKind::Session)
        return result_->setText(tr("%1 is a session; choose it as a session").arg(name));
    result_->clear();
    emit fileWanted(path);
    close();
}

QString ConnectWindow::facts() const
{
    return facts_->text();
}

QString ConnectWindow::result() const
{
    return result_->text();
}

}  // namespace terratact
