#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <QThreadPool>
#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/link/dbc_book.h"

class QHBoxLayout;
class QLabel;
class QMenu;
class QPushButton;
class QVBoxLayout;
class QWidget;

namespace terratact {

class PreferenceStore;

/// The protocol's DBC file and those of the operator, read.
struct DbcReading {
    std::vector<DbcMessage> protocol;  ///< empty: its file could not be used
    std::shared_ptr<const DbcBook> book;
    std::vector<std::pair<QString, std::optional<std::size_t>>>
        files;                          ///< frames used; empty: none is
    std::vector<std::string> troubles;  ///< a sentence each
};

/// The preferred DBC files on a page: buttons that add and remove them, and lines that say which are in use and what is
/// wrong with them, which stderr says, too.  They are read in a thread, when they change.  GUI thread only.
class DbcFiles final : public QObject {
    Q_OBJECT
public:
    /// preferences must outlive it, and page be where the buttons and lines are.
    DbcFiles(PreferenceStore& preferences, QWidget& page);
    ~DbcFiles() override;  ///< waits for the one file that is being read

    void addButtons(QHBoxLayout& row);
    void addLines(QVBoxLayout& column);
    void read();  ///< at first; it happens by itself whenever the preferred files change

    QString files() const;     ///< which are in use; empty: none
    QString troubles() const;  ///< a line each; empty: none
    QPushButton* addButton() const { return add_; }
    QPushButton* removeButton() const { return remove_; }

signals:
    void wereRead(const terratact::DbcReading& reading);

private:
    void use(const DbcReading& reading);
    void show(const QStringList& files, const QStringList& troubles);
    void addFile();

    PreferenceStore& preferences_;
    QWidget& page_;
    std::atomic<int> readings_ = 0;  ///< that were asked for; only the newest counts
    QLabel *files_ = nullptr, *troubles_ = nullptr;
    QPushButton *add_ = nullptr, *remove_ = nullptr;
    QThreadPool reader_;  ///< one file after the other; waited for before all else goes
};

}  // namespace terratact
