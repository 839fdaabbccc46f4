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

/// The DBC files of the protocol and of the operator, as read.
struct DbcReading {
    std::vector<DbcMessage> protocol;  ///< empty: its file could not be used
    std::shared_ptr<const DbcBook> book;
    /// Files in use as text; empty: none.
    std::vector<std::pair<QString, std::optional<std::size_t>>> files;
    std::vector<Message> troubles;  ///< one sentence each
};

/// The preferred DBC files on a page. Buttons add and remove files; labels show the files in use and their errors.
/// Errors are also printed on stderr. A change is read in another thread. GUI thread only.
class DbcFiles final : public QObject {
    Q_OBJECT
public:
    /// The preferences must outlive the object; `page` holds the buttons and labels.
    DbcFiles(PreferenceStore& preferences, QWidget& page);
    ~DbcFiles() override;  ///< waits for the file that is being read

    void addButtons(QHBoxLayout& row);
    void addLines(QVBoxLayout& column);
    void read();  ///< call once at first; changes of the preferred files trigger it

    QString files() const;     ///< files in use; empty: none
    QString troubles() const;  ///< one error per line; empty: none
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
    std::atomic<int> readings_ = 0;  ///< number of requested readings; only the newest counts
    QLabel *files_ = nullptr, *troubles_ = nullptr;
    QPushButton *add_ = nullptr, *remove_ = nullptr;
    /// One thread, so files are read one after another; destroyed before the other members.
    QThreadPool reader_;
};

}  // namespace terratact
