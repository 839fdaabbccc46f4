#pragma once

#include <QList>
#include <QString>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "app/link/can_source.h"
#include "app/mission/estimation.h"
#include "app/shell/page.h"
#include "drivers/operator_panel.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace terratact {

class LoopMeter;

/// A heading with names and values below it.
struct DiagnosticsSection {
    QString title;
    QList<std::pair<QString, QString>> lines{};
};

/// Returns facts that do not change while the program runs: versions, processor, permissions. It reads /dev, /proc and
/// the network stack once.
QList<DiagnosticsSection> standingDiagnostics();

/// Returns whether CAN sockets can be opened; if not, why and how to fix it. socketError: of canSocketError().
QString canSocketText(int socketError);

/// State and counts of an operator's panel.
struct PanelFacts {
    PanelReport report{};
    bool answers = false;
    PerContact<std::uint64_t> presses{};
    std::vector<double> stopLatencies{};  ///< [s]
};

/// State of the parts that the console uses.
struct ConsoleFacts {
    std::optional<double> telemetryAge{};         ///< [s]; empty: none received yet
    double telemetryRate = 0.0;                   ///< [Hz]
    QString bus{};                                ///< fault of the bus; empty: none
    std::optional<CanSource::Waiting> waiting{};  ///< queue of a bus
    std::optional<PanelFacts> panel{};            ///< empty: no panel
    bool estimating = false;
    Estimation::Counts estimates{};
    QString source{}, robot{}, robotDetails{};
    ModelInUse model{};
};

/// Returns these facts with frame times, latency and lateness of the event loop.
QList<DiagnosticsSection> consoleDiagnostics(const ConsoleFacts& facts, const LoopMeter& meter);

/// Returns the resident memory of this process [B]; 0 if unknown.
double residentMemory();

/// Returns the sections as text for a report: "Title\n  name: value\n…".
QString plainText(const QList<DiagnosticsSection>& sections);

/// Facts for remote support; a button copies them as text.
class DiagnosticsPage final : public Page {
    Q_OBJECT
public:
    using ReadSections = std::function<QList<DiagnosticsSection>()>;

    /// read: returns the changing sections; called once a second while the page is visible. Sections and lines must be
    /// the same each time.
    explicit DiagnosticsPage(ReadSections read, QWidget* parent = nullptr);
    void refresh(double now) override;

    QString text() const;  ///< text that the button copies
    QPushButton* copyButton() const { return copy_; }

private:
    QWidget* cardOf(const DiagnosticsSection& section, QList<QLabel*>* values);

    ReadSections read_;
    QList<DiagnosticsSection> standing_;
    QList<QLabel*> values_;  ///< labels of the changing values
    QPushButton* copy_ = nullptr;
    double shownAt_ = 0.0;  ///< [s]
};

}  // namespace terratact
