#pragma once

#include <QDialog>
#include <QImage>
#include <QString>
#include <functional>
#include <string>
#include <thread>

class QLabel;
class QLineEdit;

namespace terratact {

/// The files of a snapshot: a picture, the numbers, and a note where no session holds it.
struct SnapshotFiles {
    std::string base;  ///< path without ending
    std::string picture() const { return base + ".png"; }
    std::string numbers() const { return base + ".csv"; }
    std::string note() const { return base + ".txt"; }
    QString name() const;  ///< without the folder
};

/// Returns the files of a snapshot at a time (UTC). They lie beside the session; where no session records (an empty path),
/// in the operator's folder of pictures. No file of that name exists.
SnapshotFiles snapshotFiles(const std::string& session, const QDateTime& utc);

/// Writes snapshots in a thread of its own, because coding a picture takes longer than a frame of the console.
class SnapshotWriter final : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;
    void write(const SnapshotFiles& files, const QImage& picture, std::string numbers);

signals:
    /// trouble: empty if both files were written. Emitted in the GUI thread.
    void wrote(const QString& base, const QString& trouble);

private:
    std::jthread thread_;
};

/// Asks for the note of a snapshot. It blocks no window: the console goes on, and its keys are let go as it loses the
/// focus. Enter saves the note, Esc leaves the snapshot without one.
class SnapshotNote final : public QDialog {
    Q_OBJECT
public:
    explicit SnapshotNote(QWidget& console);
    void ask(const QString& name);  ///< name: of the snapshot
    QLineEdit* field() const { return field_; }

signals:
    void noted(const QString& note);

private:
    QLabel* name_ = nullptr;
    QLineEdit* field_ = nullptr;
};

}  // namespace terratact
