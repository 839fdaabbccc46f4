#pragma once

#include <QDialog>
#include <QImage>
#include <QString>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>

class QLabel;
class QLineEdit;

namespace terratact {

/// The files of a snapshot: a picture, the numbers, and a note where no session holds it.
struct SnapshotFiles {
    std::string base;       ///< path without ending
    std::string session{};  ///< path of the session beside them; empty: none records
    std::string picture() const { return base + ".png"; }
    std::string numbers() const { return base + ".csv"; }
    std::string note() const { return base + ".txt"; }
    QString name() const;  ///< without the folder
};

/// Returns new file names for a snapshot at a time (UTC). The files lie beside the session. An empty path means that no
/// session is recorded; they then lie in the operator's folder of pictures.
SnapshotFiles snapshotFiles(const std::string& session, const QDateTime& utc);

/// Writes snapshots in a separate thread, one at a time. A picture takes longer than a frame of the console, and a disk
/// may be slow. No call waits for the thread. The destructor waits for kMaxWait at most, so that a hanging disk does
/// not keep the console open. A snapshot that is unfinished then is lost; no partial file appears.
class SnapshotWriter final : public QObject {
    Q_OBJECT
public:
    using Write = std::function<QString(const SnapshotFiles&, const QImage&, const std::string&)>;
    static constexpr std::chrono::milliseconds kMaxWait{2000};

    explicit SnapshotWriter(QObject* parent = nullptr);
    /// write: writes both files and returns an error text.
    explicit SnapshotWriter(Write write, std::chrono::milliseconds maxWait = kMaxWait,
                            QObject* parent = nullptr);
    ~SnapshotWriter() override;
    bool isWriting() const { return isWriting_; }
    /// Returns false, and writes nothing, while another snapshot is being written.
    bool write(const SnapshotFiles& files, const QImage& picture, std::string numbers);

signals:
    /// trouble: empty if both files were written; else there is none of them. Emitted in the GUI thread.
    void wrote(const terratact::SnapshotFiles& files, const QString& trouble);

private:
    struct Shared;

    bool isWriting_ = false;
    Write write_;
    std::chrono::milliseconds maxWait_;
    std::shared_ptr<Shared> shared_;  ///< with the thread, which may outlive this object
    std::thread thread_;
};

/// Dialog for the note of a snapshot. It blocks no window. The console loses the focus, which releases its keys. Enter
/// saves the note, Esc leaves the snapshot without one. A note is emitted when the files are written.
class SnapshotNote final : public QDialog {
    Q_OBJECT
public:
    explicit SnapshotNote(QWidget& console);
    /// Shows the dialog for the next snapshot. Text typed for the last snapshot is saved as its note.
    void ask(const SnapshotFiles& files, const QString& text);
    /// The files of that snapshot are written, or could not be.
    void setWritten(const QString& text);
    QLineEdit* field() const { return field_; }

signals:
    void noted(const terratact::SnapshotFiles& files, const QString& note);

private:
    void take();

    SnapshotFiles files_;
    QString early_;  ///< a note that came before the files were written
    bool isWritten_ = true;
    QLabel* name_ = nullptr;
    QLineEdit* field_ = nullptr;
};

}  // namespace terratact
