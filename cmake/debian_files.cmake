# Run by cpack on the files to package. Debian requires manual pages and changelog to be compressed without a time
# stamp. Documents link to resources, which are in another place than in the sources. Folders must be accessible to
# everyone, whatever the umask of the build.
file(GLOB_RECURSE _docs ${CPACK_TEMPORARY_DIRECTORY}/*/share/man/*.1 ${CPACK_TEMPORARY_DIRECTORY}/*/changelog)
execute_process(COMMAND gzip -9 -n ${_docs} COMMAND_ERROR_IS_FATAL ANY)
file(GLOB _docs ${CPACK_TEMPORARY_DIRECTORY}/usr/share/doc/terratact/*.md)
execute_process(COMMAND sed -i "s#](../resources/#](../../terratact/#g" ${_docs} COMMAND_ERROR_IS_FATAL ANY)
file(CHMOD_RECURSE ${CPACK_TEMPORARY_DIRECTORY}/usr DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
