#pragma once

#include <QDialog>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "app/review/export/session_export_job.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QRadioButton;

namespace terratact {

/// State of the review when an export is requested.
struct ExportViewState {
    double now = 0.0;                ///< [s] of the session
    double first = 0.0, last = 0.0;  ///< [s] visible range: from A to B, or of the timeline
    bool isCursors = false;          ///< the range is from A to B
    double begin = 0.0, end = 0.0;   ///< [s] of the session
    std::int64_t scene = 0;          ///< scene of the displayed estimate; 0: none
};

/// Dialog that selects and writes an export. The displayed content is written at once. Rows of the session are written
/// by a background job while the review continues. Esc cancels the job, or closes the dialog if none runs.
class ReviewExportDialog final : public QDialog {
    Q_OBJECT
public:
    struct Sources {
        QString session;  ///< path of the session file
        std::function<ExportViewState()> poll;
        std::function<QStringList()> dbc;  ///< DBC files that the operator has chosen
        // Each returns an error text; empty: the file was written.
        std::function<QString(const QString&path)> savePicture, saveNumbers;
    };
    ReviewExportDialog(Sources sources, QWidget* parent);
    ~ReviewExportDialog() override;

    /// Shows the dialog without blocking. While it is open it follows the visible range.
    void ask();
    bool writes() const { return job_ != nullptr; }

    QComboBox* what() const { return what_; }
    QComboBox* format() const { return format_; }
    QRadioButton* visibleSpan() const { return visible_; }
    QRadioButton* wholeSession() const { return everything_; }
    QCheckBox* withPayload() const { return payload_; }
    QLineEdit* pathEdit() const { return path_; }
    QPushButton* exportButton() const { return export_; }
    QPushButton* cancelButton() const { return cancel_; }
    QProgressBar* progressBar() const { return progress_; }
    QLabel* resultLabel() const { return result_; }

    void reject() override;

private:
    QWidget* form();
    QWidget* span();
    QWidget* file();
    QWidget* buttons();
    void offerFormats();
    void showViewState();
    void showPayload();
    void showButtons();
    std::optional<QString> whyNotExport() const;  ///< empty: writing is possible
    void applyFormat();
    void nameFile();
    void browse();
    QString path() const;  ///< path with the format's ending
    void write();
    void begin(SessionExportJob::Wish wish);
    void wrote(const QString& trouble, qulonglong leftOut = 0, int damaged = 0,
               int withoutColumns = 0);

    Sources sources_;
    ExportViewState viewState_;
    std::unique_ptr<SessionExportJob> job_;  ///< null: no export is running
    QString to_;  ///< file of the newest export; path() may have changed since
    QTimer pollTimer_;
    QString named_;   ///< last proposed name; any other name was typed by the operator
    QString wanted_;  ///< named_ without the number that makes it unique; empty: propose again

    // Qt's parents own the widgets.
    QComboBox* what_ = nullptr;
    QComboBox* format_ = nullptr;
    QRadioButton* visible_ = nullptr;
    QRadioButton* everything_ = nullptr;
    QCheckBox* payload_ = nullptr;  ///< includes signals of DBC files; unticked if there are none
    bool payloadWanted_ = true;     ///< the operator's choice for payload_
    QLabel* moment_ = nullptr;
    QLineEdit* path_ = nullptr;
    QPushButton* browse_ = nullptr;
    QPushButton* export_ = nullptr;
    QPushButton* cancel_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QLabel* result_ = nullptr;
};

}  // namespace terratact
