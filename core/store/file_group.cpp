#include "core/store/file_group.h"

#include <utility>

namespace terratact {

Status FileGroup::add(const std::string& path, std::string_view content)
{
    Result<NewFile> file = NewFile::filled(path, content);
    if (!file) return file.error();
    add(*std::move(file));
    return Done{};
}

Status FileGroup::commit()
{
    for (NewFile& file : files_)
        if (Status done = file.commit(); !done) return done;
    files_.clear();
    return Done{};
}

}  // namespace terratact
