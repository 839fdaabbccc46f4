#include "app/console/pages/diagnostics_page.h"

#include <cblas.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <Eigen/Core>
#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStringList>
#include <QVBoxLayout>
#include <algorithm>
#include <thread>

#include <grp.h>
#include <qwt_global.h>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/link/can_check.h"
#include "app/shell/loop_meter.h"
#include "core/learn/kernels/covariance_kernels.h"
#include "core/learn/kernels/likelihood_kernels.h"
#include "drivers/can_interface.h"
#include "widgets/base/card.h"
#include "widgets/base/palette.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

constexpr double kRefresh = 1.0;  // [s]

QString milliseconds(double seconds)
{
    return format::number(seconds * 1000.0, 1) + QStringLiteral(" ms");
}

DiagnosticsSection versions()
{
    utsname system{};
    ::uname(&system);
    return {DiagnosticsPage::tr("Versions"),
            {{QStringLiteral("Terratact"), QApplication::applicationVersion()},
             {QStringLiteral("Qt"), QString::fromLatin1(qVersion())},
             {QStringLiteral("Qwt"), QStringLiteral(QWT_VERSION_STR)},
             {QStringLiteral("Eigen"), QStringLiteral("%1.%2.%3")
                                           .arg(EIGEN_WORLD_VERSION)
                                           .arg(EIGEN_MAJOR_VERSION)
                                           .arg(EIGEN_MINOR_VERSION)},
             {QStringLiteral("OpenBLAS"), QString::fromLatin1(openblas_get_config()).trimmed()},
             {DiagnosticsPage::tr("kernel"), QStringLiteral("%1 %2 %3")
                                                 .arg(QString::fromLocal8Bit(system.sysname),
                                                      QString::fromLocal8Bit(system.release),
                                                      QString::fromLocal8Bit(system.machine))}}};
}

DiagnosticsSection processor()
{
    return {
        DiagnosticsPage::tr("Processor"),
        {{DiagnosticsPage::tr("cores"), QString::number(std::thread::hardware_concurrency())},
         {DiagnosticsPage::tr("estimator uses"), QString::fromLatin1(covarianceKernels().name)},
         {DiagnosticsPage::tr("training uses"), QString::fromLatin1(likelihoodKernels().name)}}};
}

QString gpioText()
{
    const QStringList chips =
        QDir(QStringLiteral("/dev")).entryList({QStringLiteral("gpiochip*")}, QDir::System);
    if (chips.isEmpty()) return DiagnosticsPage::tr("none here");
    QStringList said;
    for (const QString& chip : chips) {
        const bool may = ::access(qPrintable(QStringLiteral("/dev/") + chip), R_OK | W_OK) == 0;
        said << (may ? DiagnosticsPage::tr("✔ %1").arg(chip)
                     : DiagnosticsPage::tr("✘ %1: no permission (join the group gpio)").arg(chip));
    }
    return said.join(QStringLiteral(", "));
}

QString groupText()
{
    std::vector<gid_t> ids(static_cast<std::size_t>(std::max(0, ::getgroups(0, nullptr))));
    const int got = ::getgroups(static_cast<int>(ids.size()), ids.data());
    ids.resize(static_cast<std::size_t>(
        std::max(0, got)));  // the groups may have changed between the calls
    QStringList names;
    for (const gid_t id : ids) {
        const group* found = ::getgrgid(id);
        names << (found ? QString::fromLocal8Bit(found->gr_name) : QString::number(id));
    }
    return names.isEmpty() ? DiagnosticsPage::tr("none") : names.join(QStringLiteral(", "));
}

DiagnosticsSection permissions()
{
    const CanInterfaceFacts facts = inspectInterface("");
    QStringList interfaces;
    for (const std::string& name : facts.others) interfaces << format::text(name);
    return {DiagnosticsPage::tr("Permissions"),
            {{DiagnosticsPage::tr("CAN socket"), canSocketText(canSocketError())},
             {DiagnosticsPage::tr("CAN interfaces"), interfaces.isEmpty()
                                                         ? DiagnosticsPage::tr("none here")
                                                         : interfaces.join(QStringLiteral(", "))},
             {DiagnosticsPage::tr("GPIO chips"), gpioText()},
             {DiagnosticsPage::tr("groups"), groupText()}}};
}

/// Returns the same lines with and without a bus.
DiagnosticsSection presentDiagnostics(const ConsoleFacts& facts)
{
    DiagnosticsSection section{DiagnosticsPage::tr("Now"), {}};
    section.lines << std::pair(DiagnosticsPage::tr("age of the telemetry"),
                               facts.telemetryAge ? format::age(*facts.telemetryAge)
                                                  : format::kNothing)
                  << std::pair(DiagnosticsPage::tr("telemetry"),
                               format::number(facts.telemetryRate, 0) + QStringLiteral(" Hz"));
    section.lines << std::pair(DiagnosticsPage::tr("bus"),
                               facts.bus.isEmpty() ? format::kNothing : facts.bus)
                  << std::pair(DiagnosticsPage::tr("CAN frames waiting"),
                               facts.waiting ? DiagnosticsPage::tr("%1 now, %2 at most")
                                                   .arg(facts.waiting->now)
                                                   .arg(facts.waiting->most)
                                             : format::kNothing)
                  << std::pair(DiagnosticsPage::tr("estimator"),
                               facts.estimating ? DiagnosticsPage::tr("one estimate under way")
                                                : DiagnosticsPage::tr("idle"))
                  << std::pair(DiagnosticsPage::tr("estimates"),
                               DiagnosticsPage::tr("%1 of %2 contradicted the readings")
                                   .arg(facts.estimates.contradicting)
                                   .arg(facts.estimates.estimates))
                  << std::pair(DiagnosticsPage::tr("memory"),
                               format::number(residentMemory() / 1e6, 0) + QStringLiteral(" MB"));
    return section;
}

DiagnosticsSection loopDiagnostics(const LoopMeter& meter)
{
    const auto halfAndWorst = [](const NewestValues& values) {
        if (values.count() == 0) return format::kNothing;
        return DiagnosticsPage::tr("median %1 · 99 % below %2 · longest %3")
            .arg(milliseconds(values.quantile(0.5)), milliseconds(values.quantile(0.99)),
                 milliseconds(values.most()));
    };
    return {DiagnosticsPage::tr("Last minute"),
            {{DiagnosticsPage::tr("a frame takes"), halfAndWorst(meter.frames())},
             {DiagnosticsPage::tr("an event waits"), halfAndWorst(meter.lateness())},
             {DiagnosticsPage::tr("telemetry to screen"), halfAndWorst(meter.latencies())}}};
}

QString contactText(const PanelFacts& panel, PanelContact contact)
{
    const QString level = panel.report.state.contacts[contact].closed
                            ? DiagnosticsPage::tr("closed")
                            : DiagnosticsPage::tr("open");
    const QString edges = QString::number(panel.report.counters.edges[contact]);
    if (contact == PanelContact::Stop)
        return DiagnosticsPage::tr("%1 · edges %2").arg(level, edges);
    // A clean press makes two edges; further edges are contact bounce.
    return DiagnosticsPage::tr("%1 · edges %2 · presses %3")
        .arg(level, edges, QString::number(panel.presses[contact]));
}

QString latencyText(const std::vector<double>& seconds)
{
    if (seconds.empty()) return format::kNothing;
    return DiagnosticsPage::tr("newest %1 · worst %2 of %3")
        .arg(milliseconds(seconds.back()),
             milliseconds(*std::max_element(seconds.begin(), seconds.end())))
        .arg(seconds.size());
}

/// Returns the same lines with and without a panel.
DiagnosticsSection panelDiagnostics(const std::optional<PanelFacts>& panel)
{
    DiagnosticsSection section{DiagnosticsPage::tr("Operator's panel"), {}};
    const auto line = [&](const QString& name, const auto& value) {
        section.lines << std::pair(name, panel ? value(*panel) : format::kNothing);
    };
    line(DiagnosticsPage::tr("panel"), [](const PanelFacts& p) {
        if (!p.answers)
            return DiagnosticsPage::tr("✘ does not answer: %1").arg(translated(p.report.trouble));
        return p.report.trouble.empty() ? DiagnosticsPage::tr("✔ answers")
                                        : translated(p.report.trouble);
    });
    for (const PanelContact contact : kAllPanelContacts)
        line(DiagnosticsPage::tr("contact %1").arg(format::text(name(contact))),
             [contact](const PanelFacts& p) { return contactText(p, contact); });
    line(DiagnosticsPage::tr("events lost"), [](const PanelFacts& p) {
        return DiagnosticsPage::tr("%1 by the kernel · panel gone %2 times")
            .arg(p.report.counters.lostEdges)
            .arg(p.report.counters.losses);
    });
    line(DiagnosticsPage::tr("STOP to the bus"),
         [](const PanelFacts& p) { return latencyText(p.stopLatencies); });
    return section;
}

DiagnosticsSection partsDiagnostics(const ConsoleFacts& facts)
{
    const ModelInUse& model = facts.model;
    return {DiagnosticsPage::tr("What it works with"),
            {{DiagnosticsPage::tr("source"), facts.source},
             {DiagnosticsPage::tr("robot"), facts.robot},
             {DiagnosticsPage::tr("facts of the robot"),
              facts.robotDetails.isEmpty() ? format::kNothing : facts.robotDetails},
             {DiagnosticsPage::tr("model"),
              model.trouble.empty() ? model.name : translated(model.trouble)},
             {DiagnosticsPage::tr("facts of the model"), model.details}}};
}

}  // namespace

double residentMemory()
{
    QFile file(QStringLiteral("/proc/self/statm"));
    if (!file.open(QIODevice::ReadOnly)) return 0.0;
    const QByteArrayList pages = file.readAll().split(' ');
    return pages.size() < 2 ? 0.0
                            : pages[1].toDouble() * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

QString canSocketText(int socketError)
{
    if (socketError == 0) return DiagnosticsPage::tr("✔ possible");
    const CanFinding finding = socketFinding(socketError);
    const QString what = DiagnosticsPage::tr("✘ not possible: %1").arg(translated(finding.what));
    return finding.cure.empty() ? what : what + QLatin1Char('\n') + translated(finding.cure);
}

QList<DiagnosticsSection> standingDiagnostics()
{
    return {versions(), processor(), permissions()};
}

QList<DiagnosticsSection> consoleDiagnostics(const ConsoleFacts& facts, const LoopMeter& meter)
{
    return {presentDiagnostics(facts), loopDiagnostics(meter), panelDiagnostics(facts.panel),
            partsDiagnostics(facts)};
}

QString plainText(const QList<DiagnosticsSection>& sections)
{
    QString text;
    for (const DiagnosticsSection& section : sections) {
        text += section.title + QLatin1Char('\n');
        for (const auto& [name, value] : section.lines)
            text += QStringLiteral("  %1: %2\n").arg(name, value);
    }
    return text;
}

DiagnosticsPage::DiagnosticsPage(ReadSections read, QWidget* parent)
    : Page(parent), read_(std::move(read)), standing_(standingDiagnostics())
{
    auto* title = new PlainLabel(tr("Diagnostics"), this);
    title->setProperty("heading", true);
    copy_ = new QPushButton(tr("Copy as text"), this);
    copy_->setFocusPolicy(Qt::TabFocus);
    copy_->setMinimumHeight(kTarget);
    setTip(*copy_, tr("Copies this page, for a report"));
    connect(copy_, &QPushButton::clicked, this,
            [this] { QApplication::clipboard()->setText(text()); });
    auto* head = new QHBoxLayout;
    head->addWidget(title);
    head->addStretch(1);
    head->addWidget(copy_);

    auto* content = new QWidget(this);
    auto* left = new QVBoxLayout;
    auto* right = new QVBoxLayout;
    for (const DiagnosticsSection& section : read_()) left->addWidget(cardOf(section, &values_));
    for (const DiagnosticsSection& section : standing_) right->addWidget(cardOf(section, nullptr));
    auto* halves = new QHBoxLayout(content);
    halves->setContentsMargins(0, 0, 0, 0);
    halves->setSpacing(10);
    for (QVBoxLayout* half : {left, right}) {
        half->setSpacing(10);
        half->addStretch(1);
        halves->addLayout(half, 1);
    }
    auto* scroll = new QScrollArea(this);
    scroll->setAccessibleName(tr("Diagnostics"));
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 10, 12, 10);
    column->setSpacing(8);
    column->addLayout(head);
    column->addWidget(scroll, 1);
}

QWidget* DiagnosticsPage::cardOf(const DiagnosticsSection& section, QList<QLabel*>* values)
{
    auto* card = new Card(section.title, this);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(16);
    grid->setColumnStretch(1, 1);
    for (const auto& [name, value] : section.lines) {
        const int row = grid->rowCount();
        auto* label = new PlainLabel(name, card);
        setTone(*label, Tone::Muted);
        auto* shown = new PlainLabel(value, card);
        shown->setTextInteractionFlags(Qt::TextSelectableByMouse);
        shown->setWordWrap(true);
        shown->setAccessibleName(name);
        grid->addWidget(label, row, 0, Qt::AlignTop);
        grid->addWidget(shown, row, 1);
        if (values) *values << shown;
    }
    card->body()->addLayout(grid);
    return card;
}

void DiagnosticsPage::refresh(double now)
{
    if (now - shownAt_ < kRefresh - 1e-3) return;
    shownAt_ = now;
    int i = 0;
    for (const DiagnosticsSection& section : read_())
        for (const auto& [name, value] : section.lines) values_.at(i++)->setText(value);
}

QString DiagnosticsPage::text() const
{
    return plainText(read_() + standing_);
}

}  // namespace terratact
