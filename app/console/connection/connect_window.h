#pragma once

#include <QDialog>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "app/link/can_check.h"
#include "core/base/message.h"

class QCheckBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace terratact {

/// Another robot to connect the console to.
struct ConnectionWish {
    std::string can{};      ///< CAN interface; empty: the simulated robot
    bool transmit = false;  ///< commands may be sent
};

/// A CAN interface of this computer and what was found about it.
struct BusOffer {
    std::string name;
    std::vector<CanFinding> findings;  ///< in the order in which they must be fixed
};

/// Looks at every CAN interface of this computer; at can0 if there is none. It starts a program per interface: not for
/// the GUI thread. The rest is left out once a stop is requested.
std::vector<BusOffer> busOffers(const std::stop_token& stop);

/// Window to choose the source of the console: a CAN bus, the simulated robot, a log or a recorded session. For each
/// it states what is wrong and how to repair it. Logs and sessions open in another window. The permission to send
/// commands is for one bus. It ends with another choice, another search, and another opening.
class ConnectWindow final : public QDialog {
    Q_OBJECT
public:
    struct Options {
        QString inUse{};  ///< what the console is connected to
        /// Finds the interfaces; called in a separate thread.
        std::function<std::vector<BusOffer>(const std::stop_token& stop)> search = busOffers;
        /// Returns why this console must stay connected now; empty: it may change.
        std::function<std::optional<Message>()> whyNot;
        QString sessions{};  ///< folder of the sessions
    };
    explicit ConnectWindow(Options options, QWidget* parent = nullptr);
    ~ConnectWindow() override;

    void searchAgain();  ///< searches the CAN interfaces again, unless a search is running
    /// Opens a file as a session or as a log. If the file is neither, shows the reason.
    void openFile(const QString& path, bool asSession);

    QListWidget* list() const { return list_; }
    QCheckBox* transmitBox() const { return transmit_; }
    QPushButton* connectButton() const { return connect_; }
    QPushButton* searchButton() const { return search_; }
    QString facts() const;   ///< about the chosen line
    QString result() const;  ///< why nothing was connected

signals:
    void connectionWanted(const terratact::ConnectionWish& wish);
    void fileWanted(const QString& path);  ///< in another window

protected:
    void showEvent(QShowEvent* event) override;

private:
    enum class Kind { None, Simulated, Searching, Bus, Log, Session };
    void listSources();
    void showFound(std::vector<BusOffer> found);
    void choose(Kind kind);
    void showChosen();
    void connectChosen();
    Kind kind() const;
    const BusOffer* chosenBus() const;
    std::optional<QString> whyNotConnecting() const;

    Options options_;
    std::vector<BusOffer> buses_;
    bool isSearching_ = false;  ///< at the interfaces; buses_ is empty until then
    std::string chosenName_;    ///< bus that was chosen before this search; empty: none
    QListWidget* list_ = nullptr;
    QLabel* facts_ = nullptr;
    QCheckBox* transmit_ = nullptr;
    QLabel* result_ = nullptr;
    QPushButton* connect_ = nullptr;
    QPushButton* search_ = nullptr;
    std::jthread thread_;  // looks at the interfaces
};

}  // namespace terratact
