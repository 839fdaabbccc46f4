#include "core/learn/model/file/model_file.h"

#include <stdexcept>

#include "core/learn/model/file/model_checks.h"
#include "core/learn/model/file/model_hash.h"
#include "core/learn/model/file/model_layout.h"
#include "core/learn/model/file/model_reading.h"
#include "core/learn/model/file/model_writing.h"
#include "core/store/file_read.h"
#include "core/store/file_write.h"
#include "core/store/sqlite.h"

namespace terratact {
namespace {

void requireArgument(const ModelData& model, const std::string& caller)
{
    try {
        model_file::requireModel(model);
    } catch (const model_file::Refused& refused) {
        throw std::invalid_argument(caller + ": " + refused.what());
    }
}

}  // namespace

std::string contentHash(const ModelData& model)
{
    requireArgument(model, "contentHash");
    return model_file::hashOf(model);
}

Status writeModel(const std::string& path, const ModelData& model)
{
    requireArgument(model, "writeModel");
    Result<NewFile> file = NewFile::begin(path, Access::Everybody);
    if (!file) return file.error();
    try {
        model_file::fill(file->temporaryPath(), model);
    } catch (const SqliteError& error) {
        return fileError(path, Message(TR_NOOP("core", "cannot be written: %1"), error.message()));
    }
    return file->commit();
}

Result<StoredModel> readModel(const std::string& path)
{
    try {
        SqliteFile file = SqliteFile::openUntrusted(path, model_file::kMaxBytes);
        return model_file::readStored(file);
    } catch (const SqliteError& error) {
        return fileError(path, error.message());
    } catch (const model_file::Refused& refused) {
        return fileError(path, refused.message());
    }
}

}  // namespace terratact
